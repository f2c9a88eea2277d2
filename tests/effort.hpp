// How far the long loops of tests go: in short, or in full where C2D_TESTS_FULL is set (make proof).
#pragma once

#include <cstdlib>

namespace test {

inline bool in_full() {
  const char* const set = std::getenv("C2D_TESTS_FULL");
  return set != nullptr && *set != 0;
}

// The step or the number of turns of a loop.
template <class T> T effort(T in_short, T full) { return in_full() ? full : in_short; }

} // namespace test
