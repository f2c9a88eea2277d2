#include "report/drawn/axes.hpp"
#include "report/pictures/contour.hpp"
#include "report/pictures/pictures.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr size_t kNodesAcross = 64; // of a grid, along its longer side
constexpr size_t kBands = 10;       // about
constexpr double kLeastZoom = 1e-9; // of the bodies' size: the contact is a point, but for round-off
constexpr double kPeakPlace = 1e4;  // its place is sought to a millionth of the size of the model (place_text)
constexpr double kHalfTurn = 3.14159265358979323846;

// A window and the stress grids of the bodies in it.
struct Window {
  Chart view;
  std::vector<Grid> grids; // per body
};
struct DrawnPeak {
  double value = 0.0;
  Point at;
  size_t body = 0;
};

// c2d_interior of one body at points, x and y of each; one without a finite place is outside.
c2d_status stresses_at(const Scene& scene, size_t b, std::vector<double> points, std::vector<double>& values) {
  const size_t count = points.size() / 2;
  std::vector<size_t> nowhere;
  for (size_t i = 0; i < count; ++i)
    if (!std::isfinite(points[2 * i]) || !std::isfinite(points[2 * i + 1])) {
      points[2 * i] = points[2 * i + 1] = 0.0;
      nowhere.push_back(i);
    }
  values.resize(count * C2D_POINT_FIELDS);
  const c2d_status status = c2d_interior(scene.solver, static_cast<int32_t>(b) + 1, static_cast<int32_t>(count), points.data(),
                                         2, values.data(), C2D_POINT_FIELDS);
  for (const size_t i : nowhere) values[i * C2D_POINT_FIELDS + C2D_POINT_FLAG] = C2D_POINT_OUTSIDE;
  return status;
}

// von Mises stress of one body at the grid nodes of the window inside it.
c2d_status sample(const Scene& scene, size_t b, const Chart& view, Grid& grid) {
  const double wide = view.x.high - view.x.low, high = view.y.high - view.y.low;
  const double step = std::max(wide, high) / static_cast<double>(kNodesAcross - 1);
  grid.columns = static_cast<size_t>(std::ceil(wide / step - 1e-9)) + 1;
  grid.rows = static_cast<size_t>(std::ceil(high / step - 1e-9)) + 1;
  grid.dx = wide / static_cast<double>(grid.columns - 1);
  grid.dy = high / static_cast<double>(grid.rows - 1);
  grid.x0 = view.x.low;
  grid.y0 = view.y.low;
  grid.values.assign(grid.columns * grid.rows, 0.0);
  grid.known.assign(grid.values.size(), 0);
  if (scene.bodies[b].rigid) return C2D_OK; // has no stress
  const Outlines outline = outline_of(scene.bodies[b], 0.0);
  std::vector<double> points;
  std::vector<size_t> where;
  for (size_t r = 0; r < grid.rows; ++r)
    for (size_t c = 0; c < grid.columns; ++c) {
      const Point p = grid.place(c, r);
      if (!is_inside(outline, p)) continue;
      points.push_back(p.x);
      points.push_back(p.y);
      where.push_back(grid.at(c, r));
    }
  if (where.empty()) return C2D_OK;
  std::vector<double> values;
  if (const c2d_status status = stresses_at(scene, b, points, values); status != C2D_OK) return status;
  for (size_t i = 0; i < where.size(); ++i) {
    const double* row = values.data() + i * C2D_POINT_FIELDS;
    if (static_cast<int>(row[C2D_POINT_FLAG]) == C2D_POINT_OUTSIDE) continue;
    grid.values[where[i]] = row[C2D_POINT_VON_MISES];
    grid.known[where[i]] = 1;
  }
  return C2D_OK;
}

DrawnPeak find_peak(const Window& window) {
  DrawnPeak out;
  for (size_t b = 0; b < window.grids.size(); ++b) {
    const Grid& g = window.grids[b];
    for (size_t r = 0; r < g.rows; ++r)
      for (size_t c = 0; c < g.columns; ++c)
        if (g.known[g.at(c, r)] && g.values[g.at(c, r)] > out.value) out = {g.values[g.at(c, r)], g.place(c, r), b};
  }
  return out;
}

