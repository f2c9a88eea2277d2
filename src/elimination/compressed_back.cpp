// Solutions from what compressed elimination has written: the border first, then the cells from the root to the leaves.
#include <string.h>

#include "elimination/compressed_work.hpp"
#include "memory/sizes.hpp"

namespace c2d {

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
  Carver carver{0, true};
  const auto take = [&](uint64_t bytes) {
    carver.align();
    const uint64_t at = carver.carve(bytes, 1);
    return base ? base + at : nullptr;
  };
  BackWork w{};
  w.dense = take(back_substitution_bytes(plan.border));
  w.y = reinterpret_cast<Real*>(take(static_cast<uint64_t>(plan.border.pivots) * sizeof(Real)));
  w.coefficient = reinterpret_cast<Real*>(take(static_cast<uint64_t>(plan.border.trailing) * sizeof(Real)));
  w.record = take(record_bytes(plan));
  w.buffer = take(kBlockHeaderBytes + plan.block_bytes);
  carver.align();
  if (out) *out = w;
  return carver.fits ? carver.used : UINT64_MAX;
}

// A cell's record, as write_record wrote it; and the numbers of M and h, which stand unaligned.
struct Record {
  int32_t spare, kept;
  const char *ids, *m, *h;
  int32_t id(int32_t i) const {
    int32_t out;
    memcpy(&out, ids + static_cast<size_t>(i) * sizeof out, sizeof out);
    return out;
  }
};

Real number(const char* at, int64_t i) {
  Real out;
  memcpy(&out, at + static_cast<size_t>(i) * sizeof out, sizeof out);
  return out;
}

Record open_record(const char* at) {
  Record r;
  memcpy(&r.spare, at, sizeof r.spare);
  memcpy(&r.kept, at + sizeof r.spare, sizeof r.kept);
  r.ids = at + 2 * sizeof(int32_t);
  r.m = r.ids + static_cast<size_t>(r.spare + r.kept) * sizeof(int32_t);
  r.h = r.m + static_cast<size_t>(r.spare) * static_cast<size_t>(r.kept) * sizeof(Real);
  return r;
}

struct Records {
  const CompressedPlan& plan;
  Stream stream;
  BackWork w;
};

Records open_records(const CompressedPlan& plan, Tapes& tapes, void* work) {
  Records r{plan, {}, {}};
  lay_out_back(plan, static_cast<char*>(work), &r.w);
  const uint64_t dense = upper_use(plan.border).blocks;
  r.stream = open_stream(tapes, C2D_TAPE_UPPER, plan.border.upper_first_block + dense,
                         compressed_upper_use(plan).blocks - dense, plan.block_bytes, r.w.buffer);
  return r;
}

// The record that ends at `end` comes into w.record; `end` goes to where it begins.
c2d_status read_backwards(Records& r, uint64_t& end) {
  uint64_t length;
  const c2d_status status = read_at(r.stream, end - sizeof length, &length, sizeof length);
  if (status != C2D_OK) return status;
  if (length > record_bytes(r.plan) || length + sizeof length > end) return C2D_ERR_INTERNAL;
  end -= length + sizeof length;
  return read_at(r.stream, end, r.w.record, length);
}

// x of what a cell has eliminated from x of what it kept.
void substitute(const Records& r, const Record& cell, Real* x) {
  for (int32_t i = 0; i < cell.spare; ++i) {
    Real sum = 0;
    for (int32_t k = 0; k < right_sides(r.plan); ++k)
      sum += number(cell.h, i + static_cast<int64_t>(k) * cell.spare) * r.w.coefficient[2 * r.plan.contact + k];
    x[cell.id(i)] = sum;
  }
  for (int32_t j = 0; j < cell.kept; ++j) {
    const Real factor = x[cell.id(cell.spare + j)];
    for (int32_t i = 0; i < cell.spare; ++i) x[cell.id(i)] -= number(cell.m, i + static_cast<int64_t>(j) * cell.spare) * factor;
  }
}

