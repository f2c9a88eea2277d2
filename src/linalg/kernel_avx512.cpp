// 32 registers of 64 bytes: a tile of 24 and 3 of a column take them. See kernel_loops.hpp.
#include "linalg/kernel_sets.hpp"
#if C2D_WIDEST_KERNEL >= 64
#define C2D_VECTOR_BYTES 64
#define C2D_TILE_VECTORS 3
#define C2D_TILE_COLUMNS 8
#include "linalg/kernel_loops.hpp"

const c2d::Kernel* c2d::avx512_kernel() { return &kLoops; }
#else
const c2d::Kernel* c2d::avx512_kernel() { return nullptr; }
#endif
