// Comments cite METHOD and its two further pages by their common numbers, and the dissertation's equations by theirs: all
// exist.
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <regex>
#include <set>

using namespace test;

namespace {

const fs::path kRoot = paths::root();

// METHOD 8, METHOD 8.1: a section. METHOD (8.1), thesis (5.3): an equation, or several: thesis (4.6) to (4.9).
const std::string kNumber = "(?:[A-C]|[0-9]+)\\.[0-9]+", kEquation = "\\(" + kNumber + "\\)";
const std::regex kEquations("(METHOD|thesis) (" + kEquation + "(?:(?:,| and|, and| to) " + kEquation + ")*)");
const std::regex kSections("METHOD ([0-9]+(?:\\.[0-9]+)?)");

struct Numbers {
  std::set<std::string> sections, equations, of_thesis;
};

Numbers numbers_of_page(const std::string& page) {
  Numbers out;
  const std::regex section("^## ([0-9]+) "), part("^\\*\\*([0-9]+\\.[0-9]+)\\W"),
      equation("^    (?:\\S.*?)?\\(([0-9]+\\.[0-9]+)\\)   ?"), thesis("thesis \\((" + kNumber + ")\\)");
  for (const std::string& line : lines_of(page)) {
    std::smatch match;
    if (std::regex_search(line, match, section) || std::regex_search(line, match, part)) out.sections.insert(match[1]);
    if (std::regex_search(line, match, equation)) out.equations.insert(match[1]);
    for (std::sregex_iterator i(line.begin(), line.end(), thesis), end; line.compare(0, 1, "|") == 0 && i != end; ++i)
      out.of_thesis.insert((*i)[1]);
  }
  return out;
}

// METHOD and the pages that continue its numbers.
Numbers numbers_of_method() {
  std::string pages;
  for (const char* page : {"METHOD", "METHOD-LARGE", "METHOD-MESHES"})
    pages += read_file((kRoot / "src" / page).string() + ".md");
  return numbers_of_page(pages);
}

// The text of all comments of a C or C++ file, each run of them as one line.
std::string comments_of(const std::string& text) {
  std::string out;
  bool block = false;
  for (std::string line : lines_of(text)) {
    const size_t begin = block ? 0 : std::min(line.find("//"), line.find("/*"));
    if (begin == std::string::npos) {
      out += '\n';
      continue;
    }
    const bool starts_block = !block && line.compare(begin, 2, "/*") == 0;
    const size_t end = block || starts_block ? line.find("*/", begin) : std::string::npos;
    std::string part = line.substr(begin + (block ? 0 : 2), end == std::string::npos ? end : end - begin);
    block = (block || starts_block) && end == std::string::npos;
    const size_t blanks = std::min(part.find_first_not_of(" \t"), part.size());
    out.append(part, blanks, std::string::npos) += ' ';
  }
  return out;
}

bool is_code(const fs::path& path) {
  static const std::set<std::string> kCode = {".h", ".hpp", ".c", ".cpp"};
  return kCode.count(path.extension().string()) > 0;
}

// Most texts cite nothing, which is seen much faster than by regular expressions.
bool may_cite(const std::string& text) {
  if (contains(text, "METHOD ") || contains(text, "thesis ")) return true;
  for (size_t at = text.find('('); at != std::string::npos; at = text.find('(', at + 1)) {
    const size_t point = text.find('.', at);
    const std::string number = point == std::string::npos ? "" : text.substr(at + 1, point - at - 1);
    if (!number.empty() && number.size() < 5 && number.find_first_not_of("ABC0123456789") == std::string::npos) return true;
  }
  return false;
}

// What a text cites, and what it puts in brackets without saying whose number it is.
struct Citations {
  std::set<std::string> sections, equations, of_thesis, nobodys;
};

Citations citations_of(const std::string& text) {
  Citations out;
  if (!may_cite(text)) return out;
  const std::regex equation(kEquation);
  for (std::sregex_iterator i(text.begin(), text.end(), kSections), end; i != end; ++i) out.sections.insert((*i)[1]);
  for (std::sregex_iterator i(text.begin(), text.end(), kEquations), end; i != end; ++i) {
    const std::string list = (*i)[2];
    for (std::sregex_iterator k(list.begin(), list.end(), equation); k != end; ++k)
      ((*i)[1] == "METHOD" ? out.equations : out.of_thesis).insert(k->str().substr(1, k->str().size() - 2));
  }
  const std::string rest = std::regex_replace(text, kEquations, "");
  for (std::sregex_iterator i(rest.begin(), rest.end(), equation), end; i != end; ++i) out.nobodys.insert(i->str());
  return out;
}

// Where a link into a page may point: its headings, as they are made into anchors, and named places.
std::set<std::string> anchors_of(const std::string& page) {
  std::set<std::string> out;
  const std::regex named("<a name=\"([^\"]+)\">");
  for (const std::string& line : lines_of(page)) {
    for (std::sregex_iterator i(line.begin(), line.end(), named), end; i != end; ++i) out.insert((*i)[1]);
    std::smatch match;
    if (!std::regex_match(line, match, std::regex("#+ (.*)"))) continue;
    std::string anchor;
    for (const char c : match[1].str()) {
      const char small = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
      if (small == ' ')
        anchor += '-';
      else if ((small >= 'a' && small <= 'z') || (small >= '0' && small <= '9') || small == '-' || small == '_')
        anchor += small;
    }
    out.insert(anchor);
  }
  return out;
}

void check_known(const std::set<std::string>& cited, const std::set<std::string>& known, const std::string& what) {
  for (const std::string& number : cited) CHECK_MESSAGE(known.count(number) == 1, what << " " << number);
}

} // namespace

