// Holes at any Poisson's ratio up to 0.5: Lame's ring, exact states with several holes of odd shapes, and incompressible
// bodies whose pressure nothing determines.
#include "bie/holes.hpp"
#include "callable.hpp"
#include "model_fixture.hpp"
#include "problem.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cfenv>
#include <cmath>
#include <complex>
#include <vector>

using namespace problem;

namespace {

constexpr double kPi = 3.14159265358979323846;

struct State { // displacements and stresses at a point
  double ux, uy, sxx, syy, sxy;
};
using Field = test::Callable<State(double x, double y)>;
struct Elastic {
  double g, nu; // shear modulus and Poisson's ratio, plane strain
};
Elastic moduli(const Problem& p) {
  const Body& body = p.bodies[0];
  return {body.youngs_modulus / (2 * (1 + body.poisson_ratio)), body.poisson_ratio};
}

// Kolosov's formulas: 2G (ux + i uy) = (3 - 4 nu) phi - z conj(phi') - conj(psi).
using C = std::complex<double>;
State kolosov(const Elastic& m, C z, C phi, C phi1, C phi2, C psi, C psi1) {
  const C u = ((3 - 4 * m.nu) * phi - z * std::conj(phi1) - std::conj(psi)) / (2 * m.g);
  const double trace = 4 * phi1.real();
  const C deviator = 2.0 * (std::conj(z) * phi2 + psi1); // syy - sxx + 2i sxy
  return {u.real(), u.imag(), 0.5 * (trace - deviator.real()), 0.5 * (trace + deviator.real()), 0.5 * deviator.imag()};
}
Field lame(const Elastic& m, double pressure_inside, double a, double b, double cx, double cy) {
  const double s = pressure_inside * a * a / (b * b - a * a);
  return [=](double x, double y) {
    const C z(x - cx, y - cy);
    return kolosov(m, z, 0.5 * s * z, 0.5 * s, 0.0, -s * b * b / z, s * b * b / (z * z));
  };
}
// A pressure and a force without resultant out of each of two points, one in either hole, in a field of constant stress.
Field two_sources(const Elastic& m, C a, C b) {
  return [=](double x, double y) {
    const C z(x, y), da = 1.0 / (z - a), db = 1.0 / (z - b), c(0.03, -0.02);
    return kolosov(m, z, 0.2 * z + c * da, 0.2 - c * da * da, 2.0 * c * da * da * da, -0.3 * da - 0.2 * db + 0.1 * z,
                   0.3 * da * da + 0.2 * db * db + 0.1);
  };
}

enum class Given { traction, displacement };
using Choice = test::Callable<Given(double x, double y, double nx, double ny)>;

double error(Problem p, const Field& exact, const Choice& choose, const Setup& setup = Setup()) {
  std::vector<State> wanted;
  std::vector<double> normal;
  set_ends(p, 1, [&](double x, double y, double nx, double ny, End& end) {
    const State s = exact(x, y);
    const double t[2] = {s.sxx * nx + s.sxy * ny, s.sxy * nx + s.syy * ny}, u[2] = {s.ux, s.uy};
    const bool fixed = choose(x, y, nx, ny) == Given::displacement;
    for (int c = 0; c < 2; ++c) {
      end.codes[c] = fixed ? 1 : 0;
      end.codes[2 + c] = fixed ? 0 : 1;
      end.values[fixed ? 2 + c : c] = fixed ? u[c] : t[c];
    }
    wanted.push_back({u[0], u[1], t[0], t[1], 0});
  });
  const Result r = solve(p, setup);
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  REQUIRE(r.boundary[0].size() == wanted.size());
  double du = 0, dt = 0, u = 0, t = 0;
  for (size_t i = 0; i < wanted.size(); ++i) {
    const EndResult& end = r.boundary[0][i];
    u = std::max(u, std::hypot(wanted[i].ux, wanted[i].uy));
    t = std::max(t, std::hypot(wanted[i].sxx, wanted[i].syy));
    du = std::max(du, std::hypot(end.ux - wanted[i].ux, end.uy - wanted[i].uy));
    dt = std::max(dt, std::hypot(end.tx - wanted[i].sxx, end.ty - wanted[i].syy));
  }
  return std::max(du / u, dt / t);
}

Problem body(double nu, int32_t functions = 3, double unit = 1, double modulus = 1000) {
  Problem p;
  p.analysis = C2D_ANALYSIS_STRESS;
  p.function_nodes = functions;
  p.bodies.resize(1);
  p.bodies[0].element_nodes = functions < 3 ? 2 : functions;
  p.bodies[0].youngs_modulus = modulus / (unit * unit);
  p.bodies[0].poisson_ratio = nu;
  return p;
}
void add_circle(Problem& p, int32_t n, double cx, double cy, double r, bool hole) {
  add_curve(p.bodies[0], n, [=](double s, double& x, double& y) {
    const double angle = 2 * kPi * (hole ? -s : s);
    x = cx + r * std::cos(angle), y = cy + r * std::sin(angle);
  });
}
constexpr double kRatios[] = {0.0, 0.3, 0.49, 0.4999, 0.499999, 0.5};

Given outer_given(double x, double y, double nx, double ny) {
  return nx * (x - 2) + ny * (y + 1) > 0 ? Given::displacement : Given::traction;
}
Given inner_given(double x, double y, double nx, double ny) {
  return nx * (x - 2) + ny * (y + 1) < 0 ? Given::displacement : Given::traction;
}

} // namespace

