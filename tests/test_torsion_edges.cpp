// Rare shapes and states of loads round the axis: joints within contacts, closed sections, several contacts, what has no
// result.
#include "program/estimate/loop.hpp"
#include "program/estimate/torsion.hpp"
#include "program/estimate/wanted.hpp"
#include "program/sketch/refine.hpp"
#include "sketches.hpp"

#include <cmath>

using namespace sketch;
using namespace sketches;

namespace {

const double kCircle = std::acos(-1.0);
const char kSteel[] = " E 210e3 nu 0.3\n";

struct Shape {
  std::string functions = "linear", order = "hub first", bore = "line bore to 20 0\n", seat = "line seat to 20.02 60\n",
              contact = "contact hub.bore shaft.seat mu 0.15", symmetry = "symmetry y 0\n", hub_close = "",
              start = "from 40 0\n";
};
// A hub pressed onto a shaft.
std::string hub(const std::string& loads, const Shape& shape = {}) {
  const std::string hub =
      "body hub" + std::string(kSteel) + shape.start + "line rim to 40 20\nline face to 20 20\n" + shape.bore + shape.hub_close;
  const std::string shaft = "body shaft" + std::string(kSteel) + "from 20.02 0\n" + shape.seat + "line end to 0 60\n";
  return "axisymmetric\nfunctions " + shape.functions + "\n" + shape.symmetry +
         (shape.order == "hub first" ? hub + shaft : shaft + hub) + shape.contact +
         "\ninterference\nfix shaft.end turn\ntolerance off\nsteps 4\n" + loads;
}

struct Solved {
  Sketch sketch;
  Mesh mesh;
  estimate::Trial trial;
  estimate::Twisted twisted;
};
void solve(const std::string& text, Solved& out, double fineness = 0.5) {
  CAPTURE(text);
  out.sketch = sound(text);
  out.mesh = first_mesh(out.sketch, fineness);
  estimate::Demand demand;
  estimate::ask(out.sketch, demand);
  std::string why;
  REQUIRE_MESSAGE(estimate::solve(deck_of(out.sketch, out.mesh), demand, out.trial, why) == C2D_OK, why);
  out.twisted = estimate::twist(out.sketch, out.mesh, out.trial);
}
app::TorsionTable table_of(const std::string& text, double fineness = 0.5) {
  Solved out;
  solve(text, out, fineness);
  return out.twisted.table;
}

double torque_of(const app::TorsionTable& t, const std::string& part) {
  for (size_t i = 0; i < t.parts.size(); ++i)
    if (t.parts[i].name == part) return t.steps.back().torque[i];
  FAIL("no part " << part);
  return NAN;
}

const std::string kThrough = "move hub.rim turn 0.005\n";

} // namespace

TEST_CASE("torsion edges: joints of curves within a contact do not change what it carries") {
  for (const std::string functions : {"linear", "quadratic"}) {
    CAPTURE(functions);
    Shape plain;
    plain.functions = functions;
    const app::TorsionTable whole = table_of(hub(kThrough, plain));
    REQUIRE(whole.why == "");
    for (const bool of_hub : {true, false})
      for (const std::string order : {"hub first", "shaft first"}) {
        CAPTURE(of_hub);
        CAPTURE(order);
        Shape split = plain;
        split.order = order;
        if (of_hub)
          split.bore = "line bore1 to 20 7.3\nline bore to 20 0\n",
          split.contact = "contact hub.bore1+bore shaft.seat mu 0.15 name fit";
        else
          split.seat = "line seat1 to 20.02 6.1\nline seat to 20.02 60\n",
          split.contact = "contact hub.bore shaft.seat1+seat mu 0.15 name fit";
        const app::TorsionTable t = table_of(hub(kThrough, split));
        REQUIRE(t.why == "");
        CHECK(torque_of(t, "hub.rim") == doctest::Approx(t.contacts[0].turns_through).epsilon(1e-9));
        CHECK(t.contacts[0].turns_through == doctest::Approx(whole.contacts[0].turns_through).epsilon(0.03));
      }
  }
}

TEST_CASE("torsion edges: a border of slip from both sides of a contact, for every order of functions and bodies") {
  for (const std::string functions : {"linear", "quadratic", "cubic"})
    for (const std::string order : {"hub first", "shaft first"}) {
      CAPTURE(functions);
      CAPTURE(order);
      Shape shape;
      shape.functions = functions, shape.order = order;
      const app::TorsionTable t = table_of(hub("move hub.rim turn 0.0008\n", shape));
      REQUIRE(t.borders.size() == 1);
      CHECK((t.borders[0].at[1] > 8 && t.borders[0].at[1] < 17)); // slip begins at the face, y = 20
      // Turned so little that nothing slips.
      const app::TorsionTable stick = table_of(hub("move hub.rim turn 1e-7\n", shape));
      CHECK(stick.borders.empty());
      CHECK(std::isnan(stick.contacts[0].start));
      CHECK(stick.contacts[0].turns_through > 0);
    }
}