TEST_CASE("method: every number that a comment cites stands on the page") {
  const Numbers page = numbers_of_method();
  CHECK(page.sections.size() > 40);
  CHECK(page.equations.size() > 35);
  CHECK(page.of_thesis.size() > 8);
  size_t seen = 0;
  for (const char* folder : {"src", "include", "port"})
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
      if (!entry.is_regular_file() || !is_code(entry.path())) continue;
      CAPTURE(entry.path().string());
      const std::string text = comments_of(read_file(entry.path().string()));
      const Citations cited = citations_of(text);
      check_known(cited.sections, page.sections, "METHOD");
      check_known(cited.equations, page.equations, "METHOD, equation");
      check_known(cited.of_thesis, page.of_thesis, "thesis, equation");
      for (const std::string& number : cited.nobodys) CHECK_MESSAGE(number == "", "whose equation?");
      CHECK(!contains(text, "design:"));
      seen += cited.sections.size() + cited.equations.size() + cited.of_thesis.size();
    }
  CHECK(seen > 25);
}

TEST_CASE("method: the pages cite what there is, and their links lead somewhere") {
  const Numbers page = numbers_of_method();
  const std::regex link("\\]\\(([^)#]*)(?:#([^)]*))?\\)");
  int seen = 0;
  for (const char* top : {"README.md", "src", "include", "port", "examples", "tests"}) {
    std::vector<fs::path> files;
    if (fs::is_regular_file(kRoot / top))
      files.push_back(kRoot / top);
    else
      for (const auto& entry : fs::recursive_directory_iterator(kRoot / top))
        if (entry.path().extension() == ".md") files.push_back(entry.path());
    for (const fs::path& path : files) {
      CAPTURE(path.string());
      const std::string text = read_file(path.string());
      if (path.filename().string().compare(0, 6, "METHOD") != 0) {
        const Citations cited = citations_of(text);
        check_known(cited.sections, page.sections, "METHOD");
        check_known(cited.equations, page.equations, "METHOD, equation");
      }
      for (std::sregex_iterator i(text.begin(), text.end(), link), end; i != end; ++i) {
        const std::string file = (*i)[1], anchor = (*i)[2];
        if (file.find("://") != std::string::npos) continue;
        const fs::path target = file.empty() ? path : path.parent_path() / file;
        ++seen;
        CHECK_MESSAGE(fs::exists(target), i->str());
        if (!anchor.empty() && fs::is_regular_file(target))
          CHECK_MESSAGE(anchors_of(read_file(target.string())).count(anchor) == 1, i->str());
      }
    }
  }
  CHECK(seen > 20);
}
