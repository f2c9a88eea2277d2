// Bodies of revolution (METHOD 21) against closed forms: bars, the thick sphere, rings, contact of spheres, punches and hubs.
#include "memory/config.hpp"
#include "solved_bodies.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

using namespace many;
using solved_bodies::solved;

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr auto kNoRings = !c2d::kRings;

Model revolved(int32_t function_nodes) {
  Model m;
  m.plane = C2D_AXISYMMETRIC;
  m.function_nodes = function_nodes;
  return m;
}

// Solid cylinder of radius r from z0 to z1: sides 1 lower, 2 outer, 3 upper.
Body cylinder(double r, double z0, double z1, const std::array<int32_t, 3>& elements, double modulus = 1000, double nu = 0.3) {
  return open_polygon({{0, z0, elements[0]}, {r, z0, elements[1]}, {r, z1, elements[2]}, {0, z1, 1}}, modulus, nu);
}

double relative(double got, double expected) { return std::fabs(got / expected - 1); }

} // namespace

TEST_CASE("axisymmetric bodies: bars in tension and under pressure all round, every order" * doctest::skip(kNoRings)) {
  for (int32_t functions : {2, 3, 4})
    for (double bore : {0.0, 0.7})
      for (double side : {0.0, -40.0})
        for (double nu : {0.3, 0.5}) {
          // sigma_z = 100, sigma_r = sigma_theta = side
          Model m = revolved(functions);
          const int32_t first =
              m.add(bore == 0 ? cylinder(2, 0, 3, {4, 5, 3}, 1000, nu) : rectangle(bore, 0, 2, 3, {4, 5, 3, 6}, 1000, nu));
          m.set(first, 1, end_of("0110"));
          m.set(first, 2, end_of(kPulled, side));
          m.set(first, 3, end_of(kPulled, 0, 100));
          if (bore > 0) m.set(first, 4, end_of(kPulled, -side));
          Machine machine(m);
          const Result r = machine.run();
          REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
          const double ez = (100 - 2 * nu * side) / 1000, er = (side - nu * (side + 100)) / 1000;
          double u = 0, stress = 0;
          for (const EndResult& end : r.boundary[0]) {
            u = std::max({u, std::fabs(end.ux - er * end.x), std::fabs(end.uy - ez * end.y)});
            stress = std::max({stress, std::fabs(end.sxx - side), std::fabs(end.syy - 100), std::fabs(end.sxy)});
          }
          CAPTURE(functions);
          CAPTURE(bore);
          CHECK(u < 1e-10);
          CHECK(stress < 1e-8);
          std::vector<double> round(r.boundary[0].size());
          REQUIRE(c2d_get(machine.solver, C2D_END_SZZ, 1, 1, static_cast<int64_t>(round.size()), round.data(), 1) == C2D_OK);
          for (double value : round) CHECK(std::fabs(value - side) < 1e-8);
          // Forces are those of the whole circumference; the work of the loads on the way up.
          const double area = kPi * (4 - bore * bore);
          CHECK(std::fabs(r.bodies[0].applied[1]) < 1e-10 * 100 * area);
          CHECK(relative(r.last().elastic, (100 * ez + 2 * side * er) / 2 * area * 3) < 1e-9);
        }
}

namespace {

// One more open region through the points of a curve, s from 0 to 1. Open regions come first.
void add_open_curve(Body& body, int32_t elements, const test::Callable<void(double s, double& x, double& y)>& curve) {
  const int32_t first = body.elements() + 1, points = elements * (body.element_nodes - 1);
  for (int32_t i = 0; i <= points; ++i) {
    double x, y;
    curve(static_cast<double>(i) / points, x, y);
    body.xy.insert(body.xy.end(), {x, y});
  }
  body.regions.push_back({first, first + elements - 1});
  body.sides.push_back(body.regions.back());
  ++body.open_regions;
}

// A quarter of the section of a sphere, cut at z = 0 as well; anticlockwise if `outer`.
void add_quarter(Body& body, int32_t elements, double r, bool outer) {
  add_open_curve(body, elements, [=](double s, double& x, double& y) {
    const double f = kPi / 2 * (outer ? s : 1 - s);
    x = s == (outer ? 1 : 0) ? 0 : r * std::cos(f), y = s == (outer ? 0 : 1) ? 0 : r * std::sin(f);
  });
}

// Largest error of the displacement of a sphere of radii 1 and 2 under pressure inside, relative to the largest.
double thick_sphere(int32_t functions, int32_t elements, double nu) {
  Model m = revolved(functions);
  m.symmetry = 2;
  Body body;
  body.element_nodes = 4, body.poisson_ratio = nu;
  add_quarter(body, elements, 2, true);
  add_quarter(body, elements / 2, 1, false);
  m.add(body);
  m.set(1, 2, [](double x, double y) { return end_of(kPulled, x, y); });
  const Result r = solved(m);
  double worst = 0, largest = 0;
  for (const EndResult& end : r.boundary[0]) {
    const double rho = std::hypot(end.x, end.y), u = ((1 - 2 * nu) * rho + (1 + nu) * 4 / (rho * rho)) / 7000;
    worst = std::max(worst, std::hypot(end.ux - u * end.x / rho, end.uy - u * end.y / rho));
    largest = std::max(largest, u);
  }
  return worst / largest;
}

} // namespace

TEST_CASE("axisymmetric bodies: the thick sphere, with an image across z" * doctest::skip(kNoRings)) {
  for (double nu : {0.3, 0.5})
    for (int32_t functions : {2, 3, 4})
      for (int32_t elements : {4, 8, 16})
        MESSAGE(nu, " ", functions, " ", elements, " ", thick_sphere(functions, elements, nu));
}

TEST_CASE("axisymmetric bodies: rings under pressure, up to 30,000 times their section" * doctest::skip(kNoRings)) {
  for (double radius : {0.5, 3.0, 30.0, 3e3, 3e4}) {
    Model m = revolved(3);
    const double outer = radius + 1, p = 1 / radius, a = p * radius * radius / (outer * outer - radius * radius);
    m.add(rectangle(radius, 0, outer, 1, {8, 8, 8, 8}));
    m.set(1, 1, end_of("0110"));
    m.set(1, 4, end_of(kPulled, p));
    const Result r = solved(m);
    double worst = 0, largest = 0;
    for (const EndResult& end : r.boundary[0]) {
      const double u = a / 1000 * ((1 - 0.3) * end.x + (1 + 0.3) * outer * outer / end.x);
      worst = std::max(worst, std::fabs(end.ux - u));
      largest = std::max(largest, u);
    }
    MESSAGE(radius, " ", worst / largest);
  }
}
