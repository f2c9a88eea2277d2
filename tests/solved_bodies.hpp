#pragma once
// What most tests of models of many bodies begin with.
#include "many_bodies.hpp"

#include <doctest/doctest.h>

namespace solved_bodies {

constexpr int32_t kKinds[] = {C2D_ZONE_MATCHING, C2D_ZONE_FREE};

// The result of a model that has to reach its load.
inline many::Result solved(const many::Model& m) {
  const many::Result r = many::solve(m);
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  REQUIRE_MESSAGE(r.outcome == C2D_REACHED, c2d_outcome_message(r.outcome) << "\n" << r.messages());
  return r;
}

} // namespace solved_bodies
