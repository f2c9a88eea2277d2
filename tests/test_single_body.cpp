// One body against exact solutions of elasticity: patch states, a ring, a beam, a point force; and its
// invariances.
#include "callable.hpp"
#include "problem.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace problem;

namespace {

constexpr double kPi = 3.14159265358979323846;

struct State { // displacements and stresses at a point
  double ux, uy, sxx, syy, sxy;
};
using Field = test::Callable<State(double x, double y)>;
enum class Given { traction, displacement, roller_x, roller_y }; // roller_x: ux and ty are known
using Choice = test::Callable<Given(double x, double y, double nx, double ny)>;

struct Elastic { // plane constants: exx = (sxx - nu syy)/e, gxy = 2 (1 + nu) sxy / e
  double e, nu;
};
Elastic plane_constants(const Problem& p) {
  const double e = p.bodies[0].youngs_modulus, nu = p.bodies[0].poisson_ratio;
  if (p.plane == C2D_PLANE_STRESS) return {e, nu};
  return {e / (1 - nu * nu), nu / (1 - nu)};
}

Result solved(const Problem& p, const Setup& setup = Setup()) {
  Result r = solve(p, setup);
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  return r;
}

Problem one_body(int32_t element_nodes, int32_t function_nodes, int32_t plane = C2D_PLANE_STRAIN, double nu = 0.3) {
  Problem p;
  p.plane = plane;
  p.analysis = C2D_ANALYSIS_STRESS;
  p.function_nodes = function_nodes;
  p.bodies.resize(1);
  p.bodies[0].element_nodes = element_nodes;
  p.bodies[0].poisson_ratio = nu;
  return p;
}

struct PatchError {
  double displacement = 0, traction = 0; // relative to the largest on the boundary
};

// Give the exact field's values as conditions and compare what comes back at every end. `stress` is the size
// that tractions are measured by where the exact ones vanish.
PatchError patch(Problem p, const Field& exact, const Choice& choose, double stress = 0, double length = 0) {
  std::vector<double> wanted;
  set_ends(p, 1, [&](double x, double y, double nx, double ny, End& end) {
    const State s = exact(x, y);
    const double t[2] = {s.sxx * nx + s.sxy * ny, s.sxy * nx + s.syy * ny}, u[2] = {s.ux, s.uy};
    const Given given = choose(x, y, nx, ny);
    for (int c = 0; c < 2; ++c) {
      const bool fixed = given == Given::displacement || given == (c == 0 ? Given::roller_x : Given::roller_y);
      end.codes[c] = fixed ? 1 : 0;
      end.codes[2 + c] = fixed ? 0 : 1;
      end.values[fixed ? 2 + c : c] = fixed ? u[c] : t[c];
    }
    wanted.insert(wanted.end(), {u[0], u[1], t[0], t[1]});
  });
  const Result r = solved(p);
  double du = 0, dt = 0, u = length, t = stress;
  size_t k = 0;
  for (const EndResult& end : r.boundary[0]) {
    const int32_t e = end.element;
    const std::vector<double>& xy = p.bodies[0].xy;
    // set_ends passes over the element between the nodes of a double node
    const size_t i = static_cast<size_t>(2 * (e - 1)), j = static_cast<size_t>(2 * e) % xy.size();
    if (p.bodies[0].element_nodes == 2 && p.bodies[0].regions.size() == 1 && xy[i] == xy[j] && xy[i + 1] == xy[j + 1]) continue;
    const double* w = &wanted[4 * k++];
    u = std::max({u, std::fabs(w[0]), std::fabs(w[1])});
    t = std::max({t, std::fabs(w[2]), std::fabs(w[3])});
    du = std::max({du, std::fabs(end.ux - w[0]), std::fabs(end.uy - w[1])});
    dt = std::max({dt, std::fabs(end.tx - w[2]), std::fabs(end.ty - w[3])});
  }
  REQUIRE(4 * k == wanted.size());
  return {du / u, dt / t};
}

// Constant stress with a rigid motion on top.
Field constant_stress(const Elastic& m, double sxx, double syy, double sxy, double a = 0, double b = 0, double w = 0) {
  return [=](double x, double y) {
    const double exx = (sxx - m.nu * syy) / m.e, eyy = (syy - m.nu * sxx) / m.e, exy = (1 + m.nu) * sxy / m.e;
    return State{exx * x + (exy - w) * y + a, (exy + w) * x + eyy * y + b, sxx, syy, sxy};
  };
}
// Pure bending, sxx = c y: quadratic displacements.
Field bending(const Elastic& m, double c) {
  return [=](double x, double y) { return State{c / m.e * x * y, -c / (2 * m.e) * (x * x + m.nu * y * y), c * y, 0, 0}; };
}
// A beam |y| < h with a shear force, sxx = k x y and sxy = k (h h - y y)/2: cubic displacements.
Field shear_bending(const Elastic& m, double k, double h) {
  return [=](double x, double y) {
    const double g = (1 + m.nu) * (h * h * y - y * y * y / 3) + m.nu * y * y * y / 6;
    return State{k / m.e * (x * x * y / 2 + g), k / m.e * (-m.nu * x * y * y / 2 - x * x * x / 6), k * x * y, 0,
                 k / 2 * (h * h - y * y)};
  };
}

Given on_the_left(double, double, double nx, double) { return nx < -0.999 ? Given::displacement : Given::traction; }
Given rollers(double, double, double nx, double ny) {
  return nx < -0.999 ? Given::roller_x : ny < -0.999 ? Given::roller_y : Given::traction;
}

// A body with sides in many directions, one of them facing left.
void add_house(Body& body) { add_polygon(body, {{0, -1, 3}, {2.5, -1.4, 2}, {3, 0.2, 3}, {1.6, 1.7, 2}, {0, 1, 4}}); }
void add_plate(Body& body) { add_polygon(body, {{0, -1, 5}, {3, -1, 4}, {3, 1, 5}, {0, 1, 4}}); }
void add_rectangular_hole(Body& body) { // clockwise
  add_polygon(body, {{1, -0.4, 2}, {1, 0.3, 3}, {1.8, 0.3, 2}, {1.8, -0.4, 3}});
}

} // namespace