TEST_CASE("holes: Lame's ring, pressed inside and held outside, or the other way, up to nu = 0.5") {
  for (const Choice& choose : {Choice(outer_given), Choice(inner_given)})
    for (double nu : kRatios) {
      double before = 1;
      for (int32_t n : {8, 16}) {
        CAPTURE(nu);
        CAPTURE(n);
        Problem p = body(nu);
        add_circle(p, 2 * n, 2, -1, 2, false);
        add_circle(p, n, 2, -1, 1, true);
        const double now = error(p, lame(moduli(p), 5, 1, 2, 2, -1), choose);
        CAPTURE(now);
        CHECK(now < before / 5); // quadratic elements: third order
        before = now;
      }
      CHECK(before < 5e-3); // measured 2e-4 and 3.1e-3, for every ratio
    }
}

TEST_CASE("holes: units of length and stress do not matter") {
  double first = 0;
  for (double unit : {1.0, 1e-3, 77.0})
    for (double modulus : {1000.0, 2e9}) {
      Problem p = body(0.5, 3, unit, modulus);
      add_circle(p, 16, 2 * unit, -unit, 2 * unit, false);
      add_circle(p, 8, 2 * unit, -unit, unit, true);
      const double now =
          error(p, lame(moduli(p), p.bodies[0].youngs_modulus, unit, 2 * unit, 2 * unit, -unit),
                [unit](double x, double y, double nx, double ny) { return outer_given(x / unit, y / unit, nx, ny); });
      if (first == 0) first = now;
      CHECK(std::fabs(now - first) < 1e-9);
    }
}

TEST_CASE("holes: two of them, a square and a slanted one, in an exact state") {
  // The field's sources stand off the centroids, where tr V is taken, or in them, where its errors all point the same way.
  for (bool centred : {false, true}) {
    for (int32_t functions : {2, 3, 4}) {
      double compressible[2] = {0, 0};
      const C first = centred ? C(0.9, 0.5) : C(0.8, 0.62), second = centred ? C(2.7, 0.45) : C(2.6, 0.3);
      for (double nu : kRatios)
        for (int32_t n : {2, 4}) {
          CAPTURE(functions);
          CAPTURE(nu);
          CAPTURE(n);
          Problem p = body(nu, functions);
          add_polygon(p.bodies[0], {{0, -1, 6 * n}, {4, -1, 4 * n}, {4, 2, 6 * n}, {0, 2, 4 * n}});
          add_polygon(p.bodies[0], {{0.4, 0, 2 * n}, {0.4, 1, 2 * n}, {1.4, 1, 2 * n}, {1.4, 0, 2 * n}});
          add_polygon(p.bodies[0], {{1.9, -0.5, 4 * n}, {2.5, 1.2, 2 * n}, {3.5, 1.4, 4 * n}, {2.9, -0.4, 2 * n}});
          const Field exact = two_sources(moduli(p), first, second);
          const double now = error(p, exact, [](double x, double, double nx, double) {
            return nx < -0.999 && x == 0 ? Given::displacement : Given::traction;
          });
          CAPTURE(now);
          double& reference = compressible[n == 2 ? 0 : 1];
          if (nu == 0.0) {
            reference = now;
            if (n == 4) CHECK(now < 0.5 * compressible[0]);
          }
          // Incompressible or not; 1/(1 - 2 nu) goes up to 5e5.
          if (!centred || functions > 2)
            CHECK(now < 3 * reference);
          else
            CHECK(now < (n == 2 ? 0.13 : 0.05)); // second order
        }
      CHECK(compressible[1] < (functions == 2 ? 0.02 : 0.003));
    }
  }
}

