#include "contact/reduction/reduction.hpp"

#include "contact/body_unknowns.hpp"
#include "contact/reduction/body_compliance.hpp"
#include "contact/reduction/open_form.hpp"
#include "contact/reduction/orthonormal.hpp"
#include "contact/reduction/rigid_balance.hpp"
#include "linalg/dense.hpp"
#include "memory/math.hpp"

namespace c2d {

namespace {

// The system [A C; G^T 0] for tau and x, in r.first. x: motions of the bodies, and behind them what a body where displacements
// are unknowns has beyond them, u = z + R x. Its rows are S_t t - S_u z = 0, and R^T z = 0 in the place of G^T t = 0, which the
// former say.
struct Bordered {
  const Reduction& r;
  int32_t m, motions, border;
  int64_t n() const { return int64_t{m} + border; }
  int32_t rows() const { return m + border; }
  int32_t first_displacement(int b) const { return m + motions + further_unknowns(r.model, b); } // of such a body
  Real* column(int64_t j) const { return r.first + j * n(); }
  int64_t strip_length() const { return r.strip_length; }
  Real* strip(int32_t j) const { return r.strip + j * strip_length(); }
};
Bordered bordered(const Reduction& r) {
  const int32_t motions = border_motions(r.tape);
  return Bordered{r, contact_unknowns(r.tape), motions, motions + further_unknowns(r.model)};
}

// Solved for, or rigid: its displacements are F t + R x, or R x.
bool gives_way(const Reduction& r, int b) { return r.model.body[b].contact > 0 && !keeps_equations(r, b); }
bool is_unknown(const Reduction& r, int b) { return has_displacements(r.model, b); }
bool keeps_in_zone(const Reduction& r, int32_t zone) { return (kSmallCode || !r.open) && has_kept(r.model, zone); }
int32_t flexible_columns(const Reduction& r, int b) {
  return is_rigid(r.model, b) || is_unknown(r, b) ? 0 : r.model.body[b].contact;
}

// visit(b) for those bodies until it fails.
template <class Visit> c2d_status for_bodies(const Reduction& r, bool (*which)(const Reduction&, int), Visit visit) {
  c2d_status status = C2D_OK;
  for (int b = 0; b < r.model.head->bodies && status == C2D_OK; ++b)
    if (which(r, b)) status = visit(b);
  return status;
}

// ---- A and C: pairs between bodies that are solved for ---------------------------------------------------------------

// u of a body (its F, v or R), with the sign of its sides, to the pairs' own rows of a column.
void add_to_pairs(const Reduction& r, int b, const Real* u, double factor, Real* out) {
  for_ranges(r.model, b, [&](const UnknownRange& range) {
    if (keeps_in_zone(r, range.zone)) return;
    const Real sign = static_cast<Real>(factor * range.sign());
    for (int32_t i = 0; i < range.count; ++i) out[range.all + i] += sign * u[range.own + i];
  });
}

c2d_status add_body(const Bordered& s, int b) {
  const Reduction& r = s.r;
  const Body& body = r.model.body[b];
  c2d_status status = C2D_OK;
  for_ranges(r.model, b, [&](const UnknownRange& range) {
    for (int32_t j = 0; j < range.count && flexible_columns(r, b) > 0 && status == C2D_OK; ++j) {
      if (slides(r, range.all + j)) continue;
      status = read_column(r.tape, b, BodyMatrix::flexibility, range.own + j, r.strip);
      add_to_pairs(r, b, r.strip, range.sign(), s.column(range.all + j));
    }
  });
  const bool open = !kSmallCode && r.open; // then motions are no unknowns
  for (int32_t k = 0; k < body.free_motions && !open && status == C2D_OK; ++k) {
    status = read_column(r.tape, b, BodyMatrix::motions, k, r.strip);
    add_to_pairs(r, b, r.strip, 1.0, s.column(s.m + body.first_border + k));
  }
  return status;
}

// ---- A and C: equations that are kept --------------------------------------------------------------------------------

// Columns of a product that go through memory of their own: `count` of them as they are, and as many of what comes out. With a
// kernel most of its scratch holds them, so that packing the left factor serves many; how many depends on the sizes alone.
struct Strips {
  Engine engine;
  Real *in, *out;
  int64_t ld;
  int32_t count;
};
constexpr int32_t kFewStrips = kStripColumns / 2, kMostStrips = kSmallCode ? kFewStrips : 64;

Strips strips_of(const Bordered& s) {
  const Reduction& r = s.r;
  const int64_t ld = s.strip_length(), all = full_scratch(ld, ld), packing = all / 5 / 8 * 8,
                wide = (all - packing) / (2 * ld) / 4 * 4;
  if (kSmallCode || !r.engine.kernel || r.engine.numbers < all || wide < 2 * kFewStrips)
    return {r.engine, r.strip, s.strip(kFewStrips), ld, kFewStrips};
  const int64_t most = ld < kMostStrips ? ld : kMostStrips; // there are no more
  const int32_t count = static_cast<int32_t>(wide < most ? wide : most);
  Strips strips = {r.engine, r.engine.scratch + packing, r.engine.scratch + packing + count * ld, ld, count};
  strips.engine.numbers = packing;
  strips.engine.used = nullptr;
  const int64_t used = packing + 2 * count * ld;
  if (r.engine.used && *r.engine.used < used) *r.engine.used = used;
  return strips;
}

// What a body that keeps its equations takes over of one it meets: u of that (its F, v or R) where they meet, in place.
void take_over(const Reduction& r, int b, int other, const Real* u, Real* out) {
  for_ranges(r.model, b, [&](const UnknownRange& range) {
    if (range.other != other) return;
    for (int32_t i = 0; i < range.count; ++i) out[range.own + i] = u[range.other_own + i];
  });
}

// Numbers of a body's unknowns or equations added in the places of the model's.
void add_in_place(const Reduction& r, int b, const Real* own, double factor, Real* out) {
  for_ranges(r.model, b, [&](const UnknownRange& range) {
    for (int32_t i = 0; i < range.count; ++i) out[range.all + i] += static_cast<Real>(factor) * own[range.own + i];
  });
}

// A column of the system and the factor with which one of the other body's columns, F or R, counts there.
struct Target {
  int64_t column;
  double factor;
};
Target target_of(const Bordered& s, int other, BodyMatrix matrix, int32_t j) {
  if (matrix == BodyMatrix::motions) return {s.m + s.r.model.body[other].first_border + j, 1.0};
  Target target = {0, 0.0};
  for_ranges(s.r.model, other, [&](const UnknownRange& range) {
    if (j >= range.own && j < range.own + range.count) target = {range.all + j - range.own, range.sign()};
  });
  return target;
}

// -S_u times F or R of a body that it meets, S_u in r.second.
c2d_status add_other(const Bordered& s, int b, int other, BodyMatrix matrix, int32_t columns) {
  const Reduction& r = s.r;
  const Strips strips = strips_of(s);
  const int32_t n = r.model.body[b].contact;
  c2d_status status = C2D_OK;
  for (int32_t next = 0; next < columns;) {
    int32_t count = 0, taken[kMostStrips];
    for (int64_t i = 0; i < strips.count * strips.ld; ++i) strips.in[i] = 0;
    for (; next < columns && count < strips.count && status == C2D_OK; ++next) {
      if (matrix == BodyMatrix::flexibility && slides(r, other, next)) continue;
      status = read_column(r.tape, other, matrix, next, strips.out); // nothing has come out yet
      take_over(r, b, other, strips.out, strips.in + count * strips.ld);
      taken[count++] = next;
    }
    if (status != C2D_OK) break;
    for (int64_t i = 0; i < count * strips.ld; ++i) strips.out[i] = 0;
    gemm_minus(strips.engine, n, count, n, r.second, n, strips.in, strips.ld, strips.out, strips.ld);
    for (int32_t c = 0; c < count; ++c) {
      const Target to = target_of(s, other, matrix, taken[c]);
      add_in_place(r, b, strips.out + c * strips.ld, to.factor, s.column(to.column));
    }
  }
  return status;
}

bool meets(const Model& m, int b, int other) {
  bool found = false;
  for_ranges(m, b, [&](const UnknownRange& range) { found = found || range.other == other; });
  return found;
}

// The rows of a body that keeps its equations.
c2d_status add_equations(const Bordered& s, int b) {
  const Reduction& r = s.r;
  const int32_t n = r.model.body[b].contact;
  c2d_status status = read_matrix(r.tape, b, BodyMatrix::displacement, r.second, n);
  for_ranges(r.model, b, [&](const UnknownRange& range) {
    for (int32_t j = 0; j < range.count && status == C2D_OK; ++j) {
      if (slides(r, range.all + j)) continue;
      status = read_column(r.tape, b, BodyMatrix::traction, range.own + j, r.strip);
      if (status == C2D_OK) add_in_place(r, b, r.strip, range.sign(), s.column(range.all + j));
    }
  });
  return status != C2D_OK ? status : for_bodies(r, gives_way, [&](int other) {
    const Body& body = r.model.body[other];
    if (!meets(r.model, b, other)) return c2d_status{C2D_OK};
    const c2d_status done = add_other(s, b, other, BodyMatrix::flexibility, flexible_columns(r, other));
    return done == C2D_OK ? add_other(s, b, other, BodyMatrix::motions, body.free_motions) : done;
  });
}

// C of the motions, orthonormal, to the tape.
c2d_status keep_border(const Bordered& s) {
  Real* c = s.r.second;
  for (int32_t k = 0; k < s.motions; ++k)
    for (int32_t i = 0; i < s.m; ++i) c[static_cast<int64_t>(k) * s.m + i] = s.column(s.m + k)[i];
  if (!orthonormalise(s.r.engine, s.m, s.motions, c, 0, nullptr, c + static_cast<int64_t>(s.motions) * s.m))
    return C2D_ERR_SINGULAR;
  return write_matrix(s.r.tape, ContactMatrix::border, c, s.m);
}

// A and C, to the tape.
c2d_status form_compliance(const Reduction& r) {
  const Bordered s = bordered(r);
  for (int64_t i = 0; i < s.n() * s.n(); ++i) r.first[i] = 0;
  c2d_status status = for_bodies(r, gives_way, [&](int b) { return add_body(s, b); });
  if (status == C2D_OK) status = for_bodies(r, keeps_equations, [&](int b) { return add_equations(s, b); });
  if (status == C2D_OK) status = write_matrix(r.tape, ContactMatrix::compliance, r.first, s.n());
  return status == C2D_OK ? keep_border(s) : status;
}

// ---- h ----------------------------------------------------------------------------------------------------------------

constexpr double kNothing = sizeof(Real) == 8 ? 1e-12 : 1e-5;

double largest_of(const Real* x, int32_t n) { return static_cast<double>(largest(kPlainEngine, n, x)); }

// In a column of `overlap` numbers by unknown of a body: what load case k closes, as far as the body moves for it.
void add_overlaps(const Model& m, int b, Real* out) {
  for_pairs_of(m, b, [&](const Pair& pair, int side) {
    if (pair.overlap != 0.0)
      out[dof_on(m, pair, side)] += static_cast<Real>(signed_on(side, pair.overlap) / m.head->length_unit);
  });
}

// s - S_u v of a body that keeps its equations, v of the bodies that it meets, to their places in h. What is left of a load
// that moves all pairs as a rigid body, on a body that is free to go along, is round-off, and set to zero: or its last digits
// would be the load.
//
// With `held` S_u stands in r.second, and the largest number of each column in the last strip: it is read once for all loads.
c2d_status close_equations(const Bordered& s, int b, int32_t k, bool held, Real* h) {
  const Reduction& r = s.r;
  const int32_t n = r.model.body[b].contact;
  Real *own = s.strip(1), *v = s.strip(2), *column = held ? own : s.strip(3);
  c2d_status status = C2D_OK;
  for (int32_t i = 0; i < n; ++i) v[i] = 0;
  for (int other = 0; other < r.model.head->bodies && status == C2D_OK; ++other) {
    if (!meets(r.model, b, other) || is_unknown(r, other)) continue;
    status = read_column(r.tape, other, BodyMatrix::response, k, column);
    take_over(r, b, other, column, v);
  }
  const double size = largest_of(v, n);
  if (k + 1 == r.model.head->interference) add_overlaps(r.model, b, v);
  if (status == C2D_OK) status = read_column(r.tape, b, BodyMatrix::load, k, own);
  double terms = largest_of(own, n), most = 0.0;
  for (int32_t j = 0; j < n && status == C2D_OK; ++j) {
    if (v[j] == 0) continue;
    const Real* of_u = held ? r.second + static_cast<int64_t>(j) * n : column;
    if (!held) status = read_column(r.tape, b, BodyMatrix::displacement, j, column);
    most = fmax(most, held ? static_cast<double>(s.strip(3)[j]) : largest_of(column, n));
    for (int32_t i = 0; i < n; ++i) own[i] -= v[j] * of_u[i];
  }
  terms += most * size;
  const bool nothing = largest_of(own, n) <= kNothing * terms;
  for (int32_t i = 0; i < n && nothing; ++i) own[i] = 0;
  add_in_place(r, b, own, 1.0, h);
  return status;
}

// Differences of the displacements that the loads make of bodies that are solved for, or are rigid. With every pair open they
// are all of h; what is left of them where the loads move both sides alike is round-off then, too.
c2d_status close_pairs(const Bordered& s, int32_t k, Real* h) {
  const Reduction& r = s.r;
  c2d_status status = C2D_OK;
  double terms = 0.0;
  for (int b = 0; b < r.model.head->bodies && status == C2D_OK; ++b) {
    if (!gives_way(r, b) || is_unknown(r, b)) continue;
    status = read_column(r.tape, b, BodyMatrix::response, k, s.strip(1));
    add_to_pairs(r, b, s.strip(1), 1.0, h);
    if (!kSmallCode && r.open) terms = fmax(terms, largest_of(s.strip(1), r.model.body[b].contact));
  }
  for (int32_t i = 0; i < r.model.head->pairs && k + 1 == r.model.head->interference; ++i) {
    const Pair& pair = r.model.pair[i];
    if (!keeps_in_zone(r, pair.zone)) h[pair.dof] -= static_cast<Real>(pair.overlap / r.model.head->length_unit);
  }
  for (int32_t i = 0; i < s.m && terms > 0.0 && largest_of(h, s.m) <= kNothing * terms; ++i) h[i] = 0;
  return status;
}

// S_u, and the largest number of each of its columns, where many loads need it: of the only body that keeps its equations.
c2d_status hold_displacements(const Bordered& s, bool* held) {
  const Reduction& r = s.r;
  int32_t bodies = 0, b = 0;
  for (int32_t i = 0; i < r.model.head->bodies; ++i)
    if (keeps_equations(r, i)) ++bodies, b = i;
  *held = !kSmallCode && bodies == 1 && r.model.head->load_cases > 2;
  if (!*held) return C2D_OK;
  const int32_t n = r.model.body[b].contact;
  const c2d_status status = read_matrix(r.tape, b, BodyMatrix::displacement, r.second, n);
  for (int32_t j = 0; j < n; ++j) s.strip(3)[j] = static_cast<Real>(largest_of(r.second + static_cast<int64_t>(j) * n, n));
  return status;
}

c2d_status form_closing(const Reduction& r) {
  const Bordered s = bordered(r);
  Real* h = s.strip(0);
  bool held = false;
  c2d_status status = hold_displacements(s, &held);
  for (int32_t k = 0; k < r.model.head->load_cases && status == C2D_OK; ++k) {
    for (int32_t i = 0; i < s.m; ++i) h[i] = 0;
    status = close_pairs(s, k, h);
    if (status == C2D_OK) status = for_bodies(r, keeps_equations, [&](int b) { return close_equations(s, b, k, held, h); });
    if (status == C2D_OK) status = write_column(r.tape, ContactMatrix::closing, k, h);
  }
  return status;
}

// ---- the solution -----------------------------------------------------------------------------------------------------

// Columns of B, times a factor, to where to(dof) says; null: not this one.
template <class To> c2d_status add_motions(const Bordered& s, Real factor, To to) {
  const Reduction& r = s.r;
  for (int32_t i = 0; i < r.model.head->pairs; ++i)
    for (int32_t d = 0; d <= r.model.pair[i].tangential && !keeps_in_zone(r, r.model.pair[i].zone); ++d)
      if (Real* const out = to(r.model.pair[i].dof + d)) out[r.model.pair[i].dof + d] = factor;
  return for_bodies(r, keeps_equations, [&](int b) {
    c2d_status status = C2D_OK;
    for_ranges(r.model, b, [&](const UnknownRange& range) {
      for (int32_t j = 0; j < range.count && status == C2D_OK; ++j) {
        Real* const out = to(range.all + j);
        if (!out) continue;
        status = read_column(r.tape, b, BodyMatrix::displacement, range.own + j, r.strip);
        if (status == C2D_OK) add_in_place(r, b, r.strip, factor * range.sign(), out);
      }
    });
    return status;
  });
}

// ---- bodies whose displacements are unknowns ---------------------------------------------------------------------------

// What one of them makes of the pairs' own rows and of the equations that other bodies keep.
c2d_status add_displacements(const Bordered& s, int b) {
  const Reduction& r = s.r;
  const int32_t first = s.first_displacement(b);
  c2d_status status = C2D_OK;
  for_ranges(r.model, b, [&](const UnknownRange& range) {
    for (int32_t i = 0; i < range.count; ++i) {
      Real* const column = s.column(first + range.own + i);
      if (keeps_equations(r, range.other)) {
        if (status == C2D_OK) status = read_column(r.tape, range.other, BodyMatrix::displacement, range.other_own + i, r.strip);
        if (status == C2D_OK) add_in_place(r, range.other, r.strip, -1.0, column);
      } else {
        column[range.all + i] += static_cast<Real>(range.sign());
      }
    }
  });
  return status;
}

// Its equations.
c2d_status add_own_equations(const Bordered& s, int b) {
  const Reduction& r = s.r;
  const int32_t first = s.first_displacement(b), n = r.model.body[b].contact;
  c2d_status status = C2D_OK;
  for_ranges(r.model, b, [&](const UnknownRange& range) {
    for (int32_t j = 0; j < range.count && status == C2D_OK; ++j) {
      const int32_t own = range.own + j;
      status = read_column(r.tape, b, BodyMatrix::displacement, own, r.strip);
      Real* at = s.column(first + own) + first;
      for (int32_t i = 0; i < n; ++i) at[i] -= r.strip[i];
      if (slides(r, range.all + j) || status != C2D_OK) continue;
      status = read_column(r.tape, b, BodyMatrix::traction, own, r.strip);
      at = s.column(range.all + j) + first;
      for (int32_t i = 0; i < n; ++i) at[i] += signed_on(range.side, r.strip[i]);
    }
  });
  for (int32_t k = 0; k < r.model.body[b].free_motions && status == C2D_OK; ++k) {
    status = read_column(r.tape, b, BodyMatrix::motions, k, r.strip);
    for (int32_t i = 0; i < n; ++i) s.column(first + i)[s.m + r.model.body[b].first_border + k] = r.strip[i];
  }
  return status;
}

// G^T below A, of the bodies whose motions are x, and the factors of all. Columns of q make room for those of w_t.
c2d_status factor_bordered(const Reduction& r) {
  const Bordered s = bordered(r);
  c2d_status status = for_bodies(r, gives_way, [&](int b) {
    const Body& body = r.model.body[b];
    c2d_status done = C2D_OK;
    for (int32_t k = 0; k < body.free_motions && !is_unknown(r, b) && done == C2D_OK; ++k) {
      const int64_t row = s.m + body.first_border + k;
      done = read_column(r.tape, b, BodyMatrix::resultants, k, r.strip);
      for_ranges(r.model, b, [&](const UnknownRange& range) {
        for (int32_t i = 0; i < range.count; ++i)
          if (!slides(r, range.all + i)) s.column(range.all + i)[row] += signed_on(range.side, r.strip[range.own + i]);
      });
    }
    return done;
  });
  if (!kSmallCode && r.sliding && status == C2D_OK)
    status = add_motions(s, Real(-1), [&](int32_t dof) { return slides(r, dof) ? s.column(dof) : nullptr; });
  if (status == C2D_OK)
    status = for_bodies(r, is_unknown, [&](int b) {
      const c2d_status done = add_displacements(s, b);
      return done == C2D_OK ? add_own_equations(s, b) : done;
    });
  if (status != C2D_OK) return status;
  if (lu_factor(r.engine, s.rows(), r.first, s.n(), r.pivots, r.strip, nullptr) != 0) return C2D_ERR_SINGULAR;
  int b = 0;
  while (b < r.model.head->bodies && !is_unknown(r, b)) ++b;
  if (b < r.model.head->bodies && r.round_off) r.round_off->note(growth_of(r.first, s.n(), s.rows(), s.m, r.strip), b);
  return C2D_OK;
}

// For new loads: A and C from the tape.
c2d_status read_compliance(const Reduction& r) {
  const Bordered s = bordered(r);
  for (int64_t i = 0; i < s.n() * s.n(); ++i) r.first[i] = 0;
  return read_matrix(r.tape, ContactMatrix::compliance, r.first, s.n());
}

// g of the motions that are unknowns, and s of the bodies whose displacements are.
c2d_status read_given(const Bordered& s, int32_t k, Real* out) {
  const c2d_status read = for_bodies(s.r, is_unknown, [&](int b) {
    return read_column(s.r.tape, b, BodyMatrix::load, k, out + s.first_displacement(b) - s.m);
  });
  return read != C2D_OK ? read : for_bodies(s.r, gives_way, [&](int b) {
    const Body& body = s.r.model.body[b];
    Real g[kMostMotions];
    if (body.free_motions == 0) return c2d_status{C2D_OK};
    const c2d_status status = read_column(s.r.tape, b, BodyMatrix::given, k, g);
    for (int32_t j = 0; j < body.free_motions; ++j) out[body.first_border + j] = is_unknown(s.r, b) ? Real(0) : g[j];
    return status;
  });
}

bool all_zero(const Real* x, int32_t n) {
  for (int32_t i = 0; i < n; ++i)
    if (x[i] != 0) return false;
  return true;
}

// Is a load nothing but a motion of bodies as if rigid, but for round-off? Its last digits would be the load.
c2d_status only_moves(const Bordered& s, const Real* h, bool* out) {
  Real* rest = s.strip(2);
  for (int32_t i = 0; i < s.m; ++i) rest[i] = h[i];
  const c2d_status status = take_out(s.r.tape, ContactMatrix::border, s.motions, nullptr, rest, s.strip(3));
  *out = largest_of(rest, s.m) <= kNothing * largest_of(h, s.m);
  return status;
}

// The largest term that displacements of bodies for which they are unknowns make of the pairs' equations.
c2d_status largest_term(const Bordered& s, const Real* solution, double* out) {
  const Reduction& r = s.r;
  Real* const column = s.strip(3);
  *out = 0.0;
  return for_bodies(r, is_unknown, [&](int b) {
    const Real* const x = solution + s.first_displacement(b);
    c2d_status status = C2D_OK;
    for_ranges(r.model, b, [&](const UnknownRange& range) {
      const bool kept = keeps_equations(r, range.other);
      for (int32_t i = 0; i < range.count && status == C2D_OK; ++i) {
        if (kept) status = read_column(r.tape, range.other, BodyMatrix::displacement, range.other_own + i, column);
        const double factor = kept ? largest_of(column, r.model.body[range.other].contact) : 1.0;
        *out = fmax(*out, factor * fabs(static_cast<double>(x[range.own + i])));
      }
    });
    return status;
  });
}

// The same where slender bodies bend too easily for that to show in h, or their loads are not in it: is what the tractions make
// of the equations nothing against h, or against what the displacements make of them?
c2d_status only_bends(const Bordered& s, int32_t k, const Real* tau, bool loaded, bool* out) {
  Real* const column = s.strip(3);
  double most = 0.0, term = 0.0;
  c2d_status status = loaded ? largest_term(s, tau, &term) : c2d_status{C2D_OK};
  for (int32_t j = 0; j < s.m && status == C2D_OK; ++j) {
    status = read_column(s.r.tape, ContactMatrix::compliance, j, column);
    most = fmax(most, largest_of(column, s.m));
  }
  if (status == C2D_OK) status = read_column(s.r.tape, ContactMatrix::closing, k, column);
  *out = most * largest_of(tau, s.m) <= kNothing * fmax(term, largest_of(column, s.m));
  return status;
}

// b and x of every load case, balanced; the factors are in r.first.
c2d_status form_rates(const Reduction& r) {
  const Bordered s = bordered(r);
  Real *b = s.strip(0), *given = s.strip(1);
  c2d_status status = C2D_OK;
  for (int32_t k = 0; k < r.model.head->load_cases && status == C2D_OK; ++k) {
    bool moves = false;
    status = read_column(r.tape, ContactMatrix::closing, k, b);
    if (status == C2D_OK) status = given_resultants(r, k, given);
    if (status == C2D_OK) status = only_moves(s, b, &moves);
    if (status == C2D_OK) status = read_given(s, k, b + s.m);
    if (status != C2D_OK) break;
    const bool pushed = !all_zero(given, free_motions(r.tape)), loaded = !all_zero(b + s.m, s.border);
    moves = moves && !pushed && !loaded;
    for (int32_t i = 0; i < s.rows(); ++i) b[i] = -b[i];
    lu_solve(r.engine, s.rows(), 1, r.first, s.n(), r.pivots, b, s.n());
    if (!pushed && s.border > s.motions) status = only_bends(s, k, b, loaded, &moves);
    for (int32_t i = 0; i < s.m && moves; ++i) b[i] = 0;
    if (status == C2D_OK && s.motions > 0) status = write_column(r.tape, ContactMatrix::motion_load, k, b + s.m);
    if (status == C2D_OK)
      status = for_bodies(r, is_unknown, [&](int body) {
        return write_column(r.tape, body, BodyMatrix::response, k, b + s.first_displacement(body));
      });
    if (status == C2D_OK) status = balance_rate(r, given);
    if (status == C2D_OK) status = write_column(r.tape, ContactMatrix::stiffness_load, k, b);
  }
  return status;
}

// Columns of T and X side by side in r.second: of all slots, or of those that are given.
int32_t solved_columns(const Reduction& r) { return !kSmallCode && r.sliding ? given_slots(r.model) : r.model.head->contact; }
Real* solved_column(const Bordered& s, int32_t dof) {
  if (slides(s.r, dof)) return nullptr;
  return s.r.second + (!kSmallCode && s.r.sliding ? given_number(s.r.model, dof) : dof) * s.n();
}

// B there.
c2d_status form_right_sides(const Bordered& s) {
  const Reduction& r = s.r;
  for (int64_t i = 0; i < s.n() * solved_columns(r); ++i) r.second[i] = 0;
  return add_motions(s, Real(1), [&](int32_t dof) { return solved_column(s, dof); });
}

// A row of X, which stands below T, to the strip.
const Real* row_of_motion(const Bordered& s, int64_t row) {
  for (int32_t j = 0; j < s.m; ++j) {
    const Real* const column = solved_column(s, j);
    s.r.strip[j] = column ? column[row] : Real(0);
  }
  return s.r.strip;
}

// X to the tape.
c2d_status write_motions(const Bordered& s) {
  const Reduction& r = s.r;
  c2d_status status = C2D_OK;
  for (int32_t k = 0; k < s.motions && status == C2D_OK; ++k)
    status = write_column(r.tape, ContactMatrix::motion, k, row_of_motion(s, s.m + k));
  return status != C2D_OK ? status : for_bodies(r, is_unknown, [&](int b) {
    c2d_status done = C2D_OK;
    for (int32_t i = 0; i < r.model.body[b].contact && done == C2D_OK; ++i)
      done = write_column(r.tape, b, BodyMatrix::flexibility, i, row_of_motion(s, s.first_displacement(b) + i));
    return done;
  });
}

c2d_status write_stiffness(const Bordered& s) {
  c2d_status status = C2D_OK;
  for (int32_t j = 0; j < s.m; ++j) s.r.strip[j] = 0;
  for (int32_t j = 0; j < s.m && status == C2D_OK; ++j) {
    const Real* const column = solved_column(s, j);
    status = write_column(s.r.tape, ContactMatrix::stiffness, j, column ? column : s.r.strip);
  }
  return status;
}

// T and X; the factors are in r.first, and gone afterwards.
c2d_status form_stiffness(const Reduction& r) {
  const Bordered s = bordered(r);
  c2d_status status = form_right_sides(s);
  if (status != C2D_OK) return status;
  lu_solve(r.engine, s.rows(), solved_columns(r), r.first, s.n(), r.pivots, r.second, s.n());
  status = write_motions(s);
  if (status == C2D_OK) status = balance_stiffness(r, r.second, s.n());
  return status == C2D_OK ? write_stiffness(s) : status;
}

// Forces alone, or motions of tangents.
c2d_status write_basis(const Reduction& r) {
  for (int32_t i = 0; i < r.model.head->contact; ++i) r.strip[i] = slides(r, i) ? kBasisNoForce : kBasisForce;
  return write_column(r.tape, ContactMatrix::basis, 0, r.strip);
}

using Step = c2d_status (*)(const Reduction&);
template <int n> c2d_status take_steps(const Reduction& r, const Step (&steps)[n]) {
  for (const Step& step : steps) {
    c2d_status status = r.tick(r.watch_context);
    if (status == C2D_OK) status = step(r);
    if (status != C2D_OK) return status;
  }
  return C2D_OK;
}

bool is_in_contact(const Reduction& r, int b) { return r.model.body[b].contact > 0; }
c2d_status watched(const Reduction& r, int b, c2d_status (*step)(const Reduction&, int)) {
  const c2d_status status = r.tick(r.watch_context);
  return status == C2D_OK ? step(r, b) : status;
}

c2d_status reduce_once(const Reduction& r) {
  const c2d_status status = for_bodies(r, is_in_contact, [&](int b) { return watched(r, b, find_compliance); });
  const Step steps[] = {join_motions, form_compliance, form_closing, factor_bordered, form_rates, form_stiffness};
  const Step open_steps[] = {join_motions, form_compliance, form_closing, form_open_stiffness, form_open_rates};
  if (status != C2D_OK) return status;
  return !kSmallCode && r.open ? take_steps(r, open_steps) : take_steps(r, steps);
}

} // namespace

c2d_status reduce(const Reduction& as_given) {
  Reduction r = as_given;
  r.open = as_given.open && has_open_form(r.model);
  c2d_status status = reduce_once(r);
  if (!kSmallCode && r.open && status == C2D_ERR_SINGULAR) {
    r.open = false;
    status = reduce_once(r);
  }
  if (!kSmallCode && r.sliding && status == C2D_ERR_SINGULAR) {
    r.sliding = false;
    status = reduce_once(r);
  }
  return status != C2D_OK || kSmallCode || r.open || !has_basis(r.model.head->contact) ? status : write_basis(r);
}

c2d_status reduce_on_demand(const Reduction& as_given) {
  Reduction r = as_given;
  r.open = true;
  for (int32_t i = 0; i < r.model.head->pairs; ++i) r.model.pair[i].made = -1;
  const c2d_status status = for_bodies(
      r, is_in_contact, [&](int b) { return is_rigid(r.model, b) ? watched(r, b, find_compliance) : c2d_status{C2D_OK}; });
  const Step steps[] = {form_closing};
  return status == C2D_OK ? take_steps(r, steps) : status;
}

c2d_status reduce_loads(const Reduction& as_given) {
  Reduction r = as_given;
  Form form;
  c2d_status status = kSmallCode ? c2d_status{C2D_OK} : read_form(r.tape, r.strip, &form);
  r.sliding = form.sliding;
  r.open = form.open;
  if (status == C2D_OK) status = for_bodies(r, is_in_contact, [&](int b) { return watched(r, b, find_load_response); });
  const Step steps[] = {form_closing, read_compliance, factor_bordered, form_rates},
             open_steps[] = {form_closing, form_open_rates};
  if (status != C2D_OK) return status;
  return !kSmallCode && r.open ? take_steps(r, open_steps) : take_steps(r, steps);
}

} // namespace c2d
