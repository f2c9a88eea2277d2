// Exchanges that are kept back in a list against exchanges made at once.
#include "c2d_threads.h"
#include "linalg/delayed.hpp"
#include "linalg/exchange.hpp"
#include "paths.hpp"
#include "shell.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <fenv.h>
#include <limits>
#include <random>
#include <vector>

using namespace c2d;

namespace {

const double kEps = static_cast<double>(std::numeric_limits<Real>::epsilon());
const Real kMark = Real(-77);

size_t sized(int64_t n) { return static_cast<size_t>(n); }

struct Traps {
  Traps() {
    feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
  }
  ~Traps() { fedisableexcept(FE_ALL_EXCEPT); }
};

// A tableau with a list, and the same numbers without one.
struct Both {
  std::vector<Real> now, delayed, list;
  DelayedExchanges d;
  Both(int32_t rows, int32_t cols, int32_t most, uint32_t seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    now.resize(sized(rows) * sized(cols));
    for (Real& x : now) x = static_cast<Real>(0.3 * uniform(generator) / std::sqrt(rows));
    for (int32_t j = 0; j < cols; ++j) now[sized(int64_t{j} * rows + j)] += 1; // no pivot far from one
    delayed = now;
    list.assign(sized(list_numbers(rows, most)) + 1, kMark); // nothing is read before it is written, nothing beyond
    d = {rows, cols, delayed.data(), most, list.data(), 0};
  }
  void exchange_both(const Engine& engine, int32_t r) {
    REQUIRE(exchange(d.rows, d.cols, now.data(), d.rows, r, r));
    const Real *u = nullptr, *v = nullptr;
    const Real pivot = read_entry(d, r, r);
    REQUIRE(delay_exchange(d, engine, r, r, &u, &v));
    CHECK(static_cast<double>(u[r] * pivot) == doctest::Approx(1).epsilon(100 * kEps));
    CHECK(v[r] == -1);
  }
  void add_both(int32_t a, int32_t b) {
    row_add(d.cols, now.data(), d.rows, a, b, Real(0.25));
    delayed_row_add(d, a, b, Real(0.25));
    column_add(d.rows, now.data(), d.rows, b, a, Real(-0.125));
    delayed_column_add(d, b, a, Real(-0.125));
  }
  double at(int32_t i, int32_t j) const { return static_cast<double>(now[sized(int64_t{j} * d.rows + i)]); }
  // The largest difference of what is read through the list.
  double worst(const Engine& engine) const {
    std::vector<Real> column(sized(d.rows)), row(sized(d.cols)), sum(sized(d.rows), Real(1));
    double most = 0;
    const auto meet = [&](Real x, double y) { most = std::fmax(most, std::fabs(static_cast<double>(x) - y)); };
    for (int32_t j = 0; j < d.cols; ++j) {
      read_column(d, engine, j, column.data());
      std::fill(sum.begin(), sum.end(), Real(1));
      add_column_to(d, engine, j, Real(0.5), sum.data());
      for (int32_t i = 0; i < d.rows; ++i) {
        meet(column[sized(i)], at(i, j));
        meet(read_entry(d, i, j), at(i, j));
        meet(sum[sized(i)], 1 + 0.5 * at(i, j));
      }
    }
    for (int32_t i = 0; i < d.rows; ++i) {
      read_row(d, engine, i, row.data());
      for (int32_t j = 0; j < d.cols; ++j) meet(row[sized(j)], at(i, j));
    }
    return most;
  }
};

struct Worker {
  std::vector<Real> scratch;
  Engine engine = kPlainEngine;
  explicit Worker(int64_t numbers, Instructions set = best_instructions(), Workers workers = kAlone)
      : scratch(sized(numbers) + 16) {
    const size_t past = reinterpret_cast<uintptr_t>(scratch.data()) % 64 / sizeof(Real);
    engine = {kernel_for(set), scratch.data() + (past > 0 ? 64 / sizeof(Real) - past : 0), numbers, nullptr, workers};
  }
};

} // namespace

