// Result of mesh refinement: its rounds, and numbers with their stated errors.
#pragma once

#include "post/tolerances.hpp"
#include "post/torsion/table.hpp"

#include <array>

namespace app {

// Where the elements of a curve begin and end, in their order; closed: round an outline, the first is the last.
struct MeshCurve {
  int32_t body = 1;
  bool closed = false;
  std::vector<std::array<double, 2>> ends;
};

// A mesh that was solved, beside the one with elements twice as long.
struct MeshRound {
  int32_t elements = 0, pairs = 0, equations = 0;
  double seconds = 0;
  double pressure = NAN;         // relative distance of the tractions from those on the mesh before, L1, of the worst contact
  double energy = NAN;           // the same of the energy
  bool adapted = false;          // the previous mesh was not this one with elements twice as long: no distance is defined
  std::vector<MeshCurve> curves; // of all bodies that have elements
  std::vector<Stated> stated;    // numbers with errors stated on this mesh; empty without a distance
};

// A fatigue parameter along curves: distances from the start of the first curve, one curve after another, and values.
struct FatigueLine {
  Measure what = Measure::kSwt;
  int32_t body = 1;
  std::string along; // the name of the first curve
  std::vector<std::array<double, 2>> points;
};

struct MeshLoop {
  std::vector<MeshRound> rounds;
  size_t taken = 0; // the round, from 0, with the mesh of the results
  std::vector<Stated> stated;
  int32_t positions = 0; // of moving loads, in a period; errors include the change from half as many; 0: no load moves
  std::string stopped;   // why it ended before all tolerances were met; empty: they are
  std::vector<FatigueLine> fatigue;
  TorsionTable torsion;      // loads round the axis; empty: there are none
  ToleranceTable tolerances; // of parameters; empty: none has one
  bool ran() const { return !rounds.empty(); }
  // Is a requested tolerance not met? Meshes of a deck are not adapted and have no tolerances.
  bool missed() const {
    for (const Stated& s : stated)
      if (!s.is_met()) return true;
    return stated.empty() && !stopped.empty() && ran() && rounds.front().adapted;
  }
  // In sentences; empty if nothing was asked for.
  std::string ending() const {
    std::string out = stopped.empty() ? std::string() : "It ended here: " + stopped;
    for (const Stated& s : stated)
      if (out.empty() && !std::isnan(s.tolerance)) out = "Every number that was asked for is as accurate as was asked";
    if (positions > 0 && !out.empty())
      out += ". The moving loads have " + std::to_string(positions) +
             " positions in a period, and errors include the change from " + std::to_string(positions / 2);
    return out;
  }
};

} // namespace app
