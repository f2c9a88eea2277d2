// The README keeps its word: its C programs compile and run, the files and names it mentions exist.
#include "shell.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <regex>
#include <set>

using namespace test;

namespace {

const std::string kRoot = C2D_TEST_ROOT;

std::string readme() {
  return read_file(kRoot + "/README.md");
}

// The blocks of the README fenced as this language.
std::vector<std::string> blocks(const std::string& language) {
  std::vector<std::string> out;
  bool inside = false;
  for (const std::string& line : lines_of(readme())) {
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
std::set<std::string> quoted_words() {
  std::set<std::string> out;
  bool inside = false;
  const std::regex quoted("`([^`]+)`");
  for (const std::string& line : lines_of(readme())) {
    if (line.compare(0, 3, "```") == 0) inside = !inside;
    if (inside) continue;
    for (std::sregex_iterator i(line.begin(), line.end(), quoted), end; i != end; ++i)
      out.insert((*i)[1].str());
  }
  return out;
}

// Compiles a C program with this command; "" or what the compiler said. A library with a sanitizer in it
// needs that one's run-time: then nothing is linked.
std::string compile(const std::string& compiler, const std::string& source, const std::string& out) {
  const std::string rest = kSanitized ? " -c" : " -x none '" C2D_TEST_LIBRARY "' -lm";
  const Result result =
      run_shell(compiler + " -Wall -Wextra -Wpedantic -Werror -I'" + kRoot + "/include' -I'" + kRoot +
                "/port/memory' '" + source + "'" + rest + " -o '" + out + "'");
  return result.status == 0 ? "" : result.err + "(failed)";
}

} // namespace

TEST_CASE("readme: its C programs compile as C99 and as C++ and run") {
  const std::vector<std::string> programs = blocks("c");
  REQUIRE(programs.size() >= 1);
  for (const std::string& program : programs) {
    const Folder folder;
    write_file(folder / "example.c", program);
    const std::string as_c = C2D_TEST_CC " -std=c99 -x c", as_cpp = C2D_TEST_CXX " -std=c++17 -x c++";
    for (const std::string& compiler : {as_c, as_cpp}) {
      REQUIRE(compile(compiler, folder / "example.c", folder / "example") == "");
      if (kSanitized || !contains(program, "int main(")) continue;
      const Result result = run_shell("cd '" + kRoot + "' && '" + (folder / "example") + "'");
      CHECK_MESSAGE(result.status == 0, result.out << result.err);
      // Two coefficients of friction, 28 increments each; the last pressure is the README's, and near the
      // 213.0 of the program of 1987, which lost 0.3 % of the load.
      const std::vector<std::string> rows = lines_of(result.out);
      REQUIRE(rows.size() == 56);
      double mu = 0, load = 0, pressure = 0;
      REQUIRE(std::sscanf(rows[27].c_str(), "mu %lf load %lf pressure at the centre %lf", &mu, &load,
                          &pressure) == 3);
      CHECK(mu == 0.4);
      CHECK(load == 1.03);
      CHECK(contains(readme(), "contact2d finds " + std::to_string(pressure).substr(0, 5) + " "));
      CHECK(std::fabs(pressure - 213.0) < 0.003 * 213.0);
    }
  }
}

TEST_CASE("readme: the files it names exist, and every example has its line") {
  const std::set<std::string> words = quoted_words();
  int seen = 0;
  for (const std::string& word : words) {
    const bool path =
        std::regex_match(word, std::regex("(src|port|examples|include|tests|\\.ci)/[a-z0-9_./]*"));
    if (!path) continue;
    ++seen;
    CHECK_MESSAGE(fs::exists(kRoot + "/" + word), word);
  }
  CHECK(seen > 30);
  for (const auto& entry : fs::recursive_directory_iterator(kRoot + "/examples")) { // or their folder is
    if (!entry.is_regular_file()) continue;
    const fs::path path = fs::relative(entry.path(), kRoot);
    const std::string name = path.generic_string(), folder = path.parent_path().generic_string();
    const bool by_folder = folder != "examples" && words.count(folder) + words.count(folder + "/") > 0;
    CHECK_MESSAGE((words.count(name) == 1 || by_folder), name);
  }
}

TEST_CASE("readme: the names of the table are those of the code") {
  const std::string header = read_file(kRoot + "/include/contact2d.h"),
                    sizes = read_file(kRoot + "/src/memory/sizes.hpp");
  int seen = 0;
  for (const std::string& word : quoted_words()) {
    const bool of_header = std::regex_match(word, std::regex("(c2d|C2D)_[A-Za-z0-9_]+"));
    const bool of_sizes = std::regex_match(word, std::regex("k[A-Z][A-Za-z]+"));
    if (!of_header && !of_sizes) continue;
    ++seen;
    CHECK_MESSAGE(std::regex_search(of_header ? header : sizes, std::regex("\\b" + word + "\\b")), word);
  }
  CHECK(seen > 30);
  // Every array of the workspace that had a forerunner stands in the table.
  const std::regex line("^  (k[A-Z][A-Za-z]+) = .*\\([A-Z][A-Z0-9 .,]*\\)");
  const std::set<std::string> words = quoted_words();
  for (const std::string& text : lines_of(sizes)) {
    std::smatch match;
    if (std::regex_search(text, match, line)) CHECK_MESSAGE(words.count(match[1].str()) == 1, match[1].str());
  }
}

TEST_CASE("readme: the options and exit statuses are those of the program") {
  const std::string help = run_shell("'" C2D_TEST_PROGRAM "' --help").out;
  const std::string text = readme();
  const std::regex option("--[a-z][a-z-]+");
  std::set<std::string> of_help;
  for (std::sregex_iterator i(help.begin(), help.end(), option), end; i != end; ++i) of_help.insert(i->str());
  CHECK(of_help.size() > 8);
  for (const std::string& name : of_help) {
    if (name == "--version" || name == "--help") continue; // told by --help alone
    CHECK_MESSAGE(contains(text, "`" + name), name);
  }
  for (const char* status : {"| 0 |", "| 1 |", "| 2 |", "| 3 |", "| 4 |", "| 64 |", "| 130 |"})
    CHECK_MESSAGE(contains(text, status), status);
}
