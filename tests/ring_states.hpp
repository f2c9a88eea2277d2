// What tests of bodies of revolution compare: displacements and stresses at a place of the half section.
#pragma once

#include "callable.hpp"
#include "memory/config.hpp"

namespace ring_states {

constexpr double kPi = 3.14159265358979323846;
constexpr auto kNoRings = !c2d::kRings; // small code without them: the tests are skipped

struct State {
  double ur, uz, srr, szz, srz, hoop;
};
using Field = test::Callable<State(double r, double z)>;

} // namespace ring_states
