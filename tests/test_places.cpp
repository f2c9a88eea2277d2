// Places of contacts as x, y and as distances along the second side of the contact statement: the same on every mesh, and
// however curves are numbered.
#include "program/estimate/loop.hpp"
#include "program/estimate/trial.hpp"
#include "program/estimate/wanted.hpp"
#include "program/sketch/read/read.hpp"
#include "program/sweep/responses.hpp"
#include "sketches.hpp"

#include <cmath>
#include <doctest/doctest.h>

using app::Measure;

namespace {

constexpr double kTurn = 6.283185307179586;

// A disc of radius 5 on a block whose top is at y = 0, pushed down; the contact is about 1 wide.
std::string disc(const std::string& block, const std::string& rim, const std::string& contact, bool rigid = false) {
  return "body block E 1000 nu 0.3\n" + block + "body disc " + (rigid ? "rigid" : "E 1000 nu 0.3") + "\n" + rim + contact +
         "fix block.base\n" +
         (rigid ? "drive disc about 0 5 fx 0 fy -40 turn 0\n"
                : "case normal\nplaten disc.cap about 0 5 fx 0 fy -40 turn 0\ncase shear\nplaten disc.cap about 0 5 fx 8 fy 0 "
                  "turn 0\n"
                  "history normal 1; shear 1\n");
}
const std::string kBlock = "from -4 -4\nline base to 4 -4\nline right to 4 0\nline top to -4 0\nline left close\n";
const std::string kBlockFromTop = "from 4 0\nline top to -4 0\nline left to -4 -4\nline base to 4 -4\nline right close\n";
const std::string kHalf = "from -5 5\narc rim to 5 5 centre 0 5\nline cap close\n";
const std::string kHalfFromCap = "from 5 5\nline cap to -5 5\narc rim close centre 0 5\n";

estimate::Trial solved(const std::string& text, double fineness) {
  estimate::Trial out;
  estimate::Demand demand;
  demand.drawn = true;
  std::string why;
  REQUIRE_MESSAGE(estimate::solve(sketches::deck(text, fineness), demand, out, why) == C2D_OK, why);
  REQUIRE(out.outcome == C2D_REACHED);
  return out;
}

std::vector<app::Quantity> all(const estimate::Trial& trial, Measure what) {
  std::vector<app::Quantity> out;
  for (const app::Quantity& q : trial.states.back().quantities)
    if (q.what == what && q.zone == 1) out.push_back(q);
  return out;
}
double value(const estimate::Trial& trial, Measure what) {
  const std::vector<app::Quantity> found = all(trial, what);
  REQUIRE(found.size() == 1);
  return found[0].value;
}

// In the order of x.
std::vector<app::Quantity> edges(const estimate::Trial& trial) {
  std::vector<app::Quantity> out = all(trial, Measure::kContactEdge);
  REQUIRE(out.size() == 2);
  if (out[0].at[0] > out[1].at[0]) std::swap(out[0], out[1]);
  return out;
}

estimate::Adapted found(const std::string& text) {
  const sketch::Reading r = sketch::read_sketch(text, {}, [](const std::string&, std::string&) { return false; });
  REQUIRE(r.faults.empty());
  estimate::Demand demand;
  estimate::ask(r.sketch, demand);
  return estimate::adapt(r.sketch, demand, [](const app::MeshRound&) {});
}

app::Stated stated(const estimate::Adapted& a, Measure what, size_t which = 0) {
  for (const app::Stated& s : a.loop.stated)
    if (s.what == what && which-- == 0) return s;
  FAIL("no " << app::name_of(what));
  return {};
}

} // namespace