TEST_CASE("holes: by images, closed ones beside the lines and open ones across them") {
  // A block [-3,3] x [-2,2] with holes at (+-1.5, 0) and one at the origin; a field that both lines mirror.
  const auto exact = [](const Elastic& m) {
    return Field([m](double x, double y) {
      const C z(x, y), l = 1.0 / (z + 1.6), r = 1.0 / (z - 1.6), o = 1.0 / z;
      return kolosov(m, z, 0.2 * z, 0.2, 0.0, -0.3 * (l + r) - 0.2 * o + 0.1 * z, 0.3 * (l * l + r * r) + 0.2 * o * o + 0.1);
    });
  };
  for (double nu : {0.3, 0.5}) {
    CAPTURE(nu);
    Problem whole = body(nu);
    const int n = 6;
    add_polygon(whole.bodies[0], {{-3, -2, 2 * n}, {3, -2, 2 * n}, {3, 2, 2 * n}, {-3, 2, 2 * n}});
    for (double x : {-1.6, 0.0, 1.6}) add_circle(whole, 2 * n, x, 0, 0.6, true);
    const Choice outside = [](double, double y, double, double ny) {
      return std::fabs(ny) > 0.999 && std::fabs(y) == 2 ? Given::displacement : Given::traction;
    };
    const Choice inside = [](double x, double y, double, double) {
      return std::fabs(x) == 3 || std::fabs(y) == 2 ? Given::traction : Given::displacement;
    };
    for (const Choice& choose : {outside, inside}) {
      const double full = error(whole, exact(moduli(whole)), choose);
      CAPTURE(full);
      CHECK(full < 0.02);
      Problem half = body(nu); // x >= 0: the hole at the origin is cut, the one at 1.6 is closed
      half.symmetry = 1;
      Body& b = half.bodies[0];
      const auto point = [&](double x, double y) { b.xy.insert(b.xy.end(), {x, y}); };
      const double corner[][3] = {{0, -2, n}, {3, -2, 2 * n}, {3, 2, n}, {0, 2, 0}};
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 2 * corner[i][2]; ++k) {
          const double s = k / (2 * corner[i][2]);
          point(corner[i][0] + s * (corner[i + 1][0] - corner[i][0]), corner[i][1] + s * (corner[i + 1][1] - corner[i][1]));
        }
      point(0, 2);
      for (int k = 0; k <= 2 * n; ++k) {
        const double angle = kPi / 2 - kPi * k / (2 * n);
        point(k == 0 || k == 2 * n ? 0 : 0.6 * std::cos(angle), 0.6 * std::sin(angle));
      }
      b.regions = {{1, 4 * n}, {4 * n + 1, 5 * n}};
      b.open_regions = 2;
      add_circle(half, 2 * n, 1.6, 0, 0.6, true);
      const double cut = error(half, exact(moduli(half)), choose);
      CAPTURE(cut);
      CHECK(cut < 0.02);
      CHECK(cut < 1.1 * full); // the same mesh
    }
  }
}

