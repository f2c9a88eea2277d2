// How the mesh of a sketch was found, and what is stated of its numbers: in the listing, the JSON and pictures; messages about
// a deck that is made.
#include "json.hpp"
#include "picture_runs.hpp"
#include "report/listing/listing.hpp"

#include <cmath>
#include <string>

using namespace test;

namespace {

// Half a roller on a plate; wanted loosely, so that few meshes are needed.
const char kRoller[] = "title Roller\nunits mm N\nsymmetry x 0\n"
                       "body plate E 3000 nu 0.4\nfrom 0 -20\nline base to 30 -20\nline side to 30 0\nline top to 0 0\n"
                       "body roller E 210e3 nu 0.3\nfrom 0 0\narc face to 20 20 centre 0 20\nline waist to 0 20\n"
                       "contact plate.top roller.face mu 0.2\nfix plate.base\n"
                       "traction roller.waist y -2.5\n";
const char kLoose[] = "tolerance 10 %\n";

struct Run {
  Folder folder;
  Shown shown;
  std::string listing;
  Json json;
};

void run(Run& out, const std::string& sketch) {
  const std::string name = out.folder / "roller.c2s";
  write_file(name, sketch);
  show(out.shown, name, "--listing " + quoted(out.folder / "l") + " --json " + quoted(out.folder / "j"));
  out.listing = read_file(out.folder / "l");
  const std::string text = read_file(out.folder / "j");
  REQUIRE_MESSAGE(!text.empty(), out.shown.result.err);
  out.json = JsonReader::read(text);
}

const Run& roller() {
  static const Run* const once = [] {
    Run* made = new Run;
    run(*made, std::string(kRoller) + kLoose);
    return made;
  }();
  return *once;
}

size_t count_of(const std::string& text, const std::string& part) {
  size_t out = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++out;
  return out;
}

std::string section(const std::string& listing, const std::string& title) {
  const size_t at = listing.find(title + "\n");
  return at == std::string::npos ? "" : listing.substr(at);
}

} // namespace

TEST_CASE("accuracy: the rounds in the JSON are those of the loop, and one is that of the results") {
  const Run& r = roller();
  CHECK(r.shown.result.status == 0);
  const Json& rounds = r.json["accuracy"]["rounds"];
  REQUIRE(rounds.items.size() >= 2);
  int taken = 0;
  for (size_t i = 0; i < rounds.items.size(); ++i) {
    const Json& round = rounds[i];
    CHECK(round["seconds"].number > 0);
    CHECK(round.has("tractions_change") == round.has("energy_change"));
    if (round.has("tractions_change")) { // the same mesh with every element cut
      REQUIRE(i > 0);
      CHECK(round["elements"].number ==
            doctest::Approx(2 * rounds[i - 1]["elements"].number).epsilon(0.05)); // and what zones cut
      CHECK(round["tractions_change"].number > 0);
    }
    if (round["taken"].kind != Json::kBool || round["taken"].number == 0) continue;
    ++taken;
    CHECK(round["pairs"].number ==
          doctest::Approx(static_cast<double>(last_rows(read_file(r.shown.folder / "c.csv"), 0.2).size())));
  }
  CHECK(taken == 1);
  CHECK(!rounds[0].has("tractions_change"));
}

TEST_CASE("accuracy: stated numbers fit the quantities, their tolerances, and why the loop ended") {
  const Json& accuracy = roller().json["accuracy"];
  bool met = true;
  size_t asked = 0, same = 0;
  for (const Json& s : accuracy["stated"].items) {
    CHECK(s.has("tolerance") == s.has("met"));
    CHECK(s.has("value") == (s["name"].text != "tractions"));
    if (s.has("met")) {
      ++asked;
      CHECK(s["tolerance"].number == doctest::Approx(0.1));
      const bool is_met = s["met"].number != 0;
      if (s["relative_error"].kind == Json::kNumber) CHECK(is_met == (s["relative_error"].number <= 0.1));
      met = met && is_met;
    }
    for (const Json& q : roller().json["runs"][0]["quantities"].items) {
      const double item = s.has("item") ? s["item"].number : 0, zone = s.has("zone") ? s["zone"].number : 0;
      if (q["quantity"].text != s["name"].text || q["zone"].number != zone || q["item"].number != item) continue;
      ++same;
      CHECK(q["value"].number == doctest::Approx(s["value"].number).epsilon(1e-6));
      if (q.has("error")) CHECK(q["error"].number == doctest::Approx(s["error"].number));
    }
  }
  CHECK(asked >= 3);
  CHECK(same >= 3);
  CHECK(met);
  CHECK(accuracy["stopped"].text.empty());
}

