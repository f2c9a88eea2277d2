#include "model_fixture.hpp"

#include <doctest/doctest.h>

#include <cfenv>
#include <limits>

using namespace fixture;
using c2d::UnknownKind;

namespace {

// A square of 4 elements held at its lower side: nothing to complain of.
ModelData square(int function_nodes = 2, const Points& outer = unit_square(), int element_nodes = 2) {
  ModelData d(function_nodes);
  d.body(element_nodes, {outer});
  for (int l = 1; l <= function_nodes; ++l) d.condition(1, 1, l, "1100");
  return d;
}

void check_fault(ModelData& d, const char* part, int32_t node = 0, int32_t element = 0, int32_t line = 0) {
  CHECK_FALSE(d.complete());
  const c2d_error* entry = d.find(part);
  INFO(d.all());
  REQUIRE(entry != nullptr);
  CHECK(entry->status == C2D_ERR_INPUT);
  CHECK(entry->severity == C2D_FAULT);
  if (node > 0) CHECK(entry->node == node);
  if (element > 0) CHECK(entry->element == element);
  if (line > 0) CHECK(entry->line == line);
}

Points reversed(const Points& p) {
  Points q;
  for (size_t i = p.size() / 2; i-- > 0;) q.push_back(p[2 * i]), q.push_back(p[2 * i + 1]);
  return q;
}

// A circle through `points` points as curved elements.
Points circle(double r, int points, double x = 0, double y = 0) {
  Points p;
  arc_to(p, x, y, r, 0, 360, points);
  return p;
}

struct TrappingFloat { // invalid, zero-divide and overflow stop the program while this lives
  int before;
  TrappingFloat() { before = feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW); }
  ~TrappingFloat() {
    std::feclearexcept(FE_ALL_EXCEPT);
    fedisableexcept(FE_ALL_EXCEPT);
    feenableexcept(before);
  }
};

} // namespace

TEST_CASE("topology: regions close on themselves, for every function order") {
  // Outer curve of 6 quadratic elements (12 points), hole of 3 (6 points).
  for (int f = 1; f <= 4; ++f) {
    CAPTURE(f);
    ModelData d(f);
    d.body(3, {circle(2, 12), reversed(circle(1, 6))});
    const c2d::Model m = d.view();
    CHECK(c2d::region_of_element(m, 0, 5) == 0);
    CHECK(c2d::region_of_element(m, 0, 6) == 1);
    CHECK(c2d::geometry_node(m, 0, 0, 2) == 2);
    CHECK(c2d::geometry_node(m, 0, 5, 2) == 0);
    CHECK(c2d::geometry_node(m, 0, 6, 0) == 12);
    CHECK(c2d::geometry_node(m, 0, 8, 2) == 12);
    const int steps = f == 1 ? 1 : f - 1;
    if (f > 1) {
      CHECK(c2d::functional_node(m, 0, 5, f - 1) == 0);
      CHECK(c2d::functional_node(m, 0, 8, f - 1) == 6 * steps);
      CHECK(c2d::functional_node(m, 0, 2, f - 1) == c2d::functional_node(m, 0, 3, 0));
    }
    // Every end is found at its node, and nowhere else.
    int32_t found = 0;
    for (int32_t node = 0; node < d.bodies[0].nodes; ++node) {
      int32_t ends[2];
      const int count = c2d::ends_at_node(m, 0, node, ends);
      for (int i = 0; i < count; ++i) CHECK(c2d::functional_node(m, 0, ends[i] / f, ends[i] % f) == node);
      found += count;
    }
    CHECK(found == 9 * f);
  }
}

TEST_CASE("topology: the preceding element's end comes first, also across the seam of a region") {
  ModelData d(2);
  d.body(2, {rectangle(0, 0, 4, 4, 2, 2), reversed(unit_square(1, 1))});
  int32_t ends[2];
  REQUIRE(c2d::ends_at_node(d.view(), 0, 0, ends) == 2);
  CHECK(ends[0] == 7 * 2 + 1);
  CHECK(ends[1] == 0);
  REQUIRE(c2d::ends_at_node(d.view(), 0, 8, ends) == 2);
  CHECK(ends[0] == 11 * 2 + 1);
  CHECK(ends[1] == 8 * 2);
}

