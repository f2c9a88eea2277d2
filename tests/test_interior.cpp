#include "bie/boundary_stress.hpp"
#include "bie/integrals/interior_detail.hpp"
#include "c2d_memory.h"
#include "callable.hpp"
#include "contact2d.h"
#include "effort.hpp"
#include "host_structs.hpp"
#include "model/shape.hpp"
#include "paths.hpp"
#include "room.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <complex>
#include <cstring>
#include <fstream>
#include <initializer_list>
#include <string>
#include <vector>

using namespace c2d;

namespace {

constexpr double kOnce = 1; // load factor

using Long = long double;
const double kPi = std::acos(-1.0);

// ---- kernels as the thesis writes them, component by component, in extended precision ------------------------------

// Displacement i at P from traction j at the field point, and from displacement j there: r = field point - P. Times 2G.
Long kernel_u(const Long r[2], int i, int j, Long nu) {
  const Long d = hypotl(r[0], r[1]), k = 1 / (4 * acosl(-1.0L) * (1 - nu));
  return k * ((3 - 4 * nu) * -logl(d) * (i == j) + r[i] * r[j] / (d * d));
}
Long kernel_t(const Long r[2], const Long n[2], int i, int j, Long nu) {
  const Long d = hypotl(r[0], r[1]), k = 1 / (4 * acosl(-1.0L) * (1 - nu)), e[2] = {r[0] / d, r[1] / d};
  const Long drdn = e[0] * n[0] + e[1] * n[1];
  return -k / d * (drdn * ((1 - 2 * nu) * (i == j) + 2 * e[i] * e[j]) - (1 - 2 * nu) * (e[i] * n[j] - e[j] * n[i]));
}

// Stress kernels (3.33), (3.34), stress in 2G.
Long kernel_d(const Long r[2], int i, int j, int k, Long nu) {
  const Long d = hypotl(r[0], r[1]), e[2] = {r[0] / d, r[1] / d};
  return ((1 - 2 * nu) * ((k == i) * e[j] + (k == j) * e[i] - (i == j) * e[k]) + 2 * e[i] * e[j] * e[k]) /
         (4 * acosl(-1.0L) * (1 - nu) * d);
}
Long kernel_s(const Long r[2], const Long n[2], int i, int j, int k, Long nu) {
  const Long d = hypotl(r[0], r[1]), e[2] = {r[0] / d, r[1] / d};
  const Long drdn = e[0] * n[0] + e[1] * n[1], t1 = 1 - 2 * nu;
  const Long first = t1 * (i == j) * e[k] + nu * ((i == k) * e[j] + (j == k) * e[i]) - 4 * e[i] * e[j] * e[k];
  return (2 * drdn * first + 2 * nu * (n[i] * e[j] * e[k] + n[j] * e[i] * e[k]) +
          t1 * (2 * n[k] * e[i] * e[j] + n[j] * (i == k) + n[i] * (j == k)) - (1 - 4 * nu) * n[k] * (i == j)) /
         (4 * acosl(-1.0L) * (1 - nu) * d * d);
}

// Stress at P, in 2G, of a displacement field given per 2G by its values around P.
void stress_by_differences(const test::Callable<Long(Long, Long, int)>& u, Long nu, Long out[3]) {
  const Long h = 1e-5L;
  Long grad[2][2];
  for (int i = 0; i < 2; ++i) {
    grad[i][0] = (8 * (u(h, 0, i) - u(-h, 0, i)) - (u(2 * h, 0, i) - u(-2 * h, 0, i))) / (12 * h);
    grad[i][1] = (8 * (u(0, h, i) - u(0, -h, i)) - (u(0, 2 * h, i) - u(0, -2 * h, i))) / (12 * h);
  }
  const Long dilation = nu / (1 - 2 * nu) * (grad[0][0] + grad[1][1]);
  out[0] = grad[0][0] + dilation;
  out[1] = grad[1][1] + dilation;
  out[2] = 0.5L * (grad[0][1] + grad[1][0]);
}

// ---- brute force over one element -----------------------------------------------------------------------------------

// ux, uy, sxx, syy, sxy at P of one unit nodal value: traction (which < 2) or displacement (which - 2).
struct Five {
  Long v[5] = {0, 0, 0, 0, 0};
};

struct Brute {
  Element e;
  int functions;
  Long nu;
  const Element* arc;
  bool reversed;

