// Contact zones whose sides are meshed independently: the patch test, where uniform pressure must pass
// whatever the meshes; the ordinary zone where the meshes happen to match; a cylinder on a block against
// matching meshes.
#include "paths.hpp"
#include "problem.hpp"
#include "shell.hpp"
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

using namespace problem;

namespace {

size_t at(int64_t i) { return static_cast<size_t>(i); }

struct Side {
  double x, y;
  int32_t elements;
  double growth = 1;
};
void add_sides(Body& body, const std::vector<Side>& sides) {
  const int32_t steps = body.element_nodes - 1;
  int32_t elements = 0;
  for (size_t i = 0; i < sides.size(); ++i) {
    const Side &a = sides[i], &b = sides[(i + 1) % sides.size()];
    std::vector<double> p = {0};
    const double ratio = a.elements > 1 ? std::pow(a.growth, 1.0 / (a.elements - 1)) : 1;
    double length = 1;
    for (int32_t e = 0; e < a.elements; ++e, length *= ratio) p.push_back(p.back() + length);
    for (int32_t e = 0; e < a.elements; ++e)
      for (int32_t k = 0; k < steps; ++k) {
        const double s = (p[at(e)] + (p[at(e + 1)] - p[at(e)]) * k / steps) / p.back();
        body.xy.push_back(a.x + s * (b.x - a.x));
        body.xy.push_back(a.y + s * (b.y - a.y));
      }
    elements += a.elements;
  }
  body.regions.push_back({1, elements});
}

// Two blocks of width 2 and height 1 on top of each other, on rollers at the left and below, pressed by
// `pressure`.
struct Blocks {
  int32_t lower = 7, upper = 10;
  double growth1 = 1, growth2 = 1, pressure = 3, mu = 0;
  int32_t element_nodes = 2, function_nodes = 2;
  bool free = true;
  bool left_first = false; // the sides at the left come first, not last
};
Problem pressed_blocks(const Blocks& b) {
  Problem p;
  p.function_nodes = b.function_nodes;
  p.friction = {b.mu};
  p.bodies.resize(2);
  for (Body& body : p.bodies) body.element_nodes = b.element_nodes;
  p.bodies[1].youngs_modulus = 700;
  p.bodies[1].poisson_ratio = 0.3;
  p.bodies[0].poisson_ratio = 0.21; // E/nu is not the same, so that free sliding and sticking differ
  if (b.mu > 0) p.bodies[0].poisson_ratio = 0.3, p.bodies[1].youngs_modulus = 1000;
  std::vector<Side> sides[2] = {{{0, 0, 4}, {2, 0, 3}, {2, 1, b.lower, b.growth1}, {0, 1, 3}},
                                {{0, 1, b.upper, b.growth2}, {2, 1, 3}, {2, 2, 4}, {0, 2, 3}}};
  const int32_t before = b.left_first ? 3 : 0;
  for (int body = 0; body < 2; ++body) {
    if (b.left_first) std::rotate(sides[body].begin(), sides[body].end() - 1, sides[body].end());
    add_sides(p.bodies[at(body)], sides[body]);
  }
  for (int body = 1; body <= 2; ++body)
    set_ends(p, body, [&](double, double y, double nx, double ny, End& end) {
      if (nx < -0.9) end = End{{1, 0, 0, 1}, {0, 0, 0, 0}};
      if (ny < -0.9 && y < 0.5) end = End{{0, 1, 1, 0}, {0, 0, 0, 0}};
      if (ny > 0.9 && y > 1.5) end = End{{0, 0, 1, 1}, {0, -b.pressure, 0, 0}};
    });
  if (b.free) {
    problem::FreeZone zone = problem::FreeZone();
    zone.first_element[0] = before + 8, zone.last_element[0] = before + 7 + b.lower;
    zone.first_element[1] = before + 1, zone.last_element[1] = before + b.upper;
    p.free_zones = {zone};
  } else {
    problem::Zone zone = problem::Zone();
    const int32_t f = b.function_nodes - 1;
    zone.elements = b.lower, zone.pairs = b.lower * f + 1;
    zone.first_element[0] = 8, zone.last_element[0] = 7 + b.lower;
    zone.first_node[0] = 7 * f + 1, zone.last_node[0] = (7 + b.lower) * f + 1;
    zone.first_element[1] = b.upper, zone.last_element[1] = 1;
    zone.first_node[1] = b.upper * f + 1, zone.last_node[1] = 1;
    p.zones = {zone};
  }
  return p;
}

// Largest deviation from uniform pressure and from its uniaxial state of stress, relative to it.
double patch_error(const Blocks& b, const Result& r) {
  double worst = 0;
  const Step& step = r.steps.back();
  for (int i = 0; i < step.pairs(); ++i) {
    worst = std::max(worst, std::fabs(step.at(i, C2D_TN) - b.pressure));
    worst = std::max(worst, std::fabs(step.at(i, C2D_TT)));
  }
  for (int body = 0; body < 2; ++body)
    for (const EndResult& end : r.boundary[body]) {
      const bool flat = std::fabs(end.y) < 1e-9 || std::fabs(end.y - 1) < 1e-9 || std::fabs(end.y - 2) < 1e-9;
      if (!flat)
        worst = std::max(worst, std::hypot(end.tx, end.ty));
      else
        worst = std::max(worst, std::min(std::fabs(std::fabs(end.ty) - b.pressure), std::fabs(end.ty)));
    }
  return worst / b.pressure;
}

} // namespace

