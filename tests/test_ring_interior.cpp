// Points inside bodies of revolution (METHOD 21.7): displacements and stresses, round the axis too, against closed forms; on
// the axis, near it, near the surface and its nodes.
#include "ring_states.hpp"
#include "solved_bodies.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace many;
using namespace ring_states;
using solved_bodies::solved;

namespace {

Model revolved(int32_t functions) {
  Model m;
  m.plane = C2D_AXISYMMETRIC;
  m.function_nodes = functions;
  return m;
}
Body half_section(double bore, double nu) {
  return bore == 0 ? open_polygon({{0, 0, 4}, {2, 0, 5}, {2, 3, 3}, {0, 3, 1}}, 1000, nu)
                   : rectangle(bore, 0, 2, 3, {4, 5, 3, 6}, 1000, nu);
}

void check_at(const Machine& machine, const std::vector<double>& points, const Field& field, double limit_u, double limit_s) {
  const int32_t count = static_cast<int32_t>(points.size() / 2);
  std::vector<double> rows(points.size() / 2 * C2D_POINT_FIELDS);
  REQUIRE(c2d_interior(machine.solver, 0, count, points.data(), 2, rows.data(), C2D_POINT_FIELDS) == C2D_OK);
  for (size_t i = 0; i < points.size() / 2; ++i) {
    const double* row = rows.data() + i * C2D_POINT_FIELDS;
    const double r = points[2 * i], z = points[2 * i + 1];
    const State s = field(r, z);
    CAPTURE(r);
    CAPTURE(z);
    CHECK(row[C2D_POINT_FLAG] != C2D_POINT_OUTSIDE);
    const double u = std::hypot(row[C2D_POINT_UX] - s.ur, row[C2D_POINT_UY] - s.uz);
    const double stress = std::max({std::fabs(row[C2D_POINT_SXX] - s.srr), std::fabs(row[C2D_POINT_SYY] - s.szz),
                                    std::fabs(row[C2D_POINT_SXY] - s.srz), std::fabs(row[C2D_POINT_SZZ] - s.hoop)});
    CHECK(u < limit_u);
    CHECK(stress < limit_s);
  }
}

// Points of the half section: in the middle, near the surface, near nodes, on the axis or near the bore, on the boundary.
std::vector<double> points_of(double bore) {
  std::vector<double> out = {1.3, 1.1, 0.8, 2.9, 1.999, 1.3, 1.999998, 1.3, 1.9999, 0.0001, 1.5, 1e-6, 1.4999, 1e-4, 2, 1.1};
  for (double r : {0.0, 1e-12, 1e-6, 1e-3, 0.1}) out.insert(out.end(), {bore + r, 0.77, bore + r, 2.9999});
  return out;
}

} // namespace

TEST_CASE("points inside rings: uniform stress, every order" * doctest::skip(kNoRings)) {
  for (int32_t functions : {2, 3, 4})
    for (double bore : {0.0, 0.7})
      for (double nu : {0.3, 0.5}) {
        CAPTURE(functions);
        CAPTURE(bore);
        CAPTURE(nu);
        Model m = revolved(functions);
        const double side = -40;
        m.add(half_section(bore, nu));
        m.set(1, 1, end_of("0110"));
        m.set(1, 2, end_of(kPulled, side));
        m.set(1, 3, end_of(kPulled, 0, 100));
        if (bore > 0) m.set(1, 4, end_of(kPulled, -side));
        Machine machine(m);
        REQUIRE(machine.run().status == C2D_OK);
        const double ez = (100 - 2 * nu * side) / 1000, er = (side - nu * (side + 100)) / 1000;
        const Field field = [=](double r, double z) { return State{er * r, ez * z, side, 100, 0, side}; };
        check_at(machine, points_of(bore), field, 1e-12, 1e-8);
        // Beyond the axis lies the same ring.
        double at[4] = {-1.3, 1.1, -2.5, 1}, out[2 * C2D_POINT_FIELDS];
        REQUIRE(c2d_interior(machine.solver, 1, 2, at, 2, out, C2D_POINT_FIELDS) == C2D_OK);
        CHECK(std::fabs(out[C2D_POINT_UX] + 1.3 * er) < 1e-9);
        CHECK(std::fabs(out[C2D_POINT_SZZ] - side) < 1e-7);
        CHECK(out[C2D_POINT_FIELDS + C2D_POINT_FLAG] == C2D_POINT_OUTSIDE);
      }
}