  // P = x(eta0) + offset, so that its distance is exact.
  void point(Long eta0, const Long offset[2], Long tau, Long weight, int l, int which, Five& out) const {
    const Long eta = eta0 + tau;
    Long r[2] = {-offset[0], -offset[1]}, d[2] = {0, 0};
    for (int i = 0; i < 2; ++i) {
      const Long c1 = e.c[1][i], c2 = e.c[2][i], c3 = e.c[3][i];
      r[i] += tau * (c1 + 2 * c2 * eta0 + 3 * c3 * eta0 * eta0 + tau * (c2 + 3 * c3 * eta0 + tau * c3));
      d[i] = c1 + eta * (2 * c2 + 3 * eta * c3);
    }
    const Long own = hypotl(d[0], d[1]), n[2] = {d[1] / own, -d[0] / own};
    Long measure = own;
    if (arc && which < 2) {
      const Long at = reversed ? -eta : eta;
      Long s[2];
      for (int i = 0; i < 2; ++i) s[i] = arc->c[1][i] + at * (2 * Long(arc->c[2][i]) + 3 * at * arc->c[3][i]);
      measure = hypotl(s[0], s[1]);
    }
    Long m = 0;
    const double* c = shape_coefficients(functions, l);
    for (int k = functions - 1; k >= 0; --k) m = m * eta + c[k];
    const int j = which % 2, ij[3][2] = {{0, 0}, {1, 1}, {0, 1}};
    weight *= m * measure;
    for (int i = 0; i < 2; ++i) out.v[i] += weight * (which < 2 ? kernel_u(r, i, j, nu) : -kernel_t(r, n, i, j, nu));
    for (int s = 0; s < 3; ++s)
      out.v[2 + s] +=
          weight * (which < 2 ? kernel_d(r, ij[s][0], ij[s][1], j, nu) : -kernel_s(r, n, ij[s][0], ij[s][1], j, nu));
  }
  // Panels short against the distance from P, 8-point rule in extended precision.
  void side(Long eta0, const Long offset[2], Long sign, Long end, int l, int which, Five& out) const {
    static const Long x[4] = {0.183434642495649804939476142360L, 0.525532409916328985817739049189L,
                              0.796666477413626739591553936476L, 0.960289856497536231683560868569L};
    static const Long w[4] = {0.362683783378361982965150449277L, 0.313706645877887287337962201987L,
                              0.222381034453374470544355994426L, 0.101228536290376259152531354310L};
    const Long distance = hypotl(offset[0], offset[1]) / hypotl(e.c[1][0], e.c[1][1]);
    for (Long from = 0; from < end;) {
      Long to = from + std::min(0.1L, 0.2L * (from + distance));
      if (to > end) to = end;
      for (int i = 0; i < 8; ++i) {
        const Long node = i < 4 ? -x[i] : x[i - 4];
        point(eta0, offset, sign * (0.5L * (from + to) + 0.5L * (to - from) * node), 0.5L * (to - from) * w[i % 4], l, which,
              out);
      }
      from = to;
    }
  }
  Five integrate(Long eta0, const Long offset[2], int l, int which) const {
    Five out;
    side(eta0, offset, 1, 1 - eta0, l, which, out);
    side(eta0, offset, -1, 1 + eta0, l, which, out);
    return out;
  }
};

Five field_of(const Integrator& in, int l, int which, double x, double y) {
  Complex t[4] = {}, u[4] = {};
  Complex& one = which < 2 ? t[l] : u[l];
  (which % 2 == 0 ? one.re : one.im) = 1;
  FieldElement e;
  e.in = in;
  prepare_field(t, u, e);
  PointField f = {};
  add_field(e, {0, 0}, x, y, f);
  Five out;
  out.v[0] = f.u.re;
  out.v[1] = f.u.im;
  out.v[2] = 0.5L * (f.trace + f.deviator.re);
  out.v[3] = 0.5L * (f.trace - f.deviator.re);
  out.v[4] = -0.5L * f.deviator.im;
  return out;
}

Element test_element(int shape_number) {
  const double straight_x[2] = {0.3, 1.1}, straight_y[2] = {-0.2, 0.5};
  const double bent_x[3] = {1, 0.9238795325112867, 0.7071067811865476}, bent_y[3] = {0, 0.3826834323650898, 0.70710678};
  const double odd_x[4] = {0, 0.35, 0.6, 1}, odd_y[4] = {0, 0.1, -0.05, 0.2};
  if (shape_number == 0) return make_element(2, straight_x, straight_y);
  if (shape_number == 1) return make_element(3, bent_x, bent_y);
  return make_element(4, odd_x, odd_y);
}

// Largest error of all blocks at one point, relative to the largest entry of its kind of block (u or stress, t or u).
double worst_error(const Brute& brute, const Integrator& in, double eta0, const Long offset[2]) {
  const Point p = element_point(brute.e, eta0);
  const double x = p.x + static_cast<double>(offset[0]), y = p.y + static_cast<double>(offset[1]);
  Long error[4] = {0, 0, 0, 0}, size[4] = {0, 0, 0, 0};
  for (int l = 0; l < brute.functions; ++l)
    for (int which = 0; which < (brute.arc ? 2 : 4); ++which) {
      const Five expected = brute.integrate(eta0, offset, l, which), found = field_of(in, l, which, x, y);
      for (int c = 0; c < 5; ++c) {
        const int kind = 2 * (which / 2) + (c > 1);
        error[kind] = std::max(error[kind], fabsl(found.v[c] - expected.v[c]));
        size[kind] = std::max(size[kind], fabsl(expected.v[c]));
      }
    }
  Long worst = 0;
  for (int kind = 0; kind < (brute.arc ? 2 : 4); ++kind) worst = std::max(worst, error[kind] / size[kind]);
  return static_cast<double>(worst);
}

} // namespace

TEST_CASE("interior: stress kernels are Hooke's law on differences of U and T") {
  const Long nu = 0.3L, r0[2] = {0.7L, -0.4L}, n[2] = {0.6L, 0.8L};
  const int ij[3][2] = {{0, 0}, {1, 1}, {0, 1}};
  for (int k = 0; k < 2; ++k) {
    Long d[3], s[3];
    const auto r = [&](Long x, Long y, Long out[2]) { out[0] = r0[0] - x, out[1] = r0[1] - y; };
    stress_by_differences(
        [&](Long x, Long y, int i) {
          Long at[2];
          r(x, y, at);
          return kernel_u(at, i, k, nu);
        },
        nu, d);
    stress_by_differences(
        [&](Long x, Long y, int i) {
          Long at[2];
          r(x, y, at);
          return kernel_t(at, n, i, k, nu);
        },
        nu, s);
    for (int c = 0; c < 3; ++c) {
      CHECK(std::abs(static_cast<double>(d[c] - kernel_d(r0, ij[c][0], ij[c][1], k, nu))) < 1e-12);
      CHECK(std::abs(static_cast<double>(s[c] - kernel_s(r0, n, ij[c][0], ij[c][1], k, nu))) < 1e-12);
    }
    // A force's field is the kernel itself.
    PointField f = {};
    add_force_field({k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0}, 0.3, 0.7, -0.4, 0, 0, f);
    CHECK(f.trace == doctest::Approx(static_cast<double>(kernel_d(r0, 0, 0, k, nu) + kernel_d(r0, 1, 1, k, nu))));
    CHECK(f.u.re == doctest::Approx(static_cast<double>(kernel_u(r0, 0, k, nu))).epsilon(1e-14));
  }
}

TEST_CASE("interior: element integrals against brute force, near and far") {
  // Rounding of the coordinates is 1e-16 of them: at 1e-6 of the length it moves what is 1/distance by 1e-10, which
  // curvature amplifies. 1e-8 is what c2d_interior promises there.
  for (int geometry = 0; geometry < 3; ++geometry)
    for (int functions = 1 + geometry % test::effort(2, 1); functions <= 4; functions += test::effort(2, 1)) {
      Brute brute = {test_element(geometry), functions, 0.3L, nullptr, false};
      Integrator in;
      prepare(in, brute.e, functions, 0.3, Quadrature::accurate);
      for (double eta0 : {-1.0, -0.999999, -0.37, 0.8, 1.0})
        for (double distance : {1e-6, 1e-3, 0.1, 1.0, 1.75, 1.85, 3.0, 30.0, 1e4}) {
          const Point p = element_point(brute.e, eta0);
          const Long offset[2] = {Long(-p.nx * distance + 0.1 * p.ny * distance),
                                  Long(-p.ny * distance - 0.1 * p.nx * distance)};
          CAPTURE(geometry);
          CAPTURE(functions);
          CAPTURE(eta0);
          CAPTURE(distance);
          CHECK(worst_error(brute, in, eta0, offset) < (distance < 1e-4 ? 1e-8 : 5e-11));
        }
    }
}