// From the highest nodes of the grid on to where the stress is largest: by steps that shrink, around the best point so far.
c2d_status climb(const Scene& scene, const Window& window, DrawnPeak& peak) {
  constexpr size_t kAround = 8;
  const Grid& g = window.grids[peak.body];
  double step = std::max(g.dx, g.dy);
  for (int round = 0; round < 30 && step > 0.0; ++round) {
    std::vector<double> points, values;
    for (size_t k = 0; k < kAround; ++k) {
      const double angle = 2.0 * kHalfTurn * (static_cast<double>(k) + 0.5 * (round % 2)) / static_cast<double>(kAround);
      points.push_back(peak.at.x + step * std::cos(angle));
      points.push_back(peak.at.y + step * std::sin(angle));
    }
    if (const c2d_status status = stresses_at(scene, peak.body, points, values); status != C2D_OK) return status;
    const DrawnPeak before = peak;
    for (size_t k = 0; k < kAround; ++k) {
      const double* row = values.data() + k * C2D_POINT_FIELDS;
      const Point p{points[2 * k], points[2 * k + 1]};
      const bool shown =
          p.x >= window.view.x.low && p.x <= window.view.x.high && p.y >= window.view.y.low && p.y <= window.view.y.high;
      const bool known = static_cast<int>(row[C2D_POINT_FLAG]) != C2D_POINT_OUTSIDE;
      if (shown && known && row[C2D_POINT_VON_MISES] > peak.value) peak = {row[C2D_POINT_VON_MISES], p, peak.body};
    }
    if (peak.value <= before.value * (1.0 + 1e-6)) step *= 0.5;
  }
  return C2D_OK;
}

// The boundary has stresses of its own, at the ends of elements.
c2d_status find_on_boundary(const Scene& scene, const Window& window, DrawnPeak& peak) {
  for (size_t b = 0; b < scene.bodies.size(); ++b) {
    const BodyScene& body = scene.bodies[b];
    std::vector<double> points, values;
    const size_t per_element = static_cast<size_t>(scene.summary.function_nodes);
    for (size_t i = 0; i < body.ends.size() && !body.rigid; ++i) {
      const Point p = body.ends[i];
      const bool shown =
          p.x >= window.view.x.low && p.x <= window.view.x.high && p.y >= window.view.y.low && p.y <= window.view.y.high;
      if (shown && !body.on_line[i / per_element]) points.insert(points.end(), {p.x, p.y});
    }
    if (points.empty()) continue;
    if (const c2d_status status = stresses_at(scene, b, points, values); status != C2D_OK) return status;
    for (size_t i = 0; 2 * i < points.size(); ++i) {
      const double* row = values.data() + i * C2D_POINT_FIELDS;
      const bool known = static_cast<int>(row[C2D_POINT_FLAG]) != C2D_POINT_OUTSIDE;
      if (known && row[C2D_POINT_VON_MISES] > peak.value)
        peak = {row[C2D_POINT_VON_MISES], {points[2 * i], points[2 * i + 1]}, b};
    }
  }
  return C2D_OK;
}

// Between values that all but a hundredth of the points stay above or below: a corner may have any stress.
// From zero unless the stress is everywhere far from it and yet differs from place to place.
std::vector<double> choose_levels(const Window& window, Axis& axis, const std::string& unit) {
  std::vector<double> values;
  for (const Grid& g : window.grids)
    for (size_t i = 0; i < g.values.size(); ++i)
      if (g.known[i]) values.push_back(g.values[i]);
  Range range;
  for (const size_t percent : {size_t{1}, size_t{99}}) {
    if (values.empty()) break;
    const size_t rank = (values.size() - 1) * percent / 100;
    std::nth_element(values.begin(), values.begin() + static_cast<ptrdiff_t>(rank), values.end());
    range.include(values[rank]);
  }
  if (range.low < 0.25 * range.high || range.high - range.low < 0.02 * range.high) range.include(0.0);
  axis = make_axis(range, "von Mises stress", unit, static_cast<int>(kBands));
  std::vector<double> levels;
  for (int i = 0; i < axis.ticks; ++i) levels.push_back(axis.tick(i));
  return levels;
}

void draw_window(Svg& svg, const Scene& scene, Window& window, const std::vector<double>& levels) {
  draw_axes(svg, window.view);
  const size_t bands = levels.size() - 1;
  for (size_t b = 0; b < scene.bodies.size(); ++b) {
    const Outlines curves = window.view.at(outline_of(scene.bodies[b], 0.0));
    extend(window.grids[b], 2);
    const std::vector<Polygons> filled = fill_bands(window.grids[b], levels);
    svg.begin_clip(window.view.frame);
    svg.begin_clip(curves);
    for (size_t k = 0; k < bands; ++k) {
      if (filled[k].empty()) continue;
      const std::string ink = scale_colour((static_cast<double>(k) + 0.5) / static_cast<double>(bands));
      svg.raw("<path d=\"");
      std::string data;
      append_curves(data, window.view.at(filled[k]));
      // The thin edge closes the seams between polygons of one colour.
      svg.raw(data + "\" fill=\"" + ink + "\" stroke=\"" + ink + "\" stroke-width=\"0.5\"/>\n");
    }
    svg.end_clip();
    svg.area(curves, "none", Stroke{colour::kInk, 1.1, ""});
    svg.end_clip();
  }
}

