// Registers of 16 bytes, on any machine. See kernel_loops.hpp.
#include "linalg/kernel_sets.hpp"
#if C2D_WIDEST_KERNEL >= 16
#define C2D_VECTOR_BYTES 16
#define C2D_TILE_VECTORS 2
#define C2D_TILE_COLUMNS 4
#include "linalg/kernel_loops.hpp"

const c2d::Kernel* c2d::baseline_kernel() { return &kLoops; }
#else
const c2d::Kernel* c2d::baseline_kernel() { return nullptr; }
#endif
