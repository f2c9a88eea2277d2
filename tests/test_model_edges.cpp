// Models at the edges of what is possible: where curves end on lines of symmetry, zones at the ends of open regions, a body
// that meets itself at a node, and what each is told.
#include "model_fixture.hpp"
#include "solved_bodies.hpp"

#include <cmath>

using namespace many;

namespace {

// A block below, held from below, and another one upon it, pressed from above; with a line of symmetry x = 0 or not.
Model blocks(int32_t kind, const Body& lower, const Body& upper) {
  Model m;
  m.friction = 0.3;
  m.add(lower);
  m.add(upper);
  m.set(1, 1, end_of(kHeld));
  m.set(2, 3, end_of(kPulled, 0, -1));
  m.join(kind, 1, 3, 2, 1);
  return m;
}
Model pair_of_blocks(int32_t kind, int32_t elements) {
  return blocks(kind, rectangle(0, -1, 2, 0, {1, 1, elements, 1}), rectangle(0, 0, 2, 1, {elements, 1, 1, 1}));
}
Model half_blocks(const Body& upper) {
  Model m = blocks(C2D_ZONE_MATCHING, open_polygon({{0, -1, 1}, {2, -1, 1}, {2, 0, 2}, {0, 0, 0}}), upper);
  m.symmetry = 1;
  return m;
}
Body half_upper() { return open_polygon({{0, 0, 2}, {2, 0, 1}, {2, 1, 1}, {0, 1, 0}}); }

} // namespace

TEST_CASE("model edges: a pair stands on a line of symmetry with both nodes or with none") {
  const Result r = solve(half_blocks(rectangle(0.25, 0, 2.25, 1, {2, 1, 1, 1})));
  CHECK(r.status == C2D_ERR_INPUT);
  CHECK_MESSAGE(r.told_of("one of the nodes lies on a symmetry line"), r.messages());
}

TEST_CASE("model edges: an incompressible body that only symmetry lets go of has no definite pressure") {
  Model m;
  m.symmetry = 1;
  m.add(open_polygon({{0, -1, 2}, {2, 0, 2}, {0, 1, 0}}, 1000, 0.5));
  for (End& end : m.body(1).ends) end = end_of(kHeld);
  m.body(1).ends.front() = m.body(1).ends.back() = end_of("0110"); // ux is free, but for the line
  const Result r = solve(m);
  CHECK(r.status == C2D_ERR_INPUT);
  CHECK(r.told_of("nothing determines its pressure"));
  m.body(1).ends[3] = m.body(1).ends[4] = end_of(kPulled, 1);
  CHECK(solve(m).status == C2D_OK);
}

// Traction and displacement unknown at an end: of a node that makes no pair that is one unknown too many; side 1 of a free zone
// has no pairs of its own, and the card means the contact.
TEST_CASE("model edges: an end in a zone that asks for both is left to the contact of free zones alone") {
  for (const int32_t kind : kKinds) {
    CAPTURE(kind);
    Model m = pair_of_blocks(kind, 2);
    if (kind == C2D_ZONE_MATCHING) m.zones[0].without[1] = 1;
    m.body(1).ends[3 * 2 + 1] = end_of("1111");
    const Result r = solve(m);
    CHECK((r.status == C2D_OK) == (kind == C2D_ZONE_FREE));
    CHECK(r.told_of("node 5 of body 1 has more than one unknown in x") == (kind == C2D_ZONE_MATCHING));
  }
}

TEST_CASE("model edges: the sides of a notch share no node and no element") {
  Model m;
  m.add(polygon({{0, 0, 1}, {4, 0, 1}, {4, 3, 1}, {2.5, 3, 2}, {2, 1, 2}, {1.5, 3, 1}, {0, 3, 1}}));
  m.set(1, 1, end_of(kHeld));
  m.zones.push_back({C2D_ZONE_MATCHING + C2D_ZONE_SELF, {{1, 4, 5}, {1, 6, 7}}});
  CHECK(solve(m).told_of("node 6 of body 1 is in pairs 3 and 1 of zone 1, expected in one"));
  m.zones[0].side[1] = {1, 5, 6};
  CHECK(solve(m).told_of("element 5 of body 1 is in zones 1 and 1, expected in one"));
}

