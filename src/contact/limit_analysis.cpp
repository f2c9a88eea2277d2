#include "contact/limit_analysis.hpp"

#include <math.h>

#include "contact/start.hpp"

namespace c2d {

namespace {

constexpr int kMotions = 3;
// Of a force on each of the free motions.
struct Work {
  double of[kMotions];
};

double dot(const Work& a, const Work& b) {
  double sum = 0.0;
  for (int j = 0; j < kMotions; ++j) sum += a.of[j] * b.of[j];
  return sum;
}
double length(const Work& a) { return sqrt(dot(a, a)); }
Work plus(const Work& a, double factor, const Work& b) {
  Work sum{};
  for (int j = 0; j < kMotions; ++j) sum.of[j] = a.of[j] + factor * b.of[j];
  return sum;
}

// What a pair's p and q do to the free motions: as the tableau has it, to the last digit.
struct Resultants {
  const Tableau& t;
  Real* column[kMotions]; // G; later in coordinates of the free motions
  int32_t count;
  Work of(int32_t dof) const {
    Work v{};
    for (int j = 0; j < count; ++j) v.of[j] = column[j][dof];
    return v;
  }
};

enum class Friction { own, none, rough }; // a pair's own, or as if there were none, or no bound

// Rays that span what a pair can do; a ray and its opposite for both directions.
int rays_of(const Follower& f, const Resultants& g, const Doubt& d, bool in_doubt, Friction law, Work out[4]) {
  const Pair& pair = f.t->pair[d.pair];
  const Work normal = g.of(pair.dof), along = pair.tangential ? g.of(pair.dof + 1) : Work{};
  constexpr double kAsGoodAsNone = 1e4; // bound of friction: all it leaves out would be beside the point
  const double mu = !pair.tangential || law == Friction::none ? 0.0 : law == Friction::rough ? 2.0 * kAsGoodAsNone : pair.mu;
  if (!in_doubt || (law != Friction::own && d.kind == DoubtKind::cone)) {
    if (pair.status == C2D_OPEN) return 0;
    out[0] = normal;
    out[1] = plus(Work{}, -1.0, normal);
    if (mu == 0.0) return 2;
    out[2] = along;
    out[3] = plus(Work{}, -1.0, along);
    return 4;
  }
  if (d.kind == DoubtKind::cone) {
    out[0] = plus(normal, d.sign * mu, along);
    out[1] = plus(Work{}, -1.0, out[0]);
    out[2] = plus(Work{}, -d.sign, along);
    return 3;
  }
  if (mu > kAsGoodAsNone) {
    out[0] = normal;
    out[1] = along;
    out[2] = plus(Work{}, -1.0, along);
    return 3;
  }
  out[0] = plus(normal, mu, along);
  out[1] = plus(normal, -mu, along);
  return mu == 0.0 ? 1 : 2;
}

// The part of a load that no combination of rays with factors >= 0 balances (least squares, Lawson and Hanson): at most
// three rays are in use at a time.
struct Cone {
  Work ray[kMotions]; // of length one
  double factor[kMotions];
  int32_t count;

