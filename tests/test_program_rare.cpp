// Rare turns of the program's files, outputs and sweeps: what the system refuses late, names that are none, rows without a
// place.
#include "paths.hpp"
#include "program_options.hpp"
#include "refused_calls.hpp"
#include "shell.hpp"
#include "system_calls.hpp"

#include "program/exit_code.hpp"
#include "program/files/figure_folder.hpp"
#include "program/files/path_record.hpp"
#include "program/files/sealed_file.hpp"
#include "program/files/system_file.hpp"
#include "program/outputs/outputs.hpp"
#include "program/run.hpp"
#include "program/sweep/answer.hpp"
#include "program/sweep/journal.hpp"
#include "program/sweep/parameters.hpp"
#include "program/sweep/responses.hpp"
#include "program/sweep/sweep.hpp"
#include "program/words/voice.hpp"

#include <cerrno>
#include <cmath>
#include <doctest/doctest.h>

using namespace test;

namespace {

const std::string& sample() {
  static const std::string name = paths::data() + "/decks/sample.dat";
  return name;
}

struct Ran {
  int exit;
  std::string reason;
};
Ran run(const std::vector<std::string>& words) {
  const app::Muted muted;
  app::forget_reason();
  const app::Options options = options_of(words);
  const int exit = options.command == app::Command::kSweep ? app::sweep_table(options) : app::run_deck(options);
  return {exit, app::reason_told()};
}

// A deck with a parameter.
std::string parametric(const Folder& folder) {
  std::string deck = run_shell("'" + paths::program() + "' make hertz n=8").out;
  const size_t at = deck.find("*PATH\n1 1\n");
  REQUIRE(at != std::string::npos);
  write_file(folder / "d.dat", deck.replace(at, 10, "*PATH\n1 {load=1}\n"));
  return folder / "d.dat";
}

} // namespace

TEST_CASE("rare, files: a record of another model is not read, whichever of its lists it is") {
  app::Summary model;
  model.pairs = 2, model.zones = 1, model.bodies = 2, model.load_cases = 1;
  const auto is_read = [&](app::PathRecord& record) {
    app::PathRecord back;
    return app::read_path_record(app::text_of(record), model, back);
  };
  app::PathRecord sound;
  sound.coefficients.resize(1);
  sound.coefficients[0].cycles.resize(2);
  for (app::CycleSeen& c : sound.coefficients[0].cycles) c.zones.resize(1);
  CHECK(is_read(sound));
  app::PathRecord wrong = sound;
  wrong.coefficients[0].cycles[0].zones.resize(2);
  CHECK_FALSE(is_read(wrong));
  wrong = sound;
  wrong.coefficients[0].table.resize(3);
  CHECK_FALSE(is_read(wrong));
  wrong = sound;
  wrong.coefficients[0].loads.resize(2);
  CHECK_FALSE(is_read(wrong));
}

TEST_CASE("rare, files: standard files that cannot be opened, sealed files that cannot be removed") {
  if (!can_judge_calls()) return;
  for (const char* name : {"open", "open64"}) {
    const System full(name, [] { return EMFILE; });
    app::open_standard_files(); // leaves it at that
    CHECK(full.calls() <= 1);
  }
  const Folder folder;
  std::string error, text;
  REQUIRE(app::write_sealed(folder / "s", "kind", "text", error));
  {
    const System refused("unlink", 1, EACCES);
    CHECK_FALSE(app::remove_file(folder / "s", error));
    CHECK(error == folder / "s" + ": cannot be removed: Permission denied");
  }
  CHECK(app::remove_file(folder / "s", error));
  CHECK(app::remove_file(folder / "s", error)); // that it is gone is no failure
  for (const char* name : {"fstat", "fstat64"}) {
    write_file(folder / "named", "abc");
    const System refused(name, [] { return EIO; });
    CHECK(app::read_named(folder / "named", text) ==
          (refused.calls() > 0 && text.empty() ? "cannot be read: Input/output error" : ""));
  }
}

