#include "linalg/kernel.hpp"
#include "linalg/kernel_sets.hpp"

#if defined(__x86_64__)
#include <cpuid.h>
#endif

namespace c2d {
namespace {

#if defined(__x86_64__)

// Which registers the operating system keeps when it switches between threads.
uint32_t kept_registers() {
  uint32_t low, high;
  __asm__("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
  return low;
}

Instructions of_processor() {
  constexpr uint32_t kFma = 1u << 12, kAsksSystem = 1u << 27, kAvx2 = 1u << 5, kAvx512 = 1u << 16;
  constexpr uint32_t kWide = 0x06, kWidest = 0xe6;
  uint32_t a, b, c, d;
  if (!__get_cpuid(1, &a, &b, &c, &d) || !(c & kFma) || !(c & kAsksSystem)) return Instructions::baseline;
  if (!__get_cpuid_count(7, 0, &a, &b, &c, &d)) return Instructions::baseline;
  const uint32_t kept = kept_registers();
  if ((b & kAvx512) && (kept & kWidest) == kWidest) return Instructions::avx512;
  return (b & kAvx2) && (kept & kWide) == kWide ? Instructions::avx2 : Instructions::baseline;
}

#else

Instructions of_processor() { return Instructions::baseline; }

#endif

} // namespace

const Kernel* kernel_for(Instructions set) {
  switch (set) {
  case Instructions::avx512: return avx512_kernel();
  case Instructions::avx2: return avx2_kernel();
  case Instructions::baseline: return baseline_kernel();
  default: return nullptr;
  }
}

Instructions best_instructions() {
  if (kSmallCode) return Instructions::baseline;
  int32_t set = static_cast<int32_t>(of_processor());
  while (set > 0 && kernel_for(static_cast<Instructions>(set)) == nullptr) --set;
  return static_cast<Instructions>(set);
}

} // namespace c2d