TEST_CASE("topology: functional nodes lie on the curve of another order") {
  // A parabola y = x^2 through three points is met exactly by a quadratic element with x = eta.
  ModelData d(4);
  d.body(3, {{-1, 1, 0, 0, 1, 1, 0, 5}});
  for (int l = 0; l < 4; ++l) {
    double x, y;
    c2d::node_position(d.view(), 0, l, &x, &y);
    CHECK(x == doctest::Approx(-1 + 2.0 * l / 3).epsilon(1e-15));
    CHECK(y == doctest::Approx(x * x).epsilon(1e-14));
  }
  ModelData constant(1);
  constant.body(2, {unit_square()});
  double x, y;
  c2d::node_position(constant.view(), 0, 1, &x, &y);
  CHECK(x == 1);
  CHECK(y == 0.5);
}

TEST_CASE("geometry: normals, lengths, areas") {
  ModelData d(3);
  d.body(4, {circle(2, 72)}); // 24 cubic elements
  const c2d::Model m = d.view();
  // A cubic through four points of a 15 degree arc of radius 2: errors of the order r (h/3)^4 / 4 = 2e-5 in
  // position.
  CHECK(c2d::region_area(m, 0, 0) == doctest::Approx(std::acos(-1.0) * 4).epsilon(1e-5));
  CHECK(c2d::winding_number(m, 0, 0, 0.3, 0.4) == 1);
  CHECK(c2d::winding_number(m, 0, 0, 2.3, 0.4) == 0);
  for (int l = 0; l < 3; ++l) {
    double n[2];
    const c2d::CurvePoint p = c2d::curve_point(m, 0, 5, l - 1);
    c2d::outward_normal(m, 0, 5, l - 1, n);
    CHECK(n[0] == doctest::Approx(p.x / 2).epsilon(1e-3));
    CHECK(n[1] == doctest::Approx(p.y / 2).epsilon(1e-3));
  }
  // Sixteen chords of a fifteen degree arc fall short by (1/16)^2 (pi/12)^2 / 24 = 1.1e-5.
  CHECK(c2d::element_length(m, 0, 5) == doctest::Approx(2 * std::acos(-1.0) / 12).epsilon(2e-5));
}

TEST_CASE("double node: twins, and the ends that count") {
  ModelData d(2);
  d.body(2, {{0, 0, 1, 0, 1, 0, 1, 1, 0, 1}}); // element 2 has zero length
  d.condition(1, 1, 1, "1100");
  d.condition(1, 1, 2, "1100");
  REQUIRE(d.complete());
  const c2d::Model m = d.view();
  CHECK(c2d::is_zero_length(m, 0, 1));
  CHECK(c2d::twin_node(m, 0, 1) == 2);
  CHECK(c2d::twin_node(m, 0, 2) == 1);
  CHECK(c2d::twin_node(m, 0, 0) == -1);
  CHECK_FALSE(c2d::is_second_twin(m, 0, 1));
  CHECK(c2d::is_second_twin(m, 0, 2));
  int32_t ends[2];
  REQUIRE(c2d::ends_at_node(m, 0, 1, ends) == 1);
  CHECK(ends[0] == 1);
  REQUIRE(c2d::ends_at_node(m, 0, 2, ends) == 1);
  CHECK(ends[0] == 4);
  CHECK(c2d::unknown_at(m, 0, 1, 0).kind == UnknownKind::traction);
  CHECK(c2d::unknown_at(m, 0, 2, 0).kind == UnknownKind::displacement);

  d.condition(1, 3, 1, "1110"); // ux at the second twin too
  check_fault(d, "both nodes 2 and 3", 2);
}

