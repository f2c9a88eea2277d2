// The Python package: its own tests (tests/python), with and without numpy; its structs against those of C; its wheel.
#include "hosts.hpp"

using namespace test;

namespace {

const std::string kRoot = paths::root();
const std::string kPackage = kRoot + "/port/python";

// The interpreters of this machine: the first of the path, and that of the system, which may have numpy.
std::vector<std::string> interpreters() {
  std::vector<std::string> out = {"python3"};
  const std::string first = run_shell("readlink -f \"$(command -v python3)\"").out;
  const std::string system = run_shell("readlink -f /usr/bin/python3").out;
  if (has_command("/usr/bin/python3") && first != system) out.push_back("/usr/bin/python3");
  return out;
}

// What is tested: this build.
std::string environment() {
  return "PYTHONDONTWRITEBYTECODE=1 CONTACT2D_LIBRARY='" + paths::shared() + "' CONTACT2D_PROGRAM='" + paths::program() + "' ";
}

void run_tests_of(const std::string& python, const std::string& settings, const std::string& selected = "") {
  const Result run =
      run_shell(environment() + settings + python + " '" + kRoot + "/tests/python/test_contact2d.py' " + selected);
  CHECK_MESSAGE(run.status == 0, python << " " << settings << "\n" << run.err);
  CHECK_MESSAGE(contains(run.err, "\nOK"), run.err);
}

bool has_module(const std::string& python, const std::string& module) {
  return run_shell(python + " -c 'import " + module + "'").status == 0;
}

} // namespace

TEST_CASE("python: the package's own tests, standard library alone") {
  if (can_host("python3")) run_tests_of("python3", "C2D_WITHOUT_NUMPY=1 ");
}

TEST_CASE("python: the package's own tests, with numpy") {
  if (!can_host("python3")) return;
  for (const std::string& python : interpreters())
    if (has_module(python, "numpy")) return run_tests_of(python, "");
  const char* all = std::getenv("C2D_ALL_HOSTS");
  if (all != nullptr && std::string(all) == "1")
    FAIL_CHECK("numpy is missing, and C2D_ALL_HOSTS=1");
  else
    MESSAGE("skipped: no Python has numpy");
}

TEST_CASE("python: a type checker finds nothing in the package, and what is wrong in a script that uses it") {
  if (!can_host("mypy")) return;
  const Folder folder;
  const std::string check =
      "cd '" + kPackage + "' && MYPYPATH=. mypy --ignore-missing-imports --cache-dir '" + (folder / "cache") + "' ";
  const Result own = run_shell(check + "-p contact2d");
  CHECK_MESSAGE(own.status == 0, own.out << own.err);
  write_file(folder / "use.py", "import contact2d\n"
                                "result = contact2d.solve('a.c2s', mu=0.5)\n"
                                "peak: float = result.quantity('peak pressure')\n"
                                "for row in result['contact']:\n    print(row['tn'])\n"
                                "solver = contact2d.Solver.of_deck('a.dat', threads=2)\n"
                                "print(solver.advance(1.0).name, solver.contact()['tn'], solver.get('tn'))\n"
                                "peak = result.outcome\n"     // 8
                                "solver.advnce(1.0)\n"        // 9
                                "contact2d.solve(3)\n"        // 10
                                "contact2d.swep('a.c2s')\n"); // 11
  const Result use = run_shell(check + "'" + (folder / "use.py") + "'");
  CHECK(use.status == 1);
  for (const char* line : {":8: error", ":9: error", ":10: error", ":11: error", "Found 4 errors"})
    CHECK_MESSAGE(contains(use.out, line), line << "\n" << use.out);
}

TEST_CASE("python: hostile arguments, orders of calls, callbacks and forks, drawn") {
  if (!can_host("python3")) return;
  const Result run =
      run_shell(environment() + "C2D_WITHOUT_NUMPY=1 python3 '" + kRoot + "/tests/python/draw_calls.py' --cases 5");
  CHECK_MESSAGE(run.status == 0, run.err);
  CHECK_MESSAGE(contains(run.out, "5 cases, 0 failed"), run.out);
}