TEST_CASE("interior: tractions per length of another element") {
  const Element bent = test_element(1);
  for (int geometry = 0; geometry < 3; ++geometry) {
    Brute brute = {test_element(geometry), 3, 0.2L, &bent, true};
    Integrator in;
    prepare(in, brute.e, 3, 0.2, Quadrature::accurate);
    set_arc(in, bent, true);
    for (double distance : {1e-6, 0.05, 2.0}) {
      const Point p = element_point(brute.e, 0.4);
      const Long offset[2] = {Long(-p.nx * distance), Long(-p.ny * distance)};
      CAPTURE(geometry);
      CAPTURE(distance);
      CHECK(worst_error(brute, in, 0.4, offset) < 1e-9);
    }
  }
}

// ---- whole problems, through the C interface ------------------------------------------------------------------------

namespace {

struct Condition {
  int32_t codes[4];
  double values[4];
};
using Conditions = test::Callable<Condition(double x, double y, double nx, double ny)>;

struct Answer {
  double v[C2D_POINT_FIELDS];
  double operator[](int c) const { return v[c]; }
  int flag() const { return static_cast<int>(v[C2D_POINT_FLAG]); }
};

// A solved problem; the store and the workspace live here.
struct Solved {
  test::Room memory, region = test::Room(64u << 20);
  c2d_memory_store store = {};
  c2d_solver* s = nullptr;

  Solved() = default;
  Solved(const Solved&) = delete;
  ~Solved() { c2d_close(s); }
  void create(const c2d_limits& limits) {
    uint64_t least = 0, most = 0;
    REQUIRE(c2d_memory_need(&limits, &least, &most, nullptr) == C2D_OK);
    memory.resize(most);
    c2d_memory_store_init(&store, region.data(), region.size());
    c2d_port port = C2D_INIT(c2d_port);
    c2d_memory_store_port(&store, &port);
    port.log = [](void*, const c2d_error* entry) {
      if (entry->severity == C2D_FAULT) MESSAGE(std::string(entry->text));
    };
    REQUIRE(c2d_create(&s, memory.data(), memory.size(), &limits, &port, nullptr) == C2D_OK);
  }
  void load_fully(double mu, double load) {
    c2d_outcome outcome = 0;
    REQUIRE(c2d_prepare(s) == C2D_OK);
    REQUIRE(c2d_begin(s, &mu, 1) == C2D_OK);
    REQUIRE(c2d_advance(s, &load, 1, &outcome) == C2D_OK);
    REQUIRE(outcome == C2D_REACHED);
  }
  std::vector<Answer> at(const std::vector<double>& xy, int body = 0) const {
    std::vector<Answer> out(xy.size() / 2);
    REQUIRE(c2d_interior(s, body, static_cast<int32_t>(out.size()), xy.data(), 2, out[0].v, C2D_POINT_FIELDS) == C2D_OK);
    return out;
  }
  Answer at(double x, double y, int body = 0) const { return at(std::vector<double>{x, y}, body)[0]; }
  std::vector<double> ends(int32_t field, int body, int32_t count) const {
    std::vector<double> out(static_cast<size_t>(count));
    REQUIRE(c2d_get(s, field, body, 1, count, out.data(), 1) == C2D_OK);
    return out;
  }
};

// One body of closed curves through points, with conditions by place; a point load if `force` is not null.
struct OneBody {
  int element_nodes = 2, function_nodes = 2, plane = C2D_PLANE_STRAIN;
  double nu = 0.3;
  std::vector<std::vector<double>> curves;
  const double* force = nullptr; // x, y, fx, fy

  int elements(size_t curve) const { return static_cast<int>(curves[curve].size()) / 2 / (element_nodes - 1); }
  Element element(size_t curve, int e) const {
    double x[4], y[4];
    const size_t points = curves[curve].size() / 2;
    for (int k = 0; k < element_nodes; ++k) {
      const size_t i = static_cast<size_t>(e * (element_nodes - 1) + k) % points;
      x[k] = curves[curve][2 * i];
      y[k] = curves[curve][2 * i + 1];
    }
    return make_element(element_nodes, x, y);
  }
  void solve(const Conditions& conditions, Solved& out) const {
    host::Limits limits;
    limits.bodies = 1;
    limits.function_nodes = function_nodes;
    limits.body[0].regions = static_cast<int32_t>(curves.size());
    limits.point_loads = force ? 1 : 0;
    limits.paths = 1;
    std::vector<double> xy;
    for (size_t c = 0; c < curves.size(); ++c) {
      limits.body[0].elements += elements(c);
      xy.insert(xy.end(), curves[c].begin(), curves[c].end());
    }
    limits.body[0].points = static_cast<int32_t>(xy.size() / 2);
    out.create(limits);
    c2d_problem problem = C2D_INIT(c2d_problem);
    problem.plane = plane;
    c2d_body body = C2D_INIT(c2d_body);
    body.element_nodes = element_nodes;
    body.elements = limits.body[0].elements;
    body.regions = limits.body[0].regions;
    body.youngs_modulus = 1000;
    body.poisson_ratio = nu;
    REQUIRE(c2d_set_problem(out.s, &problem) == C2D_OK);
    REQUIRE(c2d_set_body(out.s, 1, &body) == C2D_OK);
    int32_t first = 1;
    for (size_t c = 0; c < curves.size(); ++c) {
      REQUIRE(c2d_add_region(out.s, 1, first, first + elements(c) - 1) == C2D_OK);
      first += elements(c);
    }
    REQUIRE(c2d_set_nodes(out.s, 1, 1, limits.body[0].points, xy.data(), 2) == C2D_OK);
    first = 1;
    for (size_t c = 0; c < curves.size(); first += elements(c), ++c)
      for (int e = 0; e < elements(c); ++e)
        for (int l = 0; l < function_nodes; ++l) {
          const Point p = element_point(element(c, e), node_eta(function_nodes, l));
          const auto snap = [](double v) { return std::ldexp(std::round(std::ldexp(v, 40)), -40); };
          const Condition at = conditions(snap(p.x), snap(p.y), p.nx, p.ny); // both ends at a node see one place
          REQUIRE(c2d_set_condition(out.s, 1, first + e, l + 1, 1, at.codes, at.values) == C2D_OK);
        }
    if (force) REQUIRE(c2d_add_point_load(out.s, 1, 1, force[0], force[1], force[2], force[3]) == C2D_OK);
    REQUIRE(c2d_add_path(out.s, 1, &kOnce, 1) == C2D_OK);
    REQUIRE(c2d_complete(out.s) == C2D_OK);
    out.load_fully(0, 1);
  }
};

// Straight sides from corner to corner, ended by the first corner again.
std::vector<double> polygon(const std::vector<double>& corners, int elements, int element_nodes) {
  std::vector<double> out;
  const size_t n = corners.size() / 2;
  const int steps = elements * (element_nodes - 1);
  for (size_t i = 0; i < n; ++i)
    for (int k = 0; k < steps; ++k)
      for (size_t c = 0; c < 2; ++c)
        out.push_back(corners[2 * i + c] + (corners[2 * ((i + 1) % n) + c] - corners[2 * i + c]) * k / steps);
  return out;
}

// A uniform state of stress, plane strain or stress, E = 1000.
struct Uniform {
  double sxx = 3, syy = -1.5, sxy = 0.7, nu = 0.3;
  bool strain = true;
  void displacement(double x, double y, double u[2]) const {
    const double e = strain ? 1000 / (1 - nu * nu) : 1000, v = strain ? nu / (1 - nu) : nu;
    const double exx = (sxx - v * syy) / e, eyy = (syy - v * sxx) / e, exy = sxy * (1 + nu) / 1000;
    u[0] = exx * x + exy * y;
    u[1] = exy * x + eyy * y;
  }
  Condition traction(double nx, double ny) const { return {{0, 0, 1, 1}, {sxx * nx + sxy * ny, sxy * nx + syy * ny, 0, 0}}; }
};

} // namespace

