#pragma once
// Sine and cosine of an angle in degrees, exact at multiples of 30 and 45 degrees where the values are representable, and with
// the symmetries of the circle exactly kept: a quarter arc is a mirror image of itself.

#include <stdint.h>

namespace c2d {

// Any finite angle.
void cosine_and_sine(double degrees, double* cosine, double* sine);

// Point i of 0 ... steps at equal distances, about the origin: along the line from `from` to `to`, and along an arc
// between two angles in degrees. 0 and `steps` are the ends to the last bit.
void point_on_line(const double from[2], const double to[2], int32_t i, int32_t steps, double point[2]);
void point_on_arc(double radius, double from, double to, int32_t i, int32_t steps, double point[2]);

} // namespace c2d
