#pragma once
// What the dense routines work with: a kernel, memory to pack into, and workers to share the columns of a matrix.
#include "linalg/kernel.hpp"
#include "memory/workers.hpp"

namespace c2d {

// An engine without a kernel, or with less scratch than packs one row and one column of its tile, takes the plain form. How
// many workers there are changes no bit of any result.
struct Engine {
  const Kernel* kernel;
  Real* scratch;   // aligned to 64 bytes
  int64_t numbers; // its size
  int64_t* used;   // raised to the most that was taken; or null
  Workers workers = kAlone;
};
constexpr Engine kPlainEngine = {nullptr, nullptr, 0, nullptr, kAlone};

// Products go over up to kDepth of the inner index at a time. Of B, up to kWidth columns are packed at a time, more where
// the inner index is shorter, which stay in or near the second-level cache (a block of 256: 768 KiB), of A up to kBand rows
// (98 to 295 KB), which come from there fast enough for the tiles. Measured at n = 2000 and 4000: half the depth or width
// costs 5 %, by fetching C or packing A twice as often; a band of 24 rows costs 5 %, with tiles of 4 rows more.
constexpr int32_t kDepth = 384, kWidth = 384, kBand = 96;
// Numbers of scratch with which engines of any kernel run at full speed on k x n right factors.
constexpr int64_t full_scratch(int64_t k, int64_t n) {
  return (k < kDepth ? k : kDepth) * (kBand + (n < kWidth ? (n + 7) / 8 * 8 : kWidth));
}
// Into how many engines this one can be divided that calculate as it does itself: each worker's with scratch for full
// depth. At least 1.
int32_t parts_of(const Engine& engine);

// work(argument, engine, 0) ... work(argument, engine, items - 1), each once, in any order, by all workers, each with an
// engine of its own. They are handed out from both ends: the first and the last are begun first. Items own what they write.
typedef void (*ItemWork)(void* argument, const Engine& engine, int32_t item);
void run_items(const Engine& engine, int32_t items, ItemWork work, void* argument);
// For items that something is done after, by whichever of them ends last: one less is left of them; was it the last? What the
// others wrote can be read then.
bool is_last(int32_t* left);

} // namespace c2d
