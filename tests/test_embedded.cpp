// The library on Cortex-M3, M4F and M7: the sample deck in an emulator against this machine's run.
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <math.h>

// The port's mathematics under other names; what it takes from newlib is the C library's here.
namespace firmware {
extern "C" {
double firmware_sqrt(double), firmware_log(double), firmware_exp(double), firmware_sin(double), firmware_cos(double);
double firmware_atan2(double, double), firmware_fmod(double, double), firmware_hypot(double, double);
double firmware_ldexp(double, int);
}
} // namespace firmware
extern "C" {
double __ieee754_sqrt(double x) { return sqrt(x); }
}
#define sqrt firmware_sqrt
#define log firmware_log
#define exp firmware_exp
#define sin firmware_sin
#define cos firmware_cos
#define atan2 firmware_atan2
#define fmod firmware_fmod
#define hypot firmware_hypot
#define ldexp firmware_ldexp
#include "../port/cortex-m/math.cpp"
#undef sqrt
#undef log
#undef exp
#undef sin
#undef cos
#undef atan2
#undef fmod
#undef hypot
#undef ldexp

using namespace test;

namespace {

struct Board {
  const char *name, *machine, *tolerance;
};
constexpr Board kBoards[] = {{"m3", "lm3s6965evb", "1e-9"}, {"m4f", "mps2-an386", "2e-4"}, {"m7", "mps2-an500", "1e-9"}};

const std::string kFolder = paths::build() + "/embedded/";

// Images are built by C2D_ALL_HOSTS=1 make test-all (and make embedded); older ones tell nothing.
bool skipped() {
  if (std::getenv("C2D_ALL_HOSTS") != nullptr) return false;
  MESSAGE("skipped: Cortex-M boards (C2D_ALL_HOSTS=1 make test-all; needs arm-none-eabi-g++ and qemu-system-arm)");
  return true;
}

// Errors in units of the last place of the true value.
double ulps(double value, long double truth) {
  int exponent;
  std::frexp(static_cast<double>(truth), &exponent);
  return static_cast<double>(std::fabs(value - truth) / std::ldexp(1.0L, exponent - 53));
}

} // namespace

TEST_CASE("embedded: the port's logarithm, exponential, sine and cosine are right to 1.5 units in the last place") {
  double worst[4] = {};
  for (int i = 1; i < 20000; ++i) {
    const double x = i * 0.00271, wide = std::ldexp(x, i % 600 - 300), angle = (i % 2 ? 1 : -1) * x * 37.0;
    worst[0] = std::max(worst[0], ulps(firmware_log(wide), logl(wide)));
    worst[1] = std::max(worst[1], ulps(firmware_exp(i % 2 ? x : -x), expl(i % 2 ? x : -x)));
    worst[2] = std::max(worst[2], ulps(firmware_sin(angle), sinl(angle)));
    worst[3] = std::max(worst[3], ulps(firmware_cos(angle), cosl(angle)));
  }
  for (const double error : worst) CHECK(error < 1.5);
  CHECK(firmware_log(1.0) == 0.0);
  CHECK(firmware_exp(0.0) == 1.0);
  CHECK(firmware_log(5e-324) == doctest::Approx(-744.4400719213812).epsilon(1e-15));
  CHECK(firmware_exp(-701.0) == 0.0);
}

TEST_CASE("embedded: the port's hypotenuse, angle, remainder and powers of two") {
  double worst[2] = {};
  for (int i = 1; i < 20000; ++i) {
    const double x = (i % 2 ? 1 : -1) * std::ldexp(i * 0.00271, i % 61 - 30), y = (i % 3 ? 1 : -1) * i * 0.00137;
    worst[0] = std::max(worst[0], ulps(firmware_hypot(x, y), hypotl(x, y)));
    worst[1] = std::max(worst[1], ulps(firmware_atan2(y, x), atan2l(y, x)));
    CHECK(firmware_fmod(x, y) == std::fmod(x, y));
    CHECK(firmware_fmod(1e9 * x, 360.0) == std::fmod(1e9 * x, 360.0));
    CHECK(firmware_ldexp(x, i % 1500 - 750) == std::ldexp(x, i % 1500 - 750));
  }
  for (const double error : worst) CHECK(error < 3.5);
  for (const double x : {0.0, -0.0, 1.0, -1.0, 1e-300, 1e300})
    for (const double y : {0.0, -0.0, 1.0, -1.0, 1e-300, 1e300}) {
      CHECK(firmware_atan2(y, x) == doctest::Approx(std::atan2(y, x)).epsilon(1e-15));
      CHECK(std::signbit(firmware_atan2(y, x)) == std::signbit(std::atan2(y, x)));
      CHECK(firmware_hypot(x, y) == doctest::Approx(std::hypot(x, y)).epsilon(1e-15));
    }
  CHECK(std::signbit(firmware_fmod(-720.0, 360.0)));
  CHECK(firmware_fmod(1e100, 360.0) == std::fmod(1e100, 360.0));
  CHECK(firmware_fmod(5.0, 1e300) == 5.0);
}