TEST_CASE("free zones: the patch test passes with unequal meshes") {
  struct Case {
    int32_t lower, upper;
    double growth1, growth2;
  };
  for (const Case& c : {Case{7, 10, 1, 1}, Case{3, 11, 1, 1}, Case{11, 3, 1, 1}, Case{7, 10, 6, 4}, Case{9, 4, 0.2, 5},
                        Case{6, 6, 1, 1}, Case{1, 5, 1, 1}, Case{5, 1, 1, 1}})
    for (int32_t nodes : {2, 3, 4})
      for (int32_t functions : {2, 3, 4})
        for (double mu : {0.0, 0.3}) {
          if ((nodes == 4 || functions == 4) && c.lower != 7) continue;
          Blocks b;
          b.lower = c.lower, b.upper = c.upper, b.growth1 = c.growth1, b.growth2 = c.growth2, b.mu = mu;
          b.element_nodes = nodes, b.function_nodes = functions;
          const Result r = solve(pressed_blocks(b));
          INFO(c.lower, " ", c.upper, " ", c.growth1, " ", nodes, " ", functions, " ", mu, " ", r.messages());
          REQUIRE(r.status == C2D_OK);
          REQUIRE(r.outcome == C2D_REACHED);
          REQUIRE(r.steps.back().pairs() == c.upper * (functions - 1) + 1);
          CHECK(patch_error(b, r) < 1e-9);
          CHECK(r.summary.force_error < 1e-12);
        }
}

TEST_CASE("free zones: on matching meshes they are ordinary zones") {
  for (int32_t functions : {2, 3, 4})
    for (double mu : {0.0, 0.2}) {
      Blocks b;
      b.lower = b.upper = 8, b.growth1 = 3, b.growth2 = 1 / 3.0, b.mu = mu, b.function_nodes = functions;
      Problem free = pressed_blocks(b);
      b.free = false;
      Problem ordinary = pressed_blocks(b);
      for (Problem* p : {&free, &ordinary}) {
        p->bodies[0].youngs_modulus = 300; // with friction: not uniform
        set_ends(*p, 2, [&](double x, double y, double nx, double ny, End& end) {
          if (nx < -0.9) end = End{{1, 0, 0, 1}, {0, 0, 0, 0}};
          if (ny > 0.9 && y > 1.5) end = End{{0, 0, 1, 1}, {0, x < 1.1 ? -5.0 : 0.0, 0, 0}};
        });
      }
      const Result a = solve(ordinary), c = solve(free);
      INFO(functions, " ", mu, a.messages(), c.messages());
      REQUIRE(a.status == C2D_OK);
      REQUIRE(c.status == C2D_OK);
      const Difference d = compare(a, c);
      CHECK(d.worst() < 1e-9);
      CHECK(d.statuses == 0);
      CHECK(boundary_difference(a, c) < 1e-9);
    }
}

