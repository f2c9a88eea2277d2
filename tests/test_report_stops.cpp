// Reports of runs that stop early, or never begin: every output says so, and holds what was reached; and reports of more
// than they have room for.
#include "json.hpp"
#include "paths.hpp"
#include "picture_runs.hpp"
#include "refused_calls.hpp"

#include "post/corner_exponent.hpp"
#include "program/run.hpp"
#include "program/words/voice.hpp"
#include "report/cycle.hpp"
#include "report/history.hpp"

#include <doctest/doctest.h>

using namespace test;

namespace {

struct Outputs {
  Folder folder;
  Shown shown;
  std::string out, err, listing, csv, summary, ranges, boundary, json;
  int status = -1;
};

const char* const kNames[] = {"--listing", "--csv", "--summary", "--ranges", "--boundary", "--json", "--report", "--vtk"};

std::vector<std::string> words_of(const Folder& folder, const std::string& deck) {
  std::vector<std::string> words = {"run", deck, "--no-progress"};
  for (const char* name : kNames) words.insert(words.end(), {name, folder / (name + 2)});
  words.insert(words.end(), {"--figures", folder / "figures"});
  return words;
}

void take(Outputs& o) {
  const auto read = [&](const char* name) { return read_file(o.folder / name); };
  o.listing = read("listing"), o.csv = read("csv"), o.summary = read("summary"), o.ranges = read("ranges");
  o.boundary = read("boundary"), o.json = read("json"), o.shown.page = read("report"), o.shown.vtk = read("vtk");
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(o.folder / "figures", none))
    o.shown.figures[entry.path().stem().string()] = without_mark(read_file(entry.path().string()));
}

void run_all(Outputs& o, const std::string& deck) {
  write_file(o.folder / "deck", deck);
  std::string line = "'" + paths::program() + "'";
  for (const std::string& word : words_of(o.folder, o.folder / "deck")) line += " " + quoted(word);
  const Result result = run_shell(line);
  o.status = result.status, o.out = result.out, o.err = result.err;
  take(o);
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const size_t at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), by);
}

std::string small_hertz() { return run_shell("'" + paths::program() + "' make hertz n=2 L=5 ratio=1.6").out; }

size_t lines(const std::string& text) { return lines_of(text).size(); }

// Nothing was solved: headings, the model, and not one result.
void check_nothing(const Outputs& o, size_t pairs) {
  for (const std::string* table : {&o.csv, &o.summary, &o.ranges, &o.boundary}) CHECK(lines(*table) == 1);
  for (const std::string& name : names_of(o.shown)) CHECK((name == "model" || name == "model_zone"));
  CHECK(names_of(o.shown).count("model") == 1);
  CHECK(contains(o.shown.vtk, "\nPOINTS "));
  CHECK_FALSE(contains(o.shown.vtk, "POINT_DATA"));
  for (const char* never : {"id=\"numbers\"", "id=\"equilibrium\"", "Step by step"})
    CHECK_MESSAGE(!contains(o.shown.page, never), never);
  CHECK(contains(o.shown.page, "id=\"sizes\""));
  for (const char* never : {"Balance of forces", "Energy", "Contact in numbers", "in global components", "Increments"})
    CHECK_MESSAGE(!contains(o.listing, never), never);
  CHECK(contains(o.listing, "Outcome"));
  const Json json = JsonReader::read(o.json);
  CHECK(json["zones"].items.size() == (pairs > 0 ? 1 : 0));
  check_page(o.shown);
}

} // namespace

TEST_CASE("report: a deck that is only checked has its model drawn, and no results") {
  const std::string hertz = replaced(read_file(example("hertz.dat")), "    0    2\n    2    1", "    0   -1\n    2    1");
  const std::string plate = replaced(read_file(example("plate_tension.dat")), "    1    0\n", "    1   -1\n");
  for (const std::string& deck : {hertz, plate}) {
    Outputs o;
    run_all(o, deck);
    CHECK(o.status == 0);
    check_nothing(o, &deck == &hertz ? 15 : contains(deck, "HERTZ") ? 15 : 0);
    CHECK(contains(o.shown.page, "Data check only: the input is in order, nothing was solved."));
    CHECK(contains(o.listing, "data check only: the input is in order, nothing was solved\n"));
    CHECK(JsonReader::read(o.json)["outcome"].text == "checked");
    CHECK(JsonReader::read(o.json)["runs"].items.empty());
    const Result short_one = run_shell("'" + paths::program() + "' run " + quoted(o.folder / "deck"));
    CHECK((short_one.status == 0 && contains(short_one.out, "data check only")));
    CHECK_FALSE(contains(short_one.out, "Contact in numbers"));
  }
}

