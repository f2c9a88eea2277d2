#pragma once
// The inner loops of the elimination, once per instruction set. A product C -= A B is formed in tiles of C of `rows` x `cols`
// numbers that stay in registers: A comes in slices of `rows` rows, B packed row by row in slices of `cols` columns.
// Everything around them (blocking, packing, edges) is common: packed.cpp, lu.cpp.
#include "memory/config.hpp"
#include <stdint.h>

namespace c2d {

struct Kernel {
  int32_t rows, cols; // of a tile
  // C (rows x cols) -= A (rows x k) B (k x cols); A and C column-major, B row-major without gaps.
  void (*tile)(int32_t k, const Real* a, int64_t lda, const Real* b, Real* c, int64_t ldc);
  // B (n x cols, row-major without gaps) := L^-1 B, L unit lower triangular, column-major.
  void (*solve)(int32_t n, const Real* l, int64_t ldl, Real* b);
  // B := U^-1 B, U upper triangular. Where its diagonal is zero, the row of the solution is set to zero.
  void (*solve_upper)(int32_t n, const Real* u, int64_t ldu, Real* b);
  // x (m) -= L (m x k) u; returns where the first of the largest absolute values of x is, -1 if all are zero.
  int32_t (*column)(int32_t m, int32_t k, const Real* l, int64_t ldl, const Real* u, Real* x);
  // x (n) *= factor.
  void (*scale)(int32_t n, Real factor, Real* x);
  // The largest absolute value of x (n), 0 if n = 0.
  Real (*largest)(int32_t n, const Real* x);
  // A (rows x k) to `to`, without gaps.
  void (*pack)(int32_t k, const Real* a, int64_t lda, Real* to);
  // B (k x cols), column-major, to rows without gaps, and back.
  void (*to_rows)(int32_t k, const Real* b, int64_t ldb, Real* to);
  void (*from_rows)(int32_t k, const Real* from, Real* b, int64_t ldb);
  // y (n) += factor x.
  void (*add)(int32_t n, Real factor, const Real* x, Real* y);
  // y (n) += f x + g z.
  void (*add_two)(int32_t n, Real f, const Real* x, Real g, const Real* z, Real* y);
};
constexpr int32_t kMostTileNumbers = 24 * 8 * static_cast<int32_t>(sizeof(double) / sizeof(Real));

// Instruction sets, ascending. `plain` is a scalar form that needs no scratch memory and little code.
enum class Instructions : int16_t { plain = 0, baseline = 1, avx2 = 2, avx512 = 3 };
// Null for plain, and for a set that this build does not contain.
const Kernel* kernel_for(Instructions set);
// Features that a processor and its operating system report: cpuid 1 (ecx), cpuid 7 (ebx), xgetbv (registers saved). Not
// reported: 0.
struct ProcessorSays {
  uint32_t features, more_features, kept;
};
Instructions instructions_of(const ProcessorSays& processor);
// The best set up to `most` that `find` returns a kernel for.
Instructions best_there(Instructions most, const Kernel* (*find)(Instructions));
// The best set that this build contains and this machine runs. Queries the processor each time: store the answer.
Instructions best_instructions();

} // namespace c2d