namespace {

// A cylinder of radius 8 on a block, with so many elements over -1 ... 1 on either; the cylinder ends above
// in a block.
Problem cylinder(int32_t lower, int32_t upper, double mu, int32_t functions, bool free) {
  Problem p;
  p.function_nodes = functions;
  p.friction = {mu};
  p.bodies.resize(2);
  add_sides(p.bodies[0], {{-4, -4, 6}, {4, -4, 6}, {4, 0, 6, 0.2}, {1, 0, lower}, {-1, 0, 6, 5}, {-4, 0, 6}});
  Body& body = p.bodies[1];
  body.youngs_modulus = 1500;
  const auto arc = [](double x) { return 8 - std::sqrt(64 - x * x); };
  std::vector<Side> sides;
  for (int32_t i = 0; i < upper; ++i) sides.push_back({-1 + 2.0 * i / upper, arc(-1 + 2.0 * i / upper), 1});
  sides.insert(sides.end(), {{1, arc(1), 8, 4}, {2, 3, 5}, {-2, 3, 8, 0.25}});
  body.element_nodes = functions == 3 ? 3 : 2; // quadratic functions feel every kink of a polygon
  add_sides(body, sides);
  for (size_t i = 0; i < 2 * at(upper) * at(body.element_nodes - 1); i += 2) body.xy[i + 1] = arc(body.xy[i]);
  for (int b = 1; b <= 2; ++b)
    set_ends(p, b, [&](double, double y, double, double ny, End& end) {
      if (ny < -0.9 && y < -3) end = End{{1, 1, 0, 0}, {0, 0, 0, 0}};
      if (ny > 0.9 && y > 2.9) end = End{{1, 1, 0, 0}, {0, 0, mu > 0 ? 0.002 : 0.0, -0.03}};
    });
  const int32_t f = functions - 1;
  if (free) {
    problem::FreeZone zone = problem::FreeZone();
    zone.first_element[0] = 19, zone.last_element[0] = 18 + lower;
    zone.first_element[1] = upper, zone.last_element[1] = 1;
    p.free_zones = {zone};
  } else {
    problem::Zone zone = problem::Zone();
    zone.elements = lower, zone.pairs = lower * f + 1;
    zone.first_element[0] = 19, zone.last_element[0] = 18 + lower;
    zone.first_node[0] = 18 * f + 1, zone.last_node[0] = (18 + lower) * f + 1;
    zone.first_element[1] = upper, zone.last_element[1] = 1;
    zone.first_node[1] = upper * f + 1, zone.last_node[1] = 1;
    p.zones = {zone};
  }
  return p;
}
double largest(const Result& r, int field) {
  double most = 0;
  const Step& step = r.steps.back();
  for (int i = 0; i < step.pairs(); ++i) most = std::max(most, std::fabs(step.at(i, field)));
  return most;
}
double half_width(const Result& r) { // the outermost pair that touches, by the pressure's slope to zero
  const Step& step = r.steps.back();
  double touching = 0;
  for (int i = 0; i < step.pairs(); ++i)
    if (step.at(i, C2D_TN) > 0) touching = std::max(touching, std::fabs(step.at(i, C2D_X)));
  return touching;
}
double imbalance(const Result& r) { // of the contact's forces on the two bodies
  const host::Summary& s = r.summary;
  return std::hypot(s.body[0].contact[0] + s.body[1].contact[0], s.body[0].contact[1] + s.body[1].contact[1]) /
         std::hypot(s.body[1].contact[0], s.body[1].contact[1]);
}

} // namespace

TEST_CASE("free zones: a cylinder on a block with other meshes is close to the matching one") {
  for (double mu : {0.0, 0.3})
    for (int32_t functions : {2, 3}) {
      const Result matching = solve(cylinder(48, 48, mu, functions, false));
      REQUIRE(matching.status == C2D_OK);
      REQUIRE(matching.outcome == C2D_REACHED);
      for (const auto& meshes : {std::pair<int32_t, int32_t>{48, 72}, {72, 48}, {48, 32}}) {
        const Result r = solve(cylinder(meshes.first, meshes.second, mu, functions, true));
        INFO(meshes.first, " ", meshes.second, " ", mu, " ", functions, " ", r.messages());
        REQUIRE(r.status == C2D_OK);
        REQUIRE(r.outcome == C2D_REACHED);
        CHECK(largest(r, C2D_TN) == doctest::Approx(largest(matching, C2D_TN)).epsilon(0.01));
        CHECK(half_width(r) == doctest::Approx(half_width(matching)).epsilon(2.0 / 32 / half_width(matching)));
        CHECK(imbalance(r) < 1e-12);
        CHECK(r.summary.force_error < 1e-12);
        CHECK(coulomb_breach(cylinder(meshes.first, meshes.second, mu, functions, true), r) == "");
      }
    }
}

TEST_CASE("free zones: the same in the least memory, panel by panel") {
  for (int32_t functions : {1, 2, 3}) {
    const Problem p = cylinder(9, 13, 0.3, functions, true);
    Setup least;
    least.memory = Memory::minimum;
    const Result a = solve(p), b = solve(p, least);
    INFO(functions, a.messages(), b.messages());
    REQUIRE(a.status == C2D_OK);
    REQUIRE(b.status == C2D_OK);
    CHECK(compare(a, b).worst() < 1e-9);
    CHECK(boundary_difference(a, b) < 1e-9);
    CHECK(imbalance(a) < 1e-12);
  }
}

