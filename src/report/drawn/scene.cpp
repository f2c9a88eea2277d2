#include "report/drawn/scene.hpp"

#include "report/drawn/outline.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

c2d_status get_points(c2d_solver* solver, int32_t field_x, int32_t body, int32_t count, std::vector<Point>& out) {
  std::vector<double> x(static_cast<size_t>(count)), y(x.size());
  c2d_status status = c2d_get(solver, field_x, body, 1, count, x.data(), 1);
  if (status == C2D_OK) status = c2d_get(solver, field_x + 1, body, 1, count, y.data(), 1);
  out.resize(x.size());
  for (size_t i = 0; i < x.size(); ++i) out[i] = {x[i], y[i]};
  return status;
}

c2d_status get_integers(c2d_solver* solver, int32_t field, int32_t body, int32_t count, std::vector<int32_t>& out) {
  std::vector<double> values(static_cast<size_t>(count));
  const c2d_status status = c2d_get(solver, field, body, 1, count, values.data(), 1);
  out.assign(values.begin(), values.end());
  return status;
}

c2d_status gather_body(Scene& scene, int32_t body) {
  const Summary& s = scene.summary;
  c2d_solver* solver = scene.solver;
  const size_t b = static_cast<size_t>(body) - 1;
  BodyScene& out = scene.bodies[b];
  const int32_t ends = s.body[b].elements * s.function_nodes;
  out.platen = s.is_platen(body);
  if (out.platen) return C2D_OK;
  std::vector<Point> nodes;
  c2d_status status = get_points(solver, C2D_NODE_X, body, s.body[b].points, nodes);
  if (status == C2D_OK) status = get_points(solver, C2D_END_X, body, ends, out.ends);
  if (status == C2D_OK) status = get_integers(solver, C2D_END_NODE, body, ends, out.nodes);
  if (status == C2D_OK && scene.solved) status = get_points(solver, C2D_END_UX, body, ends, out.displacement);
  if (status == C2D_OK && scene.solved) status = get_points(solver, C2D_END_TX, body, ends, out.traction);
  if (status == C2D_OK && scene.solved) status = get_integers(solver, C2D_END_STATUS, body, ends, out.status);
  if (status != C2D_OK) return status;
  status = trace_outline(solver, s, body, nodes, out);
  if (status != C2D_OK) return status;
  for (int32_t e = 1; e <= s.body[b].elements; ++e)
    for (int32_t l = 1; l <= s.function_nodes; ++l) {
      EndCondition c{};
      double values[4];
      for (int32_t k = 1; k <= s.load_cases; ++k) {
        status = c2d_get_condition(solver, body, e, l, k, c.codes, values);
        if (status != C2D_OK) return status;
        for (int q = 0; q < 4; ++q) c.values[q].push_back(values[q]);
      }
      out.conditions.push_back(c);
    }
  return C2D_OK;
}

void name_units(Scene& scene) {
  const std::string length = escape_xml(scene.summary.unit_length), force = escape_xml(scene.summary.unit_force);
  scene.length_unit = length;
  if (force.empty() || length.empty()) return;
  scene.stress_unit = force + "/" + length + "&#178;";
  scene.force_unit = scene.is_revolved() ? force : force + "/" + length;
  scene.work_unit = scene.is_revolved() ? force + " " + length : force;
}

} // namespace

c2d_status gather_scene(c2d_solver* solver, const RunRecord& record, const History& history, Scene& scene) {
  scene.solver = solver;
  scene.record = &record;
  scene.history = &history;
  c2d_status status = get_summary(solver, scene.summary);
  if (status != C2D_OK) return status;
  scene.solved = scene.summary.state == C2D_STATE_RUNNING;
  name_units(scene);
  scene.bodies.resize(static_cast<size_t>(scene.summary.bodies));
  for (int32_t body = 1; body <= scene.summary.bodies && status == C2D_OK; ++body) status = gather_body(scene, body);
  if (status == C2D_OK) status = gather_zones(scene);
  if (status == C2D_OK) status = gather_loads(scene);
  return status;
}

double friction_of(const Scene& scene, size_t coefficient, size_t zone) {
  double mu = scene.record->coefficients[coefficient].mu;
  c2d_get_friction(scene.solver, static_cast<int32_t>(zone) + 1, static_cast<int32_t>(coefficient) + 1, &mu);
  return mu;
}

