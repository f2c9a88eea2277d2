// One set of cells: its linear system, its conditions, and all sets one after another.
#include "contact/rates/rate_problem.hpp"

#include "contact/rates/rate_cells.hpp"
#include "linalg/lu.hpp"
#include "memory/math.hpp"

namespace c2d {

namespace {

double larger(double a, double b) { return a > b ? a : b; }
double of_slip(Cell cell) { return cell == Cell::slip_plus ? 1.0 : -1.0; }
bool slips(Cell cell) { return cell == Cell::slip_plus || cell == Cell::slip_minus; }

// (w_n, w_t, p, q) of a pair as linear functions of its two unknowns.
struct Quantities {
  double of[4][2];
};

// Pressures are divided by the pair's own stiffness throughout, so are lengths.
Quantities quantities(const RateProblem& r, const Doubt& d, Cell cell) {
  Quantities x{};
  if (cell == Cell::open) {
    x.of[0][0] = x.of[1][1] = 1.0;
  } else if (cell == Cell::stick) {
    x.of[2][0] = x.of[3][1] = 1.0;
  } else {
    x.of[2][0] = x.of[1][1] = 1.0;
    x.of[3][0] = of_slip(cell) * cell_friction(r, d);
  }
  return x;
}

// What the tableau's y and z of a slot are by the pair's status there: indices into (w_n, w_t, p, q).
struct Sides {
  int y, z;
};
Sides sides(const Pair& pair, int slot) {
  switch (pair.status) {
  case C2D_OPEN: return {slot, slot + 2};
  case C2D_STICK: return {slot + 2, slot};
  default: return slot == 0 ? Sides{2, 0} : Sides{1, 3};
  }
}

// z of a slot as a function of the unknowns: of a slipping pair r = q - sign mu p.
void nonbasic(const Pair& pair, const Quantities& x, int slot, double out[2]) {
  const Sides s = sides(pair, slot);
  for (int c = 0; c < 2; ++c) {
    out[c] = x.of[s.z][c];
    if (pair.status == C2D_SLIP && slot == 1) out[c] -= pair.law.slope(pair.sign) * x.of[2][c];
  }
}

double scale_of(const Pair& pair, int quantity) { return quantity < 2 ? 1.0 : pair.stiffness[0]; }

Real& at(RateProblem& r, int32_t i, int32_t j) { return r.matrix[static_cast<int64_t>(j) * (r.size + 1) + i]; }

// The columns of one pair's unknowns: what they do to y of all pairs, through z of its own.
void add_columns(RateProblem& r, const Doubt& d) {
  const Tableau& t = *r.t;
  const Pair& own = t.pair[d.pair];
  const Quantities x = quantities(r, d, d.cell);
  for (int slot = 0; slot < d.slots; ++slot) {
    double z[2];
    nonbasic(own, x, slot, z);
    const Real* column = t.t + static_cast<int64_t>(column_of(t, d.pair, slot)) * t.m;
    const double unit = scale_of(own, sides(own, slot).z);
    for (int c = 0; c < d.slots; ++c) {
      at(r, d.row + slot, d.row + c) += static_cast<Real>(x.of[sides(own, slot).y][c]);
      if (z[c] == 0.0) continue;
      for (int32_t i = 0; i < r.count; ++i) {
        const Doubt& other = r.doubt[i];
        for (int s = 0; s < other.slots; ++s) {
          const double factor = unit / scale_of(t.pair[other.pair], sides(t.pair[other.pair], s).y);
          at(r, other.row + s, d.row + c) -= static_cast<Real>(factor * z[c] * static_cast<double>(column[other.dof + s]));
        }
      }
    }
  }
}

} // namespace

// Bounds of friction are divided by this, so that a large coefficient has no large noise.
static double bound_scale(double mu) { return 1.0 / (1.0 + mu); }

double cell_friction(const RateProblem& r, const Doubt& d) {
  return d.kind == DoubtKind::apex ? r.mu_part * d.law.mu : (d.kind == DoubtKind::cone ? d.law.mu : 0.0);
}

int cell_conditions(const RateProblem& r, const Doubt& d, Cell cell, Condition out[2]) {
  const double one = bound_scale(cell_friction(r, d)), mu = one * cell_friction(r, d);
  const double s = slips(cell) ? of_slip(cell) : 0.0;
  switch (d.kind) {
  case DoubtKind::cone:
    out[0] = cell == Cell::stick ? Condition{{mu, -one * d.sign}, true} : Condition{{0.0, -s}, false};
    return 1;
  case DoubtKind::apex:
    if (cell == Cell::stick) {
      out[0] = {{mu, -one}, true};
      out[1] = {{mu, one}, true};
      return 2;
    }
    out[0] = {{1.0, 0.0}, cell != Cell::open};
    out[1] = {{0.0, -s}, false};
    return cell == Cell::open ? 1 : 2;
  default: out[0] = {{1.0, 0.0}, cell != Cell::open}; return 1;
  }
}

Crossing cross(const RateProblem& r, const Doubt& d, int which, const Real* u) {
  const double one = bound_scale(cell_friction(r, d)), mu = one * cell_friction(r, d);
  switch (d.kind) {
  case DoubtKind::cone: {
    const Cell slip = d.sign > 0 ? Cell::slip_plus : Cell::slip_minus;
    if (d.cell == Cell::stick) return {slip, {0.0, -1.0 * d.sign}};
    return {Cell::stick, {mu, -one * d.sign}};
  }
  case DoubtKind::apex:
    if (d.cell == Cell::open) return {u[d.row + 1] < 0 ? Cell::slip_plus : Cell::slip_minus, {1.0, 0.0}};
    if (d.cell == Cell::stick)
      return which == 0 ? Crossing{Cell::slip_plus, {0.0, -1.0}} : Crossing{Cell::slip_minus, {0.0, 1.0}};
    if (which == 0) return {Cell::open, {1.0, 0.0}};
    return {Cell::stick, {mu, -one * of_slip(d.cell)}};
  default: return {d.cell == Cell::open ? closed_cell(d) : Cell::open, {1.0, 0.0}};
  }
}

Cell closed_cell(const Doubt& d) {
  return d.kind == DoubtKind::normal && d.law.is_smooth() && d.slots == 2 ? Cell::slip_plus : Cell::stick;
}

int32_t cell_status(const Doubt& d, Cell cell) {
  if (cell == Cell::open) return C2D_OPEN;
  if (d.kind == DoubtKind::normal) return d.law.is_smooth() ? C2D_SLIP : C2D_STICK;
  return cell == Cell::stick ? C2D_STICK : C2D_SLIP;
}
int32_t cell_sign(const Doubt& d, Cell cell) {
  if (cell_status(d, cell) != C2D_SLIP) return 0;
  return cell == Cell::slip_minus ? -1 : 1;
}

double value_of(const double row[2], const Doubt& d, const Real* u) {
  return row[0] * u[d.row] + (d.slots == 2 ? row[1] * u[d.row + 1] : 0.0);
}

void assemble_cells(RateProblem& r) {
  for (int32_t j = 0; j <= r.size; ++j)
    for (int32_t i = 0; i <= r.size; ++i) at(r, i, j) = 0;
  for (int32_t i = 0; i < r.count; ++i) add_columns(r, r.doubt[i]);
  r.work += static_cast<double>(r.size) * r.size;
}

void load_cells(const RateProblem& r, Real* out) {
  for (int32_t i = 0; i < r.count; ++i) {
    const Doubt& d = r.doubt[i];
    const Pair& pair = r.t->pair[d.pair];
    for (int s = 0; s < d.slots; ++s) out[d.row + s] = static_cast<Real>(r.rates[d.dof + s] / scale_of(pair, sides(pair, s).y));
  }
}

bool factor_cells(RateProblem& r, int32_t n) {
  const int32_t ld = r.size + 1;
  // Columns are made smaller, never larger: one that is all round-off shows as a pivot that is.
  for (int32_t j = 0; j < n; ++j) {
    Real* column = r.matrix + static_cast<int64_t>(j) * ld;
    double most = 1.0;
    for (int32_t i = 0; i < n; ++i) most = larger(most, fabs(static_cast<double>(column[i])));
    r.column_scale[j] = static_cast<Real>(1.0 / most);
    for (int32_t i = 0; i < n; ++i) column[i] *= r.column_scale[j];
  }
  r.work += static_cast<double>(n) * n * n / 1.5;
  if (lu_factor(kPlainEngine, n, r.matrix, ld, r.pivots, r.rhs, nullptr) != 0) return false;
  for (int32_t j = 0; j < n; ++j)
    if (!(fabs(static_cast<double>(r.matrix[static_cast<int64_t>(j) * ld + j])) > kRegular)) return false;
  return true;
}

void solve_cells(const RateProblem& r, int32_t n, Real* x) {
  lu_solve(kPlainEngine, n, 1, r.matrix, r.size + 1, r.pivots, x, n);
  for (int32_t j = 0; j < n; ++j) x[j] *= r.column_scale[j];
}

CellSizes sizes_of(const RateProblem& r, const Real* u) {
  CellSizes s{0.0, 0.0};
  for (int32_t i = 0; i < r.count; ++i) {
    const Doubt& d = r.doubt[i];
    const Quantities x = quantities(r, d, d.cell);
    for (int k = 0; k < 4; ++k) {
      const double value = fabs(value_of(x.of[k], d, u));
      if (k < 2)
        s.motion = larger(s.motion, value);
      else
        s.force = larger(s.force, value);
    }
  }
  return s;
}

bool satisfies(const RateProblem& r, const Real* u) {
  const CellSizes size = sizes_of(r, u);
  const double force = kConditionTolerance * size.force + kNoise * size.motion;
  const double motion = kConditionTolerance * size.motion + kNoise * size.force;
  for (int32_t i = 0; i < r.count; ++i) {
    const Doubt& d = r.doubt[i];
    Condition condition[2];
    const int count = cell_conditions(r, d, d.cell, condition);
    for (int k = 0; k < count; ++k)
      if (value_of(condition[k].row, d, u) < -(condition[k].is_force ? force : motion)) return false;
  }
  return true;
}

// Round-off would hold what nothing holds then.
static bool lets_go(const RateProblem& r) {
  for (int32_t i = 0; i < r.count; ++i)
    if (r.doubt[i].cell != Cell::open) return false;
  return r.holds_body;
}

bool solve_present_cells(RateProblem& r, Real* u) {
  if (lets_go(r)) return false;
  assemble_cells(r);
  if (!factor_cells(r, r.size)) return false;
  load_cells(r, u);
  solve_cells(r, r.size, u);
  return satisfies(r, u);
}

// ---- all cells ----------------------------------------------------------------------------------------------------

int cells_of(const Doubt& d) { return d.kind == DoubtKind::apex ? 4 : 2; }

Cell nth_cell(const Doubt& d, int n) {
  switch (d.kind) {
  case DoubtKind::cone: return n == 0 ? Cell::stick : (d.sign > 0 ? Cell::slip_plus : Cell::slip_minus);
  case DoubtKind::apex: return static_cast<Cell>(n);
  default: return n == 0 ? Cell::open : closed_cell(d);
  }
}

namespace {

// Does a set of cells come next? The first pair counts fastest.
bool next_cells(RateProblem& r) {
  for (int32_t i = 0; i < r.count; ++i) {
    Doubt& d = r.doubt[i];
    int n = 0;
    while (nth_cell(d, n) != d.cell) ++n;
    if (n + 1 < cells_of(d)) {
      d.cell = nth_cell(d, n + 1);
      return true;
    }
    d.cell = nth_cell(d, 0);
  }
  return false;
}

Signature sign_solution(const RateProblem& r, const Real* u, double* away) {
  Signature s{};
  double turn = 0.0; // weights unlike for all, so that solutions which mirror each other differ
  *away = 0.0;
  for (int32_t i = 0; i < r.count; ++i) {
    const Doubt& d = r.doubt[i];
    const Quantities x = quantities(r, d, d.cell);
    double value[4];
    for (int k = 0; k < 4; ++k) value[k] = value_of(x.of[k], d, u);
    for (int k = 0; k < d.slots; ++k) {
      turn = fmod(turn + 0.6180339887498949, 1.0);
      const double weight = 1.0 + turn;
      s.motion += weight * value[k];
      s.force += weight * value[k + 2];
      const double step = value[k] - static_cast<double>(r.before[d.row + k]);
      *away += step * step;
    }
  }
  return s;
}

// The same but for round-off: of each kind, and what the other leaves of it in every number that was summed.
bool alike(const RateProblem& r, const Signature& a, const Signature& b, const CellSizes& size) {
  constexpr double kAlike = 1e-6;
  const double noise = 4.0 * r.size * kNoise * (size.force + size.motion);
  return fabs(a.force - b.force) <= kAlike * size.force + noise && fabs(a.motion - b.motion) <= kAlike * size.motion + noise;
}

// Of solutions that are equally near, as those that mirror each other are, the order of the pairs decides: the first pair that
// differs sticks rather than slips, and slips rather than opens.
bool comes_first(const RateProblem& r) {
  const int order[] = {3, 1, 0, 2}; // by Cell
  for (int32_t i = 0; i < r.count; ++i) {
    const Doubt& d = r.doubt[i];
    if (d.cell != d.taken) return order[static_cast<int>(d.cell)] < order[static_cast<int>(d.taken)];
  }
  return false;
}

void take(RateProblem& r, Solutions& all, const Signature& s, double away) {
  all.nearest = away;
  all.taken = s;
  for (int32_t i = 0; i < r.count; ++i) r.doubt[i].taken = r.doubt[i].cell;
}

} // namespace

void add_solution(RateProblem& r, const Real* u, Solutions& all) {
  double away;
  Signature own = sign_solution(r, u, &away);
  const CellSizes size = sizes_of(r, u);
  own.size = size.motion + size.force;
  for (int32_t i = 0; i < r.count; ++i) own.closed += r.doubt[i].cell != Cell::open;
  for (int32_t k = 0; k < all.count; ++k) {
    if (!alike(r, own, all.seen[k], size)) continue;
    const bool rather = r.t->free_motions > 0 ? own.closed > all.taken.closed : own.closed < all.taken.closed;
    if (rather && alike(r, own, all.taken, size)) take(r, all, own, all.nearest);
    return;
  }
  if (all.count < Solutions::kMost)
    all.seen[all.count++] = own;
  else
    all.more = true;
  constexpr double kEqual = 1e-6;
  const bool equal = fabs(away - all.nearest) <= kEqual * all.nearest;
  if (all.count == 1 || (equal ? comes_first(r) : away < all.nearest)) take(r, all, own, away);
}

void close_what_can_be(RateProblem& r, Real* u) {
  bool right = true;
  for (int32_t i = 0; i < r.count; ++i) {
    Doubt& d = r.doubt[i];
    if (d.cell != Cell::open) continue;
    if (!right) solve_present_cells(r, u);
    right = true;
    const Quantities x = quantities(r, d, Cell::open);
    const double none = kConditionTolerance * sizes_of(r, u).motion, wt = d.slots == 2 ? value_of(x.of[1], d, u) : 0.0;
    if (fabs(value_of(x.of[0], d, u)) > none) continue;
    d.cell = closed_cell(d);
    if (d.kind == DoubtKind::apex && fabs(wt) > none) d.cell = wt < 0.0 ? Cell::slip_plus : Cell::slip_minus;
    right = solve_present_cells(r, u);
    if (!right) d.cell = Cell::open;
  }
  if (!right) solve_present_cells(r, u);
}

void take_solution(RateProblem& r) {
  for (int32_t i = 0; i < r.count; ++i) r.doubt[i].cell = r.doubt[i].taken;
}

// One that moves enormously against another is a motion that hardly anything holds.
int32_t Solutions::told() const {
  constexpr double kEnormous = 1e5;
  double least = seen[0].size;
  int32_t out = 0;
  for (int32_t k = 1; k < count; ++k) least = seen[k].size < least ? seen[k].size : least;
  for (int32_t k = 0; k < count; ++k) out += seen[k].size <= kEnormous * least;
  return out;
}

int64_t count_cells(const RateProblem& r) {
  int64_t sets = 1;
  for (int32_t i = 0; i < r.count && sets < (1 << 30); ++i) sets *= cells_of(r.doubt[i]);
  return sets < (1 << 30) ? sets : (1 << 30);
}

Settled try_all_cells(RateProblem& r, int32_t* found) {
  Solutions all{};
  for (int32_t i = 0; i < r.count; ++i) {
    r.doubt[i].taken = r.doubt[i].cell;
    r.doubt[i].cell = nth_cell(r.doubt[i], 0);
  }
  do {
    if (solve_present_cells(r, r.rhs)) add_solution(r, r.rhs, all);
  } while (next_cells(r));
  take_solution(r);
  *found = all.told();
  r.partial = all.more;
  return all.count > 0 ? Settled::solved : Settled::none;
}

RateProblem rate_problem_in(const RateArea& area, int32_t slots) {
  const uint64_t n = static_cast<uint64_t>(slots) + 1;
  RateProblem r{};
  r.doubt = static_cast<Doubt*>(area.lists);
  r.branch = reinterpret_cast<Branch*>(r.doubt + area.pairs);
  r.pivots = reinterpret_cast<int32_t*>(r.branch + 3 * area.pairs);
  r.given = r.pivots + slots + 1;
  r.free = r.given + slots;
  Real* number = area.numbers;
  r.matrix = number;
  number += n * n;
  Real** const vectors[] = {&r.rhs, &r.cover, &r.point, &r.column_scale};
  for (Real** v : vectors) {
    *v = number;
    number += n;
  }
  r.before = r.cover;
  r.mu_part = 1.0;
  return r;
}

} // namespace c2d
