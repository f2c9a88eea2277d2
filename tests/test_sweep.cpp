// Many runs: parameters of decks, numbers that are asked for, rows that are appended, sweeps over tables.
#include "paths.hpp"
#include "shell.hpp"

#include "program/sweep/answer.hpp"
#include "program/sweep/journal.hpp"
#include "program/sweep/parameters.hpp"
#include "program/sweep/responses.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <sstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace test;
namespace fs = std::filesystem;

namespace {

const std::string kExamples = paths::root() + "/examples/", kRoller = "'" + kExamples + "roller.c2s' ";

Result contact2d(const std::string& arguments) { return run_shell("'" + paths::program() + "' " + arguments); }

std::vector<std::string> filled(const std::string& deck, const std::vector<app::Setting>& settings,
                                std::string* out = nullptr) {
  std::string text = deck;
  std::vector<app::DeckFault> faults;
  const bool sound = app::put_parameters(text, settings, faults);
  CHECK(sound == faults.empty());
  if (out != nullptr) *out = text;
  std::vector<std::string> told;
  for (const app::DeckFault& f : faults)
    told.push_back(std::to_string(f.line) + ":" + std::to_string(f.column) + "-" + std::to_string(f.column_end) + ": " +
                   f.text);
  return told;
}

std::string filled_well(const std::string& deck, const std::vector<app::Setting>& settings) {
  std::string out;
  const std::vector<std::string> faults = filled(deck, settings, &out);
  CHECK_MESSAGE(faults.empty(), (faults.empty() ? "" : faults[0]));
  return out;
}

// A family's deck with a parameter in it: the number of increments.
std::string hertz_deck() {
  std::string deck = contact2d("make hertz n=8").out;
  const size_t at = deck.find("*PATH\n1 1\n");
  REQUIRE(at != std::string::npos);
  return deck.replace(at, 10, "*PATH\n{steps=2} {load}\n");
}

std::vector<std::string> columns_of(const std::string& row) {
  std::vector<std::string> out;
  std::istringstream in(row);
  for (std::string field; std::getline(in, field, ',');) out.push_back(field);
  return out;
}

} // namespace

TEST_CASE("sweep: a parameter keeps the columns of a fixed deck, and what has no room is told") {
  CHECK(filled_well("   1{mu=0.25}  7\n", {}) == "   1     0.25  7\n");
  CHECK(filled_well("   1{mu}  7\n", {{"mu", "12"}}) == "   1  12  7\n");
  CHECK(filled_well("      {mu}  7", {{"mu", "0.123456"}}) == "  0.123456  7");                 // it takes the blanks before it
  CHECK(filled_well("{a}{b}\n{a}\n", {{"a", "1"}, {"b", "2"}, {"a", "3"}}) == "  3  2\n  3\n"); // the last one counts
  CHECK(filled("   1{mu}  7\n", {{"mu", "0.123456"}}) ==
        std::vector<std::string>{
            "1:5-8: the value 0.123456 of mu has 8 characters, but there is room for 4: add blanks before the braces"});
  CHECK(filled("x\n {mu} {nu}\n", {}) == std::vector<std::string>{"2:2-5: {mu} has no value, expected --set mu=VALUE",
                                                                  "2:7-10: {nu} has no value, expected --set nu=VALUE"});
  CHECK(filled("x\n", {{"mu", "1"}}) ==
        std::vector<std::string>{"0:0-0: the deck has no parameter mu: expected {mu} in a card"});
  CHECK(filled_well("C {mu}\n{}{ a}{1}{a b}{a=}\n{", {}) == "C {mu}\n{}{ a}{1}{a b}{a=}\n{"); // a comment, and none of ours
  CHECK(filled_well("*free\n! {a}\n{a} {b=long}\n", {{"a", "0.123456"}}) == "*free\n! {a}\n0.123456 long\n");
  // braces in braces; columns are those of the deck as it is read
  CHECK(filled("*free\n{a={x=1}0} 2 {y}\n", {}) ==
        std::vector<std::string>{"2:4-8: {x} is inside other braces, expected one name and one value in each pair of braces",
                                 "2:14-16: {y} has no value, expected --set y=VALUE"});
  CHECK(filled("*free\n{k{i=2}}\n", {}).size() == 1);
  CHECK(filled_well("*free\n{a {x=1}} {\n", {}) == "*free\n{a 1} {\n"); // (no parameter with a blank in it)
  CHECK(filled("{a}\n", {{"a", "123456"}}).size() == 1);                // no blanks before it
  CHECK(filled_well("\n\n  {_a}", {{"_a", "1"}}) == "\n\n     1");
  CHECK(filled_well("", {}) == "");
  app::Setting setting;
  CHECK(app::read_setting("_a1=x", setting));
  for (const char* wrong : {"a", "=1", "a=", "a=\x7f", "a=1}", "a={", "1a=2", "a b=2", "a=1 2"})
    CHECK_FALSE(app::read_setting(wrong, setting));
}

