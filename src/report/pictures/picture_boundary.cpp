#include "report/drawn/axes.hpp"
#include "report/pictures/pictures.hpp"
#include "report/record.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

const Stroke kBodyLines[] = {
    {colour::kBlue, 1.8, ""}, {colour::kOrange, 1.8, "7 3"}, {colour::kGreen, 1.8, "2 2"}, {colour::kPurple, 1.8, "10 3 2 3"}};

struct BoundarySample {
  double s, hoop;
};

using Pieces = std::vector<std::vector<BoundarySample>>;

// Stress along one curve over its length, end by end; elements on a line of symmetry are no boundary and
// break it.
Pieces follow(const Scene& scene, const BodyScene& body, const std::vector<double>& hoop, size_t first, size_t last) {
  const size_t per_element = static_cast<size_t>(scene.summary.function_nodes);
  Pieces out;
  double s = 0.0;
  bool broken = true;
  for (size_t i = first; i < last; ++i) {
    if (body.on_line[i / per_element]) {
      broken = true;
      continue;
    }
    if (broken) out.emplace_back();
    if (!broken) s += std::hypot(body.ends[i].x - body.ends[i - 1].x, body.ends[i].y - body.ends[i - 1].y);
    out.back().push_back({s, hoop[i]});
    broken = false;
  }
  return out;
}

// The curves of a body, with what they need of axes and legend.
struct Curves {
  std::vector<Pieces> pieces; // of each curve
  std::vector<LegendEntry> entries;
  Range s, stress;
  double largest = 0.0; // in size,
  Point where;          // and where it is
};

c2d_status collect(const Scene& scene, size_t b, Curves& out) {
  const Summary& summary = scene.summary;
  const BodyScene& body = scene.bodies[b];
  const int32_t number = static_cast<int32_t>(b) + 1, field = C2D_END_HOOP;
  std::vector<std::vector<double>> hoop;
  c2d_status status = get_ends(scene.solver, summary, number, &field, 1, hoop);
  out.stress.include(0.0);
  for (int32_t r = 1; r <= summary.body[b].regions && status == C2D_OK; ++r) {
    int32_t first = 0, last = 0;
    status = c2d_get_region(scene.solver, number, r, &first, &last);
    if (status != C2D_OK) return status;
    const size_t from = static_cast<size_t>((first - 1) * summary.function_nodes);
    const size_t to = static_cast<size_t>(last * summary.function_nodes);
    out.pieces.push_back(follow(scene, body, hoop[0], from, to));
    for (size_t i = from; i < to; ++i)
      if (std::fabs(hoop[0][i]) > std::fabs(out.largest)) out.largest = hoop[0][i], out.where = body.ends[i];
    for (const std::vector<BoundarySample>& piece : out.pieces.back())
      for (const BoundarySample& p : piece) out.s.include(p.s), out.stress.include(p.hoop);
    size_t begin = from; // of what is boundary
    while (begin + 1 < to && body.on_line[begin / static_cast<size_t>(summary.function_nodes)]) ++begin;
    const Point start = body.ends[begin];
    out.entries.push_back(
        {"curve " + std::to_string(r) + ", s = 0 at " + place_text(scene, start, size_of(scene)),
         beneath(kBodyLines[static_cast<size_t>(r - 1) % 4], std::min(3, summary.body[b].regions - r) > 0
                                                                 ? static_cast<size_t>(std::min(3, summary.body[b].regions - r))
                                                                 : 0),
         Mark::kNone, true, ""});
  }
  return status;
}

// The number of a curve where its stress is largest in size, on no axis.
void label_curve(Svg& svg, const Chart& chart, const Pieces& pieces, size_t number) {
  BoundarySample most{0.0, 0.0};
  for (const std::vector<BoundarySample>& piece : pieces)
    for (const BoundarySample& p : piece)
      if (std::fabs(p.hoop) >= std::fabs(most.hoop)) most = p;
  const Point at = chart.at(most.s, most.hoop);
  const double y = most.hoop < 0.0 ? at.y + 14.0 : at.y - 5.0;
  const double x = at.x < chart.frame.left + 8.0 ? chart.frame.left + 16.0 : std::min(at.x, chart.frame.right - 8.0);
  svg.text({x, std::max(chart.frame.top + 12.0, std::min(y, chart.frame.bottom - 4.0))}, std::to_string(number + 1), 11.0,
           Anchor::kMiddle, kBodyLines[number % 4].colour, false, true);
}

c2d_status draw_boundary_of(const Scene& scene, size_t b, Pictures& out) {
  Curves curves;
  if (const c2d_status status = collect(scene, b, curves); status != C2D_OK) return status;
  const double left = 66.0, right = kPictureWidth - 18.0;
  const double top = draw_legend(nullptr, {left, 4.0}, right - left, curves.entries) + 12.0;
  Picture picture{"boundary", "Stress along the boundary", "", ""};
  const int32_t number = static_cast<int32_t>(b) + 1;
  const bool several = scene.summary.bodies > 2, named = several || !scene.summary.body_name[b].empty();
  const std::string which = named ? " of " + body_label(scene, number) : "";
  picture.title += which;
  if (several) picture.name += "_body" + std::to_string(number);
  Svg svg(picture.name, kPictureWidth, top + 250.0 + 44.0);
  draw_legend(&svg, {left, 4.0}, right - left, curves.entries);
  const Chart chart{{left, top, right, top + 250.0},
                    make_axis(curves.s, "distance s along the boundary", scene.length_unit, 9),
                    make_axis(curves.stress, "stress along the boundary", scene.stress_unit, 6)};
  draw_axes(svg, chart);
  for (size_t r = 0; r < curves.pieces.size(); ++r)
    for (const std::vector<BoundarySample>& piece : curves.pieces[r]) {
      std::vector<Point> points;
      for (const BoundarySample& p : piece) points.push_back(chart.at(p.s, p.hoop));
      svg.polyline(points, beneath(kBodyLines[r % 4], std::min<size_t>(3, curves.pieces.size() - 1 - r)));
    }
  for (size_t r = 0; curves.pieces.size() > 1 && r < curves.pieces.size(); ++r) label_curve(svg, chart, curves.pieces[r], r);
  picture.caption = "Normal stress along the boundary" + which + " (hoop stress) at " + place_at_end(scene) +
                    ": the largest in size is " + figure(curves.largest, scene.stress_unit, 6) + " at " +
                    place_text(scene, curves.where, size_of(scene)) + ".";
  picture.svg = svg.finish(picture.title, picture.caption);
  out.push_back(picture);
  return C2D_OK;
}

} // namespace

c2d_status draw_boundary_stress(const Scene& scene, Pictures& out) {
  c2d_status status = C2D_OK;
  if (!scene.pairs.empty() || scene.bodies.empty()) return status;
  const size_t count = scene.bodies.size() > 2 ? scene.bodies.size() : 1; // of two only the first, as ever
  for (size_t b = 0; b < std::min(count, kMostCharts) && status == C2D_OK; ++b)
    if (!scene.bodies[b].rigid) status = draw_boundary_of(scene, b, out);
  return status;
}

} // namespace app