TEST_CASE("one body: the plate in tension is exact") {
  const Result r = solve_text(deck_text("plate.dat"));
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  double worst_u = 0, worst_t = 0;
  for (const EndResult& end : r.boundary[0]) {
    worst_u = std::max({worst_u, std::fabs(end.ux - 0.1 * end.x), std::fabs(end.uy + 0.03 * end.y)});
    const bool left = end.element > 20, right = end.element > 8 && end.element <= 12;
    worst_t = std::max({worst_t, std::fabs(end.tx - (right ? 100 : left ? -100 : 0)), std::fabs(end.ty)});
  }
  CHECK(r.boundary[0].size() == 48);
  CHECK(worst_u < 1e-9 * 0.2);
  CHECK(worst_t < 1e-9 * 100);
}

TEST_CASE("one body: patch states of constant stress, linear to cubic functions and geometry") {
  for (int32_t plane : {C2D_PLANE_STRAIN, C2D_PLANE_STRESS})
    for (int32_t functions : {2, 3, 4})
      for (int32_t geometry : {2, 3, 4})
        for (double nu : {0.3, 0.0, -0.4, 0.499}) {
          CAPTURE(plane);
          CAPTURE(functions);
          CAPTURE(geometry);
          CAPTURE(nu);
          Problem p = one_body(geometry, functions, plane, nu);
          add_house(p.bodies[0]);
          const Elastic m = plane_constants(p);
          const Field states[] = {constant_stress(m, 1, 0, 0), constant_stress(m, 0, 1, 0), constant_stress(m, 0, 0, 1),
                                  constant_stress(m, 2, -3, 0.7, 0.01, -0.02, 0.005)};
          for (const Field& state : states) {
            const PatchError e = patch(p, state, on_the_left);
            CHECK(e.displacement < 1e-9);
            CHECK(e.traction < 1e-9);
          }
          const PatchError rigid = patch(p, constant_stress(m, 0, 0, 0, 0.3, -0.2, 0.1), on_the_left, 100);
          CHECK(rigid.displacement < 1e-9);
          CHECK(rigid.traction < 1e-9);
        }
}

