#pragma once
// Interpolative decomposition: of the columns of a matrix a few that the others are combinations of (METHOD 7.6).
//
// The matrix is given by samples, a row each, that come one after another. Where more samples come than there is room for, each
// is added into several of the rows kept, with signs that a fixed sequence decides: combinations that hold for all samples hold
// for these sums and, with as many rows as columns and some more, the other way round.
#include "linalg/kernel.hpp"
#include <stdint.h>

namespace c2d {

struct SampleSum {
  Real* w;         // [rows * columns], row by row
  int32_t columns; // of the matrix
  int32_t rows;    // that are kept
  int64_t taken;   // samples so far
  int64_t samples; // that will come, at least as many as do
  const Kernel* kernel;
};
// Rows that are kept of so many samples of so many columns.
int32_t rows_to_keep(int64_t samples, int32_t columns);
SampleSum begin_samples(Real* w, int32_t columns, int64_t samples, const Kernel* kernel = nullptr);
// One sample, x[j * step]; with `unit` divided by its largest entry.
void add_sample(SampleSum& sum, const Real* x, int64_t step, bool unit);

// Columns order[0 .. k) are chosen, the others are, to `tolerance` times the largest column's norm,
//   column order[k + j] = sum over i of column order[i] x[i + j * k],   j = 0 ... columns - k - 1.
// Returns k; most + 1 if more than `most` would be needed (x is then not told). What the samples were is lost. norms: room for
// `columns` numbers. With `relative` every column is measured by its own norm.
int32_t interpolate(SampleSum& sum, double tolerance, bool relative, int32_t most, int32_t* order, Real* norms, Real* x);

} // namespace c2d