TEST_CASE("free zones: ordinary zones beside them") {
  const auto feet = [](bool free) {
    Problem p;
    p.friction = {0.2};
    p.bodies.resize(2);
    add_sides(p.bodies[0], {{0, 0, 6}, {3, 0, 3}, {3, 1, 4}, {2, 1, 3}, {1, 1, 5}, {0, 1, 3}});
    add_sides(p.bodies[1], {{0, 1, 5}, {1, 1, 1}, {1, 1.4, 2}, {2, 1.4, 1}, {2, 1, 4}, {3, 1, 3}, {3, 2, 6}, {0, 2, 3}});
    for (int body = 1; body <= 2; ++body)
      set_ends(p, body, [&](double x, double y, double, double ny, End& end) {
        if (ny < -0.9 && y < 0.5) end = End{{1, 1, 0, 0}, {0, 0, 0, 0}};
        if (ny > 0.9 && y > 1.5) end = End{{0, 0, 1, 1}, {0.1, x < 1.4 ? -2.0 : -3.0, 0, 0}};
      });
    problem::Zone zone = problem::Zone();
    zone.elements = 5, zone.pairs = 6;
    zone.first_element[0] = 17, zone.last_element[0] = 21, zone.first_node[0] = 17, zone.last_node[0] = 22;
    zone.first_element[1] = 5, zone.last_element[1] = 1, zone.first_node[1] = 6, zone.last_node[1] = 1;
    problem::Zone other = zone;
    other.elements = 4, other.pairs = 5;
    other.first_element[0] = 10, other.last_element[0] = 13, other.first_node[0] = 10, other.last_node[0] = 14;
    other.first_element[1] = 13, other.last_element[1] = 10, other.first_node[1] = 14, other.last_node[1] = 10;
    p.zones = {zone};
    if (!free) {
      p.zones.push_back(other);
    } else {
      problem::FreeZone z = problem::FreeZone();
      z.first_element[0] = 10, z.last_element[0] = 13, z.first_element[1] = 10, z.last_element[1] = 13;
      p.free_zones = {z};
    }
    return p;
  };
  const Result a = solve(feet(false)), b = solve(feet(true));
  INFO(a.messages(), b.messages());
  REQUIRE(a.status == C2D_OK);
  REQUIRE(b.status == C2D_OK);
  CHECK(compare(a, b).worst() < 1e-9);
  CHECK(boundary_difference(a, b) < 1e-9);
}

TEST_CASE("free zones: what reaches beyond body 1 is left out, a body 1 that floats is carried") {
  Blocks b;
  b.lower = 5, b.upper = 12;
  Problem p = pressed_blocks(b);
  p.free_zones[0].first_element[0] = 9; // body 1 from x = 1.6 down
  const Result r = solve(p);
  INFO(r.messages());
  REQUIRE(r.status == C2D_OK);
  CHECK(r.steps.back().pairs() == 10); // nine of the twelve elements lie below 1.6
  CHECK(r.warned(C2D_WARN_LEFT_OUT));  // and the tenth in part
  CHECK(r.messages().find("element 10 of body 2") != std::string::npos);
  b.upper = 10; // a node at 1.6
  p = pressed_blocks(b);
  p.free_zones[0].first_element[0] = 9;
  const Result even = solve(p);
  REQUIRE(even.status == C2D_OK);
  CHECK(even.steps.back().pairs() == 9);
  CHECK(!even.warned(C2D_WARN_LEFT_OUT));
  CHECK(imbalance(r) < 1e-12);
  b.lower = 7, b.upper = 10;
  Problem floating = pressed_blocks(b);
  const auto carried = [&](double, double y, double nx, double ny, End& end) {
    if (nx < -0.9) end = End{{1, 0, 0, 1}, {0, 0, 0, 0}};
    if (ny < -0.9 && y < 0.5) end = End{{0, 0, 1, 1}, {0, b.pressure, 0, 0}};
    if (ny > 0.9 && y > 1.5) end = End{{0, 1, 1, 0}, {0, 0, 0, 0}};
  };
  for (int body = 1; body <= 2; ++body) set_ends(floating, body, carried);
  const Result f = solve(floating);
  INFO(f.messages());
  REQUIRE(f.status == C2D_OK);
  REQUIRE(f.outcome == C2D_REACHED);
  CHECK(patch_error(b, f) < 1e-9);
}

TEST_CASE("free zones: stress inside") {
  Blocks b;
  b.lower = 6, b.upper = 7;
  Setup setup;
  setup.points = {0.7, 0.5, 1.1, 0.99, 1.3, 1.02, 1.9, 0.1};
  const Result r = solve(pressed_blocks(b), setup);
  REQUIRE(r.status == C2D_OK);
  for (size_t i = 0; i < 4; ++i) {
    const double* row = &r.interior[i * C2D_POINT_FIELDS];
    CHECK(row[C2D_POINT_SYY] == doctest::Approx(-b.pressure).epsilon(1e-8));
    CHECK(std::fabs(row[C2D_POINT_SXX]) < 1e-7);
    CHECK(std::fabs(row[C2D_POINT_SXY]) < 1e-7);
  }
}

