// tests/EVIDENCE.md: every promise has tests that exist, as many as it says, and what it quotes of a file stands there.
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <regex>
#include <set>

using namespace test;

namespace {

const std::string kRoot = paths::root();

struct Row {
  std::string promise;
  std::vector<std::string> patterns;
  int tests = 0;
  std::string cases;
};

std::vector<std::string> quoted(const std::string& text) {
  std::vector<std::string> out;
  const std::regex code("`([^`]+)`");
  for (std::sregex_iterator i(text.begin(), text.end(), code), end; i != end; ++i) out.push_back((*i)[1].str());
  return out;
}

// Rows of four columns, without headings.
std::vector<Row> rows() {
  std::vector<Row> out;
  const std::regex row("\\| (.+?) \\| (`.+?`) \\| (\\d+) \\| ?(.*?) ?\\|");
  for (const std::string& line : lines_of(read_file(kRoot + "/tests/EVIDENCE.md"))) {
    if (line.compare(0, 2, "| ") != 0 || contains(line, "| ---") || contains(line, "| shown by |")) continue;
    std::smatch found;
    REQUIRE_MESSAGE(std::regex_match(line, found, row), line);
    out.push_back({found[1].str(), quoted(found[2].str()), std::stoi(found[3].str()), found[4].str()});
  }
  return out;
}

// Names of all tests, as their files have them.
std::set<std::string> test_names() {
  std::set<std::string> out;
  const std::regex name("TEST_CASE\\(\"((?:[^\"\\\\]|\\\\.)*)\"");
  for (const auto& entry : fs::directory_iterator(kRoot + "/tests")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = read_file(entry.path().string());
    for (std::sregex_iterator i(text.begin(), text.end(), name), end; i != end; ++i) out.insert((*i)[1].str());
  }
  return out;
}

// As -tc has it: * for any letters, and no difference between small and capital ones is made there; here there is.
bool matches(const std::string& name, const std::string& pattern) {
  const size_t star = pattern.find('*');
  if (star == std::string::npos) return name == pattern;
  REQUIRE(star + 1 == pattern.size());
  return name.compare(0, star, pattern, 0, star) == 0;
}

std::vector<std::string> first_words(const std::string& text, size_t count) {
  std::istringstream in(text);
  std::vector<std::string> out;
  for (std::string word; out.size() < count && in >> word;) out.push_back(word);
  return out;
}

// What a row has to say of an item of the README's lists: the words in bold, or the first five.
std::string key_of(const std::string& item) {
  std::smatch bold;
  if (std::regex_search(item, bold, std::regex("^\\*\\*(.+?)\\*\\*"))) return bold[1].str();
  std::string out;
  for (const std::string& word : first_words(item, 5)) out += (out.empty() ? "" : " ") + word;
  return out;
}

bool has_row(const std::vector<Row>& all, const std::string& promise) {
  for (const Row& row : all)
    if (contains(row.promise, promise)) return true;
  return false;
}

} // namespace

TEST_CASE("evidence: every pattern names tests, and there are as many as the table says") {
  const std::set<std::string> names = test_names();
  REQUIRE(names.size() > 1000);
  REQUIRE(rows().size() > 40);
  for (const Row& row : rows()) {
    CAPTURE(row.promise);
    CHECK(row.patterns.size() > 0);
    std::set<std::string> shown;
    for (const std::string& pattern : row.patterns) {
      const size_t before = shown.size();
      for (const std::string& name : names)
        if (matches(name, pattern)) shown.insert(name);
      CHECK_MESSAGE(shown.size() > before, "no test (or none that another pattern has not) is called " << pattern);
    }
    CHECK(static_cast<int>(shown.size()) >= row.tests);
    CHECK(static_cast<int>(shown.size()) <= row.tests + row.tests / 2 + 2); // else the table is of long ago
  }
}

TEST_CASE("evidence: what it quotes of files stands there, and its commands exist") {
  std::string makefile = read_file(kRoot + "/Makefile");
  for (const char* folder : {"/src", "/tests", "/port"})
    for (const auto& entry : fs::recursive_directory_iterator(kRoot + folder))
      if (entry.path().extension() == ".mk") makefile += read_file(entry.path().string());
  int seen = 0;
  for (const Row& row : rows()) {
    CAPTURE(row.promise);
    const std::vector<std::string> words = quoted(row.cases);
    std::string file;
    for (size_t i = words.size(); i-- > 0;) { // a file stands behind what is quoted of it
      ++seen;
      if (words[i].compare(0, 5, "make ") == 0) {
        std::smatch target;
        REQUIRE(std::regex_search(words[i], target, std::regex("^make (\\w+)( (\\w+)=\\w+)?$")));
        CHECK(std::regex_search(makefile, std::regex("\\n" + target[1].str() + ":")));
        if (target[3].matched) CHECK(contains(makefile, target[3].str()));
      } else if (words[i].compare(0, 6, "tests/") == 0) {
        file = read_file(kRoot + "/" + words[i]);
        CHECK_MESSAGE(!file.empty(), words[i]);
      } else {
        CHECK_MESSAGE(contains(file, words[i]), words[i]);
      }
    }
  }
  CHECK(seen > 20);
  // Of models of the store's sweep the number itself.
  const std::string sweep = read_file(kRoot + "/tests/test_store_sweep.cpp");
  const std::string list =
      sweep.substr(sweep.find("kModels[] ="), sweep.find("};", sweep.find("kModels[] =")) - sweep.find("kModels[] ="));
  const std::regex model("\\{\"");
  const auto models = std::distance(std::sregex_iterator(list.begin(), list.end(), model), std::sregex_iterator());
  CHECK(contains(read_file(kRoot + "/tests/EVIDENCE.md"), "in " + std::to_string(models) + " models"));
}

TEST_CASE("evidence: every promise of the README's lists has a row, and so has the header's first comment") {
  const std::vector<Row> all = rows();
  int items = 0;
  for (const std::string& line : lines_of(read_file(kRoot + "/README.md"))) {
    if (line.compare(0, 2, "- ") != 0) continue;
    ++items;
    CHECK_MESSAGE(has_row(all, key_of(line.substr(2))), line);
  }
  CHECK(items >= 13);
  const std::string header = read_file(kRoot + "/include/contact2d.h");
  const std::string comment = header.substr(0, header.find("*/"));
  const std::regex heading("\\n\\n   (Conventions|[A-Z]\\w+)(\\.| stand in one order;)");
  int headings = 0;
  for (std::sregex_iterator i(comment.begin(), comment.end(), heading), end; i != end; ++i, ++headings)
    CHECK_MESSAGE(has_row(all, (*i)[1].str()), i->str());
  CHECK(headings >= 3);
}
