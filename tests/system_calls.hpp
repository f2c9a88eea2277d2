// Calls of the system that fail: what stands between, the linker puts there (Makefile).
#pragma once

#include "callable.hpp"

#include <cstdint>
#include <cstring>
#include <utility>

namespace test {

struct SystemCall {
  const char* name;
  int64_t number; // counted from 1
  uint64_t bytes; // to be moved; of others 0
};
// What becomes of a call: errno of one that fails (0: it fails and does not say why; of bytes it moves none), or one of these.
enum { kDone = -1, kHalf = -2, kPretended = -3 }; // half of the bytes; all of them, and no memory is looked at
using SystemJudge = test::Callable<int(const SystemCall&)>;

// While it lives, each call of any thread is judged. One at a time.
class SystemCalls {
public:
  explicit SystemCalls(SystemJudge judge);
  ~SystemCalls();
  SystemCalls(const SystemCalls&) = delete;
  SystemCalls& operator=(const SystemCalls&) = delete;
};
bool can_judge_calls(); // can it be done here at all?

// Those of one name alone: an errno is what one fails with, kNothing that it moves no bytes, kDone that it is done.
constexpr int kNothing = 0;
class System {
public:
  System(const char* name, test::Callable<int()> fate)
      : name_(name), fate_(std::move(fate)), all_([this](const SystemCall& call) {
          if (std::strcmp(call.name, name_) != 0) return static_cast<int>(kDone);
          ++calls_;
          return fate_();
        }) {}
  // The n-th, from 1, fails.
  System(const char* name, int n, int code)
      : System(name, [this, n, code] { return calls_ == n ? code : static_cast<int>(kDone); }) {}
  int calls() const { return calls_; } // so far

private:
  const char* name_;
  test::Callable<int()> fate_;
  int calls_ = 0;
  SystemCalls all_;
};

} // namespace test
