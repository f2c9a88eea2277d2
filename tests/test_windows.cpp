// The program for Windows (make windows) in wine: the outputs of this one, names, locks, keys. Made anew by .ci/run; here what
// has been made is tried.
#include "hosts.hpp"

#include <cmath>
#include <cstdlib>
#include <cstring>

using namespace test;

namespace {

const std::string kProgram = paths::build() + "/windows/contact2d.exe", kCompiler = "x86_64-w64-mingw32-g++-posix";
const std::string kExamples = paths::root() + "/examples/";

// A program that this needs is missing: said aloud, or a failure where all are there.
bool can_try() {
  if (paths::sanitized()) return false; // (it has none of this build)
  if (!can_host(kCompiler) || !can_host("wine")) return false;
  if (fs::exists(kProgram)) return true;
  const char* all = std::getenv("C2D_ALL_HOSTS");
  if (all != nullptr && std::string(all) == "1")
    FAIL_CHECK("there is no " << kProgram << " (make windows), and C2D_ALL_HOSTS=1");
  else
    MESSAGE("skipped: there is no " << kProgram << " (make windows)");
  return false;
}

Result in_folder(const Folder& folder, const std::string& command) {
  return run_shell("cd '" + folder.path() + "' && " + command);
}
Result here(const Folder& folder, const std::string& words) { return in_folder(folder, "'" + paths::program() + "' " + words); }

const std::string kWine =
    "WINEDEBUG=-all WINEDLLOVERRIDES=mscoree,mshtml= WINEPREFIX='" + paths::build() + "/windows/wine' wine ";
Result there(const Folder& folder, const std::string& words) {
  return in_folder(folder, kWine + "'" + kProgram + "' " + words);
}

// A program of tests/windows.
std::string compiled(const std::string& name, const std::string& more = "") {
  const std::string program = paths::build() + "/windows/" + name + ".exe";
  const Result made = run_shell("cd '" + paths::root() + "' && " + kCompiler + " -std=c++17 -O1 -static -municode -o '" +
                                program + "' tests/windows/" + name + ".cpp " + more);
  REQUIRE_MESSAGE(made.status == 0, made.err);
  return "'" + program + "' ";
}

// tests/windows/press.cpp: the program with a key pressed.
Result with_key(const Folder& folder, const std::string& key_and_file, const std::string& words) {
  return in_folder(folder, kWine + compiled("press") + key_and_file + " '" + kProgram + "' " + words);
}

// Without what depends on the clock.
std::string without_times(const std::string& text) {
  std::string out;
  for (const std::string& line : lines_of(text)) {
    bool is_time = contains(line, "\"seconds\"");
    for (const char* phase : {"read", "assemble", "eliminate", "reduce", "contact", "back substitution", "write"})
      is_time = is_time || line.compare(0, 17 + std::strlen(phase), "<tr><td>" + std::string(phase) + "</td><td>") == 0;
    if (!is_time) out += line + "\n";
  }
  const std::string begin = "gcc ", end = ", x86_64"; // the compiler of the build
  for (size_t at = 0; (at = out.find(begin, at)) != std::string::npos && out.find(end, at) != std::string::npos;)
    out.erase(at, out.find(end, at) - at);
  return out;
}

// The same bytes, but for last digits: MinGW's sines and logarithms are not rounded as this C library's are. Outputs have up to
// 12 digits. Numbers that are differences of larger ones, of the order of 1 or less, are round-off.
bool same_but_last_digits(const std::string& one, const std::string& other) {
  const char *a = one.c_str(), *b = other.c_str();
  const auto starts_number = [](const char* at) { return std::strspn(at + (*at == '-'), "0123456789") > 0; };
  while (*a != 0 && starts_number(a) == starts_number(b)) {
    if (starts_number(a)) {
      char *a_end = nullptr, *b_end = nullptr;
      const double x = std::strtod(a, &a_end), y = std::strtod(b, &b_end);
      if (x != y && std::fabs(x - y) > std::max(2e-11 * std::fabs(x), 1e-12)) return false;
      a = a_end;
      b = b_end;
    } else if (*a++ != *b++) {
      return false;
    }
  }
  return *a == 0 && *b == 0;
}

void check_same(const Folder& folder, const std::string& one, const std::string& other) {
  const std::string text = read_file(folder / one);
  CHECK(text.size() > 50);
  const bool same = same_but_last_digits(without_times(text), without_times(read_file(folder / other)));
  CHECK_MESSAGE(same, other); // (too long to be shown)
}

// Three coefficients of friction, a load that goes to and fro.
void write_cyclic_deck(const std::string& file) {
  std::string deck = run_shell("'" + paths::program() + "' make mindlin n=6 steps=2").out;
  const size_t at = deck.find("\n1 0.3\n");
  REQUIRE(at != std::string::npos);
  write_file(file, deck.replace(at, 7, "\n3 0.3 0.2 0.8\n"));
}

} // namespace

