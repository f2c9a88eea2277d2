// Choice of the instruction set: what this build contains and this processor can run. The processor reports its instructions
// (cpuid). The operating system reports which registers it saves when it switches threads (xgetbv). Both are needed: a
// register that is not saved loses its contents.
#include "linalg/kernel.hpp"
#include "linalg/kernel_sets.hpp"
#include "memory/hostile.hpp"

#if defined(__x86_64__) && C2D_EXTENSIONS
#include <cpuid.h>
#endif

namespace c2d {
namespace {

constexpr uint32_t kFma = 1u << 12, kAsksSystem = 1u << 27, kAvx2 = 1u << 5, kAvx512 = 1u << 16;

#if defined(__x86_64__) && C2D_EXTENSIONS

// Registers that the operating system saves when it switches between threads.
uint32_t kept_registers() {
  uint32_t low, high;
  __asm__("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
  return low;
}

ProcessorSays ask_processor() {
  uint32_t a = 0, b = 0, c = 0, d = 0;
  __get_cpuid(1, &a, &b, &c, &d); // leaves them where there is no such leaf
  ProcessorSays says = {c, 0, 0};
  b = 0;
  __get_cpuid_count(7, 0, &a, &b, &c, &d);
  says.more_features = b;
  if (C2D_NEVER((says.features & kAsksSystem) == 0)) return says; // (an operating system of before 2009)
  says.kept = kept_registers();
  return says;
}

#else

ProcessorSays ask_processor() { return {}; }

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

Instructions instructions_of(const ProcessorSays& processor) {
  constexpr uint32_t kWide = 0x06, kWidest = 0xe6;
  if ((processor.features & kFma) == 0 || (processor.features & kAsksSystem) == 0) return Instructions::baseline;
  const auto has = [&](uint32_t feature, uint32_t registers) {
    return (processor.more_features & feature) != 0 && (processor.kept & registers) == registers;
  };
  return has(kAvx512, kWidest) ? Instructions::avx512 : (has(kAvx2, kWide) ? Instructions::avx2 : Instructions::baseline);
}

Instructions best_there(Instructions most, const Kernel* (*find)(Instructions)) {
  int32_t set = static_cast<int32_t>(most);
  // A build may lack a set that the processor has: take the next lower one.
  while (set > 0 && find(static_cast<Instructions>(set)) == nullptr) --set;
  return static_cast<Instructions>(set);
}

Instructions best_instructions() {
  return kSmallCode ? Instructions::baseline : best_there(instructions_of(ask_processor()), kernel_for);
}

} // namespace c2d
