// Errors of numbers from three meshes, each with elements half as long as the one before (METHOD 16.5).
#pragma once

#include "program/estimate/compare.hpp"
#include "report/stated.hpp"

namespace estimate {

// Rates at which distances fall from one halving to the next: 1/3 where all is smooth, more where edges lie amid elements.
constexpr double kLeastRate = 1.0 / 3, kMostRate = 0.5, kUsualRate = 0.45;

using app::kTractions;

// The error that is stated for a number whose values on three meshes, coarse to fine, are `before` and `last` apart; before
// 0: there are two meshes. `rate`: by which the distance of the tractions falls from one halving to the next; `floor`: the
// least that they are taken to be apart.
double stated_error(double before, double last, double rate, double floor);

// What halved meshes say of a mesh: the numbers of its last state with their errors.
std::vector<app::Stated> state_of_coarse(const Trial& coarse, const Trial& halved, const Distance& between);

// The numbers of the last common state, of the finest mesh, with errors. Two meshes: `coarse` may be null.
std::vector<app::Stated> state_numbers(const Trial* coarse, const Trial& middle, const Trial& fine, const Distance* before,
                                       const Distance& last);

} // namespace estimate
