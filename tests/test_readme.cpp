// The pages keep their word: their C programs compile and run, the files and names they mention exist, every option,
// exit status, key of the summary and keyword stands on its page, the picture is what the program draws.
#include "contact2d.h"
#include "json.hpp"
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <regex>
#include <set>

using namespace test;

namespace {

const std::string kRoot = paths::root();

std::string page(const std::string& name) { return read_file(kRoot + "/" + name); }

// All pages, by their names from the root.
std::vector<std::string> pages() {
  std::vector<std::string> out = {"README.md"};
  for (const char* folder : {"src", "include", "port", "examples", "tests"})
    for (const auto& entry : fs::recursive_directory_iterator(kRoot + "/" + folder))
      if (entry.path().extension() == ".md") out.push_back(fs::relative(entry.path(), kRoot).generic_string());
  return out;
}

// The blocks of a page fenced as this language.
std::vector<std::string> blocks(const std::string& text, const std::string& language) {
  std::vector<std::string> out;
  bool inside = false;
  for (const std::string& line : lines_of(text)) {
    if (inside && line == "```")
      inside = false;
    else if (inside)
      out.back() += line + "\n";
    else if (line == "```" + language)
      inside = true, out.emplace_back();
  }
  return out;
}

// What stands between single backquotes in the text outside the fenced blocks.
std::set<std::string> quoted_words(const std::string& text) {
  std::set<std::string> out;
  bool inside = false;
  for (const std::string& line : lines_of(text)) {
    if (line.compare(0, 3, "```") == 0) inside = !inside;
    if (inside) continue;
    for (size_t open = line.find('`'), close; open != std::string::npos; open = line.find('`', close)) {
      close = line.find('`', open + 1);
      if (close == std::string::npos) break;
      if (close > open + 1) out.insert(line.substr(open + 1, close - open - 1)), ++close;
    }
  }
  return out;
}

// Compiles a C program with this command; "" or what the compiler said. A library with a sanitizer in it
// needs that one's run-time: then nothing is linked.
std::string compile(const std::string& compiler, const std::string& source, const std::string& out) {
  const std::string rest = paths::sanitized() ? " -c" : " -x none '" + paths::library() + "' -lm";
  const Result result = run_shell(compiler + " -Wall -Wextra -Wpedantic -Werror -I'" + kRoot + "/include' -I'" + kRoot +
                                  "/port/memory' '" + source + "'" + rest + " -o '" + out + "'");
  return result.status == 0 ? "" : result.err + "(failed)";
}

const std::string kAsC = paths::c_compiler() + " -std=c99 -x c", kAsCpp = paths::cxx_compiler() + " -std=c++17 -x c++";

// What `run` prints, a row per step, and the page on the program of 1987 says of it: two coefficients of friction, 28
// increments each. The last pressure is near the 213.0 of the program of 1987, which lost 0.3 % of the load.
void check_sample(const Result& run) {
  CHECK_MESSAGE(run.status == 0, run.out << run.err);
  const std::vector<std::string> rows = lines_of(run.out);
  REQUIRE(rows.size() == 56);
  double mu = 0, load = 0, pressure = 0;
  REQUIRE(std::sscanf(rows[27].c_str(), "mu %lf load %lf pressure at the centre %lf", &mu, &load, &pressure) == 3);
  CHECK(mu == 0.4);
  CHECK(load == 1.03);
  CHECK(contains(page("src/FROM-1987.md"), "contact2d finds " + std::to_string(pressure).substr(0, 5) + " "));
  CHECK(std::fabs(pressure - 213.0) < 0.003 * 213.0);
}

// All numbers of a text, in order.
std::vector<double> numbers_of(const std::string& text) {
  std::vector<double> out;
  const std::regex number("-?[0-9]+\\.?[0-9]*(e-?[0-9]+)?");
  for (std::sregex_iterator i(text.begin(), text.end(), number), end; i != end; ++i) out.push_back(std::stod(i->str()));
  return out;
}

void add_keys(const Json& value, std::set<std::string>& keys) {
  for (const auto& member : value.members) {
    keys.insert(member.first);
    add_keys(member.second, keys);
  }
  for (const Json& item : value.items) add_keys(item, keys);
}

} // namespace