TEST_CASE("free zones: symmetry by images, patch test on the line x = 0") {
  for (int32_t functions : {2, 3})
    for (double mu : {0.0, 0.3}) {
      Blocks b;
      b.lower = 5, b.upper = 8, b.growth1 = 3, b.function_nodes = functions, b.mu = mu;
      Problem p = pressed_blocks(b);
      for (Body& body : p.bodies) { // without the left side, whose three elements come last
        body.open_regions = 1;
        body.regions[0].last -= 3;
        body.xy.resize(body.xy.size() - 4); // the curve ends where that side began
        body.ends.resize(body.ends.size() - 3 * at(functions));
      }
      p.symmetry = 1;
      const Result r = solve(p);
      INFO(functions, " ", mu, " ", r.messages());
      REQUIRE(r.status == C2D_OK);
      REQUIRE(r.outcome == C2D_REACHED);
      CHECK(patch_error(b, r) < 1e-9);
    }
}

// The left side stays in the deck, and images take its place: of the nodes inside it nothing is left, whether they are the last
// of the body's or others follow.
TEST_CASE("free zones: symmetry by images of bodies with elements on the line") {
  for (int32_t functions : {2, 3})
    for (bool left_first : {false, true}) {
      Blocks b;
      b.lower = 5, b.upper = 8, b.function_nodes = functions, b.left_first = left_first;
      const Problem p = pressed_blocks(b);
      Setup images;
      images.symmetry = C2D_SYMMETRY_IMAGES;
      const Result r = solve(p, images);
      INFO(functions, " ", left_first, " ", r.messages());
      REQUIRE(r.status == C2D_OK);
      REQUIRE(r.outcome == C2D_REACHED);
      for (int i = 0; i < r.steps.back().pairs(); ++i)
        CHECK(r.steps.back().at(i, C2D_TN) == doctest::Approx(b.pressure).epsilon(1e-9));
    }
}

TEST_CASE("free zones: a ring pressed onto a ring, all round, against Lame") {
  // Outer ring 1 < r < 2 under pressure 5, inner ring 0.5 < r < 1 held inside, nu = 0.3: with sigma_r = A -
  // B/r^2 and u = k (0.4 A r + B/r) on either, u is the same at r = 1 for this pressure.
  const double pressure = (1.4 * 5 / 0.75) / (1.4 / 0.75 - 0.4 + 0.3 / 1.1);
  const auto circle = [](double r, double from, double sense) {
    return [=](double s, double& x, double& y) {
      const double angle = from + sense * 2 * 3.14159265358979323846 * s;
      x = r * std::cos(angle), y = r * std::sin(angle);
    };
  };
  struct Case {
    int32_t element_nodes, function_nodes;
    double tolerance;
  };
  for (const Case& c : {Case{2, 2, 0.01}, Case{3, 1, 0.025}, Case{3, 2, 0.01}, Case{3, 3, 0.002}, Case{4, 4, 2e-5}})
    for (const auto& meshes : {std::pair<int32_t, int32_t>{30, 43}, {43, 30}}) {
      Problem p;
      p.function_nodes = c.function_nodes;
      p.friction = {0.5};
      p.bodies.resize(2);
      for (Body& body : p.bodies) body.element_nodes = c.element_nodes;
      add_curve(p.bodies[0], 40, circle(2, 0, 1));
      add_curve(p.bodies[0], meshes.first, circle(1, 0.3, -1));
      add_curve(p.bodies[1], meshes.second, circle(1, 0, 1));
      add_curve(p.bodies[1], 24, circle(0.5, 0, -1));
      set_ends(p, 1, [](double x, double y, double nx, double ny, End& end) {
        if (x * x + y * y > 2.5) end = End{{0, 0, 1, 1}, {-nx * 5, -ny * 5, 0, 0}};
      });
      set_ends(p, 2, [](double x, double y, double, double, End& end) {
        if (x * x + y * y < 0.5) end = End{{1, 1, 0, 0}, {0, 0, 0, 0}};
      });
      problem::FreeZone zone = problem::FreeZone();
      zone.first_element[0] = 41, zone.last_element[0] = 40 + meshes.first;
      zone.first_element[1] = 1, zone.last_element[1] = meshes.second;
      p.free_zones = {zone};
      const Result r = solve(p);
      INFO(c.element_nodes, " ", c.function_nodes, " ", meshes.first, " ", r.messages());
      REQUIRE(r.status == C2D_OK);
      REQUIRE(r.outcome == C2D_REACHED);
      const Step& step = r.steps.back();
      REQUIRE(step.pairs() == meshes.second * std::max(c.function_nodes - 1, 1));
      for (int i = 0; i < step.pairs(); ++i) CHECK(step.at(i, C2D_TN) == doctest::Approx(pressure).epsilon(c.tolerance));
      for (int k = 0; k < 2; ++k) // resultants vanish: against the size of what is summed, 2 pi p
        CHECK(std::fabs(r.summary.body[0].contact[k] + r.summary.body[1].contact[k]) < 1e-12 * 6.3 * pressure);
    }
}

