// Derivatives of the wanted numbers of a sketch by its parameters with tolerances, on the final mesh.
#pragma once

#include "post/tolerances.hpp"
#include "program/estimate/trial.hpp"
#include "program/estimate/trial_keeper.hpp"
#include "program/sketch/mesh.hpp"
#include "program/sketch/read/read.hpp"

#include <functional>

namespace estimate {

// Reads the sketch with these values of parameters in place of its own.
using Redraw = std::function<sketch::Reading(const sketch::Parameters& changed)>;

// The sketch with the nominal values of its parameters, its final mesh, and the solution there.
struct Nominal {
  const sketch::Sketch& sketch; // the mesh refers to it
  const sketch::Mesh& mesh;
  const Trial& trial;
};

// The change of a parameter in the first differences: its tolerance, within bounds by its value.
double first_step(const sketch::Tolerance& tolerance);

// All numbers of the last state of a solution, without errors.
std::vector<app::Stated> numbers_of(const Nominal& at);

// The same for changed values of parameters, on the same divisions. Throws a sketch::Fault, without a place, if the sketch
// cannot be drawn, divided or solved in the same way.
std::vector<app::Stated> numbers_with(const Nominal& at, const sketch::Parameters& changed, const Redraw& redraw,
                                      const Demand& demand);

// `stated`: the numbers of the solution with their errors, if there are any; those with a tolerance are wanted. `keeper`: as of
// adapt().
app::ToleranceTable tolerances_of(const Nominal& at, const std::vector<app::Stated>& stated, const Redraw& redraw,
                                  const Demand& demand, TrialKeeper* keeper);

} // namespace estimate
