// Sketches on the command line: values and tolerances of parameters that are none, results that miss their tolerances in
// several zones, memory that does not suffice for a derivative.
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

using namespace test;

namespace {

Result program(const std::string& command, const std::string& sketch, const std::string& words = "") {
  const Folder folder;
  write_file(folder / "s.c2s", sketch);
  return run_shell("cd '" + folder.path() + "' && '" + paths::program() + "' " + command + " s.c2s " + words);
}

const std::string kBar =
    "parameter R 5 +- 0.1\nbody b E 1 nu 0\nfrom 0 0\nline s to R 0\nline e to R 1\nline n to 0 1\nline w close\n"
    "fix b.w\ntraction b.e fx 1\nwant stress b 1 0.5\n";
const std::string kShaft =
    "axisymmetric\nparameter R 2\nbody a E 1 nu 0\nfrom 0 0\nline s to R 0\nline e to R 1\nline n to 0 1\n"
    "fix a.s\ntraction a.n turn 1\ntolerance off\n";

} // namespace

TEST_CASE("drawn deck: values of parameters and tolerances that are no numbers") {
  for (const std::string word : {"R=5+-", "R=5+-inf", "R=inf+-1", "R=5+-%", "R=nan", "R=", "R=5+--1"}) {
    CAPTURE(word);
    const Result r = program("check", kBar, word);
    CHECK(r.status == 64);
    CHECK(contains(r.err, word + ": expected the name of a parameter, = and a number"));
    CHECK(contains(r.err, "a tolerance not below 0") == (word.find("+-") != std::string::npos));
  }
  CHECK(program("check", kBar, "R=5+-2%").status == 0);
}

TEST_CASE("drawn deck: numbers that miss their tolerances, of several zones, bodies and curves") {
  const std::string two = "body f E 1 nu 0\nfrom -4 -2\nline s to 4 -2\nline e to 4 0\nline n to -4 0\nline w close\n"
                          "body a E 1 nu 0\ncircle o centre -2 1 radius 1\nbody b E 1 nu 0\ncircle o centre 2 1 radius 1\n"
                          "contact f.n a.o\ncontact f.n b.o\nfix f.s\nweight a fy -1e-3\nweight b fy -1e-3\n"
                          "want pressure 1e-4 %\nwant edges 1e-4 %\nwant hoop f.e 1e-4 %\nwant hoop f.w 1e-4 %\n"
                          "want stress a -2 1 1e-5 %\nwant stress b 2 1 1e-5 %\nlimit elements 200\n";
  for (const std::string command : {"run", "mesh"}) {
    CAPTURE(command);
    const Result r = program(command, two);
    CHECK(r.status == 5);
    for (const std::string part : {"of zone 1", "of zone 2", "its error is"}) {
      CAPTURE(part);
      CHECK_MESSAGE(contains(r.err, part), r.err);
    }
  }
}

TEST_CASE("drawn deck: where memory is too small, nothing is differentiated and nothing turned") {
  const Result bar = program("run", kBar + "tolerance off\n", "--memory 5K");
  CHECK(bar.status == 4);
  CHECK(contains(bar.err, "workspace of 5120 bytes is too small"));
  const Result shaft = program("run", kShaft, "--memory 5K");
  CHECK(shaft.status == 4);
  CHECK(contains(shaft.err, "workspace of 5120 bytes is too small"));
  CHECK(program("run", kBar + "tolerance off\n").status == 0);
  // A mesh is made without loads round the axis.
  const Result mesh = program("mesh", kShaft);
  CHECK(mesh.status == 0);
  CHECK(contains(mesh.out, "*FREE"));
}
