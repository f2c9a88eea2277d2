#include "program/sketch/deck/cycle.hpp"

#include "program/sketch/moving.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {

int cycle_start(const Sketch& sketch) {
  constexpr double kSameFactor = 1e-9;
  if (sketch.cycle && !has_moving_loads(sketch)) return sketch.cycle->before;
  if (has_moving_loads(sketch)) return cycle_start(with_positions(sketch));
  double largest = 0;
  for (const LoadCase& c : sketch.cases)
    for (const double factor : c.factors) largest = std::max(largest, std::fabs(factor));
  const auto is_as_at_end = [&](int piece) {
    return std::all_of(sketch.cases.begin(), sketch.cases.end(), [&](const LoadCase& c) {
      return std::fabs(c.factors[static_cast<size_t>(piece) - 1] - c.factors.back()) <= kSameFactor * largest;
    });
  };
  int piece = sketch.pieces;
  while (piece > 0 && is_as_at_end(piece)) --piece;
  while (piece > 0 && !is_as_at_end(piece)) --piece;
  return piece;
}

} // namespace sketch