TEST_CASE("model edges: an open curve meets itself, its line and its last corner as any other does") {
  const auto told = [](const Body& body, int32_t held) {
    Model m;
    m.symmetry = 1;
    m.add(body);
    m.set(1, held, end_of(kHeld));
    m.set(1, held + 1, end_of(kHeld));
    return solve(m);
  };
  Result r = told(open_polygon({{0, -1, 1}, {2, -1, 1}, {1, 0, 1}, {2, 0.5, 1}, {1, 0, 1}, {0, 1, 0}}), 1);
  CHECK(r.told_of("boundary points 3 and 5 of body 1 coincide at (1, 0), expected different points"));
  r = told(open_polygon({{0, -1, 2}, {2, -1, 2}, {2, 1, 1}, {0.3, 1, 1}, {0, 0.9, 0}}), 3);
  CHECK(r.status == C2D_OK);
  CHECK(r.told_of("node 6 of body 1 is a corner of 18.4349 degrees whose displacement in x is prescribed"));
  Body curved;
  curved.element_nodes = 3, curved.open_regions = 1, curved.regions = {{1, 3}}, curved.sides = {{1, 1}, {2, 2}, {3, 3}};
  curved.xy = {0, -1, 0.5, -1, 1, -1, 0, 0, 1, 1, 0.5, 1, 0, 1};
  curved.ends.resize(6);
  r = told(curved, 1);
  CHECK(r.told_of("boundary point 4 of body 1 at (0, 0) touches a line of symmetry"));
}

TEST_CASE("model edges: nothing leaves a line of symmetry, no rigid body and no force") {
  CHECK(solve(half_blocks(half_upper())).status == C2D_OK);
  Model m = half_blocks(half_upper());
  m.body(2).rigid = 1;
  m.body(2).motion[0] = 0.1;
  m.set(2, 3, end_of(kPulled));
  CHECK(solve(m).told_of("the motion of the rigid body 2 in load case 1 leaves the line of symmetry"));
  m = half_blocks(half_upper());
  m.point_loads = {{2, 0, 0.5, 1, 0}};
  const Result r = solve(m);
  CHECK(r.told_of("point load 1 at (0, 0.5) on a symmetry line acts across it"));
  std::vector<int32_t> order;
  std::string deck = deck_of(m, "ACROSS", order); // there it has a card
  const Result told = solve_deck(deck);
  REQUIRE(told.told_of("acts across it"));
  for (const c2d_error& e : told.told)
    if (std::string(e.text).find("acts across it") != std::string::npos) {
      CHECK(e.line > 10);
      CHECK(e.column == 3); // of x
    }
}

// A plate in tension sigma along x, of which a quarter is modelled: u_x = (1 - nu^2) sigma x / E. Its outer corner is a double
// node.
TEST_CASE("model edges: a quarter of a plate with a double node at its corner is exact") {
  Model m;
  m.symmetry = 3;
  m.add(open_polygon({{2, 0, 2}, {2, 1, 1}, {2, 1, 2}, {0, 1, 0}}, 1000, 0.3));
  m.set(1, 1, end_of(kPulled, 5));
  const Result r = solved(m);
  for (const EndResult& end : r.boundary.at(0)) {
    CHECK(end.ux == doctest::Approx(0.91 * 5 * end.x / 1000).epsilon(1e-9));
    CHECK(end.uy == doctest::Approx(-0.39 * 5 * end.y / 1000).epsilon(1e-9));
  }
}

// ---- zones and frames ------------------------------------------------------------------------------------------------

namespace {

using fixture::ModelData;
using fixture::Points;

// Two bodies, the first of which ends openly, of four elements; a zone of so many pairs and elements from there on.
ModelData open_zone(int32_t pairs, int32_t elements, int32_t element, int32_t step, int32_t node) {
  ModelData d(2);
  d.body(2, {{4, -1, 4, 0, 2, 0, 0, 0, 0, -1}});
  c2d::Body& body = d.bodies[0];
  body.elements -= 1, d.regions[0][0].last -= 1, d.regions[0][0].open = 1, body.open_regions = 1;
  d.body(2, {fixture::rectangle(0, 0, 4, 1, 4, 1)});
  d.zone(pairs, elements, element, step, node, step > 0 ? 4 : 1, -step, step > 0 ? 5 : 1, 30);
  return d;
}

} // namespace

TEST_CASE("model edges: a zone ends where its open region does, with its elements and its nodes") {
  const auto told = [](ModelData d, const char* words) {
    CHECK_FALSE(d.complete());
    CAPTURE(d.all());
    CHECK(d.find(words) != nullptr);
  };
  const char* const beyond = "elements or nodes go beyond the end of their open region";
  told(open_zone(3, 3, 3, 1, 3), beyond);
  told(open_zone(3, 3, 2, -1, 5), beyond);
  told(open_zone(3, 2, 3, 1, 4), beyond);
  told(open_zone(3, 2, 2, -1, 2), beyond);
  told(open_zone(2, 2, 3, 1, 1), "node 1 is not a node of the zone's elements");
  told(open_zone(2, 2, 1, 1, 4), "node 4 is not a node of the zone's elements");
}