TEST_CASE("places: distances along a straight second side do not depend on mesh and numbering") {
  const std::string contact = "contact disc.rim block.top mu 0.3\n";
  for (const std::string& block : {kBlock, kBlockFromTop})
    for (const std::string& rim : {kHalf, kHalfFromCap})
      for (const double fineness : {1.0, 2.0}) {
        const estimate::Trial t = solved(disc(block, rim, contact), fineness);
        for (const Measure what : {Measure::kContactEdge, Measure::kStickBorder, Measure::kPeakPressure})
          for (const app::Quantity& q : all(t, what))
            CHECK(q.along == doctest::Approx(4 - q.at[0]).epsilon(1e-9)); // from (4, 0)
        const std::vector<app::Quantity> e = edges(t);
        CHECK(value(t, Measure::kContactWidth) == doctest::Approx(e[1].at[0] - e[0].at[0]).epsilon(1e-9));
        CHECK(value(t, Measure::kHalfWidth) == doctest::Approx(value(t, Measure::kContactWidth) / 2));
        CHECK(value(t, Measure::kStuckWidth) < value(t, Measure::kContactWidth));
        const std::vector<app::Quantity> borders = all(t, Measure::kStickBorder);
        REQUIRE(borders.size() == 2);
        const double middle = (borders[0].along + borders[1].along) / 2;
        CHECK(value(t, Measure::kStuckWidth) == doctest::Approx(std::fabs(borders[0].along - borders[1].along)).epsilon(1e-9));
        CHECK(value(t, Measure::kEccentricity) == doctest::Approx(middle - (e[0].along + e[1].along) / 2).epsilon(1e-6));
      }
}

TEST_CASE("places: along an arc, with the nodes on the other side too, and round a circle") {
  const auto angle = [](const app::Quantity& q) { return std::atan2(q.at[1] - 5, q.at[0]); };
  for (const double fineness : {1.0, 2.0}) {
    for (const std::string& rim : {kHalf, kHalfFromCap}) {
      const estimate::Trial t = solved(disc(kBlock, rim, "contact block.top disc.rim mu 0.3\n"), fineness);
      for (const app::Quantity& q : edges(t)) CHECK(q.along == doctest::Approx(5 * (angle(q) + kTurn / 2)).epsilon(2e-5));
    }
    // The pairs are those of the block, as the disc is rigid.
    const estimate::Trial t =
        solved(disc(kBlock, "circle rim centre 0 5 radius 5\n", "contact block.top disc.rim\n", true), fineness);
    for (const app::Quantity& q : edges(t)) {
      CHECK(std::fabs(q.at[1]) < 1e-9); // on the block
      CHECK(q.along ==
            doctest::Approx(5 * std::fmod(std::atan2(-5.0, q.at[0]) + 1.25 * kTurn, kTurn)).epsilon(2e-5)); // from below
    }
  }
}

TEST_CASE("places: meshes of two searches agree within the stated errors; wanted widths drive the search") {
  const std::string text = disc(kBlock, kHalf, "contact disc.rim block.top mu 0.3\n");
  const estimate::Adapted one = found(text + "want width 2 %\n"), two = found(text + "want width 1 %  stick 3 %\n");
  CHECK((one.loop.stopped.empty() && two.loop.stopped.empty()));
  CHECK(one.loop.rounds.back().elements != two.loop.rounds.back().elements);
  for (const Measure what : {Measure::kContactWidth, Measure::kHalfWidth, Measure::kStuckWidth, Measure::kEccentricity}) {
    const app::Stated a = stated(one, what), b = stated(two, what);
    CAPTURE(a.name());
    CHECK(std::fabs(a.value - b.value) <= a.error + b.error);
    const bool by_one = what == Measure::kContactWidth || what == Measure::kHalfWidth;
    CHECK((std::isnan(a.tolerance) == !by_one && b.is_met()));
  }
  for (const double x : {-1.0, 1.0}) { // each edge of one search beside that of the other
    const auto edge = [&](const estimate::Adapted& a) {
      const app::Stated s = stated(a, Measure::kContactEdge);
      return s.at[0] * x > 0 ? s : stated(a, Measure::kContactEdge, 1);
    };
    CHECK(std::fabs(edge(one).along - edge(two).along) <= edge(one).error + edge(two).error);
  }
  const double width = 4 * std::sqrt(40 * 5 / (kTurn / 2) * 2 * (1 - 0.09) / 1000); // Hertz, of half planes
  CHECK(stated(two, Measure::kContactWidth).value == doctest::Approx(width).epsilon(0.03));
}

