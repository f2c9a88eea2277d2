#include "ours.hpp"

#include "c2d_threads.h"
#include "rivals/serve.hpp"

#include <memory>

namespace bench {

const char* name_of(c2d::Instructions set) {
  const char* names[] = {"plain", "baseline", "avx2", "avx512"};
  return names[static_cast<int>(set)];
}

bool has(c2d::Instructions set) { return c2d::kernel_for(set) != nullptr && set <= c2d::best_instructions(); }

double peak_of(c2d::Instructions set) {
  const auto loop = set == c2d::Instructions::avx512 ? peak_avx512 : set == c2d::Instructions::avx2 ? peak_avx2 : peak_baseline;
  double best = 0, keep = 0;
  for (int turn = 0; turn < 5; ++turn) {
    const double start = rival::processor_seconds(), work = loop(100000, &keep);
    best = std::max(best, work / (rival::processor_seconds() - start) * 1e-9);
  }
  return best;
}

struct OwnEngine::Pool {
  c2d_threads threads;
  c2d_port port = C2D_INIT(c2d_port);
};

OwnEngine::OwnEngine(c2d::Instructions set, int32_t n, int32_t threads) {
  // Every worker packs for itself.
  const size_t numbers = (static_cast<size_t>(c2d::full_scratch(n, n)) * static_cast<size_t>(threads) + 63) / 8 * 8;
  scratch_ = std::aligned_alloc(64, numbers * sizeof(c2d::Real));
  engine_.kernel = c2d::kernel_for(set);
  engine_.scratch = static_cast<c2d::Real*>(scratch_);
  engine_.numbers = static_cast<int64_t>(numbers);
  if (threads == 1) return;
  pool_ = new Pool;
  if (c2d_threads_start(&pool_->threads, threads) != 0) std::exit(2);
  c2d_threads_port(&pool_->threads, &pool_->port);
  engine_.workers = c2d::workers_of(&pool_->port);
}

OwnEngine::~OwnEngine() {
  if (pool_) c2d_threads_stop(&pool_->threads);
  delete pool_;
  std::free(scratch_);
}

int serve_own(const std::string& name, int threads) {
  c2d::Instructions set = c2d::Instructions::plain;
  while (name != name_of(set) && set != c2d::Instructions::avx512)
    set = static_cast<c2d::Instructions>(static_cast<int>(set) + 1);
  if (!has(set)) return 2;
  std::unique_ptr<OwnEngine> engine;
  std::vector<int32_t> pivots;
  std::vector<double> norms;
  return rival::serve(
      [&](int n, double* a, double* x) {
        if (static_cast<int>(pivots.size()) != n) { // memory is the caller's; rivals keep theirs, too
          engine = std::make_unique<OwnEngine>(set, n, threads);
          pivots.resize(static_cast<size_t>(n));
          norms.resize(static_cast<size_t>(n));
        }
        c2d::lu_factor(engine->engine(), n, a, n, pivots.data(), norms.data(), nullptr);
        c2d::lu_solve(engine->engine(), n, 1, a, n, pivots.data(), x, n);
      },
      [&] { return threads == 1 ? peak_of(set) : 0.0; });
}

} // namespace bench
