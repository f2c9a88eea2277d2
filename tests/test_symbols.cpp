// What the archive's core members may contain and ask for: nothing of an operating system, of a heap, of the
// C++ run-time; no writable data.
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <set>

using namespace test;

namespace {

// The words in backquotes of the line of port/cortex-m/README.md that begins so: what the core may ask of its host.
std::set<std::string> page_list(const std::string& beginning) {
  std::set<std::string> names;
  const std::string page = read_file(paths::root() + "/port/cortex-m/README.md");
  const size_t at = page.find(beginning);
  const std::string text = at == std::string::npos ? "" : page.substr(at, page.find('\n', at) - at);
  for (size_t open = text.find('`'); open != std::string::npos; open = text.find('`', open)) {
    const size_t close = text.find('`', open + 1);
    names.insert(text.substr(open + 1, close - open - 1));
    open = close + 1;
  }
  return names;
}

std::set<std::string> allowed_symbols() {
  std::set<std::string> names = page_list("- memory: ");
  names.merge(page_list("- mathematics: "));
  names.insert("_GLOBAL_OFFSET_TABLE_"); // of position-independent code: no symbol of the host
  return names;
}

struct Symbol {
  std::string member, name;
  char kind;
};

bool is_core(const std::string& member) { return member.compare(0, 5, "port_") != 0 && member.compare(0, 6, "tests_") != 0; }

// nm's answer: "member:" lines, then lines of an address (or none), a letter and a name.
std::vector<Symbol> core_symbols() {
  std::vector<Symbol> out;
  std::string member;
  for (const std::string& line : lines_of(run_shell("nm -P '" + paths::core() + "'").out)) {
    const size_t open = line.rfind('['), close = line.rfind("]:");
    if (open != std::string::npos && close != std::string::npos && close > open) {
      member = line.substr(open + 1, close - open - 1);
      continue;
    }
    std::istringstream in(line);
    std::string name, kind;
    if (in >> name >> kind && kind.size() == 1 && is_core(member)) out.push_back({member, name, kind[0]});
  }
  return out;
}

bool is_forbidden(const std::string& name) {
  static const char* const kParts[] = {"malloc", "calloc",   "realloc",   "_Znw",           "_Zna",   "_Zdl",
                                       "_Zda",   "__cxa",    "_ZTI",      "_ZTS",           "_ZTV",   "__gxx",
                                       "printf", "iostream", "_ZNSt",     "_ZSt",           "abort",  "exit",
                                       "strtod", "strtol",   "setlocale", "__tls_get_addr", "_Unwind"};
  for (const char* part : kParts)
    if (contains(name, part)) return true;
  return name == "free" || name == "puts" || name == "fopen" || name == "errno" || name == "__errno_location";
}

} // namespace

TEST_CASE("symbols: the core asks only for memory moves and mathematics") {
  if (paths::sanitized() || !has_command("nm")) return;
  std::set<std::string> allowed = allowed_symbols();
  REQUIRE(allowed.size() > 10);
  if (paths::hardened()) allowed.merge(page_list("- hardened builds"));
  const std::vector<Symbol> symbols = core_symbols();
  REQUIRE(symbols.size() > 100);
  std::set<std::string> defined;
  for (const Symbol& s : symbols)
    if (s.kind != 'U') defined.insert(s.name);
  for (const Symbol& s : symbols) {
    CHECK_MESSAGE(!is_forbidden(s.name), s.member << ": " << s.name);
    if (s.kind == 'U') CHECK_MESSAGE(defined.count(s.name) + allowed.count(s.name) > 0, s.member << ": " << s.name);
  }
}

TEST_CASE("symbols: what a hardened build asks for besides") {
  if (paths::sanitized() || !has_command("nm")) return;
  std::set<std::string> allowed = allowed_symbols();
  allowed.merge(page_list("- hardened builds"));
  const Folder folder;
  for (const char* source : {"memory/text", "store/block", "store/tapes", "deck/cards", "interface/create"}) {
    const std::string object = folder / "object.o";
    const std::string root = paths::root();
    const Result built =
        run_shell(paths::cxx_compiler() +
                  " -std=c++17 -O2 -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2 -fstack-protector-all -fPIC "
                  "-fno-exceptions -fno-rtti -fno-threadsafe-statics -fno-math-errno -I'" +
                  root + "/src' -I'" + root + "/include' -c '" + root + "/src/" + source + ".cpp' -o '" + object + "'");
    REQUIRE_MESSAGE(built.status == 0, built.err);
    bool protects = false;
    for (const std::string& line : lines_of(run_shell("nm -P -u '" + object + "'").out)) {
      const std::string name = line.substr(0, line.find(' '));
      protects = protects || name == "__stack_chk_fail";
      const bool own = contains(name, "c2d");
      CHECK_MESSAGE((own || allowed.count(name) == 1), source << ": " << name);
    }
    CHECK_MESSAGE(protects, source);
  }
}