TEST_CASE("holes: point loads, weight and double nodes at nu = 0.5 are the limit of those below") {
  // Solutions are analytic in the ratio: 1 - 2 nu changes them in proportion.
  const auto state = [](double nu) {
    Problem p = body(nu, 2);
    add_polygon(p.bodies[0], {{0, 0, 16}, {4, 0, 12}, {4, 3, 16}, {0, 3, 12}});
    add_polygon(p.bodies[0], {{1, 1, 1}, {1, 1, 6}, {1, 2, 6}, {2, 2, 6}, {2, 1, 6}}); // its first corner is double
    add_circle(p, 16, 3, 1.5, 0.5, true);
    set_ends(p, 1, [](double, double y, double, double ny, End& end) {
      if (ny < -0.999 && y == 0) end = End{{1, 1, 0, 0}, {0, 0, 0, 0}};
    });
    p.point_loads = {{1, 2.3, 0.6, 2, -3}};
    p.body_forces = {{1, 1, 0.5, -2}};
    const Result r = solve(p);
    REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
    return r;
  };
  const Result limit = state(0.5);
  const double near = boundary_difference(limit, state(0.4999)), nearer = boundary_difference(limit, state(0.499999));
  CAPTURE(near);
  CAPTURE(nearer);
  CHECK(near < 1e-3);
  CHECK(nearer < 0.011 * near);
}

TEST_CASE("holes: an incompressible body that is held everywhere has no definite pressure") {
  for (bool rollers : {false, true})
    for (double nu : {0.5, 0.499}) {
      CAPTURE(rollers);
      Problem p = body(nu, 2);
      add_polygon(p.bodies[0], {{0, 0, 4}, {2, 0, 4}, {2, 1, 4}, {0, 1, 4}});
      set_ends(p, 1, [&](double, double, double nx, double, End& end) {
        for (int c = 0; c < 2; ++c)
          if (!rollers || (c == 0) == (std::fabs(nx) > 0.5)) end.codes[c] = 1, end.codes[2 + c] = 0;
      });
      if (!rollers) p.bodies[0].ends[0].values[1] = 1; // no matter what
      const Result r = solve(p);
      CAPTURE(r.messages());
      CHECK((r.status == C2D_OK) == (nu < 0.5));
      if (nu == 0.5) CHECK(r.messages().find("nothing determines its pressure") != std::string::npos);
    }
}

namespace {

// Magnitudes of displacements and tractions at all ends, in order of size: what no rotation, reflection or numbering changes.
std::vector<double> magnitudes(const Result& r, bool tractions) {
  std::vector<double> out;
  for (const EndResult& end : r.boundary[0]) out.push_back(tractions ? std::hypot(end.tx, end.ty) : std::hypot(end.ux, end.uy));
  std::sort(out.begin(), out.end());
  return out;
}
double difference(const Problem& p, const Problem& q) {
  const Result a = solve(p), b = solve(q);
  REQUIRE_MESSAGE(a.status == C2D_OK, a.messages());
  REQUIRE_MESSAGE(b.status == C2D_OK, b.messages());
  double worst = 0;
  for (bool tractions : {false, true}) {
    const std::vector<double> x = magnitudes(a, tractions), y = magnitudes(b, tractions);
    REQUIRE(x.size() == y.size());
    for (size_t i = 0; i < x.size(); ++i) worst = std::max(worst, std::fabs(x[i] - y[i]) / x.back());
  }
  return worst;
}

} // namespace

