#include "report/page/frames.hpp"

#include "report/pictures/pictures.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cmath>

namespace app {

const char kFrameStyle[] =
    ".frames{display:flex;flex-wrap:wrap;gap:2px;border:0;padding:0;margin:0;min-width:0;font-size:13px}\n"
    ".frames input{position:absolute;opacity:0}.frames label{padding:2px 8px;border:1px solid #999;cursor:pointer}\n"
    ".frames :checked+label{background:#0060a8;color:#fff}.frames :focus-visible+label{outline:3px solid #d55e00}\n"
    ".frames figure{display:none;order:1;flex-basis:100%}.frames :checked+label+figure{display:block}\n"
    "@media print{.frames label{display:none}}\n";

namespace {

const Stroke kPressureLine{colour::kBlue, 1.8, ""}, kFrictionLine{colour::kOrange, 1.8, "6 2"};
constexpr double kFilmLeft = 66.0, kFilmStrip = 12.0, kFilmHigh = 250.0;

// What all frames of a zone share.
struct Film {
  const Scene& scene;
  const ZoneScene& zone;
  double mu;
  bool friction, bounded, by_load; // bounded: there is friction, and mu limits it
  Axis place, stress;
};

double turned(const ZoneSample& p, const double* row, size_t column) { return (column == C2D_TT ? p.turn : 1.0) * row[column]; }

// All tractions of the zone at one step, up to the limit of an axis.
void include_state(const Scene& scene, const ZoneScene& zone, const std::vector<double>& table, Range& range, bool& friction) {
  const double limit = axis_limit(scene, zone, table, C2D_TN);
  for (const ZoneSample& p : zone.samples) {
    const double* row = table.data() + p.pair * C2D_PAIR_FIELDS;
    friction = friction || std::fabs(row[C2D_TT]) > 1e-12 * std::fabs(row[C2D_TN]);
    for (const size_t column : {size_t{C2D_TN}, size_t{C2D_TT}})
      range.include(std::max(-limit, std::min(limit, turned(p, row, column))));
  }
}

std::vector<Point> curve_in(const Film& film, const std::vector<double>& table, size_t column, const Chart& chart,
                            double factor = 1.0) {
  std::vector<Point> out;
  for (const ZoneSample& p : film.zone.samples)
    out.push_back(chart.at(p.s, factor * turned(p, table.data() + p.pair * C2D_PAIR_FIELDS, column)));
  return out;
}

// The area within the Coulomb bounds.
void draw_bounds(Svg& svg, const Film& film, const std::vector<double>& table, const Chart& chart) {
  std::vector<Point> band = curve_in(film, table, C2D_TN, chart, film.mu);
  const std::vector<Point> lower = curve_in(film, table, C2D_TN, chart, -film.mu);
  band.insert(band.end(), lower.rbegin(), lower.rend());
  svg.begin_clip(chart.frame);
  svg.area({band}, "#eeeeee", Stroke{});
  svg.end_clip();
}

std::vector<LegendEntry> legend_of(const Film& film, const StatusFills& fills) {
  std::vector<LegendEntry> out{{traction_name(film.zone, true), beneath(kPressureLine, 1), Mark::kNone, true, ""}};
  if (film.friction) out.push_back({traction_name(film.zone, false), kFrictionLine, Mark::kNone, true, ""});
  if (film.bounded) out.push_back({"Coulomb bounds", Stroke{}, Mark::kNone, true, "#eeeeee"});
  for (const LegendEntry& entry : fills_legend(fills)) out.push_back(entry);
  return out;
}

std::string caption_of(const Film& film, const Snapshot& s) {
  const ZoneFacts f = find_facts(film.scene, film.zone, s.table);
  std::string out = "Step " + std::to_string(s.step) + ", " +
                    (film.by_load ? "load factor " + figure(s.load) : "load factors " + list_of(s.loads)) + ": ";
  if (f.touching == 0) return out + "no pair touches.";
  out += "the largest pressure of a pair is " + figure(f.peak, film.scene.stress_unit) + " at " + film.zone.position + " = " +
         figure(film.scene.pairs[f.peak_pair].s, film.scene.length_unit) + "; " + std::to_string(f.touching) + " of " +
         std::to_string(film.zone.pairs) + " pairs touch";
  return out + ", " + std::to_string(f.sticking) + " stick, " + std::to_string(f.slipping) + " slip.";
}

std::string draw_frame(const Film& film, const Snapshot& s, const std::string& name, const std::string& caption) {
  const double right = kPictureWidth - 18.0;
  Svg svg(name, kPictureWidth, 0.0);
  const StatusFills fills = status_fills(svg);
  const std::vector<LegendEntry> entries = legend_of(film, fills);
  const double top = draw_legend(nullptr, {kFilmLeft, 4.0}, right - kFilmLeft, entries) + kFilmStrip + 12.0;
  svg.set_height(top + kFilmHigh + 44.0);
  draw_legend(&svg, {kFilmLeft, 4.0}, right - kFilmLeft, entries);
  const Chart chart{{kFilmLeft, top, right, top + kFilmHigh}, film.place, film.stress};
  std::string status;
  for (size_t p = 0; p * C2D_PAIR_FIELDS < s.table.size(); ++p)
    status += static_cast<char>(static_cast<int>(s.table[p * C2D_PAIR_FIELDS + C2D_STATUS]));
  draw_status_row(svg, chart, film.zone, borders_of(film.zone), status, top - kFilmStrip - 4.0, top - 4.0, fills);
  if (film.bounded) draw_bounds(svg, film, s.table, chart);
  draw_axes(svg, chart);
  svg.begin_clip(chart.frame);
  svg.polyline(curve_in(film, s.table, C2D_TN, chart), beneath(kPressureLine, 1));
  if (film.friction) svg.polyline(curve_in(film, s.table, C2D_TT, chart), kFrictionLine);
  svg.end_clip();
  return svg.finish("Step " + std::to_string(s.step), caption);
}

void append_film(std::string& out, const Scene& scene, size_t coefficient, size_t zone_index) {
  const CoefficientHistory& history = scene.history->coefficients()[coefficient];
  const std::vector<const Snapshot*> frames = frames_of(history);
  const ZoneScene& zone = scene.zones[zone_index];
  Range range;
  range.include(0.0);
  bool friction = false;
  for (const Snapshot* s : frames) include_state(scene, zone, s->table, range, friction);
  const double mu = friction_of(scene, coefficient, zone_index);
  const Film film{scene,
                  zone,
                  mu,
                  friction,
                  friction && mu > 0.0 && std::isfinite(mu),
                  rises(history),
                  position_axis(scene, zone),
                  make_axis(range, "traction", scene.stress_unit, 6)};
  const std::string suffix = chart_suffix(scene, coefficient, zone_index), group = "frames" + suffix;
  out += "<section id=\"" + group + "\">\n<h2>Along the load path" + chart_title(scene, mu, zone_index) +
         "</h2>\n<fieldset class=\"frames\">\n<legend>Recorded step (arrow keys go on and back)</legend>\n";
  for (const Snapshot* s : frames) {
    const std::string number = std::to_string(s->step), id = group + "_" + number, caption = caption_of(film, *s);
    out += "<input type=\"radio\" name=\"" + group + "\" id=\"" + id + "\"" +
           (s == frames.back() ? " checked=\"checked\"" : "") + "/><label for=\"" + id + "\">" + number +
           "</label>\n<figure>\n" + draw_frame(film, *s, id + "_", caption) + "<figcaption>" + caption +
           "</figcaption>\n</figure>\n";
  }
  out += "</fieldset>\n</section>\n";
}

} // namespace

void append_frames(std::string& out, const Scene& scene) {
  int left = kMostFramed;
  for (size_t c = 0; c < scene.history->coefficients().size(); ++c)
    for (size_t z = 0; z < scene.zones.size(); ++z)
      if (!scene.zones[z].tied && scene.zones[z].pairs > 0 && frames_of(scene.history->coefficients()[c]).size() > 2 &&
          left-- > 0)
        append_film(out, scene, c, z);
}

} // namespace app
