// Torsion in sketches: closed forms, pressures of a press fit, invariances, what is refused.
#include "effort.hpp"
#include "json.hpp"
#include "paths.hpp"
#include "program/estimate/torsion.hpp"
#include "program/estimate/wanted.hpp"
#include "shell.hpp"
#include "sketches.hpp"

#include <cmath>

using namespace sketch;
using test::effort;
using namespace sketches;

namespace {

const double kCircle = std::acos(-1.0);

const std::string kBar =
    "axisymmetric\nbody bar E 2600 nu 0.3\nfrom 0 0\nline base to 1 0\nline side to 1 3\nline top to 0 3\n";
std::string hub(const std::string& functions, const std::string& order, const std::string& loads, double unit = 1,
                double force = 1) {
  const auto n = [&](double length) { return " " + std::to_string(unit * length); };
  const std::string material = " E " + std::to_string(210e3 * force / unit / unit) + " nu 0.3\n";
  const std::string hub = "body hub" + material + "from" + n(40) + n(0) + "\nline rim to" + n(40) + n(20) + "\nline face to" +
                          n(20) + n(20) + "\nline bore to" + n(20) + n(0) + "\n";
  const std::string shaft = "body shaft" + material + "from" + n(20.02) + n(0) + "\nline seat to" + n(20.02) + n(60) +
                            "\nline end to" + n(0) + n(60) + "\n";
  return "axisymmetric\nfunctions " + functions + "\nsymmetry y 0\n" + (order == "hub first" ? hub + shaft : shaft + hub) +
         "contact hub.bore shaft.seat mu 0.15\ninterference\nfix shaft.end turn\ntolerance off\nsteps 4\n" + loads;
}

// On the first mesh.
app::TorsionTable table_of(const std::string& text) {
  const Sketch s = sound(text);
  const Mesh mesh = first_mesh(s, 0.5);
  estimate::Demand demand;
  estimate::ask(s, demand);
  estimate::Trial trial;
  std::string why;
  REQUIRE_MESSAGE(estimate::solve(deck_of(s, mesh), demand, trial, why) == C2D_OK, why);
  return estimate::twist(s, mesh, trial).table;
}

size_t part_of(const app::TorsionTable& t, const std::string& name) {
  size_t i = 0;
  while (i < t.parts.size() && t.parts[i].name != name) ++i;
  REQUIRE(i < t.parts.size());
  return i;
}
double last_torque(const app::TorsionTable& t, const std::string& name) { return t.steps.back().torque[part_of(t, name)]; }
double last_angle(const app::TorsionTable& t, const std::string& name) { return t.steps.back().angle[part_of(t, name)]; }

struct Ran {
  int status;
  std::string err, listing;
  test::Json json;
};
Ran run(const std::string& text, const std::string& parameters = "") {
  const test::Folder folder;
  test::write_file(folder / "a.c2s", text);
  const test::Result r =
      test::run_shell("'" + paths::program() + "' run '" + (folder / "a.c2s") + "' " + parameters + " --json '" +
                      (folder / "j") + "' --report '" + (folder / "p.html") + "' --listing '" + (folder / "l") + "'");
  Ran out{r.status, r.err, "", {}};
  if (r.status != 2) {
    out.listing = test::read_file(folder / "l");
    out.json = test::JsonReader::read(test::read_file(folder / "j"));
    CHECK(test::read_file(folder / "p.html").find("torsion-table") != std::string::npos);
  }
  return out;
}

} // namespace

TEST_CASE("torsion in sketches: bars, a tie, a formula; every order") {
  for (const std::string order : {"linear", "quadratic", "cubic"}) {
    const app::TorsionTable t = table_of("functions " + order + "\n" + kBar + "fix bar.base\nmove bar.top turn 0.01\n");
    const double torque = 1000 * kCircle / 2 * 0.01 / 3;
    CHECK(last_torque(t, "bar.top") == doctest::Approx(torque).epsilon(1e-10));
    CHECK(last_torque(t, "bar.base") == doctest::Approx(-torque).epsilon(1e-10));
    CHECK(t.imbalance < 1e-13);
    // The traction of uniform torsion, tau = q r, turns the end by q L/G.
    const app::TorsionTable loaded =
        table_of("functions " + order + "\n" + kBar + "fix bar.base\ntraction bar.top turn {2*x}\n");
    CHECK(last_angle(loaded, "bar.top") == doctest::Approx(2 * 3 / 1000.0).epsilon(1e-10));
    CHECK(last_torque(loaded, "bar.top") == doctest::Approx(kCircle).epsilon(1e-10));
  }
  // Two bars of unlike shear moduli, tied end to end, meshes that do not match.
  const app::TorsionTable t =
      table_of("axisymmetric\nbody a E 2600 nu 0.3\nfrom 0 0\nline base to 1 0\nline side to 1 3\nline top to 0 3\n"
               "body b E 5200 nu 0.3\nfrom 0 3\nline foot to 1 3\nline side to 1 5\nline top to 0 5\n"
               "tie a.top b.foot\nfix a.base\nmove b.top turn 0.01\n");
  CHECK(last_torque(t, "b.top") == doctest::Approx(kCircle / 2 * 0.01 / (3 / 1000.0 + 2 / 2000.0)).epsilon(1e-10));
  CHECK(t.steps.back().carried[0] == doctest::Approx(-last_torque(t, "b.top")).epsilon(1e-9));
}

