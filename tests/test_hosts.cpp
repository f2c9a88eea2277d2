// The library in other people's programs: C, C++, Fortran of two ages, Python. Each host solves the sample
// and must find what the program finds.
#include "contact2d.h"
#include "hosts.hpp"
#include "paths.hpp"

#include <set>

using namespace test;

namespace {

const std::string kRoot = paths::root(), kDeck = kRoot + "/examples/hertz.dat";
const std::string kTraps = " -ffpe-trap=invalid,zero,overflow";
const std::string kC = paths::c_compiler(), kCxx = paths::cxx_compiler(); // with flags, perhaps

const std::vector<Peak>& expected() {
  static const std::vector<Peak> peaks = desktop_peaks(kDeck);
  return peaks;
}

void check_built(const std::string& command) {
  const Result built = run_shell(command);
  REQUIRE_MESSAGE(built.status == 0, command << "\n" << built.out << built.err);
}

// What a program asks the loader for: nothing of the C++ run-time.
void check_needs(const Libraries& libraries, const std::string& program) {
  if (!has_command("readelf")) return;
  const Result needs = run_shell("readelf -d '" + (libraries / program) + "'");
  CHECK_MESSAGE(!contains(needs.out, "libstdc++"), needs.out);
}

// Compiles sources of Fortran in a folder of its own, where the .mod file goes.
void build_fortran(const Libraries& libraries, const std::string& flags, const std::string& sources, const std::string& kind,
                   const std::string& program) {
  check_built("cd '" + (libraries / "static") + "/..' && gfortran " + flags + " " + sources + libraries.link(kind) + " -o '" +
              (libraries / program) + "'");
  check_needs(libraries, program);
}

std::string example(const std::string& name) { return "'" + kRoot + "/examples/fortran/" + name + "'"; }

} // namespace

TEST_CASE("hosts: C, linked with cc, -lcontact2d and -lm, static and shared") {
  if (!can_host("cc")) return;
  const Libraries libraries;
  const std::string compile =
      kC + " -std=c99 -I'" + kRoot + "/include' -I'" + kRoot + "/port/memory' '" + kRoot + "/examples/static_array.c'";
  for (const std::string kind : {"static", "shared"}) {
    check_built(compile + libraries.link(kind) + " -lm -o '" + (libraries / "host") + "'");
    check_needs(libraries, "host");
    const Result run = run_shell(libraries.run("host") + " '" + kDeck + "'");
    CHECK_MESSAGE(run.status == 0, run.out << run.err);
    check_peaks(peaks_of(run.out), expected(), 0.6e-4);
  }
}

TEST_CASE("hosts: C++ with a wrapper that owns memory and solver") {
  if (!can_host("cc")) return;
  const Libraries libraries;
  check_built(kCxx + " -std=c++17 -Wall -Wextra -Wpedantic -Werror -I'" + kRoot + "/include' -I'" + kRoot + "/port/memory' '" +
              kRoot + "/examples/raii.cpp'" + libraries.link("shared") + " -o '" + (libraries / "host") + "'");
  const Result run = run_shell(libraries.run("host") + " '" + kDeck + "'");
  CHECK_MESSAGE(run.status == 0, run.out << run.err);
  check_peaks(peaks_of(run.out), expected(), 0.6e-10);
  // A failure arrives as an exception with the library's words.
  const Result refused = run_shell(libraries.run("host") + " '" + kRoot + "/examples/raii.cpp'");
  CHECK(refused.status == 1);
  CHECK(!refused.out.empty());
}

TEST_CASE("hosts: Python, its standard library alone") {
  if (!can_host("python3")) return;
  const std::string script = "import contact2d, sys\n"
                             "solver = contact2d.Solver.of_deck(sys.argv[1])\n"
                             "solver.prepare()\n"
                             "solver.run(lambda now: print('mu %.4f  step %d  load %.5f  peak pressure %.10f' %\n"
                             "                             (now.mu, now.step, now.load, max(now.table['tn']))))\n";
  const Result run = run_shell("PYTHONDONTWRITEBYTECODE=1 PYTHONPATH='" + kRoot + "/port/python' CONTACT2D_LIBRARY='" +
                               paths::shared() + "' python3 -c \"" + script + "\" '" + kDeck + "'");
  CHECK_MESSAGE(run.status == 0, run.out << run.err);
  check_peaks(peaks_of(run.out), expected(), 0.6e-10);
}

