// Stated errors of numbers from two meshes, the second with bisected elements (METHOD 16.5).
#pragma once

#include "post/stated.hpp"
#include "program/estimate/compare.hpp"

#include <cmath>

namespace estimate {

bool is_same_number(const app::Stated& a, const app::Stated& b);
// The n-th number, from 0, that is the same as `s`; null: there are fewer.
const app::Stated* find_number(const std::vector<app::Stated>& all, const app::Stated& s, size_t n);

// Difference of two values of a number, app::Quantity or app::Stated. Places are compared by position, because lengths may
// start at different pairs.
template <class Number> double apart(const Number& a, const Number& b) {
  const bool is_at_place = app::row_of(a.what).scale == app::Scale::kPlace;
  return is_at_place ? std::hypot(a.at[0] - b.at[0], a.at[1] - b.at[1]) : std::fabs(a.value - b.value);
}

// Data of a round for the next one: its numbers, the distance of the tractions of each zone, and the loads and the work at the
// end of the history.
struct Round {
  std::vector<app::Stated> stated;
  std::vector<double> pressure, loads;
  double work = 0;
};

// The numbers of the last state of the coarse mesh with errors, from a comparison with the bisected mesh.
std::vector<app::Stated> state_of_coarse(const Trial& coarse, const Trial& halved, const Distance& between);

// The numbers of the last common state on the finer mesh, with errors. `before`: the previous round, or null.
std::vector<app::Stated> state_numbers(const Trial& coarse, const Trial& halved, const Distance& between, const Round* before);

// The same for requested stresses and displacements (wanted.hpp) with the values `coarse` and `fine` on the two meshes. Values
// missing on the coarse mesh, because its history ended early, get no error.
std::vector<app::Stated> state_wanted(const std::vector<app::Stated>& coarse, std::vector<app::Stated> fine,
                                      const Distance& between, const Round* before);

// Removes numbers without an error unless they were requested.
void drop_unknown(std::vector<app::Stated>& stated);

// Guards against accidental agreement of two meshes; needs the tolerances. A number is confirmed if it was also met in the
// previous round, or if its change since then gives an error below the tolerance. No number is confirmed while few pairs touch
// or the history ends early.
void confirm(std::vector<app::Stated>& stated, const Trial& halved, const Round* before);

} // namespace estimate