// Its coefficients stand in w.coefficient.
c2d_status solve(Records& r, Tapes& tapes, Real* x) {
  uint64_t end = r.plan.records;
  c2d_status status = back_substitute(r.plan.border, tapes, r.w.coefficient, r.w.y, r.w.dense);
  if (status == C2D_OK) status = read_backwards(r, end);
  if (status != C2D_OK) return status;
  for (int32_t j = 0; j < r.plan.border.pivots; ++j) {
    int32_t id;
    memcpy(&id, r.w.record + static_cast<size_t>(j) * sizeof id, sizeof id);
    if (id >= 0) x[id] = r.w.y[j];
  }
  while (end > 0) {
    status = read_backwards(r, end);
    if (status != C2D_OK) return status;
    substitute(r, open_record(r.w.record), x);
  }
  return C2D_OK;
}

} // namespace

uint64_t compressed_back_bytes(const CompressedPlan& plan) { return lay_out_back(plan, nullptr, nullptr); }

c2d_status back_substitute_compressed(const CompressedPlan& plan, Tapes& tapes, const Real* coefficient, Real* x, void* work) {
  Records r = open_records(plan, tapes, work);
  const int32_t last = plan.border.trailing - 1;
  for (int32_t j = 0; j < last; ++j) r.w.coefficient[j] = coefficient[j];
  r.w.coefficient[last] = 0;
  return solve(r, tapes, x);
}

c2d_status substitute_noise(const CompressedPlan& plan, Tapes& tapes, Real* x, void* work) {
  Records r = open_records(plan, tapes, work);
  const int32_t last = plan.border.trailing - 1;
  for (int32_t j = 0; j < last; ++j) r.w.coefficient[j] = 0;
  r.w.coefficient[last] = 1;
  return solve(r, tapes, x);
}

namespace {

// The next record from `at` on: w.record holds it from its length on, which stands behind it.
c2d_status read_forwards(Records& r, uint64_t& at) {
  int32_t counts[2];
  c2d_status status = read_at(r.stream, at, counts, sizeof counts);
  if (status != C2D_OK) return status;
  const uint64_t spare = static_cast<uint64_t>(counts[0]), kept = static_cast<uint64_t>(counts[1]);
  const uint64_t length = sizeof counts + (spare + kept) * sizeof(int32_t) +
                          spare * (kept + static_cast<uint64_t>(right_sides(r.plan))) * sizeof(Real);
  if (length > record_bytes(r.plan)) return C2D_ERR_INTERNAL;
  status = read_at(r.stream, at, r.w.record, length);
  at += length + sizeof length;
  return status;
}

void carry_weights(const Records& r, const Record& cell, Real* f, Real* w) {
  for (int32_t k = 0; k < r.plan.loads; ++k)
    for (int32_t i = 0; i < cell.spare; ++i)
      w[2 * r.plan.contact + k] += number(cell.h, i + static_cast<int64_t>(k) * cell.spare) * f[cell.id(i)];
  for (int32_t j = 0; j < cell.kept; ++j) {
    Real sum = 0;
    for (int32_t i = 0; i < cell.spare; ++i) sum += number(cell.m, i + static_cast<int64_t>(j) * cell.spare) * f[cell.id(i)];
    f[cell.id(cell.spare + j)] -= sum;
  }
}

} // namespace

c2d_status compressed_functional(const CompressedPlan& plan, Tapes& tapes, Real* f, Real* w, void* work) {
  if (w == nullptr) return C2D_OK;
  Records r = open_records(plan, tapes, work);
  const int32_t trailing = plan.border.trailing - 1;
  for (int32_t j = 0; j < trailing; ++j) w[j] = 0;
  uint64_t end = plan.records, last = 0;
  c2d_status status = read_backwards(r, end);
  const uint64_t border = end;
  while (last < border && status == C2D_OK) {
    status = read_forwards(r, last);
    if (status == C2D_OK) carry_weights(r, open_record(r.w.record), f, w);
  }
  end = plan.records;
  if (status == C2D_OK) status = read_backwards(r, end);
  if (status != C2D_OK) return status;
  for (int32_t j = 0; j < plan.border.pivots; ++j) {
    int32_t id;
    memcpy(&id, r.w.record + static_cast<size_t>(j) * sizeof id, sizeof id);
    r.w.y[j] = id >= 0 ? f[id] : Real(0);
  }
  status = transposed_functional(plan.border, tapes, r.w.y, r.w.coefficient, r.w.dense);
  for (int32_t j = 0; j < trailing && status == C2D_OK; ++j) w[j] += r.w.coefficient[j];
  return status;
}

} // namespace c2d