TEST_CASE("accuracy: the listing has a row for every mesh and every number") {
  const Run& r = roller();
  const std::string text = section(r.listing, "Accuracy");
  REQUIRE(!text.empty());
  for (const Json& round : r.json["accuracy"]["rounds"].items)
    CHECK(contains(text, " " + std::to_string(static_cast<int>(round["elements"].number)) + " "));
  CHECK(count_of(text, "   taken\n") == 1);
  size_t met = 0;
  for (const Json& s : r.json["accuracy"]["stated"].items) met += s.has("met") && s["met"].number != 0 ? 1 : 0;
  CHECK(count_of(text, "   met\n") == met);
  CHECK(contains(text, "errors are estimates"));
  CHECK(contains(text, "as accurate as was asked"));
}

TEST_CASE("accuracy: a loop that ends too early says why, everywhere") {
  Run r;
  run(r, std::string(kRoller) + "tolerance 0.1 %\nlimit elements 60\n");
  const std::string why = r.json["accuracy"]["stopped"].text;
  CHECK(contains(why, "more than 60 elements"));
  CHECK(contains(section(r.listing, "Accuracy"), why));
  CHECK(contains(r.shown.page, why));
}

TEST_CASE("accuracy: the page has the meshes and their convergence") {
  const Run& r = roller();
  check_page(r.shown);
  REQUIRE(r.shown.figures.count("meshes") == 1);
  REQUIRE(r.shown.figures.count("convergence") == 1);
  const Json& rounds = r.json["accuracy"]["rounds"];
  const std::string meshes = r.shown.figures.at("meshes");
  for (size_t i = 0; i < rounds.items.size(); ++i) {
    const std::string heading =
        "Mesh " + std::to_string(i + 1) + ": " + std::to_string(static_cast<int>(rounds[i]["elements"].number)) + " elements";
    const bool is_shown = i == 0 || rounds[i]["taken"].number != 0;
    CHECK_MESSAGE(contains(meshes, heading) == is_shown, heading);
  }
}

TEST_CASE("accuracy: runs of decks have none of it") {
  Shown shown;
  const Folder folder;
  show(shown, example("hertz.dat"), "--listing " + quoted(folder / "l") + " --json " + quoted(folder / "j"));
  CHECK(!JsonReader::read(read_file(folder / "j")).has("accuracy"));
  CHECK(section(read_file(folder / "l"), "Accuracy").empty());
  CHECK(shown.figures.count("meshes") == 0);
  CHECK(shown.figures.count("convergence") == 0);
}

TEST_CASE("accuracy: a deck with an estimate has its own mesh and the halved one") {
  Shown shown;
  const Folder folder;
  show(shown, example("hertz.dat"), "--estimate --json " + quoted(folder / "j"));
  const Json run = JsonReader::read(read_file(folder / "j"));
  REQUIRE(run.has("accuracy"));
  const Json& rounds = run["accuracy"]["rounds"];
  REQUIRE(rounds.items.size() == 2);
  CHECK(rounds[0]["taken"].number == 1);
  CHECK(rounds[1]["taken"].number == 0);
  CHECK(rounds[1]["elements"].number == doctest::Approx(2 * rounds[0]["elements"].number).epsilon(0.05));
  CHECK(rounds[1].has("tractions_change"));
  for (const Json& s : run["accuracy"]["stated"].items) CHECK(!s.has("met"));
  CHECK(shown.figures.count("meshes") == 0);
}

TEST_CASE("accuracy: messages about a sketch do not quote the deck that is made of it") {
  // The contact reaches the end of its zone, which is a warning of the library.
  const std::string short_plate =
      "title Short\nbody plate E 3000 nu 0.4\nfrom 0 -20\nline base to 30 -20\nline side to 30 0\n"
      "line far to 1 0\nline top to 0 0\nline left close\nbody punch E 3000 nu 0.3\nfrom 0 0\n"
      "line face to 1 0\nline rest to 30 0\nline side to 30 20\nline head to 0 20\nline left close\n"
      "tie plate.top punch.face\nfix plate.base\nplaten punch.head about 0 20 y 0.01 turn 0\n"
      "tolerance off\n";
  const Folder folder;
  const std::string sketch = folder / "short.c2s", deck = folder / "short.dat";
  write_file(sketch, short_plate);
  const std::string program = "'" + paths::program() + "' ";
  const Result drawn = run_shell(program + "run " + quoted(sketch) + " --listing /dev/null");
  REQUIRE(run_shell(program + "mesh " + quoted(sketch) + " -o " + quoted(deck)).status == 0);
  const Result typed = run_shell(program + "run " + quoted(deck) + " --listing /dev/null");
  CHECK_MESSAGE(drawn.status == 0, drawn.err);
  CHECK(!contains(drawn.err, "short.c2s:1")); // as in "short.c2s:12:1"
  CHECK(!contains(drawn.err, "^"));
  CHECK(contains(drawn.err, "short.c2s: warning: "));
  CHECK(contains(typed.err, "short.dat:"));
  CHECK(contains(typed.err, "^"));
  // A fault of the sketch itself has its line.
  write_file(sketch, short_plate + "fix plate.nothing\n");
  CHECK(contains(run_shell(program + "check " + quoted(sketch)).err, "short.c2s:20:"));
}

