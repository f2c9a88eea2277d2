// Calls of the library that are refused: what stands between it and report and program, the linker puts there (Makefile).
#pragma once

#include <contact2d.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace test {

// The n-th call of those that refused_calls.cpp lists, counted from here, is not done and returns `status`. 0: none.
void refuse_call(int64_t n, c2d_status status = C2D_ERR_STATE);
// Of the calls since then the first from each place and the last; all of one name. Can they be refused here at all?
std::vector<int64_t> calls_to_refuse();
std::vector<int64_t> calls_of(const std::string& name);
bool can_refuse_calls();
const char* call_refused(); // its name, once it came to it

// As long as it lives calls of the system by a name that refused_calls.cpp lists are asked about: 0 lets one through, an errno
// is what it fails with, kNothing that it moves no bytes. One of them at a time.
constexpr int kNothing = -1;
class System {
public:
  System(const char* name, std::function<int()> asked);
  // The n-th, from 1.
  System(const char* name, int n, int code);
  ~System();
  System(const System&) = delete;
  System& operator=(const System&) = delete;
  int calls() const; // so far
};

} // namespace test
