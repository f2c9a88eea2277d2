// Rates by branch and bound. Of each pair in doubt some cells are left. Every quantity of a pair may then be of certain signs
// only, those that it has in one of these cells: a system of linear inequalities, which knows nothing of the cells but that.
// If it has no solution, no set of those cells has rates. If it has one, and no pair is between two cells there, these are
// the rates; else the cells of the pair that is farthest between are divided, and both parts are looked at.

#include "contact/rates/rate_cells.hpp"
#include "linalg/exchange.hpp"
#include "memory/math.hpp"

namespace c2d {

namespace {

// Quantities of a pair: w_n, w_t and two of its forces. At the apex these are the parts along both edges of the cone,
// (p, q) = ((1, -mu) x[2] + (1, mu) x[3]) / (1 + mu); on the cone p and what friction lacks of its bound; else p and q.
// Numbered kParts * doubt + part; as many as there are unknowns are given by the others: rows and columns of the matrix,
// whose last column are the values where those others are zero.
constexpr int kParts = 4;
constexpr int kBelow = 1, kAbove = 2; // signs a quantity may have

constexpr double kMostWork = 2e9; // operations: some seconds at most

int32_t bit(Cell cell) { return 1 << static_cast<int32_t>(cell); }
bool is_allowed(const Doubt& d, Cell cell) { return (d.allowed & bit(cell)) != 0; }
bool is_fixed(const Doubt& d) { return (d.allowed & (d.allowed - 1)) == 0; }

int signs_of(bool below, bool above) { return (below ? kBelow : 0) + (above ? kAbove : 0); }

// Of the cells that are left.
int signs_of(const Doubt& d, int part) {
  const bool open = is_allowed(d, Cell::open), stick = is_allowed(d, Cell::stick);
  const bool plus = is_allowed(d, Cell::slip_plus), minus = is_allowed(d, Cell::slip_minus);
  switch (d.kind) {
  case DoubtKind::apex:
    if (part == 1) return signs_of(open || plus, open || minus);
    return signs_of(false, part == 0 ? open : stick || (part == 2 ? minus : plus));
  case DoubtKind::cone:
    if (part == 1) return signs_of(plus, minus);
    return part == 2 ? kBelow + kAbove : signs_of(false, part == 3 && stick);
  case DoubtKind::normal:
    if (part == 1) return kBelow + kAbove;
    return signs_of(false, part == 0 ? open : part == 2 && (stick || plus));
  default: return signs_of((part == 1 && open) || (part == 3 && stick), part < 2 ? open : stick);
  }
}

Real& at(const RateProblem& r, int32_t i, int32_t j) { return r.matrix[static_cast<int64_t>(j) * (r.size + 1) + i]; }

void scale_row(RateProblem& r, int32_t i, double factor) {
  for (int32_t j = 0; j <= r.size; ++j) at(r, i, j) *= static_cast<Real>(factor);
}
void scale_column(RateProblem& r, int32_t j, double factor) {
  for (int32_t i = 0; i < r.size; ++i) at(r, i, j) *= static_cast<Real>(factor);
}

// Two rows or columns, p and q: to what they are along the edges of the cone, but for a factor.
void turn_rows(RateProblem& r, int32_t n, double mu) {
  scale_row(r, n + 1, 1.0 / mu);
  row_add(r.size + 1, r.matrix, r.size + 1, n, n + 1, Real(-1));
  scale_row(r, n + 1, 2.0);
  row_add(r.size + 1, r.matrix, r.size + 1, n + 1, n, Real(1));
}
void turn_columns(RateProblem& r, int32_t n, double mu) {
  scale_column(r, n + 1, mu);
  column_add(r.size, r.matrix, r.size + 1, n, n + 1, Real(-1));
  scale_column(r, n + 1, 2.0);
  column_add(r.size, r.matrix, r.size + 1, n + 1, n, Real(1));
}

void name(RateProblem& r, int32_t i, const int part[4]) {
  const Doubt& d = r.doubt[i];
  for (int s = 0; s < d.slots; ++s) {
    r.given[d.row + s] = kParts * i + part[s];
    r.free[d.row + s] = kParts * i + part[2 + s];
  }
}

// Pressures in units of the pair's own stiffness, as everywhere in the rate problem.
void scale_pressures(RateProblem& r, const Doubt& d, const Pair& pair) {
  const double unit = pair.stiffness[0];
  for (int s = 0; s < d.slots; ++s) {
    const bool row_is_force = pair.status == C2D_STICK || (pair.status == C2D_SLIP && s == 0);
    if (row_is_force) scale_row(r, d.row + s, 1.0 / unit);
    if (pair.status == C2D_OPEN || (pair.status == C2D_SLIP && s == 1)) scale_column(r, d.row + s, unit);
  }
}

void name_apex(RateProblem& r, int32_t i, const Pair& pair) {
  const Doubt& d = r.doubt[i];
  const double one = d.law.scale();
  if (pair.status == C2D_OPEN) {
    turn_columns(r, d.row, d.law.mu);
    for (int s = 0; s < 2; ++s) scale_column(r, d.row + s, 1.0 / one);
  } else if (pair.status == C2D_STICK) {
    turn_rows(r, d.row, d.law.mu);
    for (int s = 0; s < 2; ++s) scale_row(r, d.row + s, 0.5 * one);
  } else { // r = q - sign mu p is one part alone, and p the sum of both
    scale_column(r, d.row + 1, -2.0 * d.law.slope(pair.sign) / one);
    scale_row(r, d.row, one);
    at(r, d.row, d.row + 1) -= Real(1);
    const int slips[2][4] = {{2, 1, 0, 3}, {3, 1, 0, 2}};
    name(r, i, slips[pair.sign > 0]);
  }
}

void name_cone(RateProblem& r, const Doubt& d, const Pair& pair) {
  const double one = 1.0 / d.law.scale();
  if (pair.status == C2D_STICK) {
    scale_row(r, d.row + 1, -one * d.sign);
    row_add(r.size + 1, r.matrix, r.size + 1, d.row + 1, d.row, static_cast<Real>(one * d.law.mu));
  } else {
    scale_column(r, d.row + 1, -d.sign / one);
  }
}

// The tableau's rows and columns of the pairs in doubt, in these quantities.
void lay_out(RateProblem& r) {
  for (int32_t j = 0; j < r.count; ++j)
    for (int q = 0; q < r.doubt[j].slots; ++q)
      for (int32_t i = 0; i < r.count; ++i)
        for (int s = 0; s < r.doubt[i].slots; ++s)
          at(r, r.doubt[i].row + s, r.doubt[j].row + q) =
              r.t->t[static_cast<int64_t>(column_of(*r.t, r.doubt[j].pair, q)) * r.t->m + r.doubt[i].dof + s];
  for (int32_t i = 0; i < r.count; ++i)
    for (int s = 0; s < r.doubt[i].slots; ++s) at(r, r.doubt[i].row + s, r.size) = r.rates[r.doubt[i].dof + s];
  for (int32_t i = 0; i < r.count; ++i) {
    const Doubt& d = r.doubt[i];
    const Pair& pair = r.t->pair[d.pair];
    const int parts[3][4] = {{0, 1, 2, 3}, {2, 3, 0, 1}, {2, 1, 0, 3}};
    name(r, i, parts[pair.status == C2D_OPEN ? 0 : pair.status == C2D_STICK ? 1 : 2]);
    scale_pressures(r, d, pair);
    if (d.kind == DoubtKind::apex) name_apex(r, i, pair);
    if (d.kind == DoubtKind::cone) name_cone(r, d, pair);
  }
}

// ---- the inequalities ---------------------------------------------------------------------------------------------

int signs_of(const RateProblem& r, int32_t quantity) { return signs_of(r.doubt[quantity / kParts], quantity % kParts); }

double largest_value(const RateProblem& r) {
  double most = 0.0;
  for (int32_t i = 0; i < r.size; ++i) most = fmax(most, fabs(static_cast<double>(at(r, i, r.size))));
  return most;
}

// The row whose quantity has the wrong sign by most; or the first one by number, with which no round of exchanges returns.
int32_t worst_row(const RateProblem& r, bool first) {
  double most = kConditionTolerance * largest_value(r);
  int32_t worst = -1;
  for (int32_t i = 0; i < r.size; ++i) {
    const double value = static_cast<double>(at(r, i, r.size));
    if ((signs_of(r, r.given[i]) & (value < 0.0 ? kBelow : kAbove)) != 0 || fabs(value) <= most) continue;
    if (first && worst >= 0 && r.given[i] > r.given[worst]) continue;
    if (!first) most = fabs(value);
    worst = i;
  }
  return worst;
}

// The column that mends a row: -1 if none can.
int32_t mending_column(const RateProblem& r, int32_t row, bool first) {
  const bool up = at(r, row, r.size) < 0;
  double largest = 1.0;
  for (int32_t j = 0; j < r.size; ++j) largest = fmax(largest, fabs(static_cast<double>(at(r, row, j))));
  double most = kRegular * largest;
  int32_t best = -1;
  for (int32_t j = 0; j < r.size; ++j) {
    const double entry = static_cast<double>(at(r, row, j));
    if (fabs(entry) <= most || (signs_of(r, r.free[j]) & ((entry > 0.0) == up ? kAbove : kBelow)) == 0) continue;
    if (first && best >= 0 && r.free[j] > r.free[best]) continue;
    if (!first) most = fabs(entry);
    best = j;
  }
  return best;
}

// Exchanges rows and columns until all signs are right. False: a row proves that they cannot be.
bool has_point(RateProblem& r) {
  const int32_t patience = 4 * r.size;
  for (int32_t step = 0; step < 4 * patience; ++step) {
    const int32_t row = worst_row(r, step > patience);
    if (row < 0) return true;
    const int32_t column = mending_column(r, row, step > patience);
    if (column < 0) return false;
    exchange(r.size, r.size + 1, r.matrix, r.size + 1, row, column);
    const int32_t quantity = r.given[row];
    r.given[row] = r.free[column];
    r.free[column] = quantity;
    r.work += 2.0 * r.size * r.size;
  }
  return true; // not known: no cells are left out for that
}

// Motions to r.rhs, forces to r.point, at the rows of their slots.
void read_point(RateProblem& r) {
  for (int32_t i = 0; i < r.size; ++i) r.rhs[i] = r.point[i] = 0;
  for (int32_t i = 0; i < r.size; ++i) {
    const int32_t part = r.given[i] % kParts, row = r.doubt[r.given[i] / kParts].row;
    (part < 2 ? r.rhs : r.point)[row + part % 2] = at(r, i, r.size);
  }
}

// ---- the branches -------------------------------------------------------------------------------------------------

// Divides the cells of a pair: one of them, and the others.
struct Division {
  int32_t doubt; // -1: none
  Cell cell;
  bool cell_first;
  double size; // how far from both
};

struct PairPoint {
  double wn, wt, one, other; // forces as above
};
PairPoint point_of(const RateProblem& r, const Doubt& d) {
  const bool two = d.slots == 2;
  return {static_cast<double>(r.rhs[d.row]), two ? static_cast<double>(r.rhs[d.row + 1]) : 0.0,
          static_cast<double>(r.point[d.row]), two ? static_cast<double>(r.point[d.row + 1]) : 0.0};
}

// What an open pair may not have, and what a closed one may not have.
double pressed(const Doubt& d, const PairPoint& x) {
  if (d.kind == DoubtKind::apex) return x.one + x.other;
  return fmax(x.one, d.kind == DoubtKind::adhesive ? fabs(x.other) : 0.0);
}
double apart(const Doubt& d, const PairPoint& x) { return fmax(x.wn, d.kind == DoubtKind::adhesive ? fabs(x.wt) : 0.0); }

// The cell of slip the way the pair moves, and what friction lacks of its bound there.
Cell way_of(const PairPoint& x) { return x.wt < 0.0 ? Cell::slip_plus : Cell::slip_minus; }
double lacking(const Doubt& d, const PairPoint& x) {
  if (d.kind == DoubtKind::cone) return x.other;
  return d.kind == DoubtKind::apex ? (x.wt < 0.0 ? x.one : x.other) : 0.0;
}

Division division_of(const Doubt& d, const PairPoint& x, double none) {
  const double away = apart(d, x), held = pressed(d, x), lack = lacking(d, x);
  const bool may_open = is_allowed(d, Cell::open);
  if (is_fixed(d) || (may_open && held <= none)) return {-1, Cell::open, false, 0.0};
  if (may_open && away > none) return {0, Cell::open, away > held, fmin(away, held)};
  if (fabs(x.wt) <= none || lack <= none) return {-1, Cell::open, false, 0.0};
  return {0, may_open ? Cell::open : way_of(x), !may_open && fabs(x.wt) > lack, fmin(fabs(x.wt), lack)};
}

Division worst_division(const RateProblem& r) {
  const double none = kConditionTolerance * largest_value(r);
  Division worst{-1, Cell::open, false, 0.0};
  for (int32_t i = 0; i < r.count; ++i) {
    Division own = division_of(r.doubt[i], point_of(r, r.doubt[i]), none);
    if (own.doubt < 0 || own.size <= worst.size) continue;
    worst = own;
    worst.doubt = i;
  }
  return worst;
}

// A cell of those left in which the pair is where the point has it.
Cell cell_at(const Doubt& d, const PairPoint& x, double none) {
  const Cell closed = closed_cell(d);
  if (is_allowed(d, Cell::open) && (is_fixed(d) || pressed(d, x) <= none)) return Cell::open;
  const bool slides = lacking(d, x) <= none && fabs(x.wt) > none;
  if (slides && is_allowed(d, way_of(x))) return way_of(x);
  return is_allowed(d, closed) ? closed : is_allowed(d, Cell::slip_plus) ? Cell::slip_plus : Cell::slip_minus;
}

// Where no pair is between two cells: cells that have rates there, unless they are no regular system. False: they are not.
// *next: the first pair that still has a choice.
bool try_point(RateProblem& r, Division* next) {
  const double none = kConditionTolerance * largest_value(r);
  *next = Division{-1, Cell::open, true, 0.0};
  for (int32_t i = r.count - 1; i >= 0; --i) {
    Doubt& d = r.doubt[i];
    d.cell = cell_at(d, point_of(r, d), none);
    if (!is_fixed(d)) *next = Division{i, d.cell, true, 0.0};
  }
  const bool right = solve_present_cells(r, r.rhs);
  if (right && r.t->free_motions > 0) close_what_can_be(r, r.rhs);
  lay_out(r);
  return right;
}

void allow_all(RateProblem& r) {
  for (int32_t i = 0; i < r.count; ++i) {
    r.doubt[i].allowed = 0;
    for (int n = 0; n < cells_of(r.doubt[i]); ++n) r.doubt[i].allowed |= bit(nth_cell(r.doubt[i], n));
  }
}

// A point that was given up on the way may say a cell that is not left; any other will do.
void descend(RateProblem& r, const Division& at, int32_t* depth) {
  Doubt& d = r.doubt[at.doubt];
  const int32_t before = d.allowed, one = is_allowed(d, at.cell) ? bit(at.cell) : before & -before, others = before & ~one;
  d.allowed = at.cell_first ? one : others;
  r.branch[(*depth)++] = Branch{at.doubt, before, before & ~d.allowed};
}

// To the next part that has not been looked at; false: there is none.
bool go_back(RateProblem& r, int32_t* depth) {
  while (*depth > 0) {
    Branch& last = r.branch[*depth - 1];
    Doubt& d = r.doubt[last.doubt];
    if (last.left != 0) {
      d.allowed = last.left;
      last.left = 0;
      return true;
    }
    d.allowed = last.before;
    --*depth;
  }
  return false;
}

} // namespace

Settled branch_cells(RateProblem& r, bool every, int32_t most, int32_t* found, c2d_status (*tick)(void*), void* context,
                     c2d_status* status) {
  Solutions all{};
  int32_t depth = 0;
  double fresh = 0.0; // work when the matrix was last laid out: what exchanges gather ends there
  bool done = false;
  allow_all(r);
  lay_out(r);
  for (int32_t node = 0; !done && node < most && r.work < kMostWork; ++node) {
    *status = node % 64 == 0 ? tick(context) : c2d_status{C2D_OK};
    if (*status != C2D_OK) return Settled::undecided;
    if (r.work - fresh > 8.0 * r.size * r.size * r.size) {
      lay_out(r);
      fresh = r.work;
    }
    Division next{-1, Cell::open, false, 0.0};
    if (has_point(r)) {
      read_point(r);
      next = worst_division(r);
      if (next.doubt < 0 && try_point(r, &next)) {
        add_solution(r, r.rhs, all);
        done = !every;
      }
    }
    if (next.doubt >= 0)
      descend(r, next, &depth);
    else
      done = !go_back(r, &depth) || done;
  }
  take_solution(r);
  *found = all.told();
  r.partial = all.more || !done;
  return all.count > 0 ? Settled::solved : done ? Settled::none : Settled::undecided;
}

} // namespace c2d
