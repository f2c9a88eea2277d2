// The families of problems as sketches, examples/families: solved by the loop over meshes, loosely, and compared with the
// closed forms and reference figures that tests/test_families*.cpp ask of the families' decks.
#include "body_figures.hpp"
#include "program/estimate/loop.hpp"
#include "program/estimate/wanted.hpp"
#include "sketch_runs.hpp"

#include <doctest/doctest.h>

using namespace families_test;

namespace {

// What models of finite size and strips for line loads are off by, as the tests of the families measure it.
constexpr double kKnownTo = 5e-4;

struct Found {
  estimate::Adapted adapted;
  Solution solution; // of the mesh that was taken

  // A number of a zone, 0: of none; the n-th of its name.
  app::Stated at(const std::string& name, int zone, int n = 0) const {
    for (const app::Stated& s : adapted.loop.stated)
      if (s.name() == name && s.zone == zone && n-- == 0) return s;
    FAIL("no number is called " << name << " in zone " << zone);
    return {};
  }
};

Found run(const std::string& name, sketch::Parameters parameters = {}) {
  if (parameters.count("tolerance") == 0) parameters["tolerance"] = 0.04;
  CAPTURE(name);
  const sketch::Reading drawn = sketch_test::read_example("families/" + name, parameters);
  for (const sketch::Fault& fault : drawn.faults) FAIL(fault.text);
  estimate::Demand demand;
  estimate::ask(drawn.sketch, demand);
  Found out;
  out.adapted = estimate::adapt(drawn.sketch, demand, [](const app::MeshRound&) {});
  REQUIRE_MESSAGE(out.adapted.status == C2D_OK, out.adapted.why);
  CHECK_MESSAGE(out.adapted.loop.stopped.empty(), name << ": " << out.adapted.loop.stopped);
  out.solution = solve_deck(out.adapted.deck);
  REQUIRE_MESSAGE(out.solution.error.empty(), out.solution.error);
  return out;
}

// Without the loop: for what holds on any mesh.
Solution on_first_mesh(const std::string& name, const sketch::Parameters& parameters) {
  const Solution out = sketch_test::solve("families/" + name, {2, 0, parameters});
  REQUIRE_MESSAGE(out.error.empty(), out.error);
  return out;
}

// Within the error that is stated for it: an estimate, which may be less than the true one by a fifth.
void check(const app::Stated& s, double exact) {
  CHECK_MESSAGE(std::fabs(s.value - exact) <= s.error / 0.8 + kKnownTo * s.scale,
                s.name() << " of zone " << s.zone << ": " << s.value << ", expected " << exact << ", stated " << s.error);
}
void check_place(const app::Stated& s, double x) {
  CHECK_MESSAGE(std::fabs(s.at[0] - x) <= s.error / 0.8 + kKnownTo * s.scale,
                s.name() << " of zone " << s.zone << " at " << s.at[0] << ", expected " << x << ", stated " << s.error);
}
// One of the places of a name stands there.
void check_one_place(const Found& f, const std::string& name, double x) {
  double least = HUGE_VAL;
  app::Stated nearest;
  for (const app::Stated& s : f.adapted.loop.stated)
    if (s.name() == name && std::fabs(s.at[0] - x) < least) least = std::fabs(s.at[0] - x), nearest = s;
  REQUIRE_MESSAGE(least < HUGE_VAL, name);
  check_place(nearest, x);
}

} // namespace

TEST_CASE("family sketches: Hertz, alone and on a layer of the half plane's material") {
  const Found bare = run("hertz"), small = run("hertz", {{"R", 25}}), coated = run("coating", {{"tolerance", 0.005}});
  check(bare.at("peak pressure", 1), 1000 / 1.82 / 200);
  check_place(bare.at("contact edge", 1), 1);
  check(coated.at("peak pressure", 1), 1000 / 1.82 / 200);
  check_place(coated.at("contact edge", 1), 1);
  CHECK(std::fabs(small.at("peak pressure", 1).value * 50 * 1.82 / 1000 - 1) < 0.01); // a/R is 0.04
  CHECK(run("coating", {{"E2", 3000}}).at("peak pressure", 1).value > 1.1 * 1000 / 1.82 / 200);
}

// Two meshes agree on the edge by accident; what it has moved since the round before tells.
TEST_CASE("family sketches: the edge on a layer of the same material, at 4 and at 1 %") {
  for (const double tolerance : {0.04, 0.01}) check_place(run("coating", {{"tolerance", tolerance}}).at("contact edge", 1), 1);
}

