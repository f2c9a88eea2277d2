// Calls of the system by the ports that fail: what stands between, the linker puts there (Makefile).
#pragma once

#include <cstdint>
#include <functional>

namespace test {

struct SystemCall {
  const char* name;
  int64_t number; // counted from 1
  uint64_t bytes; // to be moved; of others 0
};
// What becomes of a call: errno of one that fails (0: it fails and does not say why; of bytes it moves none), or one of these.
enum { kDone = -1, kHalf = -2, kPretended = -3 }; // half of the bytes; all of them, and no memory is looked at
using SystemJudge = std::function<int(const SystemCall&)>;

// While it lives, each call of any thread is judged. One at a time.
class SystemCalls {
public:
  explicit SystemCalls(SystemJudge judge);
  ~SystemCalls();
  SystemCalls(const SystemCalls&) = delete;
  SystemCalls& operator=(const SystemCalls&) = delete;
};
bool can_judge_calls(); // can it be done here at all?

} // namespace test