TEST_CASE("interior: patch test down to 1e-6 of an element, with a hole, every order") {
  for (int functions = 2; functions <= 4; ++functions)
    for (int plane : {C2D_PLANE_STRAIN, C2D_PLANE_STRESS}) {
      OneBody body;
      body.function_nodes = functions;
      body.plane = plane;
      body.curves = {polygon({-1, -1, 3, -1.5, 3.5, 2, 0, 2.5}, 3, 2), polygon({0.5, 0, 0.7, 1, 1.5, 0.8, 1.2, 0.1}, 2, 2)};
      Uniform exact;
      exact.strain = plane == C2D_PLANE_STRAIN;
      Solved solved;
      body.solve(
          [&](double x, double y, double nx, double ny) {
            Condition c = exact.traction(nx, ny);
            if (nx < -0.9 && x < 0.4) { // the left side is held
              c = {{1, 1, 0, 0}, {0, 0, 0, 0}};
              exact.displacement(x, y, c.values + 2);
            }
            return c;
          },
          solved);
      double worst_stress = 0, worst_u = 0, worst_szz = 0;
      int flags[4] = {0, 0, 0, 0};
      for (size_t curve = 0; curve < 2; ++curve)
        for (int e = 0; e < body.elements(curve); ++e)
          for (double distance : {1e-6, 1e-4, 1e-2})
            for (double eta : {-0.999998, -0.9, -0.5, 0.0, 0.31, 0.999}) {
              const Element element = body.element(curve, e);
              const Point p = element_point(element, eta);
              const double d = distance * 2 * element.half_length, x = p.x - d * p.nx, y = p.y - d * p.ny;
              const Answer a = solved.at(x, y);
              if (a.flag() == C2D_POINT_OUTSIDE) { // past a corner
                CHECK(std::abs(eta) > 0.99);
                continue;
              }
              ++flags[a.flag()];
              double u[2];
              exact.displacement(x, y, u);
              worst_u = std::max({worst_u, std::abs(a[C2D_POINT_UX] - u[0]), std::abs(a[C2D_POINT_UY] - u[1])});
              worst_stress = std::max({worst_stress, std::abs(a[C2D_POINT_SXX] - exact.sxx),
                                       std::abs(a[C2D_POINT_SYY] - exact.syy), std::abs(a[C2D_POINT_SXY] - exact.sxy)});
              const double szz = exact.strain ? 0.3 * (exact.sxx + exact.syy) : 0;
              worst_szz = std::max(worst_szz, std::abs(a[C2D_POINT_SZZ] - szz));
            }
      CAPTURE(functions);
      CHECK(worst_stress < 3e-8); // 1e-8 of the stress
      CHECK(worst_szz < 3e-8);
      CHECK(worst_u < 1e-12); // displacements are of the order of 0.01
      CHECK(flags[C2D_POINT_INSIDE] > 100);
      CHECK(flags[C2D_POINT_NEAR_NODE] > 50);
      CHECK(flags[C2D_POINT_BOUNDARY] == 0);
      const Answer a = solved.at(2.5, 0.3);
      CHECK(a[C2D_POINT_MAX_SHEAR] == doctest::Approx(std::sqrt(2.25 * 2.25 + 0.49)));
      CHECK(a[C2D_POINT_PRINCIPAL1] == doctest::Approx(0.75 + std::sqrt(2.25 * 2.25 + 0.49)));
      CHECK(a[C2D_POINT_PRINCIPAL2] == doctest::Approx(0.75 - std::sqrt(2.25 * 2.25 + 0.49)));
      const double p = (exact.sxx + exact.syy + a[C2D_POINT_SZZ]) / 3, xx = exact.sxx - p, yy = exact.syy - p,
                   zz = a[C2D_POINT_SZZ] - p;
      CHECK(a[C2D_POINT_VON_MISES] == doctest::Approx(std::sqrt(1.5 * (xx * xx + yy * yy + zz * zz + 2 * 0.49))));
      const int32_t ends = 20 * functions; // the boundary's tensor is the same everywhere
      const double expected[4] = {exact.sxx, exact.syy, exact.sxy, exact.strain ? 0.45 : 0.0};
      for (int f = 0; f < 4; ++f)
        for (double value : solved.ends(C2D_END_SXX + f, 1, ends)) CHECK(std::abs(value - expected[f]) < 1e-9);
    }
}

namespace {

// Largest error of the stress over the largest stress, at the points that lie inside.
double uniform_error(const Uniform& exact, const Solved& solved, const std::vector<double>& xy, int* inside) {
  double worst = 0;
  for (const Answer& a : solved.at(xy)) {
    if (a.flag() != C2D_POINT_INSIDE && a.flag() != C2D_POINT_NEAR_NODE) continue;
    ++*inside;
    worst = std::max({worst, std::abs(a[C2D_POINT_SXX] - exact.sxx), std::abs(a[C2D_POINT_SYY] - exact.syy),
                      std::abs(a[C2D_POINT_SXY] - exact.sxy)});
  }
  return worst / 3;
}

} // namespace

