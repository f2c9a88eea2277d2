#include "contact/rates/limit_analysis.hpp"

#include "contact/basis.hpp"
#include "contact/body_unknowns.hpp"
#include "contact/rates/force_cone.hpp"
#include "contact/reduction/orthonormal.hpp"
#include "contact/start.hpp"
#include "memory/math.hpp"

namespace c2d {

namespace {

// ---- resultants -------------------------------------------------------------------------------------------------------

// Combined so that they are the forces' work on the body's free motions, one each: with the pairs' weights.
void name_resultants(const ForceCone& a, int b) {
  const Body& body = a.m.body[b];
  double mix[kMostMotions][kMostMotions] = {};
  for_slots_of(a.m, b, [&](const Pair& pair, int side, int slot) {
    for (int32_t j = 0; j < body.free_motions; ++j) {
      double w[2];
      motion_at_pair(a.m, b, body.free_motion[j], body.centre, pair, w);
      for (int32_t i = 0; i < body.free_motions; ++i) mix[i][j] += a.resultants_of(pair, side, slot)[i] * pair.weight * w[slot];
    }
  });
  for_slots_of(a.m, b, [&](const Pair& pair, int side, int slot) {
    mix_row(a.resultants_of(pair, side, slot), body.free_motions, mix);
  });
}

// Less of the sum of the magnitudes that are added up is round-off of loads that balance each other.
constexpr double kNothing = sizeof(Real) == 8 ? 1e-11 : 1e-5;

// The work of the rates of the loads on the motions: that of the pressures with every pair sticking. Zero where they balance
// each other, but for round-off.
c2d_status find_load(ForceCone& a, Real* rate) {
  double terms = 0.0;
  Form form;
  c2d_status status = kSmallCode ? c2d_status{C2D_OK} : read_form(*a.f.tape, rate, &form);
  for (int32_t j = 0; j < a.motions; ++j) a.load[j] = 0.0;
  for (int32_t k = 0; k < a.f.t->cases && status == C2D_OK; ++k) {
    if (a.f.direction[k] == 0.0) continue;
    status = read_column(*a.f.tape, ContactMatrix::stiffness_load, k, rate);
    for (int32_t i = 0; i < a.m.head->pairs && status == C2D_OK; ++i)
      for (int slot = 0; slot <= a.m.pair[i].tangential; ++slot) {
        if (!kSmallCode && !has_force(form, a.m, a.m.pair[i].dof + slot)) continue;
        const Ray ray = a.of(a.m.pair[i], slot);
        const double part = a.f.direction[k] * rate[a.m.pair[i].dof + slot];
        add_to(a.load, part, ray);
        terms += fabs(part) * length(ray);
      }
  }
  for (int32_t j = 0; j < a.motions && length(a.load, a.motions) <= kNothing * terms; ++j) a.load[j] = 0.0;
  return status;
}

bool has_load(const ForceCone& a) { return length(a.load, a.motions) > 0.0; }

} // namespace

c2d_status limit_analysis(Follower& f, bool all_tried, c2d_outcome* outcome) {
  const Model& m = *f.model;
  *outcome = all_tried ? C2D_NO_ADMISSIBLE_CHANGE : C2D_UNDECIDED;
  if (m.head->motions == 0) return C2D_OK;
  Real* column;
  ForceCone a = force_cone(f, &column);
  if (!a.load) return C2D_OK;
  c2d_status status = C2D_OK;
  for (int b = 0; b < m.head->bodies && status == C2D_OK; ++b) {
    if (m.body[b].contact == 0 || m.body[b].free_motions == 0) continue;
    status = read_columns(a, b, BodyMatrix::resultants, column);
    name_resultants(a, b);
  }
  if (status == C2D_OK) status = find_load(a, column);
  if (status != C2D_OK) return status;
  if (!has_load(a) || !is_unbalanced(a, Friction::own)) return C2D_OK;
  f.moving = body_in_motion(a);
  *outcome = kind_of_motion(a);
  return C2D_OK;
}

// ---- do the loads balance? --------------------------------------------------------------------------------------------

namespace {

// Pressures with every pair sticking under these factors, or as the tape has them, and the magnitudes they are sums of.
c2d_status sum_rates(const Follower& f, const Form& form, const double* factor, Real* column, Real* sum, Real* terms) {
  c2d_status status = C2D_OK;
  for (int32_t i = 0; i < f.t->m; ++i) sum[i] = terms[i] = 0;
  for (int32_t k = 0; k < f.t->cases && status == C2D_OK; ++k) {
    if (factor[k] == 0.0) continue;
    status = read_column(*f.tape, ContactMatrix::stiffness_load, k, column);
    for (int32_t i = 0; i < f.t->m && status == C2D_OK; ++i) {
      if (!kSmallCode && !has_force(form, *f.model, i)) continue;
      const Real part = static_cast<Real>(factor[k]) * column[i];
      sum[i] += part;
      terms[i] += static_cast<Real>(fabs(static_cast<double>(part)));
    }
  }
  return status;
}

struct Resultant {
  double square = 0.0; // of its length
  double terms = 0.0;
  bool is_nothing(double more_terms) const { return sqrt(square) <= kNothing * (terms + more_terms); }
};

} // namespace

c2d_status loads_balance(const Follower& f, bool* values, bool* rates) {
  *values = *rates = true;
  const int32_t m = f.t->m;
  if (f.model->head->motions == 0) return C2D_OK;
  Real *column = f.rate_area.numbers, *reach = column + m, *sum[2] = {reach + m, reach + 2 * m},
       *terms[2] = {reach + 3 * m, reach + 4 * m};
  Resultant of[2];
  Form form;
  c2d_status status = kSmallCode ? c2d_status{C2D_OK} : read_form(*f.tape, column, &form);
  if (status == C2D_OK) status = sum_rates(f, form, f.load, column, sum[0], terms[0]);
  if (status == C2D_OK) status = sum_rates(f, form, f.direction, column, sum[1], terms[1]);
  for (int32_t i = 0; i < m; ++i) reach[i] = 0;
  for (int32_t k = 0; k < f.model->head->motions && status == C2D_OK; ++k) {
    status = read_column(*f.tape, ContactMatrix::resultants, k, column);
    for (int32_t i = 0; i < m; ++i) reach[i] += column[i] * column[i];
    for (int w = 0; w < 2; ++w) of[w].square += product(column, sum[w], m) * product(column, sum[w], m);
  }
  for (int32_t i = 0; i < m; ++i)
    for (int w = 0; w < 2; ++w) of[w].terms += static_cast<double>(terms[w][i]) * sqrt(static_cast<double>(reach[i]));
  *values = of[0].is_nothing(of[1].terms); // a load of zero may be the round-off of its path
  *rates = of[1].is_nothing(0.0);
  return status;
}

} // namespace c2d
