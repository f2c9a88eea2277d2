// The headers' manual keeps its word: the code in their comments compiles, every function is explained, contact2d.h stays
// short enough to be read, and port/README.md has every duty.
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <regex>
#include <set>

using namespace test;

namespace {

const std::string kRoot = paths::root();
const std::string kHeader = read_file(kRoot + "/include/contact2d.h");

// Code in block comments: lines from one that is indented by five blanks, after an empty one, to the next empty line or
// the end of the comment. Its indentation is taken off.
std::vector<std::string> snippets(const std::string& text) {
  std::vector<std::string> out;
  bool comment = false, inside = false, after_empty = false;
  for (const std::string& line : lines_of(text)) {
    const bool ends = contains(line, "*/");
    if (comment && !inside && after_empty && line.compare(0, 5, "     ") == 0 && line.size() > 5 && line[5] != ' ')
      inside = true, out.emplace_back();
    if (line.empty() || ends) inside = false;
    if (inside) out.back() += line.substr(5) + "\n";
    after_empty = line.empty();
    comment = (comment || contains(line, "/*")) && !ends;
  }
  return out;
}

// A definition of a function, which cannot stand in another.
bool is_function(const std::string& snippet) {
  const std::string first = snippet.substr(0, snippet.find('\n'));
  return first.compare(0, 7, "static ") == 0 && !first.empty() && first.back() == '{' && contains(first, "(");
}

std::string program_of(const std::vector<std::string>& code, const std::string& headers) {
  std::string outside = headers + "#include <stdio.h>\n#include <string.h>\n", inside;
  for (const std::string& snippet : code) (is_function(snippet) ? outside : inside) += snippet;
  return outside + "int main(void) {\n" + inside + "return 0;\n}\n";
}

// Compiled without warnings but for what is defined and not used.
Result compile(const std::string& compiler, const Folder& folder, const std::string& program) {
  write_file(folder / "a.c", program);
  std::string command = compiler + " -Wall -Wextra -Wpedantic -Werror -Wno-unused -I'" + kRoot + "/include'";
  for (const char* port : {"memory", "stdio", "posix", "threads"}) command += " -I'" + kRoot + "/port/" + port + "'";
  return run_shell(command + " '" + (folder / "a.c") + "' -o '" + (folder / "a") + "' -c");
}

const std::string kAsC = paths::c_compiler() + " -std=c99 -x c", kAsCpp = paths::cxx_compiler() + " -std=c++17 -x c++";

} // namespace

TEST_CASE("header: the code in the comments of the ports' headers compiles as C99 and C++") {
  for (const char* port : {"memory", "stdio", "posix", "threads"}) {
    const std::string name = std::string("c2d_") + port + ".h";
    const std::vector<std::string> code = snippets(read_file(kRoot + "/port/" + port + "/" + name));
    CHECK_MESSAGE(!code.empty(), name);
    for (const std::string& compiler : {kAsC, kAsCpp}) {
      const Folder folder;
      const Result compiled = compile(compiler, folder, program_of(code, "#include \"" + name + "\"\n"));
      CHECK_MESSAGE(compiled.status == 0, name << "\n" << compiled.err);
    }
  }
}

TEST_CASE("header: the code in the comments of the smaller headers compiles as C99 and C++") {
  for (const std::string name : {"contact2d_cards.h", "contact2d_cycle.h", "contact2d_image.h", "contact2d_memory.h"}) {
    const std::vector<std::string> code = snippets(read_file(kRoot + "/include/" + name));
    CHECK_MESSAGE(!code.empty(), name);
    for (const std::string& compiler : {kAsC, kAsCpp}) {
      const Folder folder;
      const Result compiled = compile(compiler, folder, program_of(code, "#include \"" + name + "\"\n"));
      CHECK_MESSAGE(compiled.status == 0, name << "\n" << compiled.err);
    }
  }
}

TEST_CASE("header: it can be read in a quarter of an hour") {
  const std::vector<std::string> lines = lines_of(kHeader);
  CHECK(lines.size() <= 600);
  for (const std::string& line : lines) CHECK_MESSAGE(line.size() <= 128, line);
}

TEST_CASE("header: every function stands below a comment") {
  // A declaration's comment ends on the line above it, above a declaration that is explained, or behind it.
  const std::vector<std::string> lines = lines_of(kHeader);
  bool explained = false;
  int seen = 0;
  for (size_t i = 0; i < lines.size(); ++i) {
    const bool declares = std::regex_search(lines[i], std::regex("^(c2d_status|int32_t|const char\\*) c2d_\\w+\\("));
    if (contains(lines[i], "*/")) explained = true;
    if (lines[i].empty()) explained = false;
    if (!declares) continue;
    ++seen;
    CHECK_MESSAGE(explained, lines[i]);
  }
  CHECK(seen > 50);
}

TEST_CASE("header: every function of a solver stands in the table of states") {
  const size_t table = kHeader.find("   State        legal calls"), calls = kHeader.find("5 a model by calls"),
               behind = kHeader.find("6 prepare");
  REQUIRE((calls < behind && behind < table && table < kHeader.size()));
  const std::string states = kHeader.substr(table, kHeader.find("*/", table) - table);
  const std::regex function("\\nc2d_status c2d_(get_)?(\\w+)\\((const )?c2d_solver\\* ");
  int seen = 0;
  for (std::sregex_iterator i(kHeader.begin(), kHeader.end(), function), end; i != end; ++i, ++seen) {
    const size_t at = static_cast<size_t>(i->position());
    const std::string name = (*i)[2].str(), word = (*i)[1].matched ? "(get)?_" + name : name; // of a list: _zone
    const bool listed = std::regex_search(states, std::regex("[ (]" + word + "\\b"));
    CHECK_MESSAGE((listed || (at > calls && at < behind)), i->str());
  }
  CHECK(seen > 50);
}

TEST_CASE("port/README.md: every function of c2d_port has its duty") {
  const std::string page = read_file(kRoot + "/port/README.md");
  const std::string port = kHeader.substr(kHeader.find("typedef struct c2d_port {"),
                                          kHeader.find("} c2d_port;") - kHeader.find("typedef struct c2d_port {"));
  const std::regex member("\\(\\*(\\w+)\\)\\(void\\* context");
  int seen = 0;
  for (std::sregex_iterator i(port.begin(), port.end(), member), end; i != end; ++i, ++seen)
    CHECK_MESSAGE(contains(page, "`" + (*i)[1].str() + "`"), (*i)[1].str());
  CHECK(seen == 13);
  for (const auto& entry : fs::directory_iterator(kRoot + "/port"))
    if (entry.is_directory())
      CHECK_MESSAGE(contains(page, "`port/" + entry.path().filename().string() + "`"), entry.path().string());
}