TEST_CASE("hosts: Fortran 2008 through the module, whatever the default kinds are, with traps") {
  if (!can_host("gfortran")) return;
  const Libraries libraries;
  const std::string sources = "'" + kRoot + "/port/fortran/contact2d.f90' " + example("contact.f90");
  const struct {
    const char *flags, *kind;
  } builds[] = {{"-std=f2008 -Wall -Wextra -Werror", "shared"}, {"-std=f2008 -fdefault-integer-8 -fdefault-real-8", "static"}};
  for (const auto& build : builds) {
    build_fortran(libraries, build.flags + kTraps, sources, build.kind, "host");
    const Result run = run_shell(libraries.run("host") + " '" + kDeck + "'");
    CHECK_MESSAGE(run.status == 0, build.flags << "\n" << run.out << run.err);
    check_peaks(peaks_of(run.out), expected(), 0.6e-10);
  }
  const Result refused = run_shell(libraries.run("host") + " '" + kRoot + "/examples/raii.cpp'");
  CHECK(refused.status == 1);
  CHECK_MESSAGE(contains(refused.out, "deck: the deck or the model has faults"), refused.out << refused.err);
  const Result without = run_shell(libraries.run("host")), missing = run_shell(libraries.run("host") + " no_such_deck");
  CHECK(without.status == 1);
  CHECK(without.out == "usage: contact DECK\n");
  CHECK(missing.status == 1);
  CHECK_MESSAGE(contains(missing.out, "contact: "), missing.out << missing.err);
  CHECK_MESSAGE(contains(missing.out, "no_such_deck"), missing.out << missing.err);
  for (const Result& run : {without, missing}) CHECK_MESSAGE(run.err == "STOP 1\n", run.err); // no backtrace
}

TEST_CASE("hosts: a legacy program whose COMMON block is the workspace, aligned or not, with traps") {
  if (!can_host("gfortran")) return;
  const Libraries libraries;
  const struct {
    const char *flags, *kind;
  } builds[] = {{"-std=legacy -O2", "static"},
                {"-std=legacy -fno-align-commons", "shared"},
                {"-std=legacy -fdefault-real-8 -fdefault-double-8", "static"}}; // REAL*8 and 0.3D0 stay what they are
  for (const auto& build : builds) {
    build_fortran(libraries, build.flags + kTraps + " -w", example("legacy.f"), build.kind, "host");
    const Result run = run_shell(libraries.run("host") + " <'" + kDeck + "'");
    CHECK_MESSAGE(run.status == 0, build.flags << "\n" << run.out << run.err);
    check_peaks(peaks_of(run.out), expected(), 0.6e-10);
    // Its own loop over the 14 load cards, without the stop half-way: events do not depend on that.
    const std::vector<Peak> own = peaks_of(run.out, true);
    REQUIRE(own.size() == 14);
    for (size_t i = 0; i < own.size(); ++i) {
      const Peak& card = expected()[2 * i + 1];
      CHECK(own[i].load == doctest::Approx(card.load));
      CHECK(own[i].pressure == doctest::Approx(card.pressure).epsilon(1e-8));
    }
  }
  const Result refused = run_shell(libraries.run("host") + " <'" + kRoot + "/examples/raii.cpp'");
  CHECK(refused.status == 1);
  CHECK_MESSAGE(contains(refused.out, "C2CARD SAYS   7"), refused.out);
}

TEST_CASE("hosts: a legacy program compiled with other lengths of numbers is told so") {
  if (!can_host("gfortran")) return;
  const Libraries libraries;
  const struct {
    const char *flags, *says;
  } builds[] = {{"-fdefault-integer-8", "C2OPEN SAYS  51"},
                {"-freal-8-real-16", "C2OPEN SAYS  52"},
                {"-fdefault-real-8", "C2OPEN SAYS  52"}, // 0.3D0 has 16 bytes
                {"-freal-8-real-4", "C2OPEN SAYS  52"}};
  for (const auto& build : builds) {
    build_fortran(libraries, std::string("-std=legacy -w ") + build.flags, example("legacy.f"), "static", "host");
    const Result run = run_shell(libraries.run("host") + " <'" + kDeck + "'");
    CHECK_MESSAGE(run.status == 3, build.flags << "\n" << run.out << run.err);
    CHECK_MESSAGE(contains(run.out, build.says), run.out);
  }
}