TEST_CASE("unknowns of Hertz's deck: corners, symmetry, contact") {
  ModelData d = hertz();
  REQUIRE(d.complete());
  const c2d::Model m = d.view();
  auto kind = [&](int body, int node, int c) { return c2d::unknown_at(m, body - 1, node - 1, c).kind; };
  auto end = [&](int body, int node, int c) { return c2d::unknown_at(m, body - 1, node - 1, c).end[0]; };
  // Corner (0, -4): both displacements known; tx is unknown on the symmetry line (end 2 of 46), ty below (end
  // 1 of 1).
  CHECK(kind(1, 1, 0) == UnknownKind::traction);
  CHECK(end(1, 1, 0) == 45 * 2 + 1);
  CHECK(kind(1, 1, 1) == UnknownKind::traction);
  CHECK(end(1, 1, 1) == 0);
  // Lower side: tx known, ux unknown; ty shared by both ends, uy known.
  CHECK(kind(1, 2, 0) == UnknownKind::displacement);
  REQUIRE(kind(1, 2, 1) == UnknownKind::shared_traction);
  CHECK(c2d::unknown_at(m, 0, 1, 1).end[0] == 1);
  CHECK(c2d::unknown_at(m, 0, 1, 1).end[1] == 2);
  // Axis nodes of the contact: x fixed with one unknown tx on the symmetry line, y contact.
  CHECK(kind(1, 38, 0) == UnknownKind::traction);
  CHECK(end(1, 38, 0) == 37 * 2);
  CHECK(kind(1, 38, 1) == UnknownKind::contact);
  CHECK(kind(2, 35, 0) == UnknownKind::traction);
  CHECK(end(2, 35, 0) == 33 * 2 + 1);
  CHECK(kind(2, 35, 1) == UnknownKind::contact);
  // Inside the zone both components, at its end too; beside it none.
  for (int c = 0; c < 2; ++c) {
    CHECK(kind(1, 24, c) == UnknownKind::contact);
    CHECK(kind(2, 36, c) == UnknownKind::contact);
    CHECK(kind(1, 23, c) == UnknownKind::displacement);
  }
  // Ends: element 23 keeps its own condition at node 24, which is a pair's.
  CHECK(c2d::pair_of_node(m, 0, 23).pair == 0);
  CHECK(c2d::pair_of_end(m, 0, 22, 1).pair == -1);
  CHECK(c2d::pair_of_end(m, 0, 23, 0).pair == 0);
  CHECK(c2d::pair_of_end(m, 0, 23, 1).pair == 1);
  CHECK(c2d::pair_of_end(m, 1, 47, 1).pair == 0);
  CHECK(c2d::pair_of_end(m, 1, 34, 0).pair == 14);
  CHECK(c2d::pair_of_end(m, 1, 33, 1).pair == -1);
  // Every unknown column has a row: 2 N unknowns, of which 2 * 15 - 1 are those of the contact.
  int contact = 0;
  for (int32_t node = 0; node < d.bodies[1].nodes; ++node) {
    for (int c = 0; c < 2; ++c) contact += c2d::unknown_at(m, 1, node, c).kind == UnknownKind::contact;
  }
  CHECK(contact == 29);
  CHECK(d.head.contact == 29);
}

TEST_CASE("conditions: none or several unknowns are faults that name the node and its ends") {
  ModelData d = square();
  d.condition(1, 3, 1, "0000", 0, 0, 17); // upper right corner: displacement and traction in both directions
  check_fault(d, "node 3 of body 1 has no unknown in x", 3, 3, 17);
  CHECK(d.find("no unknown in y") != nullptr);
  CHECK(d.find("at end 1 of element 3 prescribed") != nullptr);
  CHECK(d.find("at end 2 of element 2 zero (no card)") != nullptr);
  CHECK(d.faults == 2);

  ModelData several = square();
  several.condition(1, 3, 1, "1011");
  check_fault(several, "more than one unknown in x", 3);
  CHECK(several.faults == 1);
}

TEST_CASE("conditions: a shared traction at a corner warns, on a straight side it does not") {
  ModelData d(2);
  d.body(2, {rectangle(0, 0, 2, 2, 2, 2)});
  for (int e = 1; e <= 3; ++e) { // lower side and the first element of the right one
    d.condition(1, e, 1, "1100");
    d.condition(1, e, 2, "1100");
  }
  REQUIRE(d.complete());
  CHECK(d.count(C2D_WARN_CORNER) == 1); // node 3, both components; nodes 2 is straight
  CHECK(d.find("the sharpest of 2 such corners") != nullptr);
  REQUIRE(d.find("corner of 90 degrees") != nullptr);
  CHECK(d.find("corner of 90 degrees")->node == 3);
  CHECK(d.find("corner of 90 degrees")->severity == C2D_WARNING);
}