TEST_CASE("rare, files: pictures of an earlier run go, others stay, and what is refused is said") {
  if (!can_judge_calls()) return;
  const Folder folder;
  const std::string figures = folder / "f";
  std::string error;
  const auto write = [&](const char* name, bool keeps) {
    app::FigureFolder f;
    REQUIRE_MESSAGE(f.open(figures, error), error);
    REQUIRE_MESSAGE(f.add(name, "<svg/>\n", error), error);
    REQUIRE_MESSAGE(app::publish_all(f.files(), error), error);
    if (!keeps) return std::string();
    const bool removed = f.remove_earlier(error) && f.keep(error);
    return removed ? std::string() : error;
  };
  fs::create_directory(figures);
  CHECK(write("old.svg", true) == "");
  write_file(figures + "/a", ""), write_file(figures + "/b.svg", "of somebody else"), write_file(figures + "/note.txt", "");
  {
    const System refused("opendir", 1, EACCES);
    CHECK(write("new.svg", true) == figures + ": cannot be read: Permission denied");
  }
  CHECK(fs::exists(figures + "/old.svg"));
  {
    const System refused("unlink", [&] { return fs::exists(figures + "/old.svg") ? EACCES : int(kDone); });
    CHECK(contains(write("new.svg", true), "old.svg: cannot be removed: Permission denied"));
  }
  CHECK(write("new.svg", true) == "");
  CHECK_FALSE(fs::exists(figures + "/old.svg"));
  for (const char* stays : {"/a", "/b.svg", "/note.txt", "/new.svg"}) CHECK(fs::exists(figures + stays));
}

TEST_CASE("rare, sweep: outcomes, rows and results where there is no file beside them") {
  app::Answer answer;
  answer.exit = app::kExitInaccurate;
  CHECK(app::outcome_of(answer) == "a requested tolerance is not met");
  answer.exit = app::kExitSolved;
  CHECK(app::outcome_of(answer) == "ok");
  answer.exit = app::kExitInput, answer.reason = "no such card";
  CHECK(contains(app::outcome_of(answer), "no such card"));
  const Folder folder;
  CHECK(run({"run", sample(), "-q", "--response", "load", "--results", "/dev/null", "--row", "/dev/null"}).exit == 0);
  CHECK_FALSE(fs::exists("/dev/null.inputs"));
  const std::string deck = parametric(folder);
  write_file(folder / "t", "load\n0.5\n1\n"), write_file(folder / "none", "load\n");
  CHECK(run({"sweep", folder / "none", deck, "--response", "load", "--results", folder / "r"}).exit == 2);
  CHECK_FALSE(fs::exists(folder / "r"));
  if (!can_judge_calls()) return;
  // Its inputs are written last.
  const Ran whole = run({"sweep", folder / "t", deck, "--response", "load", "--results", folder / "r"});
  CHECK(whole.exit == 0);
  const std::string rows = read_file(folder / "r");
  int refused = 0;
  for (int n = 1; n < 12; ++n) {
    for (const std::string& name : folder.names())
      if (name.compare(0, 1, "r") == 0) fs::remove(folder / name);
    const System system("rename", n, EACCES);
    const Ran ran = run({"sweep", folder / "t", deck, "--response", "load", "--results", folder / "r"});
    if (system.calls() < n) break;
    ++refused;
    CHECK(ran.exit == 3);
    CHECK(contains(ran.reason, "Permission denied"));
    if (fs::exists(folder / "r")) CHECK(read_file(folder / "r") == rows);
  }
  CHECK(refused >= 2);
}

