// Every call of the library that report and program make is refused, one after the other: the run fails and says why, and no
// output has its name.
#include "paths.hpp"
#include "program_options.hpp"
#include "refused_calls.hpp"
#include "shell.hpp"

#include "program/run.hpp"
#include "program/words/voice.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <iterator>

using namespace test;

namespace {

// A picture is drawn without a curve's bound, a length told without what lies beyond its end, a listing without the deck's
// headings; zones and bodies are counted up to the first refused. An estimate that comes to nothing says so, and the run goes
// on.
bool may_be_missing(const std::string& call) {
  static const char* const kCalls[] = {"c2d_get_friction", "c2d_get_condition", "c2d_walk_deck", "c2d_get_zone_state",
                                       "c2d_get_body_state"};
  return std::count(std::begin(kCalls), std::end(kCalls), call) > 0;
}
void every_call_refused(const std::string& deck, bool estimates = false) {
  CAPTURE(deck);
  const Folder folder;
  const std::string out = folder / "out";
  std::vector<std::string> words = {
      "run",           deck, "--no-progress", "--out", out, "--vtk", folder / "v.vtk", "--trace", folder / "t.csv", "--ranges",
      folder / "r.csv"};
  if (estimates) words = {"run", deck, "--no-progress", "--csv", out, "--estimate"};
  const app::Options options = options_of(words);
  const app::Muted muted;
  refuse_call(0);
  REQUIRE(app::run_deck(options) == 0);
  const size_t outputs = folder.names().size();
  CHECK(outputs == (estimates ? 2 : 7)); // beside each table, and the VTK file, its inputs
  const std::vector<int64_t> calls = calls_to_refuse();
  CHECK(calls.size() > 60);
  for (const int64_t n : calls) {
    for (const std::string& gone : folder.names()) fs::remove_all(folder / gone);
    refuse_call(n);
    const int exit = app::run_deck(options);
    const std::string call = call_refused();
    CAPTURE(n);
    CAPTURE(call);
    REQUIRE(!call.empty());
    CHECK((exit != 0 || estimates || may_be_missing(call)));
    CHECK(folder.names().size() == (exit == 0 ? outputs : 0));
    CHECK((exit == 0) == app::reason_told().empty());
  }
  refuse_call(0);
}

std::string made(const Folder& folder, const std::string& words, const std::string& cards = "") {
  const std::string name = folder / "deck.dat";
  const Result deck = run_shell("'" + paths::program() + "' make " + words);
  REQUIRE(deck.status == 0);
  std::string text; // cards of a test take the place of names and path
  const std::vector<std::string> lines = lines_of(deck.out);
  for (size_t i = 0; i < lines.size(); ++i) {
    const bool names = lines[i].compare(0, 5, "*NAME") == 0, path = lines[i] == "*PATH";
    if (cards.empty() || !(names || path)) text += lines[i] + "\n";
    i += !cards.empty() && path ? 1 : 0;
  }
  write_file(name, text + cards);
  return name;
}

} // namespace

TEST_CASE("refused calls: none of a run's is taken for done") {
  if (!can_refuse_calls()) return;
  const Folder folder;
  every_call_refused(paths::data() + "/decks/sample.dat");
  every_call_refused(made(folder, "crack n=10 ratio=2 order=1"));
  every_call_refused(made(folder, "stack n=1"));
  every_call_refused(
      made(folder, "hertz n=2 L=5 ratio=1.6", "*CASES 2\ncase 2\nload 1 1 -1 0 -0.001\n*BODY FORCE 1 2 0 0 1e-6 0 0\n"));
  every_call_refused(made(folder, "hertz n=2 L=5 ratio=1.6",
                          "*NAME BODY 1 block\n*NAME ZONE 1 face\n*CURVE ARC 2 11 16 0 100 100\n*BODY FORCE 1 1 0 -0.001\n"
                          "*POINTS\nGRID 1 0 -2 1 -1 3 3\n"),
                     true);
}

TEST_CASE("refused calls: each number of a table, wherever it is asked for") {
  if (!can_refuse_calls()) return;
  const Folder folder;
  const std::string out = folder / "out";
  const app::Muted muted;
  const std::string decks[] = {made(folder, "hertz n=2 L=5 ratio=1.6"), paths::root() + "/examples/plate_tension.dat"};
  for (const std::string& deck : decks)
    for (const char* table : {"--boundary", "--ranges", "--listing", "--vtk"}) {
      CAPTURE(deck);
      CAPTURE(table);
      const app::Options options = options_of({"run", deck, "--no-progress", table, out});
      refuse_call(0);
      REQUIRE(app::run_deck(options) == 0);
      const std::vector<int64_t> numbers = calls_of("c2d_get");
      CHECK(numbers.size() > 1);
      for (const int64_t n : numbers) {
        CAPTURE(n);
        fs::remove(out);
        refuse_call(n);
        CHECK(app::run_deck(options) != 0);
        CHECK(std::string(call_refused()) == "c2d_get");
        CHECK_FALSE(fs::exists(out));
        CHECK_FALSE(app::reason_told().empty());
      }
      fs::remove(out);
    }
  refuse_call(0);
}
