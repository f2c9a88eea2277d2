// The house itself: order of includes, the list of sources, ASCII, the public header in C and C++, the
// example.
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

using namespace test;

namespace {

const fs::path kRoot = paths::root();

bool is_source(const fs::path& path) {
  const std::string e = path.extension().string();
  return e == ".cpp" || e == ".hpp" || e == ".c" || e == ".h";
}

std::vector<fs::path> files_below(const std::string& folder) {
  std::vector<fs::path> out;
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder))
    if (entry.is_regular_file()) out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  return out;
}

// What stands between the quotes or angle brackets of a file's #include lines, outside // comments.
std::vector<std::string> includes_of(const fs::path& path) {
  std::vector<std::string> out;
  for (const std::string& line : lines_of(read_file(path.string()))) {
    const size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || line[hash] != '#') continue;
    const size_t word = line.find("include", hash);
    const size_t open = line.find_first_of("\"<", hash);
    const size_t close = open == std::string::npos ? open : line.find_first_of("\">", open + 1);
    if (word != std::string::npos && close != std::string::npos && word < open)
      out.push_back(line.substr(open + 1, close - open - 1));
  }
  return out;
}

int level_of(const std::string& folder) {
  static const std::map<std::string, int> kLevels = {{"memory", 0},  {"quadrature", 0}, {"linalg", 0},  {"store", 0},
                                                     {"model", 1},   {"deck", 2},       {"bie", 2},     {"elimination", 3},
                                                     {"contact", 4}, {"solver", 5},     {"results", 6}, {"interface", 7},
                                                     {"post", 8},    {"report", 9},     {"program", 10}};
  const auto found = kLevels.find(folder);
  return found == kLevels.end() ? -1 : found->second;
}

// The folder below src/ of a file that is named from the root.
std::string folder_of(const std::string& name) { return name.substr(4, name.find('/', 4) - 4); }

std::string name_of(const fs::path& path) { return fs::relative(path, kRoot).generic_string(); }

} // namespace

TEST_CASE("build: a file of src/ includes only downward") {
  int seen = 0;
  for (const fs::path& path : files_below("src")) {
    if (!is_source(path)) continue;
    const std::string name = name_of(path);
    const std::string folder = folder_of(name);
    const int level = level_of(folder);
    CHECK_MESSAGE(level >= 0, name << ": folder " << folder << " has no place in the order");
    for (const std::string& include : includes_of(path)) {
      const size_t slash = include.find('/');
      const int other = slash == std::string::npos ? -1 : level_of(include.substr(0, slash));
      if (other < 0) continue;
      ++seen;
      CHECK_MESSAGE(other <= level, name << " includes " << include);
      CHECK_MESSAGE(fs::exists(kRoot / "src" / include), name << " includes " << include << ", which is not there");
    }
  }
  CHECK(seen > 20);
}

// By the library's object files, which are named after folder and source here.
TEST_CASE("build: a file of the core calls only downward") {
  const Result listing = run_shell("nm -A '" + paths::library() + "' 2>&1");
  if (listing.status != 0 || listing.out.find("solver_prepare.o") == std::string::npos) {
    MESSAGE("skipped: needs nm, and objects named by make");
    return;
  }
  std::map<std::string, std::string> home; // of a symbol: the object that defines it
  std::vector<std::pair<std::string, std::string>> uses;
  for (const std::string& line : lines_of(listing.out)) {
    const size_t end = line.find(".o:"), at = line.rfind(' ');
    if (end == std::string::npos || at == std::string::npos || at < 2) continue;
    const size_t start = line.rfind(':', end - 1) + 1;
    const std::string object = line.substr(start, end - start), symbol = line.substr(at + 1);
    const char kind = line[at - 1];
    if (kind == 'T' || kind == 'D' || kind == 'R') home[symbol] = object;
    if (kind == 'U' || kind == 'w') uses.push_back({object, symbol});
  }
  int seen = 0;
  for (const auto& use : uses) {
    const auto there = home.find(use.second);
    if (there == home.end()) continue;
    const int from = level_of(use.first.substr(0, use.first.find('_')));
    const int to = level_of(there->second.substr(0, there->second.find('_')));
    ++seen;
    CHECK_MESSAGE((from < 0 || to <= from), use.first << " calls " << use.second << " of " << there->second);
  }
  CHECK(seen > 500);
}

