// Tableau with delayed exchanges (METHOD 11, equation METHOD (11.4)).
//
// A Gauss-Jordan exchange, METHOD (11.3), is a rank-one change of the whole tableau and streams it through memory. Here the
// changes are collected in a list, and the tableau is represented as
//   tableau = T - U M V^T.
// T is the tableau when the list was last applied, with the rows and columns of the listed exchanges set to zero. U and V
// contain these columns and rows. M is the inverse of the block of T in which they meet.
// Phases of one exchange (r, s), p being the pivot:
// 1. Read column s and row r of the tableau: u = T_.s - U x with x = M V_s^T, v = T_r. - y V^T with y = U_r M.
// 2. If the pivot cancels, or the list is full: apply the list first, as one matrix product.
// 3. If (r, s) is in the list already, the exchange is undone: its row and column return to T.
// 4. Otherwise it is appended: M grows by one row and one column, by the inverse of a bordered matrix.
// An exchange with k listed ones costs 4 m k operations in place of 2 m^2.
// Literature: Golub and Van Loan, Matrix Computations, section 2.1 (Sherman-Morrison-Woodbury formula); principal pivoting:
// Cottle, Pang and Stone, The Linear Complementarity Problem (1992).
#include "linalg/delayed.hpp"

#include "linalg/dense.hpp"
#include "linalg/exchange.hpp"
#include "memory/hostile.hpp"
#include "memory/math.hpp"