TEST_CASE("data: everything missing or impossible is told at once") {
  ModelData d = square();
  d.node_line[0][1] = d.node_line[0][2] = -1;
  d.bodies[0].youngs_modulus = 0;
  d.bodies[0].poisson_ratio = 0.6;
  check_fault(d, "boundary point 2 to 3 have no coordinates", 2);
  CHECK(d.find("Young's modulus of body 1 is 0") != nullptr);
  CHECK(d.find("Poisson's ratio of body 1 is 0.6") != nullptr);
  CHECK(d.faults == 3);
}

TEST_CASE("data: legal Poisson's ratios depend on the plane problem") {
  for (double nu : {-0.99, -0.51, -0.49, 0.0, 0.5, 0.51, -1.0}) {
    CAPTURE(nu);
    ModelData d = square();
    d.bodies[0].poisson_ratio = nu;
    CHECK(d.complete() == (nu > -1 && nu <= 0.5));
    d.head.plane = C2D_PLANE_STRESS;
    CHECK(d.complete() == (nu > -0.5 && nu <= 0.5));
  }
  ModelData d = square();
  d.head.plane = C2D_PLANE_STRESS;
  d.bodies[0].poisson_ratio = 0.25;
  CHECK(c2d::strain_poisson_ratio(d.view(), 0) == doctest::Approx(0.2).epsilon(1e-15));
  CHECK(c2d::shear_modulus(d.view(), 0) == doctest::Approx(400).epsilon(1e-15));
}

TEST_CASE("data: moduli that are none, with traps on; numbers at the edges of what is legal") {
  const TrappingFloat trapping;
  for (double number : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e200}) {
    ModelData d = square();
    d.bodies[0].youngs_modulus = number;
    check_fault(d, "Young's modulus");
    CHECK(d.faults == 1);
  }
  ModelData d = hertz();
  CHECK(d.complete());
  for (double scale : {1e-90, 1e90}) {
    ModelData scaled = hertz();
    for (auto& xy : scaled.xy) {
      for (double& x : xy) x *= scale;
    }
    CHECK(scaled.complete());
    CHECK(scaled.head.contact == 29);
  }
  ModelData point = square(2, {0, 0, 0, 0, 0, 0, 0, 0}); // all in one point
  CHECK_FALSE(point.complete());
}

TEST_CASE("zones: bodies, nodes and elements that are not there, and a zone of one body that does not say so") {
  struct Case {
    const char* told;
    void (*change)(c2d::Zone&);
  };
  const Case cases[] = {
      {": there is no body 8, expected 1 to 2", [](c2d::Zone& z) { z.body[1] = 7; }},
      {": there is no body 0, expected 1 to 2", [](c2d::Zone& z) { z.body[0] = -1; }},
      {": both sides are on body 1, expected two different bodies", [](c2d::Zone& z) { z.body[1] = 0, z.region[1] = 0; }},
      {"first node 0 is not in the region of its elements", [](c2d::Zone& z) { z.first_node[0] = -1; }},
      {"first node 1001 is not in the region of its elements", [](c2d::Zone& z) { z.first_node[1] = 1000; }},
  };
  for (const Case& c : cases) {
    ModelData d = hertz();
    REQUIRE(d.complete());
    c.change(d.zones[0]);
    CAPTURE(c.told);
    CHECK_FALSE(d.complete());
    CHECK_MESSAGE(d.find(c.told) != nullptr, d.all());
  }
}

TEST_CASE("zones: two that name the same elements, or the same nodes") {
  ModelData d = hertz();
  REQUIRE(d.complete());
  d.zones.push_back(d.zones[0]);
  d.pairs.resize(2 * d.pairs.size());
  CHECK_FALSE(d.complete());
  CHECK_MESSAGE(d.find("is in zones 1 and 2, the first of ") != nullptr, d.all());
}

TEST_CASE("data: a ratio that is none, and a curve that has too few elements") {
  ModelData d = square();
  d.bodies[0].poisson_ratio = std::numeric_limits<double>::quiet_NaN();
  check_fault(d, "Poisson's ratio of body 1");
  ModelData two = square();
  two.regions[0][0].last = 1;
  CHECK_FALSE(two.complete());
  CHECK_MESSAGE(two.find("region 1 of body 1 has elements: 2, expected for a closed curve at least 3") != nullptr, two.all());
}

