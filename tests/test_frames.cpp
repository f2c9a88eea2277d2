#include "model_fixture.hpp"

#include <doctest/doctest.h>

using namespace fixture;

namespace {

// Two blocks of 4 x 2 with `gap` between them: body 1 below with its upper side from x = 4 to x = 0 (elements
// 7 ... 10), body 2 above with its lower side (elements 1 ... 4, going up in x). Elements have length 1.
ModelData blocks(double gap = 0.5, int function_nodes = 2, double shift = 0) {
  ModelData d(function_nodes);
  d.body(2, {rectangle(0, -2, 4, 2, 4, 2)});
  d.body(2, {rectangle(shift, gap, 4, 2, 4, 2)});
  for (int e = 1; e <= 4; ++e) {
    for (int l = 1; l <= function_nodes; ++l) d.condition(1, e, l, "1100");
  }
  const int f = function_nodes;
  if (f == 1)
    d.zone(4, 4, 7, 1, 7, 4, -1, 4, 30);
  else
    d.zone(4 * (f - 1) + 1, 4, 7, 1, 6 * (f - 1) + 1, 4, -1, 4 * (f - 1) + 1, 30);
  return d;
}

void check_fault(ModelData& d, const char* part, int32_t pair = 0, int32_t zone = 1) {
  CHECK_FALSE(d.complete());
  const c2d_error* entry = d.find(part);
  INFO(d.all());
  REQUIRE(entry != nullptr);
  CHECK(entry->status == C2D_ERR_INPUT);
  CHECK(entry->zone == zone);
  if (pair > 0) CHECK(entry->pair == pair);
  if (zone == 1) CHECK(entry->line == 30);
}

} // namespace

TEST_CASE("frames: flat blocks, every function order") {
  for (int f = 1; f <= 4; ++f) {
    CAPTURE(f);
    ModelData d = blocks(0.5, f);
    REQUIRE(d.complete());
    CHECK(d.told.size() == (f == 1 ? 1 : 0)); // constant functions are warned of
    CHECK(d.head.contact == 2 * d.head.pairs);
    for (int32_t i = 0; i < d.head.pairs; ++i) {
      const c2d::Pair& p = d.pairs[static_cast<size_t>(i)];
      CHECK(std::abs(p.nx) < 1e-14); // nodes at thirds of an element are no round numbers
      CHECK(p.ny == 1);
      CHECK(p.gap == doctest::Approx(0.5).epsilon(1e-15));
      CHECK(p.length == 1);
      CHECK(p.dof == 2 * i);
      CHECK(p.zone == 0);
      double x[2], y[2];
      for (int b = 0; b < 2; ++b) c2d::node_position(d.view(), b, p.node[b], &x[b], &y[b]);
      CHECK(x[0] == doctest::Approx(x[1]).epsilon(1e-14));
    }
  }
}

TEST_CASE("frames: where nodes stand shifted, the surfaces say the normal, not the nodes") {
  for (double gap : {9e-4, 0.5})
    for (double shift : {1e-5, 0.004, 0.02, -0.02}) {
      ModelData d = blocks(gap, 2, shift);
      REQUIRE(d.complete());
      for (const c2d::Pair& p : d.pairs) {
        CHECK(p.nx == 0);
        CHECK(p.gap == doctest::Approx(gap).epsilon(1e-15));
      }
    }
}

TEST_CASE("frames: small gaps touch, overlap is a fault") {
  for (double gap : {9e-6, -9e-6, 0.0}) {
    ModelData d = blocks(gap);
    REQUIRE(d.complete());
    for (const c2d::Pair& p : d.pairs) CHECK(p.gap == 0);
  }
  ModelData open = blocks(1.1e-5); // a little more is a gap
  REQUIRE(open.complete());
  CHECK(open.pairs[2].gap == doctest::Approx(1.1e-5).epsilon(1e-9));
  ModelData overlap = blocks(-0.01);
  check_fault(overlap, "pair 1 (node 7 of body 1, node 5 of body 2): the bodies overlap by 0.01", 1);
  CHECK(overlap.find("the largest of 5 overlaps in zone 1") != nullptr);
  CHECK(overlap.faults == 1);
}

