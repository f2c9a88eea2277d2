// What is handed to others: the man page, and the library in one file.
#include "paths.hpp"
#include "program/commands/commands.hpp"
#include "program/commands/families.hpp"
#include "shell.hpp"
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>

using namespace test;

namespace {

const std::string kRoot = paths::root();

std::set<std::string> matches(const std::string& text, const char* pattern) {
  const std::regex wanted(pattern);
  std::set<std::string> out;
  for (std::sregex_iterator i(text.begin(), text.end(), wanted), end; i != end; ++i) out.insert(i->str());
  return out;
}

// What the pattern's first group matches first, or nothing.
std::string matched(const std::string& text, const char* pattern) {
  std::smatch found;
  return std::regex_search(text, found, std::regex(pattern)) ? found[1].str() : "";
}

// Prints every step of a deck's path: pairs times C2D_PAIR_FIELDS numbers.
const char* const kHost = R"(
#include "c2d_memory.h"
#include <stdio.h>
#include <string.h>
static unsigned char memory[1 << 19], tapes[1 << 20];
static int32_t next_card(void* deck, char* text, int32_t size) {
  if (fgets(text, (int)size, (FILE*)deck) == NULL) return -1;
  text[strcspn(text, "\r\n")] = '\0';
  return (int32_t)strlen(text);
}
static int32_t show(void* context, const c2d_step* step) {
  int32_t p, c;
  (void)context;
  for (p = 0; p < step->pairs; ++p)
    for (c = 0; c < C2D_PAIR_FIELDS; ++c) printf("%.17g\n", step->table[p * step->stride + c]);
  return 0;
}
int main(int count, char** argument) {
  FILE* deck = fopen(argument[count - 1], "r");
  c2d_body_limits bodies[2];
  c2d_limits limits = C2D_INIT(c2d_limits);
  c2d_port port = C2D_INIT(c2d_port);
  c2d_memory_store store;
  c2d_solver* solver = NULL;
  if (deck == NULL) return 2;
  limits.bodies = 2;
  limits.body = bodies;
  c2d_memory_store_init(&store, tapes, sizeof tapes);
  c2d_memory_store_port(&store, &port);
  if (c2d_scan_deck(next_card, deck, &limits, NULL) != C2D_OK) return 3;
  rewind(deck);
  if (c2d_create(&solver, memory, sizeof memory, &limits, &port, NULL) != C2D_OK) return 4;
  if (c2d_read_deck(solver, next_card, deck) != C2D_OK || c2d_prepare(solver) != C2D_OK) return 5;
  if (c2d_run(solver, show, NULL) != C2D_OK || c2d_close(solver) != C2D_OK) return 6;
  fclose(deck);
  return 0;
}
)";

std::vector<double> numbers(const std::string& text) {
  std::vector<double> out;
  for (const std::string& line : lines_of(text)) out.push_back(std::strtod(line.c_str(), nullptr));
  return out;
}

} // namespace

TEST_CASE("packaging: the man page has every option, command and exit status of --help") {
  const std::string page = std::regex_replace(read_file(kRoot + "/port/packaging/contact2d.1.in"), std::regex("\\\\-"), "-");
  const std::string help = run_shell("'" + paths::program() + "' --help").out;
  const std::set<std::string> options = matches(help, "--[a-z]+(-[a-z]+)*");
  CHECK(options.size() > 10);
  for (const std::string& name : options) CHECK_MESSAGE(contains(page, name), name);
  for (const char* command : {"run", "check", "sketch", "mesh", "resume", "convert", "make"})
    CHECK_MESSAGE(contains(page, std::string("\n.B contact2d ") + command), command);
  for (const char* status : {"0", "1", "2", "3", "4", "64", "75", "130", "141", "143"})
    CHECK_MESSAGE(contains(page, std::string("\n.TP\n.B ") + status + "\n"), status);
  CHECK_MESSAGE(app::man_page("@VERSION@") == read_file(kRoot + "/port/packaging/contact2d.1.in"), "make man writes it anew");
  const std::set<std::string> problems = matches(page, "\n\\.br\n\\\\fB[a-z_]+\\\\fR:"); // what make knows, and no others
  CHECK(problems.size() == families::all_families().size());
  for (const families::Family& family : families::all_families())
    CHECK_MESSAGE(problems.count("\n.br\n\\fB" + std::string(family.name) + "\\fR:") == 1, family.name);
  CHECK(run_shell("'" + paths::program() + "' help --man").out == app::man_page(c2d_version()));
  if (!has_command("man")) return;
  const Folder folder;
  write_file(folder / "contact2d.1", page);
  const Result shown = run_shell("man --warnings -E UTF-8 -l -Tutf8 -Z '" + (folder / "contact2d.1") + "' >/dev/null");
  CHECK_MESSAGE(shown.err == "", shown.err);
}