TEST_CASE("embedded: the sample deck on three boards, blocks in files, agrees with this machine") {
  if (skipped()) return;
  const Folder folder;
  const std::string root = paths::root(), desktop = folder / "desktop.csv";
  REQUIRE(run_shell("'" + paths::program() + "' run '" + root + "/examples/hertz.dat' --no-progress --listing '" +
                    (folder / "lst") + "' --csv '" + desktop + "'")
              .status == 0);
  write_file(folder / "deck.dat", read_file(root + "/examples/hertz.dat")); // a name without blanks, which part arguments
  for (const Board& board : kBoards) {
    CAPTURE(board.name);
    const std::string image = kFolder + board.name + "/run_deck.elf", csv = folder / board.name;
    REQUIRE_MESSAGE(fs::exists(image), image << " is not there: is arm-none-eabi-g++ installed?");
    fs::create_directories(folder / "tapes");
    const Result run =
        run_shell("cd '" + folder.path() + "' && qemu-system-arm -M " + board.machine +
                  " -nographic -monitor none -serial none -kernel '" + image +
                  "' -semihosting-config enable=on,target=native,arg=deck.dat,arg=tapes,arg=" + board.name + " </dev/null");
    CHECK_MESSAGE(run.status == 0, run.out << run.err);
    for (const char* tape : {"tapes/tape1.c2d", "tapes/tape2.c2d", "tapes/tape3.c2d"}) {
      REQUIRE_MESSAGE(fs::exists(folder / tape), tape);
      CHECK_MESSAGE(fs::file_size(folder / tape) > 4096, tape);
    }
    fs::remove_all(folder / "tapes");
    const Result agrees = run_shell("'" + kFolder + "compare' '" + desktop + "' '" + csv + "' " + board.tolerance);
    CHECK_MESSAGE(agrees.status == 0, agrees.out << agrees.err);
  }
}

TEST_CASE("embedded: no heap, no errno, no struct of the C library in the images") {
  if (skipped()) return;
  for (const Board& board : kBoards) {
    CAPTURE(board.name);
    const std::string image = kFolder + board.name + "/run_deck.elf";
    const Result names = run_shell("arm-none-eabi-nm -P '" + image + "'");
    REQUIRE(names.status == 0);
    CHECK(contains(names.out, "c2d_run"));
    for (const char* part : {"_sbrk", "errno", "_reent", "_impure", "malloc", "heap", "_Unwind", "__cxa", "_Zn", "_Zd"})
      CHECK_FALSE_MESSAGE(contains(names.out, part), part);
    const Result sections = run_shell("arm-none-eabi-objdump -h '" + image + "'");
    CHECK(contains(sections.out, ".bss"));
    CHECK_FALSE(contains(sections.out, "heap"));
    CHECK_FALSE(contains(sections.out, "exidx"));
  }
}

namespace {

// Cells of the rows of a table, by their first two cells ("m7 whole").
std::map<std::string, std::vector<std::string>> table_rows(const std::string& text) {
  std::map<std::string, std::vector<std::string>> rows;
  for (const std::string& line : lines_of(text)) {
    if (line.compare(0, 2, "| ") != 0) continue;
    std::vector<std::string> cells;
    std::istringstream in(line.substr(2));
    for (std::string cell; std::getline(in, cell, '|');) {
      const size_t first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
      cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
    }
    if (cells.size() >= 8) rows[cells[0] + ' ' + cells[1]] = cells;
  }
  return rows;
}

constexpr long kStackOfAnyCall = 4096; // bytes, the caller's callbacks apart

} // namespace

// Another version of the compiler may differ by a few per cent; more means that the table is old.
TEST_CASE("embedded: the bill of the page is what make footprint prints, and stacks stay within 4 KiB") {
  if (skipped()) return;
  const auto page = table_rows(read_file(paths::root() + "/port/cortex-m/README.md"));
  for (const char* target : {"desktop", "m3", "m4f", "m7"}) {
    const std::string bill = kFolder + target + "/bill";
    REQUIRE_MESSAGE(fs::exists(bill), bill);
    const auto rows = table_rows(read_file(bill));
    CHECK(rows.size() == 7);
    for (const auto& row : rows) {
      CAPTURE(row.first);
      const auto told = page.find(row.first);
      REQUIRE(told != page.end());
      for (size_t i = 2; i < 8; ++i) {
        const double now = std::atof(row.second[i].c_str()), then = std::atof(told->second[i].c_str());
        CHECK_MESSAGE(std::fabs(now - then) <= 0.03 * now, "column " << i << ": " << now << ", the page says " << then);
      }
      if (std::string(target) != "desktop") {
        CHECK(std::atol(row.second[5].c_str()) <= kStackOfAnyCall);
        CHECK(std::atol(row.second[4].c_str()) == 0); // no static data
      }
    }
  }
}

