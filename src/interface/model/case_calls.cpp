// Prescribed values of element ends in load cases, new or replacing earlier ones.
#include "interface/model/refuse.hpp"
#include "model/symmetry.hpp"
#include "model/unknowns.hpp"
#include "model/validate/validate_finding.hpp"

namespace c2d {

namespace {

constexpr const char* kQuantity[4] = {"tx", "ty", "ux", "uy"};

c2d_status refuse(c2d_solver* s, const char* what, const char* why) {
  Refusal r;
  start_refusal(r, s, C2D_ERR_ARGUMENT);
  put_all(r.text, what, why);
  report_fault(s, r.error);
  return C2D_ERR_ARGUMENT;
}

c2d_status check_place(c2d_solver* s, int32_t body, int32_t element, int32_t local, int32_t load_case) {
  c2d_status status = check_body_number(s, body);
  if (status == C2D_OK) status = check_whole_body(s, body);
  if (status != C2D_OK) return status;
  status = check_ranges(s, {{"element number", element, 1, body_numbered(s, body).elements},
                            {"local functional node", local, 0, s->sizes.function_nodes}});
  return status == C2D_OK ? check_load_case(s, load_case) : status;
}

// A displacement already prescribed at this node in this load case.
bool contradicts(double known, double value) { return known != 0.0 && known != value; }

// Replacing values cannot contradict others, but displacements fixed by symmetry or contact cannot be set.
c2d_status check_held(c2d_solver* s, const Model& m, int b, int32_t element, int32_t node, int q) {
  if (is_rigid(m, b)) {
    char why[96];
    Text text = text_in(why);
    put_all(text, " belongs to the rigid body ", body_named(m, b), ", expected 0");
    return refuse(s, kQuantity[q], why);
  }
  if (!is_integrated(m, b, element))
    return refuse(s, kQuantity[q], " is on an element without length or on a line of symmetry, expected 0");
  if (q < 2) return C2D_OK;
  if (is_held_by_symmetry(m, b, node, q - 2)) return refuse(s, kQuantity[q], " is fixed by symmetry here, expected 0");
  if (pair_of_node(m, b, node).pair >= 0) return refuse(s, kQuantity[q], " belongs to a contact node, expected 0");
  return C2D_OK;
}

c2d_status check_end(c2d_solver* s, const Model& m, int b, int32_t element, int l, const double values[4], int32_t load_case,
                     bool replaces) {
  const int32_t end = element * m.head->function_nodes + l, node = functional_node(m, b, element, l);
  const bool contact = pair_of_end(m, b, element, l).pair >= 0;
  for (int q = 0; q < 4; ++q) {
    if (values[q] == 0.0) continue;
    if (!is_usable(values[q])) return refuse_value(s, kQuantity[q], values[q], "a finite number");
    if (q < 2 && contact) return refuse(s, kQuantity[q], " is a contact traction here, expected 0");
    if (q < 2 && !traction_known(m, b, end, q)) return refuse(s, kQuantity[q], " is unknown here, expected 0");
    c2d_status fixed = C2D_OK;
    if (replaces) fixed = check_held(s, m, b, element, node, q);
    if (fixed != C2D_OK) return fixed;
    if (q < 2) continue;
    if (!displacement_known(m, b, node, q - 2)) return refuse(s, kQuantity[q], " is unknown here, expected 0");
    const int64_t at = (static_cast<int64_t>(load_case) * m.body[b].nodes + node) * 2 + q - 2;
    if (!replaces && contradicts(m.node_disp[b][at], values[q]))
      return refuse(s, kQuantity[q], " was given another value at this node in the same load case");
  }
  return C2D_OK;
}

void set_end(const Model& m, int b, int32_t element, int l, const double values[4], int32_t load_case, bool replaces) {
  const int64_t ends = static_cast<int64_t>(m.body[b].elements) * m.head->function_nodes;
  const int32_t end = element * m.head->function_nodes + l, node = functional_node(m, b, element, l);
  for (int c = 0; c < 2; ++c) {
    if (traction_known(m, b, end, c)) m.end_traction[b][(load_case * ends + end) * 2 + c] = values[c];
    if (displacement_known(m, b, node, c) && (replaces || values[2 + c] != 0.0))
      m.node_disp[b][(static_cast<int64_t>(load_case) * m.body[b].nodes + node) * 2 + c] = values[2 + c];
  }
}

// Not part of c2d_set_values: its frame would add to that of enter.
[[gnu::noinline]] c2d_status set_values(c2d_solver* s, int32_t body, int32_t element, int32_t local, int32_t load_case,
                                        const double values[4]) {
  c2d_status status = check_place(s, body, element, local, load_case);
  if (status != C2D_OK) return status;
  if (!values) return refuse(s, "", "no values given");
  const Model m = model_of(s);
  const bool replaces = s->state == C2D_STATE_MODEL;
  const int first = local == 0 ? 0 : local - 1, last = local == 0 ? m.head->function_nodes : local;
  for (int l = first; l < last; ++l) {
    status = check_end(s, m, body - 1, element - 1, l, values, load_case - 1, replaces);
    if (status != C2D_OK) return status;
  }
  for (int l = first; l < last; ++l) set_end(m, body - 1, element - 1, l, values, load_case - 1, replaces);
  return C2D_OK;
}

} // namespace
} // namespace c2d

using namespace c2d;

extern "C" c2d_status c2d_set_values(c2d_solver* s, int32_t body, int32_t element, int32_t local, int32_t load_case,
                                     const double values[4]) {
  c2d_status status = enter(s, state_bit(C2D_STATE_BUILDING) | state_bit(C2D_STATE_MODEL));
  if (status == C2D_OK) status = set_values(s, body, element, local, load_case, values);
  return status == C2D_OK ? loaded(s) : status;
}

extern "C" c2d_status c2d_replace_point_load(c2d_solver* s, int32_t i, double x, double y, double fx, double fy) {
  c2d_status status = enter(s, state_bit(C2D_STATE_MODEL));
  if (status != C2D_OK) return status;
  if (!in_range(i, 1, s->model.point_loads))
    return refuse_number(s, C2D_ERR_ARGUMENT, "number of the point load", i, 1, s->model.point_loads);
  status = check_numbers(s, {{"x", x}, {"y", y}, {"fx", fx}, {"fy", fy}});
  if (status != C2D_OK) return status;
  PointLoad& load = array_of<PointLoad>(s, kPointLoads)[i - 1];
  load.x = x, load.y = y, load.fx = fx, load.fy = fy;
  s->loads_changed = 1;
  return C2D_OK;
}
