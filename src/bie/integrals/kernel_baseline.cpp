// Two sources at a time, on any machine. See batch_loops.hpp.
#include "bie/integrals/batch.hpp"
#if C2D_WIDEST_VECTOR >= 16
#define C2D_VECTOR_BYTES 16
#include "bie/integrals/batch_loops.hpp"

const c2d::BatchKernel* c2d::baseline_batch() { return &kBatchLoops; }
#else
const c2d::BatchKernel* c2d::baseline_batch() { return nullptr; }
#endif