// The parts of src/memory/parts.hpp, and a function or two of each file that only they need.
TEST_CASE("embedded: parts that no call declares are not linked, and come with the call") {
  if (skipped()) return;
  struct Part {
    const char* call;
    std::vector<std::string> names;
    bool deck_brings = false; // c2d_run or the deck reader
  };
  const Part parts[] = {
      {"c2d_link_free_zones", {"c2d::fit_free_zone", "c2d::fill_transfer", "c2d::surface_faced", "c2d::transferred_values"}},
      {"c2d_link_holes", {"c2d::next_hole", "c2d::hole_row", "c2d::hole_load"}},
      {"c2d_add_curve", {"c2d::validate_curves"}, true},
      {"c2d_set_body_force", {"c2d::particular_solution", "c2d::add_body_force_columns", "c2d::check_body_force"}},
      {"c2d_set_rigid", {"c2d::check_rigid", "c2d::reduce_rigid", "c2d::fill_rigid"}},
      {"c2d_set_symmetry", {"c2d::validate_lines", "c2d::is_held_by_lines", "c2d::fold_across"}},
      {"c2d_get_summary", {"c2d::build_energy", "c2d::close_balance", "c2d::balance_forces", "c2d::keep_motion"}, true},
      {"c2d_link_warnings",
       {"c2d::warn_contact", "c2d::tell_coarse_contact", "c2d::warn_surfaces", "c2d::find_condition"},
       true},
      {"c2d_link_search", {"c2d::branch_cells", "c2d::limit_analysis", "c2d::follow_cells", "c2d::try_let_go"}, true},
      {"c2d_change_loads", {"c2d::eliminate_again", "c2d::reduce_loads"}},
  };
  const Folder folder;
  const std::string root = paths::root();
  for (const Board& board : kBoards) {
    const std::string place = kFolder + board.name;
    const auto names_in = [&](const std::string& image) { return run_shell("arm-none-eabi-nm -C '" + image + "'").out; };
    const std::string solver = names_in(place + "/solver.elf"), deck = names_in(place + "/solver-deck.elf");
    CHECK(contains(solver, "c2d_interior"));
    CHECK(contains(deck, "c2d_read_deck"));
    for (const Part& part : parts) {
      CAPTURE(part.call);
      const std::string image = folder / "part.elf";
      const Result linked = run_shell("cd '" + root +
                                      "' && arm-none-eabi-g++ -nostdlib -Wl,--gc-sections -Wl,-e,c2d_create "
                                      "-Wl,-u,c2d_complete -Wl,-u,c2d_prepare -Wl,-u,c2d_advance -Wl,-u,c2d_interior -Wl,-u," +
                                      part.call + " -T port/cortex-m/sizes.ld '" + place + "/obj/port_cortex-m_math.o' '" +
                                      place + "/obj/libcontact2d.a' -lm -lc_nano -lgcc -o '" + image + "'" +
                                      (board.name[1] == '3'   ? " -mcpu=cortex-m3 -mthumb -mfloat-abi=soft"
                                       : board.name[1] == '4' ? " -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard"
                                                              : " -mcpu=cortex-m7 -mthumb -mfpu=fpv5-d16 -mfloat-abi=hard"));
      REQUIRE_MESSAGE(linked.status == 0, linked.err);
      const std::string with = names_in(image);
      for (const std::string& name : part.names) {
        CHECK_MESSAGE(contains(with, name + '('), name);
        CHECK_MESSAGE(!contains(solver, name + '('), name);
        if (!part.deck_brings) CHECK_MESSAGE(!contains(deck, name + '('), name);
      }
    }
  }
}

TEST_CASE("embedded: what is not called is not linked") {
  if (skipped()) return;
  for (const Board& board : kBoards) {
    const Result points = run_shell("arm-none-eabi-nm -C '" + kFolder + board.name + "/no-points.elf'"),
                 deck = run_shell("arm-none-eabi-nm -C '" + kFolder + board.name + "/no-deck.elf'"),
                 whole = run_shell("arm-none-eabi-nm -C '" + kFolder + board.name + "/whole.elf'");
    for (const char* name : {"c2d_interior", "c2d::read_deck_cards", "c2d::read_nodes"}) CHECK(contains(whole.out, name));
    CHECK(contains(whole.out, "c2d::fold_across("));
    CHECK_FALSE(contains(points.out, "c2d_interior"));
    for (const char* name : {"c2d_read_deck", "c2d::read_deck_cards", "c2d::read_nodes", "c2d::read_extensions"})
      CHECK_FALSE(contains(deck.out, name));
  }
}
