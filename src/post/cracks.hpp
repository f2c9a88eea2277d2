// Cracks: the faces of a contact zone end at a tie of the same two bodies, or, of one body, at each other. Data
// of a tip before the solution, and its stress intensity from the displacements of the faces (METHOD 10.7).
#pragma once

#include "post/summary.hpp"

#include <contact2d.h>

#include <cstdint>
#include <string>
#include <vector>

namespace app {

struct CrackTip {
  int32_t zone = 0; // of the faces, from 1
  double at[2] = {0, 0};
  double element = 0; // length of the one at the tip
  double modulus = 0; // E / (1 - nu^2) in plane strain, E in plane stress
  std::string why;    // reason why there is no stress intensity; else empty
  struct Pair {
    int32_t pair; // from 0
    double distance;
  };
  std::vector<Pair> faces; // all pairs of the zone, by their distance from the tip
};

// All tips of a complete model, in the order of the zones.
c2d_status find_crack_tips(c2d_solver* solver, const Summary& summary, std::vector<CrackTip>& out);

// NaN where there is none, as `why` says. K1 > 0 opens; K2 > 0 if the face on the left, seen from the faces towards the tip,
// moves towards it against the other one.
struct StressIntensity {
  int32_t zone = 0;
  double at[2] = {0, 0};
  double K1 = 0, K2 = 0;
  std::string why;
};
// From a table of the pairs, of any recorded step.
StressIntensity stress_intensity(const CrackTip& tip, const double* table, int64_t stride);

} // namespace app