TEST_CASE("delayed exchanges: whatever the length of the list, columns, rows and entries are those of exchanges made at once") {
  const Worker best(full_scratch(kMostDelayed, 200));
  for (const Engine& engine : {kPlainEngine, best.engine}) {
    for (const int32_t most : {1, 2, 3, 5, 64}) {
      for (const int32_t rows : {1, 2, 3, 7, 33, 130}) {
        for (const int32_t cols : {rows, (rows + 1) / 2}) {
          CAPTURE(most);
          CAPTURE(rows);
          CAPTURE(cols);
          Both both(rows, cols, most, static_cast<uint32_t>(rows + most));
          const double close = 100 * kEps;
          const Traps traps;
          // One more than the list holds, some of them twice, with combinations of rows and columns before and after.
          for (int32_t k = 0; k < std::min(most, 2 * cols) + 1; ++k) {
            both.exchange_both(engine, k * 19 % cols);
            if (cols > 1 && k % 3 == 1) both.add_both(k % cols, (k + 1) % cols);
            if (both.d.count == most) CHECK(both.worst(engine) < close);
          }
          CHECK(both.d.count <= most);
          CHECK((both.d.count >= 1 || cols == 1)); // of one column, which is exchanged back
          CHECK(both.worst(engine) < close);
          apply_delayed(both.d, engine);
          CHECK(both.d.count == 0);
          CHECK(both.worst(engine) < close);
          apply_delayed(both.d, engine); // of nothing
          CHECK(both.worst(engine) < close);
          CHECK(both.list.back() == kMark);
        }
      }
    }
  }
}

TEST_CASE("delayed exchanges: an exchange and its reverse give the tableau back, in one list or across its end") {
  const Worker best(full_scratch(kMostDelayed, 64));
  for (const int32_t most : {1, 2, 4}) {
    Both both(40, 40, most, 9);
    const std::vector<Real> before = both.now;
    for (const int32_t r : {3, 17, 3, 17}) both.exchange_both(best.engine, r);
    both.now = before;
    CHECK(both.worst(best.engine) < 100 * kEps);
  }
}

TEST_CASE("delayed exchanges: the list is as long as there are places whose exchanges have not been reversed") {
  const Worker best(full_scratch(kMostDelayed, 64));
  std::mt19937 generator(5);
  for (const Engine& engine : {kPlainEngine, best.engine}) {
    for (const int32_t cols : {40, 23}) {
      Both both(40, cols, 32, 11);
      std::vector<bool> out(sized(cols));
      int32_t longest = 0;
      for (int i = 0; i < 300; ++i) {
        const int32_t r = static_cast<int32_t>(generator() % 20);
        both.exchange_both(engine, r);
        out[sized(r)] = !out[sized(r)];
        longest = std::max(longest, both.d.count);
        REQUIRE(both.d.count == std::count(out.begin(), out.end(), true));
        if (i % 20 == 0) CHECK(both.worst(engine) < 1000 * kEps);
      }
      CHECK(longest > 10);
      apply_delayed(both.d, engine);
      CHECK(both.worst(engine) < 1000 * kEps);
    }
  }
}

TEST_CASE("delayed exchanges: those that are kept while the others are applied can be reversed as before") {
  const Worker best(full_scratch(kMostDelayed, 64));
  for (const Engine& engine : {kPlainEngine, best.engine}) {
    for (const int32_t cols : {40, 23}) {
      for (const int32_t kept : {0, 1, 7, 19, 20}) {
        CAPTURE(kept);
        Both both(40, cols, 32, 12);
        for (int32_t r = 0; r < 20; ++r) both.exchange_both(engine, r);
        both.add_both(1, 0);
        bool keep[kMostDelayed] = {};
        for (int32_t k = 0; k < kept; ++k) keep[place_in_list(both.d, 19 - k * 7 % 18, 19 - k * 7 % 18)] = true;
        const int32_t there = static_cast<int32_t>(std::count(keep, keep + 20, true));
        const Traps traps;
        apply_all_but(both.d, engine, keep);
        CHECK(both.d.count == there);
        CHECK(both.worst(engine) < 1000 * kEps);
        for (int32_t r = 20; r < 23; ++r) both.exchange_both(engine, r);
        CHECK(both.worst(engine) < 1000 * kEps);
        for (int32_t k = 0; k < there; ++k) both.exchange_both(engine, 19 - k * 7 % 18);
        CHECK(both.d.count == 3);
        CHECK(both.worst(engine) < 1000 * kEps);
        CHECK(both.list.back() == kMark);
      }
    }
  }
}

TEST_CASE("delayed exchanges: one of whose pivot little is left is not kept") {
  Both both(8, 8, 8, 3);
  both.now[0] = both.delayed[0] = Real(0.01);
  both.now[1] = both.delayed[1] = both.now[8] = both.delayed[8] = 1;
  both.now[9] = both.delayed[9] = Real(1);
  both.exchange_both(kPlainEngine, 1);
  both.exchange_both(kPlainEngine, 0); // the pivot is -0.99, a hundred times what stood there
  CHECK(both.d.count == 2);
  const bool keep[kMostDelayed] = {false, true};
  apply_all_but(both.d, kPlainEngine, keep);
  CHECK(both.worst(kPlainEngine) < 1000 * kEps);
  CHECK(both.d.count == 0);
}