TEST_CASE("build: the core includes no header of an operating system or of the C++ run-time") {
  static const std::set<std::string> kAllowed = {
      "stdint.h",          "stddef.h",          "string.h",           "math.h", "float.h", "contact2d.h", "contact2d_cards.h",
      "contact2d_cycle.h", "contact2d_image.h", "contact2d_memory.h", "cpuid.h"}; // the processor's own answers
  for (const fs::path& path : files_below("src")) {
    const std::string name = name_of(path);
    if (!is_source(path) || level_of(folder_of(name)) >= level_of("post")) continue;
    for (const std::string& include : includes_of(path)) {
      const bool own = include.find('/') != std::string::npos && level_of(include.substr(0, include.find('/'))) >= 0;
      CHECK_MESSAGE((own || kAllowed.count(include) == 1), name << " includes " << include);
    }
  }
}

// The options of memory/config.hpp, and what compilers say of their own.
TEST_CASE("build: the configuration header alone asks for a build's options") {
  const std::string page = read_file((kRoot / "src/memory/config.hpp").string());
  int seen = 0;
  for (const char* option :
       {"C2D_REAL", "C2D_REAL_BYTES", "C2D_SMALL", "C2D_PARTS_BY_CALL", "C2D_RINGS", "C2D_PLAIN", "C2D_ONE_FILE", "C2D_HOSTILE",
        "C2D_COUNTED", "__OPTIMIZE_SIZE__", "__OPTIMIZE__", "__FAST_MATH__", "__FINITE_MATH_ONLY__", "NDEBUG"}) {
    const std::string name = option;
    if (name.compare(0, 4, "C2D_") == 0) CHECK_MESSAGE(contains(page, "-D" + name), name << " has no entry in the header");
    for (const std::string& folder : {std::string("src"), std::string("tests")})
      for (const fs::path& path : files_below(folder)) {
        if (!is_source(path)) continue;
        for (const std::string& line : lines_of(read_file(path.string()))) {
          if (line.compare(0, 1, "#") != 0) continue;
          const size_t at = line.find(name), end = at + name.size();
          if (at == std::string::npos || (end < line.size() && (std::isalnum(line[end]) != 0 || line[end] == '_'))) continue;
          ++seen;
          CHECK_MESSAGE(name_of(path) == "src/memory/config.hpp", name_of(path) << ": " << line);
        }
      }
  }
  CHECK(seen >= 10);
}

TEST_CASE("build: report and program use the public interface alone") {
  for (const fs::path& path : files_below("src")) {
    const std::string name = name_of(path);
    if (level_of(folder_of(name)) < level_of("post")) continue;
    for (const std::string& include : includes_of(path)) {
      const size_t slash = include.find('/');
      const int level = slash == std::string::npos ? -1 : level_of(include.substr(0, slash));
      CHECK_MESSAGE((level < 0 || level >= 8), name << " includes " << include);
    }
  }
}

TEST_CASE("build: the deck reader uses the public interface, and of the core what is no part of a solver") {
  for (const fs::path& path : files_below("src/deck")) {
    if (!is_source(path)) continue;
    for (const std::string& include : includes_of(path)) {
      const std::string folder = include.substr(0, include.find('/'));
      const bool below = folder == "deck" || folder == "memory" || include == "model/polar.hpp";
      CHECK_MESSAGE((level_of(folder) < 0 || below), name_of(path) << " includes " << include);
    }
  }
}

TEST_CASE("build: src/sources.mk lists what the folders hold, and nothing twice") {
  std::multiset<std::string> listed;
  for (const std::string& line : lines_of(read_file((kRoot / "src/sources.mk").string()))) {
    const size_t at = line.find("_SOURCES += ");
    if (at != std::string::npos) listed.insert(line.substr(at + 12));
  }
  std::multiset<std::string> found;
  for (const char* folder : {"src", "port"})
    for (const fs::path& path : files_below(folder))
      if ((path.extension() == ".cpp" || path.extension() == ".c") &&
          name_of(path).compare(0, 14, "port/cortex-m/") != 0 && // compiled for its own machines only
          name_of(path).compare(0, 9, "port/web/") != 0 && name_of(path).compare(0, 13, "port/windows/") != 0 &&
          name_of(path).compare(0, 15, "port/packaging/") != 0) // tools
        found.insert(name_of(path));
  for (const std::string& name : found) CHECK_MESSAGE(listed.count(name) == 1, name << " (make relist)");
  for (const std::string& name : listed) CHECK_MESSAGE(found.count(name) == 1, name << " (make relist)");
}

