// Stores what additional right-hand sides need of an elimination (later_sides.cpp): for each cluster its lists, couplings,
// interpolation matrices X and Z, LU factors and updated skeleton rows and columns; for the border its LU factors.
//
// Only bodies with lazy columns store it (METHOD 10.12): it is several times as long as the records for back substitution.
// Matrices are stored with the sign and orientation in which later_sides.cpp multiplies by them, so that a product is one
// call.
// The matrices are those of METHOD (10.12).
#include "elimination/later_sides.hpp"
#include "linalg/dense.hpp"
#include "linalg/lu.hpp"

namespace c2d {

namespace {

void append_numbers(Stream& to, const Real* from, int64_t count) {
  append(to, from, static_cast<uint64_t>(count) * sizeof(Real));
}
void append_ids(Stream& to, const int32_t* from, int64_t count) {
  append(to, from, static_cast<uint64_t>(count) * sizeof(int32_t));
}
void append_columns(Stream& to, int32_t rows, int32_t first, int32_t end, const Real* from, int64_t ld) {
  for (int32_t j = first; j < end; ++j) append_numbers(to, from + j * ld, rows);
}

void append_couplings(Compression& t, const TreeCluster& cluster) {
  const int32_t rows = cluster.rows - cluster.half_rows, columns = cluster.columns - cluster.half_columns;
  if (cluster.half_rows < 0) return; // a leaf
  append_numbers(t.kept, t.w.coupling[0], static_cast<int64_t>(cluster.half_rows) * columns);
  append_numbers(t.kept, t.w.coupling[1], static_cast<int64_t>(rows) * cluster.half_columns);
}

// Transposes x and applies a sign: right-hand sides lie side by side, so a cluster's matrix acts from the right.
void append_turned(Compression& t, Real sign, int32_t rows, int32_t columns, const Real* x) {
  Real* const turned = t.w.samples; // the samples are no longer needed
  for (int32_t j = 0; j < columns; ++j)
    for (int32_t i = 0; i < rows; ++i)
      turned[j + static_cast<int64_t>(i) * columns] = sign * x[i + static_cast<int64_t>(j) * rows];
  append_numbers(t.kept, turned, static_cast<int64_t>(rows) * columns);
}

} // namespace

c2d_status keep_cluster(Compression& t, const TreeCluster& cluster, const Split& s) {
  const CompressedWork& w = t.w;
  const int64_t n = cluster.unknowns;
  const KeptCluster counts = {s.spare, s.rows, s.columns, cluster.columns - s.columns, cluster.half_rows, cluster.half_columns};
  append(t.kept, &counts, sizeof counts);
  append_ids(t.kept, cluster.row_ids, cluster.rows);
  append_ids(t.kept, cluster.column_ids, cluster.columns);
  append_ids(t.kept, w.row_order, cluster.rows);
  append_ids(t.kept, w.column_order, cluster.columns);
  append_ids(t.kept, w.ids, s.spare);
  append_couplings(t, cluster);
  append_columns(t.kept, s.rows, 0, s.spare, w.row_x, s.rows);
  append_turned(t, -1, s.columns, counts.rest, w.column_x);
  append_columns(t.kept, s.spare, 0, s.spare + s.rows, w.e, n);
  const int64_t behind = static_cast<int64_t>(s.spare + s.rows) * n;
  // Negated, because the contribution of x_1 to the columns is added and gemm_minus() subtracts.
  for (int32_t j = 0; j < s.columns; ++j)
    for (int32_t i = 0; i < s.spare; ++i) w.e[behind + j * n + i] = -w.e[behind + j * n + i];
  append_columns(t.kept, s.spare, 0, s.columns, w.e + behind, n);
  return t.kept.status;
}

c2d_status keep_border(Compression& t, const TreeCluster& root, const int32_t* unknowns, int32_t size) {
  const CompressedWork& w = t.w;
  const int32_t rows = border_rows(t.plan);
  if (lu_factor(t.engine, size, w.whole, size, w.pivots, w.samples, nullptr) > 0) return C2D_ERR_SINGULAR;
  const KeptCluster counts = {size, root.rows, root.columns, rows, root.half_rows, root.half_columns};
  append(t.kept, &counts, sizeof counts);
  append_ids(t.kept, root.row_ids, root.rows);
  append_ids(t.kept, root.column_ids, root.columns);
  append_ids(t.kept, w.ids, root.unknowns);
  append_ids(t.kept, unknowns, 3);
  append_ids(t.kept, w.pivots, size);
  append_couplings(t, root);
  append_turned(t, 1, rows, root.columns, w.sums);
  append_numbers(t.kept, w.whole, static_cast<int64_t>(size) * size);
  return t.kept.status;
}

} // namespace c2d