  // Orthogonal projection of `load` onto the span of the rays in use, by Gram-Schmidt: their factors.
  bool project(const Work& load, double out[kMotions]) const {
    Work unit[kMotions];
    double triangle[kMotions][kMotions] = {};
    Work rest = load;
    double part[kMotions] = {};
    for (int k = 0; k < count; ++k) {
      unit[k] = ray[k];
      for (int i = 0; i < k; ++i) {
        triangle[i][k] = dot(unit[i], unit[k]);
        unit[k] = plus(unit[k], -triangle[i][k], unit[i]);
      }
      triangle[k][k] = length(unit[k]);
      if (triangle[k][k] < 1e-10) return false; // hardly another direction
      unit[k] = plus(Work{}, 1.0 / triangle[k][k], unit[k]);
      part[k] = dot(unit[k], rest);
      rest = plus(rest, -part[k], unit[k]);
    }
    for (int k = count - 1; k >= 0; --k) {
      out[k] = part[k];
      for (int i = k + 1; i < count; ++i) out[k] -= triangle[k][i] * out[i];
      out[k] /= triangle[k][k];
    }
    return true;
  }
  void drop(int k) {
    for (--count; k < count; ++k) {
      ray[k] = ray[k + 1];
      factor[k] = factor[k + 1];
    }
  }
  // Factors as near to the projection as they can be without a negative one; rays that reach zero are dropped.
  bool settle(const Work& load) {
    double wanted[kMotions];
    for (;;) {
      if (!project(load, wanted)) return false;
      double reach = 1.0;
      int first = -1;
      for (int k = 0; k < count; ++k) {
        if (wanted[k] > 0.0) continue;
        const double part = factor[k] / (factor[k] - wanted[k]);
        if (first >= 0 && part >= reach) continue;
        reach = part;
        first = k;
      }
      for (int k = 0; k < count; ++k) factor[k] += reach * (wanted[k] - factor[k]);
      if (first < 0) return true;
      drop(first);
    }
  }
  Work rest_of(const Work& load) const {
    Work rest = load;
    for (int k = 0; k < count; ++k) rest = plus(rest, -factor[k], ray[k]);
    return rest;
  }
};

// The ray that points farthest along `rest`.
bool best_ray(Follower& f, const Resultants& g, const PathScales& s, Friction law, const Work& rest, Work* out) {
  double most = 1e-10 * length(rest);
  bool found = false;
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    Doubt d;
    const bool in_doubt = is_in_doubt(f, i, s, d);
    Work ray[4];
    const int count = rays_of(f, g, d, in_doubt, law, ray);
    for (int k = 0; k < count; ++k) {
      const double size = length(ray[k]);
      if (!(size > 0.0) || dot(ray[k], rest) <= most * size) continue;
      most = dot(ray[k], rest) / size;
      *out = plus(Work{}, 1.0 / size, ray[k]);
      found = true;
    }
  }
  return found;
}

// What of `load` the pairs cannot balance; zero if they can.
Work unbalanced(Follower& f, const Resultants& g, const Work& load, Friction law) {
  const PathScales s = decision_scales(f);
  Cone cone{};
  for (int step = 0; step < 200; ++step) {
    const Work rest = cone.rest_of(load);
    Work ray;
    if (length(rest) <= 1e-9 * length(load)) return Work{};
    if (!best_ray(f, g, s, law, rest, &ray)) return rest;
    if (cone.count == kMotions) return Work{}; // three rays span all there is
    cone.ray[cone.count] = ray;
    cone.factor[cone.count++] = 0.0;
    if (!cone.settle(load)) return Work{}; // as good as balanced
  }
  return Work{};
}

// Motions of the pairs under the free motions, for what they are needed here: per force, so with the pair's length.
Work motion_of(const Follower& f, const Pair& pair, int slot) {
  const Body& body = f.model->head->body[f.floating_body];
  Work v{};
  for (int j = 0; j < body.free_motions; ++j) {
    double w[2];
    motion_at_pair(*f.model, f.floating_body, body.free_motion[j], body.centre, pair, w);
    v.of[j] = w[slot];
  }
  return v;
}

// G's columns combined so that they are the forces' work on the free motions, one each, as nearly as its span allows.
void name_resultants(const Follower& f, Real* column[kMotions], int count) {
  double mix[kMotions][kMotions] = {};
  for (int32_t i = 0; i < f.t->pairs; ++i)
    for (int slot = 0; slot <= f.t->pair[i].tangential; ++slot) {
      const Pair& pair = f.t->pair[i];
      const Work v = motion_of(f, pair, slot);
      for (int a = 0; a < count; ++a)
        for (int b = 0; b < count; ++b) mix[a][b] += column[a][pair.dof + slot] * pair.weight * v.of[b];
    }
  for (int32_t row = 0; row < f.t->m; ++row) {
    double old[kMotions];
    for (int a = 0; a < count; ++a) old[a] = column[a][row];
    for (int b = 0; b < count; ++b) {
      double sum = 0.0;
      for (int a = 0; a < count; ++a) sum += old[a] * mix[a][b];
      column[b][row] = static_cast<Real>(sum);
    }
  }
}

// The work of so much of each load on the free motions: G^T b, b the pressures with every pair sticking. *terms: sum of the
// magnitudes of what is added up.
c2d_status work_of_loads(const Follower& f, const Resultants& g, const double* factor, Real* rate, Work* out, double* terms) {
  *out = Work{};
  *terms = 0.0;
  c2d_status status = C2D_OK;
  for (int32_t k = 0; k < f.t->cases && status == C2D_OK; ++k) {
    if (factor[k] == 0.0) continue;
    status = read_column(*f.tape, ContactMatrix::stiffness_load, k, rate);
    for (int32_t i = 0; i < f.t->m && status == C2D_OK; ++i) {
      const double part = factor[k] * rate[i];
      *out = plus(*out, part, g.of(i));
      *terms += fabs(part) * length(g.of(i));
    }
  }
  return status;
}

// Less of these terms is round-off of loads that balance each other.
constexpr double kNothing = sizeof(Real) == 8 ? 1e-11 : 1e-5;

// Of the rates of the loads; zero where they balance each other, but for round-off.
c2d_status load_on_motions(const Follower& f, const Resultants& g, Real* rate, Work* out) {
  double terms;
  const c2d_status status = work_of_loads(f, g, f.direction, rate, out, &terms);
  if (length(*out) <= kNothing * terms) *out = Work{};
  return status;
}

int free_motions(const Follower& f) { return f.model->head->body[f.floating_body].free_motions; }

c2d_status read_resultants(const Follower& f, const Resultants& g) {
  c2d_status status = C2D_OK;
  for (int32_t k = 0; k < g.count && status == C2D_OK; ++k)
    status = read_column(*f.tape, ContactMatrix::resultants, k, g.column[k]);
  return status;
}

bool none(const Work& v) { return !(length(v) > 0.0); }

// What keeps the body from its equilibrium: friction, if without bounds there is one; that it turns over, if pressure takes
// part of the load; that it comes off.
c2d_outcome kind_of_motion(Follower& f, const Resultants& g, const Work& load) {
  if (none(unbalanced(f, g, load, Friction::rough))) return C2D_GROSS_SLIDING;
  const Work rest = unbalanced(f, g, load, Friction::none);
  return length(plus(rest, -1.0, load)) > 1e-9 * length(load) ? C2D_TIPPING : C2D_FREE_MOTION;
}

} // namespace

