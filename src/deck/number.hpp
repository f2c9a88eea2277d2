#pragma once
// Numbers in fixed columns: the I and F fields of the card formats. No locale, no floating-point operation.
#include <stdint.h>

namespace c2d {

enum class FieldFault : int32_t {
  none,
  not_a_number,   // letters, two points, a sign alone, NaN, Inf ...
  not_an_integer, // a number, but with a point or an exponent, where an integer is expected
  blank_inside,   // a blank between digits
  too_large       // beyond the range of int32_t or double
};

// An I field: outer blanks are ignored, a wholly blank field is 0, a sign may lead. *value is set if `none` returns.
FieldFault integer_field(const char* text, int32_t width, int32_t* value);

// An F field, as FORTRAN reads F10.0: outer blanks are ignored, a wholly blank field is 0, the point may be
// missing (5 is 5.0), the exponent is E, D, e, d and digits, or a sign and digits (1.5+3). Correctly rounded
// (ties to even) for fields of up to 80 columns; what is smaller than the smallest normal number becomes 0.
// *value is set if `none` returns.
FieldFault real_field(const char* text, int32_t width, double* value);

// True if every column is blank.
bool is_blank(const char* text, int32_t width);

// The expected kind of value for a fault: "a number", "an integer" ...
const char* expectation(FieldFault fault, bool integer);

} // namespace c2d
