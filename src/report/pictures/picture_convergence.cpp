#include "report/drawn/axes.hpp"
#include "report/pictures/pictures.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace app {
namespace {

const Stroke kMeasureLines[] = {{colour::kBlue, 1.8, ""},           {colour::kOrange, 1.8, "7 3"}, {colour::kGreen, 1.8, "2 2"},
                                {colour::kPurple, 1.8, "10 3 2 3"}, {colour::kInk, 1.4, "4 3"},    {colour::kFaint, 1.8, ""}};
constexpr Mark kMarks[] = {Mark::kCircle, Mark::kSquare, Mark::kTriangle, Mark::kDiamond, Mark::kCircle, Mark::kSquare};
constexpr size_t kMostLines = 6;

struct Line {
  std::string name;
  std::vector<Point> points; // elements, size
};

constexpr double kLeast = 1e-4; // smaller sizes are round-off, or of no interest

void add(Line& line, double elements, double size) {
  if (std::isfinite(size) && size >= kLeast) line.points.push_back({elements, size});
}

std::vector<Line> changes(const MeshLoop& loop) {
  std::vector<Line> out{{"tractions", {}}, {"energy", {}}};
  for (const MeshRound& round : loop.rounds) {
    add(out[0], round.elements, 100.0 * round.pressure);
    add(out[1], round.elements, 100.0 * round.energy);
  }
  return out;
}

// For every kind of requested number the largest error in units of its tolerance. The kinds that are worst in the
// end come first.
std::vector<Line> errors(const MeshLoop& loop) {
  std::map<std::string, Line> lines;
  std::map<std::string, double> last;
  for (const MeshRound& round : loop.rounds) {
    std::map<std::string, double> worst;
    for (const Stated& s : round.stated)
      if (!std::isnan(s.tolerance) && s.relative_error() > 0.0) { // not NaN
        double& size = worst[s.name()];
        size = std::max(size, s.relative_error() / s.tolerance);
      }
    for (const auto& [name, size] : worst) {
      Line& line = lines[name];
      line.name = escape_xml(name);
      add(line, round.elements, size);
      last[name] = size;
    }
  }
  std::vector<std::pair<double, std::string>> order;
  for (const auto& [name, size] : last) order.emplace_back(-size, name);
  order.erase(std::remove_if(order.begin(), order.end(), [&](const auto& o) { return lines[o.second].points.empty(); }),
              order.end());
  std::sort(order.begin(), order.end());
  std::vector<Line> out;
  for (size_t i = 0; i < std::min(order.size(), kMostLines); ++i) out.push_back(lines[order[i].second]);
  return out;
}

bool has_points(const std::vector<Line>& lines) {
  return std::any_of(lines.begin(), lines.end(), [](const Line& line) { return !line.points.empty(); });
}

std::vector<LegendEntry> legend_of(const std::vector<Line>& lines) {
  std::vector<LegendEntry> out;
  for (size_t i = 0; i < lines.size(); ++i)
    if (!lines[i].points.empty())
      out.push_back({lines[i].name, beneath(kMeasureLines[i], lines.size() - 1 - i), kMarks[i], i % 2 == 0, ""});
  return out;
}

void draw_chart(Svg& svg, const Box& frame, const Range& elements, const std::vector<Line>& lines, const std::string& name,
                bool goal) {
  Range size;
  for (const Line& line : lines)
    for (const Point& p : line.points) size.include(p.y);
  if (goal) size.include(1.0);
  const Chart chart{frame, make_log_axis(elements, "elements of all bodies"), make_log_axis(size, name)};
  draw_axes(svg, chart);
  if (goal) {
    const double y = chart.at(1.0, 1.0).y;
    svg.line({frame.left, y}, {frame.right, y}, Stroke{colour::kInk, 1.6, ""});
  }
  svg.begin_clip({frame.left - 5.0, frame.top - 5.0, frame.right + 5.0, frame.bottom + 5.0});
  for (size_t i = 0; i < lines.size(); ++i) {
    std::vector<Point> points;
    for (const Point& p : lines[i].points) points.push_back(chart.at(p));
    svg.polyline(points, beneath(kMeasureLines[i], lines.size() - 1 - i));
    for (const Point& p : points) svg.mark(kMarks[i], p, 6.0, kMeasureLines[i].colour, i % 2 == 0);
  }
  svg.end_clip();
}

std::string caption_of(bool has_errors) {
  std::string out =
      "Above: difference of tractions (of the worst contact, averaged over it and the history) and of energy from "
      "the previous mesh, with elements twice as long.";
  if (has_errors)
    out += " Below: stated errors of the requested numbers, the largest of every kind, divided by their tolerances; "
           "below the thick line the tolerances are met. Values below " +
           figure(kLeast) + " are omitted. Errors are estimates, not bounds.";
  return out;
}

} // namespace

void draw_convergence(const Scene& scene, Pictures& out) {
  const MeshLoop& loop = scene.record->meshes;
  const std::vector<Line> left = changes(loop), right = errors(loop);
  if (left[0].points.size() < 2 && left[1].points.size() < 2) return; // two meshes alone do not converge
  const bool both = has_points(right);
  Range elements;
  for (const MeshRound& round : loop.rounds)
    if (std::isfinite(round.pressure) || std::isfinite(round.energy)) elements.include(round.elements);
  const double from = 72.0, to = kPictureWidth - 18.0, wide = to - from, top = 30.0, high = 210.0;
  const double first = draw_legend(nullptr, {0.0, 0.0}, wide, legend_of(left)) + high + 44.0;
  const double second = both ? draw_legend(nullptr, {0.0, 0.0}, wide, legend_of(right)) + high + 74.0 : 0.0;
  const Box frames[2] = {{from, top, to, top + high}, {from, top + first + 30.0, to, top + first + 30.0 + high}};
  Svg svg("convergence", kPictureWidth, top + first + second);
  draw_chart(svg, frames[0], elements, left, "change, %", false);
  draw_heading(svg, frames[0], "Change from the mesh before");
  draw_legend(&svg, {from, frames[0].bottom + 42.0}, wide, legend_of(left));
  if (both) {
    draw_chart(svg, frames[1], elements, right, "stated error / tolerance", true);
    draw_heading(svg, frames[1], "Stated errors");
    draw_legend(&svg, {from, frames[1].bottom + 42.0}, wide, legend_of(right));
  }
  Picture picture{"convergence", "Convergence over the meshes", caption_of(both), ""};
  picture.svg = svg.finish(picture.title, picture.caption);
  out.push_back(picture);
}

} // namespace app
