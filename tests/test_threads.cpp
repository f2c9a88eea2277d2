// The pool of threads, and that no bit of a result depends on how many there are.
#include "c2d_threads.h"
#include "effort.hpp"
#include "linalg/dense.hpp"
#include "linalg/lu.hpp"
#include "memory/workers.hpp"
#include "solver_runs.hpp"

#include <atomic>
#include <cerrno>
#include <cfenv>
#include <chrono>
#include <cstring>
#include <doctest/doctest.h>
#include <random>
#include <thread>
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
    for (int32_t n : {65, 387, 257}) {
      if (n == 257 && !test::in_full()) continue;
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

namespace {

// Calls of every kind on one solver, one after another; what each returns is seen.
class Worker {
public:
  Worker(const test::Callable<bool()>& pending, const test::Callable<void(c2d_status, bool can_be_cancelled)>& seen)
      : deck_(runs::deck_named("hertz_lin_l")), limits_(deck_.limits()), pending_(pending), seen_(seen),
        memory_(enough(limits_)) {
    c2d_port port = C2D_INIT(c2d_port);
    store_.serve(port);
    REQUIRE(c2d_create(&solver, memory_.data(), memory_.size(), &limits_, &port, nullptr) == C2D_OK);
    REQUIRE(runs::read_deck(solver, deck_) == C2D_OK);
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  void make_a_round() {
    const double mu = 0.4, point[] = {0.3, 0.3};
    double out[C2D_POINT_FIELDS], step;
    c2d_outcome outcome;
    until_done([&] { return c2d_prepare(solver); });
    look(c2d_begin(solver, &mu, 1), false);
    for (const double load : {0.5, 1.0}) {
      until_done([&] { return c2d_advance(solver, &load, 1, &outcome); });
      look(c2d_next_event(solver, &load, 1, &step), false);
      look(c2d_get(solver, C2D_TN, 1, 1, 1, out, 1), false);
    }
    until_done([&] { return c2d_interior(solver, 1, 1, point, 2, out, C2D_POINT_FIELDS); });
    until_done([&] { return c2d_indicators(solver, 1, 1, 1, out, C2D_OFF_FIELDS); });
    until_done([&] { return c2d_run(solver, nullptr, nullptr); });
    look(c2d_save(solver), false);
    look(c2d_restore(solver), false);
    look(c2d_change_loads(solver), false);
  }
  c2d_solver* solver = nullptr;

private:
  static size_t enough(const c2d_limits& limits) {
    uint64_t most = 0;
    REQUIRE(c2d_memory_need(&limits, nullptr, &most, nullptr) == C2D_OK);
    return static_cast<size_t>(most);
  }
  void look(c2d_status status, bool can_be_cancelled) { seen_(status, can_be_cancelled); }
  template <class Call> void until_done(Call call) {
    c2d_status status = C2D_ERR_CANCELLED;
    while (status == C2D_ERR_CANCELLED) {
      const bool must_tell = pending_();
      status = call();
      look(must_tell && status == C2D_OK ? c2d_status{C2D_ERR_INTERNAL} : status, true);
    }
  }
  runs::Deck deck_;
  host::Limits limits_;
  test::Callable<bool()> pending_; // a cancel has come that no call told yet
  test::Callable<void(c2d_status, bool)> seen_;
  runs::RamStore store_;
  runs::Bytes memory_;
};

} // namespace

TEST_CASE("threads: a cancel at any moment is told by one call, at once or by the next that can be cancelled") {
  const int kCancels = test::effort(300, 3000);
  std::atomic<int> told{0}, asked{0};
  std::atomic<bool> over{false};
  int late = 0, wrong = 0, rounds = 0;
  const auto pending = [&] { return asked.load() > told.load(); };
  Worker worker(pending, [&](c2d_status status, bool can_be_cancelled) {
    if (status == C2D_ERR_CANCELLED && can_be_cancelled)
      told.fetch_add(1);
    else if (status != C2D_OK)
      ++wrong;
    else if (pending())
      ++late; // the next call that can be cancelled must tell
  });
  std::thread other([&] {
    std::mt19937 generator(14);
    for (int i = 1; i <= kCancels && !over; ++i) {
      std::this_thread::sleep_for(std::chrono::microseconds(generator() % 700));
      c2d_cancel(worker.solver);
      asked.store(i);
      while (told.load() < i && !over) std::this_thread::yield();
    }
  });
  for (; told.load() < kCancels && wrong == 0; ++rounds) worker.make_a_round();
  over = true; // one that was lost would be waited for without end
  other.join();
  worker.make_a_round();
  CHECK(told.load() == kCancels); // not one more
  CHECK(wrong == 0);
  MESSAGE("cancels: " << kCancels << " in " << rounds << " rounds of calls, " << late << " calls ended with one to be told");
}
