// Errors of numbers from two meshes, the second with elements half as long (METHOD 16.5).
#pragma once

#include "program/estimate/compare.hpp"
#include "report/stated.hpp"

namespace estimate {

using app::kTractions;

// The error that is stated for a number whose values on the two meshes are `apart`; `floor`: the least that they are taken to
// be apart.
double stated_error(double apart, double floor);

// What halved meshes say of a mesh: the numbers of its last state with their errors.
std::vector<app::Stated> state_of_coarse(const Trial& coarse, const Trial& halved, const Distance& between);

// The numbers of the last common state, of the finer mesh, with errors. `earlier`, which may be null: a coarser mesh than that.
std::vector<app::Stated> state_numbers(const Trial& coarse, const Trial& halved, const Distance& between, const Trial* earlier);

} // namespace estimate