TEST_CASE("one body: incompressible in plane strain") {
  Problem p = one_body(2, 3, C2D_PLANE_STRAIN, 0.5);
  add_house(p.bodies[0]);
  const PatchError e = patch(p, constant_stress({1000 / 0.75, 1.0}, 1, -0.4, 0.3), on_the_left);
  CHECK(e.displacement < 1e-9);
  CHECK(e.traction < 1e-9);
}

TEST_CASE("one body: linear and quadratic stress states with functions of higher order on straight sides") {
  for (int32_t plane : {C2D_PLANE_STRAIN, C2D_PLANE_STRESS})
    for (int32_t geometry : {2, 3, 4})
      for (int32_t functions : {3, 4}) {
        CAPTURE(plane);
        CAPTURE(geometry);
        CAPTURE(functions);
        Problem p = one_body(geometry, functions, plane);
        add_house(p.bodies[0]);
        const Elastic m = plane_constants(p);
        const PatchError quadratic = patch(p, bending(m, 5), on_the_left);
        CHECK(quadratic.displacement < 1e-9);
        CHECK(quadratic.traction < 1e-9);
        const PatchError cubic = patch(p, shear_bending(m, 2, 1), on_the_left);
        if (functions == 4) {
          CHECK(cubic.displacement < 1e-9);
          CHECK(cubic.traction < 1e-9);
        } else { // not in the space of quadratic functions
          CHECK(cubic.displacement > 1e-9);
          CHECK(cubic.displacement < 1e-2);
        }
      }
}

TEST_CASE("one body: rollers and given shear, mixed at corners") {
  for (int32_t functions : {2, 3, 4}) {
    CAPTURE(functions);
    Problem p = one_body(2, functions);
    add_plate(p.bodies[0]);
    const Elastic m = plane_constants(p);
    const PatchError e = patch(p, constant_stress(m, 2, -3, 0.7), rollers);
    CHECK(e.displacement < 1e-9);
    CHECK(e.traction < 1e-9);
    if (functions < 3) continue;
    const PatchError bent = patch(p, bending(m, 1), rollers);
    CHECK(bent.displacement < 1e-9);
    CHECK(bent.traction < 1e-9);
  }
}

TEST_CASE("one body: holes") {
  for (int32_t functions : {2, 3, 4})
    for (int32_t geometry : {2, 3, 4}) {
      CAPTURE(functions);
      CAPTURE(geometry);
      Problem p = one_body(geometry, functions);
      add_plate(p.bodies[0]);
      add_rectangular_hole(p.bodies[0]);
      add_polygon(p.bodies[0], {{2.2, 0.1, 2}, {2.2, 0.6, 2}, {2.7, 0.4, 1}}); // a second, triangular one
      const Elastic m = plane_constants(p);
      const auto left_side = [](double x, double, double nx, double) {
        return nx < -0.999 && x == 0 ? Given::displacement : Given::traction;
      };
      const PatchError e = patch(p, constant_stress(m, 2, -3, 0.7, 0.01, 0.02, 0.003), left_side);
      CHECK(e.displacement < 1e-9);
      CHECK(e.traction < 1e-9);
    }
}

TEST_CASE("one body: constant functions come near") {
  // Constant functions hold no linear field: the error falls with the mesh.
  double before = 1;
  for (int32_t n : {4, 8, 16, 32}) {
    CAPTURE(n);
    Problem p = one_body(2, 1);
    add_polygon(p.bodies[0], {{0, -1, n}, {2, -1, n}, {2, 1, n}, {0, 1, n}});
    const double now = patch(p, constant_stress(plane_constants(p), 1, 0.5, 0.2), on_the_left).displacement;
    CHECK(now < 0.75 * before);
    before = now;
  }
  CHECK(before < 0.02);
}

