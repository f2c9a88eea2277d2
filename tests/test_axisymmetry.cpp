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
          REQUIRE(c2d_get(machine.solver, C2D_END_SZZ, 1, 1, static_cast<int32_t>(round.size()), round.data(), 1) == C2D_OK);
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
double thick_sphere(int32_t functions, int32_t outside, int32_t inside, double nu) {
  Model m = revolved(functions);
  m.symmetry = 2;
  Body body;
  body.element_nodes = 4, body.poisson_ratio = nu;
  add_quarter(body, outside, 2, true);
  add_quarter(body, inside, 1, false);
  m.add(body);
  m.set(1, 2, [](double x, double y) { return end_of(kPulled, x, y); });
  Machine machine(m);
  const Result r = machine.run();
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  double worst = 0, largest = 0;
  std::vector<double> round(r.boundary[0].size()); // the stress round the axis, at the poles too
  REQUIRE(c2d_get(machine.solver, C2D_END_SZZ, 1, 1, static_cast<int32_t>(round.size()), round.data(), 1) == C2D_OK);
  for (size_t i = 0; i < round.size(); ++i) {
    const double rho = std::hypot(r.boundary[0][i].x, r.boundary[0][i].y);
    CAPTURE(r.boundary[0][i].x);
    CHECK(std::fabs(round[i] - (1 + 4 / (rho * rho * rho)) / 7) < 0.02);
  }
  for (const EndResult& end : r.boundary[0]) {
    const double rho = std::hypot(end.x, end.y), u = ((1 - 2 * nu) * rho + (1 + nu) * 4 / (rho * rho)) / 7000;
    worst = std::max(worst, std::hypot(end.ux - u * end.x / rho, end.uy - u * end.y / rho));
    largest = std::max(largest, u);
  }
  return worst / largest;
}

} // namespace

TEST_CASE("axisymmetric bodies: the thick sphere, with an image across z" * doctest::skip(kNoRings)) {
  // 44 elements on the half section; linear, quadratic, cubic functions. The load acts inside, and its interpolation is most of
  // the error.
  const double limit[] = {2.5e-3, 2e-5, 1e-6};
  for (double nu : {0.3, 0.49, 0.49999, 0.5})
    for (int32_t functions : {2, 3, 4}) CHECK(thick_sphere(functions, 10, 12, nu) < limit[functions - 2]);
  for (int32_t functions : {2, 3, 4}) CHECK(thick_sphere(functions, 5, 6, 0.3) / thick_sphere(functions, 10, 12, 0.3) > 3.5);
}

TEST_CASE("axisymmetric bodies: a ring with a cavity beside the axis, nu up to 1/2" * doctest::skip(kNoRings)) {
  // u_r = 1/(2 G r), s_rr = -1/r^2, s_zz = 0
  for (double nu : {0.3, 0.4999, 0.5}) {
    Model m = revolved(3);
    Body body = rectangle(1, -1, 3, 4, {14, 20, 14, 20}, 1000, nu);
    add_polygon(body, {{1.5, 1, 14}, {1.5, 2, 14}, {2.5, 2, 14}, {2.5, 1, 14}});
    m.add(body);
    for (int32_t side : {2, 4, 5, 7})
      m.set(1, side, [=](double x, double) { return end_of(kPulled, (side == 2 || side == 5 ? -1 : 1) / (x * x)); });
    m.set(1, 1, end_of("0110"));
    const Result r = solved(m);
    double worst = 0;
    for (const EndResult& end : r.boundary[0]) worst = std::max(worst, std::hypot(end.ux - (1 + nu) / 1000 / end.x, end.uy));
    CHECK(worst < 1e-4 * (1 + nu) / 1000);
  }
}

TEST_CASE("axisymmetric bodies: rings under pressure, up to 30,000 times their section" * doctest::skip(kNoRings)) {
  const double radius[] = {3.0, 30.0, 3e3, 3e4}, limit[] = {2e-6, 2e-9, 1e-9, 1e-8};
  for (int k = 0; k < 4; ++k) {
    Model m = revolved(3);
    const double r0 = radius[k], outer = r0 + 1, p = 1 / r0, a = p * r0 * r0 / (outer * outer - r0 * r0);
    m.add(rectangle(r0, 0, outer, 1, {8, 8, 8, 8}));
    m.set(1, 1, end_of("0110"));
    m.set(1, 4, end_of(kPulled, p));
    const Result r = solved(m);
    double worst = 0, largest = 0;
    for (const EndResult& end : r.boundary[0]) {
      const double u = a / 1000 * ((1 - 0.3) * end.x + (1 + 0.3) * outer * outer / end.x);
      worst = std::max(worst, std::fabs(end.ux - u));
      largest = std::max(largest, u);
    }
    CHECK(worst < limit[k] * largest);
  }
}