namespace {

// A pad pressed on a block; its sides lean by `lean` over its height of 2. Its flat has round ends of radius `round`, which the
// contact leaves out.
std::string pad(double lean, const std::string& round = "") {
  const auto x = [](double value) { return std::to_string(value); };
  return "body block E 1000 nu 0.3\n" + kBlock + "body pad E 1000 nu 0.3\nfrom " + x(-1 - lean) + " 2\nline left to -1 0\n" +
         round + "line foot to 1 0\n" + round + "line right to " + x(1 + lean) +
         " 2\nline lid close\ncontact pad.foot block.top\nfix block.base\ntraction pad.lid x 0 y -4\nfix pad.left x\n";
}

} // namespace

TEST_CASE("places: a highest pressure at a sharp corner is unbounded, at a slender one it is not") {
  for (const std::string& round : {"", "fillet edge radius 0.2\n"}) {
    const estimate::Adapted by_default = found(pad(0, round) + "tolerance 5 %\n"),
                            wanted = found(pad(0, round) + "want pressure 5 %\n");
    CHECK(by_default.loop.stopped.empty());
    CHECK(wanted.loop.stopped.find("unbounded where contact ends at a corner") != std::string::npos);
    for (const estimate::Adapted* a : {&by_default, &wanted}) {
      const app::Stated peak = stated(*a, Measure::kPeakPressure);
      CHECK((peak.is_unbounded() && std::isnan(peak.error)));
      CHECK(std::fabs(peak.at[0]) == doctest::Approx(round.empty() ? 1 : 0.8).epsilon(0.05));
    }
    CHECK(std::isnan(stated(by_default, Measure::kPeakPressure).tolerance));
    CHECK(stated(by_default, Measure::kForceY).error < 0.05 * 8);
  }
  const app::Stated peak =
      stated(found(pad(-0.9) + "tolerance 5 %\n"), Measure::kPeakPressure); // sharper than 70 degrees inside
  CHECK((!peak.is_unbounded() && peak.error > 0));
}

TEST_CASE("places: of half a model the whole width counts") {
  const std::string whole =
      "symmetry x 0\nbody block E 1000 nu 0.3\nfrom 0 -4\nline base to 4 -4\nline right to 4 0\nline top to 0 0\n"
      "body disc E 1000 nu 0.3\nfrom 0 0\narc rim to 5 5 centre 0 5\nline cap to 0 5\n"
      "contact disc.rim block.top mu 0.3\nfix block.base\ntraction disc.cap x 0 y -4\n";
  const estimate::Trial t = solved(whole, 2);
  const std::vector<app::Quantity> edge = all(t, Measure::kContactEdge);
  REQUIRE(edge.size() == 1);
  CHECK(value(t, Measure::kContactWidth) == doctest::Approx(2 * edge[0].at[0]).epsilon(1e-9));
  CHECK(value(t, Measure::kHalfWidth) == doctest::Approx(edge[0].at[0]).epsilon(1e-9));
  CHECK(all(t, Measure::kEccentricity).empty());
}

TEST_CASE("places: responses name their parts") {
  std::vector<app::Response> r;
  std::string error;
  REQUIRE(
      app::read_responses("contact edge 2 x; contact edge 1 along zone 3; force x; peak pressure y; contact width", r, error));
  using Part = app::Response::Part;
  CHECK((r[0].part == Part::kX && r[0].item == 2 && r[0].which == static_cast<int>(Measure::kContactEdge)));
  CHECK((r[2].part == Part::kValue && r[2].which == static_cast<int>(Measure::kForceX)));
  CHECK((r[3].part == Part::kY && r[3].which == static_cast<int>(Measure::kPeakPressure)));
  CHECK(r[4].which == static_cast<int>(Measure::kContactWidth));
  CHECK(r[1].zone == 3);
  for (const char* wrong : {"moment x", "mean pressure along", "x", "max tn y"}) {
    r.clear();
    CHECK_FALSE(app::read_responses(wrong, r, error));
  }
}
