// Result fields and lists.
#include <string.h>

#include "interface/model/refuse.hpp"
#include "memory/math.hpp"
#include "model/surface.hpp"
#include "model/symmetry.hpp"
#include "results/back.hpp"
#include "results/interior/interior.hpp"
#include "results/table.hpp"

namespace c2d {

namespace {

// Values of one field of `count` items, item i at base[i * step + offset].
struct Field {
  const double* base;
  int64_t step, offset, items;
};

c2d_status check_range(c2d_solver* s, int64_t items, int32_t first, int32_t count, const double* out, int64_t stride) {
  if (!in_range(first, 1, items + 1)) return refuse_number(s, C2D_ERR_ARGUMENT, "first", first, 1, items);
  if (!in_range(count, 0, items - first + 1)) return refuse_number(s, C2D_ERR_ARGUMENT, "count", count, 0, items - first + 1);
  return check_array(s, "out", out, "stride", stride, 1, count);
}

bool needs_results(int32_t field) {
  return (field >= C2D_STATUS && field <= C2D_SLIP_SUM) || (field >= C2D_END_UX && field <= C2D_END_TY) ||
         (field >= C2D_END_SXX && field <= C2D_END_PRINCIPAL2);
}

c2d_status get_pair_field(c2d_solver* s, int32_t field, int32_t first, int32_t count, double* out, int64_t stride) {
  c2d_status status = check_range(s, s->model.pairs, first, count, out, stride);
  if (status != C2D_OK) return status;
  if (needs_results(field) && !s->table_is_current) {
    Session session;
    open_session(s, session);
    status = fill_table(session);
    if (status != C2D_OK) return fail_store(s, status);
  } else if (!needs_results(field)) {
    fill_positions(model_of(s), array_of<double>(s, kPairTable));
  }
  const double* table = array_of<double>(s, kPairTable);
  for (int32_t i = 0; i < count; ++i) out[i * stride] = table[static_cast<int64_t>(first - 1 + i) * C2D_PAIR_FIELDS + field];
  return C2D_OK;
}

// Position of a pair on side 1: in matching zones its node, given by the first element that has it.
void place_on_side1(const Model& m, const Pair& pair, int32_t* element, double* eta) {
  *element = pair.element;
  *eta = pair.eta;
  if (pair.node[0] < 0) return;
  int32_t ends[2] = {0, 0}; // a pair node has one or two ends
  all_ends_at_node(m, body_on(m, pair, 0), pair.node[0], ends);
  const int32_t nf = m.head->function_nodes;
  *element = ends[0] / nf;
  *eta = nf > 1 ? -1.0 + 2.0 * (ends[0] % nf) / (nf - 1) : 0.0;
}

c2d_status get_pair_place(c2d_solver* s, int32_t field, int32_t first, int32_t count, double* out, int64_t stride) {
  const c2d_status status = check_range(s, s->model.pairs, first, count, out, stride);
  if (status != C2D_OK) return status;
  const Model m = model_of(s);
  for (int32_t i = 0; i < count; ++i) {
    int32_t element = 0;
    double eta = 0.0;
    place_on_side1(m, m.pair[first - 1 + i], &element, &eta);
    out[i * stride] = field == C2D_PAIR_ELEMENT1 ? element + 1 : eta;
  }
  return C2D_OK;
}

double end_value(const Session& session, int32_t field, int b, int32_t end) {
  const Model& m = session.model;
  const int32_t nf = m.head->function_nodes, element = end / nf, l = end % nf;
  const int32_t node = functional_node(m, b, element, l);
  double x, y, value[2];
  switch (field) {
  case C2D_END_X: node_position(m, b, node, &x, &y); return x;
  case C2D_END_Y: node_position(m, b, node, &x, &y); return y;
  case C2D_END_NODE: return node + 1;
  case C2D_END_STATUS: {
    const int32_t pair = pair_of_end(m, b, element, l).pair;
    if (pair < 0) return -1;
    const double* row = array_of<double>(session.solver, kPairTable) + static_cast<int64_t>(pair) * C2D_PAIR_FIELDS;
    return row[C2D_STATUS];
  }
  case C2D_END_UX:
  case C2D_END_UY: get_displacement(session, b, node, value); return value[field - C2D_END_UX];
  case C2D_END_TX:
  case C2D_END_TY: get_traction(session, b, end, value); return value[field - C2D_END_TX];
  default: // elements replaced by images have no results
    return is_axis_element(m, b, element) ? 0.0 : end_stress(session, field, b, end);
  }
}

c2d_status get_end_field(c2d_solver* s, int32_t field, int b, int32_t first, int32_t count, double* out, int64_t stride) {
  const int64_t ends = static_cast<int64_t>(body_numbered(s, b + 1).elements) * s->model.function_nodes;
  c2d_status status = check_range(s, ends, first, count, out, stride);
  if (status != C2D_OK) return status;
  Session session;
  open_session(s, session);
  if (needs_results(field) || field == C2D_END_STATUS) {
    if (s->state != C2D_STATE_RUNNING) return fail(s, C2D_ERR_STATE, "there are no results before c2d_begin");
    if (s->blocked || s->floating) {
      for (int32_t i = 0; i < count; ++i) out[i * stride] = field == C2D_END_STATUS ? -1.0 : 0.0;
      return C2D_OK;
    }
    if (!s->table_is_current) status = fill_table(session);
    if (status == C2D_OK && field != C2D_END_STATUS) status = back_substitute_all(session);
    if (status != C2D_OK) return fail_store(s, status);
  }
  for (int32_t i = 0; i < count; ++i) out[i * stride] = end_value(session, field, b, first - 1 + i);
  return C2D_OK;
}

c2d_status get_node_field(c2d_solver* s, int32_t field, int b, int32_t first, int32_t count, double* out, int64_t stride) {
  const c2d_status status = check_range(s, body_numbered(s, b + 1).geometry_nodes, first, count, out, stride);
  if (status != C2D_OK) return status;
  const double* xy = model_of(s).xy[b];
  for (int32_t i = 0; i < count; ++i) out[i * stride] = xy[2 * static_cast<int64_t>(first - 1 + i) + (field - C2D_NODE_X)];
  return C2D_OK;
}

c2d_status get_surface_field(c2d_solver* s, int32_t field, int b, int32_t first, int32_t count, double* out, int64_t stride) {
  const c2d_status status = check_range(s, body_numbered(s, b + 1).elements, first, count, out, stride);
  if (status != C2D_OK) return status;
  const Model m = model_of(s);
  for (int32_t i = 0; i < count; ++i) {
    const SurfacePoint p = surface_point(m, b, first - 1 + i, 0.0);
    out[i * stride] = field == C2D_SURFACE_X ? p.x : p.y;
  }
  return C2D_OK;
}

} // namespace
} // namespace c2d

