// Errors of numbers from three meshes, each with elements half as long as the one before (METHOD 19).
#pragma once

#include "program/estimate/compare.hpp"
#include "report/stated.hpp"

namespace estimate {

// Three values of a number, coarse to fine, and the error that is stated for the last. `rate`: by which the distance of the
// solution itself falls from one halving to the next.
double stated_error(double coarse, double middle, double fine, double rate);

// The numbers of the last common state, of the finest mesh, with errors. Two meshes: `coarse` may be null.
std::vector<app::Stated> state_numbers(const Trial* coarse, const Trial& middle, const Trial& fine, const Distance* before,
                                       const Distance& last);

} // namespace estimate
