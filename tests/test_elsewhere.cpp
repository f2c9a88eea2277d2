// In somebody else's build: other folders, compilers, build systems and machines.
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <regex>
#include <set>

using namespace test;

namespace {

const std::string kRoot = paths::root();

std::string make_in(const std::string& root, const std::string& words) {
  return "env -u MAKEFLAGS -u MAKELEVEL make -s -C '" + root + "' " + words;
}

Result must(const std::string& command) {
  Result done = run_shell(command);
  REQUIRE_MESSAGE(done.status == 0, command << "\n" << done.out << done.err);
  return done;
}

// A line of C or C++ that is the project's own, in what the preprocessor wrote ("# 12 "file"" before each piece).
std::string own_lines(const std::string& preprocessed, const std::string& own) {
  std::string out;
  bool mine = false;
  for (const std::string& line : lines_of(preprocessed)) {
    if (line.compare(0, 2, "# ") == 0)
      mine = contains(line, own);
    else if (mine)
      out += line + "\n";
  }
  return out;
}

} // namespace

TEST_CASE("elsewhere: the same bits from two folders, with debugging information") {
  if (!has_command("make") || !has_command("ar")) return;
  const Folder folder;
  const std::string compile = "BATCH=10 CXXFLAGS='-O1 -g' CXX='" + paths::cxx_compiler() + "' ";
  std::smatch first_source; // a batch has the name of its first file
  const std::string list = read_file(kRoot + "/src/sources.mk");
  REQUIRE(std::regex_search(list, first_source, std::regex("REPORT_SOURCES \\+= src/([a-z0-9_/]+)\\.cpp")));
  std::string batch = first_source[1].str() + "_etc";
  std::replace(batch.begin(), batch.end(), '/', '_');
  const std::string objects[] = {"deck_cards", "store_block", "program_main", batch};
  std::string first[5];
  for (const char* name : {"one", "another_folder/of a longer name"}) {
    const std::string root = folder / name, build = std::string(name) == "one" ? "build" : "out";
    must("mkdir -p '" + root + "' && cd '" + kRoot + "' && cp -R Makefile src include port tests examples '" + root + "'");
    std::string targets;
    for (const std::string& object : objects) targets += build + "/obj/" + object + ".o ";
    must(make_in(root, compile + "BUILD=" + build + " " + targets + build + "/obj/amalgamate"));
    must("cd '" + root + "' && ar rcsD out.a " + targets);
    for (size_t i = 0; i < 5; ++i) {
      const std::string bytes = read_file(root + "/" + (i < 4 ? build + "/obj/" + objects[i] + ".o" : "out.a"));
      CHECK(bytes.size() > 1000);
      CHECK_FALSE(contains(bytes, folder.path()));
      if (std::string(name) == "one")
        first[i] = bytes;
      else
        CHECK_MESSAGE(bytes == first[i], i);
    }
  }
}

TEST_CASE("elsewhere: archives hold neither times nor owners") {
  if (!has_command("ar")) return;
  int members = 0;
  for (const std::string& line : lines_of(must("LC_ALL=C TZ=UTC ar tv '" + paths::library() + "'").out)) {
    ++members;
    CHECK_MESSAGE(line.compare(0, 13, "rw-r--r-- 0/0") == 0, line);
    CHECK_MESSAGE(contains(line, " 1970 "), line);
  }
  CHECK(members > 100);
}

TEST_CASE("elsewhere: PORTS=memory is a library without files, threads, program and hardening") {
  if (!has_command("make")) return;
  const Folder folder;
  const std::string commands =
      must("env -u MAKEFLAGS -u MAKELEVEL make -n -C '" + kRoot + "' PORTS=memory BUILD='" + folder.path() + "' all").out;
  CHECK(contains(commands, "-c port/memory/c2d_memory.cpp"));
  CHECK(contains(commands, "-c src/deck/cards.cpp"));
  for (const char* unwanted :
       {"port/posix", "port/stdio", "port/threads", "src/program", "-fstack-protector", "FORTIFY", "-pthread"})
    CHECK_FALSE_MESSAGE(contains(commands, unwanted), unwanted);
}

