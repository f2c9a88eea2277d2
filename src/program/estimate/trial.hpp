// A model solved along its whole history on one mesh, with what is needed to compare it with another mesh of the same model.
#pragma once

#include "post/quantities.hpp"
#include "program/store_choice.hpp"

#include <contact2d.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace estimate {

// Where displacements and stresses inside a body are wanted.
struct Place {
  int32_t body; // from 1
  double x, y;
};

// What one run may take, and what it is to bring.
struct Demand {
  uint64_t memory = 0; // workspace bytes; 0: chosen by size
  std::vector<Place> points;
  bool drawn = false;     // the deck was made from a sketch
  bool all_steps = false; // states of every increment; else only where the loads turn and midway
  bool hoop = false;      // stresses along the surfaces, which take long to find
  // Where tapes are kept in memory, with what was prepared last, unless it was large: a run of the same deck in it need
  // not prepare again. Null: nowhere.
  app::StoreChoice* store = nullptr;
  int32_t symmetry = 0, quadrature = 0, elimination = C2D_ELIMINATION_BY_SIZE; // as in c2d_options
};

enum Field { kUx, kUy, kTx, kTy, kStatus, kHoop, kFields };

// The end of a piece of the path, or where it ended early, and on the way there.
struct State {
  bool turn = false; // the former
  std::vector<double> loads;
  std::vector<std::array<std::vector<double>, kFields>> ends; // per body, per element end; kHoop if it is demanded
  std::vector<app::Quantity> quantities;
  std::vector<std::array<double, 5>> inside; // of each place: ux uy sxx syy sxy
  double work = 0, dissipated = 0, elastic = 0;
};

struct Side { // elements from 0, going up; round an outline's end if last < first
  int32_t body, first, last;
};

struct Trial {
  int32_t nodes = 0;                        // functional ones of an element
  std::vector<std::vector<double>> lengths; // of every body's elements
  std::vector<double> stiffness;            // of every body: E / (1 - nu^2)
  std::vector<double> across;               // of every body: stress along its surface by one of 1 across, at no strain along it
  std::vector<std::array<Side, 2>> zones;
  std::vector<char> tied;                 // of each zone
  std::vector<std::vector<char>> touched; // of each body, per element end: at the end of any increment
  std::vector<State> states;
  c2d_outcome outcome = C2D_REACHED;
  std::string why; // if the history ended early
  int32_t elements = 0, pairs = 0, equations = 0;
  double seconds = 0;
  double work = 0; // multiplications, roughly: the same on every machine
};

// Errors: as of c2d_create, c2d_read_deck, c2d_prepare, c2d_advance; `why` says it in words.
c2d_status solve(const std::string& deck, const Demand& demand, Trial& out, std::string& why);

} // namespace estimate