namespace {

// Equal columns, one on the other, pressed by 100 on their upper end.
Model columns(int32_t kind, int32_t functions) {
  Model m = revolved(functions);
  m.add(cylinder(2, 0, 1, {5, 4, 6}, 1000, 0.0));
  m.add(cylinder(2, 1, 3, {kind == C2D_ZONE_FREE ? 7 : 6, 4, 5}, 2000, 0.0));
  m.friction = 0.3;
  m.set(1, 1, end_of("0110"));
  m.set(2, 3, end_of(kPulled, 0, -100));
  m.join(kind, 1, 3, 2, 1);
  return m;
}

// A rigid flat punch of radius 1 on a cylinder of radius and height `size`, smooth, pressed by 1e-3: force over 2 E* d.
// `worst`: of the pressures for r < 0.99, against force / (2 pi sqrt(1 - r^2)).
double flat_punch(double size, double& worst) {
  Model m = revolved(3);
  m.add(open_polygon({{0, -size, 10}, {size, -size, 10}, {size, 0, 36, 0.7}, {1, 0, 36, 1 / 0.8}, {0, 0, 1}}));
  Body punch = open_polygon({{0, 0, 36, 0.8}, {1, 0, 4}, {1, 1, 4}, {0, 1, 1}});
  punch.rigid = 1;
  punch.motion[1] = -1e-3;
  m.add(punch);
  m.set(1, 1, end_of("0110"));
  m.join(C2D_ZONE_MATCHING, 1, 4, 2, 1);
  const Result r = solved(m);
  const double force = std::fabs(r.zones[0].force[1]);
  worst = 0;
  for (const Row& row : r.zone_rows(1))
    if (row[C2D_X] < 0.99)
      worst = std::max(worst, relative(row[C2D_TN], force / (2 * kPi * std::sqrt(1 - row[C2D_X] * row[C2D_X]))));
  return force / (2 * 1000 / (1 - 0.09) * 1e-3);
}

// Half of a hub of diameters 40 and 80, length 40, on a shaft of length 120, interference 0.02 on the radius.
Model hub_on_shaft(double mu) {
  Model m = revolved(3);
  m.symmetry = 2;
  m.friction = mu;
  m.add(open_polygon({{40, 0, 6}, {40, 20, 12, 0.7}, {20, 20, 16, 2}, {20, 0, 1}}, 210e3));
  m.add(open_polygon({{20.02, 0, 16, 0.5}, {20.02, 20, 16, 2}, {20.02, 60, 6}, {0, 60, 1}}, 210e3));
  m.interference = 1;
  m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
  return m;
}

// A side of `elements` elements along a curve, s from 0 to 1, without its last point.
void add_side(Body& body, int32_t elements, const test::Callable<void(double s, double& x, double& y)>& curve) {
  const int32_t first = body.sides.empty() ? 1 : body.sides.back().last + 1, points = elements * (body.element_nodes - 1);
  for (int32_t i = 0; i < points; ++i) {
    double x, y;
    curve(static_cast<double>(i) / points, x, y);
    body.xy.insert(body.xy.end(), {x, y});
  }
  body.sides.push_back({first, first + elements - 1});
}

// Half a sphere of radius 100 on a block of 60 by 60, both E = 1000, pressed by the load for which Hertz has a = 1, with 20
// quadratic elements on it.
constexpr double kSphere = 100, kEdge = 1;
Model sphere_on_block(int32_t functions, double nu, double mu) {
  Model m = revolved(functions);
  const int32_t zone = 25, top = 14, face = 16;
  const double w = kEdge / 19.5 * zone, pressed = 4 * 1000 / (1 - nu * nu) / 2 / (3 * kSphere);
  Body block = open_polygon({{0, -60, 8}, {60, -60, 8}, {60, 0, top, 0.66}, {w, 0, zone}, {0, 0, 1}}, 1000, nu);
  m.add(block);
  Body sphere;
  sphere.poisson_ratio = nu, sphere.element_nodes = 3;
  add_side(sphere, zone,
           [=](double s, double& x, double& y) { x = w * s, y = x * x / (kSphere + std::sqrt(kSphere * kSphere - x * x)); });
  add_side(sphere, face, [=](double s, double& x, double& y) {
    const double from = std::asin(w / kSphere), f = from * std::pow(kPi / 2 / from, s);
    x = kSphere * std::sin(f), y = kSphere * (1 - std::cos(f));
  });
  add_side(sphere, 6, [](double s, double& x, double& y) { x = kSphere * (1 - s), y = kSphere; });
  sphere.xy.insert(sphere.xy.end(), {0.0, kSphere});
  sphere.open_regions = 1, sphere.regions.push_back({1, sphere.sides.back().last});
  m.add(sphere);
  m.friction = mu;
  m.set(1, 1, end_of("0110"));
  m.set(2, 3, end_of(kPulled, 0, -pressed / (kPi * kSphere * kSphere)));
  m.join(C2D_ZONE_MATCHING, 1, 4, 2, 1);
  return m;
}

} // namespace