TEST_CASE("elsewhere: -DC2D_PLAIN leaves no word in the core that C++17 has not") {
  if (!has_command("make")) return;
  const Folder folder;
  must(make_in(kRoot, "amalgamation BUILD='" + folder.path() + "'"));
  const std::string file = folder / "amalgamation/contact2d.cpp";
  const std::string compile = paths::cxx_compiler() + " -std=c++17 -DC2D_PLAIN ";
  const Result checked = run_shell(compile + "-Wall -Wextra -Wpedantic -Wno-unused-function -fsyntax-only '" + file + "'");
  CHECK_MESSAGE(checked.status == 0, checked.err);
  const std::string text = own_lines(must(compile + "-E '" + file + "'").out, "amalgamation/");
  REQUIRE(text.size() > 1000000);
  // (HUGE_VAL, isfinite, offsetof and their like are macros of the C library)
  const std::regex word("__attribute__|__builtin_(?!huge_val|nan|inf|isfinite|isinf|isnan|offsetof)[a-z_]+|__asm__|"
                        "\\basm\\b|vector_size|__int128|__extension__|__typeof__");
  std::smatch found;
  CHECK_MESSAGE(!std::regex_search(text, found, word), (found.empty() ? "" : found[0].str()));
}

TEST_CASE("elsewhere: a parent of CMake keeps its names, its build type and its installation") {
  if (!has_command("cmake") || paths::sanitized()) return;
  const Folder folder;
  write_file(folder / "CMakeLists.txt",
             "cmake_minimum_required(VERSION 3.13)\nproject(parent C CXX)\n"
             "foreach(name core ports reports families program study chapter9 run_tests tests)\n"
             "  add_custom_target(${name})\nendforeach()\n"
             "add_subdirectory(\"" +
                 kRoot +
                 "\" contact2d)\n"
                 "add_executable(user \"" +
                 kRoot +
                 "/examples/static_array.c\")\n"
                 "target_link_libraries(user contact2d::contact2d)\n"
                 "add_library(headers OBJECT headers.c)\n" // without waiting for the library
                 "target_include_directories(headers PRIVATE "
                 "$<TARGET_PROPERTY:contact2d::contact2d,INTERFACE_INCLUDE_DIRECTORIES>)\n"
                 "message(STATUS \"type (${CMAKE_BUILD_TYPE}) flags (${CMAKE_CXX_FLAGS_RELEASE})\")\n"
                 "get_property(targets DIRECTORY \"" +
                 kRoot +
                 "\" PROPERTY BUILDSYSTEM_TARGETS)\n"
                 "message(STATUS \"targets ${targets};\")\n");
  std::string headers = "#include <contact2d.h>\n";
  for (const char* port : {"memory", "posix", "stdio", "threads"}) headers += std::string("#include <c2d_") + port + ".h>\n";
  write_file(folder / "headers.c", headers);
  const std::string configure = "cd '" + folder.path() + "' && env -u PREFIX -u LIBDIR -u CXXFLAGS cmake -S . -B build";
  const std::string told = must(configure).out;
  CHECK_MESSAGE(contains(told, "type () flags (-O3 -DNDEBUG)"), told);
  CHECK_MESSAGE(contains(told, "targets contact2d_core;contact2d_ports;contact2d;contact2d_shared;\n"), told);
  CHECK_FALSE(fs::exists(folder / "build/contact2d/contact2dConfig.cmake"));
  must("cmake --build '" + (folder / "build") + "' --target headers"); // those of the ports are found as where it is installed
  const std::string on = must(configure + " -DCONTACT2D_PROGRAM=ON -DCONTACT2D_INSTALL=ON").out;
  CHECK_MESSAGE(contains(on, ";contact2d_program;"), on);
  CHECK(fs::exists(folder / "build/contact2d/contact2dConfig.cmake"));
}

TEST_CASE("elsewhere: model_by_calls.c is C99 and C++, balances its forces and restores its state to the bit") {
  if (paths::sanitized()) return; // its library needs the sanitizer's run-time
  const Folder folder;
  for (const std::string& compile : {paths::c_compiler() + " -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Werror ",
                                     paths::cxx_compiler() + " -x c++ -std=c++17 -Wall -Wextra -Werror "}) {
    must(compile + "-I'" + kRoot + "/include' '" + kRoot + "/examples/model_by_calls.c' -x none '" + paths::library() +
         "' -lm -o '" + (folder / "model") + "'");
    const std::string told = std::regex_replace(must("'" + (folder / "model") + "'").out, std::regex("-0\\.0000"), "0.0000");
    CHECK(contains(told, "restored twice, the same bits"));
    CHECK_MESSAGE(contains(told, "steel: contact force (0.0000, 800.0000), moment 6400.000; applied (0.0000, -800.0000)"),
                  told);
    CHECK_MESSAGE(contains(told, "aluminium: contact force (0.0000, -800.0000), moment -6400.000; applied (0.0000, 800.0000)"),
                  told);
  }
}

