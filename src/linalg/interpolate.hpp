#pragma once
// Interpolative decomposition: chooses a few columns of a matrix of which all others are combinations (METHOD 7.6).
//
// The matrix is given by samples, one row each, which come one after another. If more samples come than there are rows, each is
// added to several rows, with signs from a fixed sequence. A combination of columns that is valid for all samples is valid for
// these sums. With somewhat more rows than columns the converse is practically certain.
#include "linalg/kernel.hpp"
#include <stdint.h>

namespace c2d {

struct SampleSum {
  Real* w;         // [rows * columns], row by row
  int32_t columns; // of the matrix
  int32_t rows;    // rows that are stored
  int64_t taken;   // samples so far
  int64_t samples; // samples that will come, an upper bound
  const Kernel* kernel;
};
// Rows stored for so many samples of so many columns.
int32_t rows_to_keep(int64_t samples, int32_t columns);
SampleSum begin_samples(Real* w, int32_t columns, int64_t samples, const Kernel* kernel = nullptr);
// One sample, x[j * step]; with `unit` divided by its largest entry.
void add_sample(SampleSum& sum, const Real* x, int64_t step, bool unit);

// Columns order[0 .. k) are chosen, the others are, to `tolerance` times the largest column's norm,
//   column order[k + j] = sum over i of column order[i] x[i + j * k],   j = 0 ... columns - k - 1.
// Returns k; most + 1 if more than `most` are needed (x is then undefined). The samples are overwritten. norms: room for
// `columns` numbers. With `relative` the tolerance refers to each column's own norm.
int32_t interpolate(SampleSum& sum, double tolerance, bool relative, int32_t most, int32_t* order, Real* norms, Real* x);

} // namespace c2d