TEST_CASE("report: equations without a solution: every coefficient has come to nothing") {
  if (!can_refuse_calls()) return;
  for (const char* name : {"hertz.dat", "plate_tension.dat"}) {
    Outputs o;
    std::vector<const char*> argv = {"contact2d"};
    const std::vector<std::string> words = words_of(o.folder, example(name));
    for (const std::string& word : words) argv.push_back(word.c_str());
    app::Options options;
    std::string error;
    REQUIRE(app::read_options(static_cast<int>(argv.size()), argv.data(), options, error));
    {
      const app::Muted muted;
      refuse_call(0);
      REQUIRE(app::run_deck(options) == 0);
      const std::vector<int64_t> calls = calls_of("c2d_prepare");
      REQUIRE(calls.size() == 1);
      fs::remove_all(o.folder / "figures");
      refuse_call(calls.front(), C2D_ERR_SINGULAR);
      CHECK(app::run_deck(options) == 1);
      refuse_call(0);
    }
    take(o);
    const bool contact = std::string(name) == "hertz.dat";
    check_nothing(o, contact ? 15 : 0);
    const Json json = JsonReader::read(o.json);
    CHECK(json["outcome"].text == "singular");
    CHECK(json["runs"].items.size() == (contact ? 2 : 1));
    for (const Json& run : json["runs"].items) CHECK((run["outcome"].text == "singular" && run["step"].number == 0));
    CHECK(json["incomplete"]["loads"].items.size() == 1);
    CHECK(contains(o.shown.page, "<b>not solved</b>: the equations have no unique solution"));
    CHECK(contains(o.listing, "  incomplete: singular at load factor 0, step 0: the equations have no unique solution"));
  }
}

TEST_CASE("report: a picture whose numbers are refused is not left out without a word") {
  if (!can_refuse_calls()) return;
  const Folder folder;
  const std::string deck = example("plate_tension.dat"), page = folder / "page", listing = folder / "listing";
  std::vector<const char*> argv = {"contact2d", "run",        deck.c_str(), "--no-progress",
                                   "--report",  page.c_str(), "--listing",  listing.c_str()};
  app::Options options;
  std::string error;
  REQUIRE(app::read_options(static_cast<int>(argv.size()), argv.data(), options, error));
  const app::Muted muted;
  refuse_call(0);
  REQUIRE(app::run_deck(options) == 0);
  const std::vector<int64_t> calls = calls_to_refuse();
  size_t refused = 0;
  for (const int64_t n : calls) {
    fs::remove(page);
    refuse_call(n);
    const int exit = app::run_deck(options);
    const std::string call = call_refused();
    if (call != "c2d_get" && call != "c2d_get_region") continue;
    CAPTURE(n);
    ++refused;
    CHECK(exit != 0);
    CHECK(!fs::exists(page));
  }
  CHECK(refused > 8);
  refuse_call(0);
}

TEST_CASE("report: a path that ends where it begins has the state it ends in") {
  std::string deck = read_file(example("hertz.dat"));
  std::string freed; // no displacement is held
  for (std::string line : lines_of(deck)) {
    for (const char* held : {" 0100 ", " 0110 ", " 1001 ", " 1000 ", " 0001 ", " 0101 ", " 0010 "})
      if (line.size() > 20 && line.compare(10, 6, held) == 0) line.replace(10, 6, " 0011 ");
    freed += line + "\n";
  }
  Outputs o;
  run_all(o, freed);
  CHECK(o.status == 1);
  CHECK(contains(o.err, "free motion; body 1 can move by (0, -1)"));
  const Json json = JsonReader::read(o.json);
  CHECK(json["outcome"].text == "free motion");
  CHECK((json["incomplete"]["step"].number == 1 && json["incomplete"]["body"].number == 1));
  CHECK(contains(o.shown.page, "<b>incomplete</b>, stopped at load factor 0 in step 1: free motion"));
  CHECK(contains(o.listing, "incomplete: free motion at load factor 0, step 1"));
  CHECK(names_of(o.shown).count("stress") == 1);
  CHECK(names_of(o.shown).count("stress_near") == 0); // nothing touches
  CHECK(names_of(o.shown).count("tractions_1") == 0);
  check_page(o.shown);
}

