#include "contact/limit_analysis.hpp"

#include <math.h>

#include "contact/body_unknowns.hpp"
#include "contact/orthonormal.hpp"
#include "contact/start.hpp"

namespace c2d {

namespace {

// ---- what the pairs do to the free motions, one after another of all bodies: a force's work on each -------------------

// A pair's p or q works on the motions of the two bodies that meet there.
struct Ray {
  int32_t first[2], count[2]; // on a side: the body's motions
  double of[2][kMostMotions];
};

Ray plus(const Ray& a, double factor, const Ray& b) {
  Ray sum = a;
  for (int side = 0; side < 2; ++side)
    for (int32_t j = 0; j < a.count[side]; ++j) sum.of[side][j] += factor * b.of[side][j];
  return sum;
}
Ray times(double factor, const Ray& a) {
  Ray out = a;
  for (int side = 0; side < 2; ++side)
    for (int32_t j = 0; j < a.count[side]; ++j) out.of[side][j] *= factor;
  return out;
}
double dot(const Ray& a, const double* b) {
  double sum = 0.0;
  for (int side = 0; side < 2; ++side)
    for (int32_t j = 0; j < a.count[side]; ++j) sum += a.of[side][j] * b[a.first[side] + j];
  return sum;
}
void add_to(double* to, double factor, const Ray& a) {
  for (int side = 0; side < 2; ++side)
    for (int32_t j = 0; j < a.count[side]; ++j) to[a.first[side] + j] += factor * a.of[side][j];
}
double length(const Ray& a) {
  double sum = 0.0;
  for (int side = 0; side < 2; ++side)
    for (int32_t j = 0; j < a.count[side]; ++j) sum += a.of[side][j] * a.of[side][j];
  return sqrt(sum);
}

// Of numbers for all motions.
double dot(const double* a, const double* b, int32_t n) {
  double sum = 0.0;
  for (int32_t j = 0; j < n; ++j) sum += a[j] * b[j];
  return sum;
}
double length(const double* a, int32_t n) { return sqrt(dot(a, a, n)); }
void copy(const double* from, int32_t n, double* to) {
  for (int32_t j = 0; j < n; ++j) to[j] = from[j];
}

enum class Friction { own, none, rough, ties }; // a pair's own, or as if there were none, or no bound; nothing but ties

// In use: which ray of which pair.
struct Chosen {
  int32_t pair, ray;
};

// What the analysis works with, in the place of the rate problem. Resultants are those of the bodies' equations, named: as they
// come from the tableau, to the last digit, but combined so that they are work on Body::free_motion, as nearly as their span
// allows.
struct Analysis {
  Follower& f;
  const Model& m;
  PathScales scales;
  int32_t motions;
  Friction law;
  Real* resultant;                // [2 sides][m][kMostMotions]
  double* load;                   // [motions] what is to be balanced,
  double* rest;                   // [motions] what of it is not,
  double* handed;                 // [motions] or what ties alone hand on to other motions
  double *unit, *triangle;        // [motions][motions]: orthonormal basis of the rays in use
  double *factor, *wanted, *part; // [motions] of the rays in use
  Chosen* chosen;                 // [motions]
  int32_t count, based;           // of rays in use; of the first of them, whose units stand already

