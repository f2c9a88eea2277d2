// Thin layers upon each other between blocks, pressed: the pressure is uniform to within the round-off that is told, or the
// model is refused.
#include "many_bodies.hpp"
#include "memory/config.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace many;

namespace {

enum class Joint { matching, free, tied };

// Blocks of size 1 with layers of thickness t of other materials between them; nu = 0, pressure 1: all stress is uniform.
Model layered(int32_t layers, double t, int32_t function_nodes, Joint joint) {
  const double moduli[] = {500, 100, 700};
  Model m;
  m.function_nodes = function_nodes;
  m.add(rectangle(0, 0, 1, 1, {8, 4, 8, 4}, 1000, 0));
  for (int32_t i = 0; i < layers; ++i) m.add(rectangle(0, 1 + t * i, 1, 1 + t * (i + 1), {8, 1, 8, 1}, moduli[i], 0));
  m.add(rectangle(0, 1 + t * layers, 1, 2 + t * layers, {8, 4, 8, 4}, 2000, 0));
  for (Body& b : m.bodies) b.ends.assign(static_cast<size_t>(b.elements() * function_nodes), End());
  m.set(1, 1, end_of(kHeld));
  m.set(layers + 2, 3, end_of(kPulled, 0, -1));
  for (int32_t b = 1; b <= layers + 1; ++b)
    m.join((joint == Joint::free ? C2D_ZONE_FREE : C2D_ZONE_MATCHING) + (joint == Joint::tied ? C2D_ZONE_TIED : 0), b, 3, b + 1,
           1);
  m.friction = 0.5;
  return m;
}

struct Errors {
  double pressure = 0, motion = 0;
};
Errors errors_of(const Model& m, const Result& r, double t) {
  Errors e;
  for (const Row& row : r.last().rows) e.pressure = std::max(e.pressure, std::fabs(row[C2D_TN] - 1));
  double shortened = 1.0 / 2000; // of the uppermost block, then of those below it
  for (size_t b = 0; b + 1 < m.bodies.size(); ++b) shortened += (b == 0 ? 1 : t) / m.bodies[b].youngs_modulus;
  for (const EndResult& end : r.boundary.back())
    if (std::fabs(end.y - m.scale()) < 1e-9) e.motion = std::max(e.motion, std::fabs(-end.uy / shortened - 1));
  return e;
}

const Joint kJoints[] = {Joint::matching, Joint::free, Joint::tied};

} // namespace

TEST_CASE("slender: one layer between blocks is right at any thickness" * doctest::skip(c2d::kSmallCode)) {
  for (const int32_t nodes : {2, 3, 4})
    for (const double t : {1e-3, 1e-6}) {
      const Model m = layered(1, t, nodes, Joint::matching);
      const Result r = solve(m);
      REQUIRE(r.outcome == C2D_REACHED);
      const Errors e = errors_of(m, r, t);
      CHECK(e.pressure < 1e-10);
      CHECK(e.motion < 1e-8);
    }
}

TEST_CASE("slender: layers upon each other lose no more than is told, or are refused" * doctest::skip(c2d::kSmallCode)) {
  int refused = 0, solved = 0;
  for (const Joint joint : kJoints)
    for (const int32_t nodes : {2, 3, 4})
      for (const double t : {1e-1, 1e-2, 1e-3, 1e-6}) {
        const int32_t layers = joint == Joint::tied ? 3 : 2;
        CAPTURE(static_cast<int>(joint));
        CAPTURE(nodes);
        CAPTURE(t);
        const Model m = layered(layers, t, nodes, joint);
        const Result r = solve(m);
        if (nodes > 2 && t < 2e-3) {
          CHECK(r.status == C2D_ERR_SINGULAR);
          CHECK_MESSAGE(r.told_of("so slender that round-off may be up to "), r.messages());
          CHECK(std::count_if(r.told.begin(), r.told.end(), [](const c2d_error& e) { return e.severity == C2D_FAULT; }) == 1);
          ++refused;
          continue;
        }
        REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
        REQUIRE(r.outcome == C2D_REACHED);
        const Errors e = errors_of(m, r, t);
        CHECK(e.pressure < 1e-14 + 2.2e-16 * r.summary.condition);
        CHECK(e.pressure < 1e-8);
        CHECK(e.motion < 1e-8);
        ++solved;
      }
  CHECK(refused == 12);
  CHECK(solved == 24);
}