TEST_CASE("elsewhere: make api is a page with every function and every section, and no link leads nowhere") {
  if (!has_command("make")) return;
  const Folder folder;
  must(make_in(kRoot, "api CXXFLAGS=-O0 BUILD='" + folder.path() + "'"));
  const std::string page = read_file(folder / "api/contact2d.html");
  std::set<std::string> anchors, links;
  const std::regex anchor("id=\"([^\"]*)\""), link("href=\"#([^\"]*)\"");
  for (std::sregex_iterator i(page.begin(), page.end(), anchor), end; i != end; ++i)
    CHECK_MESSAGE(anchors.insert((*i)[1]).second, (*i)[1].str());
  for (std::sregex_iterator i(page.begin(), page.end(), link), end; i != end; ++i) links.insert((*i)[1]);
  for (const std::string& name : links) CHECK_MESSAGE(anchors.count(name) == 1, name);
  const std::string header = read_file(kRoot + "/include/contact2d.h");
  const std::regex function("\nc2d_status (c2d_[a-z0-9_]+)\\(");
  int seen = 0;
  for (std::sregex_iterator i(header.begin(), header.end(), function), end; i != end; ++i, ++seen)
    CHECK_MESSAGE(links.count((*i)[1]) == 1, (*i)[1].str());
  CHECK(seen > 50);
  for (const char* name : {"section1", "section9", "C2D_OK", "C2D_TN", "c2d_limits", "c2d_read_line", "c2d_posix_store"})
    CHECK_MESSAGE(anchors.count(name) == 1, name);
  CHECK_FALSE(contains(page, "http")); // it fetches nothing
}

// (.ci/run builds and runs it)
TEST_CASE("elsewhere: make embedded BOARD=DIR takes processor, linker script and emulator from the folder") {
  if (!has_command("make")) return;
  const Folder folder;
  const std::string commands = must("env -u MAKEFLAGS -u MAKELEVEL make -n -C '" + kRoot + "' embedded BUILD='" +
                                    folder.path() + "' BOARD=tests/embedded/mps2-an385/")
                                   .out;
  for (const char* wanted : {"-mcpu=cortex-m3 -mthumb", "-T tests/embedded/mps2-an385/board.ld", "-M mps2-an385",
                             "-Wl,-u,c2d_set_rigid", "mps2-an385/run_deck.elf"})
    CHECK_MESSAGE(contains(commands, wanted), wanted);
  CHECK_FALSE(contains(commands, "cortex-m7"));
}

// A compiler that finds the header in one folder alone, and a package manager that puts it there.
TEST_CASE("elsewhere: a doctest that was installed is used if its checksum is one of those asked for") {
  if (!has_command("sha256sum")) return;
  const Folder folder;
  const std::string header = folder / "doctest/doctest.h";
  write_file(folder / "c++", "#!/bin/sh\n[ -e '" + header + "' ] && echo '-.o: " + header + "'\n");
  write_file(folder / "apt-get", "#!/bin/sh\nmkdir -p '" + (folder / "doctest") + "' && echo //1 >'" + header + "'\n");
  write_file(folder / "sudo", "#!/bin/sh\nshift\n[ \"$1\" != env ] || shift 2\nexec \"$@\"\n");
  must("chmod +x '" + (folder / "c++") + "' '" + (folder / "apt-get") + "' '" + (folder / "sudo") + "'");
  const std::string sum = must("echo //1 | sha256sum | cut -d' ' -f1").out;
  const std::string known = sum.substr(0, sum.find('\n'));
  const auto install = [&](const std::string& sums) {
    fs::remove(header);
    return run_shell("env -u DOCTEST_INCLUDE PATH='" + folder.path() + "':\"$PATH\" NO_INSTALL= CXX=c++ DOCTEST_SHA256='" +
                     sums + "' sh '" + kRoot + "/tests/doctest.sh' '" + (folder / "flags") + "'");
  };
  CHECK(install("").status == 0);
  CHECK(install("0123 " + known).status == 0);
  const Result refused = install("0123");
  CHECK(refused.status != 0);
  CHECK_MESSAGE(contains(refused.err, known), refused.err);
}