TEST_CASE("geometry: of many crossings the first ten are told") {
  std::vector<double> comb = {0, 0, 20, 0, 20, 1}; // teeth that all go through the lower side
  for (int i = 0; i < 8; ++i) {
    comb.push_back(18.5 - 2 * i), comb.push_back(-1);
    comb.push_back(17.5 - 2 * i), comb.push_back(1);
  }
  comb.push_back(0), comb.push_back(1);
  ModelData d = square(2, comb);
  CHECK_FALSE(d.complete());
  CHECK(d.count(C2D_ERR_INPUT) == 10);
  CHECK(std::string(d.told.back().text).find("(further ones are not listed)") != std::string::npos);
}

TEST_CASE("data: friction and a path may come later, a body may not") {
  ModelData none = hertz(); // a host that steps itself gives neither
  none.friction.clear();
  none.paths.clear();
  CHECK(none.complete());
  none = square();
  none.bodies[0].is_set = 0;
  check_fault(none, "body 1 is missing");
}

TEST_CASE("geometry: points that coincide") {
  ModelData d = square(2, {0, 0, 2, 0, 2, 2, 1, 2, 1, 1, 1, 2, 0, 2}); // points 4 and 6
  check_fault(d, "boundary points 4 and 6 of body 1 coincide", 6);
  ModelData curved = square(2, {0, 0, 0.5, 0, 1, 0, 1, 0, 1, 1, 0, 1}, 3); // points 3 and 4
  check_fault(curved, "boundary points 3 and 4 of body 1 coincide", 4);
  ModelData constant = square(1, {0, 0, 1, 0, 1, 0, 1, 1, 0, 1});
  check_fault(constant, "a double node needs linear functions", 0, 2);
  ModelData row = square(2, {0, 0, 1, 0, 1, 0, 1, 0, 1, 1, 0, 1});
  check_fault(row, "two elements of zero length follow one another", 0, 2);
}

TEST_CASE("geometry: a small body beside a large one is measured by its own size, and by its last digits") {
  struct Small {
    double side, x;
  };
  for (const Small& small : {Small{1e-6, 0.25}, Small{1e-9, 0.25}, Small{1e-6, 1000}}) {
    CAPTURE(small.side);
    CAPTURE(small.x);
    ModelData d(2);
    d.body(2, {fixture::rectangle(-5, -10, 10, 10, 4, 4)});
    Points p = fixture::rectangle(small.x, 1, small.side, small.side, 40, 40);
    for (int c = 0; c < 2; ++c)
      p.insert(p.begin() + 4 + c, p[static_cast<size_t>(2 + c)]); // the second point twice: a double node
    p[4] += 1e-16 * small.x;                                      // (its last digit)
    d.body(2, {p});
    CHECK_MESSAGE(d.complete(), d.all());
    for (int32_t e = 0; e < d.bodies[1].elements; ++e) CHECK(is_zero_length(d.view(), 1, e) == (e == 1));
    ModelData touches = d; // two points of the large body
    touches.xy[0] = Points{-5, -10, 5, -10, 5, 0, 1, 0, 1, -1, 1, 1e-12, -5, 0};
    touches.bodies[0].elements = touches.bodies[0].geometry_nodes = 7;
    touches.regions[0] = {{0, 6}};
    CHECK_FALSE(touches.complete());
    CHECK(touches.find("boundary points 4 and 6 of body 1 coincide") != nullptr);
  }
}

TEST_CASE("geometry: distorted curved elements") {
  // Inner point far from the middle of a straight side: x = eta + (1 - eta^2) 0.9, turns back at eta = 5/9.
  ModelData fold = square(2, {-1, -1, 0.9, -1, 1, -1, 1, 0, 1, 1, 0, 1, -1, 1, -1, 0}, 3);
  check_fault(fold, "element 1 is distorted", 0, 1);
  // A quarter point: the Jacobian vanishes at the end of the element, x = (1 + eta)^2 / 2 - 1.
  ModelData quarter = square(2, {-1, -1, -0.5, -1, 1, -1, 1, 0, 1, 1, 0, 1, -1, 1, -1, 0}, 3);
  check_fault(quarter, "its Jacobian vanishes near eta = -1", 0, 1);
  ModelData sound = square(2, {-1, -1, -0.4, -1, 1, -1, 1, 0, 1, 1, 0, 1, -1, 1, -1, 0}, 3);
  CHECK(sound.complete());
}

