#pragma once
// A build against the grain, for tests (`make hostile`): -DC2D_HOSTILE=width. Panels have that many columns where the
// caller leaves the width to the library, a workspace counts as the least that will do, memory that holds nothing is
// full of NaN and huge negative integers, promises inside the library are checked, transfers happen as late and tasks run
// in as strange an order as they may (tests/hostile), and every preparation is preceded by one whose block store
// fails. Without the macro all of this is nothing.
#include <stdint.h>
#include <string.h>

#include "memory/config.hpp"

#define C2D_ASSERT(promise) (!c2d::kHostile || (promise) ? static_cast<void>(0) : __builtin_trap())

namespace c2d {

// The bytes hold nothing any more, or nothing yet. A double of them is a NaN, an integer -1.
inline void poison(void* memory, uint64_t bytes) {
  if (kHostile && bytes > 0) memset(memory, 0xff, static_cast<size_t>(bytes));
}

} // namespace c2d