TEST_CASE("accuracy: ends of platens are no reason to warn in a sketch, those of ties are") {
  const std::string text = "title Tie\nbody plate E 3000 nu 0.4\nfrom 0 -20\nline base to 30 -20\nline side to 30 0\n"
                           "line far to 10 0\nline top to 0 0\nline left close\nfix plate.base\n"
                           "platen plate.top about 5 0 y -0.01 turn 0\ntolerance off\n";
  const Folder folder;
  const std::string sketch = folder / "tie.c2s", deck = folder / "tie.dat";
  write_file(sketch, text);
  const std::string program = "'" + paths::program() + "' ", options = " --listing /dev/null";
  const Result drawn = run_shell(program + "run " + quoted(sketch) + options);
  REQUIRE(run_shell(program + "mesh " + quoted(sketch) + " -o " + quoted(deck)).status == 0);
  const Result typed = run_shell(program + "run " + quoted(deck) + options);
  CHECK(drawn.status == 0);
  CHECK_MESSAGE(!contains(drawn.err, "joins unlike materials"), drawn.err);
  CHECK_MESSAGE(contains(typed.err, "joins unlike materials"), typed.err);
}

TEST_CASE("accuracy: axes of logarithms") {
  app::Range range;
  range.include(3.0), range.include(420.0);
  const app::Axis axis = app::make_log_axis(range, "n");
  CHECK(axis.low == 2.0);
  CHECK(axis.high == doctest::Approx(500.0));
  CHECK(axis.tick(0) == 2.0);
  CHECK(axis.tick(axis.ticks - 1) == doctest::Approx(500.0));
  CHECK(axis.label(1) == "5");
  const app::Chart chart{{0.0, 0.0, 100.0, 100.0}, axis, axis};
  CHECK(chart.at(std::sqrt(2.0 * 500.0), 2.0).x == doctest::Approx(50.0));
  CHECK(chart.at(2.0, 500.0).y == doctest::Approx(0.0));
  app::Range wide;
  wide.include(2e-6), wide.include(0.3);
  const app::Axis decades = app::make_log_axis(wide, "n");
  CHECK(decades.low == doctest::Approx(2e-6));
  CHECK(decades.tick(0) == doctest::Approx(1e-5));
  CHECK(decades.tick(1) == doctest::Approx(1e-4));
  CHECK(decades.label(0) == "10&#8315;&#8309;");
  CHECK(app::make_log_axis(app::Range(), "n").ticks >= 1);
}

// Edges of contact that one of the two meshes has and the other has not.
TEST_CASE("accuracy: an error that cannot be told is no number") {
  const Folder folder;
  const std::string examples = paths::root() + "/examples/", name = folder / "rough.c2s";
  write_file(folder / "rough_profile.csv", read_file(examples + "rough_profile.csv"));
  write_file(name, read_file(examples + "rough_profile.c2s") + "limit elements 200\n");
  const Result out =
      run_shell("'" + paths::program() + "' run " + quoted(name) + " --listing /dev/null --json " + quoted(folder / "j"));
  CHECK(out.status == 5);
  const std::string why = ": its error is unknown, the tolerance is 1 %, a finer mesh would have more than 200 elements";
  const auto line_of_edges = [](const std::string& text) { // of all edges one line: how many, and the place of the worst
    for (const std::string& line : lines_of(text))
      if (contains(line, "contact edge of zone 1, ") && contains(line, " of them, the worst at (")) return line;
    return std::string();
  };
  CHECK_MESSAGE(contains(line_of_edges(out.err), why), out.err);
  CHECK(out.err.find("nan") == std::string::npos);
  CHECK(read_file(folder / "j").find("\"relative_error\": null") != std::string::npos);
  const Result quiet =
      run_shell("'" + paths::program() + "' run -q " + quoted(name) + " --listing /dev/null --json " + quoted(folder / "j"));
  CHECK(quiet.status == 5);
  CHECK_MESSAGE(contains(line_of_edges(quiet.err), why), quiet.err); // under --quiet, too
}