TEST_CASE("interior: a uniform state between close boundaries") {
  // Ligament between two holes of 16 straight sides, and a strip: from a tenth of an element to a millionth.
  const Uniform exact;
  const auto held_left = [&](double x, double y, double nx, double ny) {
    Condition c = exact.traction(nx, ny);
    if (nx < -0.9 && x < -1.9) {
      c = {{1, 1, 0, 0}, {0, 0, 0, 0}};
      exact.displacement(x, y, c.values + 2);
    }
    return c;
  };
  for (int functions = 2; functions <= 4; ++functions)
    for (double width : {0.1, 0.01, 1e-3, 1e-4, 1e-6}) {
      if (!test::in_full() && (width == 0.01 || width == 1e-4 || functions == 4)) continue;
      CAPTURE(functions);
      CAPTURE(width);
      OneBody holes, strip;
      holes.function_nodes = strip.function_nodes = functions;
      holes.curves = {polygon({-2, -1, 2, -1, 2, 1, -2, 1}, 4, 2), {}, {}};
      for (size_t h = 0; h < 2; ++h)
        for (int i = 0; i < 16; ++i) {
          const double a = kPi * (h == 0 ? 0 : 1) - kPi * i / 8, r = 0.4, x = (h == 0 ? -1 : 1) * (r + 0.5 * width);
          holes.curves[h + 1].push_back(x + r * std::cos(a));
          holes.curves[h + 1].push_back(r * std::sin(a));
        }
      strip.curves = {{-2, 0, -1, 0, 0, 0, 1, 0, 2, 0, 2, width, 1, width, 0, width, -1, width, -2, width}};
      Solved between, thin;
      holes.solve(held_left, between);
      strip.solve(held_left, thin);
      std::vector<double> in_ligament, in_strip;
      for (double f : {0.02, 0.1, 0.3, 0.5, 0.9, 0.98}) {
        for (double y : {0.0, 0.1 * width, width, 5 * width, 0.01, 0.1})
          in_ligament.insert(in_ligament.end(), {(f - 0.5) * width, y});
        for (double x : {-1.0, 0.0, 0.01, 0.3, 1.05, 1 + width}) in_strip.insert(in_strip.end(), {x, f * width});
      }
      int inside = 0;
      CHECK(uniform_error(exact, between, in_ligament, &inside) < 1e-9);
      // The strip itself is ill conditioned with curved functions: what the boundary has is what there can be.
      double on_boundary = 0;
      for (double value : thin.ends(C2D_END_SXX, 1, 10 * functions))
        on_boundary = std::max(on_boundary, std::abs(value - exact.sxx) / 3);
      CHECK(uniform_error(exact, thin, in_strip, &inside) < 1e-9 + 5 * on_boundary);
      if (width >= 1e-3) CHECK(on_boundary < 1e-7);
      CHECK(inside > 60);
    }
}

TEST_CASE("interior: outside, in a hole, on the boundary") {
  OneBody body;
  body.function_nodes = 3;
  body.element_nodes = 3;
  body.curves = {polygon({0, 0, 4, 0, 4, 4, 0, 4}, 2, 3), {}};
  for (int i = 0; i < 16; ++i) { // clockwise circle of quadratic elements
    const double a = -kPi * i / 8;
    body.curves[1].push_back(2 + std::cos(a));
    body.curves[1].push_back(2 + std::sin(a));
  }
  Solved solved;
  const Uniform exact;
  body.solve(
      [&](double x, double y, double, double) {
        Condition c = {{1, 1, 0, 0}, {0, 0, 0, 0}};
        exact.displacement(x, y, c.values + 2);
        return c;
      },
      solved);
  const double edge = 2 + std::cos(kPi / 8), edge_y = 2 + std::sin(kPi / 8); // a node in the middle of an element
  CHECK(solved.at(-0.1, 1).flag() == C2D_POINT_OUTSIDE);
  CHECK(solved.at(1e6, 1e7).flag() == C2D_POINT_OUTSIDE);
  CHECK(solved.at(2, 2).flag() == C2D_POINT_OUTSIDE);
  CHECK(solved.at(2, 2)[C2D_POINT_VON_MISES] == 0);
  CHECK(solved.at(2, 2.99).flag() == C2D_POINT_OUTSIDE);
  CHECK(solved.at(1, 0).flag() == C2D_POINT_BOUNDARY);
  CHECK(solved.at(1, 1e-10).flag() == C2D_POINT_BOUNDARY);
  CHECK(solved.at(1, -1e-10).flag() == C2D_POINT_BOUNDARY);
  CHECK(solved.at(1, -1e-8).flag() == C2D_POINT_OUTSIDE);
  CHECK(solved.at(1, 1e-8).flag() == C2D_POINT_INSIDE);
  CHECK(solved.at(0, 0).flag() == C2D_POINT_BOUNDARY);
  CHECK(solved.at(edge, edge_y).flag() == C2D_POINT_BOUNDARY);
  CHECK(solved.at(edge + 1e-8, edge_y).flag() == C2D_POINT_INSIDE);
  CHECK(solved.at(edge - 1e-8, edge_y).flag() == C2D_POINT_OUTSIDE);
  CHECK(solved.at(3.5, 2.2).flag() == C2D_POINT_INSIDE);
  CHECK(solved.at(0.01, 0.01).flag() == C2D_POINT_NEAR_NODE);
  double u[2];
  exact.displacement(1.3, 0, u);
  CHECK(solved.at(1.3, 0)[C2D_POINT_UX] == doctest::Approx(u[0]).epsilon(1e-12));
  exact.displacement(edge, edge_y, u);
  CHECK(solved.at(edge, edge_y)[C2D_POINT_UY] == doctest::Approx(u[1]).epsilon(1e-12));

  double xy[2] = {1, 1}, out[C2D_POINT_FIELDS];
  CHECK(c2d_interior(solved.s, 2, 1, xy, 2, out, C2D_POINT_FIELDS) == C2D_ERR_ARGUMENT);
  CHECK(c2d_interior(solved.s, 1, -1, xy, 2, out, C2D_POINT_FIELDS) == C2D_ERR_ARGUMENT);
  CHECK(c2d_interior(solved.s, 1, 1, nullptr, 2, out, C2D_POINT_FIELDS) == C2D_ERR_ARGUMENT);
  CHECK(c2d_interior(solved.s, 1, 2, xy, 2, out, 5) == C2D_ERR_ARGUMENT);
  CHECK(c2d_interior(solved.s, 1, 0, nullptr, 0, nullptr, 0) == C2D_OK);
  CHECK(c2d_interior(nullptr, 1, 1, xy, 2, out, C2D_POINT_FIELDS) == C2D_ERR_ARGUMENT);
}

namespace {

// Quarter of the ring 1 < r < 2 under inner pressure 100 (plane strain, E = 1000): srr, sff = -+ B/r^2 + A.
struct Ring {
  OneBody body;
  Solved solved;
  static constexpr double A = 100.0 / 3, B = 400.0 / 3;

