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
  REQUIRE(s.zones.size() == 6);
  const HertzFigures f = worst_of_rollers(s, {-250, 0, 250}, p0);
  CHECK(f.peak < 1e-3); // as the family hertz; measured 5.3e-5
  CHECK(f.edge < 1 / 19.5);
  CHECK(f.curve < 5e-3);
  const double load = kPi / 400 * 1000 / 0.91;
  for (const c2d_zone_state& zone : s.zones) CHECK(std::fabs(std::fabs(zone.force[1]) / load - 1) < 1e-9);
  for (size_t roller = 1; roller <= 3; ++roller)
    CHECK(std::fabs(s.resultants[roller].applied[0]) < 1e-9 * load); // where it is held
}

TEST_CASE("families: a roller between half planes, and between cylinders") {
  const struct {
    const char* platens;
    double p0;
  } cases[] = {{"platens=elastic", 1000 / 1.82 / 200}, {"platens=cylinders", 1000 / 1.82 / 100}};
  for (const auto& c : cases) {
    CAPTURE(c.platens);
    const Solution s = solve("rollers", {"rollers=1", c.platens});
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

TEST_CASE("families: a dovetail's flanks carry F / (2 cos), or what friction leaves of it") {
  for (const double angle : {30.0, 45.0, 60.0})
    for (const double mu : {0.0, 0.2}) {
      CAPTURE(angle);
      CAPTURE(mu);
      const Solution s = solve("dovetail", {setting("angle", angle), setting("mu", mu)});
      reached(s);
      REQUIRE(s.zones[0].stick == 0);
      const FlankFigures f = flank_errors(s, angle, mu, 0.1);
      CHECK(std::fabs(f.balance) < 1e-9); // measured 1e-12
      CHECK(std::fabs(f.normal) < 1e-9);
      CHECK(std::fabs(s.resultants[0].applied[1] / -0.05 - 1) < 1e-6); // the disc's support
    }
}

TEST_CASE("families: moments of a gear pair are as its numbers of teeth, at ten angles") {
  for (int i = 0; i < 10; ++i) {
    CAPTURE(i);
    const Solution s = solve("gear", {setting("at", (i + 0.5) / 10)});
    CHECK(std::fabs(gear_error(reached(s), 20, 30)) < 1e-6); // measured 3.7e-7 to 1.7e-8
    CHECK(std::fabs(gear_peak(s, 20)) < 5e-3);
  }
  CHECK(std::fabs(gear_error(reached(solve("gear", {"zA=40", "zB=17"})), 40, 17)) < 1e-6);
}

TEST_CASE("families: what a gear pair misses of its ratio is the turn of its teeth, which falls with the load") {
  const auto error = [](const char* a) { return std::fabs(gear_error(reached(solve("gear", {a})), 20, 30)); };
  CHECK(error("a=2e-3") > 3 * error("a=1e-3")); // as the square of the half width
  CHECK(error("a=4e-3") > 3 * error("a=2e-3"));
}

TEST_CASE("families: a lap joint sticks, slips at mu times the clamp force, and then its stud bears the rest") {
  const double slip = 0.3; // mu N
  const auto balanced = [](const LapFigures& f) { return std::fabs(f.pull - f.friction - f.bearing) < 1e-9 * f.pull; };
  for (const char* stud : {"stud=elastic", "stud=rigid"}) {
    CAPTURE(stud);
    const Solution sticks = solve("lap_joint", {stud, "pull=0.002"}), slips = solve("lap_joint", {stud, "pull=0.01"}),
                   bears = solve("lap_joint", {stud});
    const LapFigures a = lap_figures(reached(sticks)), b = lap_figures(reached(slips)), c = lap_figures(reached(bears));
    CHECK(balanced(a));
    CHECK(balanced(b));
    CHECK(balanced(c));
    CHECK(a.friction > 0);
    CHECK(a.friction < 0.9 * slip);
    CHECK(a.bearing == 0);
    CHECK(sticks.zones[0].stick > 0);
    CHECK(std::fabs(b.friction / slip - 1) < 1e-9);
    CHECK(b.bearing == 0);
    CHECK(std::fabs(c.friction / slip - 1) < 1e-9);
    CHECK(c.bearing > slip);
    for (const Solution* s : {&sticks, &slips, &bears}) // the washers carry the clamp force
      for (const size_t washer : {6u, 7u}) CHECK(std::fabs(std::fabs(s->zones[washer].force[1]) - 1) < 1e-9);
  }
}

TEST_CASE("families: a lap joint with a rigid stud is stiffer") {
  const Solution elastic = solve("lap_joint"), rigid = solve("lap_joint", {"stud=rigid"});
  CHECK(lap_figures(reached(rigid)).bearing > 1.05 * lap_figures(reached(elastic)).bearing);
}
