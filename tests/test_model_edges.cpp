// Models at the edges of what is possible: where curves end on lines of symmetry, zones at the ends of open regions, a body
// that meets itself at a node, and what each is told.
#include "model_fixture.hpp"
#include "solved_bodies.hpp"

#include <algorithm>
#include <cmath>

using namespace many;
using namespace solved_bodies;

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
  CHECK(solve(m).told_of("node 6 of body 1 is in pairs 3 and 1 of zone 1, expected in one pair only"));
  m.zones[0].side[1] = {1, 5, 6};
  CHECK(solve(m).told_of("element 5 of body 1 is on both sides of zone 1, expected on one"));
  m.zones[0].side[1] = {1, 4, 5};
  CHECK(solve(m).told_of("element 4 of body 1 is on both sides of zone 1, the first of 2 elements on both, expected on one"));
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
  const c2d_error* fault = d.find("element 2 of body 1 is in curves 1 and 2, expected it in one curve only");
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

TEST_CASE("model edges: a free zone that ends where lines of symmetry cross ends on a boundary point that cannot be there") {
  Model m;
  m.symmetry = 3;
  m.add(open_polygon({{2, 0, 2}, {2, 2, 2}, {0, 0, 0}}));
  m.add(open_polygon({{0, 0, 3}, {2, 2, 2}, {0, 2, 0}}));
  m.join(C2D_ZONE_FREE, 1, 2, 2, 1);
  const Result r = solve(m);
  CHECK(r.status == C2D_ERR_INPUT);
  CHECK_MESSAGE(r.told_of("boundary point 5 of body 1 at (0, 0) lies at the crossing of the lines of symmetry"), r.messages());
}