TEST_CASE("windows: calls of POSIX") {
  if (!can_try()) return;
  const Folder folder;
  fs::create_directory(folder / "f");
  const std::string layer = compiled("layer", "-Iport/windows/include -D_FILE_OFFSET_BITS=64 -D_WIN32_WINNT=0x0A00 "
                                              "port/windows/*.cpp -lntdll");
  const Result run = in_folder(folder, kWine + layer + "f");
  CHECK_MESSAGE(run.status == 0, run.out);
  CHECK(run.out == "0 failed\n");
}

TEST_CASE("windows: what takes outputs for the same") {
  CHECK(same_but_last_digits("a,91.7695281727,-\n", "a,91.7695281726,-\n"));
  CHECK_FALSE(same_but_last_digits("1 2", "1 2 "));
  CHECK_FALSE(same_but_last_digits("1 2", "1 -2"));
  CHECK_FALSE(same_but_last_digits("1 2", "1 x"));
  CHECK(same_but_last_digits("5.5e-15", "-4.1e-15"));
  CHECK_FALSE(same_but_last_digits("0", "2e-12"));
  CHECK_FALSE(same_but_last_digits("1.0000000001", "1"));
}

TEST_CASE("windows: the same outputs, names with blanks, umlauts and backslashes") {
  if (!can_try()) return;
  const Folder folder;
  const std::string deck = "'Gr\u00f6\u00dfe 1.dat'";
  write_file(folder / "Gr\u00f6\u00dfe 1.dat", read_file(kExamples + "hertz.dat"));
  fs::create_directory(folder / "Ma\u00df e");
  const auto outputs = [](const std::string& begin) {
    std::string words;
    for (const char* name : {"listing", "csv", "boundary", "json", "report", "summary", "vtk", "trace"})
      words += std::string(" --") + name + " '" + begin + name + "'";
    return words;
  };
  for (const char* turn : {"", " --memory 160K --store 'file:ta pes'"}) { // over what the one before has left
    REQUIRE(here(folder, "run " + deck + turn + outputs("")).status == 0);
    const Result run = there(folder, "run " + deck + turn + outputs("Ma\u00df e\\"));
    CHECK_MESSAGE(run.status == 0, run.err);
    CHECK_FALSE(fs::exists(folder / "ta pes"));
    for (const char* name : {"listing", "csv", "boundary", "json", "report", "summary", "vtk", "trace"})
      check_same(folder, name, "Ma\u00df e/" + std::string(name));
  }
  REQUIRE(here(folder, "run " + deck + " --out all").status == 0);
  CHECK(there(folder, "run " + deck + " --out 'a ll'").status == 0);
  for (const auto& entry : fs::recursive_directory_iterator(folder / "all")) {
    const std::string name = fs::relative(entry.path(), folder / "all").string();
    if (entry.is_regular_file()) check_same(folder, "all/" + name, "a ll/" + name);
  }
  CHECK(std::distance(fs::directory_iterator(folder / "Ma\u00df e"), fs::directory_iterator()) ==
        13); // five with inputs; nothing is left
}