TEST_CASE("geometry: crossings and spikes") {
  ModelData eight = square(2, {0, 0, 2, 0, 2, 2, 1, -1, 0, 2}); // elements 3 and 4 dip through element 1
  check_fault(eight, "elements 1 and 3 of body 1 cross or touch each other", 0, 3);
  CHECK(eight.find("elements 1 and 4") != nullptr);
  CHECK(eight.faults == 2);
  ModelData touch = square(2, {0, 0, 2, 0, 2, 2, 1, 0, 0, 2}); // point 4 lies on element 1
  check_fault(touch, "elements 1 and 3");
  ModelData spike = square(2, {0, 0, 1, 0, 2, 0, 1.5, 0, 1.5, 2, 0, 2});
  check_fault(spike, "reverses its direction from element 2 to element 3", 3, 3);
  ModelData hole(2);
  hole.body(2, {unit_square(0, 0, 4), reversed(unit_square(3, 3, 2))});
  hole.condition(1, 1, 1, "1100");
  check_fault(hole, "cross or touch");
  // Curved: a bulge of element 1 through the opposite side, whose points all stay clear.
  ModelData bulge = square(2, {-1, 0, 0, 1.5, 1, 0, 1, 0.5, 1, 1, 0, 1, -1, 1, -1, 0.5}, 3);
  check_fault(bulge, "elements 1 and 3");
}

