// Numbers have a point whatever the host's locale says: the program in a locale with a decimal comma.
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <regex>

using namespace test;

namespace {

const std::string kRoot = paths::root();

// A locale that has a decimal comma and groups of three, and nothing else; empty: no localedef.
bool make_comma_locale(const Folder& folder) {
  write_file(folder / "comma", "LC_NUMERIC\ndecimal_point \",\"\nthousands_sep \".\"\ngrouping 3;3\nEND LC_NUMERIC\n");
  run_shell("localedef -c -i '" + (folder / "comma") + "' '" + (folder / "xx_XX") + "'"); // warns of all it lacks
  // For programs that do not ask for their locale themselves.
  write_file(folder / "ask.c", "#include <locale.h>\n__attribute__((constructor)) static void ask(void) { "
                               "setlocale(LC_ALL, \"\"); }\n");
  run_shell(paths::c_compiler() + " -shared -fPIC '" + (folder / "ask.c") + "' -o '" + (folder / "ask.so") + "'");
  write_file(folder / "say.c", "#include <stdio.h>\nint main(void) { return printf(\"%.1f\", 1.5) != 3; }\n");
  run_shell(paths::c_compiler() + " '" + (folder / "say.c") + "' -o '" + (folder / "say") + "'");
  return true;
}

std::string in_comma_locale(const Folder& folder) {
  return "LOCPATH='" + folder.path() + "' LC_ALL=xx_XX LD_PRELOAD='" + (folder / "ask.so") + "' ";
}

// Times differ from run to run.
std::string without_times(const std::string& text) {
  static const std::regex seconds("\"seconds\": *\\{[^}]*\\}");
  return std::regex_replace(text, seconds, "");
}

} // namespace

TEST_CASE("locale: every output of the program is the same in a locale with a decimal comma") {
  if (paths::sanitized()) return; // its run-time must be loaded first
  const Folder locale;
  make_comma_locale(locale);
  if (run_shell(in_comma_locale(locale) + "'" + (locale / "say") + "'").out != "1,5") {
    MESSAGE("skipped: localedef makes no locale with a decimal comma here");
    return;
  }
  const Folder plain, comma;
  for (const Folder* out : {&plain, &comma}) {
    const std::string prefix = "cd '" + out->path() + "' && " + (out == &comma ? in_comma_locale(locale) : "");
    const std::string program = prefix + "'" + paths::program() + "' ", deck = "'" + kRoot + "/examples/hertz.dat'";
    REQUIRE(run_shell(program + "run " + deck +
                      " --no-progress --csv csv --boundary boundary --listing listing"
                      " --json json --vtk vtk --figures figures")
                .status == 0);
    REQUIRE(run_shell(program + "check " + deck + " >check").status == 0);
    REQUIRE(run_shell(program + "convert " + deck + " --to free -o free").status == 0);
    REQUIRE(run_shell(program + "make punch mu=0.3 nu=0.25 >made").status == 0);
    // and what it wrote it reads again
    REQUIRE(run_shell(program + "run free --no-progress --csv csv_free --listing /dev/null").status == 0);
  }
  int compared = 0;
  for (const auto& entry : fs::recursive_directory_iterator(plain.path())) {
    if (!entry.is_regular_file()) continue;
    const std::string name = fs::relative(entry.path(), plain.path()).string();
    CHECK_MESSAGE(without_times(read_file(entry.path().string())) == without_times(read_file(comma / name)), name);
    ++compared;
  }
  CHECK(compared > 10);
}
