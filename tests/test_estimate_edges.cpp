// The search for a mesh where something fails: every call of the library refused, limits, histories that end early.
#include "paths.hpp"
#include "refused_calls.hpp"
#include "sketches.hpp"

#include "program/estimate/error.hpp"
#include "program/estimate/fatigue.hpp"
#include "program/estimate/loop.hpp"
#include "program/estimate/tolerances.hpp"
#include "program/estimate/wanted.hpp"

#include <algorithm>
#include <cmath>

using namespace sketch;
using namespace sketches;
using namespace test;

namespace {

// A rigid cylinder on a block, P from pi/400; `more`: history, cycle and wants.
std::string cylinder(const std::string& more) {
  return "body block E {1-(2/7)^2} nu {2/7}\nfrom -1 -2\nline bottom to 1 -2\nline right to 1 0\nline top to -1 0\n"
         "line left close\nbody cylinder rigid\nfrom -0.3 {1-sqrt(0.91)}\narc face to 0.3 {1-sqrt(0.91)} radius 1\n"
         "line right to 0.3 0.5\nline above to -0.3 0.5\nline left close\ncontact block.top cylinder.face mu 0.3\n"
         "case normal\nplaten block.bottom about 0 -2 x 0 fy {pi/400} turn 0\n"
         "case shear\nplaten block.bottom about 0 -2 x 0.01\n" +
         more;
}

// A cylinder that overlaps the block at first.
std::string overlapping(const std::string& more) {
  const std::string text = cylinder("interference\n" + more);
  std::string out = text;
  out.replace(out.find("from -0.3 {1-sqrt(0.91)}"), 24, "from -0.3 {1-sqrt(0.91)-1e-3}");
  out.replace(out.find("to 0.3 {1-sqrt(0.91)} radius"), 28, "to 0.3 {1-sqrt(0.91)-1e-3} radius");
  return out;
}

struct Solved {
  c2d_status status = C2D_OK;
  estimate::Trial trial;
  std::string why;
};
Solved solved(const Sketch& s, const Mesh& mesh) {
  Solved out;
  estimate::Demand demand;
  estimate::ask(s, demand);
  estimate::ask_below(s, mesh, demand.cycle);
  demand.drawn = true;
  out.status = estimate::solve(deck_of(s, mesh), demand, out.trial, out.why);
  return out;
}

// No call of the library that a solution makes is taken for done.
void every_call_of_a_trial_refused(const std::string& text) {
  CAPTURE(text);
  const Sketch s = sound(text);
  const Mesh mesh = first_mesh(s, 0.25);
  refuse_call(0);
  const Solved whole = solved(s, mesh);
  REQUIRE_MESSAGE(whole.status == C2D_OK, whole.why);
  REQUIRE(whole.trial.outcome == C2D_REACHED);
  const std::vector<int64_t> calls = calls_to_refuse(), summaries = calls_of("c2d_get_summary");
  CHECK(calls.size() > 30);
  for (const int64_t n : calls) {
    refuse_call(n);
    const Solved refused = solved(s, mesh);
    const std::string call = call_refused();
    CAPTURE(n);
    CAPTURE(call);
    REQUIRE(!call.empty());
    if (call == "c2d_close" || call == "c2d_get_condition" || n >= summaries.back()) continue; // the last one is of the work
    CHECK(refused.status != C2D_OK);
    CHECK(!refused.why.empty());
  }
  refuse_call(0);
}

} // namespace

TEST_CASE("estimate edges: no refused call of a solution is taken for done") {
  if (!can_refuse_calls()) return;
  const std::string fatigue = "steps 2\nwant fatigue ruiz2 block.top fatigue swt block.top depth 0.1 hoop block.top walk\n";
  every_call_of_a_trial_refused(
      cylinder("history normal 1; shear 0.05\ncycle normal 1, 0.4, 1 until steady frictionless\n" + fatigue));
  every_call_of_a_trial_refused(
      cylinder("history normal 1; shear 0.1, -0.1, 0.1\nsteps 2\nwant fatigue ruiz1 block.top pressure\n"));
  every_call_of_a_trial_refused(
      overlapping("history normal 1; shear 0.05\ncycle normal 1, 0.4, 1 until steady\nsteps 1\nwant pressure\n"));
  every_call_of_a_trial_refused(cylinder("history normal 1\ncycle shear 0.1, -0.1, 0.1 until steady\n" + fatigue));
}

namespace {

Solved solved(const std::string& text, double fineness = 0.25) {
  const Sketch s = sound(text);
  return solved(s, first_mesh(s, fineness));
}

} // namespace