TEST_CASE("geometry: straight sides with inner nodes, turned, moved and scaled, do not cross themselves") {
  const double pi = std::acos(-1.0);
  for (int nodes = 3; nodes <= 4; ++nodes)
    for (int i = 0; i < 400; ++i) {
      const double angle = 2 * pi * i / 400 + 1e-3 * i, size = std::pow(10.0, i % 13 - 6);
      const double away = i % 3 == 0 ? 0 : (i % 3 == 1 ? 7.3 : -1e4) * size, c = std::cos(angle), s = std::sin(angle);
      const double corner[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
      Points p;
      for (int side = 0; side < 4; ++side)
        for (int k = 0; k + 1 < nodes; ++k) {
          const double part = static_cast<double>(k) / (nodes - 1);
          const double x = corner[side][0] + part * (corner[side + 1][0] - corner[side][0]),
                       y = corner[side][1] + part * (corner[side + 1][1] - corner[side][1]);
          p.push_back(away + size * (c * x - s * y));
          p.push_back(-0.4 * away + size * (s * x + c * y));
        }
      ModelData turned = square(nodes == 3 ? 2 : 3, p, nodes);
      CAPTURE(nodes);
      CAPTURE(i);
      CHECK(turned.complete());
      // What does cross is found as surely: the side opposite the first one passes through it.
      for (size_t k = 0; k + 1 < static_cast<size_t>(nodes); ++k)
        for (size_t j = 0; j < 2; ++j) { // points of the third side, (1 - part, 1), moved to (1 - part, -0.1 + 0.05 part)
          const double part = static_cast<double>(k) / (nodes - 1), x = 1 - part, y = k == 0 ? 1 : -0.1 * part;
          if (k == 0) continue;
          p[2 * (2 * static_cast<size_t>(nodes - 1) + k) + j] =
              j == 0 ? away + size * (c * x - s * y) : -0.4 * away + size * (s * x + c * y);
        }
      ModelData dipped = square(nodes == 3 ? 2 : 3, p, nodes);
      CHECK_FALSE(dipped.complete());
    }
}

TEST_CASE("geometry: orientation and nesting of regions") {
  ModelData d = square(2, reversed(unit_square()));
  check_fault(d, "is the outer boundary and runs clockwise", 0, 1);
  auto with_holes = [](const std::vector<Points>& curves) {
    ModelData model(2);
    model.body(2, curves);
    model.condition(1, 1, 1, "1100");
    model.condition(1, 1, 2, "1100");
    return model;
  };
  const Points outer = unit_square(0, 0, 9);
  ModelData good = with_holes({outer, reversed(unit_square(1, 1)), reversed(unit_square(3, 3, 4))});
  CHECK(good.complete());
  ModelData turned = with_holes({outer, unit_square(1, 1)});
  check_fault(turned, "region 2 of body 1 is a hole and runs counter-clockwise", 0, 5);
  ModelData outside = with_holes({outer, reversed(unit_square(20, 1))});
  check_fault(outside, "lies outside the outer boundary", 0, 5);
  ModelData nested = with_holes({outer, reversed(unit_square(3, 3, 4)), reversed(unit_square(4, 4))});
  check_fault(nested, "region 3 of body 1 lies inside region 2", 0, 9);
  ModelData later(2); // the outer boundary need not be the first region
  later.body(2, {reversed(unit_square(1, 1)), outer});
  later.condition(1, 5, 1, "1100");
  later.condition(1, 5, 2, "1100");
  CHECK(later.complete());
}

TEST_CASE("point loads: on the boundary, outside, near, well inside") {
  ModelData d(2);
  d.body(2, {rectangle(0, 0, 8, 8, 8, 8), reversed(unit_square(4, 4))});
  d.condition(1, 1, 1, "1100");
  d.condition(1, 1, 2, "1100");
  d.point_load(1, 2.5, 2.5, 1, 1);
  REQUIRE(d.complete());
  CHECK(d.told.empty());
  d.point_load(1, 2.5, 0.5, 3, -4, 21);
  REQUIRE(d.complete());
  REQUIRE(d.count(C2D_WARN_POINT_LOAD) == 1);
  CHECK(d.told[0].element == 3);
  CHECK(d.told[0].line == 21);
  d.point_load(1, 8, 2.5, 3, -4); // on element 11 of length 1
  d.point_load(1, 0, 0, 1, 0);    // on a node
  d.point_load(1, 9, 2.5, 1, 0);
  d.point_load(1, 4.5, 4.5, 1, 0); // in the hole
  check_fault(d, "the equivalent uniform traction on element 11 is (3, -4)", 0, 11);
  CHECK(d.find("point load 4 at (0, 0) lies on the boundary") != nullptr);
  CHECK(d.find("point load 5 at (9, 2.5) lies outside body 1") != nullptr);
  CHECK(d.find("point load 6 at (4.5, 4.5) lies outside body 1") != nullptr);
  CHECK(d.faults == 4);
}

TEST_CASE("free rigid motions are found and named") {
  auto names = [](ModelData& d) {
    REQUIRE(d.complete());
    std::vector<std::string> out;
    for (int i = 0; i < d.bodies[0].free_motions; ++i) {
      char bytes[80];
      c2d::Text text = c2d::text_in(bytes);
      c2d::put_motion(text, d.view(), 0, d.bodies[0].free_motion[i]);
      out.push_back(bytes);
    }
    return out;
  };
  using Names = std::vector<std::string>;
  ModelData d(2);
  d.body(2, {unit_square(0, 0, 4)});
  CHECK(names(d) == Names{"along x", "along y", "rotation about (2, 2)"});
  d.condition(1, 1, 1, "1100"); // one node fixed
  d.condition(1, 4, 2, "0000"); // its other end names it too: only one unknown may remain
  CHECK(names(d) == Names{"rotation about (0, 0)"});
  d.condition(1, 2, 1, "1001"); // and ux at another on the same horizontal: nothing new
  CHECK(names(d) == Names{"rotation about (0, 0)"});
  d.condition(1, 1, 2, "0110"); // uy there: held
  CHECK(names(d).empty());

  ModelData roller(2);
  roller.body(2, {unit_square(0, 0, 4)});
  roller.condition(1, 1, 1, "0110");
  roller.condition(1, 1, 2, "0110");
  CHECK(names(roller) == Names{"along x"});
  const double* motion = roller.bodies[0].free_motion[0];
  CHECK(std::abs(motion[0]) == doctest::Approx(1).epsilon(1e-15));
}

TEST_CASE("free rigid motions do not depend on the unit of length") {
  for (double scale : {1e-6, 1.0, 1e6}) {
    ModelData d(2);
    d.body(2, {unit_square(0, 0, 4 * scale)});
    d.condition(1, 1, 1, "0110");
    d.condition(1, 3, 1, "0110");
    REQUIRE(d.complete());
    CHECK(d.bodies[0].free_motions == 1);
    CHECK(d.head.length_unit >= 4 * scale);
    CHECK(d.head.length_unit <= 8 * scale);
  }
}
