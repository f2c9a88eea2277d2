// Given divisions of curves: the mesh that is taken where no tolerance is asked for.
#pragma once

#include "program/sketch/sketch.hpp"

namespace sketch {

// The division of a curve, null if no statement gives one; the last statement that names the curve counts.
const Division* division_of(const Sketch& sketch, int body, const Curve& curve);

// Lengths from the curve's begin at which its elements end, 0 and the whole length included. Throws a Fault where the
// stretches of the statement do not fit on the curve.
std::vector<double> divided_ends(const Division& division, double length);

} // namespace sketch