TEST_CASE("rare, sweep: what names no number of a run, a line that is no row, a deck without parameters") {
  std::vector<app::Response> none;
  std::string error;
  for (const char* words : {"", " ", "2"}) {
    error.clear();
    CHECK_FALSE(app::read_responses(words, none, error));
  }
  std::string deck = read_file(sample());
  std::vector<app::DeckFault> faults;
  CHECK_FALSE(app::put_parameters(deck, {{"load", "2"}}, faults));
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].text == "the deck has no parameter load: expected {load} in a card");
  faults.clear(), deck = "{load=1}\n";
  CHECK_FALSE(app::put_parameters(deck, {{"laod", "2"}}, faults));
  CHECK(contains(faults.at(0).text, "load"));
  const Folder folder;
  {
    app::Journal journal;
    REQUIRE(journal.open(folder / "rows", 5, false, error) == 0);
    CHECK(journal.add(3, "three", error));
  }
  for (const char* line : {"x\n", "4\n", "99999999999999999999999 0123456789abcdef a\n", "\n"}) {
    write_file(folder / "more", read_file(folder / "rows") + line);
    app::Journal journal;
    REQUIRE(journal.open(folder / "more", 5, true, error) == 0);
    CHECK(journal.rows().size() == 1);
    fs::remove(folder / "more");
  }
  // Derivatives of one of two zones, by number.
  app::RunRecord record;
  record.meshes.tolerances.parameters = {{"R", 5, 0.5, ""}};
  for (const int32_t zone : {1, 2})
    for (const int32_t item : {1, 2}) {
      app::Stated s;
      s.what = app::Measure::kContactEdge, s.zone = zone, s.item = item;
      record.meshes.tolerances.numbers.push_back(app::Toleranced{s, {{10.0 * zone + item, ""}}});
    }
  const auto value = [&](const char* words) {
    CAPTURE(words);
    std::vector<app::Response> responses;
    std::string fault;
    REQUIRE_MESSAGE(app::read_responses(words, responses, fault), fault);
    return app::evaluate(responses.at(0), record);
  };
  CHECK(std::isnan(value("SWT of top 0"))); // they count from 1
  CHECK(value("derivative contact edge by R") == 11);
  CHECK(value("derivative contact edge 2 by R") == 12);
  CHECK(value("derivative contact edge zone 2 2 by R") == 22);
  CHECK(std::isnan(value("derivative contact edge zone 2 3 by R")));
}

TEST_CASE("rare, outputs: points of an earlier run are written anew, a listing and late files that cannot be") {
  const Folder folder;
  const std::string out = folder / "out", points = out + "/interior.csv";
  REQUIRE(run({"run", sample(), "-q", "--no-progress", "--out", out}).exit == 0);
  write_file(points, "x,y\n1,2\n"); // not points of a run
  CHECK(run({"run", sample(), "-q", "--no-progress", "--out", out}).exit == 0);
  CHECK(read_file(points) == "x,y\n1,2\n");
}

TEST_CASE("rare, run: a full device, sizes of tapes that are refused, a state saved within a cycle") {
  const Folder folder;
  const Ran full = run({"run", sample(), "-q", "--no-progress", "--csv", "/dev/full"});
  CHECK(full.exit == 3);
  CHECK(contains(full.reason, "No space left on device"));
  // A sketch with a cycle, kept at every step: the same numbers as without a store.
  write_file(folder / "s.c2s",
             "body block E {1-(2/7)^2} nu {2/7}\nfrom -1 -2\nline bottom to 1 -2\nline right to 1 0\nline top to -1 0\n"
             "line left close\nbody cylinder rigid\nfrom -0.3 {1-sqrt(0.91)}\narc face to 0.3 {1-sqrt(0.91)} radius 1\n"
             "line right to 0.3 0.5\nline above to -0.3 0.5\nline left close\ncontact block.top cylinder.face mu 0.3\n"
             "case normal\nplaten block.bottom about 0 -2 fx 0 fy {pi/400} turn 0\nhistory normal 1\n"
             "cycle normal 1, 0.4, 1 until steady\nsteps 1\ntolerance off\n");
  const Ran plain = run({"run", folder / "s.c2s", "-q", "--no-progress", "--csv", folder / "a"});
  const Ran kept = run({"run", folder / "s.c2s", "-q", "--no-progress", "--csv", folder / "b", "--store",
                        "file:" + (folder / "t"), "--keep", "--save-every", "0"});
  CHECK(plain.exit == kept.exit);
  CHECK(read_file(folder / "a") == read_file(folder / "b"));
  CHECK(read_file(folder / "a") != "");
  if (!can_refuse_calls()) return;
  // The bounds of tapes only choose where tapes go.
  const std::vector<std::string> words = {"run",        sample(),        "-q",        "--no-progress", "--csv",
                                          folder / "c", "--elimination", "compressed"};
  refuse_call(0);
  CHECK(run(words).exit == 0);
  const std::string whole = read_file(folder / "c");
  const std::vector<int64_t> sizes = calls_of("c2d_tape_need");
  CHECK(!sizes.empty());
  for (const int64_t n : sizes) {
    CAPTURE(n);
    fs::remove(folder / "c");
    refuse_call(n);
    const Ran ran = run(words);
    CHECK((ran.exit == 0 ? read_file(folder / "c") == whole : !ran.reason.empty()));
  }
  refuse_call(0);
}