TEST_CASE("windows: the deck from standard input with ends of lines as Windows has them; where it is not") {
  if (!can_try()) return;
  const Folder folder;
  std::string deck;
  for (const std::string& line : lines_of(read_file(kExamples + "hertz.dat"))) deck += line + "\r\n";
  write_file(folder / "d", deck);
  REQUIRE(here(folder, "run - --csv here <d >list").status == 0);
  CHECK(there(folder, "run - --csv there <d >'the list'").status == 0);
  check_same(folder, "here", "there");
  check_same(folder, "list", "the list");
  const Result piped = there(folder, "run - -q --csv - <d | cat");
  CHECK(piped.out == read_file(folder / "there"));
  const Result missing = there(folder, "run 'no\\such.dat'"), is_folder = there(folder, "run .");
  CHECK(missing.status == here(folder, "run no/such.dat").status);
  CHECK(contains(missing.err, "contact2d: no\\such.dat: error: cannot be read: No such file or directory"));
  CHECK(contains(is_folder.err, "Is a directory"));
  CHECK_FALSE(contains(missing.err, "\033"));
  for (const char* other : {"'.\\D2'", "d2", "./d2"}) {
    const Result same = there(folder, "run d --csv D2 --json " + std::string(other));
    CHECK((same.status == 64 && contains(same.err, "--csv and --json are the same file")));
  }
}

TEST_CASE("windows: files beside a sketch; a sweep in threads; rows that are added") {
  if (!can_try()) return;
  const Folder folder;
  fs::create_directory(folder / "a b");
  for (const char* name : {"rough_profile.c2s", "rough_profile.csv"})
    write_file(folder / "a b/" + name, read_file(kExamples + name));
  CHECK(there(folder, "check 'a b\\rough_profile.c2s'").status == here(folder, "check 'a b/rough_profile.c2s'").status);
  write_file(folder / "d", read_file(kExamples + "hertz.dat"));
  std::string deck = run_shell("'" + paths::program() + "' make hertz n=2 L=5 ratio=1.6").out;
  const size_t at = deck.find("\n1 0\n");
  write_file(folder / "p.dat", at == std::string::npos ? deck : deck.replace(at, 5, "\n1 {mu}\n"));
  REQUIRE(at != std::string::npos);
  write_file(folder / "t.csv", "mu\n0\n0.1\n0.2\n0.3\n");
  const std::string words = " t.csv p.dat --response 'max tn' --threads 2 --results ";
  REQUIRE_MESSAGE(here(folder, "sweep" + words + "here.csv").status == 0, here(folder, "sweep" + words + "here.csv").err);
  const Result swept = there(folder, "sweep" + words + "there.csv");
  CHECK_MESSAGE(swept.status == 0, swept.err);
  check_same(folder, "here.csv", "there.csv");
  CHECK_FALSE(fs::exists(folder / "there.csv.rows"));
  for (const char* mu : {"0.1", "0.2"}) {
    const std::string row = std::string("run p.dat -q --response 'max tn' --set mu=") + mu + " --row ";
    REQUIRE(here(folder, row + "rows").status == 0);
    CHECK(there(folder, row + "'the rows'").status == 0);
  }
  check_same(folder, "rows", "the rows");
}

TEST_CASE("windows: keys and locks: exit status as of signals, 75; a run that was ended goes on to the same bytes") {
  if (!can_try()) return;
  const Folder folder;
  for (const char* key : {"c", "b"}) { // while it waits for its deck
    const Result ended = with_key(folder, key + std::string(" -"), "run - --csv c");
    CHECK(ended.status == 130);
    CHECK(contains(ended.err, "cancelled"));
  }
  CHECK(folder.names().empty());
  write_cyclic_deck(folder / "d");
  REQUIRE(here(folder, "run d --listing here.list --csv here").status == 0);
  const std::string words = "run d --keep --save-every 0 --listing list --csv 'the re' --store 'file:sto re'",
                    in_path = "'sto re/contact2d.store/path0'";
  for (const auto& [key, status] : {std::pair<std::string, int>("c", 130), {"b", 143}}) {
    const Result ended = with_key(folder, key + " " + in_path, words);
    CHECK_MESSAGE(ended.status == status, ended.err);
    CHECK_FALSE(fs::exists(folder / "the re"));
    const Result resumed = there(folder, "resume 'sto re'");
    CHECK_MESSAGE(resumed.status == 0, resumed.err);
    CHECK(contains(resumed.err, "continues after step"));
    check_same(folder, "here", "the re");
    fs::remove_all(folder / "sto re");
    fs::remove(folder / "the re");
  }
  const Result busy = with_key(folder, "2 " + in_path, words); // a second one meanwhile
  CHECK_MESSAGE(busy.status == 75, busy.err);
  CHECK(contains(busy.err, "in use by another process"));
}