TEST_CASE("report: of twenty coefficients as many are drawn as can be told apart, and the caption says so") {
  std::string friction = "\n20";
  for (int i = 0; i < 20; ++i) friction += " " + std::to_string(0.02 * i).substr(0, 4);
  Outputs o;
  run_all(o, replaced(small_hertz(), "\n1 0\n", friction + "\n"));
  CHECK(o.status == 0);
  CHECK(contains(caption_of(o.shown, "path"), "; further coefficients are not drawn"));
  CHECK(names_of(o.shown).count("tractions_16") == 1);
  CHECK(names_of(o.shown).count("tractions_17") == 0);
  size_t tables = 0;
  for (size_t at = o.shown.page.find("<details>"); at != std::string::npos; at = o.shown.page.find("<details>", at + 1))
    ++tables;
  CHECK(tables == 16);
  CHECK(JsonReader::read(o.json)["runs"].items.size() == 20);
  CHECK(contains(o.listing, "coefficient of friction .................. 0.38  "));
}

TEST_CASE("report: of more than 400 increments the table has the last 400") {
  Outputs o;
  run_all(o, replaced(small_hertz(), "*PATH\n1 1\n", "*PATH\n410 1\n"));
  CHECK(o.status == 0);
  const size_t table = o.shown.page.find("<details>");
  REQUIRE(table != std::string::npos);
  const size_t end = o.shown.page.find("</table>", table);
  const std::string rows = o.shown.page.substr(table, end - table);
  CHECK_FALSE(contains(rows, "<td>10</td>"));
  CHECK(contains(rows, "<tr><td>11</td>"));
  CHECK(contains(rows, "<tr><td>410</td>"));
}

TEST_CASE("report: titles that are missing, or in letters that mean something in a format; a body with a name") {
  const std::string plate = read_file(example("plate_tension.dat"));
  const std::string title = "PLATE IN TENSION, T = 100, E = 100000, NU = 0.3, PLANE STRESS";
  Outputs none, odd;
  run_all(none, replaced(plate, title, " "));
  CHECK(contains(none.shown.page, "<h1>" + none.folder.path()));
  CHECK(contains(none.shown.vtk, "# vtk DataFile Version 3.0\ncontact2d\n"));
  run_all(odd, replaced(plate, title, "a\t<1> & \"b\"") + "*NAME BODY 1 the <plate>\n");
  CHECK(odd.status == 0);
  CHECK(contains(odd.shown.vtk, "# vtk DataFile Version 3.0\na <1> & \"b\"\n"));
  CHECK(contains(odd.shown.page, "&lt;1&gt;"));
  CHECK(contains(odd.shown.page, "Stress along the boundary of body 1 (the &lt;plate&gt;)"));
  CHECK(JsonReader::read(odd.json)["title"].text == "a <1> & \"b\"");
}

TEST_CASE("report: statuses of a history are kept while there is room, their numbers always") {
  constexpr int32_t kPairs = 1 << 24;
  app::History history;
  history.begin(8);
  const double row[C2D_PAIR_FIELDS] = {}, load = 1;
  c2d_step step = C2D_INIT(c2d_step);
  step.kind = C2D_STEP_RECORDED, step.coefficient = 1, step.cases = 1, step.loads = &load, step.load = 1;
  step.pairs = kPairs, step.table = row, step.stride = 0; // one row for all
  for (step.step = 1; step.step <= 5; ++step.step) {
    step.kind = C2D_STEP_CHANGE;
    history.note(step);
  }
  const std::vector<app::PathPoint>& points = history.coefficients()[0].points;
  REQUIRE(points.size() == 5);
  for (size_t i = 0; i < 5; ++i) {
    CHECK(points[i].status.size() == (i < 4 ? kPairs : 0)); // 2^26 bytes
    CHECK(points[i].count[C2D_OPEN] == kPairs);
  }
}

TEST_CASE("report: loads that go back and never return have no cycle; corners that are not told whole no exponents") {
  const auto path = [](const std::vector<double>& loads) {
    std::vector<app::StepRecord> steps(loads.size());
    for (size_t i = 0; i < loads.size(); ++i) steps[i].loads = {loads[i]};
    return app::find_cycle(steps);
  };
  CHECK_FALSE(path({}).any());
  CHECK_FALSE(path({1}).any());
  const app::Cycle fading = path({1, -0.8, 0.6, -0.4});
  CHECK_FALSE(fading.any());
  CHECK(fading.turns == std::vector<size_t>{1, 2});
  const app::Cycle settled = path({1, -0.8, 0.6, -0.4, 0.6, -0.4});
  CHECK((settled.any() && settled.first == 3 && settled.last == 5));

  app::CornerShape shape;
  CHECK(app::corner_exponents(shape, 1).empty());
  shape.sectors.resize(1);
  CHECK(app::corner_exponents(shape, 1).empty()); // two faces are missing
}
