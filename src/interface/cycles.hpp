#pragma once
// Shared by c2d_cycle and by c2d_run of a load path with a cycle.
#include "solver/cycle.hpp"

namespace c2d {

constexpr int32_t kCyclesByDefault = 50;
constexpr double kChangeByDefault = 1e-10; // over a steady cycle

struct CyclePlan {
  const double* load; // [corners * cases]
  int32_t corners, cases;
  int32_t closing_case; // the load case, from 1, that closes overlaps and stays at 1; 0: none
  CycleRule rule;
};
// One cycle from the load reached. If the path ends within it, the solver's outcome says why.
c2d_status follow_cycle(Session& session, const CyclePlan& plan);
// Is another cycle needed, and allowed by the limit?
bool goes_on(const Session& session, int32_t limit);
// What the cycles have come to so far.
void describe_cycles(c2d_solver* solver, c2d_cycle_state& out);

// Load factors that are the same but for round-off.
bool are_alike(const double* a, const double* b, int32_t cases);

} // namespace c2d
