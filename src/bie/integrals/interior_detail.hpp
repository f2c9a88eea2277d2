#pragma once
// The two methods by which interior.cpp evaluates an element.
#include "bie/integrals/interior.hpp"

namespace c2d {

// Closed forms on a straight element whose measure is constant.
void add_field_straight(const FieldElement& e, Complex reference, double x, double y, PointField& sum);

} // namespace c2d
