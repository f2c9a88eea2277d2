// Ranges of stresses over the last cycle of a history.
#include "json.hpp"
#include "paths.hpp"
#include "program/estimate/loop.hpp"
#include "program/estimate/wanted.hpp"
#include "program/sketch/deck/cycle.hpp"
#include "shell.hpp"
#include "sketches.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace sketch;
using namespace sketches;

namespace {

// A square that is pulled: its stress is the load factor of `pull`, everywhere.
const std::string kPulled = std::string(kSquare) + "fix b.s y\nfix b.w x\ncase pull\ntraction b.n y 1\n";
const std::string kOther = "case other\ntraction b.e x 1\n";

int start_of(const std::string& history) { return cycle_start(sound(kPulled + history)); }

// The values that a history leaves, by their names.
std::vector<app::Stated> values_of(const Sketch& s, estimate::Trial& trial) {
  const Mesh mesh = first_mesh(s, 0.5);
  estimate::Demand demand;
  estimate::ask(s, demand);
  std::string why;
  REQUIRE_MESSAGE(estimate::solve(deck_of(s, mesh), demand, trial, why) == C2D_OK, why);
  return estimate::wanted_of(s, mesh, trial);
}

} // namespace

TEST_CASE("cycle: the last one that comes back to the loads of the end") {
  CHECK(start_of("history pull 1, -1, 1\n") == 1);
  CHECK(start_of("history pull 1, -1, 1, -1, 1\n") == 3);
  CHECK(start_of("history pull 1, 2, 1, 1\n") == 1); // a piece in which nothing changes
  CHECK(start_of(kOther + "history other 1; pull 1; other 0, 1; pull 0\n") == 1);
  CHECK(start_of("history pull 0.3, 1, {0.1 + 0.2}\n") == 1); // to round-off
  CHECK(start_of("history pull 1, 0\n") == 0);                // from nothing and back
  CHECK(start_of("history pull 1\n") == 0);
  CHECK(start_of("history pull 1, 1\n") == 0);
  CHECK(start_of(kOther + "history pull 1; other 1; pull 2\n") == 0);
  CHECK(cycle_start(sound(std::string(kSquare) + "fix b.s\ntraction b.n y 1\n")) == 0); // no history
}

TEST_CASE("cycle: statements") {
  const Sketch s = sound(kPulled + "parameter cycle 0.5\nhistory pull 1, -1, 1\nwant cycle range hoop b.e+w 3 % forces\n"
                                   "want cycle range stress at b cycle 0.5 0.25 0.5 2 %  hoop b.n cycle range hoop b.s\n");
  REQUIRE(s.wants.size() == 6);
  const char* const words[] = {"hoop", "forces", "stress", "stress", "hoop", "hoop"};
  const bool cycles[] = {true, false, true, true, false, true};
  for (size_t i = 0; i < 6; ++i) {
    CAPTURE(i);
    CHECK(s.wants[i].word == words[i]);
    CHECK(s.wants[i].cycle == cycles[i]);
  }
  CHECK((s.wants[0].tolerance == 0.03 && s.wants[0].side->has("w")));
  CHECK((s.wants[3].tolerance == 0.02 && s.wants[3].where.x == 0.25 && s.wants[3].where.y == 0.5));
  CHECK(s.points.size() == 2);
}

TEST_CASE("cycle: what is wrong with it is told") {
  const std::string history = kPulled + "history pull 1, -1, 1\n";
  tells(history + "want cycle stress b 0.5 0.5\n", "12:12 'stress': expected range");
  tells(history + "want cycle range pressure\n", "12:18 'pressure': expected stress or hoop");
  tells(history + "want cycle range\n", "12:17 the statement ends here, expected stress or hoop");
  tells(history + "want forces hop b.n\n", "12:13 'hop': expected pressure, edges, forces, approach, dissipation, width, "
                                           "stick, slip, walk, loss, stress, hoop, fatigue or "
                                           "cycle");
  tells(history + "want cycle range hoop b.top\n", "'top', expected 's', 'e', 'n' or 'w'");
  tells(history + "want cycle range stress b 2 0.5\n", "is not inside body 'b'");
  for (const char* none : {"history pull 1\n", "history pull 1, 0\n"})
    tells(kPulled + none + "want cycle range hoop b.n\n", "12:1 the load history has no cycle, expected a history that "
                                                          "returns to the load factors of an earlier piece");
}

