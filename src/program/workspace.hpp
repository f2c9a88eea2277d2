// The memory of a run.
#pragma once

#include <contact2d.h>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>

namespace app {

struct FreeMemory {
  void operator()(void* memory) const { std::free(memory); }
};
struct Workspace {
  std::unique_ptr<void, FreeMemory> memory;
  uint64_t bytes = 0;
  uint64_t minimum = 0, in_core = 0;
};

// Bytes of RAM that are free now; a guess if the system gives no value.
uint64_t free_memory();

// Asks the system to use large pages for memory[0 .. bytes): the first access to a large page costs little more than one to
// a page of 4 KiB. A hint that only affects speed.
void ask_for_huge_pages(void* memory, uint64_t bytes);

// Workspace that compressed elimination can use, with this minimum.
uint64_t compressed_bytes(uint64_t minimum);

// The smallest sufficient workspace: this minimum, or the estimate for compressed elimination, whose ranks are not known
// before.
uint64_t least_bytes(const c2d_limits& limits, int32_t elimination, uint64_t minimum);

// More than is written to a tape, as a rule: with compressed elimination a quarter of what may be by the least workspace; else
// UINT64_MAX.
uint64_t expected_bytes(const c2d_limits& limits, int32_t elimination, uint64_t minimum, int32_t tape);

// C2D_ELIMINATION_DENSE or COMPRESSED: the requested one, or by size.
int32_t elimination_of(const c2d_limits& limits, int32_t chosen);

// c2d_limits.touching: what is chosen, below 0: a fifth of the pairs where there are more than kManyPairs, else all; all
// together where the rest of the limits and options say that no contact can be on demand.
constexpr int32_t kManyPairs = 1500;
int32_t touching_of(const c2d_limits& limits, int32_t chosen, int32_t elimination, int32_t stepping);

// Takes `wanted` bytes, 0: everything in memory but at most half of what is free, at least the minimum; for compressed
// elimination what that makes use of. Returns a c2d_status; C2D_ERR_MEMORY with a text that names the bytes that would do.
c2d_status take_workspace(const c2d_limits& limits, uint64_t wanted, int32_t elimination, Workspace& out, std::string& error);

} // namespace app