  const Real* resultants_of(const Pair& pair, int side, int slot) const {
    return resultant + (static_cast<int64_t>(side) * f.t->m + pair.dof + slot) * kMostMotions;
  }
  Ray of(const Pair& pair, int slot) const {
    Ray out{};
    for (int side = 0; side < 2; ++side) {
      const Body& body = m.body[body_on(m, pair, side)];
      out.first[side] = body.first_motion;
      out.count[side] = body.free_motions;
      for (int32_t j = 0; j < body.free_motions; ++j) out.of[side][j] = resultants_of(pair, side, slot)[j];
    }
    return out;
  }
  int rays_of(const Doubt& d, bool in_doubt, Ray out[4]) const;
  double* unit_of(int32_t k) const { return unit + static_cast<int64_t>(k) * motions; }
  double& in_triangle(int32_t i, int32_t k) const { return triangle[static_cast<int64_t>(k) * motions + i]; }
};

// Rays that span what a pair can do; a ray and its opposite for both directions.
int Analysis::rays_of(const Doubt& d, bool in_doubt, Ray out[4]) const {
  const Pair& pair = f.t->pair[d.pair];
  const Ray normal = of(pair, 0), along = pair.tangential ? of(pair, 1) : times(0.0, normal);
  constexpr double kAsGoodAsNone = 1e4; // bound of friction: all it leaves out would be beside the point
  const double mu = !pair.tangential || law == Friction::none ? 0.0 : law == Friction::rough ? 2.0 * kAsGoodAsNone : pair.mu;
  if (law == Friction::ties && d.pair < f.t->pairs) return 0;
  if (!in_doubt || (law != Friction::own && d.kind == DoubtKind::cone)) {
    if (pair.status == C2D_OPEN) return 0;
    out[0] = normal;
    out[1] = times(-1.0, normal);
    if (mu == 0.0 && d.pair < f.t->pairs) return 2; // (what is tied holds)
    out[2] = along;
    out[3] = times(-1.0, along);
    return 4;
  }
  if (d.kind == DoubtKind::cone) {
    out[0] = plus(normal, d.sign * mu, along);
    out[1] = times(-1.0, out[0]);
    out[2] = times(-d.sign, along);
    return 3;
  }
  if (mu > kAsGoodAsNone) {
    out[0] = normal;
    out[1] = along;
    out[2] = times(-1.0, along);
    return 3;
  }
  out[0] = plus(normal, mu, along);
  out[1] = plus(normal, -mu, along);
  return mu == 0.0 ? 1 : 2;
}

// ---- least squares with factors >= 0 (Lawson and Hanson): at most as many rays are in use as there are motions --------

// A ray in use, of length one.
Ray ray_in_use(const Analysis& a, int32_t k) {
  Doubt d;
  Ray ray[4];
  const bool in_doubt = is_in_doubt(a.f, a.chosen[k].pair, a.scales, d);
  a.rays_of(d, in_doubt, ray);
  const Ray& one = ray[a.chosen[k].ray];
  return times(1.0 / length(one), one);
}

// The unit of a ray in use, by Gram-Schmidt, and its part in the rest; false: hardly another direction.
bool add_unit(const Analysis& a, int32_t k) {
  const int32_t n = a.motions;
  double* const unit = a.unit_of(k);
  for (int32_t j = 0; j < n; ++j) unit[j] = 0.0;
  add_to(unit, 1.0, ray_in_use(a, k));
  for (int32_t i = 0; i < k; ++i) {
    a.in_triangle(i, k) = dot(a.unit_of(i), unit, n);
    for (int32_t j = 0; j < n; ++j) unit[j] -= a.in_triangle(i, k) * a.unit_of(i)[j];
  }
  a.in_triangle(k, k) = length(unit, n);
  if (a.in_triangle(k, k) < 1e-10) return false;
  for (int32_t j = 0; j < n; ++j) unit[j] /= a.in_triangle(k, k);
  a.part[k] = dot(unit, a.rest, n);
  return true;
}

// Orthogonal projection of the load onto the span of the rays in use: their factors, to `wanted`.
bool project(Analysis& a) {
  copy(a.load, a.motions, a.rest);
  for (int32_t k = 0; k < a.count; ++k) {
    if (k >= a.based && !add_unit(a, k)) return false;
    for (int32_t j = 0; j < a.motions; ++j) a.rest[j] -= a.part[k] * a.unit_of(k)[j];
  }
  a.based = a.count;
  for (int32_t k = a.count - 1; k >= 0; --k) {
    a.wanted[k] = a.part[k];
    for (int32_t i = k + 1; i < a.count; ++i) a.wanted[k] -= a.in_triangle(k, i) * a.wanted[i];
    a.wanted[k] /= a.in_triangle(k, k);
  }
  return true;
}

void drop(Analysis& a, int32_t k) {
  a.based = k;
  for (--a.count; k < a.count; ++k) {
    a.chosen[k] = a.chosen[k + 1];
    a.factor[k] = a.factor[k + 1];
  }
}

// Factors as near to the projection as they can be without a negative one; rays that reach zero are dropped.
bool settle_factors(Analysis& a) {
  for (;;) {
    if (!project(a)) return false;
    double reach = 1.0;
    int32_t first = -1;
    for (int32_t k = 0; k < a.count; ++k) {
      if (a.wanted[k] > 0.0) continue;
      const double part = a.factor[k] / (a.factor[k] - a.wanted[k]);
      if (first >= 0 && part >= reach) continue;
      reach = part;
      first = k;
    }
    for (int32_t k = 0; k < a.count; ++k) a.factor[k] += reach * (a.wanted[k] - a.factor[k]);
    if (first < 0) return true;
    drop(a, first);
  }
}

void find_rest(Analysis& a) {
  copy(a.load, a.motions, a.rest);
  for (int32_t k = 0; k < a.count; ++k) add_to(a.rest, -a.factor[k], ray_in_use(a, k));
}

// The ray that points farthest along the rest.
bool best_ray(const Analysis& a, Chosen* out) {
  double most = 1e-10 * length(a.rest, a.motions);
  bool found = false;
  for (int32_t i = 0; i < a.m.head->pairs; ++i) {
    Doubt d;
    const bool in_doubt = is_in_doubt(a.f, i, a.scales, d);
    Ray ray[4];
    const int count = a.rays_of(d, in_doubt, ray);
    for (int k = 0; k < count; ++k) {
      const double size = length(ray[k]), along = dot(ray[k], a.rest);
      if (!(size > 0.0) || along <= most * size) continue;
      most = along / size;
      *out = Chosen{i, k};
      found = true;
    }
  }
  return found;
}

// What of the load the pairs cannot balance, to `rest`; false: nothing.
bool is_unbalanced(Analysis& a, Friction law) {
  a.law = law;
  a.count = a.based = 0;
  const int32_t steps = 200 + 20 * a.motions;
  for (int32_t step = 0; step < steps; ++step) {
    Chosen ray;
    find_rest(a);
    if (length(a.rest, a.motions) <= 1e-9 * length(a.load, a.motions)) return false;
    if (!best_ray(a, &ray)) return true;
    if (a.count == a.motions) return false; // so many rays span all there is
    a.chosen[a.count] = ray;
    a.factor[a.count++] = 0.0;
    if (!settle_factors(a)) return false; // as good as balanced
  }
  return false;
}

// ---- resultants -------------------------------------------------------------------------------------------------------

// visit(pair, side, slot) for the contact unknowns of body b.
template <class Visit> void for_slots_of(const Model& m, int b, Visit visit) {
  for (PairSide at = first_pair_side(); next_pair_of(m, b, at);)
    for (int slot = 0; slot <= m.pair[at.pair].tangential; ++slot) visit(m.pair[at.pair], at.side, slot);
}

// Of body b, from the tape.
c2d_status read_resultants(const Analysis& a, int b, Real* column) {
  c2d_status status = C2D_OK;
  for (int32_t k = 0; k < a.m.body[b].free_motions && status == C2D_OK; ++k) {
    status = read_column(*a.f.tape, b, BodyMatrix::resultants, k, column);
    for_slots_of(a.m, b, [&](const Pair& pair, int side, int slot) {
      Real* out = a.resultant + (static_cast<int64_t>(side) * a.f.t->m + pair.dof + slot) * kMostMotions;
      out[k] = signed_on(side, column[dof_on(a.m, pair, side) + slot]);
    });
  }
  return status;
}

// Combined so that they are the forces' work on the body's free motions, one each: with the pairs' weights.
void name_resultants(const Analysis& a, int b) {
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
    Real* const row = a.resultant + (static_cast<int64_t>(side) * a.f.t->m + pair.dof + slot) * kMostMotions;
    double old[kMostMotions];
    for (int32_t i = 0; i < body.free_motions; ++i) old[i] = row[i];
    for (int32_t j = 0; j < body.free_motions; ++j) {
      double sum = 0.0;
      for (int32_t i = 0; i < body.free_motions; ++i) sum += old[i] * mix[i][j];
      row[j] = static_cast<Real>(sum);
    }
  });
}