TEST_CASE("packaging: the library in one file compiles with one command and solves the sample alike") {
  if (!has_command("make") || paths::sanitized()) return; // twice the same sources: what is compared is not the library's own
  const Folder folder;
  const Result made = run_shell("make -s -C '" + kRoot + "' amalgamation BUILD='" + folder.path() + "' MAKEFLAGS=");
  REQUIRE_MESSAGE(made.status == 0, made.out << made.err);
  const std::string place = folder / "amalgamation";
  // the public headers are all it needs
  for (const char* unwanted : {"#include \"linalg", "#include \"memory", "#include \"c2d_memory.h\""})
    CHECK_FALSE(contains(read_file(place + "/contact2d.cpp"), unwanted));
  const std::string options =
      matched(read_file(kRoot + "/include/README.md"), "g\\+\\+( -std=c\\+\\+17 [^`]*-c contact2d\\.cpp)");
  REQUIRE(options != "");
  const Result compiled = run_shell("cd '" + place + "' && " + paths::cxx_compiler() + options);
  REQUIRE_MESSAGE(compiled.status == 0, compiled.err);
  CHECK(compiled.err == "");
  write_file(place + "/host.c", kHost);
  const std::string cc = "cd '" + place + "' && " + paths::c_compiler() + " -std=c99 host.c ";
  const Result one = run_shell(cc + "contact2d.o -I. -lm -o one");
  REQUIRE_MESSAGE(one.status == 0, one.err);
  const Result library = run_shell(cc + "-I. '" + paths::library() + "' -lm -o library");
  REQUIRE_MESSAGE(library.status == 0, library.err);
  const std::string deck = " '" + kRoot + "/examples/hertz.dat'";
  const std::vector<double> ours = numbers(run_shell("'" + place + "/library'" + deck).out),
                            theirs = numbers(run_shell("'" + place + "/one'" + deck).out);
  REQUIRE(ours.size() == 2u * 28u * 15u * C2D_PAIR_FIELDS);
  REQUIRE(theirs.size() == ours.size());
  std::vector<double> largest(C2D_PAIR_FIELDS, 0.0);
  for (size_t i = 0; i < ours.size(); ++i)
    largest[i % C2D_PAIR_FIELDS] = std::max(largest[i % C2D_PAIR_FIELDS], std::fabs(ours[i]));
  // tractions are measured by the pressure, displacements and gaps by the normal displacement
  for (const int c : {C2D_TT}) largest[static_cast<size_t>(c)] = largest[C2D_TN];
  for (const int c : {C2D_UT1, C2D_UT2, C2D_GAP, C2D_SLIP_SUM, C2D_UN1}) largest[static_cast<size_t>(c)] = largest[C2D_UN2];
  for (size_t i = 0; i < ours.size(); ++i)
    CHECK_MESSAGE(std::fabs(ours[i] - theirs[i]) <= 1e-9 * largest[i % C2D_PAIR_FIELDS], i);
}
