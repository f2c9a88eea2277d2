// 16 registers of 32 bytes: a tile of 12 takes them. See kernel_loops.hpp.
#include "linalg/kernel_sets.hpp"
#if C2D_WIDEST_KERNEL >= 32
#define C2D_VECTOR_BYTES 32
#define C2D_TILE_VECTORS 3
#define C2D_TILE_COLUMNS 4
#include "linalg/kernel_loops.hpp"

const c2d::Kernel* c2d::avx2_kernel() { return &kLoops; }
#else
const c2d::Kernel* c2d::avx2_kernel() { return nullptr; }
#endif