// Loads 1, 0.5, 2, 1: over the last cycle from 0.5 to 2, over everything from 0.1, the end of the first step.
TEST_CASE("cycle: the range is that of the steps of the cycle") {
  const Sketch s = sound(kPulled + "history pull 4, 1, 0.5, 2, 1\nwant cycle range stress b 0.5 0.25\nwant stress b 0.5 0.75\n"
                                   "want cycle range hoop b.e\nwant hoop b.e\n");
  estimate::Trial trial;
  const std::vector<app::Stated> values = values_of(s, trial);
  const std::pair<const char*, double> expected[] = {{"displacement x", 0},
                                                     {"displacement y", 0.75},
                                                     {"stress xx", 0},
                                                     {"range of stress xx", 0},
                                                     {"stress yy", 1},
                                                     {"range of stress yy", 3.6},
                                                     {"stress xy", 0},
                                                     {"range of stress xy", 0},
                                                     {"largest stress along e", 4},
                                                     {"smallest stress along e", 0.4},
                                                     {"range of stress along e", 3.6},
                                                     {"cycle range of stress xx", 0},
                                                     {"cycle range of stress yy", 1.5},
                                                     {"cycle range of stress xy", 0},
                                                     {"cycle range of stress along e", 1.5}};
  REQUIRE(values.size() == 15);
  for (size_t i = 0; i < 15; ++i) {
    CAPTURE(i);
    CHECK(values[i].name() == expected[i].first);
    CHECK(std::fabs(values[i].value - expected[i].second) < 1e-9);
    CHECK(values[i].body == 1);
  }
  CHECK(values[1].scale == doctest::Approx(3).epsilon(1e-9));
  CHECK(values[5].scale == doctest::Approx(4).epsilon(1e-9));
  CHECK(values[12].scale == doctest::Approx(2).epsilon(1e-9));
  CHECK((values[12].at[1] == 0.25 && values[14].at[0] == 1));
}

// A block that slides away before the cycle has come back has none; what else is wanted is there.
TEST_CASE("cycle: a history that ends early has none") {
  const Sketch s =
      sound(std::string(kSquare) +
            "copy c of b shift 0 1\nfix b.s\ncontact b.n c.s mu 0.3\ncase press\n"
            "platen c.n about 0.5 2 force 0 -1 turn 0\ncase push\nplaten c.n fx 1\n"
            "history press 1; push 0.1, -0.5, 0.1\nwant cycle range hoop b.e\nwant hoop b.w\nlimit elements 200\n");
  estimate::Trial trial;
  const std::vector<app::Stated> values = values_of(s, trial);
  CHECK(trial.outcome != C2D_REACHED);
  REQUIRE(values.size() == 3);
  for (const app::Stated& value : values) CHECK(value.name().find("cycle") == std::string::npos);
  estimate::Demand demand;
  estimate::ask(s, demand);
  const estimate::Adapted found = estimate::adapt(s, demand, [](const app::MeshRound&) {});
  CHECK(found.loop.stopped.find("the history ended early") != std::string::npos);
  int others = 0;
  for (const app::Stated& value : found.loop.stated) {
    CHECK(value.name().find("cycle") == std::string::npos);
    others += value.name().find("stress along w") != std::string::npos ? 1 : 0;
  }
  CHECK(others == 3);
}

TEST_CASE("cycle: ranges in the listing, the summary and the JSON, with their place and error") {
  const test::Folder folder;
  test::write_file(folder / "a.c2s",
                   kPulled + "history pull 1, -1, 1\nwant cycle range hoop b.e 2 %  cycle range stress b 0.5 0.25 2 %\n");
  const test::Result run =
      test::run_shell("'" + paths::program() + "' run '" + (folder / "a.c2s") + "' --listing '" + (folder / "l") +
                      "' --summary '" + (folder / "s") + "' --json '" + (folder / "j") + "'");
  REQUIRE_MESSAGE(run.status == 0, run.err);
  const std::vector<std::string> rows = test::lines_of(test::read_file(folder / "s"));
  const test::Json json = test::JsonReader::read(test::read_file(folder / "j"));
  int stated = 0;
  for (const test::Json& number : json["accuracy"]["stated"].items) {
    const std::string name = number["name"].text;
    if (!test::contains(name, "cycle range of stress")) continue;
    ++stated;
    CAPTURE(name);
    CHECK(number["met"].number == 1);
    CHECK(number["error"].number <= 0.02);
    if (!test::contains(name, "yy") && !test::contains(name, "along")) continue;
    CHECK(number["value"].number == doctest::Approx(2).epsilon(1e-6));
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const std::string& r) { return test::contains(r, name); });
    REQUIRE(row != rows.end());
    CHECK(row->rfind("0,30,1,,b," + name + ",,2", 0) == 0);
    CHECK(test::contains(test::read_file(folder / "l"), name + "  "));
  }
  CHECK(stated == 4);
  CHECK(test::contains(test::read_file(folder / "l"), "met   at (0.5, 0.25)"));
}

