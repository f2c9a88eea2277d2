// A rigid body 1: the limit of ever stiffer ones, prescribed motions, reactions, energy, faults.
#include "deck_recorder.hpp"
#include "problem.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace problem;

namespace {

Result solved(const Problem& p, const Setup& setup = Setup()) {
  Result r = solve(p, setup);
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  return r;
}

// A block with a rounded foot on an obstacle, whose sides and base move by (ux, uy) if it is elastic.
Problem pressed(double mu, double ux, double uy, double load, double stiffness, bool rigid) {
  Problem p;
  p.bodies.resize(2);
  p.bodies[0].youngs_modulus = stiffness;
  add_polygon(p.bodies[0], {{-2, -1, 3}, {2, -1, 2}, {2, 0, 2}, {1, 0, 8}, {-1, 0, 2}, {-2, 0, 2}});
  Body& top = p.bodies[1];
  const auto foot = [](double x) { return 0.02 * x * x; };
  for (int i = 0; i < 8; ++i) top.xy.insert(top.xy.end(), {-1 + 0.25 * i, foot(-1 + 0.25 * i)});
  for (int i = 0; i < 3; ++i) top.xy.insert(top.xy.end(), {1, 0.02 + (1 - 0.02) * i / 3});
  for (int i = 0; i < 4; ++i) top.xy.insert(top.xy.end(), {1 - 0.5 * i, 1});
  for (int i = 0; i < 3; ++i) top.xy.insert(top.xy.end(), {-1, 1 - (1 - 0.02) * i / 3});
  top.regions = {{1, 18}};
  set_ends(p, 1, [&](double, double, double, double ny, End& end) {
    if (rigid || ny > 0.5) return;
    for (int c = 0; c < 2; ++c) end.codes[c] = 1, end.codes[2 + c] = 0;
    end.values[2] = ux, end.values[3] = uy;
  });
  set_ends(p, 2, [&](double, double y, double nx, double ny, End& end) {
    if (load != 0 && nx > 0.5 && y > 0.3) end.codes[0] = 1, end.codes[2] = 0; // guided: only up and down
    if (ny < 0.5) return;
    if (load != 0) {
      end.values[1] = load;
      return;
    }
    for (int c = 0; c < 2; ++c) end.codes[c] = 1, end.codes[2 + c] = 0;
  });
  problem::Zone zone = problem::Zone();
  zone.pairs = 9, zone.elements = 8;
  zone.first_element[0] = 8, zone.last_element[0] = 15, zone.first_node[0] = 8, zone.last_node[0] = 16;
  zone.first_element[1] = 8, zone.last_element[1] = 1, zone.first_node[1] = 9, zone.last_node[1] = 1;
  p.zones = {zone};
  p.friction = {mu};
  if (rigid) {
    p.rigid = true;
    if (ux != 0 || uy != 0) p.motions = {{ux, uy, 0}};
  }
  return p;
}

} // namespace

TEST_CASE("rigid: the limit of stiffer and stiffer obstacles") {
  for (double mu : {0.0, 0.3})
    for (bool force : {true, false}) {
      CAPTURE(mu);
      CAPTURE(force);
      const double ux = force ? 0 : (mu > 0 ? 0.004 : 0), uy = force ? 0 : 0.02, load = force ? -6 : 0;
      const Result exact = solved(pressed(mu, ux, uy, load, 1, true));
      REQUIRE(exact.outcome == C2D_REACHED);
      double before = 0;
      for (double stiffness : {1e6, 1e8, 1e10, 1e12}) { // 1e3 ... 1e9 times the block's
        CAPTURE(stiffness);
        const Result r = solved(pressed(mu, ux, uy, load, stiffness, false));
        REQUIRE(r.outcome == C2D_REACHED);
        const Difference d = compare(r, exact);
        CHECK(d.statuses == 0);
        const double now = std::max({d.traction, d.displacement2, d.gap});
        CHECK(now > 0);
        if (before > 0) CHECK(now < std::max(0.012 * before, 2e-9)); // linear in 1/E, down to round-off
        before = now;
      }
    }
}

