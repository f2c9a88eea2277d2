// A model solved along its whole history on one mesh, with the data for the comparison with another mesh.
#pragma once

#include "post/cycles.hpp"
#include "post/quantities.hpp"
#include "program/files/store_choice.hpp"

#include <contact2d.h>

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace estimate {

// A point inside a body with requested displacements or stresses.
struct Place {
  int32_t body; // from 1
  double x, y;
};

struct Trial;

// Stresses of the last cycle at every event and turn of the loads, between which they are linear in the load factors.
struct CycleDemand {
  int32_t from = 0;            // the piece of the history, from 1, at whose end the cycle begins; 0: no stresses of a cycle
  std::vector<int32_t> bodies; // from 1: with stresses along their surfaces
  bool rubbing = false;        // also friction and slip of the pairs
  std::vector<Place> points;
  // Further places that depend on the stresses along the surfaces. Empty: none.
  std::function<std::vector<Place>(const Trial&)> below;
};

// Limits and requests of one solution.
struct Demand {
  uint64_t memory = 0; // workspace bytes; 0: chosen by size
  std::vector<Place> points;
  bool drawn = false;     // the deck was made from a sketch
  bool all_steps = false; // states of every increment; else only at turns of the loads and midway
  bool hoop = false;      // also stresses along the surfaces, which are expensive
  bool zz = false;        // these, and stresses out of the plane
  CycleDemand cycle;
  // Store in memory for the tapes of the last factorisation, unless it is large: a run of the same deck need not prepare
  // again. Null: none.
  app::StoreChoice* store = nullptr;
  int32_t symmetry = 0, quadrature = 0, elimination = C2D_ELIMINATION_BY_SIZE; // as in c2d_options
};

enum Field { kUx, kUy, kTx, kTy, kStatus, kHoop, kSzz, kFields };

// A pair at one state of a cycle.
struct Rubbing {
  double x, y, pressure, friction, slip;
  int32_t zone; // from 1
};

// A recorded state: at a turn of the loads, at an early end, or between turns.
struct State {
  bool turn = false; // at a turn of the loads or at the end
  std::vector<double> loads;
  std::vector<std::array<std::vector<double>, kFields>> ends; // per body, per element end; kHoop if it is demanded; of
                                                              // a cycle kTx, kTy, kHoop and kSzz of the bodies demanded
  std::vector<app::Quantity> quantities;
  std::vector<std::array<double, 6>> inside; // per place: ux uy sxx syy sxy szz; of a cycle its points, then those below
  std::vector<Rubbing> rubbing;              // of a cycle
  double work = 0, dissipated = 0, elastic = 0;
};

double peak_pressure(const State& state, int32_t zone); // zone from 1; 0: it has none

struct Side { // elements from 0, going up; round an outline's end if last < first
  int32_t body, first, last;
};

struct Trial {
  int32_t nodes = 0;                        // functional nodes of an element
  std::vector<std::vector<double>> lengths; // per body: element lengths
  std::vector<double> stiffness;            // per body: E / (1 - nu^2)
  std::vector<double> across; // per body: stress along the surface for unit normal stress and zero strain along it
  std::vector<std::array<Side, 2>> zones;
  std::vector<char> tied;                 // per zone
  std::vector<std::vector<char>> touched; // per body and element end: touching at the end of any increment
  std::vector<State> states;
  std::vector<State> cycle; // at the turns and events of the last cycle, if it is demanded and was reached
  c2d_outcome outcome = C2D_REACHED;
  std::string why; // why the history ended early, or that its cycle is not steady; empty: it is complete
  int32_t elements = 0, pairs = 0, equations = 0;
  double seconds = 0;
  double work = 0; // approximate multiplications, equal on every machine
};

// Errors: as of c2d_create, c2d_read_deck, c2d_prepare, c2d_advance; `why` describes them.
c2d_status solve(const std::string& deck, const Demand& demand, Trial& out, std::string& why);

// The cycle in which a deck's load path ends, of each coefficient of friction that reached it.
struct EndOfCycles {
  int32_t coefficient; // from 1
  app::CycleSeen last;
  std::vector<double> tractions; // tn and tt of every pair at the end of the recorded cycle
};
c2d_status follow_cycles(const std::string& deck, const Demand& demand, std::vector<EndOfCycles>& out, std::string& why);

} // namespace estimate