TEST_CASE("free zones: an element on the border of two zones is told") {
  Blocks b;
  b.lower = 7, b.upper = 5; // elements 0.4 long; body 1 has nodes at 6/7 and 8/7
  Problem p = pressed_blocks(b);
  p.free_zones.push_back(p.free_zones[0]);
  p.free_zones[0].last_element[0] = 11, p.free_zones[0].first_element[1] = 3;
  p.free_zones[1].first_element[0] = 12, p.free_zones[1].last_element[1] = 2;
  const Result r = solve(p);
  INFO(r.messages());
  REQUIRE(r.status == C2D_OK);
  CHECK(r.steps.back().pairs() == 6);
  CHECK(r.warned(C2D_WARN_LEFT_OUT));
  CHECK(r.messages().find("element 3 of body 2") != std::string::npos);
}

namespace {

// A ring 2 < r < 3 (E = 1000) on a ring 1 < r < 2 + overlap (E = 2000), plane stress, nu = 0.3: the quarter between
// two lines of symmetry, or all of it.
std::string press_fit(bool quarter, int32_t nodes, int32_t functions, const int32_t (&meshes)[2], double overlap) {
  std::ostringstream deck;
  deck.precision(12);
  deck << "*FREE\n1\nPRESS FIT\n1 1\n2 0 " << functions << "\n";
  for (int32_t n : meshes) deck << "2 " << nodes << " " << 2 * n << " " << 2 * n * (nodes - 1) + (quarter ? 2 : 0) << "\n";
  for (int32_t n : meshes) deck << "1 " << n << "\n" << n + 1 << " " << 2 * n << "\n";
  deck << "1000 .3\n2000 .3\n1 " << (quarter ? 0 : 0.3) << "\n";
  for (int body = 0; body < 2; ++body) {
    const int32_t points = meshes[body] * (nodes - 1) + (quarter ? 1 : 0);
    const double outer = body == 0 ? 3 : 2 + overlap, last = quarter ? 90 : 360 - 360.0 / points;
    deck << "0 0\nP 1 " << outer << " 0\nP " << points << " " << outer << " " << last << "\nP " << points + 1 << " " << 2 - body
         << " " << (quarter ? 90 : 0) << "\nP " << 2 * points << " " << 2 - body << " " << (quarter ? 0 : -last) << "\n";
  }
  if (quarter) {
    deck << "0\n";
  } else { // held against the rigid motions of the inner and, by friction, the outer ring
    const int32_t n = meshes[0];
    deck << "4\n1 1 1100 0 0 0 0\n"
         << n / 2 << " 2 0110 0 0 0 0\n"
         << n / 2 + 1 << " 1 0110 0 0 0 0\n"
         << n << " 2 1100 0 0 0 0\n";
  }
  deck << "0\n0\n0\n0 0\n0 0\n1 50\n1 1\n";
  if (quarter) deck << "*SYMMETRY X 0\n*SYMMETRY Y 0\n";
  deck << "*ZONE " << meshes[0] + 1 << " " << 2 * meshes[0] << " ";
  if (quarter)
    deck << "1 " << meshes[1] << "\n";
  else
    deck << meshes[1] << " 1 " << meshes[0] << " " << meshes[1] << "\n";
  if (overlap > 0) deck << "*INTERFERENCE 1\n";
  return deck.str();
}
// Lame: overlap = 2 p [(13 / 5 + nu) / 1000 + (5 / 3 - nu) / 2000].
double press_fit_pressure(double overlap) { return overlap / (2 * (2.9 / 1000 + (5.0 / 3 - 0.3) / 2000)); }
void check_pressures(const Result& r, double pressure, double tolerance) {
  const Step& step = r.steps.back();
  for (int i = 0; i < step.pairs(); ++i) CHECK(std::fabs(step.at(i, C2D_TN) - pressure) <= tolerance * pressure);
}
double mean_pressure(const Result& r) {
  double sum = 0;
  for (int i = 0; i < r.steps.back().pairs(); ++i) sum += r.steps.back().at(i, C2D_TN);
  return sum / r.steps.back().pairs();
}

} // namespace

