#include "contact/reduction/body_compliance.hpp"
#include "contact/body_unknowns.hpp"

#include "contact/reduction/orthonormal.hpp"
#include "contact/start.hpp"
#include "linalg/dense.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"

namespace c2d {

C2D_USES(RigidPart);

namespace {

static_assert(kMostMotions < kStripColumns, "a column of the strip stays free beside the motions");

// S_u of a body in r.first, and how it is held.
struct BodyEquations {
  const Reduction& r;
  int b;
  int32_t n, count; // contact unknowns; motions
  int32_t holder[kMostMotions];
  int32_t held() const { return n - count; }
  Real* strip(int32_t j) const { return r.strip + static_cast<int64_t>(j) * n; }
};

// Displacements under each free motion of the body.
void rigid_columns(const BodyEquations& e) {
  for (int32_t j = 0; j < e.count; ++j) motion_column(e.r.model, e.b, j, e.strip(j));
  orthonormalise(e.n, e.count, e.r.strip, 0, nullptr);
}

// The unknown at which the motions left over by the ones taken move farthest.
void choose_holder(const BodyEquations& e, double taken[kMostMotions][kMostMotions], int32_t k, int32_t* holder) {
  double most = -1.0, best[kMostMotions] = {};
  for (int32_t i = 0; i < e.n; ++i) {
    double row[kMostMotions];
    for (int32_t j = 0; j < e.count; ++j) row[j] = e.strip(j)[i];
    for (int32_t t = 0; t < k; ++t) {
      double part = 0.0;
      for (int32_t j = 0; j < e.count; ++j) part += taken[t][j] * row[j];
      for (int32_t j = 0; j < e.count; ++j) row[j] -= part * taken[t][j];
    }
    double size = 0.0;
    for (int32_t j = 0; j < e.count; ++j) size += row[j] * row[j];
    if (size <= most) continue;
    most = size;
    holder[k] = i;
    for (int32_t j = 0; j < e.count; ++j) best[j] = row[j] / sqrt(size > 0.0 ? size : 1.0);
  }
  for (int32_t j = 0; j < e.count; ++j) taken[k][j] = best[j];
}

// As many contact unknowns as there are motions, which together hold them best, in ascending order.
void choose_holders(BodyEquations& e) {
  double taken[kMostMotions][kMostMotions] = {};
  for (int32_t k = 0; k < e.count; ++k) choose_holder(e, taken, k, e.holder);
  for (int32_t k = 1; k < e.count; ++k)
    for (int32_t j = k; j > 0 && e.holder[j] < e.holder[j - 1]; --j) {
      const int32_t kept = e.holder[j];
      e.holder[j] = e.holder[j - 1];
      e.holder[j - 1] = kept;
    }
}

void exchange(Real* x, int64_t i, int64_t j) {
  const Real kept = x[i];
  x[i] = x[j];
  x[j] = kept;
}

// S_u from the tape, factored but for the columns of the holders, which are put last: S_u maps their motion to nothing that the
// other columns do not map to.
c2d_status factor_held(BodyEquations& e) {
  const Reduction& r = e.r;
  const int32_t n = e.n, held = e.held();
  if (held < 0) return C2D_ERR_SINGULAR;
  const c2d_status status = read_matrix(r.tape, e.b, BodyMatrix::displacement, r.first, n);
  if (status != C2D_OK) return status;
  rigid_columns(e);
  choose_holders(e);
  for (int32_t k = e.count - 1; k >= 0; --k)
    for (int32_t i = 0; i < n; ++i)
      exchange(r.first + i, static_cast<int64_t>(e.holder[k]) * n, static_cast<int64_t>(held + k) * n);
  for (int32_t j = 0; j < n; ++j) r.strip[j] = largest(r.engine, n, r.first + static_cast<int64_t>(j) * n);
  PivotStats stats;
  start_stats(stats);
  return lu_panel({r.engine, n, held, n, r.first, n, r.pivots, r.strip, &stats}) == 0 ? C2D_OK : C2D_ERR_SINGULAR;
}

// Of a body that is solved for and that only contact holds. Pressures lose up to 100 times as much as its displacements, with
// linear functions no more.
void note_growth(const BodyEquations& e) {
  if (kSmallCode || !e.r.round_off || e.r.open || e.count == 0) return;
  const double more = e.r.model.head->function_nodes > 2 ? 100.0 : 1.0;
  e.r.round_off->note(more * growth_of(e.r.first, e.n, e.held(), e.held(), e.strip(0)), e.b);
}

// Behind the eliminated unknowns of a column come what is left of the equations; the holders' own places are among the others.
void place_holders(const BodyEquations& e, Real* x) {
  for (int32_t j = 0; j < e.count; ++j) exchange(x, e.holder[j], e.held() + j);
}

// `columns` of right-hand sides: u with the holders at rest; before(column, rest) sees what is left of the equations.
template <class Before> c2d_status solve_held(const BodyEquations& e, int32_t columns, Real* x, Before before) {
  const int32_t n = e.n, held = e.held();
  lu_apply(e.r.engine, n, held, e.r.first, n, e.r.pivots, columns, x, n);
  for (int32_t j = 0; j < columns; ++j) {
    Real* rest = x + static_cast<int64_t>(j) * n + held;
    const c2d_status status = before(j, rest);
    if (status != C2D_OK) return status;
    for (int32_t k = 0; k < e.count; ++k) rest[k] = 0;
  }
  trsm_upper(e.r.engine, held, columns, e.r.first, n, x, n);
  for (int32_t j = 0; j < columns; ++j) place_holders(e, x + static_cast<int64_t>(j) * n);
  return C2D_OK;
}

// R: each holder moves by one as the others rest.
c2d_status find_motions(const BodyEquations& e) {
  const int32_t n = e.n, held = e.held();
  c2d_status status = C2D_OK;
  for (int32_t k = 0; k < e.count; ++k) {
    Real* x = e.strip(k);
    for (int32_t i = 0; i < held; ++i) x[i] = -e.r.first[static_cast<int64_t>(held + k) * n + i];
    for (int32_t i = held; i < n; ++i) x[i] = i == held + k ? Real(1) : Real(0);
    trsm_upper(e.r.engine, held, 1, e.r.first, n, x, n);
    place_holders(e, x);
  }
  orthonormalise(n, e.count, e.r.strip, 0, nullptr);
  for (int32_t k = 0; k < e.count && status == C2D_OK; ++k)
    status = write_column(e.r.tape, e.b, BodyMatrix::motions, k, e.strip(k));
  return status;
}

// F, and of all its columns G. Those of q that slide are left out, and zero on the tape.
c2d_status find_flexibility(const BodyEquations& e) {
  const int32_t n = e.n;
  Real *f = e.r.second, *none = e.strip(kMostMotions);
  int32_t count = 0;
  c2d_status status = C2D_OK;
  for (int32_t j = 0; j < n && status == C2D_OK; ++j)
    if (!slides(e.r, e.b, j))
      status = read_column(e.r.tape, e.b, BodyMatrix::traction, j, f + static_cast<int64_t>(count++) * n);
  if (status != C2D_OK) return status;
  status = solve_held(e, count, f, [&](int32_t j, const Real* rest) {
    for (int32_t k = 0; k < e.count; ++k) e.strip(k)[j] = rest[k];
    return c2d_status{C2D_OK};
  });
  for (int32_t k = 0; k < e.count && count == n && status == C2D_OK; ++k)
    status = write_column(e.r.tape, e.b, BodyMatrix::resultants, k, e.strip(k));
  for (int32_t j = 0; j < n; ++j) none[j] = 0;
  for (int32_t j = 0; j < n && status == C2D_OK; ++j) {
    const bool left_out = slides(e.r, e.b, j);
    status = write_column(e.r.tape, e.b, BodyMatrix::flexibility, j, left_out ? none : f);
    if (!left_out) f += n;
  }
  return status;
}

// With more load cases several are solved for at once, by products of matrices. (Few have the digits that they always had.)
constexpr int32_t kManyLoads = 16;

// v and g.
c2d_status solve_loads(const BodyEquations& e) {
  const int32_t n = e.n, cases = e.r.model.head->load_cases, most = !kSmallCode && cases > kManyLoads ? n : 1;
  Real* const v = most > 1 ? e.r.second : e.r.strip;
  Real g[kMostMotions] = {};
  c2d_status status = C2D_OK;
  for (int32_t k = 0, some; k < cases && status == C2D_OK; k += some) {
    some = cases - k < most ? cases - k : most;
    for (int32_t i = 0; i < some && status == C2D_OK; ++i)
      status = read_column(e.r.tape, e.b, BodyMatrix::load, k + i, v + int64_t{i} * n);
    if (status != C2D_OK) break;
    status = solve_held(e, some, v, [&](int32_t i, const Real* rest) {
      for (int32_t j = 0; j < e.count; ++j) g[j] = rest[j];
      return e.count == 0 ? c2d_status{C2D_OK} : write_column(e.r.tape, e.b, BodyMatrix::given, k + i, g);
    });
    for (int32_t i = 0; i < some && status == C2D_OK; ++i)
      status = write_column(e.r.tape, e.b, BodyMatrix::response, k + i, v + int64_t{i} * n);
  }
  return status;
}

// ---- of a body that keeps its equations -------------------------------------------------------------------------------

// E, from E^T P^T L = 0: the equations that are left over, and what they take of the others.
c2d_status find_equilibrium(const BodyEquations& e) {
  const int32_t n = e.n, held = e.held();
  c2d_status status = C2D_OK;
  lu_settle(n, held, e.r.first, n, e.r.pivots);
  for (int32_t k = 0; k < e.count && status == C2D_OK; ++k) {
    Real* x = e.strip(k);
    for (int32_t i = 0; i < n; ++i) x[i] = i == held + k ? Real(1) : Real(0);
    for (int32_t j = held - 1; j >= 0; --j)
      x[j] = static_cast<Real>(-product(e.r.first + static_cast<int64_t>(j) * n + j + 1, x + j + 1, n - j - 1));
    for (int32_t j = held - 1; j >= 0; --j) exchange(x, j, e.r.pivots[j]);
    status = write_column(e.r.tape, e.b, BodyMatrix::equilibrium, k, x);
  }
  return status;
}

// G, with E in the strip.
c2d_status find_resultants(const BodyEquations& e) {
  const int32_t n = e.n;
  Real *column = e.strip(kMostMotions), *g = e.r.second;
  c2d_status status = C2D_OK;
  for (int32_t j = 0; j < n && status == C2D_OK; ++j) {
    status = read_column(e.r.tape, e.b, BodyMatrix::traction, j, column);
    for (int32_t k = 0; k < e.count; ++k)
      g[static_cast<int64_t>(k) * n + j] = static_cast<Real>(product(e.strip(k), column, n));
  }
  for (int32_t k = 0; k < e.count && status == C2D_OK; ++k)
    status = write_column(e.r.tape, e.b, BodyMatrix::resultants, k, g + static_cast<int64_t>(k) * n);
  return status;
}

// g = E^T s.
c2d_status balance_loads(const BodyEquations& e) {
  Real *s = e.strip(0), *equilibrium = e.strip(1), g[kMostMotions] = {};
  c2d_status status = C2D_OK;
  for (int32_t k = 0; k < e.r.model.head->load_cases && e.count > 0 && status == C2D_OK; ++k) {
    status = read_column(e.r.tape, e.b, BodyMatrix::load, k, s);
    for (int32_t j = 0; j < e.count && status == C2D_OK; ++j) {
      status = read_column(e.r.tape, e.b, BodyMatrix::equilibrium, j, equilibrium);
      g[j] = static_cast<Real>(product(equilibrium, s, e.n));
    }
    if (status == C2D_OK) status = write_column(e.r.tape, e.b, BodyMatrix::given, k, g);
  }
  return status;
}

c2d_status find_kept(BodyEquations& e) {
  if (e.count == 0) return C2D_OK;
  c2d_status status = factor_held(e);
  if (status == C2D_OK) status = find_motions(e);
  if (status == C2D_OK) status = find_equilibrium(e);
  if (status == C2D_OK) status = find_resultants(e);
  return status == C2D_OK ? balance_loads(e) : status;
}

BodyEquations equations_of(const Reduction& r, int b) {
  return BodyEquations{r, b, r.model.body[b].contact, r.model.body[b].free_motions, {}};
}

} // namespace

double growth_of(const Real* upper, int64_t ld, int32_t n, int32_t counted, Real* z) {
  double sum = 0.0;
  for (int32_t j = 0; j < n; ++j) {
    const Real* const column = upper + j * ld;
    const double above = static_cast<double>(product(column, z, j)), f = j >= counted ? 0.0 : above > 0.0 ? -1.0 : 1.0;
    z[j] = static_cast<Real>((f - above) / static_cast<double>(column[j]));
    sum += static_cast<double>(z[j]) * static_cast<double>(z[j]);
  }
  return sqrt(sum);
}

c2d_status find_compliance(const Reduction& r, int b) {
  if (is_rigid(r.model, b)) return kRigidPart.reduce_rigid(r, b);
  BodyEquations e = equations_of(r, b);
  if (keeps_equations(r, b) || has_displacements(r.model, b)) return find_kept(e);
  c2d_status status = factor_held(e);
  if (status == C2D_OK) note_growth(e);
  if (status == C2D_OK) status = find_motions(e);
  if (status == C2D_OK) status = find_flexibility(e);
  if (status == C2D_OK) status = solve_loads(e);
  if (kSmallCode || !r.sliding || e.count == 0 || status != C2D_OK) return status;
  status = find_equilibrium(e); // G has all columns
  return status == C2D_OK ? find_resultants(e) : status;
}

c2d_status find_load_response(const Reduction& r, int b) {
  if (is_rigid(r.model, b)) return kRigidPart.reduce_rigid(r, b);
  BodyEquations e = equations_of(r, b);
  if (keeps_equations(r, b) || has_displacements(r.model, b)) return balance_loads(e);
  const c2d_status status = factor_held(e);
  return status == C2D_OK ? solve_loads(e) : status;
}

} // namespace c2d