TEST_CASE("torsion in sketches: a hub turns through at the sum of its limits") {
  const app::TorsionTable t = table_of(hub("linear", "hub first", "move hub.rim turn 0.005\n"));
  REQUIRE(t.contacts.size() == 1);
  const app::TorsionContact& c = t.contacts[0];
  CHECK(last_torque(t, "hub.rim") == doctest::Approx(c.turns_through).epsilon(1e-10));
  CHECK(std::fabs(c.through) == doctest::Approx(c.turns_through).epsilon(1e-10));
  CHECK(last_torque(t, "shaft.end") == doctest::Approx(-c.turns_through).epsilon(1e-10));
  CHECK(c.turns_through ==
        doctest::Approx(0.15 * 81.7 * 2 * kCircle * 400 * 20).epsilon(0.01)); // mean pressure: another program
  CHECK(std::fabs(c.start) < 0.5 * c.turns_through);
  CHECK(c.start_at[1] == doctest::Approx(20).epsilon(1e-9)); // at the face of the hub
  CHECK(t.imbalance < 1e-12);
  CHECK(t.residual < 1e-10);
  CHECK(t.borders.empty());
  // With a torque in the place of the angle: the path ends where it turns through. 2 pi 40^2 20 q = torque.
  const double area = 2 * kCircle * 1600 * 20;
  const app::TorsionTable loaded =
      table_of(hub("linear", "hub first", "traction hub.rim turn " + std::to_string(2 * c.turns_through / area) + "\n"));
  CHECK(loaded.ended.find("turns through") != std::string::npos);
  CHECK(loaded.steps.back().loads[0] == doctest::Approx(0.5).epsilon(1e-6));
  // Back and forth: from the other side it turns through at the opposite torque.
  const app::TorsionTable back =
      table_of(hub("linear", "hub first", "case twist\nmove hub.rim turn 0.005\nhistory twist 1, -1\n"));
  CHECK(last_torque(back, "hub.rim") == doctest::Approx(-c.turns_through).epsilon(1e-10));
  // Half of it: slip from the face to a border.
  const app::TorsionTable part = table_of(hub("linear", "hub first", "move hub.rim turn 0.0008\n"));
  REQUIRE(part.borders.size() == 1);
  CHECK((part.borders[0].at[1] > 0 && part.borders[0].at[1] < 20));
  CHECK(part.steps.back().slipping[0] > 0);
}

TEST_CASE("torsion in sketches: units, order of the bodies, mirror image") {
  const std::string load = "move hub.rim turn 0.0008\n";
  for (const std::string order : {"linear", "quadratic"}) {
    const double torque = last_torque(table_of(hub(order, "hub first", load)), "hub.rim");
    CHECK(last_torque(table_of(hub(order, "shaft first", load)), "hub.rim") == doctest::Approx(torque).epsilon(1e-9));
    CHECK(last_torque(table_of(hub(order, "hub first", load, 1000, 7)), "hub.rim") / 7000 ==
          doctest::Approx(torque).epsilon(1e-9));
    CHECK(last_torque(table_of(hub(order, "hub first", "move hub.rim turn -0.0008\n")), "hub.rim") ==
          doctest::Approx(-torque).epsilon(1e-9));
  }
  const std::string up = "body b E 100 nu 0.2\nfrom 0 0\nline low to 2 0\nline flank to 1 3\nline top to 0 3\n";
  const std::string down = "body b E 100 nu 0.2\nfrom 0 -3\nline top to 1 -3\nline flank to 2 0\nline low to 0 0\n";
  const std::string rest = "fix b.low\ntraction b.flank turn {1 + x}\n";
  CHECK(last_angle(table_of("axisymmetric\n" + up + rest), "b.flank") ==
        doctest::Approx(last_angle(table_of("axisymmetric\n" + down + rest), "b.flank")).epsilon(1e-9));
}