TEST_CASE("axisymmetric contact: columns stacked, forces and energies of the whole circumference" * doctest::skip(kNoRings)) {
  for (int32_t kind : solved_bodies::kKinds)
    for (int32_t functions : {2, 3}) {
      const Result r = solved(columns(kind, functions));
      for (const Row& row : r.zone_rows(1)) CHECK(std::hypot(row[C2D_TN] - 100, row[C2D_TT]) < 1e-9);
      CHECK(relative(r.zones[0].force[1], 100 * 4 * kPi) < 1e-10);
      CHECK(r.zones[0].moment == 0);
      CHECK(relative(r.zones[0].length, 4 * kPi) < 1e-10); // the area that touches
      CHECK(relative(r.last().elastic, 0.5 * 1e4 * 4 * kPi * (1e-3 + 1e-3)) < 1e-10);
      CHECK(relative(r.last().work, r.last().elastic) < 1e-10);
    }
}

// What is soft is the radius of a ring, by the square of its distance from the axis: pressures keep their digits all the same.
TEST_CASE("axisymmetric contact: three rings upon each other, far from the axis" * doctest::skip(kNoRings || c2d::kSmallCode)) {
  for (int32_t functions : {2, 3, 4})
    for (double radius : {100.0, 1e4}) {
      Model m = revolved(functions);
      for (int i = 0; i < 3; ++i) m.add(rectangle(radius, i, radius + 1, i + 1, {3, 2, 3, 2}, 1000, 0));
      m.friction = 0.3;
      m.set(1, 1, end_of("0110"));
      m.set(3, 3, end_of(kPulled, 0, -1));
      m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1), m.join(C2D_ZONE_MATCHING, 2, 3, 3, 1);
      CAPTURE(functions);
      CAPTURE(radius);
      const Result r = solved(m);
      for (const Row& row : r.last().rows) CHECK(std::fabs(row[C2D_TN] - 1) < 1e-10);
    }
}

namespace {

// What is said of a coarse contact: of a wide block, crowned, on another one, at this distance from the axis.
std::string coarse_contact(int32_t plane, double radius, double unit) {
  Model m;
  m.plane = plane, m.function_nodes = 2;
  m.add(rectangle(radius, 0, radius + 10, 4, {6, 3, 10, 3}));
  Body upper = rectangle(radius, 4, radius + 10, 8, {10, 3, 6, 3});
  for (size_t i = 0; i <= 10; ++i) upper.xy[2 * i + 1] += 1e-4 * std::pow(static_cast<double>(i) - 5.2, 2);
  m.add(upper);
  m.set(1, 1, end_of(kHeld)), m.set(2, 3, end_of(kHeld, 0, 0, 0, -2e-4));
  m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
  const Result r = solved(scaled(m, unit, 1));
  for (const c2d_error& e : r.told)
    if (e.status == C2D_WARN_FEW_PAIRS) return e.text;
  return "";
}

std::string behind(const std::string& text, const char* words) { return text.substr(std::min(text.find(words), text.size())); }

} // namespace

TEST_CASE("axisymmetric contact: what is said of a coarse contact is said of widths, not of areas" * doctest::skip(kNoRings)) {
  const std::string strip = coarse_contact(C2D_PLANE_STRAIN, 0, 1);
  CHECK(behind(strip, "(") != "");
  CHECK(behind(coarse_contact(C2D_AXISYMMETRIC, 1e4, 1), "(") == behind(strip, "("));
  const std::string ring = behind(coarse_contact(C2D_AXISYMMETRIC, 3, 1), "(");
  CHECK(ring != "");
  CHECK(behind(coarse_contact(C2D_AXISYMMETRIC, 3, 100), "(") == ring);
}