namespace c2d {
namespace {

Real* column(const DelayedExchanges& d, int32_t j) { return d.t + static_cast<int64_t>(j) * d.rows; }

constexpr Real kRoundOff = sizeof(Real) == 8 ? Real(1e-14) : Real(1e-6);
// A pivot smaller than this part of the entry in T is a small difference of large numbers. M is an inverse, so it would carry
// that loss of digits into everything that follows.
constexpr double kCancels = 0.25;

// Places of the list's numbers: U (rows x most), V (cols x most), M and its inverse, the block of T in which rows and columns
// of the listed exchanges met (most x most), then column and row of the last pivot. The space behind M also serves as a buffer.
Real* list_left(const DelayedExchanges& d) { return d.numbers; }
Real* list_right(const DelayedExchanges& d) { return list_left(d) + static_cast<int64_t>(d.rows) * d.most; }
Real* list_middle(const DelayedExchanges& d) { return list_right(d) + static_cast<int64_t>(d.rows) * d.most; }
Real* list_corner(const DelayedExchanges& d) { return list_middle(d) + static_cast<int64_t>(d.most) * d.most; }
Real* last_column(const DelayedExchanges& d) { return list_corner(d) + static_cast<int64_t>(d.most) * d.most; }
Real* last_row(const DelayedExchanges& d) { return last_column(d) + d.rows; }
Real& left(const DelayedExchanges& d, int32_t i, int32_t k) { return list_left(d)[i + static_cast<int64_t>(k) * d.rows]; }
Real& right(const DelayedExchanges& d, int32_t j, int32_t k) { return list_right(d)[j + static_cast<int64_t>(k) * d.cols]; }
Real& middle(const DelayedExchanges& d, int32_t k, int32_t l) { return list_middle(d)[k + static_cast<int64_t>(l) * d.most]; }
Real& corner(const DelayedExchanges& d, int32_t k, int32_t l) { return list_corner(d)[k + static_cast<int64_t>(l) * d.most]; }

// x = M V_j^T and y = U_i M, times a factor.
void by_column(const DelayedExchanges& d, int32_t j, Real factor, Real* out) {
  for (int32_t k = 0; k < d.count; ++k) out[k] = 0;
  for (int32_t l = 0; l < d.count; ++l) {
    const Real by = factor * right(d, j, l), *const from = &middle(d, 0, l);
    for (int32_t k = 0; k < d.count && by != 0; ++k) out[k] += from[k] * by;
  }
}
void by_row(const DelayedExchanges& d, int32_t i, Real* out) {
  Real u[kMostDelayed];
  for (int32_t k = 0; k < d.count; ++k) u[k] = left(d, i, k);
  for (int32_t l = 0; l < d.count; ++l) {
    const Real* const from = &middle(d, 0, l);
    // Two sums, so that an addition does not wait for the one before it; the order is fixed, so the bits are.
    Real even = 0, odd = 0;
    for (int32_t k = 0; k < d.count; k += 2) even += u[k] * from[k];
    for (int32_t k = 1; k < d.count; k += 2) odd += u[k] * from[k];
    out[l] = even + odd;
  }
}

void subtract(const DelayedExchanges& d, const Engine& engine, int32_t n, const Real* list, const Real* by, Real* x) {
  gemm_minus(engine, n, 1, d.count, list, n, by, d.count, x, n);
}

void scale(const Engine& engine, int32_t n, Real factor, Real* x) {
  if (!kSmallCode && engine.kernel) return engine.kernel->scale(n, factor, x);
  for (int32_t i = 0; i < n; ++i) x[i] *= factor;
}

// Column and row of the tableau from x and y: T_.j - U x and T_i. - y V^T.
void read_column(const DelayedExchanges& d, const Engine& engine, int32_t j, const Real* by, Real* out) {
  const Real* const from = column(d, j);
  for (int32_t i = 0; i < d.rows; ++i) out[i] = from[i];
  subtract(d, engine, d.rows, list_left(d), by, out);
}
void read_row(const DelayedExchanges& d, const Engine& engine, int32_t i, const Real* by, Real* out) {
  for (int32_t j = 0; j < d.cols; ++j) out[j] = column(d, j)[i];
  subtract(d, engine, d.cols, list_right(d), by, out);
}

} // namespace

void read_column(const DelayedExchanges& d, const Engine& engine, int32_t j, Real* out) {
  Real by[kMostDelayed];
  by_column(d, j, 1, by);
  read_column(d, engine, j, by, out);
}

void read_row(const DelayedExchanges& d, const Engine& engine, int32_t i, Real* out) {
  Real by[kMostDelayed];
  by_row(d, i, by);
  read_row(d, engine, i, by, out);
}

Real read_entry(const DelayedExchanges& d, int32_t i, int32_t j) {
  Real by[kMostDelayed], sum = column(d, j)[i];
  by_column(d, j, 1, by);
  for (int32_t k = 0; k < d.count; ++k) sum -= left(d, i, k) * by[k];
  return sum;
}

// The list's part of many columns is summed as coefficients first: one product with U serves all of them.
void add_before_list(const DelayedExchanges& d, int32_t j, Real factor, Real* y, Real* by) {
  Real own[kMostDelayed];
  by_column(d, j, factor, own);
  for (int32_t k = 0; k < d.count; ++k) by[k] += own[k];
  const Real* const from = column(d, j);
  for (int32_t i = 0; i < d.rows; ++i) y[i] += factor * from[i];
}

void subtract_list(const DelayedExchanges& d, const Engine& engine, const Real* by, Real* y) {
  subtract(d, engine, d.rows, list_left(d), by, y);
}

void add_column_to(const DelayedExchanges& d, const Engine& engine, int32_t j, Real factor, Real* y) {
  Real by[kMostDelayed] = {};
  add_before_list(d, j, factor, y, by);
  subtract_list(d, engine, by, y);
}

// The exchange of (r, c) can be undone only if its row and column are as the exchange left them: a unit vector in U, minus a
// unit vector in V, zero in T. A combination of rows or columns in the meantime has mixed them with others.
int32_t place_in_list(const DelayedExchanges& d, int32_t r, int32_t c) {
  int32_t place = -1;
  for (int32_t k = 0; k < d.count; ++k) {
    if (left(d, r, k) == 0) continue;
    if (place >= 0) return -1;
    place = k;
  }
  if (place < 0 || fabs(static_cast<double>(left(d, r, place) - 1)) > kRoundOff) return -1;
  for (int32_t k = 0; k < d.count; ++k)
    if (fabs(static_cast<double>(right(d, c, k) + (k == place ? 1 : 0))) > (k == place ? kRoundOff : 0)) return -1;
  for (int32_t i = 0; i < d.rows; ++i)
    if (column(d, c)[i] != 0) return -1;
  for (int32_t j = 0; j < d.cols; ++j)
    if (column(d, j)[r] != 0) return -1;
  return place;
}

namespace {

// Moves row r of T to the list in one pass, since each of its numbers is on another page of memory. Returns its entry in
// column c.
Real put_row_by(const DelayedExchanges& d, int32_t r, int32_t c) {
  const Real met = column(d, c)[r];
  for (int32_t j = 0; j < d.cols; ++j) {
    Real& there = column(d, j)[r];
    right(d, j, d.count) = there;
    there = 0;
  }
  return met;
}

// Appends an exchange. x, y: M V_c^T and U_r M. Column c of T moves to the list as well; row r of U and row c of V become unit
// vectors, because row and column now consist of the new numbers alone.
void add_exchange(DelayedExchanges& d, int32_t r, int32_t c, Real met, Real pivot, const Real* x, const Real* y) {
  const int32_t n = d.count;
  corner(d, n, n) = met;
  for (int32_t k = 0; k < n; ++k) {
    corner(d, n, k) = left(d, r, k);
    corner(d, k, n) = right(d, c, k);
    left(d, r, k) = right(d, c, k) = 0;
  }
  for (int32_t l = 0; l < n; ++l) {
    Real* const to = &middle(d, 0, l);
    const Real by = y[l] / pivot;
    for (int32_t k = 0; k < n; ++k) to[k] += x[k] * by;
    to[n] = -by;
    middle(d, l, n) = -x[l] / pivot;
  }
  middle(d, n, n) = 1 / pivot;
  for (int32_t i = 0; i < d.rows; ++i) {
    left(d, i, n) = column(d, c)[i];
    column(d, c)[i] = 0;
  }
  left(d, r, n) = 1;
  right(d, c, n) = -1;
  ++d.count;
}

// Moves the last of n rows and columns to `place`, which keeps the matrix without gaps.
void move_last(Real* matrix, int64_t ld, int32_t n, int32_t place) {
  for (int32_t k = 0; k < n; ++k) matrix[place + k * ld] = matrix[n - 1 + k * ld];
  for (int32_t k = 0; k < n - 1; ++k) matrix[k + place * ld] = matrix[k + (n - 1) * ld];
}

// Undoes the listed exchange at `place`: M loses its row and column by the reverse of the bordered inverse, and row r and
// column c of T return to what they were.
void take_exchange(DelayedExchanges& d, int32_t r, int32_t c, int32_t place) {
  const int32_t n = d.count;
  const Real pivot = middle(d, place, place), met = corner(d, place, place);
  for (int32_t k = 0; k < n; ++k) {
    left(d, r, k) = corner(d, place, k);
    right(d, c, k) = corner(d, k, place);
  }
  // M without this exchange: M - M_.k M_k. / M_kk, the inverse of the block without its row and column.
  const Real* const out = &middle(d, 0, place);
  for (int32_t l = 0; l < n; ++l) {
    Real* const to = &middle(d, 0, l);
    const Real by = to[place] / pivot;
    for (int32_t k = 0; k < n && l != place; ++k) to[k] -= out[k] * by;
  }
  for (int32_t i = 0; i < d.rows; ++i) {
    column(d, c)[i] = left(d, i, place);
    left(d, i, place) = left(d, i, n - 1);
  }
  for (int32_t j = 0; j < d.cols; ++j) {
    column(d, j)[r] = right(d, j, place);
    right(d, j, place) = right(d, j, n - 1);
  }
  column(d, c)[r] = met;
  move_last(list_middle(d), d.most, n, place);
  move_last(list_corner(d), d.most, n, place);
  --d.count;
}

} // namespace

bool delay_exchange(DelayedExchanges& d, const Engine& engine, int32_t r, int32_t c, const Real** u, const Real** v) {
  C2D_ASSERT(d.most > 0 && d.most <= kMostDelayed && r >= 0 && r < d.rows && c >= 0 && c < d.cols && d.cols <= d.rows);
  int32_t place = place_in_list(d, r, c);
  if (d.count == d.most && place < 0) apply_delayed(d, engine);
  Real x[kMostDelayed], y[kMostDelayed], *const pivot_column = last_column(d), *const pivot_row = last_row(d);
  by_column(d, c, 1, x);
  read_column(d, engine, c, x, pivot_column);
  // The test compares with T itself: a pivot that is small there, too, is small without cancellation. (For a listed exchange T
  // has a zero here, so the test does not apply.)
  if (fabs(static_cast<double>(pivot_column[r])) < kCancels * fabs(static_cast<double>(column(d, c)[r]))) {
    apply_delayed(d, engine);
    read_column(d, engine, c, x, pivot_column);
  }
  const Real pivot = pivot_column[r];
  if ((pivot < 0 ? -pivot : pivot) < kSmallestReal) return false;
  by_row(d, r, y);
  // From here on nothing can fail, so the list may change.
  const Real met = place < 0 ? put_row_by(d, r, c) : Real(0);
  for (int32_t j = 0; j < d.cols; ++j) pivot_row[j] = place < 0 ? right(d, j, d.count) : Real(0); // undone: T has no part of it
  subtract(d, engine, d.cols, list_right(d), y, pivot_row);
  if (place >= 0)
    take_exchange(d, r, c, place);
  else
    add_exchange(d, r, c, met, pivot, x, y);
  // The caller updates its own vectors by the same rank-one change, with u scaled as METHOD (11.3) has it.
  scale(engine, d.rows, 1 / pivot, pivot_column);
  pivot_column[r] = 1 / pivot;
  pivot_row[c] = -1;
  *u = pivot_column;
  *v = pivot_row;
  return true;
}

// A combination of rows applies to T and U, one of columns to T and V: the product U M V^T follows.
void delayed_row_add(DelayedExchanges& d, int32_t target, int32_t source, Real factor) {
  row_add(d.cols, d.t, d.rows, target, source, factor);
  row_add(d.count, list_left(d), d.rows, target, source, factor);
}

void delayed_column_add(DelayedExchanges& d, int32_t target, int32_t source, Real factor) {
  column_add(d.rows, d.t, d.rows, target, source, factor);
  row_add(d.count, list_right(d), d.cols, target, source, factor);
}

namespace {

void swap_columns(int64_t n, Real* a, Real* b) {
  for (int64_t i = 0; i < n; ++i) {
    const Real kept = a[i];
    a[i] = b[i];
    b[i] = kept;
  }
}

void swap_places(const DelayedExchanges& d, int32_t a, int32_t b) {
  if (a == b) return;
  swap_columns(d.rows, &left(d, 0, a), &left(d, 0, b));
  swap_columns(d.cols, &right(d, 0, a), &right(d, 0, b));
  swap_columns(d.count, &middle(d, 0, a), &middle(d, 0, b));
  for (int32_t l = 0; l < d.count; ++l) {
    const Real kept = middle(d, a, l);
    middle(d, a, l) = middle(d, b, l);
    middle(d, b, l) = kept;
  }
}

// The exchanges that stay go behind the others, and their rows and columns of M change places (METHOD 11): the rest of M is
// then what the other exchanges alone would have given. Returns the place of the first of them. One that would leave little of
// a pivot does not stay.
int32_t set_aside(const DelayedExchanges& d, const Engine& engine, const bool* kept) {
  int32_t first = d.count;
  for (int32_t k = d.count - 1; k >= 0 && kept; --k) {
    if (!kept[k] || fabs(static_cast<double>(middle(d, k, k) * corner(d, k, k))) < kCancels) continue;
    swap_places(d, k, --first);
    exchange(d.count, d.count, list_middle(d), d.most, first, first, engine.kernel);
  }
  return first;
}

// U and V of the exchanges that stay: columns and rows of T as it will be after the others are applied.
void bring_up(const DelayedExchanges& d, const Engine& engine, int32_t first) {
  const int32_t kept = d.count - first;
  for (int32_t k = first; k < d.count; ++k)
    for (int32_t l = 0; l < first; ++l) middle(d, l, k) = -middle(d, l, k);
  gemm_minus(engine, d.rows, kept, first, list_left(d), d.rows, &middle(d, 0, first), d.most, &left(d, 0, first), d.rows);
  outer_minus(engine, d.cols, kept, first, list_right(d), d.cols, &middle(d, first, 0), d.most, &right(d, 0, first), d.cols);
}

// U := U M for the first n exchanges, in slices of rows that fit into the space behind M, which nothing else uses any more.
void multiply(const DelayedExchanges& d, const Engine& engine, int32_t n) {
  constexpr int32_t kTiles = 24; // rows of a tile, a multiple for any kernel
  Real* const product = list_corner(d);
  const int64_t room = n > 0 ? (static_cast<int64_t>(d.most) * d.most + 2 * d.rows) / n : 0;
  const int32_t most = static_cast<int32_t>(room < kTiles ? room : room - room % kTiles);
  for (int32_t top = 0; top < d.rows && n > 0; top += most) {
    const int32_t some = d.rows - top < most ? d.rows - top : most;
    for (int32_t i = 0; i < n * some; ++i) product[i] = 0;
    gemm_minus(engine, some, n, n, list_left(d) + top, d.rows, list_middle(d), d.most, product, some);
    for (int32_t k = 0; k < n; ++k)
      for (int32_t i = 0; i < some; ++i) left(d, top + i, k) = -product[i + static_cast<int64_t>(k) * some];
  }
}

// The exchanges that stay become the list.
void take_back(DelayedExchanges& d, const Engine& engine, int32_t first) {
  const int32_t kept = d.count - first;
  for (int32_t l = 0; l < kept; ++l) {
    for (int32_t i = 0; i < d.rows; ++i) left(d, i, l) = left(d, i, first + l);
    for (int32_t j = 0; j < d.cols; ++j) right(d, j, l) = right(d, j, first + l);
    for (int32_t k = 0; k < kept; ++k) corner(d, k, l) = middle(d, k, l) = middle(d, first + k, first + l);
  }
  d.count = kept;
  for (int32_t k = 0; k < kept; ++k) exchange(kept, kept, list_middle(d), d.most, k, k, engine.kernel);
}

} // namespace

void apply_all_but(DelayedExchanges& d, const Engine& engine, const bool* kept) {
  // Two products in place of one exchange after another: T passes through memory once.
  const int32_t first = set_aside(d, engine, kept);
  if (first < d.count) bring_up(d, engine, first);
  multiply(d, engine, first);
  outer_minus(engine, d.rows, d.cols, first, list_left(d), d.rows, list_right(d), d.cols, d.t, d.rows);
  take_back(d, engine, first);
}

void apply_delayed(DelayedExchanges& d, const Engine& engine) { apply_all_but(d, engine, nullptr); }

} // namespace c2d