TEST_CASE("points inside rings: bars that hang and turn" * doctest::skip(kNoRings)) {
  for (int32_t functions : {3, 4})
    for (double nu : {0.3, 0.5}) {
      const double b = -4, w = 7, g = 500 / (1 + nu), c = -w * (1 - 2 * nu) / (16 * g * (1 - nu)), k = w / (8 * (1 - nu)),
                   p = 4 * (3 - 2 * nu) * k;
      const Field hangs = [=](double r, double z) {
        return State{
            -nu * b * (3 - z) * r / 1000, b * (3 * z - z * z / 2) / 1000 - nu * b * r * r / 2000, 0, b * (3 - z), 0, 0};
      };
      for (double bore : {0.0, 0.7}) {
        Model m = revolved(functions);
        m.add(half_section(bore, nu));
        m.body(1).force[1] = b;
        m.set(1, 1, [=](double r, double z) { return end_of(kHeld, 0, 0, hangs(r, z).ur, hangs(r, z).uz); });
        Machine machine(m);
        REQUIRE(machine.run().status == C2D_OK);
        check_at(machine, points_of(bore), hangs, 1e-13, 1e-9);
      }
      const Field turns = [=](double r, double) {
        State s = {(1 - 2 * nu) * p / (2 * g) * r + c * r * r * r,
                   0,
                   p - (3 - 2 * nu) * k * r * r,
                   0,
                   0,
                   p - (1 + 2 * nu) * k * r * r};
        s.szz = nu * (s.srr + s.hoop);
        return s;
      };
      Model m = revolved(functions);
      m.add(half_section(0, nu));
      m.body(1).spin = w;
      m.set(1, 1, end_of("0110"));
      m.set(1, 3, end_of("0110"));
      Machine machine(m);
      REQUIRE(machine.run().status == C2D_OK);
      // The slope of u, which is of the third degree, gives the boundary stress near nodes: for quadratic functions not
      // exactly.
      const std::vector<double> deep = {0, 1.5, 1e-9, 1.5, 1e-4, 0.7, 0.6, 1.5, 1.1, 0.9, 0.8, 2.2};
      check_at(machine, functions == 4 ? points_of(0) : deep, turns, 1e-10, 1e-6);
    }
}

namespace {

// A hollow sphere of radii 1 and 2 under the pressure 1 inside; the lower half by symmetry.
Model hollow_sphere(int32_t functions, int32_t elements, double nu) {
  Model m = revolved(functions);
  m.symmetry = 2;
  Body body;
  body.element_nodes = 4, body.poisson_ratio = nu;
  for (double r : {2.0, 1.0}) {
    const int32_t first = body.elements() + 1;
    for (int32_t i = 0; i <= 3 * elements; ++i) {
      const double s = i / (3.0 * elements), f = kPi / 2 * (r > 1.5 ? s : 1 - s);
      body.xy.insert(body.xy.end(),
                     {s == (r > 1.5 ? 1 : 0) ? 0 : r * std::cos(f), s == (r > 1.5 ? 0 : 1) ? 0 : r * std::sin(f)});
    }
    body.regions.push_back({first, first + elements - 1});
    body.sides.push_back(body.regions.back());
    ++body.open_regions;
  }
  m.add(body);
  m.set(1, 2, [](double x, double y) { return end_of(kPulled, x, y); });
  return m;
}

State sphere_state(double r, double z, double nu) {
  const double rho = std::hypot(r, z), c = r / rho, s = z / rho, over = 8 / (rho * rho * rho);
  const double radial = (1 - over) / 7, round = (1 + over / 2) / 7;
  const double u = ((1 - 2 * nu) * rho + (1 + nu) * 4 / (rho * rho)) / 7000;
  return {u * c, u * s, radial * c * c + round * s * s, radial * s * s + round * c * c, (radial - round) * c * s, round};
}

} // namespace

TEST_CASE("points inside rings: hollow sphere, above and below its line of symmetry" * doctest::skip(kNoRings)) {
  const double limit_u[] = {2e-3, 6e-6, 3e-7}, limit_s[] = {2e-2, 2e-4, 1e-5};
  for (double nu : {0.3, 0.5})
    for (int32_t functions : {2, 3, 4}) {
      CAPTURE(nu);
      CAPTURE(functions);
      Machine machine(hollow_sphere(functions, 12, nu));
      REQUIRE(machine.run().status == C2D_OK);
      std::vector<double> points;
      for (double rho : {1.03, 1.2, 1.6, 1.95})
        for (double f : {-0.7, 0.0, 0.01, 0.6, 1.4, 1.5707, kPi / 2})
          points.insert(points.end(), {rho * std::cos(f), rho * std::sin(f)});
      const auto field = [=](double r, double z) { return sphere_state(r, z, nu); };
      const double u = 1.5 / 1000; // the largest displacement is about this
      check_at(machine, points, field, limit_u[functions - 2] * u, limit_s[functions - 2]);
    }
}

TEST_CASE("points inside rings: two columns in contact, one of them a ring far from the axis" * doctest::skip(kNoRings)) {
  for (int32_t kind : solved_bodies::kKinds)
    for (double bore : {0.0, 1e3}) {
      Model m = revolved(3);
      const auto column = [=](double z0, double z1, int32_t n) {
        return bore == 0 ? open_polygon({{0, z0, n}, {2, z0, 4}, {2, z1, n}, {0, z1, 1}}, 1000, 0.0)
                         : rectangle(bore, z0, bore + 2, z1, {n, 4, n, 4}, 1000, 0.0);
      };
      m.add(column(0, 1, 5));
      m.add(column(1, 3, kind == C2D_ZONE_FREE ? 7 : 5));
      m.friction = 0.3;
      m.set(1, 1, end_of("0110"));
      m.set(2, 3, end_of(kPulled, 0, -100));
      m.join(kind, 1, 3, 2, 1);
      Machine machine(m);
      REQUIRE(machine.run().status == C2D_OK);
      const Field field = [](double, double z) { return State{0, -0.1 * z, 0, -100, 0, 0}; };
      check_at(machine, {bore + 1, 0.5, bore + 0.3, 0.98, bore + 1.2, 1.02, bore + 0.5, 2.5, bore + 1.7, 2.99}, field, 1e-8,
               1e-5);
    }
}