TEST_CASE("symbols: no writable data, no weak doubles of the run-time, no static constructors") {
  if (paths::sanitized() || !has_command("nm")) return;
  // d, b, c: initialised, zeroed and common data. .data.rel.ro (constant tables of addresses) is d too in
  // nm's eyes, so sections decide where there are any.
  for (const Symbol& s : core_symbols())
    CHECK_MESSAGE(std::string("bBcCgGsS").find(s.kind) == std::string::npos, s.member << ": " << s.name);
  if (!has_command("objdump")) return;
  std::string member;
  for (const std::string& line : lines_of(run_shell("objdump -h '" + paths::core() + "'").out)) {
    const size_t format = line.find(":     file format");
    if (format != std::string::npos) {
      member = line.substr(0, format);
      continue;
    }
    std::istringstream in(line);
    std::string index, name, size;
    if (!(in >> index >> name >> size) || !is_core(member)) continue;
    const bool writable = name == ".bss" || name == ".data" || name.compare(0, 5, ".bss.") == 0 || name == ".tdata" ||
                          name == ".tbss" || (name.compare(0, 6, ".data.") == 0 && name.compare(0, 12, ".data.rel.ro") != 0);
    if (writable) CHECK_MESSAGE(std::stoul(size, nullptr, 16) == 0, member << ": " << name << " " << size);
    CHECK_MESSAGE(name.compare(0, 11, ".init_array") != 0, member);
    CHECK_MESSAGE(name.compare(0, 6, ".ctors") != 0, member);
    CHECK_MESSAGE(name.compare(0, 17, ".gcc_except_table") != 0, member);
  }
}

// The deck reader may declare every optional part of a model (src/memory/parts.hpp), so the program has all of them.
// New loads are asked for by a call that it has not, c2d_change_loads.
TEST_CASE("symbols: no optional part is missing where the deck reader is linked") {
  if (paths::sanitized() || !has_command("nm")) return;
  const Result names = run_shell("nm -C -u '" + paths::program() + "'");
  REQUIRE(names.status == 0);
  for (const std::string& line : lines_of(names.out))
    if (!contains(line, "_new_loads(")) CHECK_FALSE_MESSAGE(contains(line, "c2d::"), line);
}

TEST_CASE("symbols: every public function is in the library, and all C names begin with c2d_") {
  if (paths::sanitized() || !has_command("nm")) return;
  std::set<std::string> defined;
  for (const Symbol& s : core_symbols())
    if (s.kind == 'T') defined.insert(s.name);
  const std::string header =
      read_file(paths::root() + "/include/contact2d.h") + read_file(paths::root() + "/include/contact2d_cards.h") +
      read_file(paths::root() + "/include/contact2d_image.h") + read_file(paths::root() + "/include/contact2d_cycle.h");
  int seen = 0;
  for (const std::string& line : lines_of(header)) {
    const bool declares = line.compare(0, 11, "c2d_status ") == 0 || line.compare(0, 15, "const char* c2d") == 0 ||
                          line.compare(0, 12, "int32_t c2d_") == 0;
    if (!declares) continue;
    const size_t begin = line.find("c2d_", line.compare(0, 11, "c2d_status ") == 0 ? 11 : 0), end = line.find('(', begin);
    if (begin == std::string::npos || end == std::string::npos) continue;
    ++seen;
    CHECK_MESSAGE(defined.count(line.substr(begin, end - begin)) == 1, line.substr(begin, end - begin));
  }
  CHECK(seen > 30);
  for (const std::string& name : defined)
    if (name.compare(0, 2, "_Z") != 0) CHECK_MESSAGE(name.compare(0, 4, "c2d_") == 0, name);
}
