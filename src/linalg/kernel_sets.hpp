#pragma once
// One function per file with loops; null where the file was compiled without the instructions it needs, or
// small code was asked for (C2D_SMALL, which -Os implies).
#include "linalg/kernel.hpp"

namespace c2d {

const Kernel* baseline_kernel();
const Kernel* avx2_kernel();
const Kernel* avx512_kernel();

} // namespace c2d
