// Body forces of bodies of revolution (METHOD 21.6): hanging bars, turning cylinders, rings and spheres against closed forms.
#include "ring_states.hpp"
#include "solved_bodies.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace many;
using namespace ring_states;
using solved_bodies::solved;

namespace {

// A half section from z = 0 to z = 3 of radii `bore` and 2: sides 1 lower, 2 outer, 3 upper, 4 inner.
Model half_section(int32_t functions, double bore, double nu) {
  Model m;
  m.plane = C2D_AXISYMMETRIC;
  m.function_nodes = functions;
  m.add(bore == 0 ? open_polygon({{0, 0, 4}, {2, 0, 5}, {2, 3, 3}, {0, 3, 1}}, 1000, nu)
                  : rectangle(bore, 0, 2, 3, {4, 5, 3, 6}, 1000, nu));
  return m;
}

// Largest errors of the displacements, of their largest, and of the stresses, the one round the axis as well.
void check_field(const Model& m, const Field& field, double limit) {
  Machine machine(m);
  const Result r = machine.run();
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  std::vector<double> round(r.boundary[0].size());
  REQUIRE(c2d_get(machine.solver, C2D_END_SZZ, 1, 1, static_cast<int32_t>(round.size()), round.data(), 1) == C2D_OK);
  double du = 0, ds = 0, u = 1e-3, s = 0;
  for (size_t i = 0; i < round.size(); ++i) {
    const EndResult& end = r.boundary[0][i];
    const State exact = field(end.x, end.y);
    u = std::max({u, std::fabs(exact.ur), std::fabs(exact.uz)});
    s = std::max({s, std::fabs(exact.srr), std::fabs(exact.szz), std::fabs(exact.hoop)});
    du = std::max({du, std::fabs(end.ux - exact.ur), std::fabs(end.uy - exact.uz)});
    ds = std::max({ds, std::fabs(end.sxx - exact.srr), std::fabs(end.syy - exact.szz), std::fabs(end.sxy - exact.srz),
                   std::fabs(round[i] - exact.hoop)});
  }
  CHECK(du < limit * u);
  CHECK(ds < 100 * limit * s);
}

// A cylinder, ring or disc that turns, of radii a and 2, between guided ends or with ends that are free in the mean: Lame's
// solution with the centrifugal force, in terms of the elongation e.
Field turning(double w, double a, double nu, double e) {
  const double g = 500 / (1 + nu), c = -w * (1 - 2 * nu) / (16 * g * (1 - nu)), k = w / (8 * (1 - nu)), b = 2;
  // s_rr = p - q/r^2 - (3 - 2 nu) k r^2, s_hoop = p + q/r^2 - (1 + 2 nu) k r^2; u = A r + q/(2 G r) + c r^3.
  const double q = (3 - 2 * nu) * k * a * a * b * b, p = (3 - 2 * nu) * k * (a * a + b * b);
  return [=](double r, double z) {
    const double over = a > 0 ? q / (r * r) : 0;
    const double A = ((1 - 2 * nu) * p / (2 * g)) - nu * e; // e_rr + e_hoop = (1 - 2 nu) (s_rr + s_hoop)/2G - 2 nu e, at r = 0
    State s = {A * r + over * r / (2 * g) + c * r * r * r, e * z, p - over - (3 - 2 * nu) * k * r * r, 0, 0,
               p + over - (1 + 2 * nu) * k * r * r};
    s.szz = nu * (s.srr + s.hoop) + 1000 * e;
    return s;
  };
}

} // namespace

TEST_CASE("ring body force: bars and tubes hang, every material: exact" * doctest::skip(kNoRings)) {
  for (int32_t functions : {3, 4})
    for (double bore : {0.0, 0.7})
      for (double nu : {0.3, 0.5, -0.4}) {
        CAPTURE(functions);
        CAPTURE(bore);
        CAPTURE(nu);
        const double b = -4; // fixed in the plane z = 0 as the field has it there, free elsewhere
        Model m = half_section(functions, bore, nu);
        m.body(1).force[1] = b;
        const Field field = [=](double r, double z) {
          return State{
              -nu * b * (3 - z) * r / 1000, b * (3 * z - z * z / 2) / 1000 - nu * b * r * r / 2000, 0, b * (3 - z), 0, 0};
        };
        m.set(1, 1, [=](double r, double z) { return end_of(kHeld, 0, 0, field(r, z).ur, field(r, z).uz); });
        check_field(m, field, 1e-10);
        // Support and weight balance; the strain energy.
        const Result r = solved(m);
        const double area = kPi * (4 - bore * bore);
        CHECK(std::fabs(r.bodies[0].applied[1]) < 1e-10 * 3 * 4 * area);
        if (nu == 0.3) {
          m.set(1, 1, end_of("0110")); // on a smooth floor
          const Result floor = solved(m);
          CHECK(std::fabs(floor.last().elastic / (b * b * area * 27 / 6000) - 1) < 0.02); // but for the ends' own field
          CHECK(std::fabs(floor.last().work / floor.last().elastic - 1) < 1e-9);
        }
      }
}

