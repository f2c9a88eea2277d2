// Interpolative decomposition A(:, rest) = A(:, S) X (METHOD 7.6): a few columns S of which all others are combinations, to a
// tolerance.
//
// Phases:
// 1. Sketch: samples (rows of A) arrive one after another. If there are more than columns + kSpare, each is added with random
//    signs to kSpread rows. Dependencies between columns survive this with near certainty.
// 2. Householder triangulation with column exchange: in each step the column with the largest remaining norm is reflected to
//    one number. It stops when that norm is below the tolerance.
// 3. X = R_1^-1 R_2 by back substitution in the triangle.
// Literature: Businger and Golub, Numer. Math. 7 (1965), and Golub and Van Loan, Matrix Computations, section 5.4 (QR with
// column pivoting); Cheng, Gimbutas, Martinsson and Rokhlin, SIAM J. Sci. Comput. 26 (2005) (interpolative decomposition);
// Martinsson and Tropp, Acta Numerica 29 (2020) (sparse sign sketches); Steele, Lea and Flood, OOPSLA 2014 (the generator).
#include "linalg/interpolate.hpp"

#include "memory/math.hpp"

namespace c2d {

namespace {

constexpr int32_t kSpare = 24; // rows beyond the columns: a sketch then preserves norms within a small factor
constexpr int32_t kSpread = 4; // rows to which a sample is added
constexpr uint64_t kStep = 0x9e3779b97f4a7c15u;

// A fixed pseudo-random sequence (splitmix64): the same on every machine, so that runs repeat bit by bit.
uint64_t mixed(uint64_t n) {
  uint64_t z = n * kStep;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

// y += factor x, and two of these in one pass.
void add_multiple(const Kernel* kernel, int32_t n, Real factor, const Real* x, Real* y) {
  if (kernel) return kernel->add(n, factor, x, y);
  for (int32_t j = 0; j < n; ++j) y[j] += factor * x[j];
}
void add_multiples(const Kernel* kernel, int32_t n, Real f, const Real* x, Real g, const Real* z, Real* y) {
  if (kernel) return kernel->add_two(n, f, x, g, z, y);
  for (int32_t j = 0; j < n; ++j) y[j] += f * x[j] + g * z[j];
}

void add_to_row(const SampleSum& sum, Real factor, const Real* x, int64_t step, Real* row) {
  if (step == 1) return add_multiple(sum.kernel, sum.columns, factor, x, row);
  for (int32_t j = 0; j < sum.columns; ++j) row[j] += factor * x[j * step];
}

Real largest_of(int32_t n, const Real* x, int64_t step) {
  Real most = 0;
  for (int32_t j = 0; j < n; ++j) {
    const Real size = fabs(x[j * step]);
    if (size > most) most = size;
  }
  return most;
}

} // namespace

int32_t rows_to_keep(int64_t samples, int32_t columns) {
  return samples < columns + kSpare ? static_cast<int32_t>(samples) : columns + kSpare;
}

SampleSum begin_samples(Real* w, int32_t columns, int64_t samples, const Kernel* kernel) {
  const int32_t rows = rows_to_keep(samples, columns);
  for (int64_t i = 0; i < static_cast<int64_t>(rows) * columns; ++i) w[i] = 0;
  return SampleSum{w, columns, rows, 0, samples, kernel};
}

void add_sample(SampleSum& sum, const Real* x, int64_t step, bool unit) {
  // Samples from far and near differ by orders of magnitude. Scaled to 1, each counts alike.
  const Real most = unit ? largest_of(sum.columns, x, step) : Real(1);
  const int64_t number = sum.taken++;
  if (!(most > kSmallestReal)) return;
  const Real factor = 1 / most;
  // Few samples: each has a row of its own, and nothing is random.
  if (sum.rows == sum.samples) {
    add_to_row(sum, factor, x, step, sum.w + number * sum.columns);
    return;
  }
  uint64_t bits = mixed(static_cast<uint64_t>(number) + 1);
  for (int32_t k = 0; k < kSpread; ++k, bits = mixed(bits)) {
    const int64_t row = static_cast<int64_t>((bits >> 33) % static_cast<uint64_t>(sum.rows));
    add_to_row(sum, (bits & 1) != 0 ? factor : -factor, x, step, sum.w + row * sum.columns);
  }
}

namespace {

struct Reflections {
  Real* w; // row by row
  int32_t rows, columns;
  Real* norms; // squared, of the remainder of each column
  int32_t* order;
  const Kernel* kernel;
  Real* row(int32_t i) const { return w + static_cast<int64_t>(i) * columns; }
};

// Squared norms of columns first ... in rows `first` and below. Row by row, since w is stored by rows.
void measure(const Reflections& r, int32_t first) {
  for (int32_t j = first; j < r.columns; ++j) r.norms[j] = 0;
  for (int32_t i = first; i < r.rows; ++i) {
    const Real* w = r.row(i);
    for (int32_t j = first; j < r.columns; ++j) r.norms[j] += w[j] * w[j];
  }
}

template <class Number> void exchange(Number& a, Number& b) {
  const Number kept = a;
  a = b;
  b = kept;
}

int32_t longest(const Reflections& r, int32_t first) {
  int32_t best = first;
  for (int32_t j = first + 1; j < r.columns; ++j)
    if (r.norms[j] > r.norms[best]) best = j;
  return best;
}

void exchange_columns(const Reflections& r, int32_t a, int32_t b) {
  if (a == b) return;
  for (int32_t i = 0; i < r.rows; ++i) exchange(r.row(i)[a], r.row(i)[b]);
  exchange(r.norms[a], r.norms[b]);
  exchange(r.order[a], r.order[b]);
}

// Householder reflection of column k to one number, applied to all columns to the right of it. Row k is then a row of R.
// `work` [columns].
void reflect(const Reflections& r, int32_t k, Real* work) {
  Real sum = 0;
  for (int32_t i = k; i < r.rows; ++i) sum += r.row(i)[k] * r.row(i)[k];
  const Real top = r.row(k)[k], norm = static_cast<Real>(sqrt(static_cast<double>(sum)));
  // The sign avoids cancellation in the head of v.
  const Real beta = top > 0 ? -norm : norm, head = top - beta; // v = column - beta e, v.v = -2 beta head
  const Real scale = 1 / (beta * head);                        // -2 / v.v
  r.row(k)[k] = head;
  const int32_t right = k + 1, rest = r.columns - right;
  for (int32_t j = 0; j < rest; ++j) work[j] = 0;
  int32_t i = k;
  // work = v^T A, two rows at a time: `work` then passes through memory half as often.
  for (; i + 1 < r.rows; i += 2)
    add_multiples(r.kernel, rest, r.row(i)[k], r.row(i) + right, r.row(i + 1)[k], r.row(i + 1) + right, work);
  if (i < r.rows) add_multiple(r.kernel, rest, r.row(i)[k], r.row(i) + right, work);
  for (int32_t j = 0; j < rest; ++j) work[j] *= scale;
  for (i = k; i < r.rows; ++i) add_multiple(r.kernel, rest, r.row(i)[k], work, r.row(i) + right);
  r.row(k)[k] = beta;
  // Norms of what is left, by downdating. choose() measures anew before cancellation spoils them.
  const Real* w = r.row(k);
  for (int32_t j = k + 1; j < r.columns; ++j) r.norms[j] -= w[j] * w[j];
}

// Divides every column by its norm, which scale[] stores.
void scale_columns(const Reflections& r, Real* scale) {
  for (int32_t j = 0; j < r.columns; ++j) {
    const Real norm = static_cast<Real>(sqrt(static_cast<double>(r.norms[j])));
    scale[j] = norm > kSmallestReal ? norm : Real(1);
  }
  for (int32_t i = 0; i < r.rows; ++i)
    for (int32_t j = 0; j < r.columns; ++j) r.row(i)[j] /= scale[j];
}

// X = R_1^-1 R_2; R_1 is the leading triangle of the first k rows of w.
void solve_columns(const Reflections& r, int32_t k, Real* x) {
  const int32_t rest = r.columns - k;
  for (int32_t i = k - 1; i >= 0; --i) {
    Real* own = r.row(i);
    const Real pivot = own[i];
    for (int32_t j = k; j < r.columns; ++j) own[j] /= pivot;
    for (int32_t above = 0; above < i; ++above) {
      Real* w = r.row(above);
      add_multiple(r.kernel, rest, -w[i], own + k, w + k);
    }
  }
  for (int32_t j = 0; j < rest; ++j)
    for (int32_t i = 0; i < k; ++i) x[i + static_cast<int64_t>(j) * k] = r.row(i)[k + j];
}

// Reflects until the largest remaining column is below the tolerance. Returns the number of columns chosen.
int32_t choose(const Reflections& r, double tolerance, int32_t most, Real* work) {
  const double enough = 1e-9 * (sizeof(Real) == sizeof(double) ? 1.0 : 1e5); // below, differences of squares lack digits
  const int32_t end = r.rows < r.columns ? r.rows : r.columns;
  double first = 0.0, measured = 0.0;
  for (int32_t k = 0; k < end; ++k) {
    int32_t best = longest(r, k);
    if (k == 0 || static_cast<double>(r.norms[best]) < enough * measured) {
      measure(r, k);
      best = longest(r, k);
      measured = static_cast<double>(r.norms[best]);
    }
    const double left = static_cast<double>(r.norms[best]);
    if (k == 0) first = left;
    if (!(left > tolerance * tolerance * first) || !(left > static_cast<double>(kSmallestReal))) return k;
    if (k == most) return most + 1;
    exchange_columns(r, k, best);
    reflect(r, k, work);
  }
  return end;
}

} // namespace

int32_t interpolate(SampleSum& sum, double tolerance, bool relative, int32_t most, int32_t* order, Real* norms, Real* x) {
  // Until x is filled it serves for the scales and for one row: it has columns^2 numbers.
  const Reflections r{sum.w, sum.rows, sum.columns, norms, order, sum.kernel};
  for (int32_t j = 0; j < r.columns; ++j) order[j] = j;
  Real *scale = x, *work = x + r.columns;
  measure(r, 0);
  if (relative) scale_columns(r, scale);
  const int32_t k = choose(r, tolerance, most, work);
  if (k > most) return k;
  if (relative) { // back to the unscaled columns
    for (int32_t j = 0; j < r.columns; ++j) norms[j] = scale[order[j]];
    for (int32_t i = 0; i < k; ++i)
      for (int32_t j = i; j < r.columns; ++j) r.row(i)[j] *= norms[j];
  }
  solve_columns(r, k, x);
  return k;
}

} // namespace c2d
