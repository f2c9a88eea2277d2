#pragma once
// The rates of contact in a state where the statuses of some pairs are in doubt: pairs without pressure and without gap
// (at the apex of the cone), and pairs whose friction is at its bound (on the cone). With the loads every such pair may
// open, stick or slip, and each choice has its conditions:
//   apex   open dp = dq = 0, dw_n >= 0;  stick dw = 0, |dq| <= mu dp;  slip s: dw_n = 0, dp >= 0, dq = s mu dp, s dw_t <= 0
//   cone   (s = sign q)  stick dw = 0, s dq <= mu dp;  slip s: dw_n = 0, dq = s mu dp, s dw_t <= 0
// A choice for all pairs, a set of cells, is one linear system in two unknowns a pair, read off the tableau; the cells of
// a pair at the apex form a ring (open, slip +, stick, slip -), so that the rates are a piecewise linear equation:
// complementarity in the form that plane Coulomb friction allows.
#include "contact/tableau.hpp"

namespace c2d {

// What a pair may do.
enum class DoubtKind : int32_t {
  cone,    // stick or slip one way
  apex,    // open, stick, slip either way
  normal,  // open or closed: without friction, or without a tangential direction
  adhesive // open or stuck: friction without bound
};
enum class Cell : int32_t { open, slip_plus, stick, slip_minus };

struct Doubt {
  int32_t pair, dof, slots; // its unknowns in the tableau, one or two
  int32_t row;              // its first unknown and equation in the problem
  DoubtKind kind;
  Cell cell;       // as chosen
  Cell taken;      // of the solution taken so far
  int32_t allowed; // branch_cells: 1 << cell of those left
  int32_t sign;    // cone: of the friction on body 2
  FrictionLaw law;
};

// branch_cells: the cells of a pair divided in two.
struct Branch {
  int32_t doubt;
  int32_t before, left; // all of its cells, and those still to be looked at
};

struct RateProblem {
  Tableau* t;
  const double* direction; // of the loads
  Real* rates;             // right-hand side: rates of the tableau's basic numbers along the path
  Real* before;            // [size] rates of motion up to here, (dw_n, dw_t) of each doubt; solutions near them are preferred.
                           // The same place as `cover`: the one is for trying all cells, the other for a path through them
  int32_t count, size;     // pairs in doubt, unknowns
  double mu_part;          // of every coefficient of a pair at the apex: 1 but while it is increased bit by bit
  Doubt* doubt;
  Real* matrix;                             // (size + 1)^2
  Real *rhs, *cover, *point, *column_scale; // size + 1 each; rhs is lost when the matrix is factored
  int32_t* pivots;                          // size + 1
  int32_t *given, *free;                    // branch_cells: quantities that are rows of the matrix, and columns; size each
  Branch* branch;                           // branch_cells: 3 count, the way to where it is
  double work;                              // operations so far
  bool partial;                             // there may be more solutions than were counted
  bool holds_body;                          // nothing else does: of a body with free motions some pair must stay closed
  bool on_tableau;                          // follow_cells: the tableau goes along, and has to be built anew afterwards
};

// Where problems live.
struct RateArea {
  Real* numbers; // of the number of slots and one: C2D_RATES_ARRAYS_ of contact2d_memory.h
  void* lists;   // doubts and pivots: kRateListBytes for each pair
  int32_t pairs;
};
// At most 2 slots a pair, and one.
constexpr uint64_t kRateListBytes = sizeof(Doubt) + 3 * sizeof(Branch) + 7 * sizeof(int32_t);

// An empty problem of `slots` unknowns at most, carved from an area.
RateProblem rate_problem_in(const RateArea& area, int32_t slots);

enum class Settled : int32_t {
  solved,   // doubt[].cell has rates that satisfy all conditions
  none,     // all cells were tried: there are no such rates
  undecided // none were found, and not all cells were tried
};

// How many sets of cells there are; at most 2^30.
int64_t count_cells(const RateProblem& r);
// Tries all of them. *found: how many solutions differ (of those with a regular system), at least that many if r.partial; the
// one whose motion differs least from `before` is taken.
Settled try_all_cells(RateProblem& r, int32_t* found);
// Follows the piecewise linear path from an artificial load under which one set of cells is right down to none (Lemke's
// method): from the present cells, from sticking, and through increasing and decreasing coefficients of friction; or, drawn,
// from cells and artificial loads drawn at random, always the same ones.
Settled follow_cells(RateProblem& r, bool drawn, c2d_status (*tick)(void*), void* context, c2d_status* status);
// Divides the cells of the pairs until what is left of them has rates or is proven to have none, in `most` parts. `every`: all
// solutions are looked for and the nearest to `before` taken, as try_all_cells does; else one. `none` if no regular set of
// cells has rates, `undecided` if the parts did not suffice for one.
Settled branch_cells(RateProblem& r, bool every, int32_t most, int32_t* found, c2d_status (*tick)(void*), void* context,
                     c2d_status* status);

// Status and sign that a cell stands for.
int32_t cell_status(const Doubt& d, Cell cell);
int32_t cell_sign(const Doubt& d, Cell cell);

} // namespace c2d