TEST_CASE("sweep: files of parameters, plain and of Dakota") {
  using Words = std::vector<std::string>;
  const auto read = [](const std::string& text, std::string& error) {
    Words words;
    error.clear();
    app::read_parameters(text, words, error);
    return words;
  };
  std::string error;
  CHECK(read("mu = 0.3\n\n nu 0.25 # what\n{ E = 2e5 }\r\n", error) == Words{"mu=0.3", "nu=0.25", "E=2e5"});
  CHECK(error == "");
  CHECK(read("    2 variables\n 3.0e-01 mu\n 2.5 load\n 1 functions\n 1 ASV_1:f\n", error) == Words{"mu=3.0e-01", "load=2.5"});
  CHECK(error == "");
  CHECK(read("{ DAKOTA_VARS = 1 }\n{ mu = 3.0e-01 }\n{ DAKOTA_FNS = 1 }\n", error) == Words{"mu=3.0e-01"});
  CHECK(error == "");
  read("mu = 0.3\nnu\n", error);
  CHECK(error == "line 2: expected the name of a parameter and its value");
  read("2mu = 0.3\n", error);
  CHECK(contains(error, "line 1"));
  read("3 variables\n1 a\n", error);
  CHECK(error == "ends before the last variable");
  CHECK(read("", error).empty());
  CHECK(error == "");
  for (const char* wrong : {"nu\n", "{\n", "{mu = 1\n", "2 variable\n", "mu =\n", "mu\n"}) {
    CHECK(read(wrong, error).empty());
    CHECK(contains(error, "line 1: expected the name of a parameter and its value"));
  }
}

TEST_CASE("sweep: numbers that are asked for are those of the CSV, the summary and the points") {
  const Folder folder;
  write_file(folder / "points", "1,1,-3\n2,1,5\n1,0,50\n");
  const Result run =
      contact2d("run -q " + kRoller + "--csv '" + (folder / "c") + "' --summary '" + (folder / "s") + "' --interior '" +
                (folder / "i") + "' --points '" + (folder / "points") + "' --results '" + (folder / "r") +
                "' --response 'max tn; min gap;slip; peak pressure; contact edge 1 zone 1; force y;touching; "
                "sticking; slipping; stress 2; sxx 1; sxx 3; contact edge 7; load'");
  REQUIRE_MESSAGE(run.status == 0, run.err);
  double tn = -1e300, gap = 1e300, slip = 0;
  int touching = 0, sticking = 0;
  const std::vector<std::string> rows = lines_of(read_file(folder / "c"));
  const std::string last = columns_of(rows.back())[1];
  for (const std::string& row : rows) {
    const std::vector<std::string> c = columns_of(row);
    if (c[1] != last) continue;
    tn = std::max(tn, std::stod(c[7])), gap = std::min(gap, std::stod(c[13])),
    slip = std::max(slip, std::fabs(std::stod(c[14])));
    touching += c[6] != "open", sticking += c[6] == "stick";
  }
  REQUIRE(sticking > 0);
  REQUIRE(touching > sticking);
  std::vector<double> values;
  std::vector<std::string> words;
  for (const std::string& line : lines_of(read_file(folder / "r"))) {
    words.push_back(line.substr(line.find(' ') + 1));
    values.push_back(std::stod(line));
  }
  REQUIRE(values.size() == 14);
  CHECK(words[2] == "slip");
  CHECK(words[4] == "contact edge 1 zone 1");
  CHECK(values[0] == doctest::Approx(tn));
  CHECK(values[1] == doctest::Approx(gap));
  CHECK(values[2] == doctest::Approx(slip));
  CHECK(values[6] == touching);
  CHECK(values[7] == sticking);
  CHECK(values[8] == touching - sticking);
  const auto summed_up = [&](const std::string& quantity) {
    for (const std::string& row : lines_of(read_file(folder / "s"))) {
      const std::vector<std::string> c = columns_of(row);
      if (c[5] == quantity && c[3] == "1" && c[1] == last) return std::stod(c[7]);
    }
    return std::nan("");
  };
  CHECK(values[3] == doctest::Approx(summed_up("peak pressure")));
  CHECK(values[4] == doctest::Approx(summed_up("contact edge")));
  CHECK(values[5] == doctest::Approx(summed_up("force y")));
  const std::vector<std::string> inside = lines_of(read_file(folder / "i"));
  CHECK(values[9] == doctest::Approx(std::stod(columns_of(inside[2])[9])));
  CHECK(values[10] == doctest::Approx(std::stod(columns_of(inside[1])[5])));
  CHECK(std::isnan(values[11])); // outside
  CHECK(std::isnan(values[12])); // there is one edge
  CHECK(values[13] == 1.0);
  for (const char* wrong : {"max", "tn 3", "max peak pressure", "stress", "load 2", "touching 3", "zone 1", "", " ; "}) {
    std::vector<app::Response> responses;
    std::string error;
    CHECK_MESSAGE(!app::read_responses(wrong, responses, error), wrong);
    CHECK(contains(error, "expected max or min of tn"));
  }
}