TEST_CASE("delayed exchanges: a zero pivot is refused, and nothing changes but that a full list is applied") {
  Both both(3, 3, 1, 4);
  both.exchange_both(kPlainEngine, 0);
  apply_delayed(both.d, kPlainEngine);
  both.delayed[4] = both.now[4] = 0;
  const std::vector<Real> before = both.delayed;
  const Real *u = nullptr, *v = nullptr;
  const Traps traps;
  CHECK_FALSE(delay_exchange(both.d, kPlainEngine, 1, 1, &u, &v));
  CHECK(both.delayed == before);
  CHECK(both.d.count == 0);
  both.exchange_both(kPlainEngine, 0);
  both.delayed[4] += both.d.numbers[1] * both.d.numbers[3 + 1] * both.d.numbers[6]; // U, V and M of one exchange
  both.now[4] = 0;
  CHECK_FALSE(delay_exchange(both.d, kPlainEngine, 1, 1, &u, &v));
  CHECK(both.d.count == 0);
  CHECK(both.worst(kPlainEngine) < 100 * kEps);
}

// A beam clamped at one end, each place of which gives way a little of its own: with a list that holds all of them an inverse
// would take their digits away twice.
TEST_CASE("delayed exchanges: what bends loses no more digits than when exchanged at once") {
  const int32_t n = 40;
  const double local = sizeof(Real) == 8 ? 1e-7 : 1e-3;
  Both both(n, n, n, 5);
  for (int32_t j = 0; j < n; ++j)
    for (int32_t i = 0; i < n; ++i) {
      const double a = (std::min(i, j) + 1.0) / n, b = (std::max(i, j) + 1.0) / n;
      both.now[sized(int64_t{j} * n + i)] = static_cast<Real>(a * a * (3 * b - a) / 6 + (i == j ? local : 0));
    }
  both.delayed = both.now;
  for (int32_t i = n - 1; i >= 0; --i) both.exchange_both(kPlainEngine, i);
  CHECK(both.d.count < n);
  apply_delayed(both.d, kPlainEngine);
  double off = 0;
  for (size_t i = 0; i < both.now.size(); ++i)
    off = std::max(off, std::fabs(static_cast<double>(both.now[i] - both.delayed[i])) * local);
  CHECK(off < 1e5 * kEps);
}

TEST_CASE("delayed exchanges: no bit depends on scratch or threads") {
  c2d_threads pool;
  REQUIRE(c2d_threads_start(&pool, 2) == 0);
  c2d_port port = C2D_INIT(c2d_port);
  c2d_threads_port(&pool, &port);
  const int32_t n = 301, most = 37;
  const Worker least(most * 64), enough(full_scratch(kMostDelayed, n)),
      shared(4 * full_scratch(kDepth, n), best_instructions(), workers_of(&port));
  std::vector<Real> results[3];
  int at = 0;
  for (const Engine* engine : {&least.engine, &enough.engine, &shared.engine}) {
    Both both(n, n, most, 3);
    const Real *u = nullptr, *v = nullptr;
    for (int32_t k = 0; k < 2 * most + 3; ++k) REQUIRE(delay_exchange(both.d, *engine, k * 7 % n, k * 7 % n, &u, &v));
    apply_delayed(both.d, *engine);
    results[at++] = both.delayed;
  }
  CHECK(results[0] == results[1]);
  CHECK(results[0] == results[2]);
  c2d_threads_stop(&pool);
}

// More than 80 pairs, so that the tableau has a list; without friction it has half of its columns.
TEST_CASE("delayed exchanges: of whole runs no digit depends on threads") {
  using namespace test;
  const Folder folder;
  const std::string program = "'" + paths::program() + "' ";
  for (const std::string family : {"mindlin n=36 steps=1", "hertz n=70"}) {
    CAPTURE(family);
    const std::string deck = folder / "deck";
    REQUIRE(run_shell(program + "make " + family + " > '" + deck + "'").status == 0);
    const auto csv_of = [&](const std::string& options) {
      const std::string csv = folder / "csv";
      const Result ran = run_shell(program + "run '" + deck + "' --no-progress --csv '" + csv + "' " + options);
      CHECK_MESSAGE(ran.status == 0, ran.err);
      return read_file(csv);
    };
    const std::string whole = csv_of("");
    CHECK(std::count(whole.begin(), whole.end(), '\n') > 80);
    CHECK(csv_of("--threads 2") == whole);
  }
}
