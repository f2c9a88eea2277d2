#include "report/scene.hpp"

#include "report/outline.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

c2d_status get_points(c2d_solver* solver, int32_t field_x, int32_t body, int32_t count,
                      std::vector<Point>& out) {
  std::vector<double> x(static_cast<size_t>(count)), y(x.size());
  c2d_status status = c2d_get(solver, field_x, body, 1, count, x.data(), 1);
  if (status == C2D_OK) status = c2d_get(solver, field_x + 1, body, 1, count, y.data(), 1);
  out.resize(x.size());
  for (size_t i = 0; i < x.size(); ++i) out[i] = {x[i], y[i]};
  return status;
}

c2d_status get_integers(c2d_solver* solver, int32_t field, int32_t body, int32_t count,
                        std::vector<int32_t>& out) {
  std::vector<double> values(static_cast<size_t>(count));
  const c2d_status status = c2d_get(solver, field, body, 1, count, values.data(), 1);
  out.assign(values.begin(), values.end());
  return status;
}

c2d_status gather_body(Scene& scene, int32_t body) {
  const c2d_summary& s = scene.summary;
  c2d_solver* solver = scene.solver;
  const size_t b = static_cast<size_t>(body) - 1;
  BodyScene& out = scene.bodies[b];
  const int32_t ends = s.elements[b] * s.function_nodes;
  std::vector<Point> nodes;
  c2d_status status = get_points(solver, C2D_NODE_X, body, s.geometry_nodes[b], nodes);
  if (status == C2D_OK) status = get_points(solver, C2D_END_X, body, ends, out.ends);
  if (status == C2D_OK) status = get_integers(solver, C2D_END_NODE, body, ends, out.nodes);
  if (status == C2D_OK && scene.solved) status = get_points(solver, C2D_END_UX, body, ends, out.displacement);
  if (status == C2D_OK && scene.solved) status = get_points(solver, C2D_END_TX, body, ends, out.traction);
  if (status == C2D_OK && scene.solved) status = get_integers(solver, C2D_END_STATUS, body, ends, out.status);
  if (status != C2D_OK) return status;
  status = trace_outline(solver, s, body, nodes, out);
  if (status != C2D_OK) return status;
  for (int32_t e = 1; e <= s.elements[b]; ++e)
    for (int32_t l = 1; l <= s.function_nodes; ++l) {
      EndCondition c{{0, 0, 1, 1}, {0.0, 0.0, 0.0, 0.0}};
      status = c2d_get_condition(solver, body, e, l, c.codes, c.values);
      if (status != C2D_OK) return status;
      out.conditions.push_back(c);
    }
  return C2D_OK;
}

// Where a functional node lies, and whether a displacement of it is prescribed.
Point place_of_node(const BodyScene& body, int32_t node, bool& held) {
  Point place;
  for (size_t i = 0; i < body.nodes.size(); ++i) {
    if (body.nodes[i] != node) continue;
    place = body.ends[i];
    held = held || body.conditions[i].codes[2] == 0 || body.conditions[i].codes[3] == 0;
  }
  return place;
}

// s along body 1, chord by chord, from the zone's origin; towards larger x, in a steep zone towards larger y.
void measure(Scene& scene, ZoneScene& zone) {
  if (zone.pairs == 0) return;
  PairScene* p = scene.pairs.data() + zone.first;
  p[0].s = 0.0;
  for (size_t i = 1; i < zone.pairs; ++i)
    p[i].s = p[i - 1].s + std::hypot(p[i].on[0].x - p[i - 1].on[0].x, p[i].on[0].y - p[i - 1].on[0].y);
  const Point a = p[0].on[0], b = p[zone.pairs - 1].on[0];
  const bool steep = std::fabs(b.y - a.y) > 1.001 * std::fabs(b.x - a.x);
  const bool reversed = steep ? b.y < a.y : b.x < a.x;
  const bool at_first = p[0].symmetric, at_last = p[zone.pairs - 1].symmetric;
  zone.symmetric_origin = at_first != at_last;
  zone.origin = at_first != at_last ? (at_first ? 0 : zone.pairs - 1) : (reversed ? zone.pairs - 1 : 0);
  const double from = p[zone.origin].s, sign = reversed ? -1.0 : 1.0;
  for (size_t i = 0; i < zone.pairs; ++i) p[i].s = sign * (p[i].s - from) + 0.0;
}

