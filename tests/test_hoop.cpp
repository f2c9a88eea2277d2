// Largest and smallest stress along a surface lie between nodes as a rule.
#include "program/estimate/hoop.hpp"
#include "program/estimate/wanted.hpp"
#include "program/sketch/refine.hpp"
#include "sketches.hpp"

#include <cmath>

using namespace sketch;
using namespace sketches;

namespace {

struct Solved {
  Mesh mesh;
  estimate::Trial trial;
};

// A body on its mesh, without a load; the stress along its surface is `stress` of the place.
template <class Stress> Solved body_with(const Sketch& s, int32_t halved, Stress stress) {
  Solved out{first_mesh(s, 0.5), {}};
  for (; halved > 0; --halved) out.mesh = sketch::halved(s, out.mesh);
  std::string why;
  REQUIRE_MESSAGE(estimate::solve(deck_of(s, out.mesh), {}, out.trial, why) == C2D_OK, why);
  std::vector<double> along;
  const auto n = static_cast<size_t>(out.trial.nodes);
  for (const MeshedOutline& outline : out.mesh.bodies[0])
    for (const MeshedCurve& curve : outline.curves)
      for (size_t e = 0; e + 1 < curve.ends.size(); ++e)
        for (size_t i = 0; i < n; ++i) {
          const double f = static_cast<double>(i) / static_cast<double>(n - 1);
          along.push_back(stress(
              curve.curve->shape->at(curve.measure.u_at(curve.ends[e] + f * (curve.ends[e + 1] - curve.ends[e]))), curve));
        }
  for (estimate::State& state : out.trial.states) state.ends[0][estimate::kHoop] = along;
  return out;
}

Side side_of(const Sketch& s) { return *s.wants.at(0).side; }

} // namespace

TEST_CASE("hoop: the largest stress along a bore is that of the place between the nodes") {
  const Sketch s = sound("body b E 1 nu 0\n  from -3 -3\n  line s to 3 -3\n  line e to 3 3\n  line n to -3 3\n  line w close\n"
                         "  hole\n  circle bore centre 0 0 radius 1\nfix b.s\ntraction b.n y 1\nwant hoop b.bore\n");
  for (double turn = 0; turn < 0.35; turn += 0.05) {
    CAPTURE(turn);
    const Solved solved = body_with(s, 1, [&](Point p, const MeshedCurve&) {
      return 2 + std::cos(2 * (std::atan2(p.y, p.x) - turn)) * std::hypot(p.x, p.y);
    });
    const estimate::Hoop hoop = find_hoop(solved.mesh, solved.trial, side_of(s), 0);
    const size_t elements = solved.trial.lengths[0].size();
    CAPTURE(elements);
    CHECK(std::fabs(hoop.high.value - 3) < 4e-3);
    CHECK(std::fabs(hoop.low.value - 1) < 4e-3);
    const double at = std::atan2(hoop.high.at.y, hoop.high.at.x);
    CHECK(std::fabs(std::remainder(at - turn, std::acos(-1.0))) < 0.05);
  }
}

TEST_CASE("hoop: at a corner the stress is that of the node") {
  const Sketch s = sound(std::string(kSquare) + "fix b.s\ntraction b.n y 1\nwant hoop b.e+n\n");
  // it rises up to the corner of e and n, where it falls to half
  const Solved solved = body_with(s, 1, [&](Point p, const MeshedCurve& curve) {
    return curve.curve->name == "e" ? 1 + p.y : curve.curve->name == "n" ? 0.5 * (1 + p.x) : 0;
  });
  const estimate::Hoop hoop = find_hoop(solved.mesh, solved.trial, side_of(s), 0);
  CHECK(hoop.high.value == doctest::Approx(2).epsilon(1e-12));
  CHECK(hoop.high.at.x == doctest::Approx(1));
  CHECK(hoop.high.at.y == doctest::Approx(1));
}

namespace {

std::vector<app::Stated> wanted_on_first(const Sketch& s) {
  const Mesh mesh = first_mesh(s, 1);
  estimate::Demand demand;
  estimate::ask(s, demand);
  estimate::Trial trial;
  std::string why;
  REQUIRE_MESSAGE(estimate::solve(deck_of(s, mesh), demand, trial, why) == C2D_OK, why);
  return estimate::wanted_of(s, mesh, trial);
}
double value_named(const std::vector<app::Stated>& all, const std::string& name) {
  for (const app::Stated& s : all)
    if (s.name() == name) return s.value;
  FAIL(name);
  return NAN;
}

} // namespace

TEST_CASE("hoop: the stress out of the plane, of a tube round its axis, and its range") {
  const std::string square =
      "body b E 1 nu 0.3\n  from 0 0\n  line s to 1 0\n  line e to 1 1\n  line n to 0 1\n  line w close\n"
      "fix b.s y\nfix b.w.start x\ncase p\ntraction b.n fy 2\nhistory p 1, -1, 1\n"
      "want stress zz b 0.5 0.5 0.2 0.3 2 %\nwant stress zz b.e 3 %\nwant cycle range stress zz b.e\n"
      "want cycle range stress zz b 0.5 0.5\n";
  const Sketch plane = sound(square);
  REQUIRE(plane.wants.size() == 5);
  CHECK((plane.wants[0].is_zz && plane.wants[1].tolerance == 0.02 && plane.wants[2].of == WantOf::kCurves));
  const std::vector<app::Stated> of_square = wanted_on_first(plane); // plane strain: nu (sxx + syy)
  for (const char* name : {"stress zz", "largest stress zz on e"})
    CHECK(value_named(of_square, name) == doctest::Approx(0.6).epsilon(1e-9));
  CHECK(value_named(of_square, "smallest stress zz on e") == doctest::Approx(-0.6).epsilon(1e-9));
  for (const char* name :
       {"range of stress zz", "range of stress zz on e", "cycle range of stress zz on e", "cycle range of stress zz"})
    CHECK(value_named(of_square, name) == doctest::Approx(1.2).epsilon(1e-9));
  for (const app::Stated& s : of_square) CHECK(s.what >= app::Measure::kStressZZ); // nothing else was wanted
  // Lame: p (b^2 + a^2)/(b^2 - a^2) at the bore, at r a^2/(b^2 - a^2) (1 + b^2/r^2) p.
  const std::vector<app::Stated> of_tube = wanted_on_first(
      sound("axisymmetric\nbody t E 1000 nu 0.3\n  from 1 0\n  line low to 3 0\n  line out to 3 1\n  line top to 1 1\n"
            "  line bore close\nfix t.low y\npressure t.bore 8\nfunctions quadratic\nelements t.low 12\nelements t.top 12\n"
            "want stress zz t.bore\nwant stress zz t 2 0.5\n"));
  CHECK(value_named(of_tube, "largest stress zz on bore") == doctest::Approx(10).epsilon(0.01));
  CHECK(value_named(of_tube, "stress zz") == doctest::Approx(1 + 9.0 / 4).epsilon(1e-3));
  CHECK(sound(square.substr(0, square.find("want stress zz b.e")) +
              "body zz E 1 nu 0\nfrom 5 5\nline a to 6 5\nline c to 6 6\nline d close\nfix zz.a\n")
            .wants[0]
            .is_zz);
}
