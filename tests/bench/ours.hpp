// The library's own elimination as a contender, and what its loops are measured against.
#pragma once

#include "linalg/lu.hpp"

#include <cstdlib>
#include <string>

namespace bench {

double peak_avx512(int64_t rounds, double*keep), peak_avx2(int64_t rounds, double*keep),
    peak_baseline(int64_t rounds, double*keep);

// plain, baseline, avx2, avx512; the names in the table.
const char* name_of(c2d::Instructions set);
bool has(c2d::Instructions set); // this build and this machine

// GFLOP/s that this machine reaches with registers alone.
double peak_of(c2d::Instructions set);

// A kernel with scratch and, for more than one thread, workers.
class OwnEngine {
public:
  OwnEngine(c2d::Instructions set, int32_t n, int32_t threads);
  ~OwnEngine();
  OwnEngine(const OwnEngine&) = delete;
  OwnEngine& operator=(const OwnEngine&) = delete;
  const c2d::Engine& engine() const { return engine_; }

private:
  struct Pool;
  c2d::Engine engine_ = c2d::kPlainEngine;
  void* scratch_ = nullptr;
  Pool* pool_ = nullptr;
};

// run_bench --serve SET THREADS: answers like the rivals do.
int serve_own(const std::string& set, int threads);

} // namespace bench