TEST_CASE("torsion in sketches: Reissner and Sagoci, the half space from blocks of two sizes") {
  const std::string block =
      "parameter size 20\naxisymmetric\nbody block E 2 nu 0\nfrom 0 {-size}\nline base to size {-size}\nline side to "
      "size 0\nline top to 1 0\nline disc to 0 0\nfix block.base\nmove block.disc turn 1\nwant torque " +
      effort<std::string>("0.1", "0.01") + " %\n";
  double torque[2] = {};
  for (int k = 0; k < 2; ++k) {
    const Ran r = run(block, k == 0 ? "size=20" : "size=60");
    CHECK(r.status == 0);
    CHECK(r.err.empty());
    const test::Json& steps = r.json["torsion"]["steps"];
    torque[k] = steps[steps.items.size() - 1]["torque"][1].number;
    for (const test::Json& s : r.json["accuracy"]["stated"].items)
      if (s["name"].text == "torque on block.disc") CHECK(s["error"].number < 0.001 * torque[k]);
  }
  CHECK((27 * torque[1] - torque[0]) / 26 ==
        doctest::Approx(16.0 / 3).epsilon(effort(3e-4, 3e-5))); // what is left falls as size^-3
}

TEST_CASE("torsion in sketches: a ball on a flat: Lubkin") {
  const std::string ball =
      "parameter turned 0.001\naxisymmetric\nbody flat rigid\nfrom 0 -100\nline base to 100 -100\nline side to 100 0\n"
      "line top to 0 0\nbody ball E 1000 nu 0.3\nfrom 0 0\narc low centre 0 100 turn 90\nline mid to 0 100\n"
      "contact flat.top ball.low mu 0 turn 0.2\ncase load\npressure ball.mid {4*1000/(300*0.91)/(pi*100^2)}\n"
      "case twist\ndrive flat turn turned\nfix ball.mid turn\nhistory load 1; twist 1\nwant pressure " +
      effort<std::string>("5 %  torque 5", "1 %  torque 0.1") + " %\n";
  const Ran r = run(ball);
  CHECK(r.status == 0);
  const test::Json& torsion = r.json["torsion"];
  const double force = 4 * 1000 / (300 * 0.91), shear = 1000 / 2.6;
  CHECK(torsion["interfaces"][0]["turns_through"].number == doctest::Approx(3 * kCircle / 16 * 0.2 * force).epsilon(2e-3));
  REQUIRE(torsion["borders"].items.size() == 1);
  // The angle at which the stuck circle has the radius c (Lubkin 1951), and the torque: while it shrinks, only the stuck circle
  // turns, as a rigid disc on a half space. The ball is less stiff by 0.3 a/R: 3e-3 (R = 400: 8e-4, R = 1000: 3e-4).
  const auto angle_at = [&](double c) {
    const double k = std::sqrt(1 - c * c);
    return 3 * 0.2 * force / (4 * kCircle * shear) * (std::comp_ellint_1(k) - std::comp_ellint_2(k));
  };
  double torque = 0, c = 1;
  for (constexpr double kStep = 1e-4; angle_at(c - kStep) < 0.001; c -= kStep)
    torque += 16.0 / 3 * shear * std::pow(c - kStep / 2, 3) * (angle_at(c - kStep) - angle_at(c));
  const test::Json& steps = torsion["steps"];
  CHECK(steps[steps.items.size() - 1]["torque"][0].number == doctest::Approx(torque).epsilon(4e-3));
  CHECK(torsion["borders"][0]["at"][0].number == doctest::Approx(c).epsilon(effort(0.04, 0.01)));
  CHECK(r.listing.find("Loads round the axis") != std::string::npos);
}

TEST_CASE("torsion in sketches: shear stress at the surface") {
  const Ran r = run(kBar + "fix bar.base\nmove bar.top turn 0.01\nwant shear bar.side 1 %\nwant angle\n");
  CHECK(r.status == 0);
  bool seen = false;
  for (const test::Json& s : r.json["accuracy"]["stated"].items)
    if (s["name"].text == "largest shear stress on side") {
      seen = true;
      CHECK(s["value"].number == doctest::Approx(1000 * 0.01 / 3).epsilon(1e-9));
    }
  CHECK(seen);
}

TEST_CASE("torsion in sketches: derivatives by parameters, responses of a sweep") {
  // Without friction in the plane of the section pressures do not depend on mu: the torque is proportional to it.
  std::string text = "parameter mu 0.15 +- 0.01\n" + hub("linear", "hub first", "move hub.rim turn 0.005\nwant torque 1 %\n");
  text.replace(text.find("mu 0.15\ninterference"), 7, "mu 0 turn mu");
  text.replace(text.find("tolerance off\n"), 14, "");
  const test::Folder folder;
  test::write_file(folder / "a.c2s", text);
  const test::Result r =
      test::run_shell("'" + paths::program() + "' run -q '" + (folder / "a.c2s") + "' --json '" + (folder / "j") +
                      "' --response 'torque on hub.rim' --results '" + (folder / "r") + "'");
  REQUIRE_MESSAGE(r.status == 0, r.err);
  const test::Json json = test::JsonReader::read(test::read_file(folder / "j"));
  const double through = json["torsion"]["interfaces"][0]["turns_through"].number;
  size_t seen = 0;
  for (const test::Json& number : json["tolerances"]["numbers"].items)
    if (number["name"].text == "torque on hub.rim" || number["name"].text == "torque that turns through bore on seat") {
      ++seen;
      CHECK(number["by"][0]["derivative"].number == doctest::Approx(through / 0.15).epsilon(1e-6));
    }
  CHECK(seen == 2);
  CHECK(std::atof(test::read_file(folder / "r").c_str()) == doctest::Approx(through).epsilon(1e-9));
}