TEST_CASE("family sketches: Cattaneo and Mindlin: pressure, border of stick, dissipation") {
  const Found f = run("mindlin", {{"tolerance", 0.1}, {"drive", 1}});
  check(f.at("peak pressure", 1), 1000 / 1.82 / 400);
  // The cylinder is round: pushed, it touches a little beside the middle, by 8e-4 of a for R = 200 a, by half of that for 400
  // a.
  const app::Stated first = f.at("contact edge", 1, 0), last = f.at("contact edge", 1, 1);
  CHECK(std::fabs(std::fabs(last.at[0] - first.at[0]) / 2 - 1) <= first.error + last.error + kKnownTo);
  for (const double side : {-1.0, 1.0}) check_one_place(f, "stick border", side * std::sqrt(0.4));
  const double muP = 0.3 * kPi / (4 * 200 * 2 * 0.91 / 1000), k = 0.4;
  const double loop = 4 / kPi * muP * muP * (2 * 0.91 / 1000) * (k * std::log(k) + 1 - k - (1 - k) * (1 - k) / 2);
  check(f.at("dissipated", 0), 1.25 * loop); // the way out slips half as far as the way back
}

// Linear functions took sixteen meshes and four times as long: the tractions are accurate long before the force of the flanks.
TEST_CASE("family sketches: a cylinder moved by its flanks gets quadratic functions") {
  const Found f = run("mindlin", {{"tolerance", 0.01}});
  CHECK(f.adapted.sketch.order == 2);
  CHECK(f.adapted.loop.rounds.back().equations < 2000);
}

TEST_CASE("family sketches: Spence's punch, and Turner's unloading") {
  const Found other = run("punch", {{"tolerance", 0.1}, {"mu", 0.4}, {"nu", 0.3}}),
              unloaded = run("punch", {{"tolerance", 0.1}, {"unload", 0.45}});
  check_one_place(other, "stick border", 0.864481667647117);
  const std::vector<Row>& loaded = unloaded.solution.steps.at(0).rows;
  CHECK(std::fabs(loaded[0].tn / 0.33151417068531397 - 1) < 3e-3); // measured 1.8e-3
  CHECK(std::fabs(last_with(loaded, C2D_STICK) - 0.7) < 0.025);
  check_one_place(unloaded, "stick border", 0.5486995057134002);
  check_one_place(unloaded, "stick border", 0.9589479775660557);
}

TEST_CASE("family sketches: rigid cylinder with friction and with adhesion") {
  const double p00 = 1000 / 0.91 / 200;
  const Found f = run("cylinder_friction", {{"tolerance", 0.01}}),
              stuck = run("cylinder_friction", {{"tolerance", 0.01}, {"mu", HUGE_VAL}});
  check(f.at("peak pressure", 1), p00 * 1.0782404462398982);
  check_place(f.at("contact edge", 1), 0.9728971709260842);
  check_one_place(f, "stick border", 0.864481667647117 * 0.9728971709260842);
  check(stuck.at("peak pressure", 1), p00 * 1.0773110514492);
  check_place(stuck.at("contact edge", 1), 0.9686138354342385);
}

TEST_CASE("family sketches: layers that recede, are lifted, are pressed") {
  const Found equal = run("receding_layer"), stiff = run("receding_layer", {{"E2", 3000}});
  check(equal.at("peak pressure", 1), 0.7130805511737414);
  check_place(equal.at("contact edge", 1), 1.3241653718676933);
  check(stiff.at("peak pressure", 1), 0.5394575709930005);
  check_place(stiff.at("contact edge", 1), 1.836300638935971);
  const Found lifted = run("layer_lifted"), more = run("layer_lifted", {{"lambda", 4}}), pressed = run("layer_pressed");
  const double unit = 2 * 0.91 / 1e4;
  check_one_place(lifted, "contact edge", 0.9518250994943219);
  check(lifted.at("peak pressure", 1), 1.0816857184683064);
  CHECK(std::fabs(lifted.solution.last()[0].gap / unit / 0.6533972762806306 - 1) < 1e-2);
  check_one_place(more, "contact edge", 2.392934771522195);
  CHECK(std::fabs(more.solution.last()[0].gap / unit / 8.659071056346853 - 1) < 1e-2);
  check(pressed.at("peak pressure", 1), 93.07800764228236);
  for (const double x : {1.228462713443854, 3.139877067800519}) check_one_place(pressed, "contact edge", x);
}

TEST_CASE("family sketches: smooth disc in a hole") {
  const struct {
    sketch::Parameters settings;
    double angle, pole;
  } cases[] = {{{}, 19.62506010432921, 0.6090826758968362},
               {{{"Sx", 0}, {"Sy", -1}}, 56.97288043400285, 1.2813590670454869},
               {{{"E2", 3000}}, 18.93347421398299, 0.8547353512796745}};
  for (const auto& c : cases) {
    CAPTURE(c.angle);
    const Found f = run("disc_in_hole", c.settings);
    check(f.at("peak pressure", 1), c.pole);
    check_place(f.at("contact edge", 1), std::sin(c.angle * kPi / 180));
  }
}