using namespace c2d;

extern "C" c2d_status c2d_get(c2d_solver* s, int32_t field, int32_t body, int32_t first, int32_t count, double* out,
                              int64_t stride) {
  const InsideStep inside(s);
  const bool pairs = field >= 0 && field < C2D_PAIR_FIELDS;
  const bool ends = field >= C2D_END_X && field <= C2D_END_PRINCIPAL2, nodes = field == C2D_NODE_X || field == C2D_NODE_Y;
  c2d_status status = enter(s, needs_results(field) ? state_bit(C2D_STATE_RUNNING) : kComplete);
  if (status != C2D_OK) return status;
  const bool places = field == C2D_PAIR_ELEMENT1 || field == C2D_PAIR_ETA1;
  const bool surfaces = field == C2D_SURFACE_X || field == C2D_SURFACE_Y;
  if (!pairs && !ends && !nodes && !places && !surfaces) return refuse(s, C2D_ERR_ARGUMENT, "there is no such field");
  if (pairs) return get_pair_field(s, field, first, count, out, stride);
  if (places) return get_pair_place(s, field, first, count, out, stride);
  status = check_ranges(s, {{"body", body, 1, s->model.bodies}});
  if (status != C2D_OK) return status;
  if (ends) return get_end_field(s, field, body - 1, first, count, out, stride);
  if (surfaces) return get_surface_field(s, field, body - 1, first, count, out, stride);
  return get_node_field(s, field, body - 1, first, count, out, stride);
}