TEST_CASE("holes: bodies turned, mirrored, numbered otherwise give the same but for round-off") {
  // Square, circle, L, U (its centroid lies outside, two circles are as good), a crooked channel, a thin slit.
  const std::vector<test::Callable<void(Body&, double, double)>> shapes = {
      [](Body& b, double x, double y) {
        add_polygon(b, {{x, y, 2}, {x, y + 0.8, 2}, {x + 0.8, y + 0.8, 2}, {x + 0.8, y, 2}});
      },
      [](Body& b, double x, double y) {
        add_curve(b, 7, [=](double s, double& px, double& py) {
          px = x + 0.4 + 0.4 * std::cos(2 * kPi * s), py = y + 0.4 - 0.4 * std::sin(2 * kPi * s);
        });
      },
      [](Body& b, double x, double y) {
        add_polygon(
            b,
            {{x, y, 3}, {x, y + 0.9, 1}, {x + 0.3, y + 0.9, 2}, {x + 0.3, y + 0.3, 2}, {x + 0.9, y + 0.3, 1}, {x + 0.9, y, 3}});
      },
      [](Body& b, double x, double y) {
        add_polygon(b, {{x, y, 3},
                        {x, y + 0.9, 1},
                        {x + 0.2, y + 0.9, 3},
                        {x + 0.2, y + 0.2, 2},
                        {x + 0.7, y + 0.2, 3},
                        {x + 0.7, y + 0.9, 1},
                        {x + 0.9, y + 0.9, 3},
                        {x + 0.9, y, 3}});
      },
      [](Body& b, double x, double y) {
        add_polygon(b, {{x, y, 3},
                        {x + 0.1, y + 0.9, 3},
                        {x + 0.9, y + 0.8, 1},
                        {x + 0.85, y + 0.65, 2},
                        {x + 0.2, y + 0.7, 3},
                        {x + 0.3, y + 0.1, 1}});
      },
      [](Body& b, double x, double y) {
        add_polygon(b, {{x, y, 1}, {x, y + 0.1, 4}, {x + 0.9, y + 0.2, 1}, {x + 0.9, y + 0.1, 4}});
      }};
  std::vector<std::vector<size_t>> bodies = {{0}, {1}, {2}, {3}, {4}, {5}, {0, 3}, {2, 1}, {3, 4}, {5, 2, 0}, {3, 3, 1}};
  for (const std::vector<size_t>& holes : bodies)
    for (int32_t functions : {2, 3}) {
      CAPTURE(holes.size());
      CAPTURE(holes[0]);
      CAPTURE(functions);
      Problem p = body(0.48, functions);
      p.bodies[0].element_nodes = 2;
      const double width = 0.3 + 1.2 * static_cast<double>(holes.size());
      add_polygon(p.bodies[0], {{0, 0, 5}, {width, 0, 4}, {width, 1.5, 5}, {0, 1.5, 4}});
      for (size_t i = 0; i < holes.size(); ++i) shapes[holes[i]](p.bodies[0], 0.3 + 1.2 * static_cast<double>(i), 0.3);
      set_ends(p, 1, [&](double x, double y, double nx, double ny, End& end) {
        const double outer = y == 0 && ny < -0.999 ? -1 : y == 1.5 && ny > 0.999 ? 1 : 0;
        if (outer < 0) end = End{{1, 1, 0, 0}, {0, 0, 0, 0}};
        if (outer > 0) end.values[0] = 1 + x, end.values[1] = 2 - 0.3 * x;
        if (outer == 0 && x == 0) end.values[0] = nx;
      });
      for (double angle : {90.0, 37.0, 211.5}) CHECK(difference(p, rotated(p, angle)) < 1e-10);
      CHECK(difference(p, reflected(p)) < 1e-10);
      CHECK(difference(p, reflected(rotated(p, 90))) < 1e-10);
      for (int32_t by : {1, 3}) CHECK(difference(p, renumbered(p, by)) < 1e-10);
    }
}

