#pragma once
// Of rate_problem.hpp: the system of one set of cells, and what bounds it.
#include "contact/rates/rate_problem.hpp"

namespace c2d {

// Motions count in the unit of length, pressures by the stiffness of their own pair; columns are scaled to entries of at
// most 1. A system with a pivot below this has no solution that could be told from a motion that nothing holds.
constexpr double kRegular = sizeof(Real) == 8 ? 1e-9 : 1e-5;
// Conditions hold within this of the largest rate of their kind, and within this noise of the other kind.
constexpr double kConditionTolerance = sizeof(Real) == 8 ? 1e-9 : 1e-4;
constexpr double kNoise = sizeof(Real) == 8 ? 1e-11 : 1e-6; // what motions leave of round-off in forces: 3e-12 has been seen

struct Condition { // row . u >= 0
  double row[2];
  bool is_force;
};
struct Crossing { // where a condition ends: the cell beyond, and what of it grows from zero there
  Cell cell;
  double entering[2];
};
struct CellSizes { // largest rates
  double force, motion;
};

// Two numbers that tell solutions apart, whatever their cells: forces and motions summed with unlike weights.
struct Signature {
  double force, motion;
  double size;    // largest motion
  int32_t closed; // pairs
};
struct Solutions {
  static constexpr int kMost = 12;
  Signature seen[kMost];
  int32_t count;
  bool more; // than could be kept
  Signature taken;
  double nearest;       // of the one taken: how far its motion is from that before
  int32_t told() const; // those that count
};
// Adds the present solution, u, unless it is there already under other cells; if its motion is the nearest to r.before so far
// its cells are taken. Cells that mean the same, open and slipping of a pair that slides with neither force nor gap, must not
// depend on the order in which they are tried, or slip would: such pairs are open where supports hold the bodies, and as many
// closed as can be where contact does, which could not hold with all of them open.
void add_solution(RateProblem& r, const Real* u, Solutions& all);
// Of a solution u under the present cells: its open pairs that slide with neither force nor gap, closed one by one.
void close_what_can_be(RateProblem& r, Real* u);
void take_solution(RateProblem& r); // the cells taken are the present ones

double cell_friction(const RateProblem& r, const Doubt& d);
int cell_conditions(const RateProblem& r, const Doubt& d, Cell cell, Condition out[2]);
Crossing cross(const RateProblem& r, const Doubt& d, int which, const Real* u);
Cell closed_cell(const Doubt& d); // of a pair that is open or closed
int cells_of(const Doubt& d);
Cell nth_cell(const Doubt& d, int n);
double value_of(const double row[2], const Doubt& d, const Real* u);

void assemble_cells(RateProblem& r);              // the matrix of the present cells
void load_cells(const RateProblem& r, Real* out); // its right-hand side
bool factor_cells(RateProblem& r, int32_t n);     // its first n rows and columns; false: not regular
void solve_cells(const RateProblem& r, int32_t n, Real* x);
CellSizes sizes_of(const RateProblem& r, const Real* u);
bool satisfies(const RateProblem& r, const Real* u);
bool solve_present_cells(RateProblem& r, Real* u); // all of it; false: not regular, or a condition is violated

} // namespace c2d
