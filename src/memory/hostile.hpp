#pragma once
// A build for tests under hostile conditions (`make hostile`): -DC2D_HOSTILE=width. Panels have that many columns where the
// caller leaves the width to the library. A workspace is never larger than necessary. Unused memory is full of NaN and huge
// negative integers. Assertions inside the library are checked. Transfers happen as late and tasks run in as unusual an order
// as allowed (tests/hostile). Every preparation is preceded by one whose block store fails. Without the macro nothing of this
// remains.
#include <stdint.h>
#include <string.h>

#include "memory/config.hpp"

#define C2D_ASSERT(promise) (!c2d::kHostile || (promise) ? static_cast<void>(0) : C2D_STOP())

// A condition that no test can make true, for the reason given beside it: a guard. In the hostile build it stops the program;
// the build that counts branches does not count it.
#if C2D_COUNTS_BRANCHES
#define C2D_NEVER(condition) (sizeof(condition) == 0)
#else
#define C2D_NEVER(condition) c2d::never(condition)
#endif

namespace c2d {

// A memory checker reports reads of bytes that were never written.
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

inline bool never(bool condition) {
  C2D_ASSERT(!condition);
  return condition;
}

// Overwrites memory that has no valid contents any more, or none yet. As a double it is NaN, as an integer -1.
inline void poison(void* memory, uint64_t bytes) {
  if (kHostile) memset(memory, 0xff, static_cast<size_t>(bytes));
}

} // namespace c2d
