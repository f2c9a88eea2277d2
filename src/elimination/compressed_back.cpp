// Solutions and functionals from the records of compressed elimination (METHOD 7.6).
//
// Solution, root to leaves:
// 1. The dense border gives its own unknowns y (back_substitute).
// 2. Each cluster, in reverse order of elimination: x_1 = h - M x_2, where x_2 was found by the cluster above it.
// Functional f . x = w . c, leaves to root, the transpose of that:
// 1. Each cluster: w += h^T f_1, then f_2 := f_2 - M^T f_1. The eliminated unknowns are then accounted for.
// 2. The border takes the rest (transposed_functional).
// Both read the records once. The tape is written once, so a record is found by its length: behind it when reading backwards,
// from its counts when reading forwards.
// Literature: Golub and Van Loan, Matrix Computations, section 3.1 (substitution).
#include <string.h>

#include "elimination/later_sides.hpp"
#include "linalg/dense.hpp"
#include "memory/sizes.hpp"

namespace c2d {

Stream records_of(const CompressedPlan& plan, Tapes& tapes, char* buffer) {
  const uint64_t dense = most_upper_use(plan.border).blocks;
  return open_stream(tapes, C2D_TAPE_UPPER, plan.border.upper_first_block + dense + 1,
                     compressed_upper_use(plan).blocks - dense - 1, plan.block_bytes, buffer);
}

Stream open_records(const CompressedPlan& plan, Tapes& tapes, char* buffer, uint64_t* end) {
  Stream out = records_of(plan, tapes, buffer);
  *end = 0;
  out.status = read_block(tapes, C2D_TAPE_UPPER, out.first_block - 1, buffer, kEndBytes);
  if (out.status == C2D_OK) memcpy(end, buffer + kBlockHeaderBytes, sizeof *end);
  if (*end > out.blocks * out.block_bytes) *end = 0;
  return out;
}

namespace {

struct BackWork {
  Real *y, *coefficient; // unknowns of the border; its trailing columns'
  char *record, *buffer;
  void* dense;
};

uint64_t record_bytes(const CompressedPlan& plan) {
  const uint64_t own = static_cast<uint64_t>(record_numbers(plan)) * sizeof(double);
  const uint64_t border = static_cast<uint64_t>(plan.border.pivots) * sizeof(int32_t) + sizeof(uint64_t);
  return own > border ? own : border;
}

uint64_t lay_out_back(const CompressedPlan& plan, char* base, BackWork* out) {
  AreaCarver area{base};
  BackWork w{};
  char* dense = nullptr;
  const uint64_t block = round_up(kBlockHeaderBytes + plan.block_bytes), own = back_substitution_bytes(plan.border);
  area.take(dense, own > block ? own : block); // enough for any cut of the border
  w.dense = dense;
  area.take(w.y, static_cast<uint64_t>(plan.border.pivots));
  area.take(w.coefficient, static_cast<uint64_t>(plan.border.trailing));
  area.take(w.record, record_bytes(plan));
  area.take(w.buffer, kBlockHeaderBytes + plan.block_bytes);
  if (out) *out = w;
  return area.total();
}

// A cluster's record, as write_record() wrote it. The numbers of M and h are not aligned in it, so they are copied out.
struct Record {
  int32_t spare, kept;
  const char *ids, *m, *h;
  int32_t id(int32_t i) const {
    int32_t out;
    memcpy(&out, ids + static_cast<size_t>(i) * sizeof out, sizeof out);
    return out;
  }
};

int32_t border_id(const char* record, int32_t j) {
  int32_t out;
  memcpy(&out, record + static_cast<size_t>(j) * sizeof out, sizeof out);
  return out;
}

Real number(const char* at, int64_t i) {
  Real out;
  memcpy(&out, at + static_cast<size_t>(i) * sizeof out, sizeof out);
  return out;
}

struct Records {
  const CompressedPlan& plan;
  Stream stream;
  BackWork w;
  uint64_t end;
};

Records begin_reading(const CompressedPlan& plan, Tapes& tapes, void* work) {
  Records r{plan, {}, {}, 0};
  lay_out_back(plan, static_cast<char*>(work), &r.w);
  r.stream = open_records(plan, tapes, r.w.buffer, &r.end);
  return r;
}

// Counts and identities address memory, and the record may come from another program: every one of them is checked.
c2d_status fault_of(const Records& r) { return r.stream.status != C2D_OK ? r.stream.status : c2d_status{C2D_ERR_INTERNAL}; }

uint64_t length_of(const Records& r, int64_t spare, int64_t kept) {
  const int64_t numbers = spare * (kept + right_sides(r.plan)), most = 2 * static_cast<int64_t>(r.plan.rank);
  if (spare < 0 || kept < 0 || spare + kept > most) return UINT64_MAX;
  return static_cast<uint64_t>(2 + spare + kept) * sizeof(int32_t) + static_cast<uint64_t>(numbers) * sizeof(Real);
}

bool open_record(const Records& r, uint64_t length, Record& out) {
  const char* at = r.w.record;
  memcpy(&out.spare, at, sizeof out.spare);
  memcpy(&out.kept, at + sizeof out.spare, sizeof out.kept);
  if (length_of(r, out.spare, out.kept) != length) return false;
  out.ids = at + 2 * sizeof(int32_t);
  out.m = out.ids + static_cast<size_t>(out.spare + out.kept) * sizeof(int32_t);
  out.h = out.m + static_cast<size_t>(out.spare) * static_cast<size_t>(out.kept) * sizeof(Real);
  for (int32_t i = 0; i < out.spare + out.kept; ++i)
    if (out.id(i) < 0 || out.id(i) >= r.plan.columns) return false;
  return true;
}

// Reads the record that ends at `end` into w.record and moves `end` to its begin. Returns its length; 0 if there is none.
uint64_t read_backwards(Records& r, uint64_t& end) {
  uint64_t length = 0;
  if (r.stream.status != C2D_OK || end < sizeof length ||
      read_at(r.stream, end - sizeof length, &length, sizeof length) != C2D_OK)
    return 0;
  if (length < 2 * sizeof(int32_t) || length > record_bytes(r.plan) || length + sizeof length > end) return 0;
  end -= length + sizeof length;
  return read_at(r.stream, end, r.w.record, length) == C2D_OK ? length : 0;
}

// Reads which unknown of the body each unknown of the border is (-1: none), into w.record, and the border's plan. Returns
// false if the record does not fit the plan.
bool read_border(Records& r, uint64_t& end, EliminationPlan& border) {
  const uint64_t listed = read_backwards(r, end) / sizeof(int32_t), most = static_cast<uint64_t>(r.plan.border.pivots);
  const uint64_t least = most - static_cast<uint64_t>(root_size(r.plan));
  if (listed < least || listed > most) return false;
  border = border_with(r.plan, static_cast<int32_t>(listed - least));
  for (int32_t j = 0; j < border.pivots; ++j)
    if (border_id(r.w.record, j) < -1 || border_id(r.w.record, j) >= r.plan.columns) return false;
  return true;
}

// x_1 = h - M x_2: unknowns that a cluster eliminated, from those that it kept. h is the sum over the right-hand sides.
void substitute(const Records& r, const Record& cluster, Real* x) {
  for (int32_t i = 0; i < cluster.spare; ++i) {
    Real sum = 0;
    for (int32_t k = 0; k < right_sides(r.plan); ++k)
      sum += number(cluster.h, i + static_cast<int64_t>(k) * cluster.spare) * r.w.coefficient[2 * border_contact(r.plan) + k];
    x[cluster.id(i)] = sum;
  }
  for (int32_t j = 0; j < cluster.kept; ++j) {
    const Real factor = x[cluster.id(cluster.spare + j)];
    for (int32_t i = 0; i < cluster.spare; ++i)
      x[cluster.id(i)] -= number(cluster.m, i + static_cast<int64_t>(j) * cluster.spare) * factor;
  }
}

// The coefficients of the load cases and of the contact are in w.coefficient.
c2d_status solve(Records& r, Tapes& tapes, Real* x) {
  uint64_t end = r.end;
  if (r.stream.status != C2D_OK) return r.stream.status;
  EliminationPlan border;
  if (!read_border(r, end, border)) return fault_of(r);
  const c2d_status status = back_substitute(border, tapes, r.w.coefficient, r.w.y, r.w.dense);
  if (status != C2D_OK) return status;
  for (int32_t j = 0; j < border.pivots; ++j) {
    const int32_t id = border_id(r.w.record, j);
    if (id >= 0) x[id] = r.w.y[j];
  }
  // The samples for the check come first on the tape; everything behind them is a record.
  while (end > sample_bytes(r.plan)) {
    Record cluster;
    const uint64_t length = read_backwards(r, end);
    if (length == 0 || !open_record(r, length, cluster)) return fault_of(r);
    substitute(r, cluster, x);
  }
  return C2D_OK;
}

} // namespace

uint64_t compressed_back_bytes(const CompressedPlan& plan) { return lay_out_back(plan, nullptr, nullptr); }

c2d_status back_substitute_compressed(const CompressedPlan& plan, Tapes& tapes, const Real* coefficient, Real* x, void* work) {
  Records r = begin_reading(plan, tapes, work);
  const int32_t last = plan.border.trailing - 1;
  for (int32_t j = 0; j < last; ++j) r.w.coefficient[j] = coefficient[j];
  r.w.coefficient[last] = 0;
  return solve(r, tapes, x);
}

// The same solution for the right-hand side of random signs: A^-1 s of METHOD 7.6.
c2d_status substitute_noise(const CompressedPlan& plan, Tapes& tapes, Real* x, void* work) {
  Records r = begin_reading(plan, tapes, work);
  const int32_t last = plan.border.trailing - 1;
  for (int32_t j = 0; j < last; ++j) r.w.coefficient[j] = 0;
  r.w.coefficient[last] = 1;
  return solve(r, tapes, x);
}

int64_t sides_room(const CompressedPlan& plan) {
  const int64_t n = most_dofs(plan);
  return n * n / 4 + 1 + n * kMostSides;
}

namespace {

// substitute() for many right-hand sides at once: a matrix product, with h already in x.
void substitute_sides(const Engine& engine, const Record& cluster, int32_t count, Real* x, Real* room) {
  const int64_t sides = count;
  const size_t bytes = static_cast<size_t>(count) * sizeof(Real);
  Real *const kept = room, *const spare = kept + cluster.kept * sides, *const m = spare + cluster.spare * sides;
  for (int32_t i = 0; i < cluster.spare; ++i) memcpy(spare + i * sides, x + cluster.id(i) * sides, bytes);
  for (int32_t j = 0; j < cluster.kept; ++j) {
    memcpy(kept + j * sides, x + cluster.id(cluster.spare + j) * sides, bytes);
    for (int32_t i = 0; i < cluster.spare; ++i)
      m[j + static_cast<int64_t>(i) * cluster.kept] = number(cluster.m, i + static_cast<int64_t>(j) * cluster.spare);
  }
  gemm_minus(engine, count, cluster.spare, cluster.kept, kept, count, m, cluster.kept, spare, count);
  for (int32_t i = 0; i < cluster.spare; ++i) memcpy(x + cluster.id(i) * sides, spare + i * sides, bytes);
}

} // namespace

c2d_status carry_down(const CompressedPlan& plan, Tapes& tapes, const Engine& engine, int32_t count, Real* x, Real* room,
                      void* work) {
  Records r = begin_reading(plan, tapes, work);
  uint64_t end = r.end;
  if (r.stream.status != C2D_OK) return r.stream.status;
  EliminationPlan border;
  if (!read_border(r, end, border)) return fault_of(r);
  while (end > sample_bytes(plan)) {
    Record cluster;
    const uint64_t length = read_backwards(r, end);
    if (length == 0 || !open_record(r, length, cluster)) return fault_of(r);
    substitute_sides(engine, cluster, count, x, room);
  }
  return C2D_OK;
}

namespace {

// Reads the record at `at` into w.record. Its length behind it is skipped. Returns false if there is none.
bool read_forwards(Records& r, uint64_t& at, Record& out) {
  int32_t counts[2];
  if (read_at(r.stream, at, counts, sizeof counts) != C2D_OK) return false;
  const uint64_t length = length_of(r, counts[0], counts[1]);
  if (length > record_bytes(r.plan) || read_at(r.stream, at, r.w.record, length) != C2D_OK) return false;
  at += length + sizeof length;
  return open_record(r, length, out);
}

// Transpose of substitute(): the weights of eliminated unknowns move to the right-hand sides (h) and to the kept unknowns (M).
void carry_weights(const Records& r, const Record& cluster, Real* f, Real* w) {
  for (int32_t k = 0; k < r.plan.loads; ++k)
    for (int32_t i = 0; i < cluster.spare; ++i)
      w[2 * border_contact(r.plan) + k] += number(cluster.h, i + static_cast<int64_t>(k) * cluster.spare) * f[cluster.id(i)];
  for (int32_t j = 0; j < cluster.kept; ++j) {
    Real sum = 0;
    for (int32_t i = 0; i < cluster.spare; ++i)
      sum += number(cluster.m, i + static_cast<int64_t>(j) * cluster.spare) * f[cluster.id(i)];
    f[cluster.id(cluster.spare + j)] -= sum;
  }
}

} // namespace

c2d_status compressed_functional(const CompressedPlan& plan, Tapes& tapes, Real* f, Real* w, void* work) {
  if (w == nullptr) return C2D_OK;
  Records r = begin_reading(plan, tapes, work);
  const int32_t trailing = plan.border.trailing - 1;
  for (int32_t j = 0; j < trailing; ++j) w[j] = 0;
  uint64_t end = r.end, last = sample_bytes(plan);
  EliminationPlan border;
  if (!read_border(r, end, border)) return fault_of(r);
  const uint64_t clusters = end;
  while (last < clusters) {
    Record cluster;
    if (!read_forwards(r, last, cluster)) return fault_of(r);
    carry_weights(r, cluster, f, w);
  }
  end = r.end;
  if (!read_border(r, end, border)) return fault_of(r);
  for (int32_t j = 0; j < border.pivots; ++j) {
    const int32_t id = border_id(r.w.record, j);
    r.w.y[j] = id >= 0 ? f[id] : Real(0);
  }
  const c2d_status status = transposed_functional(border, tapes, r.w.y, r.w.coefficient, r.w.dense);
  for (int32_t j = 0; j < trailing && status == C2D_OK; ++j) w[j] += r.w.coefficient[j];
  return status;
}

} // namespace c2d
