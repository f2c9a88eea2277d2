// Assembly, elimination and interior points by several tasks at once: every number is that of one task, bit by bit.
#include "callable.hpp"
#include "effort.hpp"
#include "many_bodies.hpp"
#include "solver/solver.hpp"
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <memory>
#include <random>
#include <thread>

using namespace runs;

namespace {

// parallel_for of a store that also counts how often it was asked for tasks.
struct Tasks {
  RamStore store;
  int32_t threads = 1;
  int64_t calls = 0;
  test::Callable<void()> before_tasks;

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
    if (tasks.before_tasks) tasks.before_tasks();
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
    out.progress = [](void* c, const c2d_progress* now) {
      if (now->phase == C2D_PHASE_ASSEMBLE) self(c).at_once.insert({now->body, now->done == now->total});
    };
    out.cancel = [](void* c) { return self(c).questions++ == self(c).cancel_at ? int32_t{1} : int32_t{0}; };
    return out;
  }
  int64_t questions = 0, cancel_at = -1;
  std::map<int32_t, bool> at_once; // per body: the first that was told of it was that it is assembled
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

// ---- small bodies, each by one task ------------------------------------------------------------------------------------

namespace {

// Blocks in a row, each pressed down and held below, sides touching: of several sizes, one rigid, one so large that it is not
// one of several.
many::Model row_of_blocks(int32_t count) {
  many::Model m;
  const int32_t rigid = 4, large = 8;
  for (int32_t i = 1; i <= count; ++i) {
    const int32_t along = i == large ? 150 : 3 + i % 4;
    m.add(many::rectangle(i, 0, i + 1, 1, {along, 6, along, 6}, 1000 + 50 * i));
    m.body(i).rigid = i == rigid;
    if (i == rigid) continue;
    m.set(i, 1, many::end_of(many::kHeld));
    m.set(i, 3, many::end_of(many::kPulled, 0.3, -5 - i));
  }
  for (int32_t i = 1; i < count; ++i) {
    const many::Range right = m.side(i, 2), left = m.side(i + 1, 4);
    m.zones.push_back({C2D_ZONE_MATCHING, {{i, right.first + 1, right.last - 1}, {i + 1, left.last - 1, left.first + 1}}});
  }
  m.friction = 0.3;
  m.paths = {{2, 1.0}};
  return m;
}

// The row, in so much of the memory from the least to the most, with so many tasks at once.
struct Row {
  Tasks tasks;
  std::vector<c2d_body_limits> list;
  c2d_limits limits;
  many::Model model;
  std::unique_ptr<Machine> machine;
  Numbers numbers;

