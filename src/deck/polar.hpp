#pragma once
// Sine and cosine of an angle in degrees, exact at multiples of 30 and 45 degrees where the values are
// representable, and with the symmetries of the circle exactly kept: a quarter arc is a mirror image of
// itself.

namespace c2d {

// Any finite angle.
void cosine_and_sine(double degrees, double* cosine, double* sine);

} // namespace c2d
