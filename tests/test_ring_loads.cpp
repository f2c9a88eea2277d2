// Point loads on the axis of bodies of revolution and round it (METHOD 21.8): Kelvin's solution, statics, Betti's theorem.
#include "ring_states.hpp"
#include "solved_bodies.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace many;
using namespace ring_states;
using solved_bodies::solved;

namespace {

// A cylinder of radius 1 and length 6, or a tube.
Model rod(int32_t functions, double bore, int32_t n = 6) {
  Model m;
  m.plane = C2D_AXISYMMETRIC;
  m.function_nodes = functions;
  m.add(bore == 0 ? open_polygon({{0, 0, n}, {1, 0, 4 * n}, {1, 6, n}, {0, 6, 1}})
                  : rectangle(bore, 0, 1, 6, {n, 4 * n, n, 4 * n}));
  return m;
}

std::array<double, C2D_POINT_FIELDS> inside(const Machine& machine, double r, double z) {
  const double at[2] = {r, z};
  std::array<double, C2D_POINT_FIELDS> out{};
  REQUIRE(c2d_interior(machine.solver, 1, 1, at, 2, out.data(), C2D_POINT_FIELDS) == C2D_OK);
  CHECK(out[C2D_POINT_FLAG] != C2D_POINT_OUTSIDE);
  return out;
}

} // namespace

TEST_CASE("ring loads: a force on the axis, surrounded by Kelvin's displacements" * doctest::skip(kNoRings)) {
  const double nu = 0.3, g = 500 / (1 + nu), force = 50, z0 = 3, c = force / (16 * kPi * g * (1 - nu));
  Model m = rod(4, 0);
  m.point_loads.push_back({1, 0, z0, 0, force});
  for (int32_t side : {1, 2, 3})
    m.set(1, side, [=](double r, double z) {
      const double rho = std::hypot(r, z - z0), d = z - z0;
      return end_of(kHeld, 0, 0, c * r * d / (rho * rho * rho), c * (3 - 4 * nu + d * d / (rho * rho)) / rho);
    });
  Machine machine(m);
  const Result r = machine.run();
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  CHECK(std::fabs(r.bodies[0].applied[1]) < 1e-10 * force);
  for (const auto& at : {std::array<double, 2>{0.0, 3.5}, {0.4, 3.1}, {0.5, 2.2}, {0.001, 4.0}}) {
    const double z = at[1] - z0, rho = std::hypot(at[0], z), s = -force / (8 * kPi * (1 - nu) * rho * rho * rho),
                 t = 1 - 2 * nu;
    const auto row = inside(machine, at[0], at[1]);
    const double srr = s * (3 * at[0] * at[0] * z / (rho * rho) - t * z), szz = s * (3 * z * z * z / (rho * rho) + t * z);
    const double srz = s * (3 * at[0] * z * z / (rho * rho) + t * at[0]), round = -s * t * z;
    CHECK(std::fabs(row[C2D_POINT_UY] - c * (3 - 4 * nu + z * z / (rho * rho)) / rho) < 1e-5 * c);
    CHECK(std::fabs(row[C2D_POINT_SXX] - srr) < 1e-3);
    CHECK(std::fabs(row[C2D_POINT_SYY] - szz) < 1e-3);
    CHECK(std::fabs(row[C2D_POINT_SXY] - srz) < 1e-3);
    CHECK(std::fabs(row[C2D_POINT_SZZ] - round) < 1e-3);
  }
}

TEST_CASE("ring loads: far from a load in a rod the stress is uniform; work and energy agree" * doctest::skip(kNoRings)) {
  for (double bore : {0.0, 0.4})
    for (double r : {0.0, 0.7}) {
      if (bore > 0 && r == 0) continue;
      Model m = rod(3, bore);
      m.point_loads.push_back({1, r, 4.5, 0, -100});
      m.set(1, 1, end_of("0110"));
      Machine machine(m);
      const Result result = machine.run();
      REQUIRE_MESSAGE(result.status == C2D_OK, result.messages());
      CHECK(std::fabs(result.bodies[0].applied[1]) < 1e-10 * 100);
      const double area = kPi * (1 - bore * bore);
      for (double at : {0.45, 0.7, 0.9}) CHECK(std::fabs(inside(machine, at, 0.7)[C2D_POINT_SYY] / (-100 / area) - 1) < 1e-3);
      CHECK(std::fabs(inside(machine, 0.6, 5.9)[C2D_POINT_SYY]) < 0.05 * 100 / area);
      CHECK(std::fabs(result.last().defect) < 1e-2);
    }
}

TEST_CASE("ring loads: Betti's theorem for a ring, radial and along the axis, and a force on the axis" *
          doctest::skip(kNoRings)) {
  const double place[3][2] = {{0.6, 2.0}, {0.5, 3.5}, {0.0, 4.0}}, force[3][2] = {{3, 0}, {0, 5}, {0, 7}};
  double work[3][3];
  for (int k = 0; k < 3; ++k) {
    Model m = rod(4, 0);
    m.point_loads.push_back({1, place[k][0], place[k][1], force[k][0], force[k][1]});
    m.set(1, 1, end_of("0110"));
    Machine machine(m);
    REQUIRE(machine.run().status == C2D_OK);
    for (int i = 0; i < 3; ++i) {
      if (i == k) continue;
      const auto row = inside(machine, place[i][0], place[i][1]);
      work[i][k] = force[i][0] * row[C2D_POINT_UX] + force[i][1] * row[C2D_POINT_UY];
    }
  }
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < i; ++k) CHECK(std::fabs(work[i][k] / work[k][i] - 1) < 1e-5);
}
