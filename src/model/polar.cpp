// Points on lines and arcs for generated nodes, with exact symmetry.
//
// Meshes of circles should be exactly symmetric: otherwise mirrored nodes differ in the last digit and results of a symmetric
// model become unsymmetric. So sine and cosine are evaluated in the first octant only, with exact values at 0, 30, 45 and 90
// degrees, and reflected into the others. fmod and the subtractions of multiples of 90 degrees are exact in floating point.
#include "model/polar.hpp"

#include "memory/math.hpp"

namespace c2d {
namespace {

// 0 <= degrees <= 45. Here cosine and sine of the library are accurate, and a common value at 45 degrees keeps the diagonal
// exact.
void first_octant(double degrees, double* cosine, double* sine) {
  constexpr double kRadians = 3.14159265358979323846 / 180.0;
  constexpr double kHalfRoot = 0.70710678118654752440;
  *cosine = degrees == 45.0 ? kHalfRoot : cos(degrees * kRadians);
  *sine = degrees == 45.0 ? kHalfRoot : degrees == 30.0 ? 0.5 : sin(degrees * kRadians);
}

} // namespace

void cosine_and_sine(double degrees, double* cosine, double* sine) {
  double angle = fmod(degrees, 360.0); // exact, as are the subtractions below
  if (angle < 0.0) angle += 360.0;
  const int32_t quadrant = static_cast<int32_t>(angle / 90.0);
  angle -= 90.0 * quadrant;
  double c, s;
  if (angle <= 45.0)
    first_octant(angle, &c, &s);
  else
    first_octant(90.0 - angle, &s, &c);
  switch (quadrant % 4) {
  case 0: *cosine = c, *sine = s; break;
  case 1: *cosine = -s, *sine = c; break;
  case 2: *cosine = -c, *sine = -s; break;
  default: *cosine = s, *sine = -c; break;
  }
}

namespace {

// Point i of a uniform division. The last one is `to` itself, without round-off, so that neighbouring curves meet exactly.
double between(double from, double to, int32_t i, int32_t steps) {
  return i == steps ? to : from + (to - from) * i / static_cast<double>(steps);
}

} // namespace

void point_on_line(const double from[2], const double to[2], int32_t i, int32_t steps, double point[2]) {
  for (int c = 0; c < 2; ++c) point[c] = between(from[c], to[c], i, steps);
}

void point_on_arc(double radius, double from, double to, int32_t i, int32_t steps, double point[2]) {
  double cosine, sine;
  cosine_and_sine(between(from, to, i, steps), &cosine, &sine);
  point[0] = radius * cosine;
  point[1] = radius * sine;
}

} // namespace c2d