// Less of the sum of the magnitudes that are added up is round-off of loads that balance each other.
constexpr double kNothing = sizeof(Real) == 8 ? 1e-11 : 1e-5;

// The work of the rates of the loads on the motions: that of the pressures with every pair sticking. Zero where they balance
// each other, but for round-off.
c2d_status find_load(Analysis& a, Real* rate) {
  double terms = 0.0;
  c2d_status status = C2D_OK;
  for (int32_t j = 0; j < a.motions; ++j) a.load[j] = 0.0;
  for (int32_t k = 0; k < a.f.t->cases && status == C2D_OK; ++k) {
    if (a.f.direction[k] == 0.0) continue;
    status = read_column(*a.f.tape, ContactMatrix::stiffness_load, k, rate);
    for (int32_t i = 0; i < a.m.head->pairs && status == C2D_OK; ++i)
      for (int slot = 0; slot <= a.m.pair[i].tangential; ++slot) {
        const Ray ray = a.of(a.m.pair[i], slot);
        const double part = a.f.direction[k] * rate[a.m.pair[i].dof + slot];
        add_to(a.load, part, ray);
        terms += fabs(part) * length(ray);
      }
  }
  for (int32_t j = 0; j < a.motions && length(a.load, a.motions) <= kNothing * terms; ++j) a.load[j] = 0.0;
  return status;
}