TEST_CASE("ring body force: a solid cylinder turns, between guided ends and free in the mean: exact" *
          doctest::skip(kNoRings)) {
  for (int32_t functions : {3, 4})
    for (double nu : {0.3, 0.5, -0.4}) {
      CAPTURE(functions);
      CAPTURE(nu);
      const double w = 7;
      Model m = half_section(functions, 0, nu);
      m.body(1).spin = w;
      m.set(1, 1, end_of("0110"));
      m.set(1, 3, end_of("0110"));
      check_field(m, turning(w, 0, nu, 0), 1e-10);
      const double e = -nu * w * 4 / (2 * 1000); // no force along the axis: nu times the mean of s_rr + s_hoop over E
      const Field free = turning(w, 0, nu, e);
      m.set(1, 3, [&](double r, double z) { return end_of(kPulled, 0, free(r, z).szz); });
      check_field(m, free, 1e-10);
      double sum = 0;
      for (int i = 0; i < 1000; ++i) sum += (i + 0.5) * free((i + 0.5) / 500, 0).szz;
      CHECK(std::fabs(sum) < 1e-3 * 5e5 * w);
      // The energy of the field: half the work of the force.
      m.set(1, 3, end_of("0110"));
      const Field guided = turning(w, 0, nu, 0);
      double work = 0;
      for (int i = 0; i < 2000; ++i) {
        const double r = (i + 0.5) / 1000;
        work += 0.5 * w * r * guided(r, 0).ur * 2 * kPi * r * 3 / 1000;
      }
      if (work > 0) CHECK(std::fabs(solved(m).last().elastic / work - 1) < 1e-5);
    }
}

TEST_CASE("ring body force: thick rings turn between guided ends; far from the axis as well" * doctest::skip(kNoRings)) {
  const double bore[] = {1.0, 0.3}, limit[] = {2e-6, 3e-5};
  for (int k = 0; k < 2; ++k)
    for (double nu : {0.3, 0.5}) {
      Model m;
      m.plane = C2D_AXISYMMETRIC;
      m.function_nodes = 4;
      m.add(rectangle(bore[k], 0, 2, 1, {16, 8, 16, 12}, 1000, nu));
      m.body(1).spin = 7;
      m.set(1, 1, end_of("0110"));
      m.set(1, 3, end_of("0110"));
      check_field(m, turning(7, bore[k], nu, 0), limit[k]);
    }
  // A thin ring: hoop stress w R^2, which makes the radius grow by w R^3/E.
  const double big = 3e4, w = 1e-7;
  Model m;
  m.plane = C2D_AXISYMMETRIC;
  m.function_nodes = 3;
  m.add(rectangle(big - 0.5, 0, big + 0.5, 1, {6, 6, 6, 6}));
  m.body(1).spin = w;
  m.set(1, 1, end_of("0110"));
  const Result r = solved(m);
  for (const EndResult& end : r.boundary[0]) CHECK(std::fabs(end.ux / (w * big * big * big / 1000) - 1) < 1e-4);
}