// An arc whose lowest node is 2e-8 above a flat: far more than round-off, less than the last digit of coordinates of 100 on
// cards. Where the bodies lie and how they are turned is nothing to the gap.
TEST_CASE("frames: a small gap of one pair counts wherever the bodies lie") {
  for (const double angle : {0.0, 0.7, 2.0})
    for (const double shift : {0.0, 100.0}) {
      CAPTURE(angle);
      CAPTURE(shift);
      std::vector<double> flat = rectangle(0, -2, 4, 2, 4, 2), arc = rectangle(0, 0, 4, 2, 4, 2);
      for (size_t i = 0; i < 5; ++i) arc[2 * i + 1] = 2e-8 + 0.01 * (arc[2 * i] - 2) * (arc[2 * i] - 2);
      for (std::vector<double>* body : {&flat, &arc})
        for (size_t i = 0; i < body->size(); i += 2) {
          const double x = (*body)[i], y = (*body)[i + 1];
          (*body)[i] = shift + std::cos(angle) * x - std::sin(angle) * y;
          (*body)[i + 1] = std::sin(angle) * x + std::cos(angle) * y;
        }
      ModelData d(2);
      d.body(2, {flat});
      d.body(2, {arc});
      for (int e = 1; e <= 4; ++e)
        for (int l = 1; l <= 2; ++l) d.condition(1, e, l, "1100");
      d.zone(5, 4, 7, 1, 7, 4, -1, 5, 30);
      REQUIRE(d.complete());
      CHECK(std::abs(d.pairs[2].gap - 2e-8) < 1e-12);
      CHECK(d.pairs[1].gap == doctest::Approx(0.01).epsilon(1e-3));
    }
}

TEST_CASE("frames: Hertz's deck, arcs on a flat") {
  ModelData d = hertz();
  REQUIRE(d.complete());
  for (size_t i = 0; i < 15; ++i) {
    const c2d::Pair& p = d.pairs[i];
    CAPTURE(i);
    // The deck's angles put the nodes above one another to 3e-6: the vertical gap lies at the edge of the
    // wedge.
    CHECK(std::abs(p.nx) < 2e-5);
    CHECK(p.ny == doctest::Approx(1).epsilon(1e-9));
    // Nodes lie on a circle of radius 8 over a flat.
    const double x = 2.8 - 0.2 * static_cast<double>(i);
    CHECK(p.gap == doctest::Approx(8 - std::sqrt(64 - x * x)).epsilon(1e-5));
    CHECK(p.tangential == (i < 14 ? 1 : 0));
    CHECK(p.dof == 2 * static_cast<int32_t>(i));
    CHECK(p.length == doctest::Approx(0.2).epsilon(1e-4));
  }
  CHECK(d.pairs[14].nx == 0);
  CHECK(d.pairs[14].ny == 1);
  CHECK(d.head.contact == 29);
  // On the circle the normal at x leans by asin(x / 8): 20.5 degrees at x = 2.8, 14.5 at 2.0. The polygon's
  // normal at a node between two chords is the circle's, but at the end of the zone there is one chord only.
  REQUIRE(d.count(C2D_WARN_NORMALS) == 1); // one for the zone, about its worst pair
  CHECK(d.told[0].pair == 1);
  CHECK(std::string(d.told[0].text).find("at 4 pairs") != std::string::npos);
  CHECK(d.count(C2D_WARN_KINK) == 0);
  // Body 1 is held, body 2 may only move along the axis.
  CHECK(d.bodies[0].free_motions == 0);
  CHECK(d.bodies[1].free_motions == 1);
}

TEST_CASE("frames: averaged normals where the gap closes nothing") {
  // Touching wedge faces: a roof of 4.9 degrees either side on body 1, a flat body 2, node at the ridge
  // touches.
  const double h = std::tan(4.9 * std::acos(-1.0) / 180);
  ModelData d(2);
  d.body(2, {{-1, -3, 1, -3, 1, -h, 0, 0, -1, -h}});
  d.body(2, {{-1, 0, 0, 0, 1, 0, 1, 2, -1, 2}});
  d.condition(1, 1, 1, "1100");
  d.condition(1, 1, 2, "1100");
  d.zone(3, 2, 3, 1, 3, 2, -1, 3);
  REQUIRE(d.complete());
  CHECK(d.pairs[1].nx == doctest::Approx(0).epsilon(1e-15));
  CHECK(d.pairs[1].ny == doctest::Approx(1).epsilon(1e-15));
  CHECK(d.pairs[1].gap == 0);
  CHECK(d.count(C2D_WARN_KINK) == 0); // 9.8 degrees
  // At its ends the gap is vertical, which is -n2 itself: the edge of the wedge.
  CHECK(std::abs(d.pairs[0].nx) < 1e-15);
  CHECK(d.pairs[0].gap == doctest::Approx(h).epsilon(1e-14));
}