extern "C" c2d_status c2d_get_friction(c2d_solver* s, int32_t zone, int32_t i, double* mu) {
  c2d_status status = enter(s, kComplete);
  if (status == C2D_OK) status = check_ranges(s, {{"zone", zone, 0, s->model.zones}, {"i", i, 1, s->model.coefficients}});
  if (status == C2D_OK) status = check_pointers(s, {{"mu", mu}});
  if (status != C2D_OK) return status;
  *mu = zone == 0 ? array_of<double>(s, kFriction)[i - 1] : coefficient_of_zone(s, zone - 1, i - 1);
  return C2D_OK;
}

extern "C" c2d_status c2d_get_path(c2d_solver* s, int32_t i, int32_t* increments, double* load, int32_t cases) {
  c2d_status status = enter(s, kComplete);
  if (status == C2D_OK)
    status = check_ranges(s, {{"i", i, 1, s->model.paths}, {"cases", cases, s->model.load_cases, s->model.load_cases}});
  if (status == C2D_OK) status = check_pointers(s, {{"increments", increments}, {"load", load}});
  if (status != C2D_OK) return status;
  *increments = array_of<Path>(s, kPaths)[i - 1].increments;
  for (int32_t k = 0; k < cases; ++k) load[k] = array_of<double>(s, kPathLoads)[static_cast<int64_t>(i - 1) * cases + k];
  return C2D_OK;
}

extern "C" c2d_status c2d_get_zone(c2d_solver* s, int32_t i, c2d_zone* out) {
  c2d_status status = enter(s, kComplete);
  if (status == C2D_OK) status = check_ranges(s, {{"i", i, 1, s->model.zones}});
  if (status != C2D_OK) return status;
  const Model m = model_of(s);
  const Zone& zone = m.zone[i - 1];
  c2d_zone ours;
  memset(&ours, 0, sizeof ours);
  ours.kind = (zone.is_free != 0 ? C2D_ZONE_FREE : C2D_ZONE_MATCHING) + (zone.is_tied != 0 ? C2D_ZONE_TIED : 0) +
              (zone.is_self != 0 ? C2D_ZONE_SELF : 0);
  ours.pairs = zone.pairs;
  for (int k = 0; k < 2; ++k) {
    c2d_side& side = k == 0 ? ours.side1 : ours.side2;
    side.body = zone.body[k] + 1;
    side.elements = zone_elements(zone, k);
    side.first_element = zone.first_element[k] + 1;
    side.last_element = zone_element(m, zone, k, side.elements - 1) + 1;
    if (zone.is_free != 0 && k == 0) continue;
    side.first_node = zone.first_node[k] + 1;
    side.last_node = zone_node(m, zone, k, zone.pairs - 1) + 1;
  }
  return give(s, "c2d_zone", ours, out);
}

extern "C" c2d_status c2d_get_region(c2d_solver* s, int32_t body, int32_t i, int32_t* first, int32_t* last) {
  c2d_status status = enter(s, kComplete);
  if (status == C2D_OK) status = check_ranges(s, {{"body", body, 1, s->model.bodies}});
  if (status == C2D_OK) status = check_ranges(s, {{"i", i, 1, body_numbered(s, body).regions}});
  if (status == C2D_OK) status = check_pointers(s, {{"first_element", first}, {"last_element", last}});
  if (status != C2D_OK) return status;
  const Region& region = model_of(s).region[body - 1][i - 1];
  *first = region.first + 1;
  *last = region.last + 1;
  return C2D_OK;
}