TEST_CASE("build: make and CMake read that list and no other") {
  const std::string make = read_file((kRoot / "Makefile").string()), cmake = read_file((kRoot / "CMakeLists.txt").string());
  CHECK(contains(make, "include src/sources.mk"));
  CHECK(contains(cmake, "file(STRINGS src/sources.mk"));
  CHECK_FALSE(contains(cmake, ".cpp "));
  // The archive that these tests are linked with holds one member per listed source.
  if (!has_command("ar")) return;
  const size_t members = lines_of(run_shell("ar t '" + paths::library() + "'").out).size();
  size_t sources = 0;
  for (const std::string& line : lines_of(read_file((kRoot / "src/sources.mk").string())))
    if (line.compare(0, 16, "CORE_SOURCES += ") == 0 || line.compare(0, 16, "PORT_SOURCES += ") == 0) ++sources;
  CHECK(members == sources);
}

TEST_CASE("build: make without a target makes library and program") {
  const Result said =
      run_shell("cd '" + kRoot.string() + "' && env -u MAKEFLAGS -u MAKELEVEL make -pnq BUILD=build 2>/dev/null");
  CHECK(said.out.find("\n.DEFAULT_GOAL := all\n") != std::string::npos);
  const size_t all = said.out.find("\nall: ");
  REQUIRE(all != std::string::npos);
  const std::string needs = said.out.substr(all, said.out.find('\n', all + 1) - all);
  CHECK(needs.find("build/libcontact2d.a") != std::string::npos);
  CHECK(needs.find("build/contact2d") != std::string::npos);
}

// Its objects depend on the flags of its own: those of the build would make all of the build be compiled again.
TEST_CASE("build: the page made of one file leaves the flags of the build as they are") {
  const test::Folder folder;
  const std::string build = folder / "b", one = build + "/amalgamation/contact2d.cpp";
  const test::Result made = test::run_shell("cd '" + kRoot.string() + "' && env -u MAKEFLAGS -u MAKELEVEL make -n web BUILD='" +
                                            build + "' ONE_FILE='" + one + "' NO_INSTALL=1");
  CHECK_MESSAGE(made.status == 0, made.err);
  CHECK(test::contains(made.out, "> " + build + "/web/flags"));
  CHECK(test::contains(made.out, "-c " + one));
  CHECK(!test::contains(made.out, "> " + build + "/flags"));
}

TEST_CASE("build: every text is ASCII without tabs or trailing blanks") {
  std::vector<fs::path> files = {kRoot / "README.md", kRoot / "CMakeLists.txt", kRoot / "Makefile"};
  for (const char* folder : {"src", "include", "port", "tests", "examples"})
    for (const fs::path& path : files_below(folder)) files.push_back(path);
  static const std::set<std::string> kTexts = {".dat", ".in", ".md", ".mk", ".sh", ".txt", ".f", ".f90", ".py", ".map"};
  int seen = 0;
  for (const fs::path& path : files) {
    const bool rules = path.extension() == ".mk" || path.filename() == "Makefile"; // which begin with tabs
    if (!is_source(path) && !rules && kTexts.count(path.extension().string()) == 0) continue;
    ++seen;
    const std::string text = read_file(path.string());
    const auto odd = std::find_if(text.begin(), text.end(), [&](char c) {
      return c != '\n' && !(rules && c == '\t') && (static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126);
    });
    CHECK_MESSAGE(odd == text.end(), name_of(path) << ": byte " << (odd - text.begin()));
    if (is_source(path)) CHECK_MESSAGE(!contains(text, " \n"), name_of(path) << ": blanks at the end of a line");
  }
  CHECK(seen > 300);
}

TEST_CASE("build: the public headers compile alone, as C99 and as C++, with all warnings") {
  const Folder folder;
  std::vector<std::string> headers;
  for (const char* place : {"include", "port"})
    for (const fs::path& path : files_below(place))
      if (path.extension() == ".h" && !contains(path.string(), "/port/windows/include/")) // what MinGW's own lack
        headers.push_back(path.string());
  for (const std::string& header : headers) {
    write_file(folder / "a.c", "#include \"" + header +
                                   "\"\n#include \"contact2d.h\"\nint a(void);\nint a(void) { c2d_limits l = "
                                   "C2D_INIT(c2d_limits); return (int)l.struct_size; }\n");
    const std::string include = " -I'" + (kRoot / "include").string() + "' ";
    const Result c = run_shell(paths::c_compiler() + " -std=c99 -pedantic -Wall -Wextra -Werror" + include + "-c '" +
                               (folder / "a.c") + "' -o '" + (folder / "a.o") + "'");
    CHECK_MESSAGE(c.status == 0, header << "\n" << c.err);
    const Result cxx = run_shell(paths::cxx_compiler() + " -x c++ -std=c++17 -pedantic -Wall -Wextra -Werror" + include +
                                 "-c '" + (folder / "a.c") + "' -o '" + (folder / "a.o") + "'");
    CHECK_MESSAGE(cxx.status == 0, header << "\n" << cxx.err);
  }
}

