// Four sources at a time. See batch_loops.hpp.
#include "bie/integrals/batch.hpp"
#if C2D_WIDEST_VECTOR >= 32
#define C2D_VECTOR_BYTES 32
#include "bie/integrals/batch_loops.hpp"

const c2d::BatchKernel* c2d::avx2_batch() { return &kBatchLoops; }
#else
const c2d::BatchKernel* c2d::avx2_batch() { return nullptr; }
#endif