  Ring(int arc_elements, int side_elements, int element_nodes, int function_nodes) {
    body.element_nodes = element_nodes;
    body.function_nodes = function_nodes;
    const int k = element_nodes - 1, along = side_elements * k;
    std::vector<double> p;
    const auto put = [&](double r, double a) { p.push_back(r * std::cos(a)), p.push_back(r * std::sin(a)); };
    for (int i = 0; i < along; ++i) put(1 + 1.0 * i / along, 0);
    for (int i = 0; i < arc_elements * k; ++i) put(2, kPi / 2 * i / (arc_elements * k));
    for (int i = 0; i < along; ++i) p.push_back(0), p.push_back(2 - 1.0 * i / along);
    for (int i = 0; i < arc_elements * k; ++i) put(1, kPi / 2 * (1 - 1.0 * i / (arc_elements * k)));
    body.curves = {p};
    body.solve(
        [&](double x, double y, double nx, double ny) {
          if (ny < -0.999 && y < 1e-12) return Condition{{0, 1, 1, 0}, {0, 0, 0, 0}};
          if (nx < -0.999 && x < 1e-12) return Condition{{1, 0, 0, 1}, {0, 0, 0, 0}};
          const double pressure = x * x + y * y < 2 ? 100 : 0;
          return Condition{{0, 0, 1, 1}, {-pressure * nx, -pressure * ny, 0, 0}};
        },
        solved);
  }
  // Largest error of the stresses over the largest stress there.
  static double error(double x, double y, const Answer& a) {
    const double r2 = x * x + y * y, c = (x * x - y * y) / r2, s = 2 * x * y / r2, d = -B / r2;
    const double scale = A + B / r2;
    return std::max({std::abs(a[C2D_POINT_SXX] - A - d * c), std::abs(a[C2D_POINT_SYY] - A + d * c),
                     std::abs(a[C2D_POINT_SXY] - d * s), std::abs(a[C2D_POINT_SZZ] - 0.3 * 2 * A)}) /
           scale;
  }
};

} // namespace

TEST_CASE("interior: Lame's ring, quadratic elements") {
  for (int n : {8, 16}) {
    Ring ring(n, n / 2, 3, 3);
    double inside = 0, displacement = 0, node = 0, close = 0, side = 0;
    for (double r : {1.2, 1.5, 1.77})
      for (double a : {0.2, 0.7, 1.3}) {
        const double x = r * std::cos(a), y = r * std::sin(a);
        const Answer p = ring.solved.at(x, y);
        CHECK(p.flag() == C2D_POINT_INSIDE);
        inside = std::max(inside, Ring::error(x, y, p));
        const double ur = 1.3 / 1000 * (0.4 * Ring::A * r + Ring::B / r);
        displacement = std::max(displacement, std::abs(std::hypot(p[C2D_POINT_UX], p[C2D_POINT_UY]) / ur - 1));
      }
    for (int e = 0; e < ring.body.elements(0); ++e)
      for (double eta : {-1.0, 1.0}) {
        const Element element = ring.body.element(0, e);
        const Point end = element_point(element, eta);
        // At 0.01 of an element from the node in three directions, away from the ring's corners' other sides.
        for (double angle : {0.25, 0.5, 0.75}) {
          const double d = 0.02 * element.half_length, c = std::cos(kPi * angle), s = std::sin(kPi * angle);
          const double tx = -end.ny, ty = end.nx; // direction of travel; the inside is to its left
          const double x = end.x + d * (c * tx - s * ty), y = end.y + d * (c * ty + s * tx);
          const Answer p = ring.solved.at(x, y);
          if (p.flag() == C2D_POINT_OUTSIDE) continue;
          CHECK(p.flag() == C2D_POINT_NEAR_NODE);
          node = std::max(node, Ring::error(x, y, p));
        }
        for (double distance : {0.02, 0.05, 0.08, 0.12, 0.2}) {
          const double d = distance * 2 * element.half_length, x = end.x - d * end.nx, y = end.y - d * end.ny;
          const Answer p = ring.solved.at(x, y);
          if (p.flag() == C2D_POINT_INSIDE || p.flag() == C2D_POINT_NEAR_NODE) close = std::max(close, Ring::error(x, y, p));
        }
      }
    for (int e = 0; e < ring.body.elements(0); ++e)
      for (double eta : {-0.7, 0.0, 0.5}) {
        const Element element = ring.body.element(0, e);
        const Point p = element_point(element, eta);
        const double d = 2e-6 * element.half_length, x = p.x - d * p.nx, y = p.y - d * p.ny;
        side = std::max(side, Ring::error(x, y, ring.solved.at(x, y)));
      }
    CAPTURE(n);
    INFO("inside " << inside << ", u " << displacement << ", 0.01 from nodes " << node << ", 0.02-0.2 from nodes " << close
                   << ", 1e-6 from sides " << side);
    // What the mesh is worth: second order at least everywhere, fourth inside.
    const double h = 8.0 / n;
    CHECK(inside < 2e-4 * h * h * h * h);
    CHECK(displacement < 2e-5 * h * h * h * h);
    CHECK(node < 0.0045 * h * h);
    CHECK(close < 0.0035 * h * h);
    CHECK(side < 0.008 * h * h);
    // Hoop stress of the boundary: sff on the arcs, srr on the straight sides.
    const int32_t ends = 3 * ring.body.elements(0);
    const std::vector<double> x = ring.solved.ends(C2D_END_X, 1, ends), y = ring.solved.ends(C2D_END_Y, 1, ends),
                              hoop = ring.solved.ends(C2D_END_HOOP, 1, ends);
    double worst = 0;
    for (size_t i = 0; i < x.size(); ++i) {
      const size_t element = i / 3, first_arc = static_cast<size_t>(n / 2);
      const bool arc = element / first_arc == 1 || element / first_arc == 2 || element / first_arc >= 4;
      const double r2 = x[i] * x[i] + y[i] * y[i];
      worst = std::max(worst, std::abs(hoop[i] - Ring::A - (arc ? 1 : -1) * Ring::B / r2) / (Ring::A + Ring::B / r2));
    }
    CHECK(worst < 0.006 * h * h);
  }
}