TEST_CASE("one body: displacements given everywhere") {
  for (int32_t functions : {1, 2, 3, 4}) {
    CAPTURE(functions);
    const Choice everywhere = [](double, double, double, double) { return Given::displacement; };
    Problem p = one_body(2, functions);
    add_house(p.bodies[0]);
    const Field rigid = constant_stress(plane_constants(p), 0, 0, 0, 0.3, -0.2, 0.1);
    // Corners share one traction there, and zero is what both sides want. With constant functions a rotation
    // is a staircase; a translation is not.
    const PatchError e =
        patch(p, functions == 1 ? constant_stress(plane_constants(p), 0, 0, 0, 0.3, -0.2) : rigid, everywhere, 100);
    CHECK(e.traction < 1e-9);
    if (functions < 3) continue;
    Problem circle = one_body(3, 3); // curved sides
    add_curve(circle.bodies[0], 12, [](double s, double& x, double& y) {
      x = std::cos(2 * kPi * s);
      y = 0.7 * std::sin(2 * kPi * s);
    });
    if (functions == 3) CHECK(patch(circle, rigid, everywhere, 100).traction < 1e-9);
  }
}

TEST_CASE("one body: a double node at a corner changes nothing where the state is a patch") {
  for (size_t corner : {5u, 9u, 14u}) { // two free corners, one at the held side
    CAPTURE(corner);
    Problem p = one_body(2, 2);
    add_plate(p.bodies[0]);
    const Elastic m = plane_constants(p);
    const Field state = constant_stress(m, 2, -3, 0.7, 0.01, -0.02, 0.005);
    const PatchError single = patch(p, state, on_the_left);
    std::vector<double>& xy = p.bodies[0].xy;
    const double x = xy[2 * corner], y = xy[2 * corner + 1];
    xy.insert(xy.begin() + static_cast<std::ptrdiff_t>(2 * corner), {x, y});
    ++p.bodies[0].regions[0].last;
    const PatchError twice = patch(p, state, on_the_left);
    CHECK(single.displacement < 1e-9);
    CHECK(single.traction < 1e-9);
    CHECK(twice.displacement < 1e-9);
    CHECK(twice.traction < 1e-9);
  }
}

TEST_CASE("one body: traction that jumps is carried whole") {
  for (int32_t functions : {1, 2, 3, 4}) {
    CAPTURE(functions);
    Problem p = one_body(2, functions);
    add_polygon(p.bodies[0], {{0, 0, 6}, {3, 0, 4}, {3, 2, 6}, {0, 2, 4}});
    set_ends(p, 1, [](double, double, double nx, double ny, End& end) {
      if (nx < -0.9) {
        const int32_t held[4] = {1, 1, 0, 0};
        std::copy(held, held + 4, end.codes);
      }
      (void)ny;
    });
    // -7 and 2 on the second and third elements of the top (elements 11 ... 16), nothing around them.
    for (int32_t e : {12, 13})
      for (int32_t l = 1; l <= functions; ++l) {
        p.end(1, e, l).values[0] = 2;
        p.end(1, e, l).values[1] = e == 12 ? -7 : -3.5;
      }
    const Result r = solved(p);
    const Resultant all = resultant(p, r, 1, 0);
    CHECK(std::fabs(all.fx) < 1e-12 * all.size);
    CHECK(std::fabs(all.fy) < 1e-12 * all.size);
    CHECK(std::fabs(all.moment) < 1e-12 * all.size * 3);
    double reaction[2] = {0, 0}; // by the held side alone: elements of length 0.5
    const double weight[4][4] = {{1}, {0.5, 0.5}, {1 / 6.0, 4 / 6.0, 1 / 6.0}, {1 / 8.0, 3 / 8.0, 3 / 8.0, 1 / 8.0}};
    for (const EndResult& end : r.boundary[0]) {
      if (end.element <= 16) continue;
      const size_t l = static_cast<size_t>(&end - r.boundary[0].data()) % static_cast<size_t>(functions);
      reaction[0] += 0.5 * weight[functions - 1][l] * end.tx;
      reaction[1] += 0.5 * weight[functions - 1][l] * end.ty;
    }
    CHECK(reaction[0] == doctest::Approx(-2.0).epsilon(1e-11));
    CHECK(reaction[1] == doctest::Approx(5.25).epsilon(1e-11));
  }
}

