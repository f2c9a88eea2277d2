// Families of three bodies and more against closed forms and balances. Tolerances are those asked for; what was measured
// stands beside them.
#include "body_figures.hpp"

#include <doctest/doctest.h>

using namespace families_test;

namespace {

const Solution& reached(const Solution& s) {
  REQUIRE_MESSAGE(s.error.empty(), s.error);
  REQUIRE(!s.steps.empty());
  return s;
}

} // namespace

TEST_CASE("families: a stack of plates has a uniform field, whatever the meshes and functions") {
  for (const char* order : {"order=1", "order=2", "order=3"}) {
    CAPTURE(order);
    CHECK(uniform_error(reached(solve("stack", {order})), 1, 0.2) < 1e-10);
  }
  CHECK(uniform_error(reached(solve("stack", {"q=-0.29"})), 1, 0.29) < 1e-10); // just below the limit
  CHECK(uniform_error(reached(solve("stack", {"plates=7", "q=0", "n=3"})), 1, 0) < 1e-10);
}

TEST_CASE("families: rollers between rigid platens share the load, with Hertz's pressure at both contacts of each") {
  const double p0 = 1000 / 0.91 / 200; // E* a / (2 R)
  const Solution s = solve("rollers");
  reached(s);
  REQUIRE(s.zones.size() == 4); // of the half roller in the middle, and of that on the right
  const HertzFigures f = worst_of_rollers(s, {0, 250}, p0);
  CHECK(f.peak < 1e-3); // as the family hertz; measured 5.3e-5
  CHECK(f.edge < 1 / 19.5);
  CHECK(f.curve < 5e-3);
  const double load = kPi / 400 * 1000 / 0.91;
  for (size_t zone = 0; zone < 4; ++zone)
    CHECK(std::fabs(std::fabs(s.zones[zone].force[1]) / (zone < 2 ? load / 2 : load) - 1) < 1e-3);
  CHECK(std::fabs(s.resultants[3].applied[0]) < 1e-9 * load); // where it is held
}

TEST_CASE("families: a roller between half planes, and between cylinders") {
  const struct {
    const char* platens;
    double p0;
  } cases[] = {{"platens=planes", 1000 / 1.82 / 200}, {"platens=cylinders", 1000 / 1.82 / 100}};
  for (const auto& c : cases) {
    CAPTURE(c.platens);
    const Solution s = solve("roller_between", {c.platens});
    const HertzFigures f = worst_of_rollers(reached(s), {0}, c.p0);
    CHECK(f.peak < 1e-3); // measured 5.3e-5
    CHECK(f.edge < 1 / 19.5);
    CHECK(f.curve < 5e-3);
  }
}

TEST_CASE("families: rollers without clearance share the load as between rigid rings") {
  const struct {
    int rollers;
    bool between;
    const char* order;
  } cases[] = {{12, false, "order=1"}, {12, true, "order=1"}, {7, false, "order=1"}, {18, true, "order=2"}};
  for (const auto& c : cases) {
    CAPTURE(c.rollers);
    CAPTURE(c.between);
    const double shaft = 5 * c.rollers / 12.0;
    const Solution s =
        solve("bearing", {c.between ? "place=between" : "place=under", c.order, setting("Z", c.rollers), setting("R", shaft)});
    CHECK(bearing_figures(reached(s), c.rollers, c.between, shaft).share < 1e-3); // measured 2.4e-4
    const double load = 2 * s.resultants[0].contact[1];
    for (size_t roller = 2; roller < s.resultants.size(); ++roller) // where it is held
      CHECK(std::hypot(s.resultants[roller].applied[0], s.resultants[roller].applied[1]) < 1e-4 * load);
  }
}

TEST_CASE("families: the stiffer the rings, the nearer the largest force on a roller to 4.08 P/Z") {
  const double rigid = bearing_figures(reached(solve("bearing")), 12).factor;
  CHECK(std::fabs(rigid - 4.08) < 0.02);
  double before = 0;
  for (const double E : {1e3, 4e3, 1.6e4, 6.4e4}) {
    const double factor = bearing_figures(reached(solve("bearing", {"rings=elastic", setting("E1", E)})), 12).factor;
    CAPTURE(E);
    CHECK(factor > before);
    CHECK(factor < rigid);
    if (before > 0) CHECK(rigid - factor < 0.6 * (rigid - before));
    before = factor;
  }
}

TEST_CASE("families: a layer of the half plane's material, bonded to it, leaves Hertz's contact") {
  for (const char* bond : {"bond=matching", "bond=free"})
    for (const char* thickness : {"t=0.5", "t=1", "t=3"}) {
      CAPTURE(bond);
      CAPTURE(thickness);
      const Solution s = solve("coating", {"E2=1000", bond, thickness});
      const HertzFigures f = hertz_figures(reached(s).zone(1), 0, 1, 1000 / 1.82 / 200);
      CHECK(std::fabs(f.peak) < 1e-3); // measured 1.4e-4 and 3.9e-4
      CHECK(std::fabs(f.edge) < 1 / 19.5);
      CHECK(f.curve < 5e-3);
    }
}

TEST_CASE("families: a stiff layer narrows the contact, a soft one widens it") {
  const auto peak = [](const char* E2) { return largest_pressure(reached(solve("coating", {E2})).zone(1)); };
  const double p0 = 1000 / 1.82 / 200;
  CHECK(peak("E2=3000") > 1.1 * p0);
  CHECK(peak("E2=300") < 0.9 * p0);
}

TEST_CASE("families: bonded strips bend as the beam of two materials") {
  for (const char* bond : {"bond=matching", "bond=free"}) {
    CAPTURE(bond);
    const BendingFigures f = bending_errors(reached(solve("bimaterial", {bond})));
    CHECK(f.deflection < 1e-4); // measured 5.3e-5 and 7.1e-5
    CHECK(f.stress < 1e-4);     // measured 5.6e-5 and 7.5e-5
  }
}

TEST_CASE("families: ring shrunk on a bonded bush against Lame with three layers") {
  for (const char* bond : {"bond=matching", "bond=free"}) {
    CAPTURE(bond);
    const ShrinkFigures f = shrink_errors(reached(solve("shrink", {bond})));
    CHECK(f.fit < 1e-4);                                                  // measured 1.3e-6 and 1.1e-5
    CHECK(f.bond < (std::string(bond) == "bond=matching" ? 1e-4 : 1e-3)); // measured 1.3e-6 and 4.1e-4, pair by pair
  }
}