TEST_CASE("free zones: a curved one that ends on lines of symmetry is whole") {
  // Straight elements: see the next test; 7e-6 at these angles, every third pair. Quadratic ones: the overlap itself
  // against the radius.
  for (const auto& meshes : {std::pair<int32_t, int32_t>{12, 12}, {12, 9}})
    for (int32_t nodes : {2, 3})
      for (double overlap : {1e-3, 0.0, -0.01}) { // overlap, none, clearance
        const int32_t functions = nodes;
        const Result r = solve_text(press_fit(true, nodes, functions, {meshes.first, meshes.second}, overlap));
        INFO(meshes.second, " ", nodes, " ", overlap, " ", r.messages());
        REQUIRE(r.status == C2D_OK);
        REQUIRE(r.steps.back().pairs() == meshes.second * (functions - 1) + 1);
        CHECK(!r.warned(C2D_WARN_LEFT_OUT));
        check_pressures(r, press_fit_pressure(std::max(overlap, 0.0)), nodes == 3 ? 2e-3 : 0.07);
      }
}

TEST_CASE("free zones: overlaps of straight elements are closed") {
  // Polygons of 24 and 20 sides: their circles' overlap is known to round-off, 2 % are those of a wall of 1 between polygons,
  // 6 % those of single pairs.
  for (double overlap : {1e-3, 1e-2}) {
    const Result r = solve_text(press_fit(false, 2, 2, {24, 20}, overlap));
    const double pressure = press_fit_pressure(overlap);
    INFO(overlap, " ", pressure, " ", r.messages());
    REQUIRE(r.status == C2D_OK);
    REQUIRE(r.steps.back().pairs() == 20);
    CHECK(std::fabs(mean_pressure(r) / pressure - 1) < 0.02);
    check_pressures(r, pressure, 0.06);
    CHECK(!r.warned(C2D_WARN_OVERLAP)); // the circles are certain
  }
}

TEST_CASE("free zones: constant functions, a pair where two elements of body 1 meet") {
  // Its displacement has two values there; no last digit chooses one.
  Blocks b;
  b.lower = 4, b.upper = 5, b.function_nodes = 1;
  Problem p = pressed_blocks(b);
  double factor = 1;
  for (End& end : p.bodies[1].ends) end.values[1] *= end.values[1] != 0 ? factor += 0.2 : 1; // no state of its own mirror
  const Result plain = solve(p);
  for (double length = 1.1; length < 3; length *= 1.1) {
    Mapping units;
    units.length = 1 / length;
    const Difference d = compare(plain, solve(scaled(p, length, 1)), units);
    CHECK(d.traction < 1e-9);
    CHECK(d.displacement1 < 1e-9);
  }
}

TEST_CASE("free zones: a node right above the middle of an element faces it, whatever the last digits of the units") {
  // A round body over a hollow of seven elements: touching, not a gap of a thousandth, which leaves body 2 free.
  const Result r = solve_text(test::read_file(paths::root() + "/tests/data/hard/F1_facing_in_other_units.dat"));
  REQUIRE(r.status == C2D_OK);
  CHECK(r.outcome == C2D_REACHED);
}

TEST_CASE("free zones: elements of very different length, and surfaces that wobble, are told") {
  Blocks b;
  b.lower = 3, b.upper = 20;
  const Result coarse = solve(pressed_blocks(b)), fine = solve(pressed_blocks(Blocks{}));
  REQUIRE(coarse.status == C2D_OK);
  CHECK(coarse.warned(C2D_WARN_SIZES));
  CHECK(coarse.messages().find("zone 1: elements that face each other differ in length more than fourfold at 21 pairs") !=
        std::string::npos);
  CHECK(coarse.messages().find("0.666667 and 0.1") != std::string::npos);
  REQUIRE(fine.status == C2D_OK);
  CHECK(!fine.warned(C2D_WARN_SIZES));
  CHECK(!fine.warned(C2D_WARN_SURFACE));
  CHECK(!fine.warned(C2D_WARN_FAR));
  Problem p = pressed_blocks(Blocks{});
  std::vector<double>& xy = p.bodies[0].xy; // the lower block's upper side, up and down by up to 4e-4
  const double wobble[3] = {0, -4e-4, -1e-4};
  for (size_t i = 0; i < xy.size(); i += 2)
    if (xy[i + 1] > 0.999 && xy[i] > 0.01 && xy[i] < 1.99) xy[i + 1] += wobble[(i / 2) % 3];
  const Result rough = solve(p);
  INFO(rough.messages());
  REQUIRE(rough.status == C2D_OK);
  CHECK(rough.warned(C2D_WARN_SURFACE));
  CHECK(rough.messages().find("between boundary points the surfaces are uncertain by") != std::string::npos);
}