TEST_CASE("pages: the C programs compile as C99 and as C++ and run") {
  const std::vector<std::string> programs = blocks(page("include/README.md"), "c");
  REQUIRE(programs.size() == 2);
  for (const std::string& program : programs)
    for (const std::string& compiler : {kAsC, kAsCpp}) {
      const Folder folder;
      write_file(folder / "example.c", program);
      REQUIRE(compile(compiler, folder / "example.c", folder / "example") == "");
      if (paths::sanitized()) continue;
      const Result run = run_shell("cd '" + kRoot + "' && '" + (folder / "example") + "'");
      if (program == programs[0])
        check_sample(run);
      else // two squares: half of a pressure of 1, uniform in both
        CHECK_MESSAGE(run.out == "pressure 0.500000, stress at (1, 1) -0.500000\n", run.out << run.err);
      CHECK(run.status == 0);
    }
}

// A number of the table of the README's first problem: value, error, formula of Hertz, difference in percent.
void check_first_number(const std::string& text, const std::string& name, double value, double error, double exact) {
  CAPTURE(name);
  const size_t at = text.find("| " + name + " |");
  REQUIRE(at != std::string::npos);
  double told[4] = {};
  REQUIRE(std::sscanf(text.c_str() + at + name.size() + 4, " %lf +- %lf | %lf | %lf %%", told, told + 1, told + 2, told + 3) ==
          4);
  CHECK(std::fabs(value - told[0]) < 0.1 * told[1]);
  CHECK(std::fabs(error - told[1]) < 0.5 * told[1]); // another compiler may lead to another mesh
  CHECK(std::fabs(exact - told[2]) < 1e-5 * exact);
  CHECK(std::fabs(100 * std::fabs(told[0] / told[2] - 1) - told[3]) < 0.005);
  CHECK(std::fabs(told[0] - exact) < told[1]);
}

TEST_CASE("pages: the README is two screens, and its first problem is so") {
  const std::string text = page("README.md");
  CHECK(lines_of(text).size() <= 110);
  CHECK(contains(text, "```\n" + page("examples/tutorial/t1_roller.c2s") + "```\n"));
  const Folder folder;
  const Result run =
      run_shell("'" + paths::program() + "' run '" + kRoot +
                "/examples/tutorial/t1_roller.c2s' --no-progress --listing /dev/null --json '" + (folder / "j") + "'");
  CHECK(run.status == 0);
  CHECK_MESSAGE(run.err == "", run.err);
  double peak[2] = {}, edge[2] = {};
  const Json json = JsonReader::read(read_file(folder / "j")); // (its items live as long as it)
  for (const Json& q : json["runs"][0]["quantities"].items) {
    const std::string name = q["quantity"].text;
    if (name == "peak pressure") peak[0] = q["value"].number, peak[1] = q["error"].number;
    if (name == "contact edge") edge[0] = q["x"].number, edge[1] = q["error"].number;
  }
  const double a = std::sqrt(4 * 200 * 5 / (std::acos(-1.0) * 206e3 / (2 * 0.91))), p0 = 2 * 200 / (std::acos(-1.0) * a);
  check_first_number(text, "peak pressure, MPa", peak[0], peak[1], p0);
  check_first_number(text, "x where the contact ends, mm", edge[0], edge[1], a);
  // The end of `make demo`.
  char told[120];
  std::snprintf(told, sizeof told, "Hertz: peak pressure %.2f MPa, contact up to x = %.6f mm", p0, a);
  CHECK(contains(page("Makefile"), told));
}

TEST_CASE("pages: the files they name exist, and every example has its line") {
  int seen = 0;
  for (const std::string& name : pages()) {
    CAPTURE(name);
    for (const std::string& word : quoted_words(page(name))) {
      if (!std::regex_match(word, std::regex("(src|port|examples|include|tests|\\.ci)/[a-z0-9_./]*"))) continue;
      ++seen;
      CHECK_MESSAGE(fs::exists(kRoot + "/" + word), word);
    }
  }
  CHECK(seen > 100);
  const std::set<std::string> words = quoted_words(page("examples/README.md"));
  for (const auto& entry : fs::recursive_directory_iterator(kRoot + "/examples")) { // or their folder is
    if (!entry.is_regular_file() || entry.path().extension() == ".md") continue;
    const fs::path path = fs::relative(entry.path(), kRoot);
    const std::string name = path.generic_string(), folder = path.parent_path().generic_string();
    const bool by_folder = folder != "examples" && words.count(folder) + words.count(folder + "/") > 0;
    bool outside = by_folder; // a folder of its own, told where hosts are
    if (!outside) outside = contains(page("include/README.md"), "`" + folder + "/`");
    CHECK_MESSAGE((words.count(name) == 1 || outside), name);
  }
}

