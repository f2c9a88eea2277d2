#include "contact/rates/force_cone.hpp"

#include "memory/hostile.hpp"
#include "memory/math.hpp"

namespace c2d {

namespace {

double dot(const double* a, const double* b, int32_t n) {
  double sum = 0.0;
  for (int32_t j = 0; j < n; ++j) sum += a[j] * b[j];
  return sum;
}

} // namespace

double work(const Ray& a, const double* b) {
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

double length(const double* a, int32_t n) { return sqrt(dot(a, a, n)); }
void copy(const double* from, int32_t n, double* to) {
  for (int32_t j = 0; j < n; ++j) to[j] = from[j];
}

namespace {

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

} // namespace

Ray ForceCone::of(const Pair& pair, int slot) const {
  Ray out{};
  for (int side = 0; side < 2; ++side) {
    const Body& body = m.body[body_on(m, pair, side)];
    out.first[side] = body.first_motion;
    out.count[side] = body.free_motions;
    for (int32_t j = 0; j < body.free_motions; ++j) out.of[side][j] = resultants_of(pair, side, slot)[j];
  }
  return out;
}

// ---- where it all stands ----------------------------------------------------------------------------------------------

namespace {

// Small vectors stand where results per pair do: there are at most two motions a pair.
ForceCone with_vectors(Follower& f) {
  ForceCone out{f,
                *f.model,
                decision_scales(f),
                f.model->head->motions,
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
  const int64_t n = out.motions;
  if (7 * n > int64_t{C2D_PAIR_FIELDS} * f.rate_area.pairs) return out;
  double* lists = static_cast<double*>(f.rate_area.lists);
  double** const vectors[] = {&out.load, &out.rest, &out.handed, &out.factor, &out.wanted, &out.part};
  for (double** vector : vectors) {
    *vector = lists;
    lists += n;
  }
  out.chosen = reinterpret_cast<Chosen*>(lists);
  return out;
}

// As many doubles as there are in so many numbers.
int64_t doubles_in(int64_t numbers) { return numbers * static_cast<int64_t>(sizeof(Real)) / 8; }
int64_t rate_numbers(const Follower& f) { return static_cast<int64_t>(f.t->m + 1) * (f.t->m + 5); }

} // namespace

ForceCone force_cone(Follower& f, Real** column) {
  ForceCone out = with_vectors(f);
  const int64_t m = f.t->m, n = out.motions, before = (m + 7) / 8 * 8 + (6 * m + 7) / 8 * 8;
  *column = f.rate_area.numbers;
  out.resultant = *column + (m + 7) / 8 * 8;
  out.unit = reinterpret_cast<double*>(*column + before);
  out.triangle = out.unit + n * n;
  if (2 * n * n > doubles_in(rate_numbers(f) - before)) out.load = nullptr;
  return out;
}

ForceCone cone_for_tableau(Follower& f, Real** column) {
  ForceCone out = with_vectors(f);
  const int64_t n = out.motions, before = (6 * static_cast<int64_t>(f.t->m) + 1) / 2 * 2;
  *column = f.t->t;
  out.resultant = f.rate_area.numbers;
  out.unit = reinterpret_cast<double*>(out.resultant + before);
  out.triangle = reinterpret_cast<double*>(f.t->t);
  const int64_t numbers = f.t->m * static_cast<int64_t>(tableau_columns(*f.t));
  if (n * n > doubles_in(rate_numbers(f) - before) || n * n > doubles_in(numbers)) out.load = nullptr;
  return out;
}

c2d_status read_columns(const ForceCone& a, int b, BodyMatrix matrix, Real* column) {
  c2d_status status = C2D_OK;
  for (int32_t k = 0; k < a.m.body[b].free_motions && status == C2D_OK; ++k) {
    status = read_column(*a.f.tape, b, matrix, k, column);
    for_slots_of(a.m, b, [&](const Pair& pair, int side, int slot) {
      a.resultants_of(pair, side, slot)[k] = signed_on(side, column[dof_on(a.m, pair, side) + slot]);
    });
  }
  return status;
}

void mix_row(Real* row, int32_t count, const double mix[kMostMotions][kMostMotions]) {
  double old[kMostMotions];
  for (int32_t i = 0; i < count; ++i) old[i] = row[i];
  for (int32_t j = 0; j < count; ++j) {
    double sum = 0.0;
    for (int32_t i = 0; i < count; ++i) sum += old[i] * mix[i][j];
    row[j] = static_cast<Real>(sum);
  }
}

namespace {
// With quadratic functions a node on the axis of revolution has no share in forces: int N r ds = 0 (METHOD 21.9).
bool has_no_share(const Model& m, const Pair& pair) {
  if (!is_axisymmetric(m) || m.head->function_nodes != 3 || pair.tangential != 0) return false;
  double x, y;
  pair_position(m, pair, 0, &x, &y);
  return x == 0.0;
}
} // namespace

// Rays that span what a pair can do; a ray and its opposite for both directions.
int ForceCone::rays_of(const Doubt& d, bool in_doubt, Ray out[4]) const {
  const Pair& pair = f.t->pair[d.pair];
  if (has_no_share(m, pair)) return 0;
  const Ray normal = of(pair, 0), along = pair.tangential ? of(pair, 1) : times(0.0, normal);
  constexpr double kAsGoodAsNone = 1e4; // bound of friction: all it leaves out would be beside the point
  const double mu = !pair.tangential || law == Friction::none ? 0.0
                    : law == Friction::rough                  ? 2.0 * kAsGoodAsNone
                                                              : pair.law.mu;
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

namespace {

// ---- least squares with factors >= 0 (Lawson and Hanson): at most as many rays are in use as there are motions --------

// A ray in use, of length one.
Ray ray_in_use(const ForceCone& a, int32_t k) {
  Doubt d;
  Ray ray[4];
  const bool in_doubt = is_in_doubt(a.f, a.chosen[k].pair, a.scales, d);
  a.rays_of(d, in_doubt, ray);
  const Ray& one = ray[a.chosen[k].ray];
  return times(1.0 / length(one), one);
}

// The unit of a ray in use, by Gram-Schmidt, and its part in the rest; false: hardly another direction.
bool add_unit(const ForceCone& a, int32_t k) {
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
bool project(ForceCone& a) {
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

void drop(ForceCone& a, int32_t k) {
  a.based = k;
  for (--a.count; k < a.count; ++k) {
    a.chosen[k] = a.chosen[k + 1];
    a.factor[k] = a.factor[k + 1];
  }
}

// Factors as near to the projection as they can be without a negative one; rays that reach zero are dropped.
bool settle_factors(ForceCone& a) {
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

void find_rest(ForceCone& a) {
  copy(a.load, a.motions, a.rest);
  for (int32_t k = 0; k < a.count; ++k) add_to(a.rest, -a.factor[k], ray_in_use(a, k));
}

// The ray that points farthest along the rest.
bool best_ray(const ForceCone& a, Chosen* out) {
  double most = 1e-10 * length(a.rest, a.motions);
  bool found = false;
  for (int32_t i = 0; i < a.m.head->pairs; ++i) {
    Doubt d;
    const bool in_doubt = is_in_doubt(a.f, i, a.scales, d);
    Ray ray[4];
    const int count = a.rays_of(d, in_doubt, ray);
    for (int k = 0; k < count; ++k) {
      const double size = length(ray[k]), along = work(ray[k], a.rest);
      if (!(size > 0.0) || along <= most * size) continue;
      most = along / size;
      *out = Chosen{i, k};
      found = true;
    }
  }
  return found;
}

} // namespace

// Rest of the loads that counts as none: the motions that the equations know differ from rigid ones by the error of the
// integrals, 1e-7 where functions are of lower order than the geometry, so that a load above the only pair that touches seems
// to turn the body.
constexpr double kBalanced = 1e-6;

bool is_unbalanced(ForceCone& a, Friction law) {
  a.law = law;
  a.count = a.based = 0;
  const int32_t steps = 200 + 20 * a.motions;
  for (int32_t step = 0; !C2D_NEVER(step == steps); ++step) { // (less is left after each)
    Chosen ray;
    find_rest(a);
    if (length(a.rest, a.motions) <= kBalanced * length(a.load, a.motions)) return false;
    if (!best_ray(a, &ray)) return true;
    if (C2D_NEVER(a.count == a.motions)) return false; // so many rays span all there is: nothing would be left
    a.chosen[a.count] = ray;
    a.factor[a.count++] = 0.0;
    if (!settle_factors(a)) return false; // as good as balanced
  }
  return false;
}

c2d_outcome kind_of_motion(ForceCone& a) {
  if (!is_unbalanced(a, Friction::rough)) return C2D_GROSS_SLIDING;
  is_unbalanced(a, Friction::ties); // what ties hand on is the load as well
  copy(a.rest, a.motions, a.handed);
  is_unbalanced(a, Friction::none);
  double taken = 0.0;
  for (int32_t j = 0; j < a.motions; ++j) taken += (a.rest[j] - a.handed[j]) * (a.rest[j] - a.handed[j]);
  return sqrt(taken) > kBalanced * length(a.load, a.motions) ? C2D_TIPPING : C2D_FREE_MOTION;
}

int32_t body_in_motion(const ForceCone& a) {
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

} // namespace c2d
