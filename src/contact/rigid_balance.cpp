#include "contact/rigid_balance.hpp"

#include <math.h>

#include "contact/start.hpp"
#include "linalg/dense.hpp"

namespace c2d {

namespace {

using Matrix = ContactMatrix;

static_assert(kMostMotions < kStripColumns, "a column of the strip stays free beside the motions");

Real* strip_column(const Reduction& r, int32_t j) { return r.strip + static_cast<int64_t>(j) * r.tape.m; }

double product(const Real* a, const Real* b, int32_t n) {
  double sum = 0.0;
  for (int32_t i = 0; i < n; ++i) sum += static_cast<double>(a[i]) * b[i];
  return sum;
}

// x[0 ... count) of m numbers, made orthonormal; the same sums of y (or null). Twice, so that they are so to the last digit.
void orthonormalise(int32_t m, int32_t count, Real* x, Real* y) {
  const auto subtract = [m](Real* from, double part, const Real* what) {
    for (int32_t i = 0; i < m; ++i) from[i] -= static_cast<Real>(part * static_cast<double>(what[i]));
  };
  const auto divide = [m](Real* v, double by) {
    for (int32_t i = 0; i < m; ++i) v[i] = static_cast<Real>(static_cast<double>(v[i]) / by);
  };
  for (int64_t j = 0; j < count; ++j) {
    Real* v = x + j * m;
    for (int pass = 0; pass < 2; ++pass) {
      for (int64_t k = 0; k < j; ++k) {
        const double part = product(x + k * m, v, m);
        subtract(v, part, x + k * m);
        if (y) subtract(y + j * m, part, y + k * m);
      }
      const double size = sqrt(product(v, v, m));
      if (size > 0.0) divide(v, size);
      if (size > 0.0 && y) divide(y + j * m, size);
    }
  }
}

// The motions of the pairs under each free motion of the body.
void rigid_columns(const Reduction& r, const Body& body) {
  const Model& m = r.model;
  for (int32_t j = 0; j < body.free_motions; ++j)
    for (int32_t i = 0; i < m.head->pairs; ++i) {
      const Pair& pair = m.pair[i];
      double w[2];
      motion_at_pair(m, floating_body(r), body.free_motion[j], body.centre, pair, w);
      for (int32_t d = 0; d <= pair.tangential; ++d) strip_column(r, j)[pair.dof + d] = static_cast<Real>(w[d]);
    }
  orthonormalise(r.tape.m, body.free_motions, r.strip, nullptr);
}

// As many contact unknowns as there are motions, which together hold them best.
void choose_holders(const Reduction& r, int32_t count, int32_t* holder) {
  double taken[kMostMotions][kMostMotions] = {};
  for (int32_t k = 0; k < count; ++k) {
    double most = -1.0, best[kMostMotions] = {};
    for (int32_t i = 0; i < r.tape.m; ++i) {
      double row[kMostMotions];
      for (int32_t j = 0; j < count; ++j) row[j] = strip_column(r, j)[i];
      for (int32_t t = 0; t < k; ++t) {
        double part = 0.0;
        for (int32_t j = 0; j < count; ++j) part += taken[t][j] * row[j];
        for (int32_t j = 0; j < count; ++j) row[j] -= part * taken[t][j];
      }
      double size = 0.0;
      for (int32_t j = 0; j < count; ++j) size += row[j] * row[j];
      if (size <= most) continue;
      most = size;
      holder[k] = i;
      for (int32_t j = 0; j < count; ++j) best[j] = row[j] / sqrt(size > 0.0 ? size : 1.0);
    }
    for (int32_t j = 0; j < count; ++j) taken[k][j] = best[j];
  }
}

void sort(int32_t count, int32_t* holder) {
  for (int32_t k = 1; k < count; ++k)
    for (int32_t j = k; j > 0 && holder[j] < holder[j - 1]; --j) {
      const int32_t kept = holder[j];
      holder[j] = holder[j - 1];
      holder[j - 1] = kept;
    }
}

void exchange(Real* x, int64_t i, int64_t j) {
  const Real kept = x[i];
  x[i] = x[j];
  x[j] = kept;
}

// S_u of the body in `first`, factored but for the columns of the holders, which stand last: S_u maps their motion to nothing
// that the other columns do not map to. False: there is more that meets no resistance.
bool factor_held(const Reduction& r, int32_t count, const int32_t* holder) {
  const int32_t m = r.tape.m, held = m - count;
  Real* s = r.first;
  for (int32_t k = count - 1; k >= 0; --k)
    for (int32_t i = 0; i < m; ++i) exchange(s + i, static_cast<int64_t>(holder[k]) * m, static_cast<int64_t>(held + k) * m);
  for (int32_t j = 0; j < m; ++j) r.strip[j] = largest(r.engine, m, s + static_cast<int64_t>(j) * m);
  PivotStats stats;
  start_stats(stats);
  if (lu_panel({r.engine, m, held, m, s, m, r.pivots, r.strip, &stats}) != 0) return false;
  lu_settle(m, held, s, m, r.pivots);
  return true;
}

// R in the strip: each holder moves by one as the others rest.
void find_motions(const Reduction& r, int32_t count, const int32_t* holder) {
  const int32_t m = r.tape.m, held = m - count;
  for (int32_t k = 0; k < count; ++k) {
    Real* x = strip_column(r, k);
    for (int32_t i = 0; i < held; ++i) x[i] = -r.first[static_cast<int64_t>(held + k) * m + i];
    for (int32_t i = held; i < m; ++i) x[i] = i == held + k ? Real(1) : Real(0);
    trsm_upper(r.engine, held, 1, r.first, m, x, m);
    for (int32_t j = 0; j < count; ++j) exchange(x, holder[j], held + j);
  }
  orthonormalise(m, count, r.strip, nullptr);
}

// E in the strip, from E^T P^T L = 0: the equations that are left over, and what they take of the others.
void find_equilibrium(const Reduction& r, int32_t count) {
  const int32_t m = r.tape.m, held = m - count;
  for (int32_t k = 0; k < count; ++k) {
    Real* e = strip_column(r, k);
    for (int32_t i = 0; i < m; ++i) e[i] = i == held + k ? Real(1) : Real(0);
    for (int32_t j = held - 1; j >= 0; --j)
      e[j] = static_cast<Real>(-product(r.first + static_cast<int64_t>(j) * m + j + 1, e + j + 1, m - j - 1));
    for (int32_t j = held - 1; j >= 0; --j) exchange(e, j, r.pivots[j]);
  }
}

int32_t motions(const Reduction& r) { return r.model.head->body[floating_body(r)].free_motions; }

Matrix of_floating(const Reduction& r, Matrix first_body) {
  return static_cast<Matrix>(static_cast<int32_t>(first_body) + 3 * floating_body(r));
}
// G, orthonormal, in place of what is in `first`, and E to match in the strip.
c2d_status find_resultants(const Reduction& r, int32_t count) {
  const int32_t m = r.tape.m;
  Real *column = strip_column(r, kMostMotions), *g = r.first;
  const double side = floating_body(r) == 1 ? 1.0 : -1.0; // body 1 carries -tau
  c2d_status status = C2D_OK;
  for (int32_t j = 0; j < m && status == C2D_OK; ++j) {
    status = read_column(r.tape, of_floating(r, Matrix::traction1), j, column);
    for (int32_t k = 0; k < count; ++k)
      g[static_cast<int64_t>(k) * m + j] = static_cast<Real>(side * product(strip_column(r, k), column, m));
  }
  orthonormalise(m, count, g, r.strip);
  return status;
}

// Columns to the tape, the rest of three as zeros.
c2d_status keep(const Reduction& r, Matrix matrix, int32_t count, const Real* columns) {
  Real* none = strip_column(r, kMostMotions);
  for (int32_t i = 0; i < r.tape.m; ++i) none[i] = 0;
  c2d_status status = C2D_OK;
  for (int32_t k = 0; k < kMostMotions && status == C2D_OK; ++k)
    status = write_column(r.tape, matrix, k, k < count ? columns + static_cast<int64_t>(k) * r.tape.m : none);
  return status;
}

c2d_status fetch(const Reduction& r, Matrix matrix, Real* columns) {
  c2d_status status = C2D_OK;
  for (int32_t k = 0; k < motions(r) && status == C2D_OK; ++k)
    status = read_column(r.tape, matrix, k, columns + static_cast<int64_t>(k) * r.tape.m);
  return status;
}

// T (I - R R^T), R in the strip.
void remove_motions(const Reduction& r, int32_t count) {
  const int32_t m = r.tape.m;
  Real* response = strip_column(r, kMostMotions);
  for (int32_t k = 0; k < count; ++k) {
    const Real* motion = strip_column(r, k);
    for (int32_t i = 0; i < m; ++i) response[i] = 0;
    for (int32_t j = 0; j < m; ++j)
      for (int32_t i = 0; i < m; ++i) response[i] += motion[j] * r.first[static_cast<int64_t>(j) * m + i];
    for (int32_t j = 0; j < m; ++j)
      for (int32_t i = 0; i < m; ++i) r.first[static_cast<int64_t>(j) * m + i] -= response[i] * motion[j];
  }
}

// T := (I - G G^T) T, G in `second`.
void remove_resultants(const Reduction& r, int32_t count) {
  const int32_t m = r.tape.m;
  for (int32_t j = 0; j < m; ++j) {
    Real* column = r.first + static_cast<int64_t>(j) * m;
    for (int32_t k = 0; k < count; ++k) {
      const Real* g = r.second + static_cast<int64_t>(k) * m;
      const double part = product(g, column, m);
      for (int32_t i = 0; i < m; ++i) column[i] -= static_cast<Real>(part * static_cast<double>(g[i]));
    }
  }
}

} // namespace

c2d_status find_balance(const Reduction& r) {
  int32_t count = motions(r), holder[kMostMotions] = {};
  if (count > 0) {
    rigid_columns(r, r.model.head->body[floating_body(r)]);
    choose_holders(r, count, holder);
    sort(count, holder);
    const c2d_status status = read_matrix(r.tape, of_floating(r, Matrix::displacement1), r.first);
    if (status != C2D_OK) return status;
    if (!factor_held(r, count, holder)) count = 0; // what the pivots of the tableau say later decides
  }
  find_motions(r, count, holder);
  c2d_status status = keep(r, Matrix::motions, count, r.strip);
  find_equilibrium(r, count);
  if (status == C2D_OK) status = find_resultants(r, count);
  if (status == C2D_OK) status = keep(r, Matrix::resultants, count, r.first);
  return status == C2D_OK ? keep(r, Matrix::equilibrium, count, r.strip) : status;
}

c2d_status balance_stiffness(const Reduction& r) {
  const int32_t count = motions(r);
  c2d_status status = fetch(r, Matrix::motions, r.strip);
  if (status == C2D_OK) status = fetch(r, Matrix::resultants, r.second);
  if (status != C2D_OK) return status;
  remove_motions(r, count);
  remove_resultants(r, count);
  for (int64_t i = 0; i < static_cast<int64_t>(r.tape.m) * r.tape.m && count >= r.tape.m; ++i) r.first[i] = 0; // only motions
  return C2D_OK;
}

c2d_status balance_rate(const Reduction& r, int32_t k) {
  const int32_t m = r.tape.m;
  Real *b = r.strip, *s = strip_column(r, 1), *column = strip_column(r, 2);
  c2d_status status = motions(r) > 0 ? read_column(r.tape, of_floating(r, Matrix::load1), k, s) : c2d_status{C2D_OK};
  for (int32_t j = 0; j < motions(r) && status == C2D_OK; ++j) {
    status = read_column(r.tape, Matrix::equilibrium, j, column);
    const double g = product(column, s, m);
    if (status == C2D_OK) status = read_column(r.tape, Matrix::resultants, j, column);
    const double part = product(column, b, m) + g;
    for (int32_t i = 0; i < m; ++i) b[i] -= static_cast<Real>(part * static_cast<double>(column[i]));
  }
  return status;
}

} // namespace c2d
