#include "interface/model/refuse.hpp"

#include "memory/parts.hpp"
#include "model/validate/validate.hpp"

namespace c2d {

void start_refusal(Refusal& r, c2d_solver* s, c2d_status status) {
  r.error = blank_error();
  r.error.status = status;
  r.error.severity = C2D_FAULT;
  r.error.line = s->model.line;
  r.error.column = s->model.column;
  r.error.column_end = s->model.column_end;
  r.text = text_in(r.error.text);
}
c2d_status refuse(c2d_solver* s, c2d_status status, const char* text) {
  Refusal r;
  start_refusal(r, s, status);
  put(r.text, text);
  report_fault(s, r.error);
  return status;
}
c2d_status refuse_integer(c2d_solver* s, c2d_status status, const char* what, int32_t value, int32_t first, int32_t last) {
  Refusal r;
  start_refusal(r, s, status);
  put_all(r.text, what, " is ", value, ", expected ", first);
  if (last == INT32_MAX)
    put(r.text, " or more");
  else if (last != first)
    put_all(r.text, " to ", last);
  report_fault(s, r.error);
  return status;
}
c2d_status refuse_part(c2d_solver* s, const char* what, const char* call) {
  Refusal r;
  start_refusal(r, s, C2D_ERR_ARGUMENT);
  put_all(r.text, what, kNeedsPart, call, " links it");
  report_fault(s, r.error);
  return C2D_ERR_ARGUMENT;
}
c2d_status refuse_limit(c2d_solver* s, const char* member, int64_t limit, int64_t needed) {
  return refuse_body_limit(s, 0, member, limit, needed);
}
c2d_status refuse_body_limit(c2d_solver* s, int32_t body, const char* member, int64_t limit, int64_t needed) {
  Refusal r;
  start_refusal(r, s, C2D_ERR_LIMIT);
  r.error.body = body;
  put(r.text, "c2d_limits.");
  if (body > 0) put_all(r.text, "body[", body - 1, "].");
  put_all(r.text, member, " is ", limit, ", expected ", needed, " or more");
  report_fault(s, r.error);
  return C2D_ERR_LIMIT;
}
c2d_status refuse_value(c2d_solver* s, const char* what, double value, const char* expected) {
  Refusal r;
  start_refusal(r, s, C2D_ERR_ARGUMENT);
  put_all(r.text, what, " is ", value, ", expected ", expected);
  report_fault(s, r.error);
  return C2D_ERR_ARGUMENT;
}

c2d_status check_each(c2d_solver* s, const Ranged* arguments, int32_t count) {
  for (const Ranged* a = arguments; a < arguments + count; ++a)
    if (a->value < a->first || a->value > a->last)
      return refuse_number(s, C2D_ERR_ARGUMENT, a->name, a->value, a->first, a->last);
  return C2D_OK;
}
c2d_status check_each(c2d_solver* s, const Pointed* arguments, int32_t count) {
  for (const Pointed* a = arguments; a < arguments + count; ++a) {
    if (a->pointer) continue;
    Refusal r;
    start_refusal(r, s, C2D_ERR_ARGUMENT);
    put_all(r.text, a->name, " is null");
    report_fault(s, r.error);
    return C2D_ERR_ARGUMENT;
  }
  return C2D_OK;
}
c2d_status check_each(c2d_solver* s, const Numbered* arguments, int32_t count) {
  for (const Numbered* a = arguments; a < arguments + count; ++a)
    if (!is_usable(a->value)) return refuse_value(s, a->name, a->value, "a finite number");
  return C2D_OK;
}

c2d_status check_array(c2d_solver* s, const char* name, const double* array, const char* stride_name, int64_t stride,
                       int64_t least, int32_t count) {
  if (count <= 0 || (array && stride >= least && stride <= longest_stride(count))) return C2D_OK;
  Refusal r;
  start_refusal(r, s, C2D_ERR_ARGUMENT);
  if (!array)
    put_all(r.text, name, " is null, and count is ", count);
  else
    put_all(r.text, stride_name, " is ", stride, stride < least ? ", expected at least " : ", expected at most ",
            stride < least ? least : longest_stride(count));
  report_fault(s, r.error);
  return C2D_ERR_ARGUMENT;
}

c2d_status enter_building(c2d_solver* s) { return enter(s, kBuilding); }
c2d_status built(c2d_solver* s) {
  s->state = C2D_STATE_BUILDING;
  return C2D_OK;
}

c2d_status enter_loads(c2d_solver* s) { return enter(s, kBuilding | state_bit(C2D_STATE_MODEL)); }
c2d_status loaded(c2d_solver* s) {
  if (s->state != C2D_STATE_MODEL) return built(s);
  s->loads_changed = 1;
  return C2D_OK;
}

c2d_status check_body_number(c2d_solver* s, int32_t body) {
  if (in_range(body, 1, s->sizes.bodies)) return C2D_OK;
  return refuse_number(s, C2D_ERR_ARGUMENT, "body number", body, 1, s->sizes.bodies);
}

c2d_status check_whole_body(c2d_solver* s, int32_t body) {
  const Body& b = body_numbered(s, body);
  if (b.is_set && b.region_count == b.regions) return C2D_OK;
  return refuse(s, C2D_ERR_ARGUMENT, "give the body and all its regions first");
}
c2d_status check_load_case(c2d_solver* s, int32_t load_case) {
  if (in_range(load_case, 1, s->sizes.load_cases)) return C2D_OK;
  return refuse_number(s, C2D_ERR_ARGUMENT, "load case", load_case, 1, s->sizes.load_cases);
}

} // namespace c2d