// ---- ring
// -------------------------------------------------------------------------------------------------------

namespace {

struct Lame { // a ring a < r < b with pressure p inside
  double a, b, p;
  Elastic m;
  double constant() const { return p * a * a / (b * b - a * a); }
  double radial(double r) const { return constant() * (1 - b * b / (r * r)); }
  double hoop(double r) const { return constant() * (1 + b * b / (r * r)); }
  double displacement(double r) const { return r / m.e * (hoop(r) - m.nu * radial(r)); }
};

} // namespace

TEST_CASE("one body: thick ring, quadratic, against Lame") {
  const Problem p = load("ring3.dat");
  const Lame lame = {1, 2, 100, plane_constants(p)};
  const Result r = solved(p);
  double bore = 0, hoop = 0;
  int seen_bore = 0, seen_line = 0;
  for (const EndResult& end : r.boundary[0]) {
    const double radius = std::hypot(end.x, end.y);
    if (radius < 1 + 1e-6) {
      const double u = (end.ux * end.x + end.uy * end.y) / radius;
      bore = std::max(bore, std::fabs(u / lame.displacement(1) - 1));
      ++seen_bore;
    }
    if (end.y == 0 && end.element <= 4) { // the line y = 0: its traction is the hoop stress
      hoop = std::max(hoop, std::fabs(-end.ty / lame.hoop(end.x) - 1));
      ++seen_line;
    }
  }
  CHECK(seen_bore > 10);
  CHECK(seen_line > 10);
  CHECK(bore < 1e-4);
  CHECK(hoop < 5e-3);
}

namespace {

// Largest error of a whole ring of 2 n cubic elements, and the largest traction of its three supports.
void whole_ring(int32_t n, double& worst, double& reaction) {
  Problem p = one_body(4, 4, C2D_PLANE_STRESS);
  const auto circle = [](double radius, double turn) {
    return [=](double s, double& x, double& y) {
      x = radius * std::cos(turn * 2 * kPi * s);
      y = radius * std::sin(turn * 2 * kPi * s);
    };
  };
  add_curve(p.bodies[0], n, circle(2, 1));
  add_curve(p.bodies[0], n, circle(1, -1));
  set_ends(p, 1, [](double x, double y, double nx, double ny, End& end) {
    if (std::hypot(x, y) > 1.5) return;
    end.values[0] = -100 * nx;
    end.values[1] = -100 * ny;
  });
  const auto hold = [&](int32_t element, int c) { // at the first end of an element of the outside
    End& end = p.end(1, element, 1);
    end.codes[c] = 1, end.codes[2 + c] = 0;
  };
  hold(1, 1), hold(1 + n / 4, 0), hold(1 + n / 2, 1);
  const Lame lame = {1, 2, 100, plane_constants(p)};
  const Result r = solved(p);
  worst = reaction = 0;
  for (const EndResult& end : r.boundary[0]) {
    const double radius = std::hypot(end.x, end.y), u = lame.displacement(radius < 1.5 ? 1 : 2);
    worst = std::max({worst, std::fabs(end.ux - u * end.x / radius) / u, std::fabs(end.uy - u * end.y / radius) / u});
    if (radius > 1.5) reaction = std::max({reaction, std::fabs(end.tx), std::fabs(end.ty)});
  }
}

} // namespace

TEST_CASE("one body: whole ring, cubic, held by three displacements") {
  double before = 1e-2;
  for (int32_t n : {8, 16, 32}) {
    CAPTURE(n);
    double worst, reaction;
    whole_ring(n, worst, reaction);
    CHECK(worst < before / 8);    // third order at the least
    CHECK(reaction < 1e-9 * 100); // the loads balance by symmetry: nothing for the supports
    before = worst;
  }
  CHECK(before < 2e-6);
}