TEST_CASE("estimate edges: cycles that are not steady, and such that the path does not reach the end of") {
  const std::string wants = "steps 2\nwant fatigue swt block.top\n";
  const Solved one = solved(cylinder("history normal 1\ncycle shear 0.1, -0.1, 0.1 until steady digits 12 limit 1\n" + wants));
  CHECK(one.status == C2D_OK);
  CHECK(one.trial.outcome == C2D_REACHED);
  CHECK(one.trial.why == "the cycle is not steady after 1 cycle");
  CHECK(!one.trial.cycle.empty());
  const Solved two =
      solved(cylinder("history normal 1; shear 0.3\ncycle normal 0.4, 1 until steady digits 12 limit 2\n" + wants));
  CHECK(two.status == C2D_OK);
  CHECK(two.trial.why == "the cycle is not steady after 2 cycles");
  const Solved smooth = solved(
      cylinder("history normal 1; shear 0.3\ncycle normal 0.4, 1 until steady digits 12 limit 1 frictionless\n" + wants));
  CHECK(smooth.trial.why == "the cycle is not steady after 1 cycle");
  CHECK(smooth.trial.outcome == C2D_REACHED);
  // Pulled over its friction by forces it slides away, in the cycle.
  std::string forces = cylinder("history normal 1\ncycle shear 0.1, 2, 0.1 until steady\n" + wants);
  forces.replace(forces.find("x 0 fy"), 3, "fx 0");
  forces.replace(forces.find("x 0.01"), 6, "fx {pi/400}");
  const Solved slides = solved(forces);
  CHECK(slides.status == C2D_OK);
  CHECK(slides.trial.outcome == C2D_GROSS_SLIDING);
  CHECK(slides.trial.why == c2d_outcome_message(slides.trial.outcome));
}

TEST_CASE("estimate edges: overlaps are closed before a cycle begins, with friction and without") {
  for (const char* start : {"", " frictionless"}) {
    CAPTURE(start);
    const Solved s = solved(overlapping("history normal 1; shear 0.05\ncycle normal 1, 0.4, 1 until steady" +
                                        std::string(start) + "\nsteps 1\nwant pressure\n"));
    CHECK_MESSAGE(s.status == C2D_OK, s.why);
    CHECK(s.trial.outcome == C2D_REACHED);
    REQUIRE(!s.trial.states.empty());
    CHECK(s.trial.states.back().loads.back() == 1); // the case of the overlaps stays whole
    CHECK(estimate::peak_pressure(s.trial.states.back(), 1) > 0);
  }
}

namespace {

estimate::Adapted found(const std::string& text) {
  const Sketch s = sound(text);
  estimate::Demand demand;
  estimate::ask(s, demand);
  return estimate::adapt(s, demand, [](const app::MeshRound&) {});
}

const std::string kPulled =
    "plane stress\nbody b E 1 nu 0\nfrom 0 0\nline s to 1 0\nline e to 1 1\nline n to 0 1\nline w close\n"
    "fix b.s y\nfix b.w x\ntraction b.n y 1\n";

// A beam: linear functions cannot follow its bending.
const std::string kBeam = "body b E 1e3 nu 0.3\nfrom 0 0\nline s to 12 0\nline e to 12 1\nline n to 0 1\nline w close\n"
                          "fix b.w\ntraction b.e y 1\nwant approach at b 11.9 0.5 b 0.1 0.5 1 %\n";

} // namespace

TEST_CASE("estimate edges: friction in a cycle may vanish on two meshes and not on a finer one, so its error is not zero") {
  estimate::Distance between;
  between.pressure = {0.1};
  app::Stated energy;
  energy.what = app::Measure::kCycleDissipated;
  energy.value = 0, energy.scale = 1e-10, energy.unseen = 2;
  const auto error_of = [&](const app::Stated& s) { return estimate::state_wanted({s}, {s}, between, nullptr)[0].error; };
  CHECK(error_of(energy) == doctest::Approx(2 * 0.5 * 0.1 * 2)); // doubled in the first round
  energy.other_rule = true;                                      // the contact is pressed by turns
  CHECK(error_of(energy) == doctest::Approx(2 * 0.2 * 0.1 * 2));
  energy.what = app::Measure::kFindley; // other numbers that two meshes give are those of the loads
  CHECK(error_of(energy) < 1e-18);
}

