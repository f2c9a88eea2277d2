// c2d_set_condition: known and unknown quantities at an element end.
#include "interface/model/refuse.hpp"
#include "model/unknowns.hpp"
#include "model/validate/validate.hpp"

using namespace c2d;

namespace {

c2d_status check_condition(c2d_solver* s, int32_t body, int32_t element, int32_t local, int32_t load_case,
                           const int32_t codes[4], const double values[4]) {
  const c2d_status whole = check_whole_body(s, body);
  if (whole != C2D_OK) return whole;
  const int32_t elements = body_numbered(s, body).elements;
  if (!in_range(element, 1, elements)) return refuse_number(s, C2D_ERR_ARGUMENT, "element number", element, 1, elements);
  if (!in_range(local, 1, s->sizes.function_nodes))
    return refuse_number(s, C2D_ERR_ARGUMENT, "local functional node", local, 1, s->sizes.function_nodes);
  if (!in_range(load_case, 1, s->sizes.load_cases))
    return refuse_number(s, C2D_ERR_ARGUMENT, "load case", load_case, 1, s->sizes.load_cases);
  const c2d_status given = check_pointers(s, {{"codes", codes}, {"values", values}});
  if (given != C2D_OK) return given;
  constexpr const char* kNames[4] = {"tx", "ty", "ux", "uy"};
  for (int k = 0; k < 4; ++k) {
    if (!in_range(codes[k], 0, 1)) return refuse_number(s, C2D_ERR_ARGUMENT, "condition code", codes[k], 0, 1);
    if (codes[k] == 0 && !is_usable(values[k])) return refuse_value(s, kNames[k], values[k], "a finite number");
  }
  return C2D_OK;
}

// The other end at this node may prescribe a different displacement.
bool displacement_agrees(const Model& m, int b, int32_t node, int32_t end, int component, int32_t load_case, double value) {
  int32_t ends[2];
  const int count = ends_at_node(m, b, node, ends);
  for (int i = 0; i < count; ++i) {
    if (ends[i] == end) continue;
    if ((m.end_code[b][ends[i]] & (component == 0 ? kKnownUx : kKnownUy)) == 0) continue;
    const int64_t at = (static_cast<int64_t>(load_case) * m.body[b].nodes + node) * 2 + component;
    const double known = m.node_disp[b][at];
    if (load_case > 0 && known == 0.0) continue; // the other end set only its codes, no value in this case
    if (known != value) return false;
  }
  return true;
}

} // namespace

extern "C" c2d_status c2d_set_condition(c2d_solver* s, int32_t body, int32_t element, int32_t local, int32_t load_case,
                                        const int32_t codes[4], const double values[4]) {
  c2d_status status = enter_building(s);
  if (status == C2D_OK) status = check_body_number(s, body);
  if (status == C2D_OK) status = check_condition(s, body, element, local, load_case, codes, values);
  if (status != C2D_OK) return status;
  const Model m = model_of(s);
  const int b = body - 1;
  const int32_t end = (element - 1) * s->sizes.function_nodes + local - 1;
  const int32_t node = functional_node(m, b, element - 1, local - 1);
  for (int c = 0; c < 2; ++c)
    if (codes[2 + c] == 0 && !displacement_agrees(m, b, node, end, c, load_case - 1, values[2 + c]))
      return refuse(s, C2D_ERR_ARGUMENT,
                    c == 0 ? "the two ends at this node prescribe different x-displacements"
                           : "the two ends at this node prescribe different y-displacements");
  const int64_t ends = static_cast<int64_t>(m.body[b].elements) * s->sizes.function_nodes;
  uint8_t code = kGiven;
  for (int k = 0; k < 4; ++k)
    if (codes[k] == 0) code = static_cast<uint8_t>(code | (1 << k));
  m.end_code[b][end] = code;
  m.end_line[b][end] = s->model.line;
  for (int c = 0; c < 2; ++c) {
    m.end_traction[b][((load_case - 1) * ends + end) * 2 + c] = codes[c] == 0 ? values[c] : 0.0;
    if (codes[2 + c] == 0)
      m.node_disp[b][(static_cast<int64_t>(load_case - 1) * m.body[b].nodes + node) * 2 + c] = values[2 + c];
  }
  return built(s);
}