Outlines outline_of(const BodyScene& body, double magnification) {
  Outlines out;
  for (const std::vector<OutlinePoint>& curve : body.curves) {
    out.emplace_back();
    for (const OutlinePoint& p : curve)
      out.back().push_back({p.at.x + magnification * (p.moved.x - p.at.x), p.at.y + magnification * (p.moved.y - p.at.y)});
  }
  return out;
}

ZoneFacts find_facts(const Scene& scene, const ZoneScene& zone, const std::vector<double>& table) {
  ZoneFacts f;
  f.peak_pair = zone.first;
  bool stuck = false; // the pair before
  for (size_t p = zone.first; p < zone.first + zone.pairs; ++p) {
    const double* row = table.data() + p * C2D_PAIR_FIELDS;
    const double s = scene.pairs[p].s;
    const int status = static_cast<int>(row[C2D_STATUS]);
    if (p == zone.first || is_larger(row[C2D_TN], f.peak)) f.peak = row[C2D_TN], f.peak_pair = p;
    const bool begins = status == C2D_STICK && !stuck;
    stuck = status == C2D_STICK;
    if (status == C2D_OPEN) continue;
    f.low = f.touching == 0 ? s : std::min(f.low, s);
    f.high = f.touching == 0 ? s : std::max(f.high, s);
    ++f.touching;
    if (status == C2D_SLIP) ++f.slipping;
    if (status != C2D_STICK) continue;
    f.stick_low = f.sticking == 0 ? s : std::min(f.stick_low, s);
    f.stick_high = f.sticking == 0 ? s : std::max(f.stick_high, s);
    ++f.sticking;
    f.stretches += begins ? 1 : 0;
  }
  return f;
}

std::string words_of_sticking(const Scene& scene, const ZoneScene& zone, const ZoneFacts& f) {
  const std::string low = std::string(zone.position) + " = " + figure(f.stick_low, scene.length_unit),
                    high = figure(f.stick_high, scene.length_unit);
  if (f.stretches < 2) return "; sticking from " + low + " to " + high;
  return "; sticking in " + std::to_string(f.stretches) + " stretches between " + low + " and " + high;
}

std::string place_on_path(const Scene& scene, size_t coefficient) {
  const CoefficientRecord& record = scene.record->coefficients[coefficient];
  const std::vector<CoefficientHistory>& histories = scene.history->coefficients();
  if (coefficient >= histories.size() || rises(histories[coefficient])) return "load factor " + figure(record.load);
  return "step " + std::to_string(record.step) + " (load factor" + (histories[coefficient].loads.size() > 1 ? "s " : " ") +
         list_of(histories[coefficient].loads) + ")";
}

// Has every contact the coefficient of the run, or have some one of their own?
static bool has_one_friction(const Scene& scene, size_t coefficient) {
  for (size_t z = 0; z < scene.zones.size(); ++z)
    if (!scene.zones[z].tied && friction_of(scene, coefficient, z) != scene.record->coefficients[coefficient].mu) return false;
  return true;
}

std::string place_at_end(const Scene& scene) {
  const size_t count = scene.record->coefficients.size();
  std::string out = count > 0 ? place_on_path(scene, count - 1) : "load factor " + figure(scene.summary.load);
  const bool names_friction = count != 1 || has_one_friction(scene, 0);
  if (!scene.pairs.empty() && names_friction) out += ", &#956; = " + figure(scene.summary.mu);
  return out;
}

std::string list_of(const std::vector<double>& numbers) {
  std::string out;
  for (size_t i = 0; i < numbers.size(); ++i) out += (i > 0 ? ", " : "") + figure(numbers[i]);
  return out;
}

std::string figure(double value, int digits) {
  std::string out;
  if (std::isinf(value)) return "infinite";
  append_general(out, value, 0, digits);
  const size_t at = out.find("e+0");
  if (at == std::string::npos || out[at + 3] > '6') return out;
  const double last = std::pow(10.0, out[at + 3] - '0' + 1 - digits); // up to ten million in full: 210000
  out.clear();
  append_general(out, std::round(value / last) * last, 0, 7);
  return out;
}

std::string figure(double value, const std::string& unit, int digits) {
  return unit.empty() ? figure(value, digits) : figure(value, digits) + " " + unit;
}

} // namespace app