TEST_CASE("sweep: misspelt requested numbers are answered by what may be meant") {
  struct {
    const char *wrong, *answer;
  } const cases[] = {{"peak presure", "'peak presure', did you mean 'peak pressure'?"},
                     {"load; Contact Egde 2 X zone 3", "'Contact Egde 2 X zone 3', did you mean 'contact edge 2 x zone 3'?"},
                     {"max tm", "'max tm', did you mean 'max tn'?"},
                     {"peak pressure zne 2", "'peak pressure zne 2', did you mean 'peak pressure zone 2'?"},
                     {"stres 3", "'stres 3', did you mean 'stress 3'?"},
                     {"touchin", "'touchin', did you mean 'touching'?"},
                     {"forcey", "'forcey', did you mean 'force y'?"},
                     {"presure", "'presure', did you mean 'peak pressure', 'mean pressure' or 'edge pressure'?"},
                     {"qqqqqq", "'qqqqqq': expected max or min of tn"}};
  for (const auto& c : cases) {
    std::vector<app::Response> responses;
    std::string error;
    CHECK_MESSAGE(!app::read_responses(c.wrong, responses, error), c.wrong);
    CHECK_MESSAGE(error.rfind(c.answer, 0) == 0, error);
  }
}

TEST_CASE("sweep: results say FAIL and why whatever failed, and rows of many jobs are whole") {
  const Folder folder;
  write_file(folder / "deck", hertz_deck());
  const std::string deck = "run -q '" + (folder / "deck") + "' ",
                    to = " --response 'max tn' --results '" + (folder / "r") + "' ";
  const auto failed = [&](const std::string& arguments, int status, const std::string& why) {
    fs::remove(folder / "r");
    CHECK_MESSAGE(contact2d(arguments).status == status, arguments);
    const std::string text = read_file(folder / "r");
    CHECK_MESSAGE(contains(text, "FAIL "), text);
    CHECK_MESSAGE(contains(text, why), text);
    CHECK(lines_of(text).size() == 1);
  };
  failed(deck + to, 2, "{load} has no value");
  failed(deck + to + "load=x", 2, "expected a number");
  failed(deck + to + "load=1 --memory 1K", 4, "too small");
  failed(deck + to + "load=1 --csv /nowhere/c", 3, "cannot be written");
  failed(deck + to + "load=1 --params /nowhere/p", 2, "No such file");
  failed(deck + to + "load=1 --nonsense", 64, "takes no option");
  failed("run -q '" + (folder / "none") + "'" + to, 2, "");
  CHECK(contact2d(deck + to + "load=1 --keep").status == 0);
  CHECK(contains(read_file(folder / "r"), " max tn\n"));
  CHECK(contact2d(deck + "load=1 --results '" + (folder / "r") + "'").status == 64);
  CHECK(contact2d(deck + "load=1 --response 'max tn'").status == 64);
  for (const char* more : {"load=1 ", "load=1 --nonsense ", "load=x --row x --row "})
    CHECK(contact2d(deck + more + "--response 'max tn' --results '" + (folder / "deck") + "'").status == 64);
  CHECK(contact2d("run --response load --results '" + (folder / "deck") + "' --nonsense '" + (folder / "deck") + "'").status ==
        64);
  CHECK(read_file(folder / "deck") == hertz_deck()); // it is no place for results

  const std::string rows = folder / "rows.csv", row = " --response 'max tn' --row '" + rows + "' ";
  std::string jobs;
  for (int i = 1; i <= 12; ++i) jobs += "'" + paths::program() + "' " + deck + row + "load=0." + std::to_string(i) + " & ";
  CHECK(run_shell(jobs + "wait").status == 0);
  CHECK(contact2d(deck + row + "load=x").status == 2);
  const std::vector<std::string> lines = lines_of(read_file(rows));
  REQUIRE(lines.size() == 14);
  CHECK(lines[0] == "outcome,load,max tn");
  for (size_t i = 1; i < 13; ++i) CHECK_MESSAGE(lines[i].compare(0, 5, "ok,0.") == 0, lines[i]);
  CHECK(contains(lines[13], "FAIL"));
  CHECK(contact2d(deck + " --response 'min tn' --row '" + rows + "' load=1").status == 3);
  CHECK(lines_of(read_file(rows)).size() == 14);
  CHECK(contact2d(deck + " --response 'min tn' --row /nowhere/r load=1").status == 3);
}

