// Torsion of bodies whose angles are given on several sides, that meet three at a corner, or that are slit; rings that touch
// all round; paths of many events.
#include "json.hpp"
#include "paths.hpp"
#include "post/torsion/slip_path.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace test;

namespace {

const double kPi = std::acos(-1.0);

Json results(const std::string& text) {
  const Folder folder;
  write_file(folder / "s.c2s", text);
  const Result r =
      run_shell("'" + paths::program() + "' run -q '" + (folder / "s.c2s") + "' --json '" + (folder / "r.json") + "'");
  REQUIRE_MESSAGE(r.status == 0, r.err);
  return JsonReader::read(read_file(folder / "r.json"));
}

// A base of radius 2 and height 1, and upon it a rod of radius 1 within a ring; all of one material.
std::string stack(const std::string& ties, const std::string& given) {
  return "axisymmetric\nbody a E 1 nu 0\nfrom 0 0\nline s to 2 0\nline e to 2 1\nline n to 0 1\n"
         "body b E 1 nu 0\nfrom 0 1\nline s to 1 1\nline e to 1 2\nline n to 0 2\n"
         "body c E 1 nu 0\nfrom 1 1\nline s to 2 1\nline e to 2 2\nline n to 1 2\nline w close\n" +
         ties + "fix a.s x y\n" + given + "tolerance off\n";
}

double of(const Json& table, const std::string& name, const char* what) {
  const Json& all = table["turned"];
  for (size_t i = 0; i < all.items.size(); ++i)
    if (all[i]["name"].text == name) return table["steps"][table["steps"].items.size() - 1][what][i].number;
  return NAN;
}

} // namespace

TEST_CASE("torsion of rare shapes: three bodies that meet at a corner are one shaft, whatever the order of their ties") {
  const double torque = 0.5 * 0.1 / 2 * kPi / 2 * 16; // G angle over length, polar moment
  for (const char* ties : {"tie a.n b.s\ntie a.n c.s\ntie b.e c.w\n", "tie c.w b.e\ntie c.s a.n\ntie b.s a.n\n",
                           "tie b.e c.w\ntie b.s a.n\ntie a.n c.s\n"}) {
    CAPTURE(ties);
    const Json t = results(stack(ties, "fix a.s turn\nmove b.n turn 0.1\nmove c.n turn 0.1\n"))["torsion"];
    CHECK(of(t, "b.n", "torque") + of(t, "c.n", "torque") == doctest::Approx(torque).epsilon(2e-3));
    CHECK(of(t, "b.n", "torque") == doctest::Approx(torque / 16).epsilon(5e-3));
    CHECK(t["imbalance"].number < 1e-9);
  }
}

TEST_CASE("torsion of rare shapes: bodies that are turned on all sides turn as one, without a torque") {
  for (const char* ties : {"tie a.n b.s\ntie a.n c.s\ntie b.e c.w\n", "tie c.w b.e\ntie c.s a.n\ntie b.s a.n\n"})
    for (const char* given : {"move a.s turn 0.1\nmove a.e turn 0.1\nmove c.e turn 0.1\nmove b.n turn 0.1\n",
                              "move c.e turn 0.1\nmove c.n turn 0.1\n", "move a.e turn 0.1\n"}) {
      CAPTURE(ties);
      CAPTURE(given);
      const Json t = results(stack(ties, given))["torsion"];
      const Json& last = t["steps"][t["steps"].items.size() - 1];
      for (const Json& angle : last["angle"].items) CHECK(angle.number == doctest::Approx(0.1).epsilon(1e-9));
      for (const Json& torque : last["torque"].items) CHECK(std::fabs(torque.number) < 1e-9);
    }
}