TEST_CASE("python: pip builds a wheel without network, and it works where it is installed") {
  if (!can_host("python3")) return;
  std::string python;
  for (const std::string& each : interpreters())
    if (python.empty() && has_module(each, "pip")) python = each;
  if (python.empty()) {
    MESSAGE("skipped: no Python has pip");
    return;
  }
  const Folder folder;
  fs::create_directories(folder / "built");
  fs::create_symlink(paths::shared(), folder / "built/libcontact2d.so.0.2.0");
  fs::create_symlink(paths::program(), folder / "built/contact2d");
  for (const char* isolation : {"", "--no-build-isolation "}) {
    const std::string place = folder / (*isolation == '\0' ? "isolated" : "not");
    const Result made = run_shell("CONTACT2D_BUILD='" + (folder / "built") + "' " + python +
                                  " -m pip install --disable-pip-version-check --no-index --no-deps " + isolation +
                                  "--target '" + place + "' '" + kPackage + "'");
    REQUIRE_MESSAGE(made.status == 0, made.out << made.err);
    const Result run = run_shell("cd '" + folder.path() + "' && PYTHONPATH='" + place + "' " + python +
                                 " -c \"import contact2d, sys; r = contact2d.solve(sys.argv[1], pictures=False); "
                                 "print(contact2d.__file__, contact2d.lib._name, '%.6f' % max(r['contact']['tn']))\" '" +
                                 kRoot + "/examples/hertz.dat'");
    CHECK_MESSAGE(run.status == 0, run.err);
    CHECK(contains(run.out, place + "/contact2d/__init__.py " + place + "/contact2d/bin/libcontact2d.so 212.8"));
    const Result command = run_shell("PYTHONPATH='" + place + "' '" + place + "/bin/contact2d' --version");
    CHECK_MESSAGE(command.out == "contact2d 0.2.0\n", command.err);
  }
}

TEST_CASE("python: an editable install names the tree, and a relative CONTACT2D_BUILD is found where pip was called") {
  if (!can_host("python3")) return;
  const Folder folder;
  const std::string place = folder / "tree/port/python";
  fs::create_directories(place);
  for (const char* each : {"contact2d", "build_contact2d.py", "wheel_tag.py", "README.md"})
    fs::copy(kPackage + "/" + each, place + "/" + each, fs::copy_options::recursive);
  fs::create_directories(folder / "tree/include");
  for (const char* each : {"include/contact2d.h", "LICENSE"}) fs::copy(kRoot + "/" + each, folder / "tree/" + each);
  fs::create_directories(folder / "there/built");
  fs::create_symlink(paths::shared(), folder / "there/built/libcontact2d.so.0.2.0");
  fs::create_symlink(paths::program(), folder / "there/built/contact2d");
  const auto build = [&](const std::string& settings, const std::string& what) {
    return run_shell("cd '" + place + "' && " + settings +
                     " PYTHONDONTWRITEBYTECODE=1 \"$(python3 -c 'import sys; print(sys.executable)')\" "
                     "-c \"import build_contact2d as b; print(b." +
                     what + "('" + folder.path() + "'))\"");
  };
  const std::string from_there = "PWD='" + (folder / "there") + "' CONTACT2D_BUILD=built";
  const Result made = build(from_there, "build_editable");
  REQUIRE_MESSAGE(made.out == "contact2d-0.2.0-py3-none-any.whl\n", made.err);
  const Result run =
      run_shell("cd '" + folder.path() +
                "' && python3 -m zipfile -e *-any.whl site && env -u CONTACT2D_LIBRARY "
                "-u CONTACT2D_PROGRAM PYTHONDONTWRITEBYTECODE=1 python3 -c \"import site; site.addsitedir('site'); "
                "import contact2d; print(contact2d.__file__, contact2d.lib._name, contact2d.library.program())\"");
  CHECK_MESSAGE(run.out == place + "/contact2d/__init__.py " + (folder / "tree/build/libcontact2d.so.0.2.0") + " " +
                               (folder / "tree/build/contact2d") + "\n",
                run.out << run.err);
  const Result wheel = build(from_there, "build_wheel");
  CHECK_MESSAGE(contains(wheel.out, "contact2d-0.2.0-py3-none-"), wheel.err);
  const Result files = run_shell("cd '" + folder.path() + "' && python3 -m zipfile -l " + wheel.out);
  for (const char* file : {"contact2d/py.typed", "contact2d/methods.pyi", "contact2d/tables.py", "contact2d/bin/contact2d"})
    CHECK_MESSAGE(contains(files.out, file), files.out);
  const Result none = build("CONTACT2D_BUILD=nowhere", "build_wheel");
  CHECK(none.status == 1);
  CHECK_MESSAGE(
      contains(none.err, "CONTACT2D_BUILD=nowhere: expected libcontact2d.so.0.2.0 and contact2d of `make python` in "),
      none.err);
}

