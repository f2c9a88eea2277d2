#include "contact/reduction/rigid_balance.hpp"

#include "contact/body_unknowns.hpp"
#include "contact/reduction/orthonormal.hpp"
#include "linalg/dense.hpp"

namespace c2d {

namespace {

Real* strip_column(const Reduction& r, int32_t j) { return r.strip + j * r.strip_length; }

// One of all motions: body and column.
struct BodyMotion {
  int b, column;
};
BodyMotion body_motion(const Model& m, int32_t motion) {
  int b = 0;
  while (m.body[b].contact == 0 || motion >= m.body[b].first_motion + m.body[b].free_motions) ++b;
  return {b, motion - m.body[b].first_motion};
}

// A column of a body's matrix, with the signs of its sides, in the places of the pairs.
c2d_status read_on_pairs(const Reduction& r, BodyMatrix matrix, BodyMotion of, Real* out) {
  Real* own = strip_column(r, kStripColumns - 1);
  const c2d_status status = read_column(r.tape, of.b, matrix, of.column, own);
  for (int32_t i = 0; i < contact_unknowns(r.tape); ++i) out[i] = 0;
  for_ranges(r.model, of.b, [&](const UnknownRange& range) {
    for (int32_t i = 0; i < range.count; ++i) out[range.all + i] += signed_on(range.side, own[range.own + i]);
  });
  return status;
}

// Columns of T, and the slot of one.
int32_t columns_of(const Reduction& r) { return !kSmallCode && r.sliding ? given_slots(r.model) : contact_unknowns(r.tape); }
int32_t slot_of(const Reduction& r, int32_t j) { return !kSmallCode && r.sliding ? given_slot(r.model, j) : j; }

// T (I - R R^T) for one motion, in column 0 of the strip; what slides goes along.
void remove_motion(const Reduction& r, Real* t, int64_t ld) {
  const int32_t m = contact_unknowns(r.tape), columns = columns_of(r);
  const Real* motion = strip_column(r, 0);
  Real* response = strip_column(r, 1);
  for (int32_t i = 0; i < m; ++i) response[i] = slides(r, i) ? -motion[i] : Real(0);
  for (int32_t j = 0; j < columns; ++j)
    for (int32_t i = 0; i < m; ++i) response[i] += motion[slot_of(r, j)] * t[j * ld + i];
  for (int32_t j = 0; j < columns; ++j)
    for (int32_t i = 0; i < m; ++i) t[j * ld + i] -= response[i] * motion[slot_of(r, j)];
}

// (I - Q Q^T) T for one resultant, in column 0 of the strip.
void remove_resultant(const Reduction& r, Real* t, int64_t ld) {
  const int32_t m = contact_unknowns(r.tape);
  for (int32_t j = 0; j < columns_of(r); ++j)
    subtract(m, t + j * ld, product(strip_column(r, 0), t + j * ld, m), strip_column(r, 0));
}

// The few motions of one body; boards have no product for more.
c2d_status remove_one_by_one(const Reduction& r, Real* t, int64_t ld) {
  const int32_t n = free_motions(r.tape);
  c2d_status status = C2D_OK;
  for (int32_t k = 0; k < n && status == C2D_OK; ++k) {
    status = read_column(r.tape, ContactMatrix::motions, k, strip_column(r, 0));
    if (status == C2D_OK) remove_motion(r, t, ld);
  }
  for (int32_t k = 0; k < n && status == C2D_OK; ++k) {
    status = read_column(r.tape, ContactMatrix::resultants, k, strip_column(r, 0));
    if (status == C2D_OK) remove_resultant(r, t, ld);
  }
  return status;
}

// X, R or Q in m rows, -X^T, and zeros for a product with either: 3 m n <= (m + n)^2 numbers.
struct Factors {
  Real *x, *across, *part;
};
c2d_status read_factors(const Reduction& r, ContactMatrix matrix, Factors& out) {
  const int64_t m = contact_unknowns(r.tape), n = free_motions(r.tape);
  out = {r.first, r.first + m * n, r.first + 2 * m * n};
  const c2d_status status = read_matrix(r.tape, matrix, out.x, m);
  for (int64_t j = 0; j < n && status == C2D_OK; ++j)
    for (int64_t i = 0; i < m; ++i) out.across[i * n + j] = -out.x[j * m + i];
  for (int64_t i = 0; i < m * n; ++i) out.part[i] = 0;
  return status;
}
// R in the rows of T's columns alone, and what of it slides as the product to begin with.
void keep_given(const Reduction& r, Factors& f) {
  const int64_t m = contact_unknowns(r.tape), n = free_motions(r.tape);
  for (int64_t k = 0; k < n; ++k)
    for (int32_t i = 0; i < m; ++i)
      if (slides(r, i)) f.part[k * m + i] = f.x[k * m + i];
  for (int32_t j = 0; j < columns_of(r); ++j)
    for (int64_t k = 0; k < n; ++k) {
      f.x[k * m + j] = f.x[k * m + slot_of(r, j)];
      f.across[j * n + k] = -f.x[k * m + j];
    }
}

c2d_status remove_together(const Reduction& r, Real* t, int64_t ld) {
  const int32_t m = contact_unknowns(r.tape), n = free_motions(r.tape), columns = columns_of(r);
  Factors f;
  c2d_status status = read_factors(r, ContactMatrix::motions, f);
  if (status != C2D_OK) return status;
  if (!kSmallCode && r.sliding) keep_given(r, f);
  gemm_minus(r.engine, m, n, columns, t, ld, f.x, m, f.part, m);
  gemm_minus(r.engine, m, columns, n, f.part, m, f.across, n, t, ld);
  status = read_factors(r, ContactMatrix::resultants, f);
  if (status != C2D_OK) return status;
  gemm_minus(r.engine, n, columns, m, f.across, n, t, ld, f.part, n);
  gemm_minus(r.engine, m, columns, n, f.x, m, f.part, n, t, ld);
  return C2D_OK;
}

// R without friction is orthonormal in the slots that are given. False: hardly any of them moves where others do.
constexpr double kSlidesFreely = 1e4;
bool orthonormalise_given(const Reduction& r, Real* motions, Real* scratch) {
  const int32_t m = contact_unknowns(r.tape), n = free_motions(r.tape), given = given_slots(r.model), rest = m - given;
  Real *x = scratch, *y = x + static_cast<int64_t>(given) * n;
  scratch = y + static_cast<int64_t>(rest) * n;
  const auto pass = [&](bool in) { // to x and y, or back
    for (int64_t k = 0; k < n; ++k)
      for (int32_t i = 0, at = 0, out = 0; i < m; ++i) {
        Real &place = slides(r, i) ? y[k * rest + out++] : x[k * given + at++], &own = motions[k * m + i];
        (in ? place : own) = in ? own : place;
      }
  };
  pass(true);
  if (!orthonormalise(r.engine, given, n, x, rest, y, scratch)) return false;
  for (int64_t k = 0; k < n; ++k)
    if (!(product(y + k * rest, y + k * rest, rest) < kSlidesFreely * kSlidesFreely)) return false;
  pass(false);
  return true;
}

} // namespace

c2d_status join_motions(const Reduction& r) {
  const int32_t m = contact_unknowns(r.tape), count = free_motions(r.tape);
  Real *resultants = r.first, *motions = r.second, *mix = r.second + static_cast<int64_t>(count) * m;
  c2d_status status = count <= m ? c2d_status{C2D_OK} : c2d_status{C2D_ERR_SINGULAR};
  for (int32_t j = 0; j < count && status == C2D_OK; ++j) {
    status = read_on_pairs(r, BodyMatrix::resultants, body_motion(r.model, j), resultants + static_cast<int64_t>(j) * m);
    if (status == C2D_OK)
      status = read_on_pairs(r, BodyMatrix::motions, body_motion(r.model, j), motions + static_cast<int64_t>(j) * m);
    for (int32_t i = 0; i < count; ++i) mix[static_cast<int64_t>(j) * count + i] = i == j ? Real(1) : Real(0);
  }
  if (status != C2D_OK) return status;
  Real* scratch = resultants + static_cast<int64_t>(count) * m; // m n + m^2 <= (m + n)^2
  for (int32_t i = 0; i < m && !kSmallCode && r.sliding; ++i)
    for (int32_t j = 0; j < count && slides(r, i); ++j) resultants[static_cast<int64_t>(j) * m + i] = 0;
  const bool apart = !kSmallCode && r.sliding ? orthonormalise_given(r, motions, scratch)
                                              : orthonormalise(r.engine, m, count, motions, 0, nullptr, scratch);
  if (!apart) return C2D_ERR_SINGULAR;
  if (!orthonormalise(r.engine, m, count, resultants, count, mix, scratch)) return C2D_ERR_SINGULAR;
  status = write_matrix(r.tape, ContactMatrix::motions, motions, m);
  if (status == C2D_OK) status = write_matrix(r.tape, ContactMatrix::resultants, resultants, m);
  return status == C2D_OK ? write_matrix(r.tape, ContactMatrix::mix, mix, count) : status;
}

c2d_status given_resultants(const Reduction& r, int32_t k, Real* out) {
  const int32_t count = free_motions(r.tape);
  Real *raw = strip_column(r, kStripColumns - 1), *mix = strip_column(r, kStripColumns - 2), own[kMostMotions];
  c2d_status status = C2D_OK;
  for (int b = 0; b < r.model.head->bodies && status == C2D_OK; ++b) {
    const Body& body = r.model.body[b];
    if (body.contact == 0 || body.free_motions == 0) continue;
    status = read_column(r.tape, b, BodyMatrix::given, k, own);
    for (int32_t j = 0; j < body.free_motions; ++j) raw[body.first_motion + j] = own[j];
  }
  for (int32_t j = 0; j < count && status == C2D_OK; ++j) {
    status = read_column(r.tape, ContactMatrix::mix, j, mix);
    out[j] = static_cast<Real>(product(mix, raw, count));
  }
  return status;
}

c2d_status balance_stiffness(const Reduction& r, Real* t, int64_t ld) {
  const int32_t m = contact_unknowns(r.tape), n = free_motions(r.tape);
  const c2d_status status = kSmallCode || n <= kMostMotions ? remove_one_by_one(r, t, ld) : remove_together(r, t, ld);
  for (int32_t j = 0; j < m && n >= m; ++j) // only motions, and all slots are given (has_sliding_form)
    for (int32_t i = 0; i < m; ++i) t[j * ld + i] = 0;
  return status;
}

c2d_status take_out(const ContactTape& tape, ContactMatrix matrix, int32_t count, const Real* given, Real* x, Real* column) {
  const int32_t m = contact_unknowns(tape);
  c2d_status status = C2D_OK;
  for (int32_t j = 0; j < count && status == C2D_OK; ++j) {
    status = read_column(tape, matrix, j, column);
    if (status == C2D_OK) subtract(m, x, product(column, x, m) + (given ? static_cast<double>(given[j]) : 0.0), column);
  }
  return status;
}

c2d_status balance_rate(const Reduction& r, const Real* given) {
  return take_out(r.tape, ContactMatrix::resultants, free_motions(r.tape), given, strip_column(r, 0),
                  strip_column(r, kStripColumns - 1));
}

} // namespace c2d