c2d_status loads_balance(const Follower& f, bool* values, bool* rates) {
  *values = *rates = true;
  const int count = free_motions(f);
  if (count == 0) return C2D_OK;
  const RateProblem r = rate_problem_in(f.rate_area, f.t->m);
  Resultants g{*f.t, {r.rhs, r.cover, r.point}, count};
  Work load, rate;
  double terms, rate_terms;
  c2d_status status = read_resultants(f, g);
  if (status == C2D_OK) status = work_of_loads(f, g, f.load, r.column_scale, &load, &terms);
  if (status == C2D_OK) status = work_of_loads(f, g, f.direction, r.column_scale, &rate, &rate_terms);
  if (status != C2D_OK) return status;
  *values = length(load) <= kNothing * (terms + rate_terms); // a load of zero may be the round-off of its path
  *rates = length(rate) <= kNothing * rate_terms;
  return status;
}

c2d_status limit_analysis(Follower& f, bool all_tried, c2d_outcome* outcome) {
  const int count = free_motions(f);
  *outcome = all_tried ? C2D_NO_ADMISSIBLE_CHANGE : C2D_UNDECIDED;
  if (count == 0) return C2D_OK;
  const RateProblem r = rate_problem_in(f.rate_area, f.t->m);
  Resultants g{*f.t, {r.rhs, r.cover, r.point}, count};
  c2d_status status = read_resultants(f, g);
  if (status != C2D_OK) return status;
  name_resultants(f, g.column, count);
  Work load;
  status = load_on_motions(f, g, r.column_scale, &load);
  if (status != C2D_OK) return status;
  if (!none(unbalanced(f, g, load, Friction::own))) *outcome = kind_of_motion(f, g, load);
  return C2D_OK;
}

} // namespace c2d
