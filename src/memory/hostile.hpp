#pragma once
// A build against the grain, for tests (`make hostile`): -DC2D_HOSTILE=width. Panels have that many columns where the
// caller leaves the width to the library, a workspace counts as the least that will do, memory that holds nothing is
// full of NaN and huge negative integers, promises inside the library are checked, transfers happen as late and tasks run
// in as strange an order as they may (tests/hostile), and every preparation is preceded by one whose block store
// fails. Without the macro all of this is nothing.
#include <stdint.h>
#include <string.h>

#include "memory/config.hpp"

#define C2D_ASSERT(promise) (!c2d::kHostile || (promise) ? static_cast<void>(0) : C2D_STOP())

// A condition that no test can make hold, for the reason told beside it: kept as a guard. In the hostile build it stops the
// program; the build that counts branches does not count it.
#if C2D_COUNTS_BRANCHES
#define C2D_NEVER(condition) (sizeof(condition) == 0)
#else
#define C2D_NEVER(condition) c2d::never(condition)
#endif

namespace c2d {

// A checker of memory would object to looking at bytes that nobody has written.
#if defined(__has_feature)
#if __has_feature(memory_sanitizer)
#define C2D_WATCHED 1
#endif
#endif
#ifdef C2D_WATCHED
constexpr bool kWatched = true;
#else
constexpr bool kWatched = false;
#endif

inline bool never(bool holds) {
  C2D_ASSERT(!holds);
  return holds;
}

// The bytes hold nothing any more, or nothing yet. A double of them is a NaN, an integer -1.
inline void poison(void* memory, uint64_t bytes) {
  if (kHostile) memset(memory, 0xff, static_cast<size_t>(bytes));
}

} // namespace c2d
