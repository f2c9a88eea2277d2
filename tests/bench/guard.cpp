// Work whose instructions guard.sh has counted by an emulated processor: fixed, repeatable, without a clock.
// The sets are named, because the emulated processor has no AVX-512 and would choose by itself.
#include "bench.hpp"
#include "ours.hpp"
#include "rivals/serve.hpp"

#include <cstdio>
#include <memory>

namespace bench {
namespace {

test::Callable<void()> elimination_job(c2d::Instructions set, int32_t n) {
  if (!c2d::kernel_for(set)) return {};
  struct Data {
    rival::Matrix m;
    OwnEngine engine;
    std::vector<int32_t> pivots;
    std::vector<double> norms;
  };
  const std::shared_ptr<Data> d(new Data{rival::make_matrix("random:1", n),
                                         {set, n, 1},
                                         std::vector<int32_t>(static_cast<size_t>(n)),
                                         std::vector<double>(static_cast<size_t>(n))});
  return [d, n] {
    c2d::lu_factor(d->engine.engine(), n, d->m.a.data(), n, d->pivots.data(), d->norms.data(), nullptr);
    c2d::lu_solve(d->engine.engine(), n, 1, d->m.a.data(), n, d->pivots.data(), d->m.b.data(), n);
  };
}

using c2d::Instructions;
// A solver takes the best set; which that is is up to the processor that valgrind runs on.
bool chosen(Instructions set) { return c2d::best_instructions() == set; }
const struct Job {
  const char* name;
  test::Callable<void()> (*make)();
} jobs[] = {
    {"lu.100.baseline", [] { return elimination_job(Instructions::baseline, 100); }},
    {"lu.320.baseline", [] { return elimination_job(Instructions::baseline, 320); }},
    {"lu.100.avx2", [] { return elimination_job(Instructions::avx2, 100); }},
    {"lu.320.avx2", [] { return elimination_job(Instructions::avx2, 320); }},
    {"assembly.200.baseline", [] { return assembly_job(Instructions::baseline, 200); }},
    {"assembly.200.avx2", [] { return assembly_job(Instructions::avx2, 200); }},
    {"interior.100.avx2", [] { return chosen(Instructions::avx2) ? interior_job(100, 20) : nullptr; }},
    {"contact.50.avx2", [] { return chosen(Instructions::avx2) ? contact_job(50, 4) : nullptr; }},
};

} // namespace

// What is counted begins and ends with this function.
extern "C" __attribute__((noinline)) void guarded_work(const test::Callable<void()>& work) {
  work();
  asm volatile("" ::: "memory"); // no jump instead of a call
}

int guard(const std::string& name) {
  for (const Job& job : jobs) {
    if (name == "list") std::printf("%s\n", job.name);
    if (name != job.name) continue;
    const test::Callable<void()> work = job.make();
    if (!work) return 2;
    guarded_work(work);
    return 0;
  }
  return name == "list" ? 0 : 1;
}

} // namespace bench