namespace {

// A coefficient of friction that stands in the call, and comes back.
const char kLiteralProgram[] = R"(      PROGRAM LITRAL
      REAL*8 WORK(20000), FMU
      INTEGER*4 IERR, ICHECK(2), ISIZE(13)
      DATA ICHECK /1987, 64/
      DATA ISIZE /2, 2, 8, 8, 8, 8, 1, 1, 1, 3, 2, 0, 1/
      CALL C2OPEN (WORK, 20000, ICHECK, 1987.015625D0, IERR)
      IF (IERR .EQ. 0) CALL C2SIZE (WORK, ISIZE, 13, IERR)
      IF (IERR .EQ. 0) CALL C2PROB (WORK, 0, 2, 0, 'LITERALS', 8, IERR)
      IF (IERR .EQ. 0) CALL C2MU (WORK, 0.3D0, IERR)
      WRITE (6, 100) IERR
      CALL C2MU (WORK, -0.3D0, IERR)
      WRITE (6, 100) IERR
  100 FORMAT (' IERR', I4)
      END
)";

} // namespace

TEST_CASE("hosts: literals of a FORTRAN 77 program are read right, or C2OPEN refuses") {
  if (!can_host("gfortran")) return;
  const Libraries libraries;
  write_file(libraries / "literal.f", kLiteralProgram);
  const struct {
    const char *flags, *says;
  } builds[] = {{"", " IERR   0\n IERR   1\n"},
                {"-fdefault-integer-8", nullptr},
                {"-fdefault-real-8 -fdefault-double-8", " IERR   0\n IERR   1\n"},
                {"-fdefault-real-8", " IERR  52\n IERR  54\n"},
                {"-freal-8-real-16", " IERR  52\n IERR  54\n"},
                {"-freal-8-real-10", " IERR  52\n IERR  54\n"},
                {"-freal-8-real-4", " IERR  52\n IERR  54\n"}};
  for (const auto& build : builds) {
    build_fortran(libraries, std::string("-std=legacy -w ") + build.flags, "'" + (libraries / "literal.f") + "'", "static",
                  "host");
    const Result run = run_shell(libraries.run("host"));
    // An INTEGER of 8 bytes begins like one of 4 where the low end comes first.
    const int32_t one = 1;
    const bool low_first = *reinterpret_cast<const char*>(&one) == 1;
    if (build.says == nullptr && !low_first) continue;
    CHECK_MESSAGE(run.out == (build.says == nullptr ? builds[0].says : build.says), build.flags << "\n" << run.out << run.err);
  }
}

TEST_CASE("hosts: names without an underscore and in capitals, as the page makes them") {
  if (!can_host("gfortran") || !can_host("objcopy")) return;
  const std::string page = read_file(kRoot + "/port/fortran/README.md");
  const size_t from = page.find("nm -g"), to = page.find("gfortran", from);
  REQUIRE(to < page.size());
  std::string commands = page.substr(from, to - from);
  const Libraries libraries;
  fs::create_directories(libraries / "build");
  fs::create_symlink(paths::library(), libraries / "build/libcontact2d.a");
  const std::string go = "cd '" + (libraries / ".") + "' && ";
  check_built(go + commands);
  write_file(libraries / "literal.f", kLiteralProgram);
  check_built(go + "gfortran -std=legacy -w -fno-underscoring literal.f build/libcontact2d_plain.a -o host && ./host > out");
  CHECK(read_file(libraries / "out") == " IERR   0\n IERR   1\n");
  // No option of gfortran writes capitals: a C program calls them so.
  const size_t last = commands.rfind("\\1/p");
  REQUIRE(last < commands.size());
  commands.replace(last, 2, "\\U\\1");
  check_built(go + commands);
  write_file(libraries / "capitals.c",
             "#include <stdio.h>\nextern void C2VERS(char*, int*);\n"
             "int main(void) { char text[6] = \"\"; int n = 5; C2VERS(text, &n); puts(text); return 0; }\n");
  check_built(go + "cc capitals.c build/libcontact2d_plain.a -lm -o host && ./host > out");
  CHECK(read_file(libraries / "out") == std::string(c2d_version()) + "\n");
}

