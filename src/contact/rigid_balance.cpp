#include "contact/rigid_balance.hpp"

#include <math.h>

#include "contact/start.hpp"

namespace c2d {

namespace {

static_assert(kMostMotions < kStripColumns, "a column of the strip stays free beside the motions");

Real* strip_column(const Reduction& r, int32_t j) { return r.strip + static_cast<int64_t>(j) * r.tape.m; }

double product(const Real* a, const Real* b, int32_t n) {
  double sum = 0.0;
  for (int32_t i = 0; i < n; ++i) sum += static_cast<double>(a[i]) * b[i];
  return sum;
}

// Columns first ... of the strip, orthonormal; twice, so that they are so to the last digit.
void orthonormalise(const Reduction& r, int32_t count) {
  const int32_t m = r.tape.m;
  for (int32_t j = 0; j < count; ++j) {
    Real* v = strip_column(r, j);
    for (int pass = 0; pass < 2; ++pass) {
      for (int32_t k = 0; k < j; ++k) {
        const Real* u = strip_column(r, k);
        const double part = product(u, v, m);
        for (int32_t i = 0; i < m; ++i) v[i] -= static_cast<Real>(part * u[i]);
      }
      const double size = sqrt(product(v, v, m));
      for (int32_t i = 0; i < m && size > 0.0; ++i) v[i] = static_cast<Real>(v[i] / size);
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
  orthonormalise(r, body.free_motions);
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

// (I - G G^T) T, G in the strip.
void remove_resultants(const Reduction& r, int32_t count) {
  const int32_t m = r.tape.m;
  for (int32_t j = 0; j < m; ++j) {
    Real* column = r.first + static_cast<int64_t>(j) * m;
    for (int32_t k = 0; k < count; ++k) {
      const Real* g = strip_column(r, k);
      const double part = product(g, column, m);
      for (int32_t i = 0; i < m; ++i) column[i] -= static_cast<Real>(part * g[i]);
    }
  }
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

// T, or its transpose, in `second`, with the rows and columns of the holders replaced by those of the identity: what is left
// by holding so many unknowns is regular.
bool factor_held(const Reduction& r, bool transposed, int32_t count, const int32_t* holder) {
  const int32_t m = r.tape.m;
  for (int32_t j = 0; j < m; ++j)
    for (int32_t i = 0; i < m; ++i)
      r.second[static_cast<int64_t>(j) * m + i] =
          transposed ? r.first[static_cast<int64_t>(i) * m + j] : r.first[static_cast<int64_t>(j) * m + i];
  for (int32_t k = 0; k < count; ++k)
    for (int32_t i = 0; i < m; ++i) {
      r.second[static_cast<int64_t>(i) * m + holder[k]] = r.second[static_cast<int64_t>(holder[k]) * m + i] = 0;
      if (i == holder[k]) r.second[static_cast<int64_t>(i) * m + i] = 1;
    }
  return lu_factor(r.engine, m, r.second, m, r.pivots, r.strip, nullptr) == 0;
}

// Vectors x with T x = 0, or x^T T = 0, in the strip: one for each holder, which moves by one as the other holders rest.
void null_columns(const Reduction& r, bool transposed, int32_t count, const int32_t* holder) {
  const int32_t m = r.tape.m;
  for (int32_t k = 0; k < count; ++k) {
    Real* x = strip_column(r, k);
    for (int32_t i = 0; i < m; ++i)
      x[i] =
          -(transposed ? r.first[static_cast<int64_t>(i) * m + holder[k]] : r.first[static_cast<int64_t>(holder[k]) * m + i]);
    for (int32_t j = 0; j < count; ++j) x[holder[j]] = j == k ? Real(1) : Real(0);
    lu_solve(r.engine, m, 1, r.second, m, r.pivots, x, m);
  }
  orthonormalise(r, count);
}

c2d_status keep_resultants(const Reduction& r, int32_t count) {
  c2d_status status = C2D_OK;
  for (int32_t k = 0; k < kMostMotions && status == C2D_OK; ++k) {
    Real* g = strip_column(r, k);
    for (int32_t i = 0; i < r.tape.m && k >= count; ++i) g[i] = 0;
    status = write_column(r.tape, ContactMatrix::resultants, k, g);
  }
  return status;
}

} // namespace

c2d_status balance_stiffness(const Reduction& r) {
  const Body& body = r.model.head->body[floating_body(r)];
  int32_t count = body.free_motions, holder[kMostMotions] = {};
  if (count >= r.tape.m && count > 0) { // nothing but motions
    for (int64_t i = 0; i < static_cast<int64_t>(r.tape.m) * r.tape.m; ++i) r.first[i] = 0;
    for (int64_t i = 0; i < static_cast<int64_t>(r.tape.m) * kMostMotions; ++i) r.strip[i] = 0;
    for (int32_t k = 0; k < r.tape.m; ++k) strip_column(r, k)[k] = 1;
    count = kMostMotions;
  } else if (count > 0) {
    rigid_columns(r, body);
    choose_holders(r, count, holder);
    const bool held = factor_held(r, false, count, holder);
    if (held) {
      null_columns(r, false, count, holder);
      remove_motions(r, count);
    }
    if (held && factor_held(r, true, count, holder)) {
      null_columns(r, true, count, holder);
      remove_resultants(r, count);
    } else {
      count = 0; // T is singular beyond the motions: what its pivots say later decides
    }
  }
  return keep_resultants(r, count);
}

} // namespace c2d