TEST_CASE("rigid: reactions, motion and output of the obstacle") {
  Setup setup;
  setup.points = {0.5, -0.5, 0.3, 0.6};
  const Result r = solved(pressed(0.3, 0.004, 0.02, 0, 1, true), setup);
  REQUIRE(r.outcome == C2D_REACHED);
  CHECK(r.summary.body[0].unknowns == 0);
  for (const EndResult& end : r.boundary[0]) {
    CHECK(end.ux == doctest::Approx(0.004).epsilon(1e-14));
    CHECK(end.uy == doctest::Approx(0.02).epsilon(1e-14));
  }
  double touched = 0;
  for (const EndResult& end : r.boundary[0]) touched = std::max(touched, -end.ty);
  CHECK(touched > 0);
  for (int i = 0; i < 9; ++i) {
    CHECK(r.steps.back().at(i, C2D_UN1) == doctest::Approx(0.02).epsilon(1e-12));
    CHECK(r.steps.back().at(i, C2D_UT1) == doctest::Approx(0.004).epsilon(1e-12));
  }
  for (int i = 0; i < 2; ++i) {
    CHECK(r.summary.body[0].applied[i] == doctest::Approx(-r.summary.body[0].contact[i]).epsilon(1e-13));
    CHECK(r.summary.body[0].contact[i] == doctest::Approx(-r.summary.body[1].contact[i]).epsilon(1e-12));
    CHECK(r.summary.body[1].applied[i] == doctest::Approx(-r.summary.body[1].contact[i]).epsilon(1e-10));
  }
  CHECK(r.interior[C2D_POINT_UX] == doctest::Approx(0.004).epsilon(1e-13));
  CHECK(r.interior[C2D_POINT_SYY] == 0);
  CHECK(r.interior[C2D_POINT_FLAG] == C2D_POINT_INSIDE);
  CHECK(r.interior[C2D_POINT_FIELDS + C2D_POINT_SYY] < 0);
  // The obstacle's motion is all that does work.
  CHECK(r.summary.work > 0);
  CHECK(std::fabs(r.summary.energy_defect) < 0.02);
}

TEST_CASE("rigid: moving the obstacle or the block, and a rotation, is the same") {
  // The block's top goes down instead of the obstacle going up.
  Problem down = pressed(0.3, 0, 0, 0, 1, true);
  for (End& end : down.bodies[1].ends)
    if (end.codes[3] == 0) end.values[3] = -0.02;
  const Result a = solved(pressed(0.3, 0, 0.02, 0, 1, true)), b = solved(down);
  for (int i = 0; i < 9; ++i)
    CHECK(a.steps.back().at(i, C2D_TN) == doctest::Approx(b.steps.back().at(i, C2D_TN)).epsilon(1e-9).scale(1));
  // A small rotation on top of the rise presses one side more; turned the other way it is the mirror image.
  Problem left = pressed(0, 0, 0, 0, 1, true), right = left;
  left.motions = {{0, 0.02, 0.005}};
  right.motions = {{0, 0.02, -0.005}};
  const Result l = solved(left), r = solved(right);
  for (int i = 0; i < 9; ++i)
    CHECK(l.steps.back().at(i, C2D_TN) == doctest::Approx(r.steps.back().at(8 - i, C2D_TN)).epsilon(1e-9).scale(1));
  CHECK(std::fabs(l.steps.back().at(2, C2D_TN) - l.steps.back().at(6, C2D_TN)) > 0.1);
  for (const EndResult& end : l.boundary[0]) {
    CHECK(end.ux == doctest::Approx(-0.005 * end.y).epsilon(1e-12));
    CHECK(end.uy == doctest::Approx(0.02 + 0.005 * end.x).epsilon(1e-12));
  }
}

TEST_CASE("rigid: what cannot be is told") {
  Problem p = pressed(0.3, 0, 0.02, 0, 1, true);
  p.bodies[0].ends[0].values[1] = 1;
  CHECK(solve(p).status == C2D_ERR_INPUT);
  p = pressed(0.3, 0, 0.02, 0, 1, true);
  p.body_forces = {{1, 1, 0, -1}};
  CHECK(solve(p).status == C2D_ERR_INPUT);
  p = pressed(0.3, 0, 0.02, 0, 1, true);
  p.bodies.resize(1), p.zones.clear();
  CHECK(solve(p).status == C2D_ERR_ARGUMENT);
}

TEST_CASE("rigid: the keyword card") {
  const auto with = [](const std::vector<std::string>& cards) {
    std::vector<std::string> deck = deck_test::squares();
    deck.insert(deck.end(), cards.begin(), cards.end());
    return deck_test::read(deck_test::joined(deck));
  };
  CHECK(with({"*RIGID"}).status == C2D_OK);
  CHECK(with({"*RIGID", "1 0 0.1 0 0 0", "2 0.1 0 0 0 0"}).sizes.load_cases == 2);
  CHECK(with({"*RIGID", "1 0 0.1 0 0"}).status == C2D_ERR_INPUT);
  CHECK(with({"*RIGID", "0 0 0.1 0 0 0"}).status == C2D_ERR_INPUT);
  CHECK(with({"*RIGID 1"}).status == C2D_OK);
  CHECK(with({"*RIGID 2", "1 0 0.1 0 0 0"}).status == C2D_OK);
  CHECK(with({"*RIGID 3"}).status == C2D_ERR_INPUT);
  CHECK(with({"*RIGID 1 2"}).status == C2D_ERR_INPUT);
  const deck_test::Reading twice = with({"*RIGID", "*RIGID 1"});
  CHECK(twice.status == C2D_ERR_INPUT);
  REQUIRE(twice.faults.size() == 1);
  CHECK(twice.faults[0].text == "body 1 has two *RIGID keywords, expected one");
}