TEST_CASE("python: what is taken from the tree is built by a target of its own, which is named where it is missing") {
  const Folder folder;
  const Result made =
      run_shell("env -u MAKEFLAGS -u MAKELEVEL make -n -C '" + kRoot + "' python BUILD='" + folder.path() + "'");
  CHECK_MESSAGE(made.status == 0, made.err);
  for (const char* file : {"/libcontact2d.so.0.2.0 ", "/contact2d "}) CHECK(contains(made.out, "-o " + folder.path() + file));
  CHECK(contains(read_file(kPackage + "/README.md"), "`make python`"));
  if (!can_host("python3")) return;
  fs::create_directories(folder / "port/python");
  fs::create_directories(folder / "include");
  fs::copy(kPackage + "/contact2d", folder / "port/python/contact2d", fs::copy_options::recursive);
  fs::copy(kRoot + "/include/contact2d.h", folder / "include/contact2d.h");
  const Result run = run_shell("cd '" + (folder / "port/python") +
                               "' && env -u CONTACT2D_LIBRARY LD_LIBRARY_PATH= "
                               "PYTHONDONTWRITEBYTECODE=1 python3 -c 'import contact2d'");
  CHECK(run.status == 1);
  CHECK_MESSAGE(contains(run.err, "`make python` in "), run.err);
}

TEST_CASE("python: the archive of the package holds what it is compiled from") {
  if (!can_host("python3")) return;
  const Folder folder;
  const Result made = run_shell(
      "cd '" + kPackage + "' && PYTHONDONTWRITEBYTECODE=1 python3 -c \"import build_contact2d as b; print(b.build_sdist('" +
      folder.path() + "'))\"");
  REQUIRE_MESSAGE(made.status == 0, made.err);
  REQUIRE(run_shell("cd '" + folder.path() + "' && tar xzf contact2d-0.2.0.tar.gz").status == 0);
  const std::string place = folder / "contact2d-0.2.0";
  // every source that is listed, and every file that one of them includes
  const Result whole =
      run_shell("cd '" + place +
                "' && PYTHONDONTWRITEBYTECODE=1 python3 -c \"import build_contact2d as b; "
                "print('\\n'.join(s for n in ('CORE', 'PORT', 'REPORT', 'PROGRAM') for s in b.listed(n + '_SOURCES')))\"");
  const std::vector<std::string> sources = lines_of(whole.out);
  REQUIRE(sources.size() > 300);
  const Result compiled = run_shell("cd '" + place + "/source' && " + paths::cxx_compiler() +
                                    " -std=c++17 -fsyntax-only -Isrc -Iinclude -Iport/memory -Iport/posix -Iport/stdio "
                                    "-Iport/threads -Iport/fortran " +
                                    sources.front() + " " + sources.back());
  CHECK_MESSAGE(compiled.status == 0, compiled.err);
  for (const std::string& source : sources) CHECK_MESSAGE(fs::exists(place + "/source/" + source), source);
}
