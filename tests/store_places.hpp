#pragma once
// The places of the program at which the store is asked for something, by their chains of calls, and what becomes of
// the calls of a host when one of them fails.
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#if defined(__GLIBC__)
#include <execinfo.h>
#endif

namespace runs {

// The calls that lead here.
inline std::vector<uintptr_t> calls_to_here() {
  std::vector<uintptr_t> out;
#if defined(__GLIBC__)
  void* frame[40];
  const int frames = backtrace(frame, 40);
  for (int i = 0; i < frames; ++i) out.push_back(reinterpret_cast<uintptr_t>(frame[i]));
#endif
  return out;
}
// Who asks.
inline uint64_t asker(const std::vector<uintptr_t>& calls = calls_to_here()) {
  uint64_t out = 14695981039346656037u;
  for (const uintptr_t call : calls) out = (out ^ call) * 1099511628211u;
  return out;
}

struct Life {
  c2d_status status = C2D_OK; // of the first call that failed
  std::string call;           // which it was
  c2d_error error = C2D_INIT(c2d_error);
  int32_t state = 0;
  Numbers numbers;
};

// The calls in their order, until one of them fails.
struct Caller {
  c2d_solver* solver;
  Life& life;
  bool operator()(const char* call, c2d_status status) {
    if (life.status != C2D_OK) return false;
    life.status = status, life.call = call;
    if (status != C2D_OK) {
      life.error = error_of(solver);
      life.state = c2d_get_state(solver);
    }
    return status == C2D_OK;
  }
};

inline bool is_of(char kind, c2d_status status) {
  switch (kind) {
  case 'o': return status == C2D_ERR_STORE_OPEN;
  case 'r': return status == C2D_ERR_STORE_READ;
  case 'w': return status == C2D_ERR_STORE_WRITE;
  case 's': return status == C2D_ERR_STORE_SYNC;
  default: return status == C2D_ERR_STORE_CLOSE;
  }
}

// What the failure of one operation of the store has led to; `clean`: the same calls with a store that does not fail.
inline void check_failed_life(const Life& life, const Life& clean, const RamStore::Operation& failed) {
  if (life.status == C2D_OK) { // at most what says how far the tapes are used, or the end
    CHECK((failed.kind == 'c' || failed.tape == C2D_TAPE_CONTROL));
    CHECK(life.numbers == clean.numbers);
    return;
  }
  if (life.call == "c2d_restore") { // an older state may be there, or none: the solver is as before, or broken
    CHECK(life.status >= C2D_ERR_STORE_OPEN);
    CHECK((life.state == C2D_STATE_RUNNING || life.state == C2D_STATE_BROKEN));
    return;
  }
  CHECK(is_of(failed.kind, life.status));
  CHECK(life.error.status == life.status);
  CHECK(life.error.host_code == 1000 + failed.kind);
  CHECK(life.error.tape == failed.tape);
  if (life.call != "c2d_save") CHECK(life.state == C2D_STATE_BROKEN);
}

struct Place {                // of the program
  size_t first = 0, last = 0; // operations
};

} // namespace runs
