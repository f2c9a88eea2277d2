// Contact zones whose sides are meshed independently: the patch test, where uniform pressure must pass whatever the
// meshes; the ordinary zone where the meshes happen to match; a cylinder on a block against matching meshes.
#include "problem.hpp"

#include <doctest/doctest.h>

#include <cmath>

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

// Two blocks of width 2 and height 1 on top of each other, on rollers at the left and below, pressed by `pressure`.
struct Blocks {
  int32_t lower = 7, upper = 10;
  double growth1 = 1, growth2 = 1, pressure = 3, mu = 0;
  int32_t element_nodes = 2, function_nodes = 2;
  bool free = true;
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
  add_sides(p.bodies[0], {{0, 0, 4}, {2, 0, 3}, {2, 1, b.lower, b.growth1}, {0, 1, 3}});
  add_sides(p.bodies[1], {{0, 1, b.upper, b.growth2}, {2, 1, 3}, {2, 2, 4}, {0, 2, 3}});
  for (int body = 1; body <= 2; ++body)
    set_ends(p, body, [&](double, double y, double nx, double ny, End& end) {
      if (nx < -0.9) end = End{{1, 0, 0, 1}, {0, 0, 0, 0}};
      if (ny < -0.9 && y < 0.5) end = End{{0, 1, 1, 0}, {0, 0, 0, 0}};
      if (ny > 0.9 && y > 1.5) end = End{{0, 0, 1, 1}, {0, -b.pressure, 0, 0}};
    });
  if (b.free) {
    c2d_free_zone zone = C2D_INIT(c2d_free_zone);
    zone.first_element[0] = 8, zone.last_element[0] = 7 + b.lower;
    zone.first_element[1] = 1, zone.last_element[1] = b.upper;
    p.free_zones = {zone};
  } else {
    c2d_zone zone = C2D_INIT(c2d_zone);
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
      if (!flat) worst = std::max(worst, std::hypot(end.tx, end.ty));
      else worst = std::max(worst, std::min(std::fabs(std::fabs(end.ty) - b.pressure), std::fabs(end.ty)));
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