namespace {

// Corners one after the other, every side in elements of about `size`.
fixture::Points outline_of(const std::vector<std::array<double, 2>>& corners, double size) {
  fixture::Points out;
  for (size_t i = 0; i < corners.size(); ++i) {
    const auto &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const int n = static_cast<int>(std::ceil(std::hypot(b[0] - a[0], b[1] - a[1]) / size));
    for (int k = 0; k < n; ++k) out.insert(out.end(), {a[0] + (b[0] - a[0]) * k / n, a[1] + (b[1] - a[1]) * k / n});
  }
  return out;
}

// Inside of a clockwise polygon: the distance from its boundary; outside: -1.
double depth(const std::vector<std::array<double, 2>>& corners, double x, double y) {
  double distance = 1e300;
  bool inside = false;
  for (size_t i = 0; i < corners.size(); ++i) {
    const auto &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const double dx = b[0] - a[0], dy = b[1] - a[1];
    const double s = std::min(std::max(((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy), 0.0), 1.0);
    distance = std::min(distance, std::hypot(a[0] + s * dx - x, a[1] + s * dy - y));
    if ((a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / dy * dx) inside = !inside;
  }
  return inside ? distance : -1.0;
}

} // namespace

TEST_CASE(
    "holes: where the centroid lies outside, the centre of the widest circle is taken, as a search of all places finds it") {
  using Corners = std::vector<std::array<double, 2>>;
  const Corners horseshoe = {{0, 0}, {0, 2}, {0.5, 2}, {0.5, 0.7}, {2.2, 0.7}, {2.2, 2}, {3, 2}, {3, 0}};
  const Corners hook = {{0, 0}, {0, 3}, {0.4, 3}, {0.5, 0.45}, {2, 0.3}, {2, 0}};
  const Corners arch = {{0, 0}, {0, 2}, {0.5, 2}, {0.5, 0.5}, {2.5, 0.5}, {2.5, 2}, {3, 2}, {3, 0}}; // its own mirror image
  for (const Corners& shape : {horseshoe, hook, arch})
    for (const bool turned : {false, true})
      for (const bool twin : {false, true}) {
        Corners corners = shape;
        if (turned) { // a quarter
          for (auto& corner : corners) corner = {3 - corner[1], corner[0]};
        }
        double area = 0, length = 0, centroid[2] = {};
        for (size_t i = 0; i < corners.size(); ++i) {
          const auto &a = corners[i], &b = corners[(i + 1) % corners.size()];
          const double twice = a[0] * b[1] - b[0] * a[1];
          area += 0.5 * twice;
          for (size_t c = 0; c < 2; ++c) centroid[c] += twice * (a[c] + b[c]) / 6;
          length += std::hypot(b[0] - a[0], b[1] - a[1]);
        }
        for (double& c : centroid) c /= area;
        REQUIRE(area < 0); // clockwise: the material is outside
        const auto merit = [&](double x, double y) {
          const double away = std::hypot(x - centroid[0], y - centroid[1]) / length;
          return depth(corners, x, y) * (1 - away * away);
        };
        double best = 0;
        for (double x = 0.005; x < 3; x += 0.01)
          for (double y = 0.005; y < 3; y += 0.01) best = std::max(best, merit(x, y));
        fixture::ModelData d(2);
        fixture::Points hole = outline_of(corners, 0.05);
        if (twin) hole.insert(hole.begin(), {hole[0], hole[1]});
        d.body(2, {outline_of({{-2, -2}, {5, -2}, {5, 5}, {-2, 5}}, 1.0), hole});
        REQUIRE(d.complete());
        const c2d::Model m = d.view();
        c2d::HoleWalk walk = {};
        c2d::Hole found = {};
        std::feclearexcept(FE_ALL_EXCEPT);
        REQUIRE(c2d::next_hole(m, 0, walk, found));
        CHECK(std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW) == 0);
        CHECK(found.points == (shape == arch ? 2 : 1));
        for (int32_t k = 0; k < found.points; ++k) {
          const double x = found.at[k][0] * m.head->length_unit, y = found.at[k][1] * m.head->length_unit;
          CHECK(merit(x, y) > 0.96 * best); // it touches the middle of an element
          CHECK(merit(x, y) < 1.01 * best);
        }
        c2d::Hole none = {};
        CHECK(!c2d::next_hole(m, 0, walk, none));
      }
}

// Two rooms with a neck between them, in which the centroid lies too near to the edge; the points of a slit of no breadth see
// nothing before them.
TEST_CASE("holes: one has a place in either room beside a neck, and a slit of no breadth its centroid") {
  using fixture::ModelData;
  const fixture::Points rooms = {-2, -0.5, -2, 0.5,  -1, 0.5,  -1, 0.05,  1,  0.05,  1,  0.5,
                                 2,  0.5,  2,  -0.5, 1,  -0.5, 1,  -0.05, -1, -0.05, -1, -0.5};
  const fixture::Points slit = {-2, 0, -1, 4e-10, 0, 1e-10, 1, 4e-10, 2, 0, 1, -4e-10, 0, -1e-10, -1, -4e-10};
  for (const fixture::Points& curve : {rooms, slit}) {
    ModelData d(2);
    d.body(2, {fixture::rectangle(-3, -2, 6, 4, 3, 2), curve});
    d.head.length_unit = 1;
    c2d::HoleWalk walk{};
    c2d::Hole hole;
    REQUIRE(c2d::next_hole(d.view(), 0, walk, hole));
    REQUIRE(hole.points == (curve == rooms ? 2 : 1));
    for (int k = 0; k < hole.points; ++k) {
      CHECK(hole.at[k][0] == doctest::Approx(curve == rooms ? 3 * k - 1.5 : 0.0));
      CHECK(std::fabs(hole.at[k][1]) < 1e-12);
    }
    if (curve == rooms) CHECK(hole.length == doctest::Approx(4 * 2.2 / 11.8)); // of its area and length
    CHECK(!c2d::next_hole(d.view(), 0, walk, hole));
  }
}