TEST_CASE("pages: the citation names this version") {
  const std::string citation = page("CITATION.cff");
  char version[40];
  std::snprintf(version, sizeof version, "\nversion: %d.%d.%d\n", C2D_VERSION_MAJOR, C2D_VERSION_MINOR, C2D_VERSION_PATCH);
  CHECK(contains(citation, version));
  CHECK(citation.compare(0, 19, "cff-version: 1.2.0\n") == 0);
}

TEST_CASE("pages: every page is on the map") {
  const std::string readme = page("README.md"), map = readme.substr(readme.find("## Pages"));
  for (const std::string& name : pages())
    if (name != "README.md") CHECK_MESSAGE(contains(map, "(" + name + ")"), name);
}

namespace {
std::set<std::string> identifiers_of(const std::string& text) {
  std::set<std::string> out;
  const auto is_of_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (auto at = text.begin(); at != text.end();) {
    const auto end = std::find_if_not(at, text.end(), is_of_name);
    if (end != at) out.emplace(at, end);
    at = std::find_if(end, text.end(), is_of_name);
  }
  return out;
}
} // namespace

TEST_CASE("pages: the names they quote are those of the code") {
  std::string headers;
  for (const auto& entry : fs::directory_iterator(kRoot + "/include")) headers += read_file(entry.path().string());
  for (const auto& entry : fs::recursive_directory_iterator(kRoot + "/port"))
    if (entry.path().extension() == ".h" || entry.path().extension() == ".f90") headers += read_file(entry.path().string());
  std::string sizes = page("src/memory/sizes.hpp"); // and the arrays of its lists, of which some had a forerunner
  std::set<std::string> forerunners;
  const std::regex array("^  ARRAY\\(\\w+, ([A-Z]\\w+), .*"), forerunner(".*/\\*.*\\([A-Z][A-Z0-9 .,]*\\).*");
  for (const std::string& text : lines_of(page("include/contact2d_memory.h"))) {
    std::smatch match;
    if (!std::regex_match(text, match, array)) continue;
    sizes += "k" + match[1].str() + "\n";
    if (std::regex_match(text, forerunner)) forerunners.insert("k" + match[1].str());
  }
  CHECK(forerunners.size() > 8);
  const std::set<std::string> of_headers = identifiers_of(headers), of_sizes = identifiers_of(sizes);
  const std::regex header_name("(c2d|C2D)_[A-Za-z0-9_]*[A-Za-z0-9]"), size_name("k[A-Z][A-Za-z]+");
  int seen = 0;
  for (const std::string& name : pages()) {
    CAPTURE(name);
    // The first column of the list of changes is what a version before had.
    const std::string text =
        name == "include/CHANGELOG.md" ? std::regex_replace(page(name), std::regex("\n\\|[^|\n]*\\|"), "\n|") : page(name);
    for (const std::string& word : quoted_words(text)) {
      const bool is_header_name = std::regex_match(word, header_name);
      if (!is_header_name && !(name == "src/FROM-1987.md" && std::regex_match(word, size_name))) continue;
      if (word == "C2D_REAL" || word == "C2D_SMALL" || word == "C2D_PARTS_BY_CALL") continue; // said when compiling
      ++seen;
      CHECK_MESSAGE((is_header_name ? of_headers : of_sizes).count(word) == 1, word);
    }
  }
  CHECK(seen > 100);
  // Every array of the workspace that had a forerunner stands in the table.
  const std::set<std::string> words = quoted_words(page("src/FROM-1987.md"));
  for (const std::string& name : forerunners) CHECK_MESSAGE(words.count(name) == 1, name);
}