TEST_CASE("free zones: bad input") {
  const auto fault = [](const test::Callable<void(Problem&)>& spoil) {
    Problem p = pressed_blocks(Blocks{});
    spoil(p);
    const Result r = solve(p);
    CHECK(r.status != C2D_OK);
    return r.messages();
  };
  const auto says = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
  const std::string top = fault([](Problem& p) { // the upper block's upper side
    p.free_zones[0].first_element[1] = 14, p.free_zones[0].last_element[1] = 17;
  });
  CHECK_MESSAGE(says(top, "does not face"), top);
  const std::string beside = fault([](Problem& p) { // its right side
    p.free_zones[0].first_element[1] = 11, p.free_zones[0].last_element[1] = 13;
  });
  CHECK_MESSAGE(says(beside, "no element of body 2 faces body 1"), beside);
  const std::string away = fault([](Problem& p) {
    for (size_t i = 0; i < p.bodies[1].xy.size(); i += 2) p.bodies[1].xy[i] += 5;
  });
  CHECK_MESSAGE(says(away, "expected ranges of elements that face each other"), away);
  const std::string twice = fault([](Problem& p) {
    p.free_zones.push_back(p.free_zones[0]);
    p.free_zones[0].last_element[0] = 12, p.free_zones[1].first_element[0] = 11;
  });
  CHECK_MESSAGE(says(twice, "is in zones 1 and 2"), twice);
  const std::string range = fault([](Problem& p) { p.free_zones[0].last_element[1] = 1000; });
  CHECK_MESSAGE(says(range, "contact element of body 2 is 1000"), range);
  const std::string overlap = fault([](Problem& p) {
    for (size_t i = 1; i < p.bodies[1].xy.size(); i += 2) p.bodies[1].xy[i] -= 0.1;
  });
  CHECK_MESSAGE(says(overlap, "overlap by 0.1"), overlap);
}

namespace {

// The lines of a deck, its zones' cards given by hand.
std::string hertz_deck(const std::string& zone) {
  std::istringstream in(deck_text("hertz_lin_l.dat"));
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  lines[5] = "    2    0    2"; // no ordinary zone
  const size_t first = lines.size() - 7;
  REQUIRE(lines[first] == "    1    2   10    9");
  lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(first), lines.begin() + static_cast<std::ptrdiff_t>(first) + 3);
  lines[first] = lines[first + 1] = "    0    0";
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text + zone + "\n";
}

} // namespace

TEST_CASE("free zones: *ZONE in a deck") {
  const Result ordinary = solve_text(deck_text("hertz_lin_l.dat"));
  REQUIRE(ordinary.status == C2D_OK);
  for (const char* card : {"*ZONE 26 34 43 35", "*zone 34 26 35 43", "*ZONE 26,34,43,35,9,9"}) {
    const Result r = solve_text(hertz_deck(card));
    INFO(card, " ", r.messages());
    REQUIRE(r.status == C2D_OK);
    CHECK(r.steps.back().pairs() == ordinary.steps.back().pairs());
    CHECK(largest(r, C2D_TN) == doctest::Approx(largest(ordinary, C2D_TN)).epsilon(0.01));
    CHECK(imbalance(r) < 1e-12);
    CHECK(r.steps.back().at(0, C2D_PAIR_NODE1) == 0);
  }
  const auto refused = [](const char* card, const char* part) {
    std::string said;
    try { // what the deck alone shows is thrown
      const Result r = solve_text(hertz_deck(card));
      CHECK(r.status == C2D_ERR_INPUT);
      said = r.messages();
    } catch (const std::runtime_error& error) {
      said = error.what();
    }
    CHECK_MESSAGE(said.find(part) != std::string::npos, said);
  };
  refused("*ZONE 26 34 43", "element of body 2");
  refused("*ZONE 26 340 43 35", "element of body 1");
  refused("*ZONE 26 34 43 35 9 9 1", "7 fields, expected 6");
  refused("*ZONE 26 34 43 35 9 8", "does not contain the number of elements");
  refused("*ZONE 1 8 43 35", "face");
  // A deck in which there is no contact to be had: one body, or stresses alone.
  for (const char* name : {"plate", "block"}) {
    runs::Deck deck = runs::deck_named(name);
    if (std::string(name) == "block") { // without its zone: three cards, and two with sums, in front of two load cards
      deck.lines[2][9] = deck.lines[3][9] = '0';
      deck.lines.erase(deck.lines.end() - 7, deck.lines.end() - 4);
      deck.lines[deck.lines.size() - 4] = deck.lines[deck.lines.size() - 3] = "    0    0";
    }
    deck.lines.push_back("*ZONE 1 1 1 1");
    c2d_body_limits bodies[2] = {};
    c2d_limits limits = C2D_INIT(c2d_limits);
    limits.bodies = 2, limits.body = bodies;
    std::string told;
    const c2d_report hear = [](void* to, const c2d_error* e) { *static_cast<std::string*>(to) += std::string(e->text) + "\n"; };
    CHECK(c2d_check_deck(runs::Deck::read, &deck, &limits, hear, &told) == C2D_ERR_INPUT);
    const char* const what = "a contact zone or platen in a stress analysis (IOUT 0), expected IOUT 1";
    CHECK_MESSAGE(told.find(what) != std::string::npos, told);
  }
}
