// From reset to main on a Cortex-M3, M4 or M7: vectors, floating-point unit, static data, a painted stack.
#include "startup.hpp"

#include "semihosting.hpp"

int main();

// Set by the linker script (sections.ld): ends of regions, not data.
extern "C" {
extern uint32_t c2d_data_image[], c2d_data_start[], c2d_data_end[], c2d_bss_start[], c2d_bss_end[], c2d_stack_top[];
void c2d_reset();
}

namespace {

constexpr uint32_t kPaint = 0xC0DEFACEu;

inline uint32_t* stack_pointer() {
  uint32_t* here;
  asm volatile("mov %0, sp" : "=r"(here));
  return here;
}

void fault() {
  host::say("contact2d: hardware fault\n");
  host::end(70);
}
void interrupt() {
  host::say("contact2d: an interrupt that nobody asked for\n");
  host::end(71);
}

} // namespace

extern "C" void c2d_reset() {
#if defined(__ARM_FP)
  // Coprocessors 10 and 11, before the first instruction that needs them.
  *reinterpret_cast<volatile uint32_t*>(0xE000ED88u) |= 0xFu << 20;
  asm volatile("dsb\n\tisb" ::: "memory");
#endif
  const uint32_t* from = c2d_data_image;
  for (uint32_t* to = c2d_data_start; to < c2d_data_end; ++to, ++from) *static_cast<volatile uint32_t*>(to) = *from;
  for (uint32_t* to = c2d_bss_start; to < c2d_bss_end; ++to) *static_cast<volatile uint32_t*>(to) = 0;
  uint32_t* const here = stack_pointer();
  for (uint32_t* to = c2d_bss_end; to < here; ++to) *static_cast<volatile uint32_t*>(to) = kPaint;
  host::end(main());
}

// Where the core looks for its first stack pointer and its handlers.
struct Vectors {
  const uint32_t* stack;
  void (*handler[15])();
};
extern "C" __attribute__((section(".vectors"), used))
const Vectors c2d_vectors = {c2d_stack_top,
                             {c2d_reset, fault, fault, fault, fault, fault, nullptr, nullptr, nullptr, nullptr, interrupt,
                              interrupt, nullptr, interrupt, interrupt}};

uint32_t stack_size() { return static_cast<uint32_t>(c2d_stack_top - c2d_bss_end) * 4; }

uint32_t stack_used() {
  const uint32_t* lowest = c2d_bss_end;
  while (lowest < c2d_stack_top && *static_cast<const volatile uint32_t*>(lowest) == kPaint) ++lowest;
  return static_cast<uint32_t>(c2d_stack_top - lowest) * 4;
}
