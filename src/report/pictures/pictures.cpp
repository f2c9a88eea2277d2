#include "report/pictures/pictures.hpp"

#include "post/zone_line.hpp"
#include "report/text.hpp"

#include <algorithm>

namespace app {

void draw_charts(const Scene& scene, size_t coefficients, void (*draw)(const Scene&, size_t, size_t, Pictures&),
                 Pictures& out) {
  size_t drawn = 0;
  for (size_t c = 0; c < coefficients; ++c)
    for (const bool tied : {false, true})
      for (size_t z = 0; z < scene.zones.size(); ++z)
        if (scene.zones[z].tied == tied && !scene.record->coefficients[c].table.empty() && scene.zones[z].pairs > 0 &&
            drawn++ < kMostCharts)
          draw(scene, c, z, out);
}

std::string chart_title(const Scene& scene, double mu, size_t zone) {
  std::string out = scene.zones[zone].tied ? "" : ", &#956; = " + figure(mu);
  if (scene.zones.size() < 2) return out;
  out += ", " + zone_label(scene, zone);
  if (scene.summary.names_bodies()) out += ": " + bodies_of(scene, scene.zones[zone]);
  return out;
}

std::string body_label(const Scene& scene, int64_t body) { return escape_xml(body_text(scene.summary, body)); }

std::string zone_label(const Scene& scene, size_t zone) {
  return escape_xml(zone_text(scene.summary, static_cast<int64_t>(zone) + 1));
}

std::string bodies_of(const Scene& scene, const ZoneScene& zone) {
  return body_label(scene, zone.body[0]) + " on " + body_label(scene, zone.body[1]);
}

std::string place_text(const Scene& scene, Point p, double size) {
  return "(" + figure(told_place(p.x, size)) + ", " + figure(told_place(p.y, size)) + ")" +
         (scene.length_unit.empty() ? "" : " " + scene.length_unit);
}

double size_of(const Scene& scene) {
  Range x, y;
  for (const BodyScene& body : scene.bodies)
    for (const auto& curve : body.curves)
      for (const OutlinePoint& p : curve) x.include(p.at.x), y.include(p.at.y);
  return std::max(x.high - x.low, y.high - y.low);
}

double sum_of_forces(const Scene& scene) {
  const auto extent = [&](Point a, Point b) { // of bodies of revolution the area, as their forces are whole
    return distance(a, b) * (scene.is_revolved() ? 3.14159265358979324 * std::fabs(a.x + b.x) : 1.0);
  };
  double sum = 0.0;
  for (const BodyScene& body : scene.bodies) {
    std::vector<double> length(body.on_line.size(), 0.0);
    for (const auto& curve : body.curves)
      for (size_t i = 0; i < curve.size(); ++i)
        length[static_cast<size_t>(curve[i].element) - 1] += extent(curve[i].at, curve[(i + 1) % curve.size()].at);
    const size_t ends = length.empty() ? 0 : body.traction.size() / length.size();
    for (size_t e = 0; e < length.size(); ++e)
      for (size_t l = 0; l < ends; ++l) sum += length[e] * app::length(body.traction[e * ends + l]) / static_cast<double>(ends);
  }
  return sum;
}

std::string contact_zones(const Scene& scene) {
  return scene.summary.names_bodies() && scene.zones.size() > 1 ? "zones" : "zone";
}

const BodyStyle& style_of(size_t body) {
  static const BodyStyle kStyles[] = {
      {"#dce9f5", "#b9cbdc", colour::kBlue, ""},     {"#e6c88c", "#c2a263", "#8a5a00", "7 2"},
      {"#f6f3ea", "#d6d0bc", "#444444", "12 3"},     {"#a4b494", "#85966f", "#33521f", "4 2"},
      {"#e8d0dc", "#c8a9b9", "#7a2a5a", "10 2 3 2"}, {"#b4b8cc", "#9297b0", "#35357a", "14 2 2 2 2 2"}};
  return kStyles[body % 6];
}

std::string chart_suffix(const Scene& scene, size_t coefficient, size_t zone) {
  std::string out;
  if (scene.summary.coefficients > 1) out += "_" + std::to_string(coefficient + 1);
  if (scene.zones.size() > 1) out += "_zone" + std::to_string(zone + 1);
  return out;
}

bool is_of_contact(const Scene& scene, const PairScene& pair) {
  const ZoneScene& zone = scene.zones[static_cast<size_t>(pair.zone) - 1];
  return !scene.bodies[static_cast<size_t>(zone.body[0]) - 1].platen;
}

bool has_contact(const Scene& scene) {
  for (const PairScene& pair : scene.pairs)
    if (is_of_contact(scene, pair)) return true;
  return false;
}

bool is_tied(const CoefficientRecord& record, const ZoneScene& zone) {
  return static_cast<int>(record.table[zone.first * C2D_PAIR_FIELDS + C2D_STATUS]) == C2D_TIED;
}

Mark status_mark(int status) {
  if (status == C2D_TIED) return Mark::kSquare;
  return status == C2D_STICK ? Mark::kCircle : status == C2D_SLIP ? Mark::kTriangle : Mark::kCross;
}

std::vector<LegendEntry> status_legend(bool tied) {
  if (tied) return {{"tied", Stroke{}, Mark::kSquare, true, ""}};
  return {{"stick", Stroke{}, Mark::kCircle, true, ""},
          {"slip", Stroke{}, Mark::kTriangle, true, ""},
          {"open", Stroke{}, Mark::kCross, true, ""}};
}

std::string position_name(const Scene& scene, const ZoneScene& zone) {
  const std::string along = ", along body " + std::to_string(zone.body[0]);
  if (*zone.position != 's') return zone.position + along;
  if (!zone.symmetric_origin) return "s from pair " + std::to_string(zone.origin + 1) + along;
  const Summary& s = scene.summary;
  std::string line;
  if (s.symmetry == 3) // which of the two
    line = scene.pairs[zone.origin].image_line == 1 ? " x = " + figure(s.symmetry_at[0]) : " y = " + figure(s.symmetry_at[1]);
  return std::string("s from the ") + scene.mirror_name() + line + along;
}

Axis position_axis(const Scene& scene, const ZoneScene& zone) {
  Range s;
  for (const ZoneSample& p : zone.samples) s.include(p.s);
  return make_axis(s, position_name(scene, zone), scene.length_unit, 6, true);
}

std::string traction_name(const ZoneScene& zone, bool normal) {
  if (zone.tied) return normal ? "normal stress tn" : "shear stress tt";
  return normal ? "contact pressure tn" : "friction tt";
}

c2d_status draw_pictures(const Scene& scene, Pictures& out) {
  draw_contact(scene, out);
  draw_model(scene, out);
  draw_tractions(scene, out);
  draw_status_map(scene, out);
  draw_loop(scene, out);
  draw_cycles(scene, out);
  draw_cycle_loop(scene, out);
  draw_cycle_status(scene, out);
  draw_gap(scene, out);
  c2d_status status = C2D_OK;
  if (scene.solved) {
    draw_deformed(scene, out);
    status = draw_boundary_stress(scene, out);
    if (status == C2D_OK) status = draw_stress(scene, out);
  }
  draw_path(scene, out);
  draw_energy(scene, out);
  if (scene.solved) draw_balance(scene, out);
  draw_fatigue(scene, out);
  draw_tolerances(scene, out);
  draw_meshes(scene, out);
  draw_convergence(scene, out);
  return status;
}

} // namespace app
