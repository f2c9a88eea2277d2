#pragma once
// One function per file with loops; null where the file was compiled without the instructions it needs, and in small code.
#include "linalg/kernel.hpp"

// Where vectors in memory cannot be had as kernel_loops.hpp wants them there are no loops either, and the plain forms
// do all: clang before 14 takes a vector behind a reference for an aligned one; x87 (i386 without SSE) calculates with
// more digits than it stores, so that a number looked for is not equal to itself.
#include <float.h>
#if (FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 1) || (defined(__clang__) && __clang_major__ < 14)
#define C2D_WIDEST_KERNEL 0
#else
#define C2D_WIDEST_KERNEL C2D_WIDEST_VECTOR
#endif

namespace c2d {

const Kernel* baseline_kernel();
const Kernel* avx2_kernel();
const Kernel* avx512_kernel();

} // namespace c2d