TEST_CASE("sweep: a row for each row, the same bytes with any threads, and rows that fail stop nothing") {
  const Folder folder;
  write_file(folder / "deck", hertz_deck());
  write_file(folder / "table", "\xef\xbb\xbfload, steps\n1,1\n0.5,1\nx,1\n\n2,2\n0.25,3\n");
  const std::string sweep = "sweep '" + (folder / "table") + "' '" + (folder / "deck") + "' --response 'max tn; touching' ";
  const Result one = contact2d(sweep + "--threads 1"), many = contact2d(sweep + "--threads 4");
  REQUIRE_MESSAGE(one.status == 0, one.err);
  CHECK(one.out == many.out);
  CHECK(one.err == "");
  const std::vector<std::string> lines = lines_of(one.out);
  REQUIRE(lines.size() == 6);
  CHECK(lines[0] == "row,load,steps,max tn,touching,outcome");
  CHECK(contains(lines[3], "3,x,1,,,\"FAIL "));
  CHECK(contains(lines[3], "expected a number"));
  const auto value = [&](size_t row) { return columns_of(lines[row])[3]; };
  for (const size_t row : {1u, 2u, 4u, 5u}) {
    const std::vector<std::string> c = columns_of(lines[row]);
    const Result alone =
        contact2d("run -q '" + (folder / "deck") + "' load=" + c[1] + " steps=" + c[2] + " --response 'max tn' --results -");
    CHECK(alone.out == c[3] + " max tn\n");
    CHECK(c[5] == "ok");
  }
  CHECK(std::stod(value(4)) > std::stod(value(1)));
  CHECK(contains(contact2d(sweep + "--threads 2 --progress").err, "5 of 5 rows, 1 failed"));
  // A row that takes its time (the program stands still for a while) tells how long the others may take, and at the end
  // nothing.
  write_file(folder / "P", "P\n50\n");
  const Result waited =
      run_shell("{ '" + paths::program() + "' sweep '" + (folder / "P") + "' " + kRoller +
                "--response load --progress & }; sleep 0.1; kill -STOP $!; sleep 1.1; kill -CONT $!; wait $!");
  CHECK_MESSAGE(waited.status == 0, waited.err);
  CHECK_MESSAGE(contains(waited.err, "1 of 1 rows\n"), waited.err);
  // of a sketch
  write_file(folder / "mu", "mu\n0\n0.3\n");
  const Result sketch = contact2d("sweep '" + (folder / "mu") + "' " + kRoller + "--response 'sticking' P=50");
  REQUIRE_MESSAGE(sketch.status == 0, sketch.err);
  CHECK(contains(sketch.out, "\n1,0,0,ok\n"));
  CHECK(std::stod(columns_of(lines_of(sketch.out)[2])[2]) > 0);
}