namespace {

struct FileCards {
  std::ifstream file;
  static int32_t read(void* context, char* text, int32_t size) {
    std::string line;
    if (!std::getline(static_cast<FileCards*>(context)->file, line)) return -1;
    std::strncpy(text, line.c_str(), static_cast<size_t>(size) - 1);
    text[size - 1] = 0;
    return static_cast<int32_t>(line.size());
  }
};

// The deck's model under `load`.
void solve_deck(const char* name, double mu, double load, Solved& out) {
  const std::string path = paths::root() + "/tests/data/decks/" + name;
  FileCards scan = {std::ifstream(path)}, cards = {std::ifstream(path)};
  host::Limits limits;
  REQUIRE(c2d_scan_deck(FileCards::read, &scan, &limits, nullptr) == C2D_OK);
  out.create(limits);
  REQUIRE(c2d_read_deck(out.s, FileCards::read, &cards) == C2D_OK);
  out.load_fully(mu, load);
}

// int syy dx, int sxy dx over a horizontal cut, by Gauss points on equal panels.
void cut_forces(const Solved& solved, int body, double x0, double x1, double y, double out[2]) {
  const double node[4] = {0.18343464249564981, 0.52553240991632899, 0.79666647741362674, 0.96028985649753623};
  const double weight[4] = {0.36268378337836198, 0.31370664587788729, 0.22238103445337447, 0.10122853629037626};
  out[0] = out[1] = 0;
  for (int panel = 0; panel < 8; ++panel)
    for (int i = 0; i < 8; ++i) {
      const double half = (x1 - x0) / 16, x = x0 + half * (2 * panel + 1) + half * (i < 4 ? -node[i] : node[i - 4]);
      const Answer a = solved.at(x, y, body);
      CHECK(a.flag() <= C2D_POINT_NEAR_NODE);
      out[0] += half * weight[i % 4] * a[C2D_POINT_SYY];
      out[1] += half * weight[i % 4] * a[C2D_POINT_SXY];
    }
}

} // namespace

namespace {

// Width of body 2 at a height, by bisection on the flags.
double width_at(const Solved& solved, double y) {
  double inside = 0.1, outside = 8.5;
  for (int i = 0; i < 60; ++i) {
    const double x = 0.5 * (inside + outside);
    (solved.at(x, y, 2).flag() == C2D_POINT_OUTSIDE ? outside : inside) = x;
  }
  return inside;
}

} // namespace

TEST_CASE("interior: the thesis's cylinder, equilibrium of cuts through both bodies") {
  Solved solved;
  solve_deck("sample.dat", 0.4, 1.0, solved);
  double force[2];
  for (double y : {-0.3, -1.0, -2.5, -3.7}) {
    cut_forces(solved, 1, 0, 8, y, force);
    CAPTURE(y);
    CHECK(force[0] == doctest::Approx(-455.06).epsilon(1e-3));
  }
  // The upper body is meshed coarsely: 0.65 % at worst (0.01 % with quadratic functions on the same polygon).
  for (double y : {0.6, 2.0, 8.0, 12.0}) {
    cut_forces(solved, 2, 0, width_at(solved, y), y, force);
    CAPTURE(y);
    CHECK(force[0] == doctest::Approx(-455.06).epsilon(y < 1 ? 1e-3 : 8e-3));
  }
  CHECK(solved.at(0.5, 3).flag() == C2D_POINT_INSIDE); // finds the body itself
  CHECK(solved.at(0.5, 3)[C2D_POINT_UY] == solved.at(0.5, 3, 2)[C2D_POINT_UY]);
  CHECK(solved.at(0.5, 3, 1).flag() == C2D_POINT_OUTSIDE);
  CHECK(solved.at(7.9, 0.5).flag() == C2D_POINT_OUTSIDE); // between them
  CHECK(solved.at(0.05, 0).flag() == C2D_POINT_BOUNDARY);

  Solved finer; // another mesh, load 60.3125 over a width of 8
  solve_deck("half_cylinder.dat", 0.4, 1.0, finer);
  for (double y : {2.0, 5.0, 7.0}) {
    cut_forces(finer, 2, 0, width_at(finer, y), y, force);
    CAPTURE(y);
    CHECK(force[0] == doctest::Approx(-482.5).epsilon(1e-3));
  }
}

TEST_CASE("interior: joins the boundary on both sides of a contact") {
  Solved solved;
  solve_deck("sample56.dat", 0.4, 1.0, solved);
  host::Summary summary;
  REQUIRE(host::get_summary(solved.s, summary) == C2D_OK);
  for (int body = 1; body <= 2; ++body) {
    const int32_t ends = 2 * summary.body[body - 1].elements;
    std::vector<double> field[7];
    for (int f = 0; f < 3; ++f) field[f] = solved.ends(C2D_END_SXX + f, body, ends);
    field[3] = solved.ends(C2D_END_X, body, ends);
    field[4] = solved.ends(C2D_END_Y, body, ends);
    field[5] = solved.ends(C2D_END_STATUS, body, ends);
    double largest = 0, largest_u = 0;
    for (double u : solved.ends(C2D_END_UX, body, ends)) largest_u = std::max(largest_u, std::abs(u));
    for (double s : field[1]) largest = std::max(largest, std::abs(s));
    double worst = 0, worst_u = 0;
    int touching = 0;
    for (size_t i = 0; i + 1 < static_cast<size_t>(ends); i += 2) {
      if (!(field[5][i] > 0) || !(field[5][i + 1] > 0)) continue; // both ends touch
      ++touching;
      const double x = 0.5 * (field[3][i] + field[3][i + 1]), y = 0.5 * (field[4][i] + field[4][i + 1]);
      const double dx = field[3][i + 1] - field[3][i], dy = field[4][i + 1] - field[4][i];
      const Answer near = solved.at(x - 1e-6 * dy, y + 1e-6 * dx, body), on = solved.at(x, y, body);
      CHECK(near.flag() == C2D_POINT_INSIDE);
      CHECK(on.flag() == C2D_POINT_BOUNDARY);
      for (int c = 0; c < 3; ++c) {
        const int field_of_point = C2D_POINT_SXX + c;
        worst = std::max(worst, std::abs(near[field_of_point] - on[field_of_point]) / largest);
      }
      worst_u = std::max(worst_u, std::hypot(near[0] - on[0], near[1] - on[1]) / largest_u);
    }
    CHECK(touching > 10);
    CHECK(worst < 0.02);
    CHECK(worst_u < 0.002);
  }
}

