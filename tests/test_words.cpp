// The words of the command line: help, quiet runs, one folder for all outputs, what a terminal shows, completions, progress.
#include "paths.hpp"
#include "shell.hpp"

#include "program/option_table.hpp"
#include "program/progress.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <vector>

using namespace test;

namespace {

const std::string kExamples = paths::root() + "/examples/", kDeck = "'" + kExamples + "hertz.dat' ";

Result contact2d(const std::string& arguments) { return run_shell("'" + paths::program() + "' " + arguments); }

// What the command writes to a terminal; its two streams are one there.
Result on_terminal(const std::string& before, const std::string& arguments) {
  const Folder folder;
  write_file(folder / "go", before + " '" + paths::program() + "' " + arguments + "\n");
  return run_shell("script -qec 'sh " + (folder / "go") + "' /dev/null </dev/null");
}

std::set<std::string> names_in(const std::string& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

std::set<std::string> options_in(const std::string& text) {
  std::set<std::string> found;
  const std::regex option("^  (-[a-z], )?(--[a-z-]+)");
  for (const std::string& line : lines_of(text)) {
    std::smatch match;
    if (std::regex_search(line, match, option)) found.insert(match[2]);
  }
  return found;
}

std::set<std::string> options_of(const app::CommandRow& command) {
  std::set<std::string> names;
  for (const app::OptionRow& option : app::all_options())
    if ((option.commands & app::bit_of(command.command)) != 0) names.insert(option.name);
  return names;
}

} // namespace

TEST_CASE("words: help of a command has its options and no others, and every way to ask for it says the same") {
  for (const app::CommandRow& command : app::all_commands()) {
    if (command.command == app::Command::kHelp) continue;
    const Result asked = contact2d(std::string("help ") + command.name);
    INFO(command.name);
    CHECK(asked.status == 0);
    CHECK(contains(asked.out, std::string("usage: contact2d ") + command.name + " "));
    CHECK(options_in(asked.out) == options_of(command));
    for (const char* way : {" --help", " -h"}) CHECK(contact2d(command.name + std::string(way)).out == asked.out);
    for (const std::string& line : lines_of(asked.out)) CHECK_MESSAGE(line.size() <= 120, line);
  }
  CHECK(contact2d("run " + kDeck + "--help").out == contact2d("help run").out);
  CHECK(contact2d("help").out == contact2d("--help").out);
  CHECK(contact2d("-h").out == contact2d("--help").out);
  CHECK(contact2d("-V").out == contact2d("--version").out);
  const Result family = contact2d("make hertz --help");
  CHECK(family.status == 0);
  CHECK(contains(family.out, "n="));
  CHECK(contact2d("help walk").status == 64);
  CHECK(contact2d("run -x " + kDeck).status == 64);
}

TEST_CASE("words: a quiet run writes the same files, and nothing on a terminal but errors") {
  const Folder folder;
  const auto to = [&folder](const char* name) { return " --csv '" + (folder / name) + "'"; };
  const Result loud = contact2d("run " + kDeck + to("a")), quiet = contact2d("run -q " + kDeck + to("b"));
  CHECK(contains(loud.err, "warning:"));
  CHECK(contains(loud.out, "Balance of forces"));
  CHECK(quiet.status == 0);
  CHECK(quiet.out + quiet.err == "");
  CHECK(read_file(folder / "a") == read_file(folder / "b"));
  CHECK(contains(contact2d("run --quiet --listing - " + kDeck).out, "Balance of forces"));
  CHECK(contact2d("check -q " + kDeck).out == "");
  write_file(folder / "bad", "no deck\n");
  for (const char* command : {"run -q '", "check -q '"}) {
    const Result wrong = contact2d(command + (folder / "bad") + "'");
    CHECK(wrong.status == 2);
    CHECK(contains(wrong.err, "error:"));
  }
}

TEST_CASE("words: several decks are checked one after another, and the first fault gives the exit status") {
  const Folder folder;
  write_file(folder / "bad", "no deck\n");
  const std::string roller = "'" + kExamples + "roller.dat' ", bad = "'" + (folder / "bad") + "' ";
  const Result both = contact2d("check " + kDeck + roller);
  CHECK(both.status == 0);
  CHECK(both.out == contact2d("check " + kDeck).out + "\n" + contact2d("check " + roller).out);
  const Result mixed = contact2d("check " + kDeck + bad + roller);
  CHECK(mixed.status == 2);
  CHECK(contains(mixed.out, "roller.dat"));
  CHECK(contains(mixed.err, (folder / "bad") + ":1:"));
}

TEST_CASE("words: --out puts every output into one folder, as each alone would be") {
  const Folder folder;
  const std::string all = folder / "all";
  const Result run = contact2d("run " + kDeck + "--out '" + all + "' --csv '" + (folder / "mine.csv") + "'");
  REQUIRE_MESSAGE(run.status == 0, run.err);
  CHECK(run.out == "");
  std::set<std::string> names;
  for (const char* name :
       {"listing.txt", "boundary.csv", "run.json", "report.html", "boundary.vtk", "trace.csv", "bodies.csv", "summary.csv",
        "figures", "boundary.csv.inputs", "trace.csv.inputs", "bodies.csv.inputs", "summary.csv.inputs", "boundary.vtk.inputs"})
    names.insert(name);
  CHECK(names_in(all) == names); // no points, no interior.csv
  CHECK(read_file(folder / "mine.csv").size() > 1000);
  CHECK(read_file(all + "/trace.csv") == contact2d("run " + kDeck + "--trace -").out);
  CHECK(read_file(all + "/boundary.csv") == contact2d("run " + kDeck + "--boundary -").out);
  CHECK(names_in(all + "/figures").size() > 5);

  write_file(folder / "points", "2,0,-3\n");
  const Result inside = contact2d("run " + kDeck + "--out '" + all + "' --points '" + (folder / "points") + "'");
  CHECK_MESSAGE(inside.status == 0, inside.err);
  CHECK(lines_of(read_file(all + "/interior.csv")).size() == 2);

  write_file(folder / "bad", "no deck\n");
  CHECK(contact2d("run '" + (folder / "bad") + "' --out '" + (folder / "none") + "'").status == 2);
  CHECK(contact2d("run " + kDeck + "--memory 1K --out '" + (folder / "none") + "'").status == 4);
  CHECK(names_in(folder.path()).count("none") == 0);
  CHECK(contact2d("run " + kDeck + "--out '" + (folder / "bad") + "'").status == 3); // a file
}

TEST_CASE("words: a terminal that asked for no listing sees what answers the question, in colours if it likes") {
  if (!has_command("script")) return;
  const Result end = on_terminal("TERM=xterm", "run " + kDeck);
  CHECK(end.status == 0);
  CHECK(lines_of(end.out).size() < 60);
  for (const char* part : {"peak pressure", "Outcome", "--listing FILE writes the complete listing"})
    CHECK_MESSAGE(contains(end.out, part), part);
  CHECK_FALSE(contains(end.out, "Balance of forces"));
  CHECK(contains(end.out, "\033[1;35mwarning:"));
  CHECK(contains(on_terminal("TERM=xterm", "run --listing - " + kDeck).out, "Balance of forces"));
  const Folder folder;
  write_file(folder / "bad", "no deck\n");
  const std::string bad = "run '" + (folder / "bad") + "'";
  CHECK(contains(on_terminal("TERM=xterm", bad).out, "\033[1;31merror:"));
  for (const char* plain : {"TERM=xterm NO_COLOR=1", "TERM=dumb", "env -u TERM"})
    CHECK_FALSE(contains(on_terminal(plain, bad).out, "\033[1"));
  CHECK(contains(on_terminal("TERM=xterm NO_COLOR=", bad).out, "\033[1;31merror:"));
  CHECK_FALSE(contains(contact2d(bad).err, "\033"));
}

TEST_CASE("words: every shell completes every command and option") {
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    const Result script = contact2d("completion " + shell);
    CHECK(script.status == 0);
    for (const app::CommandRow& command : app::all_commands()) CHECK(contains(script.out, command.name));
    for (const app::OptionRow& option : app::all_options()) CHECK_MESSAGE(contains(script.out, option.name + 2), option.name);
    if (!has_command(shell.c_str())) continue;
    const Folder folder;
    write_file(folder / "script", script.out);
    CHECK_MESSAGE(run_shell(shell + " -n '" + (folder / "script") + "'").err == "", shell);
  }
  CHECK(contact2d("completion").status == 64);
  CHECK(contact2d("completion ksh").status == 64);
  if (!has_command("bash")) return;
  const auto completed = [](const std::string& words, int at) {
    const Folder folder;
    write_file(folder / "go", "cd '" + paths::root() + "'\neval \"$('" + paths::program() +
                                  "' completion bash)\"\nCOMP_WORDS=(" + words + ") COMP_CWORD=" + std::to_string(at) +
                                  "\n_contact2d\necho \"${COMPREPLY[@]}\"\n");
    return run_shell("bash '" + (folder / "go") + "'").out;
  };
  CHECK(completed("contact2d m", 1) == "mesh make\n");
  CHECK(completed("contact2d exampl", 1) == "examples\n"); // a file in place of a command
  CHECK(completed("contact2d run --st", 2) == "--stresses --stepping --store\n");
  CHECK(completed("contact2d run --stepping ''", 3) == "events deck\n");
  CHECK(completed("contact2d check --st", 2) == "\n");
  CHECK(completed("contact2d make her", 2) == "hertz\n");
}