namespace {

// Compiles examples/NAME.c with `compiler`, links it with the C compiler, runs it with `arguments`.
Result run_program(const std::string& compiler, const std::string& name, const std::string& arguments) {
  const Folder folder;
  const std::string root = kRoot.string(), object = folder / "a.o", program = folder / "a";
  const Result compiled = run_shell(compiler + " -Wall -Wextra -Werror -I'" + root + "/include' -I'" + root +
                                    "/port/memory' -c '" + root + "/examples/" + name + ".c' -o '" + object + "'");
  if (compiled.status != 0) return compiled;
  const Result linked =
      run_shell(paths::c_compiler() + " '" + object + "' '" + paths::library() + "' -lm -o '" + program + "'");
  if (linked.status != 0) return linked;
  return run_shell("'" + program + "' " + arguments);
}
// examples/static_array.c on a deck.
Result run_example(const std::string& compiler, const std::string& deck) {
  return run_program(compiler, "static_array", "'" + kRoot.string() + "/examples/" + deck + "'");
}

} // namespace

TEST_CASE("example: static_array.c is C99, links with plain cc and -lm, and solves the sample") {
  if (paths::sanitized()) return; // its library needs the sanitizer's run-time
  const Result result = run_example(paths::c_compiler() + " -std=c99 -pedantic", "hertz.dat");
  CHECK_MESSAGE(result.status == 0, result.out << result.err);
  const std::vector<std::string> lines = lines_of(result.out);
  REQUIRE(lines.size() == 2 * 28 + 1); // two coefficients, 14 load cards of 2 increments
  double load = 0.0, peak = 0.0;
  REQUIRE(std::sscanf(lines[27].c_str(), "mu 0.4 step 28 load %lf peak pressure %lf", &load, &peak) == 2);
  CHECK(load == doctest::Approx(1.03));
  CHECK(peak > 190.0); // Hertz: 208 for the load of 468.7 per unit length
  CHECK(peak < 230.0);
}

TEST_CASE("example: static_array.c is C++ as well, and tells an unusable deck") {
  if (paths::sanitized()) return;
  const std::string cxx = paths::cxx_compiler() + " -x c++ -std=c++17 -pedantic -fno-exceptions -fno-rtti";
  const Result result = run_example(cxx, "plate_tension.dat");
  CHECK_MESSAGE(result.status == 0, result.out << result.err);
  CHECK(run_example(cxx, "static_array.c").status == 1);
}

// Hertz' half width of the example is 1: the pressure on the axis is 2 P/pi.
TEST_CASE("example: adapt.c is C99 and C++, and states errors of its pressures that hold") {
  if (paths::sanitized()) return;
  for (const std::string& compiler : {paths::c_compiler() + " -std=c99 -pedantic",
                                      paths::cxx_compiler() + " -x c++ -std=c++17 -pedantic -fno-exceptions -fno-rtti"}) {
    const Result result = run_program(compiler, "adapt", "");
    CHECK_MESSAGE(result.status == 0, result.out << result.err);
    const double exact = 2 * 8.630447 / std::acos(-1.0);
    int elements = 0, rounds = 0;
    double pressure = 0, stated = 0, before = 1e300;
    for (const std::string& line : lines_of(result.out)) {
      REQUIRE(std::sscanf(line.c_str(), "round %*d: %d elements, pressure %lf, stated error of the pressures %lf", &elements,
                          &pressure, &stated) == 3);
      CHECK(std::fabs(pressure / exact - 1) < stated / 100);
      CHECK(stated < before);
      before = stated;
      ++rounds;
    }
    CHECK(rounds > 5);
    CHECK(stated < 0.1);
    CHECK(elements <= 100); // some 1,000 equal ones
  }
}
