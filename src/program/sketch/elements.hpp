// Divisions of curves given by statements: the mesh used without a tolerance.
#pragma once

#include "program/sketch/sketch.hpp"

namespace sketch {

// The division of a curve; null if no statement gives one. The last statement that names the curve counts.
const Division* division_of(const Sketch& sketch, int body, const Curve& curve);

// Lengths from the start of the curve where its elements end, including 0 and the total length. Throws a Fault if the stretches
// of the statement do not fit on the curve.
std::vector<double> divided_ends(const Division& division, double length);

} // namespace sketch