TEST_CASE("frames: kinks and paired normals that differ warn, with numbers") {
  const double h = std::tan(8 * std::acos(-1.0) / 180);
  ModelData d(2);
  d.body(2, {{-1, -3, 1, -3, 1, -h, 0, 0, -1, -h}});
  d.body(2, {{-1, h, 0, 0, 1, h, 1, 2, -1, 2}});
  d.condition(1, 1, 1, "1100");
  d.condition(1, 1, 2, "1100");
  d.zone(3, 2, 3, 1, 3, 2, -1, 3);
  REQUIRE(d.complete());
  REQUIRE(d.count(C2D_WARN_KINK) == 2); // 16 degrees on either body
  const c2d_error* kink = d.find("elements 3 and 4 of body 1 meet at a kink of 16 degrees");
  REQUIRE(kink != nullptr);
  CHECK(kink->node == 4);
  CHECK(kink->pair == 2);
  CHECK(kink->zone == 1);
  REQUIRE(d.count(C2D_WARN_NORMALS) == 1); // the outer pairs: 16 degrees
  CHECK(d.find("at 2 pairs") != nullptr);
  CHECK(d.pairs[0].ny == doctest::Approx(1).epsilon(1e-14));
}

// An element of three nodes above a flat, (s^2, 1 - s): upright at its upper end, and a little beyond that.
TEST_CASE("frames: at a pair a surface may turn away from the other by a right angle, and no more") {
  for (const double more : {0.0, 1e-6}) {
    CAPTURE(more);
    ModelData d(2);
    d.body(3, {rectangle(0, -1, 1, 1, 2, 2)});
    d.body(3, {{0, 1, 0.25 - more, 0.5, 1, 0, 1, 0.5, 1, 1, 0.5, 1}});
    d.condition(1, 1, 1, "1100");
    d.condition(1, 1, 2, "1100");
    d.zone(2, 1, 3, 1, 3, 1, -1, 2);
    CHECK(d.complete() == (more == 0));
    const c2d_error* told = d.find(more == 0 ? "90 degrees" : "the surfaces do not face each other");
    REQUIRE_MESSAGE(told != nullptr, d.all());
    CHECK(told->pair == 2);
    // At the lower end the slope is 1/2.
    if (more > 0) CHECK(d.find("15 degrees at 1 pair, pair 1 (node 3 of body 1, node 2 of body 2): 26.5") != nullptr);
  }
}

TEST_CASE("frames: kinks are told once for a side of a zone; those that go on alike are chords of an arc") {
  const auto kinks = [](const std::vector<double>& heights) { // of a surface from x = 1 to -1, even as to its parts
    Points below = {-1, -3, 1, -3}, above;
    const double n = static_cast<double>(heights.size() - 1);
    for (size_t i = 0; i < heights.size(); ++i) {
      const double x = 1 - 2 * static_cast<double>(i) / n;
      below.insert(below.end(), {x, heights[i]});
      above.insert(above.begin(), {x, heights[i]});
    }
    above.insert(above.end(), {1, 2, -1, 2});
    const int elements = static_cast<int>(n);
    ModelData d(2);
    d.body(2, {below});
    d.body(2, {above});
    d.condition(1, 1, 1, "1100");
    d.condition(1, 1, 2, "1100");
    d.zone(elements + 1, elements, 3, 1, 3, elements, -1, elements + 1);
    CHECK(d.complete());
    return d;
  };
  ModelData zigzag = kinks({0, 0.1, 0, 0.15, 0});
  CHECK(zigzag.count(C2D_WARN_KINK) == 2);
  CHECK(zigzag.find("of body 1 meet at a kink of 33.3985 degrees, more than 10, the largest of 3") != nullptr);
  CHECK(kinks({0, 0.15, 0.2, 0.15, 0}).count(C2D_WARN_KINK) == 0); // 11.1, 11.4, 11.1 degrees
  ModelData roof = kinks({0, 0.1, 0.2, 0.1, 0});                   // of 22.6
  CHECK(roof.count(C2D_WARN_KINK) == 2);
  CHECK(roof.find("the largest of") == nullptr);
}

