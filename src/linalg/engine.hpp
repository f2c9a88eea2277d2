#pragma once
// Resources of the dense routines: a kernel, memory for packing, and workers that share the columns of a matrix.
#include "linalg/kernel.hpp"
#include "memory/workers.hpp"

namespace c2d {

// An engine without a kernel, or with too little scratch to pack one row and one column of its tile, uses the plain form. The
// number of workers changes no bit of any result.
struct Engine {
  const Kernel* kernel;
  Real* scratch;   // aligned to 64 bytes
  int64_t numbers; // its size
  int64_t* used;   // raised to the largest amount used; or null
  Workers workers = kAlone;
};
constexpr Engine kPlainEngine = {nullptr, nullptr, 0, nullptr, kAlone};

// Products use up to kDepth of the inner index at a time. Of B, up to kWidth columns are packed at a time, more if the inner
// index is shorter; they stay in or near the second-level cache (a block of 256: 768 KiB). Of A, up to kBand rows (98 to 295
// KB), which that cache delivers fast enough. Measured at n = 2000 and 4000: half the depth or width costs 5 %, because C is
// loaded or A packed twice as often; a band of 24 rows costs 5 %, with tiles of 4 rows more.
constexpr int32_t kDepth = 384, kWidth = 384, kBand = 96;
// Numbers of scratch with which any kernel runs at full speed on k x n right factors.
constexpr int64_t full_scratch(int64_t k, int64_t n) {
  return (k < kDepth ? k : kDepth) * (kBand + (n < kWidth ? (n + 7) / 8 * 8 : kWidth));
}
// Number of engines into which this one can be divided so that each computes as the whole one does: each worker has scratch
// for full depth. At least 1.
int32_t parts_of(const Engine& engine);

// work(argument, engine, 0) ... work(argument, engine, items - 1), each once, in any order, by all workers, each with an
// engine of its own. Items are handed out from both ends: the first and the last start first. Items own what they write.
typedef void (*ItemWork)(void* argument, const Engine& engine, int32_t item);
void run_items(const Engine& engine, int32_t items, ItemWork work, void* argument);
// For work that follows a group of items and is done by the item that finishes last: subtracts one and returns whether it was
// the last. Everything that the other items wrote can be read then.
bool is_last(int32_t* left);

} // namespace c2d
