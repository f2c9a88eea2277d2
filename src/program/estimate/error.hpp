// Errors of numbers from two meshes, the second with elements half as long (METHOD 16.5).
#pragma once

#include "post/stated.hpp"
#include "program/estimate/compare.hpp"

namespace estimate {

using app::kTractions;

// What a round leaves for the next one: its numbers, of each zone the distance of its tractions, where it ended: the loads on
// the way to which it did, and the work they did until then.
struct Round {
  std::vector<app::Stated> stated;
  std::vector<double> pressure, loads;
  double work = 0;
};

// What halved meshes say of a mesh: the numbers of its last state with their errors.
std::vector<app::Stated> state_of_coarse(const Trial& coarse, const Trial& halved, const Distance& between);

// The numbers of the last common state, of the finer mesh, with errors. `before`, the round before, may be null.
std::vector<app::Stated> state_numbers(const Trial& coarse, const Trial& halved, const Distance& between, const Round* before);

// The same of stresses and displacements that were wanted (wanted.hpp), whose values on the two meshes are `coarse` and `fine`.
// Those that the coarse mesh has not, where the history ended early, have none.
std::vector<app::Stated> state_wanted(const std::vector<app::Stated>& coarse, std::vector<app::Stated> fine,
                                      const Distance& between, const Round* before);

// Removes numbers without an error, unless they were asked for.
void drop_unknown(std::vector<app::Stated>& stated);

// Two numbers that happen to agree are no reason to end. Once tolerances are known: notes of each number whether it may count
// as met, as it may where it was so in the round before, too, or where what it changed since then says the same. While contact
// hangs on a few pairs, or the history ended early, none may.
void confirm(std::vector<app::Stated>& stated, const Trial& halved, const Round* before);

} // namespace estimate