TEST_CASE("pages: options, exit statuses and keys of the summary are those of the program") {
  const std::string text = page("src/report/OUTPUT.md"), help = run_shell("'" + paths::program() + "' --help").out;
  const std::regex option("--[a-z][a-z-]+");
  std::set<std::string> of_help;
  for (std::sregex_iterator i(help.begin(), help.end(), option), end; i != end; ++i) of_help.insert(i->str());
  CHECK(of_help.size() > 8);
  for (const std::string& name : of_help) {
    if (name == "--version" || name == "--help") continue; // told by --help alone
    const bool told = contains(text, "`" + name) || (name == "--to" && contains(text, "[--to ")) ||
                      ((name == "--list" || name == "--man") && contains(text, " " + name + "`"));
    CHECK_MESSAGE(told, name);
  }
  for (const char* status : {"| 0 |", "| 1 |", "| 2 |", "| 3 |", "| 4 |", "| 64 |", "| 75 |", "| 130 |", "| 141 |", "| 143 |"})
    CHECK_MESSAGE(contains(text, status), status);

  const Folder folder;
  const std::string to = " --listing /dev/null --json '" + (folder / "a.json") + "'";
  std::set<std::string> keys;
  for (const char* deck : {"examples/roller.dat", "examples/sliding_block.dat", "examples/three_bodies.dat"}) {
    run_shell("cd '" + kRoot + "' && '" + paths::program() + "' run " + deck + to);
    add_keys(JsonReader::read(read_file(folder / "a.json")), keys);
  }
  CHECK(keys.size() > 50);
  const std::set<std::string> words = quoted_words(text);
  for (const std::string& key : keys) CHECK_MESSAGE(words.count(key) == 1, key);
}

TEST_CASE("pages: every keyword and every column of the results is explained") {
  const std::string deck = page("src/deck/DECK.md"), keywords = page("src/deck/keywords.cpp");
  const std::regex row("^    \\{\"([A-Z ]+)\", read_");
  int seen = 0;
  for (const std::string& line : lines_of(keywords)) {
    std::smatch match;
    if (!std::regex_search(line, match, row)) continue;
    ++seen;
    CHECK_MESSAGE(contains(deck, "`*" + match[1].str()), match[1].str());
  }
  CHECK(seen >= 10);
  const std::set<std::string> words = quoted_words(page("src/report/OUTPUT.md"));
  for (const char* column : {"mu", "step", "load", "pair", "x", "y", "status", "tn", "tt", "un1", "ut1", "un2", "ut2", "gap",
                             "slip", "zone", "body1", "body2"})
    CHECK_MESSAGE(words.count(column) == 1, column);
}

TEST_CASE("pages: every warning and every outcome is explained") {
  const std::string text = page("src/report/OUTPUT.md"), header = page("include/contact2d_codes.h");
  const std::regex warning("C2D_WARN_([A-Z_0-9]+) = 2");
  int seen = 0;
  for (std::sregex_iterator i(header.begin(), header.end(), warning), end; i != end; ++i, ++seen)
    CHECK_MESSAGE(contains(text, "| `" + (*i)[1].str() + "` |"), i->str());
  CHECK(seen >= 16);
  for (int outcome = 0; std::string(c2d_outcome_message(outcome)) != c2d_outcome_message(-1); ++outcome)
    CHECK_MESSAGE(contains(text, std::string("\n| ") + c2d_outcome_message(outcome) + " |"), c2d_outcome_message(outcome));
}

// Not to the last digit, which may differ from machine to machine.
TEST_CASE("pages: the picture is drawn by the program") {
  const Folder folder;
  const Result run = run_shell("cd '" + kRoot + "' && '" + paths::program() +
                               "' run examples/roller.dat --listing /dev/null --figures '" + (folder / "a") + "'");
  REQUIRE(run.status == 0);
  const std::string svg = read_file(folder / "a/tractions_2.svg");
  const std::vector<double> drawn = numbers_of(svg.substr(0, svg.rfind("<!--"))), // without its checksum
      kept = numbers_of(page("examples/roller.svg"));
  CHECK(kept.size() > 500);
  REQUIRE(drawn.size() == kept.size());
  for (size_t i = 0; i < kept.size(); ++i) CHECK(std::fabs(drawn[i] - kept[i]) < 1.0); // a pixel
}