TEST_CASE("axisymmetric contact: elimination is dense, whatever the options say" * doctest::skip(kNoRings || c2d::kSmallCode)) {
  Model m = columns(C2D_ZONE_MATCHING, 2);
  m.elimination = C2D_ELIMINATION_COMPRESSED;
  CHECK(solved(m).last().rows == solved(columns(C2D_ZONE_MATCHING, 2)).last().rows);
}

TEST_CASE("axisymmetric contact: a rigid flat punch on a block" * doctest::skip(kNoRings)) {
  // The half space: the block's own share of the compliance falls like one over its size.
  double worst = 0;
  const double small = flat_punch(60, worst), large = flat_punch(180, worst);
  CHECK(worst < 1e-3);
  CHECK(relative((3 / large - 1 / small) / 2, 1) < 1e-4);
}

TEST_CASE("axisymmetric contact: Hertz, a sphere on a block" * doctest::skip(kNoRings)) {
  const double nu = 0.3, modulus = 1000 / (1 - nu * nu) / 2;
  for (int32_t functions : {2, 3, 4}) {
    Model m = sphere_on_block(functions, nu, 0);
    const Result r = solved(m);
    const double force = std::fabs(r.zones[0].force[1]), a = std::cbrt(3 * force * kSphere / (4 * modulus));
    const double p0 = 2 * modulus * a / (kPi * kSphere);
    double worst = 0, last = 0;
    for (const Row& row : r.zone_rows(1)) {
      const double x = row[C2D_X] / a;
      if (x < 0.9) worst = std::max(worst, std::fabs(row[C2D_TN] / p0 - std::sqrt(1 - x * x)));
      if (row[C2D_TN] > 0) last = std::max(last, x);
    }
    CHECK(relative(a, kEdge) < 3e-3);
    CHECK(worst < 1e-3);
    CHECK(last > 0.95);
    CHECK(last < 1.01);
  }
}

TEST_CASE("axisymmetric contact: a sphere on a rigid flat with friction, the border of stick" * doctest::skip(kNoRings)) {
  // Radius of stick over that of contact, pressure at the centre over that of Hertz (0: not compared): an independent program
  // of the same problem, the first CONTACT's case spence35. (Spence's formula leaves out what friction does to the pressure.)
  struct {
    double nu, mu, border, p0;
  } const kCases[] = {{0.0, 0.2986, 0.494, 0}, {0.3, 0.2, 0.711, 1.0806}, {0.3, 0.1, 0.208, 1.0824}, {0.2, 0.3, 0.758, 1.1492}};
  for (int32_t functions : {3, 4})
    for (const auto& at : kCases) {
      const double modulus = 1000 / (1 - at.nu * at.nu), force = 4 * modulus / (3 * kSphere);
      Model m = sphere_on_block(functions, at.nu, at.mu);
      m.body(1).rigid = 1;
      m.set(2, 3, end_of(kPulled, 0, -force / (kPi * kSphere * kSphere)));
      const Result r = solved(m);
      double stick = 0, edge = 0, centre = 0;
      for (const Row& row : r.zone_rows(1)) {
        if (row[C2D_TN] > 0) edge = std::max(edge, row[C2D_X]);
        if (static_cast<int>(row[C2D_STATUS]) == C2D_STICK) stick = std::max(stick, row[C2D_X]);
        if (row[C2D_X] == 0) centre = row[C2D_TN] * kPi * kSphere / (2 * modulus);
      }
      CAPTURE(at.nu);
      CAPTURE(at.mu);
      CHECK(std::fabs(stick - at.border * edge) < kEdge / 19.5);
      if (at.p0 > 0 && functions == 4) CHECK(std::fabs(centre - at.p0) < 3e-3);
    }
}

TEST_CASE("axisymmetric contact: a hub pressed on a shaft" * doctest::skip(kNoRings)) {
  for (double mu : {0.0, 0.15}) {
    const Result r = solved(hub_on_shaft(mu));
    CHECK(relative(std::fabs(r.zones[0].force[0]) / r.zones[0].length, mu == 0 ? 80.604 : 81.717) < 1e-4);
    CHECK(std::fabs(r.last().defect) < 1e-12);
  }
}