TEST_CASE("torsion in sketches: what is refused") {
  const std::string plane = "body b E 1 nu 0\nfrom 0 0\nline s to 1 0\nline e to 1 1\nline n to 0 1\nline w close\nfix b.s\n";
  const auto refuses = [](const std::string& text, int line, const std::string& words) {
    const Reading reading = read(text);
    REQUIRE_MESSAGE(!reading.faults.empty(), text);
    CHECK(reading.faults[0].at.line == line);
    CHECK(reading.faults[0].at.column > 0);
    CHECK_MESSAGE(reading.faults[0].text.find(words) != std::string::npos, reading.faults[0].text);
  };
  refuses(plane + "traction b.n turn 1\n", 8, "only bodies of revolution turn round an axis");
  refuses(plane + "fix b.n turn\n", 8, "only bodies of revolution turn round an axis");
  refuses("body a E 1 nu 0\nfrom 0 0\nline s to 1 0\nline e to 1 1\nline n to 0 1\nline w close\ncontact a.s a.n turn 0.1\n", 7,
          "only bodies of revolution turn round an axis");
  const std::string bar = kBar + "fix bar.base\n";
  refuses(bar + "case a\ntraction bar.top turn 1\npressure bar.side 1\n", 9, "would share one cone");
  refuses(bar + "traction bar.top turn 1\npressure bar.side 1\n", 8, "one load case has loads in the plane");
  refuses(bar + "case a travel 0 1 positions 8\ntraction bar.top turn 1\n", 9, "expected a case without a course");
  refuses(bar + "move bar.top turn 1\ntraction bar.top turn 1\n", 9, "expected an angle or a traction, not both");
  refuses(bar + "move bar.top turn 1 x 1\n", 8, "expected nothing after the angle");
  refuses(bar + "move bar.top x 1 turn 1\n", 8, "a statement 'move' of its own");
  refuses(bar + "traction bar.top turn 1 fx 1\n", 8, "expected nothing after the traction");
  refuses(bar + "move bar.top.start turn 1\n", 8, "a point is turned, expected curves");
  refuses(bar + "fix bar.top.start turn\n", 8, "a point is kept from turning, expected curves");
  refuses(bar + "platen bar.top turn 1 turn 2\n", 8, "the angle of rotation is given twice");
  refuses(kBar + "fix bar.base y\ntraction bar.top turn 1\n", 8, "nothing keeps body 'bar' from turning");
  refuses(bar + "want torque\n", 8, "no load round an axis");
  refuses(bar + "case a\ntraction bar.top turn 1\ncase b\npressure bar.side 1\nhistory a 1; b 1\n", 9,
          "after loads round the axis");
  refuses(bar + "case a\ntraction bar.top turn 1\ncase b\npressure bar.side 1\nhistory a 1\n", 9, "is never applied");
  refuses(bar + "case b\npressure bar.side 1\ncase a\ntraction bar.top turn 1\nhistory b 1\n", 11, "is never applied");
  const std::string two =
      "axisymmetric\nbody base rigid\nfrom 0 -1\nline low to 2 -1\nline side to 2 0\nline top to 0 0\nbody bar E 1 nu 0\n"
      "from 0 0\nline foot to 1 0\nline side to 1 1\nline top to 0 1\n";
  refuses(two + "contact base.top bar.foot\ntraction bar.side turn 1\n", 13, "a coefficient of friction of its contact ('mu')");
  refuses(two + "contact base.top bar.foot mu 1\nmove base.top turn 1\nmove bar.top turn 2\n", 13,
          "expected 'drive' for its rotation");
  refuses(two + "contact base.top bar.foot turn -1\n", 12, "expected a coefficient of friction, 0 or above");
  // An open contact carries no torque.
  const Ran open = run(two + "contact base.top bar.foot mu 1\nfix bar.side x\ncase p\nmove bar.top y 0\ncase t\ntraction "
                             "bar.side turn 1\nhistory p 1; t 1\n"
                             "tolerance off\n");
  CHECK(open.status == 1);
  CHECK(open.err.find("loads round the axis: no results: a body can turn without resistance") != std::string::npos);
}