TEST_CASE("torsion edges: a closed section with its mirror image carries as the half of it") {
  const app::TorsionTable half = table_of(hub("move hub.rim turn 0.005\n"));
  Shape whole;
  whole.symmetry = "", whole.start = "from 40 -20\n", whole.bore = "line bore to 20 -20\n",
  whole.hub_close = "line back close\n";
  whole.seat = "line seat to 20.02 60\n";
  std::string text = hub("fix hub.rim y\nmove hub.rim turn 0.005\n", whole);
  text.replace(text.find("from 20.02 0\n"), 13, "from 0 -60\nline foot to 20.02 -60\n");
  text.replace(text.find("fix shaft.end turn"), 18, "fix shaft.end turn\nfix shaft.foot turn\nfix shaft.end y");
  const app::TorsionTable t = table_of(text);
  REQUIRE(t.why == "");
  CHECK(t.contacts[0].turns_through == doctest::Approx(2 * half.contacts[0].turns_through).epsilon(0.02));
  CHECK(torque_of(t, "hub.rim") == doctest::Approx(t.contacts[0].turns_through).epsilon(1e-9));
}

TEST_CASE("torsion edges: a hub turned a little slips from both of its faces, as its image does") {
  for (const std::string functions : {"linear", "quadratic", "cubic"}) {
    CAPTURE(functions);
    Shape whole;
    whole.functions = functions;
    whole.symmetry = "", whole.start = "from 40 -20\n", whole.bore = "line bore to 20 -20\n",
    whole.hub_close = "line back close\n";
    std::string text = hub("fix hub.rim y\nmove hub.rim+face turn 0.0008\n", whole);
    text.replace(text.find("from 20.02 0\n"), 13, "from 0 -60\nline foot to 20.02 -60\n");
    text.replace(text.find("fix shaft.end turn"), 18, "fix shaft.end turn\nfix shaft.foot turn\nfix shaft.end y");
    const app::TorsionTable t = table_of(text);
    REQUIRE(t.why == "");
    CHECK(t.parts[0].name != "");
    for (const auto& border : t.borders) CHECK(std::fabs(border.at[1]) < 20);
    CHECK(t.borders.size() >= 1);
  }
}

TEST_CASE("torsion edges: a contact without friction carries nothing") {
  Shape smooth;
  smooth.contact = "contact hub.bore shaft.seat mu 0";
  const app::TorsionTable t = table_of(hub("move hub.rim turn 0.005\n", smooth));
  CHECK(t.why == "");
  CHECK(std::isnan(t.contacts[0].turns_through));
  CHECK(std::fabs(torque_of(t, "hub.rim")) < 1e-6);
  tells(hub("traction hub.rim turn 1\n", smooth), "18:1 nothing keeps body 'hub' from turning");
}

TEST_CASE("torsion edges: tractions of several cases on one curve, and the path ends in the first piece that turns through") {
  const app::TorsionTable sum = table_of(
                              hub("case a\ntraction hub.rim turn 0.1\ncase b\ntraction hub.rim turn 0.2\nhistory a 1; b 1\n")),
                          one = table_of(hub("traction hub.rim turn 0.3\n"));
  CHECK(torque_of(sum, "hub.rim") == doctest::Approx(torque_of(one, "hub.rim")).epsilon(1e-9));
  CHECK(torque_of(one, "hub.rim") == doctest::Approx(0.3 * 2 * kCircle * 1600 * 20).epsilon(1e-9));
  const app::TorsionTable ended =
      table_of(hub("case a\ntraction hub.rim turn 1000\ncase b\ntraction hub.rim turn 0.2\nhistory a 1; b 1\n"));
  CHECK(ended.ended.find("turns through") != std::string::npos);
  CHECK(ended.steps.back().loads[1] == 0); // the second piece has not begun
}

TEST_CASE("torsion edges: two contacts slip one after the other") {
  std::string text = hub("case twist\nmove ring.top turn 0.02\nhistory twist 1, -1, 1\n");
  const std::string ring =
      "body ring" + std::string(kSteel) + "from 60 0\nline top to 60 20\nline side to 39.98 20\nline in to 39.98 0\n";
  text.replace(text.find("contact hub"), 11, ring + "contact ring.in hub.rim mu 0.3 name outer\ncontact hub");
  const app::TorsionTable t = table_of(text);
  REQUIRE(t.why == "");
  REQUIRE(t.contacts.size() == 2);
  CHECK(t.contacts[0].name == "outer");
  // The weaker fit turns through, the other one holds.
  const size_t weak = t.contacts[0].turns_through < t.contacts[1].turns_through ? 0 : 1;
  CHECK(std::fabs(t.contacts[weak].through) == doctest::Approx(t.contacts[weak].turns_through).epsilon(1e-9));
  CHECK(std::isnan(t.contacts[1 - weak].through));
  CHECK(std::fabs(torque_of(t, "ring.top")) == doctest::Approx(t.contacts[weak].turns_through).epsilon(1e-9));
}

