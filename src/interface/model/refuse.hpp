#pragma once
// Refused model calls: reported like faults of a deck, with the position set by c2d_set_line.
#include "interface/entry.hpp"
#include "memory/text.hpp"

namespace c2d {

struct Refusal {
  c2d_error error;
  Text text;
};
void start_refusal(Refusal& r, c2d_solver* solver, c2d_status status);
// Each reports the fault and returns its status. Message: "what is VALUE, expected FIRST to LAST".
c2d_status refuse(c2d_solver* solver, c2d_status status, const char* text);
c2d_status refuse_integer(c2d_solver* solver, c2d_status status, const char* what, int32_t value, int32_t first, int32_t last);
c2d_status refuse_part(c2d_solver* solver, const char* what, const char* call);                 // which links the part
c2d_status refuse_limit(c2d_solver* solver, const char* member, int64_t limit, int64_t needed); // of c2d_limits
c2d_status refuse_body_limit(c2d_solver* solver, int32_t body, const char* member, int64_t limit, int64_t needed);
c2d_status refuse_value(c2d_solver* solver, const char* what, double value, const char* expected);

// Check arguments in order and refuse the first invalid one by its name: integers out of range, null pointers, numbers that are
// not finite.
struct Ranged {
  const char* name;
  int64_t value, first, last;
};
struct Pointed {
  const char* name;
  const void* pointer;
};
struct Numbered {
  const char* name;
  double value;
};
c2d_status check_each(c2d_solver* solver, const Ranged* arguments, int32_t count);
c2d_status check_each(c2d_solver* solver, const Pointed* arguments, int32_t count);
c2d_status check_each(c2d_solver* solver, const Numbered* arguments, int32_t count);
template <int32_t N> c2d_status check_ranges(c2d_solver* s, const Ranged (&arguments)[N]) {
  return check_each(s, arguments, N);
}
template <int32_t N> c2d_status check_pointers(c2d_solver* s, const Pointed (&arguments)[N]) {
  return check_each(s, arguments, N);
}
template <int32_t N> c2d_status check_numbers(c2d_solver* s, const Numbered (&arguments)[N]) {
  return check_each(s, arguments, N);
}

// A caller's array with `count` entries at distances of `stride` numbers: refuses null, and a stride that is
// less than `least` or leaves the address space.
c2d_status check_array(c2d_solver* solver, const char* name, const double* array, const char* stride_name, int64_t stride,
                       int64_t least, int32_t count);
inline int64_t longest_stride(int32_t count) {
  return PTRDIFF_MAX / static_cast<ptrdiff_t>(sizeof(double)) / count - C2D_POINT_FIELDS; // no 64-bit division
}

// The calls of section 5: legal in empty and building; `built`: something was changed.
constexpr uint32_t kBuilding = state_bit(C2D_STATE_EMPTY) | state_bit(C2D_STATE_BUILDING);
c2d_status enter_building(c2d_solver* solver);
c2d_status built(c2d_solver* solver);
// Loads may also be changed in state model, which stays complete.
c2d_status enter_loads(c2d_solver* solver);
c2d_status loaded(c2d_solver* solver);
c2d_status check_body_number(c2d_solver* solver, int32_t body); // 1 ... bodies
c2d_status check_whole_body(c2d_solver* solver, int32_t body);  // given, with all its regions
c2d_status check_load_case(c2d_solver* solver, int32_t load_case);
// A load card of the deck: a path segment that ends at `load` in case 1 and at zero in all others.
c2d_status add_load_card(c2d_solver* solver, int32_t increments, double load); // load_calls.cpp
// A part of the factors of a path segment: the first part adds the segment, the last one checks that there is one per load
// case.
c2d_status add_factors(c2d_solver* solver, int32_t increments, int32_t given, const double* load, int32_t count, bool last);

// Numbers and limits of the interface have 32 bits, whatever type stores them (interface/create.cpp).
template <class Value, class First, class Last>
inline c2d_status refuse_number(c2d_solver* solver, c2d_status status, const char* what, Value value, First first, Last last) {
  return refuse_integer(solver, status, what, static_cast<int32_t>(value), static_cast<int32_t>(first),
                        static_cast<int32_t>(last));
}
template <class First, class Last> inline bool in_range(int32_t value, First first, Last last) {
  return value >= static_cast<int32_t>(first) && value <= static_cast<int32_t>(last);
}

} // namespace c2d
