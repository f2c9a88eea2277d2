// Largest and smallest stress along a surface lie between nodes as a rule.
#include "program/estimate/hoop.hpp"
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