// Where it all stands; false: there is no room for it (bodies that a few pairs hold, one by one).
bool take_room(Analysis& a, Real** column) {
  const int64_t m = a.f.t->m, n = a.motions, numbers = (m + 1) * (m + 5);
  *column = a.f.rate_area.numbers;
  a.resultant = *column + (m + 7) / 8 * 8;
  const int64_t before = (m + 7) / 8 * 8 + (6 * m + 7) / 8 * 8;
  const int64_t doubles = static_cast<int64_t>((numbers - before) * static_cast<int64_t>(sizeof(Real)) / 8);
  double* at = reinterpret_cast<double*>(*column + before);
  // Small ones stand where results per pair do.
  double* lists = static_cast<double*>(a.f.rate_area.lists);
  if (7 * n > int64_t{C2D_PAIR_FIELDS} * a.f.rate_area.pairs) return false;
  double** const vectors[] = {&a.load, &a.rest, &a.handed, &a.factor, &a.wanted, &a.part};
  for (double** vector : vectors) {
    *vector = lists;
    lists += n;
  }
  a.chosen = reinterpret_cast<Chosen*>(lists);
  a.unit = at;
  a.triangle = at + n * n;
  return 2 * n * n <= doubles;
}

bool has_load(const Analysis& a) { return length(a.load, a.motions) > 0.0; }

// What keeps the bodies from their equilibrium: friction, if without bounds there is one; that one turns over, if pressure
// takes part of the load; that it comes off.
c2d_outcome kind_of_motion(Analysis& a) {
  if (!is_unbalanced(a, Friction::rough)) return C2D_GROSS_SLIDING;
  is_unbalanced(a, Friction::ties); // what ties hand on is the load as well
  copy(a.rest, a.motions, a.handed);
  is_unbalanced(a, Friction::none);
  double taken = 0.0;
  for (int32_t j = 0; j < a.motions; ++j) taken += (a.rest[j] - a.handed[j]) * (a.rest[j] - a.handed[j]);
  return sqrt(taken) > 1e-9 * length(a.load, a.motions) ? C2D_TIPPING : C2D_FREE_MOTION;
}

// What no pair balances is the motion on which the loads do work that no force of a pair opposes. Whose part is the largest?
int32_t body_in_motion(const Analysis& a) {
  int32_t found = -1;
  double most = 0.0;
  for (int b = 0; b < a.m.head->bodies; ++b) {
    const Body& body = a.m.body[b];
    const double size = body.contact > 0 ? length(a.rest + body.first_motion, body.free_motions) : 0.0;
    if (size <= (1.0 + 1e-9) * most) continue;
    most = size;
    found = b;
  }
  return found;
}

} // namespace

c2d_status limit_analysis(Follower& f, bool all_tried, c2d_outcome* outcome) {
  const Model& m = *f.model;
  *outcome = all_tried ? C2D_NO_ADMISSIBLE_CHANGE : C2D_UNDECIDED;
  if (m.head->motions == 0) return C2D_OK;
  Analysis a{f,
             m,
             decision_scales(f),
             m.head->motions,
             Friction::own,
             nullptr,
             nullptr,
             nullptr,
             nullptr,
             nullptr,
             nullptr,
             nullptr,
             nullptr,
             nullptr,
             nullptr,
             0,
             0};
  Real* column;
  if (!take_room(a, &column)) return C2D_OK;
  c2d_status status = C2D_OK;
  for (int b = 0; b < m.head->bodies && status == C2D_OK; ++b) {
    if (m.body[b].contact == 0 || m.body[b].free_motions == 0) continue;
    status = read_resultants(a, b, column);
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

// Pressures with every pair sticking under these factors, and the magnitudes they are sums of.
c2d_status sum_rates(const Follower& f, const double* factor, Real* column, Real* sum, Real* terms) {
  c2d_status status = C2D_OK;
  for (int32_t i = 0; i < f.t->m; ++i) sum[i] = terms[i] = 0;
  for (int32_t k = 0; k < f.t->cases && status == C2D_OK; ++k) {
    if (factor[k] == 0.0) continue;
    status = read_column(*f.tape, ContactMatrix::stiffness_load, k, column);
    for (int32_t i = 0; i < f.t->m && status == C2D_OK; ++i) {
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
  c2d_status status = sum_rates(f, f.load, column, sum[0], terms[0]);
  if (status == C2D_OK) status = sum_rates(f, f.direction, column, sum[1], terms[1]);
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
