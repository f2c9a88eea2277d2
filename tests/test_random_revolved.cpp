// A draw of random bodies of revolution (more of them: make random KIND=revolved). tests/test_random_bodies.cpp has what their
// judge sees.
#include "effort.hpp"
#include "memory/config.hpp"
#include "random/revolved_bodies.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace random_decks;

TEST_CASE("random bodies: a draw of revolution" * doctest::skip(!c2d::kRings || c2d::kSmallCode)) {
  int reached = 0, forces = 0;
  const uint64_t count = test::effort<uint64_t>(3, 40);
  for (uint64_t seed = 1; seed <= count; ++seed) {
    const Verdict v = judge_revolved(seed);
    std::string all;
    for (const std::string& f : v.findings) all += "\n" + f;
    CHECK_MESSAGE(v.findings.empty(), "make random N=1 KIND=revolved SEED=" << seed << ": " << v.title << all);
    reached += v.status == C2D_OK && v.outcome == C2D_REACHED;
    std::string title;
    const many::Result r = many::solve(generate_revolved(seed, title));
    if (!r.steps.empty()) forces += std::fabs(r.zones.empty() ? 0 : r.zones[0].force[1]) > 0;
  }
  CHECK(2 * static_cast<uint64_t>(reached) > count); // or the draw says little
  CHECK(2 * static_cast<uint64_t>(forces) > count);
}

TEST_CASE("random bodies: rings that nothing presses any more move freely, in all forms" *
          doctest::skip(!c2d::kRings || c2d::kSmallCode)) {
  const Verdict v = judge_revolved(1272);
  CHECK(v.outcome == C2D_FREE_MOTION);
  CHECK(v.findings.empty());
}