TEST_CASE("estimate edges: digits that arithmetic does not have are not reached") {
  const estimate::Adapted a = found(kPulled + "want stress at b 0.5 0.5 1e-12 %\nlimit elements 50\n");
  CHECK(a.status == C2D_OK);
  CHECK(a.loop.stopped == "a finer mesh would have more than 50 elements");
  for (const app::Stated& s : a.loop.stated)
    if (s.what == app::Measure::kStressYY) CHECK(s.value == doctest::Approx(1).epsilon(1e-6));
}

TEST_CASE(
    "estimate edges: bending takes quadratic functions, and linear ones where these cannot be solved or would be too much") {
  if (!can_refuse_calls()) return;
  refuse_call(0);
  const estimate::Adapted whole = found(kBeam);
  const std::vector<int64_t> solutions = calls_of("c2d_prepare");
  CHECK(whole.sketch.order == 2);
  const auto deflection = [](const estimate::Adapted& a) {
    for (const app::Stated& s : a.loop.stated)
      if (s.what == app::Measure::kShiftOf) return std::fabs(s.value);
    return 0.0;
  };
  CHECK(deflection(whole) > 0);
  int linear = 0;
  for (size_t k = 0; k < std::min<size_t>(6, solutions.size()); ++k) {
    CAPTURE(k);
    refuse_call(solutions[k], C2D_ERR_SINGULAR);
    const estimate::Adapted a = found(kBeam + "limit elements 400\n");
    if (a.sketch.order == 2) continue;
    if (a.loop.stopped.empty() || a.loop.stopped.find("elements") != std::string::npos) {
      ++linear; // goes on
      CHECK(deflection(a) == doctest::Approx(deflection(whole)).epsilon(0.03));
    }
  }
  CHECK(linear > 0);
  refuse_call(0);
  for (double most = 1e6; most < 1e10; most *= 1.5) { // somewhere among them only the other functions exceed it
    const estimate::Adapted a = found(kBeam + "limit work " + std::to_string(most) + "\n");
    CHECK((a.loop.stopped.empty() || a.loop.stopped.find("another refinement would exceed the work limit") == 0));
    if (a.loop.stopped.empty()) break;
  }
}

namespace {

// A block that a drive presses against a rigid cylinder.
const std::string kDriven =
    "parameter d 0.01 +- 1 %\nbody block E 1 nu 0.3\nfrom -1 -2\nline bottom to 1 -2\nline right to 1 0\nline top to -1 0\n"
    "line left close\nbody cylinder rigid\nfrom -0.3 {1-sqrt(0.91)}\narc face to 0.3 {1-sqrt(0.91)} radius 1\n"
    "line right to 0.3 0.5\nline above to -0.3 0.5\nline left close\ncontact block.top cylinder.face mu 0.3\n"
    "platen block.bottom about 0 -2 x 0 y d turn 0\nsteps 1\nwant pressure edges 20 %\nlimit elements 60\n";

// With another sketch in the place of the changed one.
app::ToleranceTable toleranced(const std::string& text, const estimate::Redraw& redraw) {
  const Sketch s = sound(text);
  estimate::Demand demand;
  estimate::ask(s, demand);
  const estimate::Adapted a = estimate::adapt(s, demand, [](const app::MeshRound&) {});
  REQUIRE(a.status == C2D_OK);
  return estimate::tolerances_of({a.sketch, a.mesh, a.trial}, a.loop.stated, redraw, demand, nullptr);
}

} // namespace

TEST_CASE("estimate edges: a number that a change of a parameter ends has no derivative") {
  for (const double side : {1, -1}) {
    CAPTURE(side);
    const app::ToleranceTable t = toleranced(kDriven, [&](const Parameters& changed) {
      const double d = changed.at("d");
      return read(kDriven, {{"d", side * (d - 0.01) < 0 ? -0.01 : d}}); // apart
    });
    REQUIRE(!t.numbers.empty());
    int edges = 0;
    for (const app::Toleranced& n : t.numbers)
      if (n.number.what == app::Measure::kContactEdge)
        ++edges, CHECK(n.by[0].why == "it does not exist on both sides of the value");
    CHECK(edges == 2);
  }
}

TEST_CASE("estimate edges: a sketch that a change of a parameter spoils is named with its fault") {
  for (const int line : {0, 3}) {
    const app::ToleranceTable t = toleranced(kDriven, [&](const Parameters& changed) {
      Reading out = read(kDriven, changed);
      out.faults.push_back({{line, 1}, "no such curve"});
      return out;
    });
    CHECK(t.parameters[0].why == std::string("with d = 0.0101: ") + (line > 0 ? "line 3: " : "") + "no such curve");
  }
}