TEST_CASE("frames: nodes shifted along the surface do not face each other") {
  const auto shifted = [](double s) {
    ModelData d(2);
    d.body(2, {{-1, -3, 1, -3, 1, 0, 0, 0, -1, 0}});
    d.body(2, {{-1 + s, 0, s, 0, 1 + s, 0, 1 + s, 2, -1 + s, 2}});
    d.condition(1, 1, 1, "1100");
    d.condition(1, 1, 2, "1100");
    d.zone(3, 2, 3, 1, 3, 2, -1, 3);
    return d;
  };
  ModelData near = shifted(0.49), half = shifted(-0.51), far = shifted(1.0);
  CHECK(near.complete());
  CHECK(near.count(C2D_WARN_OFFSET) == 0);
  CHECK(half.complete());
  CHECK(half.count(C2D_WARN_OFFSET) == 1); // one for the zone
  CHECK(half.find("the nodes do not face each other at 3 pairs, least at pair ") != nullptr);
  CHECK_FALSE(far.complete());
  const c2d_error* fault = far.find("shifted by 1 along the surface");
  REQUIRE(fault != nullptr);
  CHECK(fault->pair == 1);
  CHECK(fault->severity == C2D_FAULT);
}

TEST_CASE("frames: symmetry conditions that are none") {
  auto axis = [](const char* below, const char* above, double ux, bool above_alone = false) {
    ModelData d = blocks();
    d.condition(1, 11, 1, below, above_alone ? 0 : ux); // body 1, node 11 (0, 0), on its left side
    d.condition(2, 12, 2, above, ux);                   // body 2, node 1 (0, 0.5)
    return d;
  };
  ModelData good = axis("1001", "1001", 0);
  REQUIRE(good.complete());
  CHECK(good.pairs[4].tangential == 0);
  CHECK(good.pairs[4].nx == 0);
  CHECK(good.pairs[4].ny == 1);
  CHECK(good.head.contact == 9);
  CHECK(c2d::unknown_at(good.view(), 0, 10, 0).kind == c2d::UnknownKind::traction);
  CHECK(c2d::unknown_at(good.view(), 0, 10, 1).kind == c2d::UnknownKind::contact);
  ModelData one = axis("1001", "0011", 0);
  check_fault(one, "ux is prescribed on body 1 only", 5);
  ModelData both = axis("1100", "1100", 0);
  check_fault(both, "displacements are prescribed in both directions", 5);
  ModelData moved = axis("1001", "1001", 0.1);
  check_fault(moved, "a nonzero ux is prescribed", 5);
  moved = axis("1001", "1001", 0.1, true);
  check_fault(moved, "a nonzero ux is prescribed", 5);
  ModelData free = axis("0001", "1001", 0); // no traction across is unknown: the contact has no part in that
  CHECK_FALSE(free.complete());
  REQUIRE(free.find("node 11 of body 1 has no unknown in x") != nullptr);
  CHECK(free.find("besides those of contact pair") == nullptr);
  ModelData normal = axis("0110", "0110", 0);
  check_fault(normal, "uy is prescribed nearly along the normal", 5);
  ModelData extra = blocks(); // unknown traction beside the contact, displacement free
  extra.condition(2, 12, 2, "1011");
  CHECK_FALSE(extra.complete());
  REQUIRE(extra.find("besides those of contact pair 5") != nullptr);
  CHECK(extra.find("besides those of contact pair 5")->node == 1);
}

TEST_CASE("zones: ranges, steps, sides") {
  auto with = [](int pairs, int elements, int e1, int s1, int n1, int e2, int s2, int n2) {
    ModelData d = blocks();
    d.zones.clear();
    d.head.pairs = 0;
    d.zone(pairs, elements, e1, s1, n1, e2, s2, n2, 30);
    return d;
  };
  CHECK(with(4, 4, 7, 1, 8, 4, -1, 4).complete());   // a node less at one end
  CHECK(with(4, 4, 7, 1, 7, 4, -1, 5).complete());   // at the other
  CHECK(with(5, 4, 10, -1, 11, 1, 1, 1).complete()); // the other way along both
  ModelData d = with(5, 4, 7, 1, 8, 4, -1, 4);
  check_fault(d, "node 12 is not a node of the zone's elements");
  d = with(4, 4, 7, 1, 8, 4, -1, 5);
  check_fault(d, "the first pair is node 2 along the elements of body 1 and node 1");
  d = with(5, 4, 7, 1, 7, 1, 1, 1);
  check_fault(d, "increase in the same direction");
  d = with(3, 2, 5, 1, 5, 4, -1, 5); // elements 5, 6 of body 1: its right side
  check_fault(d, "element 5 of body 1 with normal (1, ");
  CHECK(d.find("do not face each other, the worst of 2") != nullptr);
  CHECK(d.faults == 1);
  d = with(20, 20, 7, 1, 7, 4, -1, 5);
  check_fault(d, "elements: 20, more than its region has");
}