void draw_bar(Svg& svg, const Box& bar, const Axis& axis, const std::vector<double>& levels) {
  const size_t bands = levels.size() - 1;
  const double high = bar.height() / static_cast<double>(bands);
  for (size_t k = 0; k < bands; ++k) {
    const double bottom = bar.bottom - static_cast<double>(k) * high;
    svg.rectangle({bar.left, bottom - high, bar.right, bottom},
                  scale_colour((static_cast<double>(k) + 0.5) / static_cast<double>(bands)), Stroke{colour::kInk, 0.6, ""});
  }
  double widest = 0.0;
  for (size_t k = 0; k <= bands; ++k) {
    std::string label = axis.label(static_cast<int>(k));
    if (k == bands) label = "&#8805; " + label;
    if (k == 0 && levels[0] > 0.0) label = "&#8804; " + label;
    svg.text({bar.right + 6.0, bar.bottom - static_cast<double>(k) * high + 4.0}, label, 11.0);
    widest = std::max(widest, text_width(label, 11.0));
  }
  svg.text({bar.right + widest + 18.0, 0.5 * (bar.top + bar.bottom)}, axis.name, 12.0, Anchor::kMiddle, colour::kInk, true);
}

c2d_status draw_stress_of(const Scene& scene, const std::string& name, const std::string& title, Range x, Range y,
                          double margin, Pictures& out) {
  const double left = 62.0, right = kPictureWidth - 106.0, top = 14.0;
  const double high = view_height(x, y, right - left, 260.0, 460.0);
  Window window;
  window.view = make_view({left, top, right, top + high}, x, y, margin, scene.length_unit);
  window.grids.resize(scene.bodies.size());
  for (size_t b = 0; b < scene.bodies.size(); ++b) {
    if (const c2d_status status = sample(scene, b, window.view, window.grids[b]); status != C2D_OK) return status;
  }
  DrawnPeak peak = find_peak(window);
  c2d_status status = climb(scene, window, peak);
  if (status == C2D_OK) status = find_on_boundary(scene, window, peak);
  if (status != C2D_OK) return status;
  Axis axis;
  const std::vector<double> levels = choose_levels(window, axis, scene.stress_unit);
  Svg svg(name, kPictureWidth, top + high + 44.0);
  draw_window(svg, scene, window, levels);
  const double bar_high = std::min(high, 26.0 * static_cast<double>(levels.size()));
  const double middle = top + 0.5 * high;
  draw_bar(svg, {right + 16.0, middle - 0.5 * bar_high, right + 34.0, middle + 0.5 * bar_high}, axis, levels);
  Picture picture{name, title, "", ""};
  picture.caption = "von Mises stress at " + place_at_end(scene) + ", drawn on the undeformed shape";
  picture.caption += ": the largest value in the picture is " + figure(peak.value, scene.stress_unit) + " at " +
                     place_text(scene, peak.at, kPeakPlace * size_of(scene));
  if (scene.bodies.size() > 1) picture.caption += " in " + body_label(scene, static_cast<int64_t>(peak.body) + 1);
  picture.caption += ".";
  picture.svg = svg.finish(picture.title, picture.caption);
  out.push_back(picture);
  return C2D_OK;
}

} // namespace

c2d_status draw_stress(const Scene& scene, Pictures& out) {
  Range x, y, zoom_x, zoom_y;
  for (const BodyScene& body : scene.bodies)
    for (const auto& curve : body.curves)
      for (const OutlinePoint& p : curve) x.include(p.at.x), y.include(p.at.y);
  c2d_status status = draw_stress_of(scene, "stress", "Stress inside", x, y, 12.0, out);
  if (status != C2D_OK || scene.pairs.empty()) return status;
  const std::vector<double>& table = scene.record->coefficients.back().table;
  for (size_t p = 0; p < scene.pairs.size() && !table.empty(); ++p)
    if (is_of_contact(scene, scene.pairs[p]) && static_cast<int>(table[p * C2D_PAIR_FIELDS + C2D_STATUS]) != C2D_OPEN)
      for (const Image& image : scene.zone_images)
        for (const Point& on : scene.pairs[p].on) zoom_x.include(image.place(on).x), zoom_y.include(image.place(on).y);
  if (zoom_x.empty) return status;
  const double size = std::max(zoom_x.high - zoom_x.low, zoom_y.high - zoom_y.low);
  const double whole = std::max(x.high - x.low, y.high - y.low);
  if (size <= kLeastZoom * whole || size > 0.6 * whole) return status;
  const double reach = 0.7 * size; // stresses of a contact reach about as deep as it is wide
  Range near_x, near_y;
  for (const double d : {-reach, reach}) {
    for (const double at : {zoom_x.low + d, zoom_x.high + d}) near_x.include(std::min(x.high, std::max(x.low, at)));
    for (const double at : {zoom_y.low + d, zoom_y.high + d}) near_y.include(std::min(y.high, std::max(y.low, at)));
  }
  const auto is_most = [](const Range& part, const Range& all) { return part.high - part.low > 0.8 * (all.high - all.low); };
  if (is_most(near_x, x) && is_most(near_y, y)) return status; // no nearer than the picture before
  return draw_stress_of(scene, "stress_zone", "Stress near the contact", near_x, near_y, 12.0, out);
}

} // namespace app