TEST_CASE("interior: a point load inside, order four, plane stress") {
  // The full plane's own field, its displacement prescribed on part of the boundary and its traction elsewhere.
  const double load[4] = {0.4, 0.3, 200, -100}, nu = 0.25, nu_strain = nu / (1 + nu), g2 = 1000 / (1 + nu);
  OneBody body;
  body.function_nodes = 4;
  body.nu = nu;
  body.plane = C2D_PLANE_STRESS;
  body.curves = {polygon({-1, -1, 1.5, -1, 1.5, 1.5, -1, 1.5}, 8, 2)};
  body.force = load;
  const auto exact = [&](double x, double y, double u[2], double s[3]) {
    const Long r[2] = {load[0] - x, load[1] - y};
    const int ij[3][2] = {{0, 0}, {1, 1}, {0, 1}};
    for (int i = 0; i < 2; ++i)
      u[i] = static_cast<double>(kernel_u(r, i, 0, nu_strain) * load[2] + kernel_u(r, i, 1, nu_strain) * load[3]) / g2;
    for (int c = 0; c < 3; ++c)
      s[c] = static_cast<double>(kernel_d(r, ij[c][0], ij[c][1], 0, nu_strain) * load[2] +
                                 kernel_d(r, ij[c][0], ij[c][1], 1, nu_strain) * load[3]);
  };
  Solved solved;
  body.solve(
      [&](double x, double y, double nx, double ny) {
        double u[2], s[3];
        exact(x, y, u, s);
        if (nx < -0.9) return Condition{{1, 1, 0, 0}, {0, 0, u[0], u[1]}};
        return Condition{{0, 0, 1, 1}, {s[0] * nx + s[2] * ny, s[2] * nx + s[1] * ny, 0, 0}};
      },
      solved);
  for (double x : {-0.8, 0.1, 0.42, 1.1})
    for (double y : {-0.7, 0.31, 1.2}) {
      double u[2], s[3];
      exact(x, y, u, s);
      const Answer a = solved.at(x, y);
      const double size = std::abs(s[0]) + std::abs(s[1]) + std::abs(s[2]);
      CAPTURE(x);
      CAPTURE(y);
      for (int c = 0; c < 3; ++c) CHECK(std::abs(a[C2D_POINT_SXX + c] - s[c]) < 1e-4 * size);
      for (int c = 0; c < 2; ++c) CHECK(std::abs(a[c] - u[c]) < 5e-7); // of 0.05 at most
      CHECK(a[C2D_POINT_SZZ] == 0);
    }
  CHECK(std::isfinite(solved.at(0.4, 0.3)[C2D_POINT_SXX])); // at the load itself
}

TEST_CASE("interior: constant elements and a double node") {
  OneBody constant;
  constant.function_nodes = 1;
  constant.curves = {polygon({0, 0, 2, 0, 2, 1, 0, 1}, 20, 2)};
  const Uniform exact;
  Solved solved;
  const auto held_left = [&](double x, double y, double nx, double ny) {
    Condition c = exact.traction(nx, ny);
    if (nx < -0.9) {
      c = {{1, 1, 0, 0}, {0, 0, 0, 0}};
      exact.displacement(x, y, c.values + 2);
    }
    return c;
  };
  constant.solve(held_left, solved);
  for (double x : {0.4, 1.0, 1.6}) // first order: steps of displacement
    CHECK(solved.at(x, 0.45)[C2D_POINT_SXX] == doctest::Approx(exact.sxx).epsilon(0.02));
  const Answer corner = solved.at(1.5 + 0.002, 0.002); // 0.02 of an element from an end, where displacement steps
  CHECK(corner.flag() == C2D_POINT_NEAR_NODE);
  CHECK(corner[C2D_POINT_SXX] == doctest::Approx(exact.sxx).epsilon(0.1));

  OneBody twin;
  twin.curves = {{0, 0, 1, 0, 2, 0, 2, 0, 2, 1, 1, 1, 0, 1, 0, 0.5}}; // the corner (2, 0) twice
  Solved other;
  twin.solve(held_left, other);
  for (double d : {1e-6, 0.01, 0.3}) {
    const Answer a = other.at(2 - d, 0.7 * d);
    for (int c = 0; c < 3; ++c)
      CHECK(a[C2D_POINT_SXX + c] == doctest::Approx(c == 0 ? exact.sxx : c == 1 ? exact.syy : exact.sxy).epsilon(1e-8));
  }
}

TEST_CASE("interior: nothing raises a floating-point exception that hosts trap") {
  Ring ring(6, 3, 3, 3);
  Solved contact;
  solve_deck("sample.dat", 0.4, 1.0, contact);
  std::vector<double> xy;
  for (double y = -4; y <= 16; y += 0.5)
    for (double x = 0; x <= 8; x += 0.5) xy.insert(xy.end(), {x, y, x * 1e-7, y, x, y * 1e-7});
  xy.insert(xy.end(), {1e150, 0, 0, -1e308, 1, 0, 0, 1, 1e-300, 1e-300, 1e308, 1, 1, -1e308, 1e50, 1});
  std::vector<Answer> out(xy.size() / 2);
  const int32_t count = static_cast<int32_t>(out.size());
  std::feclearexcept(FE_ALL_EXCEPT);
  const c2d_status first = c2d_interior(ring.solved.s, 0, count, xy.data(), 2, out[0].v, C2D_POINT_FIELDS);
  const c2d_status second = c2d_interior(contact.s, 0, count, xy.data(), 2, out[0].v, C2D_POINT_FIELDS);
  for (double none : {NAN, INFINITY, -INFINITY}) {
    const double point[2] = {1, none};
    double row[C2D_POINT_FIELDS];
    CHECK(c2d_interior(ring.solved.s, 0, 1, point, 2, row, C2D_POINT_FIELDS) == C2D_ERR_ARGUMENT);
  }
  CHECK(std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW) == 0);
  CHECK(first == C2D_OK);
  CHECK(second == C2D_OK);
  int flags[4] = {0, 0, 0, 0};
  CHECK(out[out.size() - 3].flag() == C2D_POINT_OUTSIDE);
  for (const Answer& a : out) {
    ++flags[a.flag()];
    for (double v : a.v) CHECK(std::isfinite(v));
  }
  for (int f : flags) CHECK(f > 0);
}

TEST_CASE("interior: one point at a time, strides, both bodies: the same numbers") {
  Solved solved;
  solve_deck("sample.dat", 0.4, 1.0, solved);
  const std::vector<double> xy = {1, 3, 2, -1, 0.3, 0.2, 9, 9, 0.01, -1e-7};
  const std::vector<Answer> together = solved.at(xy);
  double wide[5][20], places[5][3];
  for (int i = 0; i < 5; ++i) {
    const Answer alone = solved.at(xy[static_cast<size_t>(2 * i)], xy[static_cast<size_t>(2 * i + 1)]);
    CHECK(std::memcmp(alone.v, together[static_cast<size_t>(i)].v, sizeof alone.v) == 0);
    for (int c = 0; c < 2; ++c) places[i][c] = xy[static_cast<size_t>(2 * i + c)];
    wide[i][C2D_POINT_FIELDS] = 77;
  }
  REQUIRE(c2d_interior(solved.s, 0, 5, places[0], 3, wide[0], 20) == C2D_OK);
  for (int i = 0; i < 5; ++i) {
    CHECK(std::memcmp(wide[i], together[static_cast<size_t>(i)].v, sizeof(Answer)) == 0);
    CHECK(wide[i][C2D_POINT_FIELDS] == 77);
  }
  // The answer at zero load is zero, and before that there is none.
  const double mu = 0.4;
  REQUIRE(c2d_begin(solved.s, &mu, 1) == C2D_OK);
  CHECK(solved.at(1, 3).flag() == C2D_POINT_INSIDE);
  CHECK(solved.at(1, 3)[C2D_POINT_VON_MISES] == 0);
}
