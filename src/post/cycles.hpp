// What c2d_run has found of the cycle of a load path that it repeats until it is steady (contact2d_cycle.h).
#pragma once

#include "post/zone_line.hpp"

#include <contact2d_cycle.h>

#include <cstdint>
#include <vector>

namespace app {

// Of one zone over one cycle.
struct ZoneCycle {
  int32_t touched = 0, stuck = 0, slipped = 0;
  double walk = 0, slip_range = 0;
};

// One cycle, at its end.
struct CycleSeen {
  int32_t result = C2D_CYCLE_NOT_STEADY;
  int32_t cycles = 0, extrapolations = 0, stuck = 0, slipped = 0, range_pair = 0, walk_pair = 0;
  double change = 0, dissipated = 0, slip_range = 0, walk = 0, elastic = 0;
  std::vector<ZoneCycle> zones;
};

// The cycle followed last, of all zones; the elastic energy is left to the caller.
c2d_status find_cycle_seen(c2d_solver* solver, int32_t zones, CycleSeen& out);

// What of a zone is followed through the next cycle. Pairs from 0.
struct FollowedZone {
  int32_t pair = -1;            // that with the largest slip range over the last cycle; -1: none slips
  std::vector<int32_t> touched; // those that touched for some of it
};
c2d_status find_followed(c2d_solver* solver, const std::vector<ZoneLine>& lines, int32_t pairs, std::vector<FollowedZone>& out);

// The same for the numbers of a contact: which pairs stuck all the time. No zones: no cycle has been followed.
struct CycleResults {
  std::vector<ZoneCycle> zones;
  std::vector<double> stuck; // 1 or 0 of each pair
  double dissipated = 0;
  int32_t result = C2D_CYCLE_NOT_STEADY;
};
c2d_status find_cycle_results(c2d_solver* solver, int32_t zones, int32_t pairs, CycleResults& out);

// The cycle of the load path that c2d_run repeats.
struct RepeatedPaths {
  int32_t first = 0, pieces = 0, limit = 0, digits = 0, start = 0; // first: from 1; 0: none
};
RepeatedPaths repeated_paths(c2d_solver* solver);

// How many cycles the solver has followed; 0: none.
int32_t cycles_followed(c2d_solver* solver);

} // namespace app
