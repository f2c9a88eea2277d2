// Calls in any order with any arguments, in any state, with everything failing.
#include "calls.hpp"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string violation = calls::run(data, size);
  if (violation.empty()) return 0;
  std::fprintf(stderr, "contact2d.h does not hold: %s\n", violation.c_str());
  __builtin_trap();
}
