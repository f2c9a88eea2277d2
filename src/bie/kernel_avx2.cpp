// Four sources at a time. See batch_loops.hpp.
#include "bie/batch.hpp"
#if !defined(C2D_SMALL) && defined(__AVX2__) && defined(__FMA__)
#define C2D_VECTOR_BYTES 32
#include "bie/batch_loops.hpp"

const c2d::BatchKernel* c2d::avx2_batch() { return &kBatchLoops; }
#else
const c2d::BatchKernel* c2d::avx2_batch() { return nullptr; }
#endif