// ---- beam
// -------------------------------------------------------------------------------------------------------

TEST_CASE("one body: tip of a clamped beam") {
  // Length 10, height 1, plane stress, shear 1 at the tip: P L^3/(3 E I) + 6 P L / (5 G A). The formula leaves out
  // what the clamp does near it. Measured with these meshes: 0.52, 0.30 and 0.22 % less than the formula.
  const double beam = -(1000.0 / (3 * 1000.0 / 12) + 6.0 * 10 / (5 * 1000 / 2.6));
  double before = 0;
  for (int32_t n : {1, 2, 4}) {
    Problem p = one_body(2, 3, C2D_PLANE_STRESS);
    add_polygon(p.bodies[0], {{0, -0.5, 40 * n}, {10, -0.5, 6 * n}, {10, 0.5, 40 * n}, {0, 0.5, 6 * n}});
    set_ends(p, 1, [](double, double y, double nx, double, End& end) {
      if (nx < -0.9) {
        const int32_t held[4] = {1, 1, 0, 0};
        std::copy(held, held + 4, end.codes);
      } else if (nx > 0.9) {
        end.values[1] = -1.5 * (1 - 4 * y * y);
      }
    });
    const Result r = solved(p);
    double tip = 0;
    for (const EndResult& end : r.boundary[0])
      if (end.x == 10 && end.y == 0) tip = end.uy;
    CHECK(tip / beam < 1);
    CHECK(tip / beam > std::max(before, 0.994));
    before = tip / beam;
  }
  CHECK(before > 0.997);
}

// ---- point force
// ------------------------------------------------------------------------------------------------

namespace {

// Kelvin's solution in plane strain for a force f at (px, py).
Field kelvin(double e, double nu, double px, double py, double fx, double fy) {
  return [=](double x, double y) {
    const double g = e / (2 * (1 + nu)), rx = x - px, ry = y - py, r = std::hypot(rx, ry);
    const double d[2] = {rx / r, ry / r}, f[2] = {fx, fy};
    const double df = d[0] * fx + d[1] * fy;
    double u[2], s[2][2];
    for (int i = 0; i < 2; ++i) {
      u[i] = (-(3 - 4 * nu) * std::log(r) * f[i] + d[i] * df) / (8 * kPi * g * (1 - nu));
      for (int j = 0; j < 2; ++j)
        s[i][j] =
            -((1 - 2 * nu) * (f[i] * d[j] + f[j] * d[i] - (i == j ? df : 0)) + 2 * d[i] * d[j] * df) / (4 * kPi * (1 - nu) * r);
    }
    return State{u[0], u[1], s[0][0], s[1][1], s[0][1]};
  };
}

} // namespace

TEST_CASE("one body: a point force inside against Kelvin's solution") {
  double before = 1;
  for (int32_t n : {6, 12, 24}) {
    CAPTURE(n);
    Problem p = one_body(2, 3);
    add_polygon(p.bodies[0], {{0, -1, n}, {3, -1, n}, {3, 1, n}, {0, 1, n}});
    p.point_loads.push_back({1, 1.4, 0.2, 3, -5});
    const PatchError e = patch(p, kelvin(1000, 0.3, 1.4, 0.2, 3, -5), on_the_left);
    CHECK(e.displacement < 0.25 * before);
    before = e.displacement;
  }
  CHECK(before < 1e-4);
}

TEST_CASE("one body: supports carry point forces to round-off") {
  for (int32_t functions : {1, 2, 3, 4}) {
    CAPTURE(functions);
    Problem p = one_body(2, functions);
    add_plate(p.bodies[0]);
    set_ends(p, 1, [](double, double, double, double ny, End& end) {
      if (ny > -0.9) return;
      const int32_t held[4] = {1, 1, 0, 0};
      std::copy(held, held + 4, end.codes);
    });
    p.point_loads = {{1, 1.4, 0.2, 3, -5}, {1, 2.1, -0.3, -1, 0.5}};
    const Result r = solved(p);
    const Resultant all = resultant(p, r, 1, 0);
    CHECK(all.size > 7);
    CHECK(std::fabs(all.fx) < 1e-12 * all.size);
    CHECK(std::fabs(all.fy) < 1e-12 * all.size);
    CHECK(std::fabs(all.moment) < 1e-12 * all.size * 3);
    for (double sum : r.summary.body[0].applied) CHECK(std::fabs(sum) < 1e-12 * all.size * 3);
  }
}