TEST_CASE("sweep: killed anywhere and resumed it writes the same table") {
  const Folder folder;
  write_file(folder / "deck", hertz_deck());
  std::string table = "load\n";
  for (int i = 1; i <= 60; ++i) table += std::to_string(0.01 * i) + "\n";
  write_file(folder / "table", table);
  const std::string sweep = "sweep '" + (folder / "table") + "' '" + (folder / "deck") +
                            "' --response 'max tn' --threads 2 --results '",
                    whole = folder / "whole", out = folder / "out", rows = out + ".rows";
  REQUIRE(contact2d(sweep + whole + "'").status == 0);
  CHECK_FALSE(fs::exists(whole + ".rows"));
  for (int round = 0; round < 4; ++round) { // killed when so many rows are there
    fs::remove(out);
    const std::string resume = round > 0 && fs::exists(rows) ? " --resume" : "";
    const size_t before = fs::exists(rows) ? lines_of(read_file(rows)).size() : 0;
    const pid_t child = ::fork();
    if (child == 0) {
      ::setpgid(0, 0);
      ::execl("/bin/sh", "sh", "-c", ("exec '" + paths::program() + "' " + sweep + out + "'" + resume).c_str(),
              static_cast<char*>(nullptr));
      ::_exit(127);
    }
    const size_t enough = std::max(3 + 12 * static_cast<size_t>(round), before + 1); // and it has begun
    for (int wait = 0; wait < 5000 && (!fs::exists(rows) || lines_of(read_file(rows)).size() < enough) && !fs::exists(out);
         ++wait)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ::kill(child, round % 2 == 0 ? SIGKILL : SIGTERM);
    int status = 0;
    ::waitpid(child, &status, 0);
    if (round % 2 == 1 && !fs::exists(out)) CHECK((WIFEXITED(status) && WEXITSTATUS(status) == 143)); // it can go on
  }
  if (!fs::exists(out)) {
    CHECK(contains(contact2d(sweep + out + "'").err, "expected --resume"));
    write_file(rows, read_file(rows) + "57 0123456789abcdef torn");       // no line that a kill cut off is a row
    CHECK(contact2d(sweep + out + "' --memory 1M --resume").status == 2); // of other inputs
    REQUIRE(contact2d(sweep + out + "' --resume").status == 0);
  }
  CHECK(read_file(out) == read_file(whole));
  CHECK_FALSE(fs::exists(rows));
}

TEST_CASE("sweep: a journal takes whole lines of its own sweep, and belongs to one process") {
  const Folder folder;
  const std::string path = folder / "rows";
  std::string error;
  {
    app::Journal journal;
    REQUIRE(journal.open(path, 5, false, error) == 0);
    CHECK(journal.add(3, "three", error));
    CHECK(journal.add(0, "", error));
    app::Journal other;
    CHECK(other.open(path, 5, true, error) == 75);
    CHECK(contains(error, "another process"));
  }
  const std::string kept = read_file(path);
  for (size_t at = 0; at < kept.size(); ++at) { // every byte flipped: a row is there as it was, or not at all
    std::string flipped = kept;
    flipped[at] = static_cast<char>(flipped[at] ^ 1);
    write_file(path, flipped);
    app::Journal journal;
    const int exit = journal.open(path, 5, true, error);
    CHECK((exit == 0 || exit == 2));
    for (const auto& [row, text] : journal.rows()) CHECK_MESSAGE((row == 3 ? text == "three" : row == 0 && text.empty()), at);
  }
  for (size_t cut = 0; cut <= kept.size(); ++cut) {
    write_file(path, kept.substr(0, cut));
    app::Journal journal;
    REQUIRE(journal.open(path, 5, true, error) == 0);
    CHECK(journal.rows().size() == (cut + 1 >= kept.size() ? 2u : cut >= kept.find("three") + 5 ? 1u : 0u));
    CHECK(journal.add(7, "seven", error));
    app::Journal again;
    CHECK(again.open(path, 5, true, error) == 75);
  }
  app::Journal last;
  REQUIRE(last.open(path, 5, true, error) == 0);
  CHECK(last.rows().at(7) == "seven");
  CHECK(app::Journal().open("/nowhere/rows", 5, true, error) == 3);
}