TEST_CASE("axisymmetric bodies: platens move along the axis and hold the radius" * doctest::skip(kNoRings)) {
  for (int32_t functions : {2, 3, 4})
    for (double bore : {0.0, 0.7}) {
      CAPTURE(functions);
      CAPTURE(bore);
      // The lower end is glued; the upper one is moved by 0.01: prescribed, by a platen, by a platen with the force found.
      Model m = revolved(functions);
      m.add(bore == 0 ? cylinder(2, 0, 3, {4, 5, 4}) : rectangle(bore, 0, 2, 3, {4, 5, 4, 5}));
      m.set(1, 1, end_of(kHeld));
      Model prescribed = m;
      prescribed.set(1, 3, end_of(kHeld, 0, 0, 0, 0.01));
      const Result exact = solved(prescribed);
      Platen& moved = m.move(1, 3);
      moved.is_free[0] = moved.is_free[1] = moved.is_free[2] = 0, moved.motion[1] = 0.01;
      const Result r = solved(m);
      REQUIRE(r.boundary[0].size() == exact.boundary[0].size());
      double worst = 0;
      for (size_t i = 0; i < r.boundary[0].size(); ++i) {
        const EndResult &a = r.boundary[0][i], &b = exact.boundary[0][i];
        worst = std::max(worst, std::hypot(a.ux - b.ux, a.uy - b.uy));
      }
      CHECK(worst < 1e-10);
      CHECK(relative(r.last().elastic, exact.last().elastic) < 1e-8);
      const double force = r.bodies[1].applied[1];
      CHECK(relative(force, 2 * exact.last().elastic / 0.01) < 1e-8); // of the whole circumference
      m.platens[0].is_free[1] = 1, m.platens[0].load[1] = force, m.platens[0].motion[1] = 0;
      const Result pulled = solved(m);
      CHECK(relative(pulled.states[1].motion[1], 0.01) < 1e-9);
      CHECK(relative(pulled.last().work, exact.last().elastic) < 1e-8);
    }
}

namespace {

std::string refusal(const Model& m) {
  Machine machine(m);
  CHECK(machine.status == C2D_ERR_INPUT);
  std::string text;
  for (const c2d_error& e : machine.told) text += std::string(e.text) + "\n";
  return text;
}

void refuses(const Model& m, const char* words) {
  const std::string text = refusal(m);
  CHECK_MESSAGE(text.find(words) != std::string::npos, text);
}

Model one(const Body& body) {
  Model m = revolved(2);
  m.add(body);
  m.set(1, 1, end_of("0110"));
  return m;
}

} // namespace

TEST_CASE("axisymmetric bodies: what is refused, and in which words" * doctest::skip(kNoRings)) {
  refuses(one(rectangle(-1, 0, 2, 1, {3, 2, 3, 2})), "lies beyond the axis x = 0, expected a half section at x >= 0");
  refuses(one(rectangle(0, 0, 2, 1, {3, 2, 3, 2})), "lies on the axis x = 0, expected no elements there: leave them out");
  refuses(one(open_polygon({{0, 0, 2}, {2, 0, 2}, {2, 1, 2}, {1, 1, 1}})),
          "expected it on the axis x = 0 or a line of symmetry");
  refuses(one(polygon({{0, 0, 2}, {2, -1, 2}, {2, 1, 2}})), "touches the axis x = 0, expected that only at the ends");
  Model m = one(cylinder(1, 0, 1, {2, 2, 2}));
  m.set(1, 1, end_of(kHeld, 0, 0, 0.1));
  refuses(m, "lies on the axis x = 0 and has a prescribed ux that is not 0");
  m = one(cylinder(1, 0, 1, {2, 2, 2}));
  m.point_loads.push_back({1, 0, 0.5, 1, 0});
  refuses(m, "point load 1 at (0, 0.5) on a symmetry line acts across it, expected a force along the line");
  m = one(cylinder(1, 0, 1, {2, 2, 2}));
  m.body(1).force[0] = -1;
  refuses(m, "the body force of body 1 in load case 1 acts across the axis x = 0, expected one along it");
  m = one(cylinder(1, 0, 1, {2, 2, 2}));
  m.symmetry = 1;
  refuses(m, "a line of symmetry x = value in a model of bodies of revolution");
  m = one(cylinder(1, 0, 1, {2, 2, 2}));
  m.move(1, 3);
  refuses(m, "may move freely across the axis, expected motions along it");
}
