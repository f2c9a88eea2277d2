// Eight sources at a time. See batch_loops.hpp.
#include "bie/batch.hpp"
#if !defined(C2D_SMALL) && defined(__AVX512F__) && defined(__FMA__)
#define C2D_VECTOR_BYTES 64
#include "bie/batch_loops.hpp"

const c2d::BatchKernel* c2d::avx512_batch() { return &kBatchLoops; }
#else
const c2d::BatchKernel* c2d::avx512_batch() { return nullptr; }
#endif
