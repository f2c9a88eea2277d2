#pragma once
// One function per file with loops; null where the file was compiled without the instructions it needs, and in small code.
#include "linalg/kernel.hpp"

// Without vectors as kernel_loops.hpp needs them there are no loops, and the plain forms do everything: clang before 14 takes a
// vector behind a reference for an aligned one; x87 (i386 without SSE) computes with more digits than it stores, so a number
// may differ from its stored value.
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