namespace {

// A sphere of radius 1 turns (Chree): the cubic field that is in equilibrium and leaves the surface free.
State sphere(double w, double nu, double r, double z) {
  const double g = 500 / (1 + nu), d = 10 * g * (nu - 1) * (5 * nu + 7), n1 = nu + 1;
  const double a = w * 4 * (3 * nu * nu + 2 * nu - 3) / (d * n1), b = -w * (5 * nu * nu + 3 * nu - 4) / d;
  const double c = -w * (5 * nu * nu + 8 * nu - 9) / d, f = 2 * w * (nu - 3) / d;
  const double h = -w * (10 * nu * nu * nu + 3 * nu * nu - 18 * nu - 3) / (d * n1), k = -w * (3 * nu + 1) / d;
  return {a * r + b * r * r * r + c * r * z * z, h * z + k * z * z * z + f * z * r * r, 0, 0, 0, 0};
}

double turning_sphere(int32_t functions, int32_t elements, double nu) {
  Model m;
  m.plane = C2D_AXISYMMETRIC;
  m.function_nodes = functions;
  m.symmetry = 2;
  Body body;
  body.element_nodes = 4, body.poisson_ratio = nu;
  for (int32_t i = 0; i <= 3 * elements; ++i) {
    const double f = kPi / 2 * i / (3 * elements);
    body.xy.insert(body.xy.end(), {i == 3 * elements ? 0 : std::cos(f), i == 0 ? 0 : std::sin(f)});
  }
  body.regions = body.sides = {{1, elements}};
  body.open_regions = 1;
  m.add(body);
  m.body(1).spin = 7;
  const Result r = solved(m);
  double worst = 0, largest = 0;
  for (const EndResult& end : r.boundary[0]) {
    const State exact = sphere(7, nu, end.x, end.y);
    worst = std::max(worst, std::hypot(end.ux - exact.ur, end.uy - exact.uz));
    largest = std::max(largest, std::hypot(exact.ur, exact.uz));
  }
  return worst / largest;
}

} // namespace

TEST_CASE("ring body force: a sphere turns" * doctest::skip(kNoRings)) {
  for (double nu : {0.3, 0.5}) {
    const double limit[] = {1e-2, 1e-4, 4e-6}, falls[] = {3, 7, 9};
    for (int32_t functions : {2, 3, 4}) {
      const double coarse = turning_sphere(functions, 12, nu), fine = turning_sphere(functions, 24, nu);
      CHECK(coarse < limit[functions - 2]);
      CHECK(fine < coarse / falls[functions - 2]);
    }
  }
}

TEST_CASE("ring body force: a ring stands on a block, by its weight" * doctest::skip(kNoRings)) {
  Model m;
  m.plane = C2D_AXISYMMETRIC;
  m.function_nodes = 3;
  m.add(open_polygon({{0, -3, 6}, {3, -3, 6}, {3, 0, 4}, {2, 0, 6}, {1, 0, 4}, {0, 0, 1}}));
  m.add(rectangle(1, 0, 2, 2, {6, 6, 4, 6}));
  m.friction = 0.3;
  m.body(2).force[1] = -0.5;
  m.set(1, 1, end_of("0110"));
  m.join(C2D_ZONE_MATCHING, 1, 4, 2, 1);
  const Result r = solved(m);
  CHECK(std::fabs(std::fabs(r.zones[0].force[1]) / (0.5 * kPi * 3 * 2) - 1) < 1e-9);
  CHECK(std::fabs(r.last().work / r.last().elastic - 1) < 0.05); // the rest is dissipated
  CHECK(std::fabs(r.last().defect) < 1e-9);
}

namespace {

// Two columns upon each other, nu 0, pressed by p, the lower one heavy: the work, and what it is.
double work_of_columns(int32_t plane, int32_t kind, bool swapped, double p, double weight, double& exact) {
  const double r = 3, width = 0.6, area = plane == C2D_AXISYMMETRIC ? std::acos(-1.0) * width * (2 * r + width) : width;
  Model m;
  m.plane = plane, m.function_nodes = 3;
  m.add(rectangle(r, 0, r + width, 1, {2, 2, 3, 2}, 1000, 0));
  m.add(rectangle(r, 1, r + width, 2, {kind == C2D_ZONE_FREE ? 2 : 3, 2, 2, 2}, 1000, 0));
  m.body(1).force[1] = -weight;
  m.set(1, 1, end_of(kHeld)), m.set(2, 3, end_of(kPulled, 0, -p));
  m.join(kind, 1, 3, 2, 1);
  exact = area / 2000 * (2 * p * p + p * weight + weight * weight / 3);
  return solved(swapped ? with_swapped_sides(m, 1) : m).last().work;
}

} // namespace

TEST_CASE("body force: its work has what a free zone hands over, on either side, in the plane and round the axis") {
  for (int32_t plane : {int32_t{C2D_PLANE_STRAIN}, int32_t{C2D_AXISYMMETRIC}})
    for (int32_t kind : solved_bodies::kKinds)
      for (bool swapped : {false, true}) {
        if (plane == C2D_AXISYMMETRIC && kNoRings) continue;
        double exact = 0;
        const double work = work_of_columns(plane, kind, swapped, 1, 5, exact);
        CAPTURE(plane);
        CAPTURE(kind);
        CAPTURE(swapped);
        CHECK(std::fabs(work / exact - 1) < 1e-10);
      }
}