TEST_CASE("torsion of rare shapes: a shaft with a slit whose faces are tied is a shaft, one whose faces slip carries less") {
  const std::string shaft = "axisymmetric\nbody a E 1 nu 0\nfrom 0 0\nline s to 2 0\nline e1 to 2 1\nline l to 1 1\n"
                            "line i to 1 1.00005\nline u to 2 1.00005\nline e2 to 2 2\nline n to 0 2\nfix a.s\n";
  const double torque = 0.5 * 0.1 / 2 * kPi / 2 * 16;
  const Json tied = results(shaft + "tie a.l a.u\nmove a.n turn 0.1\ntolerance off\n")["torsion"];
  const Json open = results(shaft + "move a.n turn 0.1\ntolerance off\n")["torsion"];
  CHECK(of(tied, "a.n", "torque") == doctest::Approx(torque).epsilon(0.01));
  CHECK(of(open, "a.n", "torque") < 0.8 * torque);
  CHECK(of(open, "a.n", "torque") > torque / 16);
}

TEST_CASE("torsion of rare shapes: a path of hundreds of events, pairs without a load and one without stiffness") {
  const size_t n = 450;
  app::SlipProblem problem{app::TwistMatrix(n, n), app::TwistMatrix(n, 1), {}};
  for (size_t i = 0; i < n; ++i) { // springs in parallel; the last is not loaded
    problem.stiffness.row(i)[i] = 2;
    problem.load.row(i)[0] = i + 1 < n ? 1 : 0;
    problem.limit.push_back(0.01 * static_cast<double>(i + 1));
  }
  app::SlipPath path(problem);
  size_t events = 0;
  CHECK(path.go_to({10}, [&](const app::SlipState&) { ++events; }));
  CHECK(events == n - 1);
  CHECK(path.residual() < 1e-12);
  for (size_t i = 0; i + 1 < n; ++i) {
    CHECK(path.state().traction[i] == doctest::Approx(problem.limit[i]));
    CHECK(path.state().slip[i] == doctest::Approx((problem.limit[i] - 10) / 2));
  }
  CHECK(path.state().traction[n - 1] == 0);
  app::SlipProblem loose{app::TwistMatrix(1, 1), app::TwistMatrix(1, 1), {1.0}};
  loose.load.row(0)[0] = 1;
  app::SlipPath free(loose);
  CHECK_FALSE(free.go_to({3}, [](const app::SlipState&) {}));
  CHECK(free.state().factors[0] == doctest::Approx(1));
  CHECK(free.state().traction[0] == doctest::Approx(1));
}

TEST_CASE("torsion of rare shapes: a rod in a ring-shaped channel touches all round, or below") {
  const std::string channel =
      "axisymmetric\nbody h E 100 nu 0.3\nfrom 4 -2\nline s to 8 -2\nline e to 8 2\nline n to 4 2\nline w close\n"
      "hole\ncircle i centre 6 0 radius 1\nbody r E 100 nu 0.3\n";
  const auto quantity = [](const Json& json, const std::string& name) {
    double out = NAN;
    for (const Json& q : json["runs"][0]["quantities"].items)
      if (q["quantity"].text == name) out = q["value"].number;
    return out;
  };
  const Json tight =
      results(channel + "circle o centre 6 0 radius 1.005\ncontact h.i r.o\nfix h.s\ninterference\ntolerance off\n");
  CHECK(quantity(tight, "mean pressure") > 0.7 * quantity(tight, "peak pressure"));
  CHECK(quantity(tight, "mean pressure") < quantity(tight, "peak pressure"));
  CHECK(quantity(tight, "contact width") == doctest::Approx(2 * kPi).epsilon(0.01));
  const Json low =
      results(channel + "circle o centre 6 -0.02 radius 0.98\ncontact h.i r.o\nfix h.s\nweight r fy -0.5\ntolerance off\n");
  CHECK(quantity(low, "contact width") > 0.1);
  CHECK(quantity(low, "contact width") < kPi);
  CHECK(quantity(low, "force y") == doctest::Approx(0.5 * kPi * 0.98 * 0.98 * 2 * kPi * 6).epsilon(0.01));
}