TEST_CASE("words: progress never goes back, and the bodies count by their work") {
  app::WorkDone work;
  work.expect({2000, 1000}, 4, 2);
  c2d_progress now = C2D_INIT(c2d_progress);
  double before = 0.0;
  const auto shown = [&](int32_t phase, int32_t body, int64_t done, int64_t total) {
    now.phase = phase, now.body = body, now.done = done, now.total = total;
    const double share = work.share(now);
    CHECK(share >= before);
    CHECK(share <= 1.0);
    return before = share;
  };
  CHECK(shown(C2D_PHASE_ASSEMBLE, 1, 1000, 2000) > 0.3);
  shown(C2D_PHASE_ASSEMBLE, 1, 2000, 2000);
  shown(C2D_PHASE_ELIMINATE, 1, 10, 2000);
  const double first = shown(C2D_PHASE_ELIMINATE, 1, 2000, 2000);
  CHECK(first > 0.75); // four times the entries
  CHECK(first < 0.9);
  shown(C2D_PHASE_ASSEMBLE, 2, 500, 1000);
  CHECK(shown(C2D_PHASE_ELIMINATE, 2, 1000, 1000) == doctest::Approx(1.0));
  CHECK(shown(C2D_PHASE_REDUCE, 0, 0, 0) == 1.0);
  before = 0.0;
  now.load = 0.0, now.target = 1.0;
  CHECK(shown(C2D_PHASE_CONTACT, 0, 1, 0) == 0.0);
  now.load = 0.5;
  CHECK(shown(C2D_PHASE_CONTACT, 0, 2, 0) == doctest::Approx(0.5 / 8));
  work.reached(1, 1, 1.0);
  now.load = 0.75, now.target = 0.5; // down again
  CHECK(shown(C2D_PHASE_CONTACT, 0, 3, 0) == doctest::Approx(1.5 / 8));
  work.reached(1, 4, 0.5);
  now.load = 0.0, now.target = 1.0;
  CHECK(shown(C2D_PHASE_CONTACT, 0, 4, 0) == doctest::Approx(0.5));
  CHECK(work.coefficient() == 2);
  CHECK(app::duration_text(0.2) == "1 s");
  CHECK(app::duration_text(89.5) == "90 s");
  CHECK(app::duration_text(100) == "2 min");
  CHECK(app::duration_text(7000) == "2 h");
}

TEST_CASE("words: the line of progress of a run counts up to the end of the path") {
  const Folder folder;
  const Result made = contact2d("make hertz n=150 > '" + (folder / "deck") + "'");
  REQUIRE(made.status == 0);
  const Result run = contact2d("run '" + (folder / "deck") + "' --listing /dev/null --progress");
  REQUIRE(run.status == 0);
  std::vector<int> percents;
  const std::regex percent("following the load, increment [0-9]+ of [0-9]+: ([0-9]+) %");
  for (std::sregex_iterator i(run.err.begin(), run.err.end(), percent), end; i != end; ++i)
    percents.push_back(std::stoi((*i)[1]));
  REQUIRE(!percents.empty());
  CHECK(std::is_sorted(percents.begin(), percents.end()));
}
