#pragma once
// The hostile build (memory/hostile.hpp) prepares every model twice, first with a store that fails on the way.
#include "solver/solver.hpp"

namespace c2d {

// The solver's store, until it has been asked `left` times. Trivial; `port` holds functions that expect this struct.
struct FailingStore {
  c2d_port caller;
  int64_t left;
  c2d_port port;
};
constexpr int32_t kRehearsedFailure = 4711; // what it returns then

void make_failing(const c2d_port& caller, int64_t left, FailingStore& out);

} // namespace c2d
