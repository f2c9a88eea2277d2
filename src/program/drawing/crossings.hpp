// Crossings of curves.
#pragma once

#include "program/drawing/drawing.hpp"

namespace drawing {

struct Crossing {
  size_t first, second; // curves; one and the same where it crosses itself
  Point at;
};

// Points where curves pass through each other, further than `tolerance` from their ends. Curves that touch do not cross, nor do
// those that overlap by less than some 1e-5 of their radius.
std::vector<Crossing> crossings_of(const std::vector<Curve>& curves, double tolerance);

} // namespace drawing