TEST_CASE("torsion edges: what has no result says why") {
  Solved s;
  solve(hub(kThrough), s);
  estimate::Trial early = s.trial;
  early.outcome = C2D_GROSS_SLIDING, early.why = "it slides";
  CHECK(estimate::twist(s.sketch, s.mesh, early).table.why == "the history in the plane of the section ended early: it slides");
  early = s.trial, early.states.clear();
  CHECK(estimate::twist(s.sketch, s.mesh, early).table.why.find("ended early") != std::string::npos);
  const Mesh fine = first_mesh(s.sketch, 100);
  CHECK(elements_of(fine) > 3000);
  const estimate::Twisted large = estimate::twist(s.sketch, fine, s.trial);
  CHECK(large.table.why == "the mesh has more than 3000 nodes, which loads round the axis are limited to");
  // Nothing is marked by a mesh without a result.
  Levels levels;
  for (const auto& outlines : s.mesh.bodies) {
    size_t count = 0;
    for (const MeshedOutline& outline : outlines) count += outline.elements();
    levels.emplace_back(count);
  }
  const auto marked = [&] {
    int sum = 0;
    for (const auto& of_body : levels)
      for (const Bisection& b : of_body) sum += b.level;
    return sum;
  };
  estimate::mark_torsion(s.sketch, s.twisted, large, s.mesh, levels);
  estimate::mark_torsion(s.sketch, large, s.twisted, s.mesh, levels);
  CHECK(marked() == 0);
  Solved finer;
  finer.sketch = s.sketch;
  finer.mesh = halved(s.sketch, s.mesh);
  std::string why;
  estimate::Demand demand;
  REQUIRE(estimate::solve(deck_of(s.sketch, finer.mesh), demand, finer.trial, why) == C2D_OK);
  estimate::mark_torsion(s.sketch, s.twisted, estimate::twist(s.sketch, finer.mesh, finer.trial), s.mesh, levels);
  CHECK(marked() > 0);
}

TEST_CASE("torsion edges: the search for a mesh with loads round the axis and numbers of the plane") {
  std::string text =
      hub("move hub.rim turn 0.0008\nwant torque 20 % hoop hub.bore 30 % stress at hub 30 5 30 %\nlimit elements 160\n");
  text.replace(text.find("tolerance off\n"), 14, "");
  const Sketch s = sound(text);
  estimate::Demand demand;
  estimate::ask(s, demand);
  const estimate::Adapted a = estimate::adapt(s, demand, [](const app::MeshRound&) {});
  REQUIRE_MESSAGE(a.status == C2D_OK, a.why);
  bool torque = false;
  for (const app::Stated& n : a.loop.stated) {
    torque = torque || n.what == app::Measure::kTorque;
  }
  CHECK(torque);
  const app::TorsionTable first = table_of(hub("move hub.rim turn 0.0008\n"));
  CHECK(torque_of(a.loop.torsion, "hub.rim") == doctest::Approx(torque_of(first, "hub.rim")).epsilon(0.05));
}

TEST_CASE("torsion edges: the flat of a ball in two curves, whose joint lies within the contact") {
  // Partial contact: pressure and slip at nodes that the mesh of the history does not have.
  const auto ball = [](const std::string& flat) {
    return "axisymmetric\nbody block E 1000 nu 0.3\nfrom 0 -8\nline foot to 8 -8\nline side to 8 0\n" + flat +
           "body ball E 1000 nu 0.3\nfrom 0 0\narc face to 4 {8-sqrt(48)} radius 8\nline side to 4 6\nline lid to 0 6\n"
           "contact block.TOP ball.face mu 0.5\nfix block.foot\nfix block.foot turn\n"
           "case press\nplaten ball.lid about 0 6 fy -100 turn 0\ncase twist\nmove ball.lid turn 0.002\n"
           "history press 1; twist 1\nsteps 2\ntolerance off\n";
  };
  std::string one = ball("line top to 0 0\n"), two = ball("line top1 to 0.31 0\nline top to 0 0\n");
  one.replace(one.find("block.TOP"), 9, "block.top"), two.replace(two.find("block.TOP"), 9, "block.top1+top");
  const app::TorsionTable a = table_of(one), b = table_of(two);
  REQUIRE((a.why == "" && b.why == ""));
  CHECK(torque_of(b, "ball.lid") == doctest::Approx(torque_of(a, "ball.lid")).epsilon(0.1));
}
