// What ships, read with readelf: a stack that is protected, memory functions that check, marks for control-flow enforcement,
// a program at addresses of chance, no table that is writable once it runs (port/packaging/hardening.mk).
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

using namespace test;

namespace {

std::string readelf(const std::string& options, const std::string& file) {
  const Result told = run_shell("LC_ALL=C readelf -W " + options + " '" + file + "'");
  REQUIRE_MESSAGE(told.status == 0, told.err);
  return told.out;
}

bool has_line(const std::string& text, const std::string& first, const std::string& second) {
  for (const std::string& line : lines_of(text))
    if (contains(line, first) && contains(line, second)) return true;
  return false;
}

// What a program or a shared library lacks, a word each; nothing if it is hardened.
std::string lacks(const std::string& file) {
  std::string out;
  const auto demand = [&out](bool holds, const char* what) { out += holds ? "" : std::string(what) + " "; };
  const std::string segments = readelf("-l", file), dynamic = readelf("-d", file), names = readelf("--dyn-syms", file);
  demand(has_line(readelf("-h", file), "Type:", "DYN"), "position-independent");
  demand(contains(segments, "GNU_RELRO"), "relro");
  demand(has_line(dynamic, "FLAGS", "NOW"), "now");
  demand(has_line(segments, "GNU_STACK", " RW ") && !has_line(segments, "GNU_STACK", "RWE"), "stack-not-executable");
  demand(!has_line(segments, "LOAD", "RWE"), "writable-or-executable");
  demand(!contains(dynamic, "TEXTREL"), "text-not-relocated");
  demand(contains(names, "__stack_chk_fail"), "stack-protector");
  return out;
}

// Members of an archive that run on this machine, and how many of them are marked.
void count_marks(const std::string& archive, const std::string& mark, int& members, int& marked) {
  for (const std::string& line : lines_of(readelf("-n", archive))) {
    if (contains(line, "File: ")) ++members;
    if (contains(line, mark)) ++marked;
  }
}

bool can_look() {
  if (paths::sanitized() || !has_command("readelf")) return false;
  if (!paths::hardened()) MESSAGE("skipped: this build is not hardened");
  return paths::hardened();
}

} // namespace

TEST_CASE("hardened: program and shared library") {
  if (!can_look()) return;
  CHECK(lacks(paths::program()) == "");
  CHECK(lacks(paths::shared()) == "");
  CHECK(has_line(readelf("-d", paths::program()), "FLAGS_1", "PIE"));
  CHECK(contains(readelf("--dyn-syms", paths::program()), "_chk@")); // memcpy and its like, where sizes are known
}

TEST_CASE("hardened: every object of the library is marked for control-flow enforcement") {
  if (!can_look()) return;
#if defined(__x86_64__) || defined(__i386__)
  const std::string mark = "x86 feature: IBT, SHSTK";
#elif defined(__aarch64__)
  const std::string mark = "AArch64 feature: BTI, PAC";
#else
  const std::string mark;
#endif
  if (mark.empty()) return;
  int members = 0, marked = 0;
  count_marks(paths::library(), mark, members, marked);
  CHECK(members > 100);
  CHECK(marked == members);
}

TEST_CASE("hardened: this test finds what is missing") {
  if (!can_look()) return;
  const Folder folder;
  write_file(folder / "soft.c", "int main(void) { return 0; }\n");
  const std::string soft = folder / "soft";
  const Result built =
      run_shell(paths::c_compiler() + " -fno-stack-protector -fcf-protection=none -no-pie -Wl,-z,norelro,-z,lazy " +
                "-Wl,-z,execstack '" + (folder / "soft.c") + "' -o '" + soft + "'");
  if (built.status != 0) return; // another linker's words
  CHECK(lacks(soft) == "position-independent relro now stack-not-executable stack-protector ");
}

// What is compiled without it is what a host without a C library gets.
TEST_CASE("hardened: HARDENING= leaves nothing of it in the library") {
  if (!has_command("make") || paths::sanitized()) return;
  const Folder folder;
  const std::string commands = run_shell("make -n -C '" + paths::root() + "' BUILD='" + folder.path() +
                                         "' HARDENING= MAKEFLAGS= '" + (folder / "contact2d") + "'")
                                   .out;
  CHECK(contains(commands, "src/deck/cards.cpp"));
  for (const char* option : {"-fstack-protector", "FORTIFY", "-fcf-protection", "-mbranch-protection", "-z,relro", "-fPIE"})
    CHECK_FALSE_MESSAGE(contains(commands, option), option);
}
