// The pool of threads, and that no bit of a result depends on how many there are.
#include "c2d_threads.h"
#include "linalg/dense.hpp"
#include "linalg/lu.hpp"
#include "memory/workers.hpp"

#include <atomic>
#include <cerrno>
#include <cfenv>
#include <cstring>
#include <doctest/doctest.h>
#include <random>
#include <vector>

using namespace c2d;

namespace {

struct Pool {
  c2d_threads pool;
  c2d_port port = C2D_INIT(c2d_port);
  explicit Pool(int32_t threads) {
    REQUIRE(c2d_threads_start(&pool, threads) == 0);
    c2d_threads_port(&pool, &port);
  }
  ~Pool() { c2d_threads_stop(&pool); }
};

std::vector<Real> random_numbers(size_t n, uint32_t seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Real> out(n);
  for (Real& x : out) x = static_cast<Real>(uniform(generator));
  return out;
}

// Everything an elimination does to one matrix, with as many tasks at once as asked for.
std::vector<Real> all_work(const Kernel* kernel, const c2d_port& port, int32_t n) {
  const int64_t numbers = full_scratch(n, n) * 2;
  std::vector<Real> scratch(static_cast<size_t>(numbers) + 16);
  const size_t past = reinterpret_cast<uintptr_t>(scratch.data()) % 64 / sizeof(Real);
  const Engine engine = {kernel, scratch.data() + (past > 0 ? 64 / sizeof(Real) - past : 0), numbers, nullptr,
                         workers_of(&port)};
  const size_t size = static_cast<size_t>(n) * static_cast<size_t>(n);
  std::vector<Real> a = random_numbers(size, 1), x = random_numbers(size, 2), c = random_numbers(size, 3);
  std::vector<Real> norms(static_cast<size_t>(n));
  std::vector<int32_t> pivots(static_cast<size_t>(n));
  CHECK(lu_factor(engine, n, a.data(), n, pivots.data(), norms.data(), nullptr) == 0);
  lu_solve(engine, n, n, a.data(), n, pivots.data(), x.data(), n);
  gemm_minus(engine, n, n, n, a.data(), n, x.data(), n, c.data(), n);
  a.insert(a.end(), x.begin(), x.end());
  a.insert(a.end(), c.begin(), c.end());
  return a;
}

} // namespace

TEST_CASE("threads: each task runs once, before the call returns, whatever their number") {
  for (int32_t threads : {1, 2, 3, 7}) {
    Pool pool(threads);
    CHECK(pool.port.threads == threads);
    for (int32_t round = 0; round < 200; ++round) {
      const int32_t n = round % 23;
      std::vector<int> ran(24, 0);
      pool.port.parallel_for(
          pool.port.context, n, [](void* a, int32_t i) { ++static_cast<int*>(a)[i]; }, ran.data());
      for (int32_t i = 0; i < 24; ++i) REQUIRE(ran[static_cast<size_t>(i)] == (i < n ? 1 : 0));
    }
    std::atomic<int64_t> sum{0}; // more than one ticket can count
    const int32_t many = (1 << 20) + 5;
    pool.port.parallel_for(
        pool.port.context, many, [](void* a, int32_t i) { static_cast<std::atomic<int64_t>*>(a)->fetch_add(i); }, &sum);
    CHECK(sum == int64_t(many) * (many - 1) / 2);
  }
}

TEST_CASE("threads: tasks have the caller's rounding") {
  Pool pool(3);
  const int before = std::fegetround();
  std::fesetround(FE_UPWARD);
  std::vector<int> found(50, -1);
  pool.port.parallel_for(
      pool.port.context, 50, [](void* a, int32_t i) { static_cast<int*>(a)[i] = std::fegetround(); }, found.data());
  std::fesetround(before);
  for (int each : found) CHECK(each == FE_UPWARD);
}

TEST_CASE("threads: numbers out of range are refused, and a pool may be started again") {
  c2d_threads pool;
  CHECK(c2d_threads_start(&pool, 0) == EINVAL);
  CHECK(c2d_threads_start(&pool, C2D_THREADS_MOST + 1) == EINVAL);
  for (int32_t turn = 0; turn < 3; ++turn) {
    REQUIRE(c2d_threads_start(&pool, 2) == 0);
    c2d_threads_stop(&pool);
  }
}

TEST_CASE("threads: the functions of the port inside are called with their own context") {
  struct Inner {
    int32_t tape = -1;
    uint64_t block = 0;
  } inner;
  c2d_port port = C2D_INIT(c2d_port);
  port.context = &inner;
  port.read = [](void* c, int32_t tape, uint64_t block, void*, uint64_t bytes) {
    *static_cast<Inner*>(c) = {tape, block};
    return static_cast<int32_t>(bytes);
  };
  port.cancel = [](void* c) { return static_cast<Inner*>(c)->tape; };
  c2d_threads pool;
  REQUIRE(c2d_threads_start(&pool, 2) == 0);
  c2d_threads_port(&pool, &port);
  CHECK(port.context == &pool);
  CHECK(port.read(port.context, 3, 17, nullptr, 5) == 5);
  CHECK(inner.tape == 3);
  CHECK(inner.block == 17);
  CHECK(port.cancel(port.context) == 3);
  CHECK(!port.write);
  CHECK(!port.clock);
  c2d_threads_stop(&pool);
}

TEST_CASE("threads: factors, solutions and products are the same bits for any number of tasks") {
  const c2d_port alone = C2D_INIT(c2d_port);
  for (int32_t set = 0; set <= static_cast<int32_t>(best_instructions()); ++set) {
    const Kernel* kernel = kernel_for(static_cast<Instructions>(set));
    for (int32_t n : {65, 257, 387}) {
      const std::vector<Real> one = all_work(kernel, alone, n);
      for (int32_t threads : {2, 3, 7}) {
        Pool pool(threads);
        const std::vector<Real> several = all_work(kernel, pool.port, n);
        CHECK_MESSAGE(std::memcmp(one.data(), several.data(), one.size() * sizeof(Real)) == 0,
                      "set " << set << " n " << n << " threads " << threads);
      }
    }
  }
}
