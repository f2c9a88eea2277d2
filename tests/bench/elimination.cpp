// Speed of the streamed elimination, all in memory and with an eighth of it, against the loops of 1987.
#include "elimination/eliminate.hpp"

#include "bench.hpp"
#include "c2d_memory.h"

#include <algorithm>
#include <cstring>

namespace bench {

namespace {

using c2d::Real;

struct Matrix {
  int32_t n;
  std::vector<Real> a;
  explicit Matrix(int32_t size) : n(size), a(static_cast<size_t>(size) * static_cast<size_t>(size)) {
    uint32_t seed = 1;
    for (Real& v : a) v = static_cast<Real>((seed = seed * 1664525u + 1013904223u) >> 8) / 8388608 - 1;
    for (int32_t i = 0; i < n; ++i)
      a[static_cast<size_t>(i) * static_cast<size_t>(n + 1)] += static_cast<Real>(n);
  }
  static c2d_status fill(void* context, int32_t first, int32_t count, Real* panel, int64_t ld) {
    const Matrix* m = static_cast<const Matrix*>(context);
    const size_t rows = static_cast<size_t>(m->n);
    for (int32_t j = 0; j < count; ++j)
      std::memcpy(panel + j * ld, m->a.data() + static_cast<size_t>(first + j) * rows, rows * sizeof(Real));
    return C2D_OK;
  }
};

// The store and work area for one plan.
struct Streamed {
  c2d::EliminationPlan plan;
  std::vector<unsigned char> region, work;
  c2d_memory_store store;
  c2d_port port;
  c2d::Tapes tapes;
  std::vector<Real> scratch;
  c2d::Engine engine;

  Streamed(int32_t n, uint64_t bytes) : plan(), store(), port(), tapes(), engine() {
    if (c2d::plan_elimination(bytes, n, n, 0, 0, plan, nullptr) != C2D_OK)
      give_up("no plan for the elimination");
    work.resize(c2d::elimination_bytes(plan) + 64);
    const c2d::TapeUse lower = c2d::lower_use(plan), upper = c2d::upper_use(plan);
    const uint64_t block = std::max(lower.max_data_bytes, upper.max_data_bytes);
    region.resize((lower.blocks + upper.blocks + 2) * (block + c2d::kBlockHeaderBytes + 64) + (1 << 16));
    c2d_memory_store_init(&store, region.data(), region.size());
    port = C2D_INIT(c2d_port);
    c2d_memory_store_port(&store, &port);
    tapes.port = &port;
    tapes.run_id = 1;
    if (c2d::open_tape(tapes, C2D_TAPE_LOWER, lower.blocks, lower.max_data_bytes) != C2D_OK ||
        c2d::open_tape(tapes, C2D_TAPE_UPPER, upper.blocks, upper.max_data_bytes) != C2D_OK)
      give_up("no tapes for the elimination");
    scratch.resize(static_cast<size_t>(c2d::full_scratch(n, n)) + 8);
    engine = {c2d::kernel_for(c2d::best_instructions()), scratch.data(), c2d::full_scratch(n, n), nullptr};
  }
  Streamed(const Streamed&) = delete;
  Streamed& operator=(const Streamed&) = delete;
  void run(const Matrix& m) {
    unsigned char* start = work.data() + (64 - reinterpret_cast<uintptr_t>(work.data()) % 64) % 64;
    const c2d::ColumnSource source = {const_cast<Matrix*>(&m), Matrix::fill};
    if (c2d::eliminate(plan, source, {nullptr, nullptr}, tapes, start, nullptr, {nullptr, nullptr}, engine) !=
        C2D_OK)
      give_up("elimination failed");
  }
};

// Row k from the rows below it, one after another, as DECOMP did, but for the rows' being contiguous here.
void row_loops(int32_t n, int32_t pivots, Real* a) {
  const size_t ld = static_cast<size_t>(n);
  for (size_t i = 0; i < static_cast<size_t>(pivots); ++i) {
    for (size_t j = i + 1; j < ld; ++j) {
      const Real factor = -a[j * ld + i] / a[i * ld + i];
      for (size_t k = i + 1; k < ld; ++k) a[j * ld + k] += factor * a[i * ld + k];
    }
  }
}

// Operations of eliminating the first p of n columns, no right-hand side.
double operations(double n, double p) {
  return 2 * (p * n * n - p * p * n + p * p * p / 3);
}

} // namespace

void elimination() {
  heading("Elimination: GFLOP/s of n x n, partial pivoting, store in memory");
  for (const int32_t n : {100, 200, 500, 1000, 2000}) {
    const Matrix matrix(n);
    const std::string name = "elimination." + std::to_string(n) + ".";
    const uint64_t all = c2d::elimination_bytes_in_core(n, n, 0);
    Streamed in_core(n, all), eighth(n, all / 8);
    const double work = operations(n, n);
    std::vector<Real> copy;
    const int32_t pivots = n > 500 ? 500 * 500 / n : n; // a part will do where it lasts
    // Taken in turns, so that a slow spell of the machine strikes all three.
    std::vector<double> t[3];
    for (int turn = 0; turn < 3; ++turn) {
      const double enough = 0.1;
      t[0].push_back(time_of(1, enough, [&] { in_core.run(matrix); }));
      t[1].push_back(time_of(1, enough, [&] { eighth.run(matrix); }));
      double last = 0;
      std::vector<double> loops;
      for (double spent = 0; loops.empty() || spent < enough; spent += last) {
        copy = matrix.a;
        const double start = processor_seconds();
        row_loops(n, pivots, copy.data());
        loops.push_back(last = processor_seconds() - start);
      }
      t[2].push_back(median(loops));
    }
    const double fast = work / median(t[0]) * 1e-9, small = work / median(t[1]) * 1e-9;
    const double old = operations(n, pivots) / median(t[2]) * 1e-9;
    row(name + "in_core", fast, "GFLOP/s", times(fast / old) + " of the row loops");
    row(name + "eighth", small, "GFLOP/s",
        times(small / old) + ", panels of " + std::to_string(eighth.plan.panel_columns) + " columns");
    row(name + "row_loops", old, "GFLOP/s");
  }
}

} // namespace bench