// Cattaneo's contact moved to and fro: the loss of a cycle in closed form (K. L. Johnson, Contact Mechanics, 7.4).
TEST_CASE("cycle: the friction loss of the last cycle is in the CSV summary as in the JSON, and its error holds") {
  const test::Folder folder;
  const test::Result run = test::run_shell("'" + paths::program() + "' run '" + paths::root() +
                                           "/examples/families/mindlin.c2s' drive=1 -q --summary '" + (folder / "s") +
                                           "' --json '" + (folder / "j") + "'");
  REQUIRE_MESSAGE(run.status == 0, run.err);
  const double star = 1000 / 0.91 / 2, P = std::acos(-1.0) / 800 * star, share = 0.6, k = 1 - share;
  const double loss = 4 * 0.09 * P * P / (std::acos(-1.0) * star) * (k * std::log(k) + 1 - k - share * share / 2);
  const std::string name = "dissipated in the last cycle";
  std::vector<std::string> rows;
  for (const std::string& row : test::lines_of(test::read_file(folder / "s")))
    if (test::contains(row, name)) rows.push_back(row);
  REQUIRE(rows.size() == 1);
  double mu = 0, step = 0, load = 0, value = 0, error = 0;
  REQUIRE(std::sscanf(rows[0].c_str(), ("%lf,%lf,%lf,0,," + name + ",,%lf,,,%lf,,").c_str(), &mu, &step, &load, &value,
                      &error) == 5);
  CHECK(std::fabs(value - loss) <= error / 0.8);
  CHECK(error < 0.05 * loss);
  int stated = 0;
  const test::Json json = test::JsonReader::read(test::read_file(folder / "j"));
  for (const test::Json& number : json["accuracy"]["stated"].items) {
    if (number["name"].text != name) continue;
    ++stated;
    CHECK(number["value"].number == doctest::Approx(value).epsilon(1e-9));
    CHECK(number["error"].number == doctest::Approx(error).epsilon(1e-9));
  }
  CHECK(stated == 1);
}

// At the end of it nothing is left of the contact but round-off: no pressure, and no edges where one could be sought.
TEST_CASE("cycle: a contact that its history unloads meets its tolerance, without edges") {
  const test::Folder folder;
  for (const char* modulus : {"200e3", "70e3"}) { // like and unlike bodies
    const std::string text = "title Pressed and let go\nparameter R 50 w 10 h {R - sqrt(R^2 - w^2)}\n"
                             "body block E 200e3 nu 0.3\n from -30 -30\n line bottom to 30 -30\n line right to 30 0\n"
                             " line top to -30 0\n line left close\nbody pad E " +
                             std::string(modulus) +
                             " nu 0.3\n from {-w} h\n arc face to w h radius R\n line right to w 20\n line top to {-w} 20\n"
                             " line left close\ncontact block.top pad.face mu 0.6\ncase normal\n fix block.bottom\n"
                             " platen pad.top about 0 20 force 0 -200 turn 0\nhistory normal 1, 0\n"
                             "want pressure edges forces approach\n";
    test::write_file(folder / "s.c2s", text);
    const test::Result run =
        test::run_shell("'" + paths::program() + "' run '" + (folder / "s.c2s") + "' -q --json '" + (folder / "j") + "'");
    CHECK_MESSAGE(run.status == 0, run.err);
    const test::Json json = test::JsonReader::read(test::read_file(folder / "j"));
    CHECK(json["accuracy"]["rounds"].items.size() <= 10);
    int pressures = 0;
    for (const test::Json& number : json["accuracy"]["stated"].items) {
      CHECK_FALSE(test::contains(number["name"].text, "edge"));
      CHECK_FALSE(test::contains(number["name"].text, "width"));
      if (number["name"].text != "peak pressure") continue;
      ++pressures;
      CHECK(number["value"].number < 1e-6); // (1000 under the load)
      CHECK(number["error"].number < 1e-2);
    }
    CHECK(pressures == 1);
  }
}