// Slim triangles with one tip: each edge of one faces an edge of the other, the tips point the same way. And a cusp, at whose
// tip both sides have opposite normals to 1e-8, in the place of one of them.
TEST_CASE("model edges: tips that point the same way do not face each other, and one without a normal faces nothing") {
  const double t = 0.45, k = 0.3, e = 1e-8;
  const Points slim = {0, 0, 1, -t, 1, t};
  const Points cusp = {0, 0, 0.5, -(k / 4 + e / 2), 1, -(k + e), 1, 0, 1, k + e, 0.5, k / 4 + e / 2};
  for (int which = 0; which < 3; ++which) {
    CAPTURE(which);
    ModelData d(2);
    d.body(which == 1 ? 3 : 2, {which == 1 ? cusp : slim});
    d.body(which == 2 ? 3 : 2, {which == 2 ? cusp : slim});
    d.zone(3, 2, 3, 1, 3, 1, -1, 2, 30);
    CHECK_FALSE(d.complete());
    const c2d_error* fault = d.find(which == 0 ? "the surfaces do not face each other" : "no normal on one of the bodies");
    REQUIRE_MESSAGE(fault != nullptr, d.all());
    CHECK(fault->pair == 2);
  }
}

TEST_CASE("model edges: curves given by calls have no line, and share no element") {
  ModelData d(2);
  d.body(2, {fixture::rectangle(0, 0, 2, 1, 4, 1)});
  for (int32_t first : {0, 1}) d.surfaces.push_back({C2D_CURVE_SPLINE, 0, first, first + 1, 0, 0, {0, 0}, 0});
  CHECK_FALSE(d.complete());
  const c2d_error* fault = d.find("element 2 of body 1 is in curves 1 and 2, expected in one");
  REQUIRE_MESSAGE(fault != nullptr, d.all());
  CHECK(fault->line == 0);
}

// A wavy surface of chords: between its points, where the nodes of the other body are, nobody knows it to a tenth of the waves.
TEST_CASE("model edges: overlaps that chords explain count as touching, unless overlaps are what loads") {
  for (const int32_t interference : {0, 1}) {
    CAPTURE(interference);
    std::vector<Corner> lower = {{-2, -2, 1}, {2, -2, 1}}, upper = {{1.5, 2, 1}, {-1.5, 2, 1}};
    for (int i = 0; i <= 8; ++i) lower.push_back({2 - 0.5 * i, i % 2 == 0 ? 0.01 : -0.01, 1});
    for (int i = 0; i <= 4; ++i) upper.push_back({-1.25 + 0.5 * i + (i == 4 ? 0.5 : 0), -1e-3, 1});
    Model m;
    m.friction = 0.3;
    m.interference = interference;
    m.add(polygon(lower));
    m.add(polygon(upper));
    m.set(1, 1, end_of(kHeld));
    m.zones.push_back({C2D_ZONE_FREE, {{1, 3, 10}, {2, 3, 6}}});
    if (interference == 0) m.set(2, 1, end_of(kPulled, 0, -1));
    const Result r = solve(m);
    CAPTURE(r.messages());
    CHECK(r.told_of("overlaps smaller than what the elements leave open of the surfaces"));
    CHECK(r.told_of("they count as touching") == (interference == 0));
  }
}

TEST_CASE("model edges: a kink of the side whose nodes make the pairs of a free zone is told with its node and pair") {
  for (int side = 0; side < 2; ++side) {
    CAPTURE(side);
    const double h[2] = {side == 0 ? -0.2 : 0.0, side == 1 ? 0.2 : 0.0};
    Model m;
    m.friction = 0.3;
    m.add(polygon({{-1, -2, 1}, {1, -2, 1}, {1, h[0], 2}, {0, 0, 2}, {-1, h[0], 1}}));
    m.add(polygon({{1, 2, 1}, {-1, 2, 1}, {-1, h[1], 2}, {0, 0, 2}, {1, h[1], 1}}));
    m.set(1, 1, end_of(kHeld));
    m.set(2, 1, end_of(kPulled, 0, -1));
    m.zones.push_back({C2D_ZONE_FREE, {{1, 3, 6}, {2, 3, 6}}});
    const Result r = solve(m);
    int kinks = 0;
    for (const c2d_error& e : r.told) {
      if (e.status != C2D_WARN_KINK) continue;
      ++kinks;
      CHECK(e.body == side + 1);
      CHECK((e.pair > 0) == (side == 1));
      CHECK((e.node > 0) == (side == 1));
    }
    CHECK_MESSAGE(kinks == 1, r.messages());
  }
}
