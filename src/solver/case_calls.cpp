// What an end carries in a load case beyond the one its condition was given with.
#include "memory/text.hpp"
#include "model/unknowns.hpp"
#include "model/validate.hpp"
#include "solver/solver.hpp"

namespace c2d {

namespace {

constexpr const char* kQuantity[4] = {"tx", "ty", "ux", "uy"};

c2d_status refuse(c2d_solver* s, const char* what, const char* why) {
  c2d_error e = blank_error();
  e.status = C2D_ERR_ARGUMENT;
  e.severity = C2D_FAULT;
  e.line = s->model.line;
  e.column = s->model.column;
  e.column_end = s->model.column_end;
  Text text = text_in(e.text);
  put(text, what);
  put(text, why);
  report_fault(s, e);
  return C2D_ERR_ARGUMENT;
}

bool in_range(int64_t value, int64_t first, int64_t last) { return value >= first && value <= last; }

c2d_status check_place(c2d_solver* s, int32_t body, int32_t element, int32_t local, int32_t load_case) {
  if (!in_range(body, 1, s->sizes.bodies)) return refuse(s, "body number", ": there is no such body");
  const Body& b = s->model.body[body - 1];
  if (!b.is_set || b.region_count < b.regions)
    return refuse(s, "", "give the body and all its regions before the values of its load cases");
  if (!in_range(element, 1, b.elements)) return refuse(s, "element number", ": the body has no such element");
  if (!in_range(local, 0, s->sizes.function_nodes))
    return refuse(s, "local functional node", ": the element has no such node");
  if (!in_range(load_case, 1, s->sizes.load_cases)) return refuse(s, "load case", ": there is no such load case");
  return C2D_OK;
}

// A prescribed displacement that another card gave this node for this case.
bool contradicts(double known, double value) { return known != 0.0 && known != value; }

c2d_status check_end(c2d_solver* s, const Model& m, int b, int32_t element, int l, const double values[4],
                     int32_t load_case) {
  const int32_t end = element * m.head->function_nodes + l, node = functional_node(m, b, element, l);
  const bool contact = pair_of_end(m, b, element, l) >= 0;
  for (int q = 0; q < 4; ++q) {
    if (values[q] == 0.0) continue;
    if (!is_usable(values[q])) return refuse(s, kQuantity[q], " is not a usable number");
    if (q < 2 && contact) return refuse(s, kQuantity[q], " is a contact traction here, expected 0");
    if (q < 2 && !traction_known(m, b, end, q)) return refuse(s, kQuantity[q], " is unknown here, expected 0");
    if (q < 2) continue;
    if (!displacement_known(m, b, node, q - 2)) return refuse(s, kQuantity[q], " is unknown here, expected 0");
    const int64_t at = (static_cast<int64_t>(load_case) * m.head->body[b].nodes + node) * 2 + q - 2;
    if (contradicts(m.node_disp[b][at], values[q]))
      return refuse(s, kQuantity[q], " was given another value at this node in the same load case");
  }
  return C2D_OK;
}

void set_end(const Model& m, int b, int32_t element, int l, const double values[4], int32_t load_case) {
  const int64_t ends = static_cast<int64_t>(m.head->body[b].elements) * m.head->function_nodes;
  const int32_t end = element * m.head->function_nodes + l, node = functional_node(m, b, element, l);
  for (int c = 0; c < 2; ++c) {
    if (traction_known(m, b, end, c)) m.end_traction[b][(load_case * ends + end) * 2 + c] = values[c];
    if (displacement_known(m, b, node, c) && values[2 + c] != 0.0)
      m.node_disp[b][(static_cast<int64_t>(load_case) * m.head->body[b].nodes + node) * 2 + c] = values[2 + c];
  }
}

} // namespace
} // namespace c2d

using namespace c2d;

extern "C" c2d_status c2d_set_case_values(c2d_solver* s, int32_t body, int32_t element, int32_t local,
                                          const double values[4], int32_t load_case) {
  c2d_status status = enter(s, state_bit(C2D_STATE_BUILDING));
  if (status == C2D_OK) status = check_place(s, body, element, local, load_case);
  if (status != C2D_OK) return status;
  if (!values) return refuse(s, "", "no values given");
  const Model m = model_of(s);
  const int first = local == 0 ? 0 : local - 1, last = local == 0 ? m.head->function_nodes : local;
  for (int l = first; l < last; ++l) {
    status = check_end(s, m, body - 1, element - 1, l, values, load_case - 1);
    if (status != C2D_OK) return status;
  }
  for (int l = first; l < last; ++l) set_end(m, body - 1, element - 1, l, values, load_case - 1);
  return C2D_OK;
}
