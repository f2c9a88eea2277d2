// Registers of 16 bytes, on any machine but those that calculate with more digits than they store (x87: i386 without
// SSE), which have no such registers, and where a number looked for is not equal to itself. See kernel_loops.hpp.
#include <float.h>

#include "linalg/kernel_sets.hpp"
#if !defined(C2D_SMALL) && (FLT_EVAL_METHOD == 0 || FLT_EVAL_METHOD == 1)
#define C2D_VECTOR_BYTES 16
#define C2D_TILE_VECTORS 2
#define C2D_TILE_COLUMNS 4
#include "linalg/kernel_loops.hpp"

const c2d::Kernel* c2d::baseline_kernel() {
  return &kLoops;
}
#else
const c2d::Kernel* c2d::baseline_kernel() {
  return nullptr;
}
#endif
