// Calls of the library that are refused: what stands between it and report and program, the linker puts there (Makefile).
#pragma once

#include <contact2d.h>

#include <cstdint>
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

} // namespace test
