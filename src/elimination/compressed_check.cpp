// Residual of a compressed solution: some of the body's equations are assembled anew, without compression, and the solution is
// inserted (METHOD 7.6, "how exact").
//
// Phases:
// 1. Read the samples: some 32 nodes, their diagonal blocks and right-hand sides.
// 2. For the columns of kNodesAtOnce nodes at a time: r += A x, term by term, and the largest term.
// 3. Add tr V of the holes, METHOD (4.1), and subtract the right-hand sides: r = H u - G t + L n tr V - sum lambda_k r_k.
// The residual is compared with its largest term, because r alone has the unit of the displacements and says nothing by
// itself. 32 nodes are a sample: compression acts on whole clusters, so an error of it affects many equations.
// Literature: Higham, Accuracy and Stability of Numerical Algorithms, chapter 7 (residuals and backward error).
#include <string.h>

#include "elimination/compressed_work.hpp"
#include "memory/math.hpp"
#include "memory/sizes.hpp"
#include "model/symmetry.hpp"

namespace c2d {

namespace {

constexpr int32_t kNodesAtOnce = 32, kColumnsOfNode = 6; // outer unknowns, contact displacements, contact tractions
constexpr int32_t kMostColumns = kNodesAtOnce * kColumnsOfNode + 3;

struct CheckWork {
  double* diagonal;          // [4 nodes], of the samples alone
  double *sum, *largest;     // [2 samples]
  double* trace;             // [holes] tr V
  Real *block, *row, *value; // [2 samples * columns], [columns], [columns]
  Real* right;               // [2 samples * loads]
  int32_t *place, *stamp;    // of all columns, -1; of elements
  int32_t *elements, *node, *column;
  int32_t* hole; // hole of each sample
  double* point;
  int32_t* twin;
  Hole* holes;
  char* buffer;
};

uint64_t lay_out_check(const CompressedPlan& plan, char* base, CheckWork* out) {
  CheckWork w{};
  AreaCarver area{base};
  const uint64_t samples = kCheckedNodes, nodes = static_cast<uint64_t>(plan.nodes), columns = kMostColumns;
  const uint64_t holes = static_cast<uint64_t>(plan.holes);
  area.take(w.diagonal, 4 * nodes);
  area.take(w.sum, 2 * samples);
  area.take(w.largest, 2 * samples);
  area.take(w.trace, holes);
  area.take(w.block, 2 * samples * columns);
  area.take(w.row, columns);
  area.take(w.value, columns);
  area.take(w.right, 2 * samples * static_cast<uint64_t>(plan.loads));
  area.take(w.place, static_cast<uint64_t>(plan.columns) + 2 * static_cast<uint64_t>(plan.contact));
  area.take(w.stamp, nodes);
  area.take(w.elements, 2 * kNodesAtOnce);
  area.take(w.node, samples);
  area.take(w.column, columns);
  area.take(w.hole, samples);
  area.take(w.point, 2 * samples);
  area.take(w.twin, samples);
  area.take(w.holes, holes);
  area.take(w.buffer, kBlockHeaderBytes + plan.block_bytes);
  if (out) *out = w;
  return area.total();
}

struct Check {
  const CompressedPlan& plan;
  const ColumnSystem& system; // of the samples
  const Real *coefficient, *x;
  CheckWork w;
  int32_t samples, listed; // columns of a chunk
};

c2d_status read_samples(const CompressedPlan& plan, Tapes& tapes, const CheckWork& w) {
  uint64_t end = 0, at = 0;
  Stream stream = open_records(plan, tapes, w.buffer, &end);
  if (stream.status == C2D_OK && end < sample_bytes(plan)) return C2D_ERR_INTERNAL;
  for (int32_t i = 0; i < sample_count(plan); ++i) {
    CheckedNode sample{};
    if (read_at(stream, at, &sample, sizeof sample) != C2D_OK) return stream.status;
    at += sizeof sample;
    if (sample.node < 0 || sample.node >= plan.nodes || sample.hole < -1 || sample.hole >= plan.holes) return C2D_ERR_INTERNAL;
    w.node[i] = sample.node;
    w.twin[i] = sample.twin;
    w.hole[i] = sample.hole;
    memcpy(w.point + 2 * i, sample.point, sizeof sample.point);
    memcpy(w.diagonal + 4 * static_cast<int64_t>(sample.node), sample.diagonal, sizeof sample.diagonal);
    const uint64_t bytes = 2 * static_cast<uint64_t>(plan.loads) * sizeof(Real);
    read_at(stream, at, w.right + 2 * static_cast<int64_t>(i) * plan.loads, bytes);
    at += bytes;
  }
  return stream.status;
}

void list_column(Check& c, int32_t column, Real value) {
  c.w.place[column] = c.listed;
  c.w.column[c.listed] = column;
  c.w.value[c.listed++] = value;
}

// Columns of a node and their values in the solution. Contact quantities stand on the right-hand side, hence the minus sign.
void list_columns(Check& c, int32_t node) {
  const int32_t own = c.plan.columns;
  visit_columns(c.plan, c.system.model, c.system.body, node,
                [&](int32_t j) { list_column(c, j, j < own ? c.x[j] : -c.coefficient[j - own]); });
}

int32_t list_elements_at(Check& c, int32_t first, int32_t end) {
  const Model& m = c.system.model;
  int32_t listed = 0;
  for (int32_t node = first; node < end; ++node) {
    int32_t ends[2];
    const int found = ends_at_node(m, c.system.body, node, ends);
    for (int k = 0; k < found; ++k) {
      const int32_t element = ends[k] / m.head->function_nodes;
      if (c.w.stamp[element] == first) continue;
      c.w.stamp[element] = first;
      c.w.elements[listed++] = element;
    }
  }
  return listed;
}

// One pass over the body in chunks of nodes: memory for a few columns of the sample rows is enough for any body.
void add_chunk(Check& c, int32_t first, int32_t end) {
  const CheckWork& w = c.w;
  c.listed = 0;
  for (int32_t node = first; node < end; ++node) list_columns(c, node);
  for (int32_t k = 0; k < 3 && end == c.plan.nodes; ++k) // rho and omega
    list_column(c, c.plan.columns - 3 + k, c.x[c.plan.columns - 3 + k]);
  const ChosenColumns columns{w.place, c.listed, w.elements, list_elements_at(c, first, end)};
  const int32_t rows = 2 * c.samples;
  fill_chosen(c.system, columns, w.block, rows);
  for (int32_t j = 0; j < c.listed; ++j)
    for (int32_t i = 0; i < rows; ++i) {
      const double term = static_cast<double>(w.block[i + static_cast<int64_t>(j) * rows]) * static_cast<double>(w.value[j]);
      w.sum[i] += term;
      w.largest[i] = fmax(w.largest[i], fabs(term));
    }
  for (int32_t k = 0; k < c.plan.holes; ++k) {
    fill_hole_row(c.system, w.holes[k], columns, w.row, 1);
    for (int32_t j = 0; j < c.listed; ++j) w.trace[k] += static_cast<double>(w.row[j]) * static_cast<double>(w.value[j]);
  }
  for (int32_t j = 0; j < c.listed; ++j) w.place[w.column[j]] = -1;
}

// The part of METHOD (4.1) beside the integrals, and the right-hand sides.
void add_rest(Check& c) {
  const CheckWork& w = c.w;
  for (int32_t i = 0; i < 2 * c.samples; ++i) {
    const int32_t s = i / 2, hole = w.hole[s];
    if (hole >= 0 && !is_held_by_symmetry(c.system.model, c.system.body, w.node[s], i % 2)) {
      double n[2];
      hole_normal(c.system.model, c.system.body, w.node[s], n);
      w.sum[i] += n[i % 2] * w.trace[hole];
    }
    for (int32_t k = 0; k < c.plan.loads; ++k)
      w.sum[i] -= static_cast<double>(w.right[(static_cast<int64_t>(s) * c.plan.loads + k) * 2 + i % 2]) *
                  static_cast<double>(c.coefficient[2 * c.plan.contact + k]);
  }
}

} // namespace

uint64_t compressed_check_bytes(const CompressedPlan& plan) { return lay_out_check(plan, nullptr, nullptr); }

c2d_status check_compressed(const CompressedPlan& plan, const ColumnSystem& whole, Tapes& tapes, const Real* coefficient,
                            const Real* x, void* work, Remainder* out) {
  CheckWork w;
  lay_out_check(plan, static_cast<char*>(work), &w);
  const c2d_status status = read_samples(plan, tapes, w);
  if (status != C2D_OK) return status;
  // A body whose only sources are the samples; columns and elements are those of the whole body.
  ColumnSystem system = whole;
  system.diagonal = w.diagonal;
  system.point = w.point;
  system.twin = w.twin;
  system.chosen = w.node;
  system.sources = sample_count(plan);
  system.some_passed_over = true;
  Check c{plan, system, coefficient, x, w, system.sources, 0};
  list_holes(system, plan.holes, w.holes);
  for (int32_t j = 0; j < plan.columns + 2 * plan.contact; ++j) w.place[j] = -1;
  for (int32_t node = 0; node < plan.nodes; ++node) w.stamp[node] = -1;
  for (int32_t k = 0; k < plan.holes; ++k) w.trace[k] = 0.0;
  for (int32_t i = 0; i < 2 * system.sources; ++i) w.sum[i] = w.largest[i] = 0.0;
  for (int32_t node = 0; node < plan.nodes; node += kNodesAtOnce)
    add_chunk(c, node, node + kNodesAtOnce < plan.nodes ? node + kNodesAtOnce : plan.nodes);
  add_rest(c);
  double squares = 0.0, most = 0.0, terms = 0.0;
  for (int32_t i = 0; i < 2 * system.sources; ++i) {
    squares += w.sum[i] * w.sum[i];
    most = fmax(most, fabs(w.sum[i]));
    terms = fmax(terms, w.largest[i]);
  }
  out->mean = sqrt(squares / (2 * system.sources));
  out->relative = terms > 0.0 ? most / terms : 0.0;
  return C2D_OK;
}

} // namespace c2d
