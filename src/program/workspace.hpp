// How much memory a run takes.
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

// Bytes of RAM that are free now; a guess if the system does not tell.
uint64_t free_memory();

// Takes `wanted` bytes, 0: everything in memory but at most half of what is free, at least the minimum.
// Returns a c2d_status; C2D_ERR_MEMORY with a text that names the bytes that would do.
c2d_status take_workspace(const c2d_limits& limits, uint64_t wanted, Workspace& out, std::string& error);

} // namespace app