c2d_status gather_pairs(Scene& scene) {
  const int32_t count = scene.summary.pairs;
  if (count == 0) return C2D_OK;
  std::vector<int32_t> node[2], zone;
  std::vector<Point> place; // on body 1: in zones of meshes that do not match no node lies there
  c2d_status status = get_integers(scene.solver, C2D_PAIR_NODE1, 1, count, node[0]);
  if (status == C2D_OK) status = get_integers(scene.solver, C2D_PAIR_NODE2, 1, count, node[1]);
  if (status == C2D_OK) status = get_points(scene.solver, C2D_X, 1, count, place);
  if (status == C2D_OK) status = get_integers(scene.solver, C2D_PAIR_ZONE, 1, count, zone);
  if (status != C2D_OK) return status;
  scene.zones.resize(static_cast<size_t>(scene.summary.zones));
  for (size_t p = 0; p < zone.size(); ++p) {
    PairScene pair{zone[p], {}, 0.0, false};
    for (size_t b = 0; b < 2; ++b) pair.on[b] = place_of_node(scene.bodies[b], node[b][p], pair.symmetric);
    pair.on[0] = place[p];
    const c2d_summary& s = scene.summary;
    pair.symmetric = pair.symmetric || ((s.symmetry & 1) != 0 && pair.on[0].x == s.symmetry_at[0]) ||
                     ((s.symmetry & 2) != 0 && pair.on[0].y == s.symmetry_at[1]);
    scene.pairs.push_back(pair);
    const size_t z = static_cast<size_t>(zone[p]) - 1;
    if (z >= scene.zones.size()) continue;
    if (scene.zones[z].pairs++ == 0) scene.zones[z].first = p;
  }
  for (ZoneScene& z : scene.zones) measure(scene, z);
  return C2D_OK;
}

void name_units(Scene& scene) {
  const std::string length = escape_xml(scene.summary.unit_length),
                    force = escape_xml(scene.summary.unit_force);
  scene.length_unit = length;
  if (force.empty() || length.empty()) return;
  scene.stress_unit = force + "/" + length + "&#178;";
  scene.force_unit = force + "/" + length;
  scene.work_unit = force;
}

} // namespace

c2d_status gather_scene(c2d_solver* solver, const RunRecord& record, const History& history, Scene& scene) {
  scene.solver = solver;
  scene.record = &record;
  scene.history = &history;
  c2d_status status = c2d_get_summary(solver, &scene.summary);
  if (status != C2D_OK) return status;
  scene.solved = scene.summary.state == C2D_STATE_RUNNING;
  name_units(scene);
  scene.bodies.resize(static_cast<size_t>(scene.summary.bodies));
  for (int32_t body = 1; body <= scene.summary.bodies && status == C2D_OK; ++body)
    status = gather_body(scene, body);
  if (status == C2D_OK) status = gather_pairs(scene);
  PointLoad load{};
  double at[2], force[2];
  for (int32_t i = 1; status == C2D_OK && c2d_get_point_load(solver, i, &load.body, at, force) == C2D_OK;
       ++i) {
    load.at = {at[0], at[1]};
    load.force = {force[0], force[1]};
    scene.point_loads.push_back(load);
  }
  return status;
}

double friction_of(const Scene& scene, size_t coefficient, size_t zone) {
  double mu = scene.record->coefficients[coefficient].mu;
  c2d_get_zone_friction(scene.solver, static_cast<int32_t>(zone) + 1, static_cast<int32_t>(coefficient) + 1,
                        &mu);
  return mu;
}

std::vector<std::vector<Point>> outline_of(const BodyScene& body, double magnification) {
  std::vector<std::vector<Point>> out;
  for (const std::vector<OutlinePoint>& curve : body.curves) {
    out.emplace_back();
    for (const OutlinePoint& p : curve)
      out.back().push_back(
          {p.at.x + magnification * (p.moved.x - p.at.x), p.at.y + magnification * (p.moved.y - p.at.y)});
  }
  return out;
}

ZoneFacts find_facts(const Scene& scene, const ZoneScene& zone, const std::vector<double>& table) {
  ZoneFacts f;
  f.peak_pair = zone.first;
  for (size_t p = zone.first; p < zone.first + zone.pairs; ++p) {
    const double* row = table.data() + p * C2D_PAIR_FIELDS;
    const double s = scene.pairs[p].s;
    const int status = static_cast<int>(row[C2D_STATUS]);
    if (p == zone.first || row[C2D_TN] > f.peak) f.peak = row[C2D_TN], f.peak_pair = p;
    if (status == C2D_OPEN) continue;
    f.low = f.touching == 0 ? s : std::min(f.low, s);
    f.high = f.touching == 0 ? s : std::max(f.high, s);
    ++f.touching;
    if (status == C2D_SLIP) ++f.slipping;
    if (status != C2D_STICK) continue;
    f.stick_low = f.sticking == 0 ? s : std::min(f.stick_low, s);
    f.stick_high = f.sticking == 0 ? s : std::max(f.stick_high, s);
    ++f.sticking;
  }
  return f;
}

std::string figure(double value, int digits) {
  std::string out;
  if (std::isinf(value)) return "infinite";
  append_general(out, value, 0, digits);
  return out;
}

std::string figure(double value, const std::string& unit, int digits) {
  return unit.empty() ? figure(value, digits) : figure(value, digits) + " " + unit;
}

} // namespace app