TEST_CASE("family sketches: rectangle between rough plates") {
  check_one_place(run("rough_plates"), "stick border", 0.4386065376);
}

TEST_CASE("family sketches: one body: Lame, Kirsch, a cantilever") {
  const Found ring = run("ring"), hole = run("hole"), beam = run("cantilever");
  check(ring.at("largest stress along bore", 0), 5.0 / 3);
  check(ring.at("largest stress along rim", 0), 2.0 / 3);
  check(hole.at("largest stress along hole", 0), 3);
  check(hole.at("smallest stress along hole", 0), -1);
  for (const EndRow& end : hole.solution.ends)
    if (end.x == 0 && std::fabs(end.y - 1) < 1e-12) CHECK(end.uy == doctest::Approx(-0.91e-3).epsilon(1e-3));
  check(beam.at("stress xy", 0, 0), -0.75);
  check(beam.at("stress xx", 0, 1), -5.7);
  int tips = 0;
  const double tip = 512 / (3 * 1000 / 0.91 * 2 / 3);
  for (const EndRow& end : beam.solution.ends)
    if (end.x == 0) {
      CHECK(end.uy == doctest::Approx(tip).epsilon(1e-3));
      ++tips;
    }
  CHECK(tips > 0);
}

TEST_CASE("family sketches: a stack of plates has a uniform field") {
  CHECK(uniform_error(run("stack").solution, 1, 0.2) < 1e-9);
  CHECK(uniform_error(run("stack", {{"q", -0.29}}).solution, 1, 0.29) < 1e-9);
}

TEST_CASE("family sketches: rollers between platens; rollers of a bearing") {
  const Found rollers = run("rollers", {{"tolerance", 0.1}}), bearing = run("bearing", {{"tolerance", 0.1}});
  const double p0 = 1000 / 0.91 / 200, load = kPi / 400 * 1000 / 0.91;
  for (int zone = 1; zone <= 4; ++zone) {
    check(rollers.at("peak pressure", zone), p0);
    CHECK(std::fabs(std::fabs(rollers.solution.zones[static_cast<size_t>(zone) - 1].force[1]) / load - (zone < 3 ? 0.5 : 1)) <
          2e-3);
  }
  CHECK(bearing_figures(bearing.solution, 12).share < 2e-3);
}

TEST_CASE("family sketches: bonded strips in bending; a ring shrunk on a bonded bush") {
  const Found strips = run("bimaterial"), shrunk = run("shrink");
  const BendingFigures f = bending_errors(strips.solution);
  CHECK(f.deflection < 1e-3);
  CHECK(f.stress < 1e-2);
  const ShrinkFigures exact = shrink_exact();
  for (const Row& row : shrunk.solution.zone(1)) CHECK(row.tn == doctest::Approx(exact.fit).epsilon(1e-3));
  for (const Row& row : shrunk.solution.zone(2)) CHECK(row.tn == doctest::Approx(exact.bond).epsilon(1e-3));
}

TEST_CASE("family sketches: a dovetail's flanks carry F / (2 cos), or what friction leaves of it, on any mesh") {
  for (const double angle : {30.0, 45.0, 60.0})
    for (const double mu : {0.0, 0.2}) {
      CAPTURE(angle);
      CAPTURE(mu);
      const Solution s = on_first_mesh("dovetail", {{"angle", angle}, {"mu", mu}});
      REQUIRE(s.zones[0].stick == 0);
      const FlankFigures f = flank_errors(s, angle, mu, 0.1);
      CHECK(std::fabs(f.balance) < 1e-9);
      CHECK(std::fabs(f.normal) < 1e-9);
      CHECK(std::fabs(s.resultants[0].applied[1] / -0.05 - 1) < 1e-6); // the disc's support
    }
}

TEST_CASE("family sketches: moments of a gear pair are as its numbers of teeth, and Hertz's pressure between them") {
  double before = 0;
  for (const double at : {0.05, 0.95}) {
    CAPTURE(at);
    const Found gear = run("gear", {{"tolerance", 0.1}, {"at", at}});
    before = std::fabs(gear_error(gear.solution, 20, 30));
    CHECK(before < 1e-6);
    CHECK(std::fabs(gear_peak(gear.solution, 20)) < gear.at("peak pressure", 1).relative_error() + 5e-3);
  }
  CHECK(std::fabs(gear_error(run("gear", {{"tolerance", 0.1}, {"zA", 40}, {"zB", 17}}).solution, 40, 17)) < 1e-6);
  // What it misses of its ratio is the turn of its teeth, which grows with the load, the square of the half width.
  // (On meshes for 0.2 % they are 1.41e-7 and 2.46e-6; on one for 10 % the second has an error of its own of that size.)
  const Found wide = run("gear", {{"tolerance", 0.03}, {"at", 0.95}, {"a", 4e-3}});
  CHECK(std::fabs(gear_error(wide.solution, 20, 30)) > 9 * before);
}