TEST_CASE("estimate edges: an unbounded pressure has no derivative") {
  std::string punch = kDriven;
  const size_t from = punch.find("from -0.3"), to = punch.find("line right to 0.3 0.5");
  punch.replace(from, to - from, "from -0.3 0\nline face to 0.3 0\n");
  const app::ToleranceTable t = toleranced(punch, [&](const Parameters& changed) { return read(punch, changed); });
  bool seen = false;
  for (const app::Toleranced& n : t.numbers)
    if (n.number.is_unbounded()) seen = true, CHECK(n.by[0].why == "it is unbounded");
  CHECK(seen);
}

TEST_CASE("estimate edges: rubbing on two curves, and on one that touches nothing") {
  std::string text = cylinder("history normal 1; shear 0.1, -0.1, 0.1\nsteps 2\n"
                              "want fatigue ruiz1 block.left1+top fatigue ruiz2 block.left1+top fatigue ruiz1 block.left\n");
  text.replace(text.find("line top to -1 0\n"), 17, "line top to 0.013 0\nline left1 to -1 0\n");
  text.replace(text.find("contact block.top "), 18, "contact block.top+left1 ");
  const Sketch s = sound(text);
  const Mesh mesh = first_mesh(s, 0.5);
  const Solved one = solved(s, mesh);
  REQUIRE_MESSAGE(one.status == C2D_OK, one.why);
  const std::vector<app::Stated> values = estimate::wanted_of(s, mesh, one.trial);
  // The same on one curve.
  const Sketch whole = sound(
      cylinder("history normal 1; shear 0.1, -0.1, 0.1\nsteps 2\nwant fatigue ruiz1 block.top fatigue ruiz2 block.top\n"));
  const Mesh other = first_mesh(whole, 0.5);
  const Solved two = solved(whole, other);
  const std::vector<app::Stated> same = estimate::wanted_of(whole, other, two.trial);
  REQUIRE(values.size() == same.size()); // none of the curve that nothing rubs
  CHECK(values[0].value > 0);
  CHECK(values[0].value == doctest::Approx(same[0].value).epsilon(0.2)); // meshes differ
}

TEST_CASE("estimate edges: a body of three, no contact of which is on it, and a contact at the joint of a closed outline") {
  // The block's contact side goes round the first point of its outline.
  std::string text = cylinder("history normal 1; shear 0.05\nsteps 1\nwant hoop block.top2+top hoop base.lid pressure\n");
  const std::string outline = "from -1 -2\nline bottom to 1 -2\nline right to 1 0\nline top to -1 0\nline left close\n";
  text.replace(text.find(outline), outline.size(),
               "from 0.007 0\nline top to -1 0\nline left to -1 -2\nline bottom to 1 -2\nline right to 1 0\nline top2 close\n"
               "body base E 1 nu 0.3\nfrom -1 -3\nline foot to 1 -3\nline flank to 1 -2\nline lid to -1 -2\nline back "
               "close\ntie block.bottom base.lid\n");
  text.replace(text.find("contact block.top "), 18, "contact block.top2+top ");
  for (size_t at; (at = text.find("platen block.bottom about 0 -2")) != std::string::npos;)
    text.replace(at, 30, "platen base.foot about 0 -3");
  const Solved s = solved(text, 0.5);
  REQUIRE_MESSAGE(s.status == C2D_OK, s.why);
  CHECK(s.trial.outcome == C2D_REACHED);
  CHECK(s.trial.zones.size() >= 2);
  CHECK(estimate::peak_pressure(s.trial.states.back(), s.trial.tied[0] == 0 ? 1 : 2) > 0);
  const Sketch sketch = sound(text);
  const Mesh mesh = first_mesh(sketch, 0.5);
  const std::vector<app::Stated> values = estimate::wanted_of(sketch, mesh, s.trial);
  CHECK(values.size() >= 4);
}

TEST_CASE("estimate edges: a small body is the same work with compression and without") {
  const std::string pulled = kPulled;
  const Sketch s = sound(pulled + "tolerance off\n");
  const Mesh mesh = first_mesh(s, 1);
  const auto work_of = [&](int32_t elimination) {
    estimate::Demand demand;
    demand.elimination = elimination;
    estimate::Trial trial;
    std::string why;
    REQUIRE_MESSAGE(estimate::solve(deck_of(s, mesh), demand, trial, why) == C2D_OK, why);
    CHECK(trial.states.back().ends[0][estimate::kUy].size() > 0);
    return trial.work;
  };
  CHECK(work_of(C2D_ELIMINATION_COMPRESSED) == doctest::Approx(work_of(C2D_ELIMINATION_DENSE)).epsilon(0.01));
}
