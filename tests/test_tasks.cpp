// Assembly, elimination and interior points by several tasks at once: every number is that of one task, bit by bit.
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <random>
#include <thread>

using namespace runs;

namespace {

// parallel_for of a store that also counts how often it was asked for tasks.
struct Tasks {
  RamStore store;
  int32_t threads = 1;
  int64_t calls = 0;

  static int32_t open(void* c, int32_t t, uint64_t n, uint64_t bytes) { return RamStore::open(&self(c).store, t, n, bytes); }
  static int32_t read(void* c, int32_t t, uint64_t k, void* d, uint64_t n) {
    return RamStore::read(&self(c).store, t, k, d, n);
  }
  static int32_t write(void* c, int32_t t, uint64_t k, const void* d, uint64_t n) {
    return RamStore::write(&self(c).store, t, k, d, n);
  }
  static int32_t sync(void* c, int32_t t) { return RamStore::sync(&self(c).store, t); }
  static int32_t close(void* c, int32_t t) { return RamStore::close(&self(c).store, t); }
  static void parallel_for(void* c, int32_t n, void (*task)(void*, int32_t), void* argument) {
    Tasks& tasks = self(c);
    ++tasks.calls;
    std::vector<std::thread> running;
    for (int32_t t = 0; t < tasks.threads; ++t)
      running.emplace_back([=, &tasks] {
        for (int32_t i = n - 1 - t; i >= 0; i -= tasks.threads) task(argument, i); // in an order of their own
      });
    for (std::thread& thread : running) thread.join();
  }
  static Tasks& self(void* context) { return *static_cast<Tasks*>(context); }

  c2d_port port() {
    c2d_port out = C2D_INIT(c2d_port);
    out.context = this;
    out.open = open, out.read = read, out.write = write, out.sync = sync, out.close = close;
    out.parallel_for = parallel_for;
    out.threads = threads;
    return out;
  }
};

struct All {
  Numbers numbers;
  std::vector<double> inside;
};

All solve(const Deck& deck, int32_t threads, const std::vector<double>& xy, int64_t* calls) {
  Tasks tasks;
  tasks.threads = threads;
  const c2d_port port = tasks.port();
  const host::Limits limits = deck.limits();
  uint64_t minimum = 0, in_core = 0;
  REQUIRE(c2d_memory_need(&limits, &minimum, &in_core, nullptr) == C2D_OK);
  Machine machine(limits, in_core + (uint64_t(16) << 20), &port);
  REQUIRE(machine.created == C2D_OK);
  All out;
  REQUIRE(run_all(machine.solver, deck, out.numbers) == C2D_OK);
  const int32_t count = static_cast<int32_t>(xy.size() / 2);
  out.inside.resize(static_cast<size_t>(count) * C2D_POINT_FIELDS);
  const int64_t before = tasks.calls;
  REQUIRE(c2d_interior(machine.solver, 0, count, xy.data(), 2, out.inside.data(), C2D_POINT_FIELDS) == C2D_OK);
  *calls = tasks.calls - before;
  CHECK(machine.guards_are_whole());
  return out;
}

} // namespace

// A ring whose inner nodes do not stand in the middle of their elements: how such an element is cut for its integrals is
// found for each source.
static Deck uneven_ring() {
  Deck deck = deck_named("ring3");
  const auto card_of = [](int node) { return static_cast<size_t>(node + 8); };
  const auto number = [&](int node, size_t from) { return std::stod(deck.lines[card_of(node)].substr(from, 10)); };
  for (int node = 2; node < 56; node += 2)
    for (const size_t from : {size_t{6}, size_t{16}}) { // columns of x and y
      char text[16];
      std::snprintf(text, sizeof text, "%10.8f", number(node, from) + 0.2 * (number(node + 1, from) - number(node - 1, from)));
      deck.lines[card_of(node)].replace(from, 10, text, 10);
    }
  return deck;
}

TEST_CASE("tasks: no bit of a solution or of interior points depends on their number") {
  for (const std::string name : {"sample56", "hertz_lin_l", "ring3", "uneven ring", "../judge/two_holes"}) {
    CAPTURE(name);
    const Deck deck = name == "uneven ring" ? uneven_ring() : deck_named(name);
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> within(-3, 3);
    std::vector<double> xy(2 * 3 * 1024 + 2 * 77); // three blocks and a bit
    for (double& x : xy) x = within(random);
    int64_t calls;
    const All one = solve(deck, 1, xy, &calls);
    CHECK(calls == 0);
    int inside = 0;
    for (size_t i = C2D_POINT_FLAG; i < one.inside.size(); i += C2D_POINT_FIELDS)
      inside += std::fabs(one.inside[i] - double(C2D_POINT_OUTSIDE)) > 0.5;
    CHECK(inside > 0);
    for (int32_t threads : {2, 3, 5, 7}) {
      CAPTURE(threads);
      const All many = solve(deck, threads, xy, &calls);
      CHECK(calls > 0);
      CHECK(many.numbers == one.numbers);
      CHECK(Numbers::same(many.inside, one.inside));
    }
  }
}