TEST_CASE("hosts: a model by calls of FORTRAN 77 has the pressure of the closed form") {
  if (!can_host("gfortran")) return;
  const Libraries libraries;
  for (const std::string flags : {"-std=legacy -Wall -Werror", "-std=legacy -fcheck=all"}) {
    build_fortran(libraries, flags + kTraps, example("blocks.f"), "static", "host");
    const Result run = run_shell(libraries.run("host"));
    CHECK_MESSAGE(run.status == 0, run.out << run.err);
    const std::vector<std::string> lines = lines_of(run.out);
    REQUIRE(lines.size() == 4);
    const double pressure = 1000.0 / (1 - 0.09) * 0.005; // E/(1 - nu^2) times the strain
    int outcome = -1, slipping = 0;
    double p[5], force = 0, syy[3];
    REQUIRE(std::sscanf(lines[0].c_str(), " OUTCOME %d PRESSURE %lf %lf %lf %lf %lf", &outcome, p, p + 1, p + 2, p + 3,
                        p + 4) == 6);
    REQUIRE(std::sscanf(lines[1].c_str(), " PAIRS SLIPPING %d FORCE ON BLOCK 2 %lf", &slipping, &force) == 2);
    REQUIRE(std::sscanf(lines[2].c_str(), " STRESS INSIDE %lf %lf %lf", syy, syy + 1, syy + 2) == 3);
    CHECK(outcome == 0);
    CHECK(slipping == 5);
    for (const double each : p) CHECK(each == doctest::Approx(pressure).epsilon(1e-9)); // the digits printed
    CHECK(force == doctest::Approx(pressure).epsilon(1e-9));                            // over a length of 1
    for (const double each : syy) CHECK(each == doctest::Approx(-pressure).epsilon(1e-9));
    REQUIRE(std::sscanf(lines[3].c_str(), " OUTCOME %d PRESSURE %lf %lf %lf %lf %lf", &outcome, p, p + 1, p + 2, p + 3,
                        p + 4) == 6); // twice as far, through the factors that were kept
    CHECK(outcome == 0);
    for (const double each : p) CHECK(each == doctest::Approx(2 * pressure).epsilon(1e-9));
  }
}

namespace {

// Names with their versions, as port/packaging/contact2d.symbols has them.
std::set<std::string> exported_names() {
  std::set<std::string> out;
  for (const std::string& line :
       lines_of(run_shell("nm -D --defined-only --with-symbol-versions '" + paths::shared() + "'").out)) {
    const size_t blank = line.rfind(' ');
    std::string name = line.substr(blank + 1);
    const size_t twice = name.find("@@");
    if (twice != std::string::npos) name.erase(twice, 1);
    if (!contains(line, " A ")) out.insert(name); // A: the version itself
  }
  return out;
}

} // namespace

TEST_CASE("hosts: the shared library exports what contact2d.symbols lists, and nothing else") {
  if (paths::sanitized() || !has_command("nm") || !has_command("readelf")) return;
  std::set<std::string> listed;
  for (const std::string& line : lines_of(read_file(kRoot + "/port/packaging/contact2d.symbols")))
    if (line[0] == ' ') listed.insert(line.substr(1, line.find(' ', 1) - 1));
  const std::set<std::string> found = exported_names();
  REQUIRE(found.size() > 80);
  for (const std::string& name : found) CHECK_MESSAGE(listed.count(name) == 1, name << ": new? make symbols");
  for (const std::string& name : listed) CHECK_MESSAGE(found.count(name) == 1, name << " is gone");
  const std::string dynamic = run_shell("readelf -d '" + paths::shared() + "'").out;
  CHECK_MESSAGE(contains(dynamic, "[libcontact2d.so.0.2]"), dynamic);
  CHECK_MESSAGE(!contains(dynamic, "libstdc++"), dynamic);
  // Both build systems link by the same script.
  for (const char* file : {"/Makefile", "/CMakeLists.txt"})
    CHECK(contains(read_file(kRoot + file), "port/packaging/contact2d.map"));
}