TEST_CASE("zones: elements in two zones, nodes in two pairs") {
  ModelData d = blocks();
  d.zones.clear();
  d.head.pairs = 0;
  d.zone(3, 2, 7, 1, 7, 4, -1, 5, 30);
  d.zone(3, 2, 9, 1, 9, 2, -1, 3, 31); // shares the middle node
  check_fault(d, "node 9 of body 1 is in pairs 3 and 4 of zones 1 and 2, expected in one pair only", 4, 2);
  CHECK(d.find("node 3 of body 2 is in pairs 3 and 4 of zones 1 and 2") != nullptr);
  CHECK(d.faults == 2);
  d.zones.pop_back();
  d.head.pairs = 3;
  d.zone(2, 2, 9, 1, 10, 2, -1, 2, 31); // does not
  CHECK(d.complete());
  d.zones.pop_back();
  d.head.pairs = 3;
  d.zone(1, 2, 8, 1, 10, 3, -1, 2, 31);
  check_fault(d, "element 8 of body 1 is in zones 1 and 2", 0, 2);
  d.zones.pop_back();
  d.head.pairs = 3;
  d.zone(3, 2, 7, 1, 7, 4, -1, 5, 31); // the same once more
  check_fault(d, "element 7 of body 1 is in zones 1 and 2, the first of 2 elements in two zones", 0, 2);
  CHECK(d.find("element 4 of body 2 is in zones 1 and 2, the first of 2") != nullptr);
  CHECK(d.faults == 2); // one for each body, and none for their nodes
}

TEST_CASE("zones: a body that runs the wrong way is one fault, and its elements are not said to look away") {
  ModelData d(2);
  d.body(2, {{-1, 0, 0, 0, 1, 0, 1, -3, -1, -3}}); // clockwise, below body 2
  d.body(2, {{-1, 0, 0, 0, 1, 0, 1, 2, -1, 2}});
  d.condition(1, 4, 1, "1100");
  d.condition(1, 4, 2, "1100");
  d.zone(3, 2, 2, -1, 3, 1, 1, 1, 30);
  CHECK_FALSE(d.complete());
  CHECK(d.find("is the outer boundary and runs clockwise") != nullptr);
  CHECK(d.find("do not face each other") == nullptr);
  CHECK(d.told.size() == 1);
}

TEST_CASE("zones: a double node is no place for contact") {
  ModelData d(2);
  d.body(2, {{-1, -3, 1, -3, 1, -1, 0, -1, 0, -1, -1, -1}}); // element 4 has zero length
  d.body(2, {{-1, 0, 0, 0, 1, 0, 1, 2, -1, 2}});
  d.condition(1, 1, 1, "1100");
  d.condition(1, 1, 2, "1100");
  d.zone(2, 1, 3, 1, 3, 2, -1, 3, 30);
  check_fault(d, "node 4 is a double node");
}

TEST_CASE("zones: a ring that goes all round wraps and is watched at its seam") {
  // A 12-sided shaft in a 12-sided hole of the same size plus a gap; the pairs go round from element 3.
  ModelData d(2);
  Points shaft, hole;
  arc_to(shaft, 0, 0, 1, 0, 360, 12);
  arc_to(hole, 0, 0, 1.1, 0, -360, 12);
  d.body(2, {shaft});
  d.body(2, {rectangle(-3, -3, 6, 6, 1, 1), hole});
  d.condition(2, 1, 1, "1100");
  d.condition(2, 1, 2, "1100");
  // Shaft element k runs from 30 (k-1) to 30 k degrees; hole element j (from 5) from -30 (j-5) to -30 (j-4).
  d.zone(12, 12, 3, 1, 3, 14, -1, 15);
  REQUIRE(d.complete());
  CHECK(d.count(C2D_WARN_KINK) == 0); // chords of an arc
  for (const c2d::Pair& p : d.pairs) {
    double x, y;
    c2d::node_position(d.view(), 0, p.node[0], &x, &y);
    CHECK(p.nx == doctest::Approx(x).epsilon(1e-12));
    CHECK(p.ny == doctest::Approx(y).epsilon(1e-12));
    CHECK(p.gap == doctest::Approx(0.1).epsilon(1e-12));
  }
  CHECK(d.pairs[11].node[0] == 1);
  CHECK(c2d::pair_of_end(d.view(), 0, 1, 1).pair == 0);
  CHECK(d.bodies[0].free_motions == 3);
}