// A hole that goes all round a block, told from the middle of where they touch. Its other elements begin and end beside the
// block.
TEST_CASE("model edges: a free zone that begins in the middle of what is faced is one of two runs") {
  Model m;
  m.add(rectangle(0, -3, 1, 0, {2, 2, 4, 2}));
  m.add(rectangle(-4, -8, 5, 3, {4, 4, 4, 4}));
  add_polygon(m.body(2), {{-2, -5, 1}, {-2, 0, 20}, {3, 0, 1}, {3, -5, 1}});
  m.body(2).ends.resize(static_cast<size_t>(2 * m.body(2).elements()));
  m.set(1, 1, end_of(kHeld));
  for (const int32_t from : {37, 27}) { // 26 ... 29 are faced, the zone goes down
    m.zones = {{C2D_ZONE_FREE, {{1, 5, 8}, {2, from, from + 1, 23}}}};
    const Result r = solve(m);
    const char* several =
        "the elements of body 2 that face body 1 form several ranges, expected one range of consecutive elements";
    CHECK_MESSAGE(r.told_of(several) == (from == 27), r.messages());
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

// ---- exact states ----------------------------------------------------------------------------------------------------
// Under an even stress the displacements are linear, which straight elements hold exactly, whatever the shape.

namespace {

constexpr double kSxx = 5, kSyy = -2, kE = 1000, kNu = 0.3;
double even_ux(double x) { return ((1 - kNu * kNu) * kSxx - kNu * (1 + kNu) * kSyy) * x / kE; }
double even_uy(double y) { return ((1 - kNu * kNu) * kSyy - kNu * (1 + kNu) * kSxx) * y / kE; }

// Its tractions on all elements of body 1, but displacements on side `held`, if there is one.
void load_evenly(Model& m, int32_t held) {
  Body& b = m.body(1);
  for (size_t side = 1; side <= b.sides.size(); ++side) {
    double x[2], y[2];
    m.place(1, b.sides[side - 1].first, 1, x[0], y[0]);
    m.place(1, b.sides[side - 1].first, 2, x[1], y[1]);
    const double size = std::hypot(x[1] - x[0], y[1] - y[0]), nx = (y[1] - y[0]) / size, ny = (x[0] - x[1]) / size;
    m.set(1, static_cast<int32_t>(side), [&](double at_x, double at_y) {
      return static_cast<int32_t>(side) == held ? end_of(kHeld, 0, 0, even_ux(at_x), even_uy(at_y))
                                                : end_of(kPulled, kSxx * nx, kSyy * ny);
    });
  }
}
double worst_of(const Result& r) {
  double worst = 0;
  for (const EndResult& end : r.boundary.at(0))
    worst = std::max({worst, std::fabs(end.ux - even_ux(end.x)), std::fabs(end.uy - even_uy(end.y))});
  return worst;
}
// One more open region through these points, straight from one to the next.
void add_open(Body& body, const std::vector<Corner>& corners) {
  const int32_t first = body.elements() + 1;
  int32_t last = first - 1;
  for (size_t i = 0; i < corners.size(); ++i) {
    body.xy.insert(body.xy.end(), {corners[i].x, corners[i].y});
    if (i > 0) ++last, body.sides.push_back({last, last});
  }
  body.regions.push_back({first, last});
  ++body.open_regions;
}

} // namespace

TEST_CASE("model edges: holes whose centroid is near their edge, or outside them, leave an even stress even") {
  for (double thick : {0.25, 0.35, 0.45, 0.5, 0.55, 0.6, 0.7, 0.9}) { // of the limbs of a chevron
    CAPTURE(thick);
    Model m;
    m.add(rectangle(-3, -2, 3, 4, {6, 6, 6, 6}));
    add_polygon(m.body(1), {{-1.5, 0, 3}, {-1.5, thick, 3}, {0, 1 + thick, 3}, {1.5, thick, 3}, {1.5, 0, 3}, {0, 1, 3}});
    Model with;
    with.add(m.body(1));
    load_evenly(with, 1);
    CHECK(worst_of(solved(with)) < 1e-9);
  }
}

TEST_CASE("model edges: bites on two lines of symmetry, at their crossing and beside it, of one element and of more") {
  for (int which = 0; which < 3; ++which) {
    CAPTURE(which);
    Model m;
    m.symmetry = 3;
    if (which == 0) { // across both lines
      Body b = open_polygon({{3, 0, 3}, {3, 4, 3}, {0, 4, 0}}, kE, kNu);
      add_open(b, {{0, 0.7, 1}, {0.7, 0, 1}});
      m.add(b);
    } else if (which == 1) { // in one of them
      Body b = open_polygon({{3, 0, 3}, {3, 4, 3}, {0, 4, 0}}, kE, kNu);
      add_open(b, {{0, 2.5, 1}, {0.4, 2.2, 1}, {0.4, 1.8, 1}, {0, 1.5, 1}});
      m.add(b);
    } else {
      Body b = open_polygon({{3, 0, 3}, {3, 4, 3}, {0, 4, 0}}, kE, kNu);
      add_open(b, {{0.4, 0, 1}, {0.5, 0.5, 1}, {1, 0.5, 1}, {1.2, 0, 1}});
      m.add(b);
    }
    load_evenly(m, 0);
    const Result r = solve(m);
    REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
    CHECK(worst_of(r) < 1e-9);
  }
}

// Blocks side by side on a line of symmetry y = 0: rollers at one end, an even pressure at the other.
TEST_CASE("model edges: free zones across a line of symmetry carry an even pressure") {
  Model m;
  m.symmetry = 2;
  m.friction = 0.2;
  m.add(open_polygon({{0, 0, 3}, {0, 2, 2}, {-1, 2, 2}, {-1, 0, 0}}));
  m.add(open_polygon({{1, 0, 2}, {1, 2, 2}, {0, 2, 4}, {0, 0, 0}}));
  m.set(1, 3, end_of("1001"));
  m.set(2, 1, end_of(kPulled, -1, 0));
  m.join(C2D_ZONE_FREE, 1, 1, 2, 3);
  const Result r = solved(m);
  for (const Row& row : r.last().rows) CHECK(row[C2D_TN] == doctest::Approx(1).epsilon(1e-9));
}

TEST_CASE("model edges: a punch holds the whole of an open curve as displacements of zero do") {
  const auto ring = [](bool punch) {
    Model m;
    m.symmetry = 3;
    Body b = open_polygon({{3, 0, 3}, {3, 3, 3}, {0, 3, 0}}, kE, kNu);
    add_open(b, {{0, 1, 1}, {0.7, 0.7, 1}, {1, 0, 1}});
    m.add(b);
    m.set(1, 1, end_of(kPulled, 3, 1));
    if (punch) {
      Platen& p = m.move(1, 3);
      p.side.last += 1;
      for (int32_t& free : p.is_free) free = 0;
    } else {
      m.set(1, 3, end_of(kHeld)), m.set(1, 4, end_of(kHeld));
    }
    const Result r = solve(m);
    REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
    return r;
  };
  const Result one = ring(true), other = ring(false);
  for (size_t i = 0; i < one.boundary[0].size(); ++i) {
    CHECK(std::fabs(one.boundary[0][i].ux - other.boundary[0][i].ux) < 1e-10);
    CHECK(std::fabs(one.boundary[0][i].uy - other.boundary[0][i].uy) < 1e-10);
  }
}

TEST_CASE("model edges: a load case that moves a rigid body along x alone is none without loads") {
  Model m = pair_of_blocks(C2D_ZONE_MATCHING, 2);
  m.cases = 2;
  m.body(2).rigid = 1;
  m.body(2).motion[0] = 0.001;
  m.set(2, 3, end_of(kPulled));
  m.set_second(1, 2, end_of(kPulled, 0.1));
  const Result r = solve(m);
  CHECK_MESSAGE(!r.told_of("loads nothing"), r.messages());
  m.body(2).motion[0] = 0;
  CHECK(solve(m).told_of("load case 1 loads nothing"));
}

// Quadratic functions have a least pressure within elements; where nothing is pressed there is none to tell.
TEST_CASE(
    "model edges: quadratic functions without contact, with a body that nothing holds, and with one that is pulled away") {
  Model alone;
  alone.function_nodes = 3;
  alone.add(rectangle(0, 0, 2, 1, {2, 1, 2, 1}));
  alone.set(1, 1, end_of(kHeld));
  CHECK(solved(alone).summary.tension_ratio == 0.0);
  for (int which = 0; which < 2; ++which) {
    Model m;
    m.function_nodes = 3;
    m.friction = 0.3;
    m.add(rectangle(0, -1, 2, 0, {1, 1, 2, 1}));
    m.add(rectangle(0, 0.1, 2, 1, {2, 1, 1, 1}));
    m.set(1, 1, end_of(kHeld));
    m.set(2, 3, end_of(kPulled, 0, 1));
    m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
    if (which == 1) m.add(rectangle(5, 5, 6, 6, {1, 1, 1, 1})); // held by nothing, touched by nothing
    const Result r = solve(m);
    REQUIRE(r.status == C2D_OK);
    CHECK(r.outcome == C2D_FREE_MOTION);
    CHECK(r.summary.tension_ratio == 0.0);
  }
}

TEST_CASE("model edges: of ties that are apart the widest is told, wherever it is") {
  for (const double tilt : {0.2, -0.2}) {
    CAPTURE(tilt);
    Model m;
    m.add(rectangle(0, -1, 2, 0, {1, 1, 2, 1}));
    m.add(polygon({{0, 0.3 - tilt / 2, 2}, {2, 0.3 + tilt / 2, 1}, {2, 2, 1}, {0, 2, 1}}));
    m.set(1, 1, end_of(kHeld));
    m.join(C2D_ZONE_MATCHING + C2D_ZONE_TIED, 1, 3, 2, 1);
    const Result r = solve(m);
    CHECK(r.status == C2D_ERR_INPUT);
    CHECK_MESSAGE(r.told_of("0.3995"), r.messages());
  }
}

// Nothing holds the upper block: half of it goes straight up, along the line of symmetry.
TEST_CASE("model edges: half a block that is pulled away goes along its line of symmetry") {
  for (const double push : {1.0, -1.0}) {
    CAPTURE(push);
    Model m = half_blocks(half_upper());
    m.set(2, 3, end_of(kPulled, 0, push));
    const Result r = solve(m);
    REQUIRE(r.status == C2D_OK);
    CHECK(r.outcome == (push > 0 ? C2D_FREE_MOTION : C2D_REACHED));
    if (push < 0) continue;
    CHECK(r.summary.outcome_body == 2);
    CHECK(std::fabs(r.summary.free_motion[0]) < 1e-12);
    CHECK(r.summary.free_motion[1] > 0);
  }
}

TEST_CASE("model edges: a body that nothing but a tie holds moves with what it is tied to") {
  for (const int32_t kind : kKinds) {
    CAPTURE(kind);
    Model m = pair_of_blocks(kind + C2D_ZONE_TIED, 2);
    m.set(1, 1, [](double x, double) { return end_of(x == 0 ? "1100" : "0110"); });
    m.set(2, 3, end_of(kPulled, 0, 1)); // pulled away
    const Result r = solve(m);
    REQUIRE(r.status == C2D_OK);
    CHECK(r.outcome == C2D_REACHED);
    // Even tension 1 in plane strain, nu = 0.3, over a height of 2.
    double top = 0;
    for (const EndResult& e : r.boundary[1]) top = std::max(top, e.uy);
    CHECK(top == doctest::Approx(2 * 0.91 / 1000).epsilon(1e-6));
  }
}

TEST_CASE("model edges: half a block that friction holds at its line of symmetry, and that is lifted off") {
  Model m = half_blocks(half_upper());
  m.set(2, 3, end_of(kPulled, 0, 1));
  for (const double mu : {0.0, 0.3}) {
    m.friction = mu;
    m.paths = {{2, -1}, {2, 1}}; // pressed on, then pulled off
    const Result r = solve(m);
    REQUIRE(r.status == C2D_OK);
    CHECK(r.outcome == C2D_FREE_MOTION);
    CHECK(r.summary.outcome_body == 2);
    CHECK(r.summary.free_motion[0] == 0);
    CHECK(r.summary.free_motion[1] == doctest::Approx(1));
    CHECK(r.summary.free_motion[2] == 0);
  }
}

TEST_CASE("model edges: an element of zero length that ends an open curve lies on the line of symmetry") {
  Model m = half_blocks(half_upper());
  Body& upper = m.body(2); // (0, 0) ... (2, 0) (2, 1) (0, 1), and there once more
  upper.xy.insert(upper.xy.end(), {0, 1});
  upper.regions[0].last = 5;
  upper.ends.insert(upper.ends.end(), {upper.ends[6], upper.ends[7]});
  const Result r = solve(m);
  CHECK(r.status == C2D_ERR_INPUT);
  CHECK_MESSAGE(r.told_of("element 5 of body 2 lies on the line of symmetry x = 0, expected no elements there"), r.messages());
  CHECK(r.told.size() == 1);
}

TEST_CASE("model edges: bodies that a tie holds together, and that can move together, are told once") {
  Model m = pair_of_blocks(C2D_ZONE_MATCHING + C2D_ZONE_TIED, 2);
  m.set(1, 1, end_of("0110")); // along x they are free
  const Result r = solve(m);
  CHECK(r.outcome == C2D_FREE_MOTION);
  CHECK_MESSAGE(r.told_of("nothing holds bodies 1, 2: they can move together in 1 way"), r.messages());
}

TEST_CASE("model edges: bodies apart that nothing has moved yet have no results and no states") {
  for (const bool rigid : {false, true}) {
    CAPTURE(rigid);
    Model m = blocks(C2D_ZONE_MATCHING, rectangle(0, -1, 2, 0, {1, 1, 2, 1}), rectangle(0, 0.1, 2, 1.1, {2, 1, 1, 1}));
    if (rigid) {
      Body& upper = m.body(2);
      upper.rigid = 1, upper.is_free[0] = upper.is_free[1] = upper.is_free[2] = 1, upper.load[1] = -1, upper.point[0] = 1;
      m.set(2, 3, end_of(kPulled));
    }
    m.paths = {{1, 0}};
    const Result r = solve(m);
    CAPTURE(r.messages());
    REQUIRE(r.status == C2D_OK);
    CHECK(r.outcome == C2D_REACHED);
    CHECK((r.zones[0].open == 3 && r.zones[0].stick == 0 && r.zones[0].slip == 0));
    for (const std::vector<EndResult>& body : r.boundary)
      for (const EndResult& e : body) CHECK((e.ux == 0 && e.uy == 0 && e.tx == 0 && e.ty == 0));
    for (const c2d_body_state& state : r.states) CHECK((state.motion[1] == 0 && state.contact[1] == 0));
    Machine machine(m);
    machine.run();
    const double xy[4] = {1, -0.5, 1, 0.6};
    double inside[2 * C2D_POINT_FIELDS];
    REQUIRE(c2d_interior(machine.solver, 0, 2, xy, 2, inside, C2D_POINT_FIELDS) == C2D_OK);
    for (const double* row : {inside, inside + C2D_POINT_FIELDS}) {
      CHECK(row[C2D_POINT_FLAG] == C2D_POINT_INSIDE);
      for (int c = 0; c < C2D_POINT_FLAG; ++c) CHECK(row[c] == 0);
    }
  }
}

TEST_CASE("model edges: a body that slides freely has its place told while loads press on it") {
  Model m = pair_of_blocks(C2D_ZONE_MATCHING, 2);
  m.friction = 0;
  const auto warned = [&](double second) {
    m.paths = {{1, 1}, {1, second}};
    const Result r = solve(m);
    CHECK(r.status == C2D_OK);
    int count = 0;
    for (const c2d_error& e : r.told) count += e.status == C2D_WARN_UNDEFINED_PLACE;
    return count;
  };
  CHECK(warned(0.5) >= 1);
  CHECK(warned(0) >= 1);
}

TEST_CASE("model edges: a body with a slit that is pushed off another one slides as a whole does") {
  for (const bool slit : {false, true}) {
    CAPTURE(slit);
    Model m;
    m.add(rectangle(-1, -2, 5, 0, {1, 1, 6, 1}));
    m.add(slit ? polygon({{0, 0, 4}, {4, 0, 1}, {4, 3, 1}, {2.5, 3, 2}, {2, 1, 2}, {1.5, 3, 1}, {0, 3, 1}})
               : polygon({{0, 0, 4}, {4, 0, 1}, {4, 3, 1}, {0, 3, 1}}));
    m.friction = 0.2;
    m.cases = 2;
    m.set(1, 1, end_of(kHeld));
    m.zones.push_back({C2D_ZONE_FREE, {{1, 3, 8}, {2, 1, 4}}});
    if (slit) {
      m.join(C2D_ZONE_MATCHING + C2D_ZONE_SELF, 2, 4, 2, 5);
      m.zones.back().without[1] = 1;
    }
    m.body(2).force[1] = -1; // its weight
    m.set_second(2, 2, end_of(kPulled, 1));
    m.paths = {{1, 1, 0}, {4, 1, 8}};
    const Result r = solve(m);
    CAPTURE(r.messages());
    REQUIRE(r.status == C2D_OK);
    CHECK(r.outcome == C2D_GROSS_SLIDING);
    CHECK(r.summary.outcome_body == 2);
    CHECK(std::fabs(r.summary.free_motion[0]) == doctest::Approx(1));
  }
}

TEST_CASE("model edges: blocks that slide down their slopes are told the directions of the slopes") {
  Model m;
  m.add(polygon({{0, 0, 2}, {8, 0, 1}, {8, 1, 2}, {6, 3, 2}, {2, 3, 2}, {0, 1, 1}}));
  m.add(polygon({{8, 1, 1}, {9, 2, 1}, {7, 4, 1}, {6, 3, 2}}));
  m.add(polygon({{0, 1, 2}, {2, 3, 1}, {1, 4, 1}, {-1, 2, 1}}));
  m.set(1, 1, end_of(kHeld));
  m.join(C2D_ZONE_MATCHING, 1, 3, 2, 4);
  m.join(C2D_ZONE_MATCHING, 1, 5, 3, 1);
  for (const int32_t body : {2, 3}) m.body(body).force[1] = -1;
  const Result r = solve(m);
  REQUIRE(r.status == C2D_OK);
  CHECK(r.outcome == C2D_FREE_MOTION);
  const double* motion = r.summary.free_motion; // down, along x away from the middle
  CHECK(motion[0] == doctest::Approx(r.summary.outcome_body == 2 ? std::sqrt(0.5) : -std::sqrt(0.5)));
  CHECK(motion[1] == doctest::Approx(-std::sqrt(0.5)));
  CHECK(motion[2] == 0);
}

// A disc that fills a hole, pressed all round and then sheared: it slips in places, and touches everywhere.
TEST_CASE("model edges: in a ring that touches all round the zones of slip are seen from a border between them on") {
  const auto told = [](int32_t elements, double shear) {
    Model m;
    std::vector<Corner> round, back;
    for (int32_t i = 0; i < elements; ++i) {
      const double angle = 2 * std::acos(-1.0) * i / elements;
      round.push_back({std::cos(angle), std::sin(angle), 1});
      back.push_back({std::cos(angle), -std::sin(angle), 1});
    }
    m.add(rectangle(-2, -2, 2, 2, {4, 4, 4, 4}));
    add_polygon(m.body(1), back);
    m.body(1).ends.resize(static_cast<size_t>(2 * m.body(1).elements()));
    m.add(polygon(round));
    m.zones.push_back({C2D_ZONE_MATCHING, {{1, 17, 16 + elements}, {2, elements, 1}}});
    m.friction = 0.3;
    m.cases = 2;
    m.set(1, 1, end_of("0110")), m.set(1, 4, end_of("1001"));
    m.set(1, 2, end_of(kPulled, -1)), m.set(1, 3, end_of(kPulled, 0, -1));
    m.set_second(1, 1, end_of("0110", -1)), m.set_second(1, 4, end_of("1001", 0, -1));
    m.set_second(1, 2, end_of(kPulled, 0, 1)), m.set_second(1, 3, end_of(kPulled, 1));
    m.paths = {{1, 1, 0}, {2, 1, shear}, {1, 0.9, 0.9 * shear}};
    return solve(m);
  };
  for (const double shear : {0.05, 0.6}) {
    CAPTURE(shear);
    const Result r = told(16, shear);
    CAPTURE(r.messages());
    REQUIRE(r.status == C2D_OK);
    CHECK(r.outcome == C2D_REACHED);
    REQUIRE(r.steps.size() == 4);
    int slip = 0, open = 0;
    for (const Row& row : r.steps[2].rows) {
      const auto status = static_cast<int32_t>(row[C2D_STATUS]);
      slip += status == C2D_SLIP, open += status == C2D_OPEN;
    }
    CHECK(open == 0);
    CHECK((slip > 0) == (shear > 0.3)); // against 0.3 of a pressure of about 1; the supports take their part
    CHECK(slip < 16);
  }
}

// ---- parts of the model by themselves ---------------------------------------------------------------------------------

TEST_CASE("model edges: an open curve on no line closes straight, and may end with a double node") {
  ModelData d(2);
  d.body(2, {{0, 0, 2, 0, 2, 1, 0, 1, 0, 1}});
  d.bodies[0].elements -= 1, d.regions[0][0].last -= 1, d.regions[0][0].open = 1, d.bodies[0].open_regions = 1;
  d.head.length_unit = 1;
  for (int32_t symmetry = 0; symmetry < 4; ++symmetry) {
    d.head.symmetry = symmetry;
    CHECK(c2d::region_area(d.view(), 0, 0) == 2);
  }
  c2d::Reporter reporter = {&d, ModelData::keep, 0};
  const c2d::Model m = d.view();
  CHECK(c2d::validate_geometry(m, reporter));
  CHECK_MESSAGE(d.told.empty(), d.all());
  for (int32_t node = 0; node < 5; ++node) {
    CHECK(c2d::twin_node(m, 0, node) == (node < 3 ? -1 : 7 - node));
    CHECK(c2d::is_second_twin(m, 0, node) == (node == 4));
  }
}

TEST_CASE("model edges: how far an element of no length is away") {
  ModelData d(2);
  d.body(2, {{0, 0, 1, 0, 1, 0, 1, 1}});
  d.head.length_unit = 1;
  CHECK(c2d::distance_to_element(d.view(), 0, 1, 4, 4) == 5);
}

TEST_CASE("model edges: motions are told along an axis, along a slope, or about a point") {
  ModelData d(2);
  d.body(2, {fixture::unit_square()});
  d.head.length_unit = 2;
  const auto told = [&](double x, double y, double turn) {
    char room[200];
    c2d::Text text = c2d::text_in(room);
    const double motion[3] = {x, y, turn};
    c2d::put_motion(text, d.view(), 0, motion);
    return std::string(room);
  };
  CHECK(told(-1, 0, 0) == "along x");
  CHECK(told(0, 1, 0) == "along y");
  CHECK(told(3, -4, 0) == "along (0.6, -0.8)");
  CHECK(told(0, 1, 1) == "rotation about (-2, 0)");
}

TEST_CASE("model edges: two curved elements make a body, whose stress turns with it") {
  const auto lens = [](double turn, double grow) {
    Model m;
    m.function_nodes = 3;
    Body b;
    b.element_nodes = 3;
    add_curve(b, 2, [&](double s, double& x, double& y) {
      const double angle = 2 * std::acos(-1.0) * (s + turn);
      x = std::cos(angle), y = std::sin(angle);
    });
    b.ends.resize(6);
    m.add(b);
    m.set(1, 1, [&](double x, double y) { return end_of(kHeld, 0, 0, grow * x, grow * y); });
    return solved(m);
  };
  const Result a = lens(0, 1e-3), b = lens(0.25, 1e-3), half = lens(0, 5e-4);
  for (size_t i = 0; i < 6; ++i) {
    const EndResult &p = a.boundary[0][i], &q = b.boundary[0][i];
    CHECK(p.sxx > 0);
    CHECK(p.sxx == doctest::Approx(q.syy).epsilon(1e-9));
    CHECK(p.syy == doctest::Approx(q.sxx).epsilon(1e-9));
    CHECK(p.sxy == doctest::Approx(-q.sxy).epsilon(1e-9));
    CHECK(p.sxx == doctest::Approx(2 * half.boundary[0][i].sxx).epsilon(1e-9));
  }
}