  Row(int32_t threads, double share, int32_t keep_factors = 0, int32_t count = 11) : model(row_of_blocks(count)) {
    limits = many::limits_of(model, list);
    tasks.threads = threads;
    uint64_t least = 0, most = 0;
    REQUIRE(c2d_memory_need(&limits, &least, &most, nullptr) == C2D_OK);
    const c2d_port port = tasks.port();
    machine = std::make_unique<Machine>(limits, least + static_cast<uint64_t>(share * double(most + (4 << 20) - least)), &port);
    REQUIRE(machine->created == C2D_OK);
    c2d_options options = C2D_INIT(c2d_options);
    options.keep_factors = keep_factors;
    REQUIRE(c2d_set_options(machine->solver, &options) == C2D_OK);
    REQUIRE(many::feed(machine->solver, model) == C2D_OK);
  }
  c2d_status prepare() { return c2d_prepare(machine->solver); }
  void run() {
    REQUIRE(run_prepared(machine->solver, numbers) == C2D_OK);
    CHECK(machine->guards_are_whole());
  }
  int64_t side_by_side() const {
    return std::count_if(tasks.at_once.begin(), tasks.at_once.end(), [](const auto& body) { return body.second; });
  }
  // Of the preparation: what was done to the store, in this order, and what the blocks hold.
  bool same_store(const Row& other) const {
    const auto &a = tasks.store.done, &b = other.tasks.store.done;
    bool same = a.size() == b.size();
    for (size_t i = 0; same && i < a.size(); ++i)
      same = a[i].kind == b[i].kind && a[i].tape == b[i].tape && a[i].block == b[i].block && a[i].bytes == b[i].bytes;
    for (int32_t t = 0; t < C2D_TAPES; ++t) same = same && tasks.store.tape[t] == other.tasks.store.tape[t];
    return same;
  }
};

} // namespace

TEST_CASE("tasks: small bodies side by side leave the bits and the blocks that they leave one after the other") {
  for (const int32_t keep_factors : {0, 1})
    for (const double share : {0.0, 0.1, 0.3, 0.6, 1.0}) {
      CAPTURE(share);
      Row one(1, share, keep_factors);
      REQUIRE(one.prepare() == C2D_OK);
      CHECK(one.side_by_side() == 0);
      for (const int32_t threads : {2, 3, 7}) {
        if (threads != 3 && !test::in_full()) continue;
        CAPTURE(threads);
        Row several(threads, share, keep_factors);
        REQUIRE(several.prepare() == C2D_OK);
        if (share == 0) CHECK(several.side_by_side() == 0);
        if (share == 1) CHECK(several.side_by_side() == 9); // neither the rigid one nor the large one
        CHECK(several.same_store(one));
        Row again(1, share, keep_factors);
        REQUIRE(again.prepare() == C2D_OK);
        again.run(), several.run();
        CHECK(several.numbers == again.numbers);
      }
    }
}

TEST_CASE("tasks: small bodies side by side, cancelled at every chance, are prepared again to the same bits") {
  Row whole(3, 1.0);
  REQUIRE(whole.prepare() == C2D_OK);
  whole.run();
  int cancelled = 0;
  for (int64_t at = 0;; at += 101) {
    Row row(3, 1.0);
    row.tasks.questions = 0, row.tasks.cancel_at = at;
    const c2d_status status = row.prepare();
    if (status == C2D_OK) break;
    REQUIRE(status == C2D_ERR_CANCELLED);
    ++cancelled;
    REQUIRE(row.prepare() == C2D_OK);
    row.run();
    REQUIRE(row.numbers == whole.numbers);
  }
  CHECK(cancelled > 10);
}

TEST_CASE("tasks: a store that fails while small bodies are written") {
  Row whole(2, 1.0);
  REQUIRE(whole.prepare() == C2D_OK);
  const size_t operations = whole.tasks.store.done.size();
  REQUIRE(operations > 400);
  for (size_t n = 0; n < operations; n += 29) {
    CAPTURE(n);
    Row row(2, 1.0);
    char kind = ' ';
    row.tasks.store.before = [&](const RamStore::Operation& operation, size_t i) {
      if (i != n) return 0;
      kind = operation.kind;
      return 78;
    };
    const c2d_status status = row.prepare();
    c2d_error why = C2D_INIT(c2d_error);
    c2d_last_error(row.machine->solver, &why);
    CHECK(status == (kind == 'o'   ? C2D_ERR_STORE_OPEN
                     : kind == 'r' ? C2D_ERR_STORE_READ
                     : kind == 'w' ? C2D_ERR_STORE_WRITE
                     : kind == 's' ? C2D_ERR_STORE_SYNC
                                   : C2D_ERR_STORE_CLOSE));
    CHECK(why.host_code == 78);
  }
}

TEST_CASE("tasks: small bodies, more of them than are taken at once") {
  Row one(1, 1.0, 0, 28), two(2, 1.0, 0, 28);
  REQUIRE(one.prepare() == C2D_OK);
  REQUIRE(two.prepare() == C2D_OK);
  CHECK(two.side_by_side() == 26);
  CHECK(two.same_store(one));
  one.run(), two.run();
  CHECK(one.numbers == two.numbers);
}

TEST_CASE("tasks: small bodies side by side, one of them without pivots") {
  Row row(2, 1.0);
  int calls = 0;
  row.tasks.before_tasks = [&] { // from the second time on: columns are there, and no factors yet
    if (calls++ == 0) return;
    c2d_solver* const s = row.machine->solver;
    std::memset(c2d::array_of<char>(s, c2d::kPhase), 0, static_cast<size_t>(s->bytes - s->layout.persistent));
  };
  CHECK(row.prepare() == C2D_ERR_SINGULAR);
  CHECK(c2d_get_state(row.machine->solver) == C2D_STATE_MODEL);
  CHECK(std::string(error_of(row.machine->solver).text).find("the equations are singular") == 0);
  row.tasks.before_tasks = nullptr;
  REQUIRE(row.prepare() == C2D_OK);
  row.run();
  Row other(2, 1.0);
  REQUIRE(other.prepare() == C2D_OK);
  other.run();
  CHECK(row.numbers == other.numbers);
}