// ---- units
// ------------------------------------------------------------------------------------------------------

TEST_CASE("one body: any unit of length and stress, the degenerate scales of plain equations too") {
  const double nu = 0.3, kappa = 3 - 4 * nu;
  // A circle of radius exp(1/(2 kappa)) has no unique solution without the balance rows.
  const double lengths[] = {
      1e-6,          1e-3, 0.37, std::exp(1 / (2 * kappa)), std::exp(-1 / (2 * kappa)), std::exp(1 / kappa), std::exp(0.5),
      std::exp(1.0), 1e3,  1e6};
  for (bool all_given : {false, true}) {
    Problem p = one_body(3, 3);
    add_curve(p.bodies[0], 12, [](double s, double& x, double& y) {
      x = std::cos(2 * kPi * s);
      y = std::sin(2 * kPi * s);
    });
    set_ends(p, 1, [&](double x, double y, double, double, End& end) {
      if (all_given || x < -1e-9) {
        const int32_t held[4] = {1, 1, 0, 0};
        std::copy(held, held + 4, end.codes);
        end.values[2] = 0.01 * x * y, end.values[3] = 0.02 * x * x;
      } else {
        end.values[0] = 3 * x, end.values[1] = -2 * y * y;
      }
    });
    const Result reference = solved(p);
    for (double length : lengths)
      for (double stress : {1e-6, 1.0, 7.3, 1e6}) {
        CAPTURE(length);
        CAPTURE(stress);
        Result r = solved(scaled(p, length, stress));
        for (EndResult& end : r.boundary[0]) {
          end.ux /= length, end.uy /= length;
          end.tx /= stress, end.ty /= stress;
        }
        CHECK(boundary_difference(reference, r) < 1e-9);
      }
  }
}

TEST_CASE("one body: turned, reflected and renumbered") {
  Problem p = one_body(2, 3);
  add_house(p.bodies[0]);
  set_ends(p, 1, [](double x, double y, double nx, double, End& end) {
    if (nx < -0.999) {
      const int32_t held[4] = {1, 1, 0, 0};
      std::copy(held, held + 4, end.codes);
    } else {
      end.values[0] = x * y, end.values[1] = 2 - x;
    }
  });
  p.point_loads.push_back({1, 1.2, 0.1, 4, 3});
  const Result reference = solved(p);
  double u = 0;
  for (const EndResult& end : reference.boundary[0]) u = std::max({u, std::fabs(end.ux), std::fabs(end.uy)});
  const double angle = 30 * kPi / 180, c = std::cos(angle), s = std::sin(angle);
  Result turned = solved(rotated(p, 30));
  for (EndResult& end : turned.boundary[0]) {
    const EndResult e = end;
    end.ux = c * e.ux + s * e.uy, end.uy = -s * e.ux + c * e.uy;
    end.tx = c * e.tx + s * e.ty, end.ty = -s * e.tx + c * e.ty;
  }
  CHECK(boundary_difference(reference, turned) < 1e-9);
  Result mirrored = solved(reflected(p));
  std::reverse(mirrored.boundary[0].begin(), mirrored.boundary[0].end());
  for (EndResult& end : mirrored.boundary[0]) end.ux = -end.ux, end.tx = -end.tx;
  CHECK(boundary_difference(reference, mirrored) < 1e-9);
  Result shifted = solved(renumbered(p, 4));
  std::rotate(shifted.boundary[0].rbegin(), shifted.boundary[0].rbegin() + 4 * 3, shifted.boundary[0].rend());
  CHECK(boundary_difference(reference, shifted) < 1e-9);
}