TEST_CASE("family sketches: a lap joint sticks, slips at mu times the clamp force, and then its stud bears the rest") {
  const double slip = 0.03; // mu N
  const auto balanced = [](const LapFigures& f) { return std::fabs(f.pull - f.friction - f.bearing) < 1e-9 * f.pull; };
  double bearing = 0;
  for (const bool rigid : {false, true}) {
    CAPTURE(rigid);
    const auto pulled = [rigid](double pull) {
      std::string text = test::read_file(paths::root() + "/examples/families/lap_joint.c2s");
      const std::string stud = "body stud E E nu nu";
      REQUIRE(test::contains(text, stud));
      if (rigid) text.replace(text.find(stud), stud.size(), "body stud rigid") += "drive stud about 0 0\n"; // the tie moves it
      return sketch_test::solve(sketch_test::read_text(text, {{"pull", pull}}), {2});
    };
    const Solution sticks = pulled(0.0002), slips = pulled(0.001), bears = pulled(0.003);
    for (const Solution* s : {&sticks, &slips, &bears}) REQUIRE_MESSAGE(s->error.empty(), s->error);
    const auto figures = [rigid](const Solution& s) {
      LapFigures f = lap_figures(s);
      if (rigid) f.bearing = -f.bearing; // the stud is side 1 then
      return f;
    };
    const LapFigures a = figures(sticks), b = figures(slips), c = figures(bears);
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
    CHECK(c.bearing > (rigid ? 1.05 * bearing : slip));
    bearing = c.bearing;
  }
}

TEST_CASE("family sketches: stress intensity of cracks, by the handbook") {
  const CrackFactors exact = crack_factors(0.5);
  const Found centre = run("crack"), edge = run("crack_edge");
  REQUIRE(centre.solution.cracks.size() == 2);
  for (const app::StressIntensity& tip : centre.solution.cracks)
    CHECK(std::fabs(tip.K1 / std::sqrt(kPi) / exact.centre - 1) < 0.01);
  REQUIRE(edge.solution.cracks.size() == 1);
  CHECK(std::fabs(edge.solution.cracks[0].K1 / std::sqrt(kPi) / exact.edge - 1) < 0.01);
}

// Solved meshes, two a round. A support begins on the smooth flank, where shares fall only with the length; the dissipated
// energy depends on the bodies far more than on tractions.
TEST_CASE("family sketches: few rounds where corners and bodies, not contacts, decide") {
  const auto meshes = [](double tolerance) {
    const sketch::Reading drawn = sketch_test::read_example("families/mindlin", {{"tolerance", tolerance}});
    for (const sketch::Fault& fault : drawn.faults) FAIL(fault.text);
    estimate::Demand demand;
    estimate::ask(drawn.sketch, demand);
    const estimate::Adapted found = estimate::adapt(drawn.sketch, demand, [](const app::MeshRound&) {});
    CHECK(found.loop.stopped.empty());
    return found.loop.rounds.size();
  };
  CHECK(meshes(0.01) <= 6);   // ten with equal parts
  CHECK(meshes(0.001) <= 10); // sixteen when the contact is refined for that energy
}

TEST_CASE("family sketches: every one is short, told on the page, and the program takes it") {
  const std::string page = test::read_file(paths::root() + "/examples/README.md");
  int sketches = 0;
  for (const auto& entry : test::fs::directory_iterator(paths::root() + "/examples/families")) {
    const std::string name = entry.path().filename().string(), text = test::read_file(entry.path().string());
    CAPTURE(name);
    ++sketches;
    CHECK(test::lines_of(text).size() <= 100);
    for (const std::string& line : test::lines_of(text)) CHECK(line.size() <= 128);
    CHECK(test::contains(page, "`" + name + "`"));
    const test::Result checked = test::run_shell("'" + paths::program() + "' check '" + entry.path().string() + "'");
    CHECK_MESSAGE(checked.status == 0, checked.err);
  }
  CHECK(sketches == 24);
  const std::string hertz = "'" + paths::program() + "' run '" + paths::root() + "/examples/families/hertz.c2s'";
  const test::Result run = test::run_shell(hertz + " R=25 --listing /dev/null");
  CHECK_MESSAGE(run.status == 0, run.err);
}

// The program has their text, which make relist puts there.
TEST_CASE("family sketches: make answers from them, every key with what it means") {
  CHECK(families::all_families().size() == 24);
  for (const families::Family& family : families::all_families()) {
    CAPTURE(family.name);
    CHECK(family.sketch == test::read_file(paths::root() + "/examples/families/" + family.name + ".c2s"));
    for (const families::Parameter& p : families::parameters_of(family)) CHECK_MESSAGE(p.meaning.size() > 3, p.key);
  }
}