TEST_CASE("sweep: faults of a table have their places") {
  const Folder folder;
  write_file(folder / "deck", hertz_deck());
  const auto told = [&](const std::string& table, const std::string& expected) {
    write_file(folder / "table", table);
    const Result result = contact2d("sweep '" + (folder / "table") + "' '" + (folder / "deck") + "' --response 'max tn'");
    CHECK(result.status == 2);
    CHECK_MESSAGE(contains(result.err, expected), result.err);
    CHECK(result.out == "");
  };
  told("load\n", "no rows, expected a heading");
  told("load,2x\n1,2\n", ":1:6: error: '2x': expected the name of a parameter");
  told("load,load\n1,2\n", ":1:6: error: load is the name of two columns");
  told("load, nope,steps\n1,2,3\n", ":1:7: error: no parameter nope, expected one of load steps");
  told("load,steps\n1\n1,2,3\n", ":2:1: error: 1 values, expected 2");
  told("load,steps\n1,a b\n", ":2:3: error: 'a b': expected a value without blanks");
  const Result sketch = contact2d("sweep '" + (folder / "table") + "' " + kRoller + "--response 'max tn'");
  CHECK(sketch.status == 2);
  CHECK_MESSAGE(contains(sketch.err, ":1:1: error: no parameter load, expected one of P R mu"), sketch.err);
  const Result none = contact2d("sweep '" + (folder / "table") + "' '" + kExamples + "hertz.dat' --response 'max tn'");
  CHECK_MESSAGE(contains(none.err, ":1:1: error: no parameter load\n"), none.err);
  const Result setting = contact2d("sweep '" + (folder / "table") + "' '" + (folder / "deck") + "' --response 'max tn' nope=1");
  CHECK(setting.status == 64);
  CHECK_MESSAGE(contains(setting.err, "deck: no parameter nope, expected one of load steps\n"), setting.err);
  CHECK(contact2d("sweep t d").status == 64);
  CHECK(contact2d("sweep t").status == 64);
  CHECK(contact2d("sweep t d --response 'max tn' --resume").status == 2); // no such table
  write_file(folder / "table", "load\n1\n");
  {
    app::Journal other; // of a process that is at it
    std::string error;
    REQUIRE(other.open(folder / "o.rows", 0, false, error) == 0);
    const std::string sweep = "sweep '" + (folder / "table") + "' '" + (folder / "deck") + "' --response 'max tn' --results '" +
                              (folder / "o") + "' --resume";
    const Result busy = contact2d(sweep);
    CHECK(busy.status == 75);
    CHECK(contains(busy.err, "o.rows: another process is running this sweep"));
    other.remove();
  }
  const std::string results = "sweep '" + (folder / "table") + "' '" + (folder / "deck") + "' --response 'max tn' --results ";
  fs::create_directory(folder / "d");
  const Result directory = contact2d(results + "'" + (folder / "d") + "'");
  CHECK(directory.status == 3);
  CHECK_MESSAGE(contains(directory.err, "/d: cannot be written: "), directory.err);
  CHECK_FALSE(fs::exists(folder / "d.rows")); // nothing has been solved
  CHECK(contact2d(results + "/dev/null").status == 0);
  CHECK_FALSE(fs::exists("/dev/null.rows"));
  CHECK(contact2d(results + "/dev/null --resume").status == 64);
  CHECK(contact2d("sweep '" + (folder / "table") + "' '" + (folder / "deck") + "' --response 'max tn' --resume").status == 64);
  CHECK(contact2d("sweep '" + (folder / "table") + "' '" + (folder / "none") + "' --response 'max tn'").status == 2);
}
