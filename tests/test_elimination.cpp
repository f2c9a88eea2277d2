#include "c2d_memory.h"
#include "c2d_posix.h"
#include "c2d_stdio.h"
#include "elimination/eliminate.hpp"
#include "linalg/dense.hpp"
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <doctest/doctest.h>
#include <fenv.h>
#include <filesystem>
#include <limits>
#include <random>
#include <string>
#include <unistd.h>
#include <vector>

using namespace c2d;

namespace {

const double kEps = static_cast<double>(std::numeric_limits<Real>::epsilon());
using Numbers = std::vector<Real>;

// A matrix of the caller's, and what the elimination made of it.
struct Problem {
  int32_t rows, pivots, trailing;
  Numbers a; // rows x (pivots + trailing)
  Numbers s; // (rows - pivots) x trailing, from the sink
  int32_t next_column = 0, next_trailing = 0;
  int32_t calls = 0, refuse_at = -1, calls_after_refusal = 0;
  std::vector<int32_t> told;

  Problem(int32_t m, int32_t p, int32_t t, uint32_t seed, double grade = 0) : rows(m), pivots(p), trailing(t) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    a.resize(static_cast<size_t>(m) * static_cast<size_t>(p + t));
    s.assign(static_cast<size_t>(m - p) * static_cast<size_t>(t), Real(-5));
    told.assign(static_cast<size_t>(p + t), 0);
    for (int32_t j = 0; j < p + t; ++j) {
      for (int32_t i = 0; i < m; ++i) {
        const double scale = std::pow(10.0, grade * (0.7 * i + 0.3 * j) / (m > 1 ? m - 1 : 1));
        at(i, j) = static_cast<Real>(uniform(generator) * scale);
      }
    }
  }
  Real& at(int32_t i, int32_t j) { return a[static_cast<size_t>(i + static_cast<int64_t>(j) * rows)]; }
  bool refused() {
    if (refuse_at >= 0 && calls > refuse_at) ++calls_after_refusal;
    return calls++ == refuse_at;
  }

  static c2d_status fill(void* context, int32_t first, int32_t count, Real* panel, int64_t ld) {
    Problem* p = static_cast<Problem*>(context);
    if (p->refused()) return C2D_ERR_CANCELLED;
    CHECK(first == p->next_column); // every column once, in order
    p->next_column += count;
    for (int32_t j = 0; j < count; ++j) {
      for (int32_t i = 0; i < p->rows; ++i) panel[i + j * ld] = p->at(i, first + j);
    }
    return C2D_OK;
  }
  static c2d_status take(void* context, int32_t first, int32_t count, const Real* values, int64_t ld) {
    Problem* p = static_cast<Problem*>(context);
    if (p->refused()) return C2D_ERR_CANCELLED;
    CHECK(first == p->next_trailing);
    p->next_trailing += count;
    const int32_t rest = p->rows - p->pivots;
    for (int32_t j = 0; j < count; ++j) {
      for (int32_t i = 0; i < rest; ++i) {
        p->s[static_cast<size_t>(i + static_cast<int64_t>(first + j) * rest)] = values[i + j * ld];
      }
    }
    return C2D_OK;
  }
  static c2d_status step(void* context, int32_t column) {
    Problem* p = static_cast<Problem*>(context);
    if (p->refused()) return C2D_ERR_CANCELLED;
    p->told.at(static_cast<size_t>(column)) += 1;
    return C2D_OK;
  }
  ColumnSource source() { return {this, fill}; }
  RowSink sink() { return {this, take}; }
  Watch watch() { return {this, step}; }
};

struct Work {
  std::vector<unsigned char> bytes;
  unsigned char* start;
  uint64_t size;
  explicit Work(uint64_t count) : bytes(count + 128, 0xA5), size(count) {
    const uintptr_t address = reinterpret_cast<uintptr_t>(bytes.data());
    start = bytes.data() + (64 - address % 64) % 64;
  }
  bool intact() const { // nothing behind the area was written
    for (const unsigned char* p = start + size; p < bytes.data() + bytes.size(); ++p) {
      if (*p != 0xA5) return false;
    }
    return true;
  }
};

// Counts what goes through to a memory store; the n-th operation may fail.
struct Store {
  std::vector<unsigned char> region;
  c2d_memory_store memory;
  c2d_port inner, port;
  Tapes tapes;
  int32_t operations = 0, fail_at = -1;
  char failed = ' ';
  explicit Store(size_t bytes = 4 << 20) : region(bytes), inner(), port(), tapes() {
    c2d_memory_store_init(&memory, region.data(), region.size());
    c2d_memory_store_port(&memory, &inner);
    port = C2D_INIT(c2d_port);
    port.context = this;
    port.open = [](void* c, int32_t t, uint64_t n, uint64_t b) {
      Store* s = static_cast<Store*>(c);
      return s->fails('o') ? 77 : s->inner.open(s->inner.context, t, n, b);
    };
    port.read = [](void* c, int32_t t, uint64_t k, void* d, uint64_t n) {
      Store* s = static_cast<Store*>(c);
      return s->fails('r') ? 77 : s->inner.read(s->inner.context, t, k, d, n);
    };
    port.write = [](void* c, int32_t t, uint64_t k, const void* d, uint64_t n) {
      Store* s = static_cast<Store*>(c);
      return s->fails('w') ? 77 : s->inner.write(s->inner.context, t, k, d, n);
    };
    port.sync = [](void*, int32_t) { return 0; };
    port.close = [](void*, int32_t) { return 0; };
    tapes.port = &port;
    tapes.run_id = 12345;
  }
  bool fails(char kind) {
    if (operations++ != fail_at) return false;
    failed = kind;
    return true;
  }
};

c2d_status open_for(const EliminationPlan& plan, Tapes& tapes) {
  const TapeUse lower = lower_use(plan), upper = upper_use(plan);
  c2d_status status = open_tape(tapes, C2D_TAPE_LOWER, plan.lower_first_block + lower.blocks, lower.max_data_bytes);
  if (status != C2D_OK) return status;
  return open_tape(tapes, C2D_TAPE_UPPER, plan.upper_first_block + upper.blocks, upper.max_data_bytes);
}

EliminationPlan plan_of(const Problem& p, int32_t width, int32_t block) {
  return {p.rows, p.pivots, p.trailing, width, block, 0, 0, 0, 0, 0};
}

uint64_t work_bytes(const EliminationPlan& plan) { return elimination_bytes(plan); }

c2d_status run(Problem& p, const EliminationPlan& plan, Tapes& tapes, PivotStats* stats) {
  Work work(work_bytes(plan));
  const c2d_status status = eliminate(plan, p.source(), p.sink(), tapes, work.start, stats, p.watch());
  CHECK(work.intact());
  return status;
}

// Textbook elimination with partial pivoting, in long double: the reference.
struct Reference {
  int32_t rows, columns;
  std::vector<long double> a;
  long double& at(int32_t i, int32_t j) { return a[static_cast<size_t>(i + static_cast<int64_t>(j) * rows)]; }
  explicit Reference(const Problem& p) : rows(p.rows), columns(p.pivots + p.trailing), a(p.a.begin(), p.a.end()) {
    for (int32_t k = 0; k < p.pivots; ++k) {
      int32_t row = k;
      for (int32_t i = k; i < rows; ++i) row = std::fabs(at(i, k)) > std::fabs(at(row, k)) ? i : row;
      for (int32_t j = 0; j < columns; ++j) std::swap(at(k, j), at(row, j));
      for (int32_t i = k + 1; i < rows; ++i) {
        const long double f = at(i, k) / at(k, k);
        for (int32_t j = k; j < columns; ++j) at(i, j) -= f * at(k, j);
      }
    }
  }
};

// Largest difference of S from the reference's, over the largest entry of S's row.
double sink_error(const Problem& p, Reference& reference) {
  const int32_t rest = p.rows - p.pivots;
  double worst = 0;
  for (int32_t i = 0; i < rest; ++i) {
    long double most = 0, difference = 0;
    for (int32_t j = 0; j < p.trailing; ++j) {
      const long double right = reference.at(p.pivots + i, p.pivots + j);
      const long double found = p.s[static_cast<size_t>(i + static_cast<int64_t>(j) * rest)];
      most = std::fmax(most, std::fabs(right));
      difference = std::fmax(difference, std::fabs(found - right));
    }
    if (most > 0) worst = std::fmax(worst, static_cast<double>(difference / most));
  }
  return worst;
}

// Largest difference of a back substitution with coefficients c from the reference's, over the solution's
// largest.
double back_error(const Problem& p, Reference& reference, const Numbers& c, const Numbers& x) {
  std::vector<long double> right(static_cast<size_t>(p.pivots), 0.0L);
  long double most = 0, difference = 0;
  for (int32_t i = p.pivots - 1; i >= 0; --i) {
    long double sum = 0;
    for (int32_t k = 0; k < p.trailing; ++k) sum += c[static_cast<size_t>(k)] * reference.at(i, p.pivots + k);
    for (int32_t j = i + 1; j < p.pivots; ++j) sum -= reference.at(i, j) * right[static_cast<size_t>(j)];
    right[static_cast<size_t>(i)] = sum / reference.at(i, i);
    most = std::fmax(most, std::fabs(right[static_cast<size_t>(i)]));
    difference = std::fmax(difference, std::fabs(right[static_cast<size_t>(i)] - x[static_cast<size_t>(i)]));
  }
  return most > 0 ? static_cast<double>(difference / most) : static_cast<double>(difference);
}

Numbers coefficients(int32_t count) {
  Numbers c(static_cast<size_t>(count) + 1);
  for (int32_t k = 0; k < count; ++k) c[static_cast<size_t>(k)] = static_cast<Real>(std::cos(1.0 + k));
  return c;
}

// Of two vectors, over the largest entry of the second.
double largest_difference(const Numbers& a, const Numbers& b) {
  REQUIRE(a.size() == b.size());
  double most = 0, difference = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    most = std::fmax(most, std::fabs(static_cast<double>(b[i])));
    difference = std::fmax(difference, std::fabs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
  }
  return difference / most;
}

// f . x of a solution x is w . c for the coefficients c it was made of.
void check_functional(const EliminationPlan& plan, Tapes& tapes, const Numbers& c, const Numbers& x, double tolerance) {
  Numbers f(x.size() + 1), w(static_cast<size_t>(plan.trailing) + 1, Real(7));
  double expected = 0, found = 0, size = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    f[i] = static_cast<Real>(std::sin(2.0 + static_cast<double>(i)));
    expected += static_cast<double>(f[i]) * static_cast<double>(x[i]);
    size += std::fabs(static_cast<double>(f[i]) * static_cast<double>(x[i]));
  }
  Work work(back_substitution_bytes(plan));
  REQUIRE(transposed_functional(plan, tapes, f.data(), w.data(), work.start) == C2D_OK);
  CHECK(work.intact());
  CHECK(w.back() == Real(7));
  for (size_t k = 0; k + 1 < w.size(); ++k) {
    found += static_cast<double>(w[k]) * static_cast<double>(c[k]);
    size += std::fabs(static_cast<double>(w[k]) * static_cast<double>(c[k]));
  }
  CHECK(std::fabs(found - expected) <= tolerance * size);
}

// Eliminate, substitute back; everything against the reference. Returns x.
Numbers check_against_reference(Problem& p, const EliminationPlan& plan, Tapes& tapes, double tolerance) {
  PivotStats stats;
  REQUIRE(run(p, plan, tapes, &stats) == C2D_OK);
  CHECK(p.next_column == p.pivots + p.trailing);
  CHECK(p.next_trailing == p.trailing);
  for (int32_t count : p.told) CHECK(count >= 2);
  Reference reference(p);
  CHECK(sink_error(p, reference) < tolerance);
  Numbers c = coefficients(p.trailing), x(static_cast<size_t>(p.pivots) + 1, Real(9));
  Work work(back_substitution_bytes(plan));
  REQUIRE(back_substitute(plan, tapes, c.data(), x.data(), work.start) == C2D_OK);
  CHECK(work.intact());
  CHECK(x.back() == Real(9));
  x.pop_back();
  CHECK(back_error(p, reference, c, x) < tolerance);
  const Tapes counted = tapes;
  check_functional(plan, tapes, c, x, tolerance);
  CHECK(tapes.reads[C2D_TAPE_UPPER] - counted.reads[C2D_TAPE_UPPER] == upper_use(plan).blocks);
  tapes = counted;
  CHECK(tapes.bytes_written[C2D_TAPE_LOWER] == lower_use(plan).bytes_written);
  CHECK(tapes.bytes_read[C2D_TAPE_LOWER] == lower_use(plan).bytes_read);
  CHECK(tapes.writes[C2D_TAPE_LOWER] == lower_use(plan).blocks);
  CHECK(tapes.bytes_written[C2D_TAPE_UPPER] == upper_use(plan).bytes_written);
  CHECK(tapes.bytes_read[C2D_TAPE_UPPER] == upper_use(plan).bytes_read);
  CHECK(tapes.writes[C2D_TAPE_UPPER] == upper_use(plan).blocks);
  CHECK(tapes.reads[C2D_TAPE_UPPER] == upper_use(plan).blocks);
  return x;
}

} // namespace

TEST_CASE("eliminating in panels of any width gives what textbook elimination gives") {
  struct Shape {
    int32_t rows, pivots, trailing;
  };
  const Shape shapes[] = {{0, 0, 0}, {1, 0, 0},  {1, 1, 0},   {1, 1, 3},    {2, 1, 1},   {3, 0, 5},   {3, 3, 2},
                          {5, 4, 3}, {10, 7, 6}, {10, 10, 0}, {50, 30, 41}, {64, 64, 1}, {67, 40, 55}};
  for (const Shape& shape : shapes) {
    const int32_t all = shape.pivots + shape.trailing;
    for (int32_t width : {1, 2, 3, 8, 20, 33, shape.pivots, all - 1, all}) {
      for (int32_t block : {1, 2, 3, 8, 64}) {
        if (width < 1 || width > all || block > width) continue;
        CAPTURE(shape.rows);
        CAPTURE(shape.pivots);
        CAPTURE(shape.trailing);
        CAPTURE(width);
        CAPTURE(block);
        Problem p(shape.rows, shape.pivots, shape.trailing, 17);
        const EliminationPlan plan = plan_of(p, width, block);
        Store store;
        REQUIRE(open_for(plan, store.tapes) == C2D_OK);
        // Random matrices of this size have condition numbers up to some 1e3.
        check_against_reference(p, plan, store.tapes, 1e4 * kEps);
      }
    }
  }
}

TEST_CASE("strips of L and narrower chunks of U give the same numbers") {
  for (int32_t rows : {67, 130}) {
    for (int32_t width : {16, 33, 60}) {
      for (int32_t high : {16, 17, 40, 66, 130}) {
        Problem p(rows, rows - 12, 31, 19), q(rows, rows - 12, 31, 19);
        EliminationPlan plan = plan_of(p, width, 16);
        Store store, whole;
        REQUIRE(open_for(plan, whole.tapes) == C2D_OK);
        const Numbers expected = check_against_reference(p, plan, whole.tapes, 1e4 * kEps);
        plan.block_rows = high;
        CAPTURE(rows);
        CAPTURE(width);
        CAPTURE(high);
        REQUIRE(open_for(plan, store.tapes) == C2D_OK);
        const Numbers x = check_against_reference(q, plan, store.tapes, 1e4 * kEps);
        CHECK(largest_difference(x, expected) < 5000 * kEps);
        if (high < rows) CHECK(lower_use(plan).blocks > lower_use(plan_of(p, width, 16)).blocks);
        // The strips of a chunk are its rows; only headers are more.
        const TapeUse cut = lower_use(plan), uncut = lower_use(plan_of(p, width, 16));
        CHECK(cut.bytes_written - 64 * cut.blocks == uncut.bytes_written - 64 * uncut.blocks);
        CHECK(cut.max_data_bytes <= 16 * static_cast<uint64_t>(high) * sizeof(Real));
        CHECK(upper_use(plan).max_data_bytes <= 16 * static_cast<uint64_t>(high) * sizeof(Real));
      }
    }
  }
}

TEST_CASE("bytes moved stay below n / (3 w) + 2.5 matrices, whatever the memory") {
  for (int32_t n : {500, 1000, 2000, 4000, 8000, 20000}) {
    const double matrix = static_cast<double>(n) * n * sizeof(Real);
    for (int32_t part : {2, 3, 4, 8, 16, 32, 64}) {
      CAPTURE(n);
      CAPTURE(part);
      EliminationPlan plan;
      REQUIRE(plan_elimination(static_cast<uint64_t>(matrix) / static_cast<uint64_t>(part), n, n, 1, 0, plan, nullptr) ==
              C2D_OK);
      const TapeUse lower = lower_use(plan), upper = upper_use(plan);
      const double moved = static_cast<double>(lower.bytes_written + lower.bytes_read + upper.bytes_written + upper.bytes_read);
      CHECK(moved / matrix <= n / (3.0 * plan.panel_columns) + 2.5);
      if (n / part < 64) continue; // narrow panels make do with one buffer
      CHECK(block_buffers(plan) == 2);
      // Buffers take little from the panel, so that the bound itself is near n^3 / 3 over the memory.
      CHECK(plan.panel_columns >= 0.8 * n / part);
    }
  }
}

TEST_CASE("graded matrices") {
  for (int32_t width : {1, 3, 8, 20, 90}) {
    for (double grade : {-6.0, 6.0}) {
      Problem p(60, 50, 40, 23, grade);
      const EliminationPlan plan = plan_of(p, width, width < 8 ? 1 : 8);
      Store store;
      REQUIRE(open_for(plan, store.tapes) == C2D_OK);
      check_against_reference(p, plan, store.tapes, 1e5 * kEps);
    }
  }
}

TEST_CASE("the whole system is solved: reduced equations, then back substitution") {
  const int32_t n = 120, pivots = 90, rest = n - pivots;
  Problem p(n, pivots, rest + 1, 29); // the last trailing column is the right-hand side
  const EliminationPlan plan = plan_of(p, 16, 8);
  Store store;
  REQUIRE(open_for(plan, store.tapes) == C2D_OK);
  REQUIRE(run(p, plan, store.tapes, nullptr) == C2D_OK);
  // S u = s for the kept unknowns; the eliminated ones from A_o x = s - B u.
  std::vector<int32_t> small_pivots(static_cast<size_t>(rest)), pivots_dense(static_cast<size_t>(n));
  Real* right = p.s.data() + static_cast<size_t>(rest) * static_cast<size_t>(rest);
  std::vector<Real> norms(static_cast<size_t>(n) + 1);
  lu_factor(kPlainEngine, rest, p.s.data(), rest, small_pivots.data(), norms.data(), nullptr);
  lu_solve(kPlainEngine, rest, 1, p.s.data(), rest, small_pivots.data(), right, rest);
  Numbers c(static_cast<size_t>(rest) + 1, Real(1)), x(static_cast<size_t>(pivots));
  for (int32_t k = 0; k < rest; ++k) c[static_cast<size_t>(k)] = -right[k];
  Work work(back_substitution_bytes(plan));
  REQUIRE(back_substitute(plan, store.tapes, c.data(), x.data(), work.start) == C2D_OK);
  x.insert(x.end(), right, right + rest);
  Numbers dense(p.a.begin(), p.a.begin() + n * n), y(p.a.begin() + n * n, p.a.end());
  const Numbers b = y;
  lu_factor(kPlainEngine, n, dense.data(), n, pivots_dense.data(), norms.data(), nullptr);
  lu_solve(kPlainEngine, n, 1, dense.data(), n, pivots_dense.data(), y.data(), n);
  double most = 0, difference = 0, residual = 0;
  for (int32_t i = 0; i < n; ++i) {
    long double sum = b[static_cast<size_t>(i)];
    for (int32_t j = 0; j < n; ++j) sum -= static_cast<long double>(p.at(i, j)) * x[static_cast<size_t>(j)];
    residual = std::fmax(residual, std::fabs(static_cast<double>(sum)));
    most = std::fmax(most, std::fabs(static_cast<double>(y[static_cast<size_t>(i)])));
    difference = std::fmax(difference, std::fabs(static_cast<double>(x[static_cast<size_t>(i)] - y[static_cast<size_t>(i)])));
  }
  CHECK(residual < 30 * n * kEps * most);
  CHECK(difference < 1e5 * kEps * most);
}

TEST_CASE("one panel in steps: the bits of the whole, and its errors") {
  for (const int32_t keep_lower : {0, 1}) {
    Problem p(40, 25, 14, 21), q(40, 25, 14, 21);
    EliminationPlan plan = plan_of(p, 39, 8);
    plan.keep_lower = keep_lower;
    Store one, steps;
    REQUIRE(open_for(plan, one.tapes) == C2D_OK);
    REQUIRE(open_for(plan, steps.tapes) == C2D_OK);
    PivotStats expected{}, stats{};
    REQUIRE(run(p, plan, one.tapes, &expected) == C2D_OK);
    Work work(work_bytes(plan));
    const auto fill = [&] {
      int64_t ld;
      Real* panel = only_panel(plan, work.start, &ld);
      for (int32_t j = 0; j < 39; ++j)
        for (int32_t i = 0; i < 40; ++i) panel[i + j * ld] = q.at(i, j);
    };
    fill();
    const int32_t before = steps.operations;
    REQUIRE(factor_only_panel(plan, steps.tapes, work.start, stats, kPlainEngine) == C2D_OK);
    CHECK(steps.operations == before);
    REQUIRE(write_only_panel(plan, q.sink(), steps.tapes, work.start, q.watch()) == C2D_OK);
    CHECK(q.s == p.s);
    for (const int32_t told : q.told) CHECK(told > 0);
    CHECK(std::memcmp(&stats, &expected, sizeof stats) == 0);
    CHECK(steps.region == one.region);
    CHECK(work.intact());
    for (int32_t i = 0; i < 40; ++i) q.at(i, 11) = 0;
    fill();
    CHECK(factor_only_panel(plan, steps.tapes, work.start, stats, kPlainEngine) == C2D_ERR_SINGULAR);
    CHECK(stats.first_unusable == 11);
    q.at(3, 30) = std::numeric_limits<Real>::quiet_NaN();
    fill();
    CHECK(factor_only_panel(plan, steps.tapes, work.start, stats, kPlainEngine) == C2D_ERR_INTERNAL);
  }
}

TEST_CASE("the result hardly depends on the panels' width, and not at all on the store") {
  Numbers first_x, first_s;
  for (int32_t width : {130, 1, 3, 8, 40, 64, 100}) {
    Problem p(90, 70, 60, 31);
    const EliminationPlan plan = plan_of(p, width, width < 8 ? width : 8);
    Store store;
    REQUIRE(open_for(plan, store.tapes) == C2D_OK);
    const Numbers x = check_against_reference(p, plan, store.tapes, 1e4 * kEps);
    if (first_x.empty()) first_x = x, first_s = p.s;
    // 5000 eps is 1.1e-12 in double precision; both in relation to the largest number.
    CHECK(largest_difference(x, first_x) < 5000 * kEps);
    CHECK(largest_difference(p.s, first_s) < 5000 * kEps);

    char folder[] = "/tmp/contact2d_elimination_XXXXXX";
    REQUIRE(mkdtemp(folder) != nullptr);
    for (bool posix : {false, true}) {
      c2d_stdio_store stdio_store;
      c2d_posix_store posix_store;
      c2d_port port = C2D_INIT(c2d_port);
      REQUIRE(c2d_posix_store_init(&posix_store, folder) == 0);
      REQUIRE(c2d_stdio_store_init(&stdio_store, folder) == 0);
      if (posix)
        c2d_posix_store_port(&posix_store, &port);
      else
        c2d_stdio_store_port(&stdio_store, &port);
      Tapes tapes = {};
      tapes.port = &port;
      Problem q(90, 70, 60, 31);
      REQUIRE(open_for(plan, tapes) == C2D_OK);
      CHECK(check_against_reference(q, plan, tapes, 1e4 * kEps) == x);
      CHECK(q.s == p.s);
      CHECK(close_all(tapes) == C2D_OK);
      CHECK(c2d_posix_store_discard(&posix_store, nullptr) == 0);
    }
    std::filesystem::remove_all(folder);
  }
}

TEST_CASE("two bodies share the tapes") {
  Problem one(20, 12, 9, 37), two(31, 22, 10, 38);
  EliminationPlan first = plan_of(one, 5, 2), second = plan_of(two, 7, 3);
  second.lower_first_block = lower_use(first).blocks;
  second.upper_first_block = upper_use(first).blocks;
  Store store;
  Tapes& tapes = store.tapes;
  REQUIRE(open_tape(tapes, C2D_TAPE_LOWER, second.lower_first_block + lower_use(second).blocks, 31 * 3 * 8) == C2D_OK);
  REQUIRE(open_tape(tapes, C2D_TAPE_UPPER, second.upper_first_block + upper_use(second).blocks, 31 * 3 * 8) == C2D_OK);
  REQUIRE(run(one, first, tapes, nullptr) == C2D_OK);
  REQUIRE(run(two, second, tapes, nullptr) == C2D_OK);
  Problem* problems[] = {&one, &two};
  const EliminationPlan* plans[] = {&first, &second};
  for (int i = 0; i < 2; ++i) {
    const Problem& p = *problems[i];
    Reference reference(p);
    Numbers c = coefficients(p.trailing), x(static_cast<size_t>(p.pivots));
    Work work(back_substitution_bytes(*plans[i]));
    REQUIRE(back_substitute(*plans[i], tapes, c.data(), x.data(), work.start) == C2D_OK);
    CHECK(back_error(p, reference, c, x) < 1e4 * kEps);
    CHECK(sink_error(p, reference) < 1e4 * kEps);
  }
}

TEST_CASE("transfers are what a count of columns by hand gives") {
  const uint64_t real = sizeof(Real), rows = 40, pivots = 25, trailing = 14;
  Problem p(40, 25, 14, 3);
  // Blocks of one column: column j of U has j + 1 numbers, of L rows - j.
  for (uint64_t width : std::vector<uint64_t>{1, 4, 10, 25, 39}) {
    const EliminationPlan plan = plan_of(p, static_cast<int32_t>(width), 1);
    uint64_t upper = trailing * (64 + pivots * real), lower = 0, lower_read = 0, blocks = 0;
    for (uint64_t j = 0; j < pivots; ++j) {
      upper += 64 + (j + 1) * real;
      const uint64_t panels = (pivots + trailing + width - 1) / width, later = panels - 1 - j / width;
      if (later == 0) continue;
      ++blocks;
      lower += 64 + (rows - j) * real;
      lower_read += later * (64 + (rows - j) * real);
    }
    CHECK(upper_use(plan).bytes_written == upper);
    CHECK(upper_use(plan).bytes_read == upper);
    CHECK(upper_use(plan).blocks == pivots + trailing);
    CHECK(upper_use(plan).max_data_bytes == pivots * real);
    CHECK(lower_use(plan).bytes_written == lower);
    CHECK(lower_use(plan).bytes_read == lower_read);
    CHECK(lower_use(plan).blocks == blocks);
    CHECK(lower_use(plan).max_data_bytes == (blocks > 0 ? rows * real : 0));
  }
  CHECK(lower_use(plan_of(p, 39, 8)).blocks == 0); // everything at once needs no tape for L
  CHECK(upper_use(plan_of(p, 39, 8)).blocks == 4 + 2);
}

TEST_CASE("plans fit into the memory given, use it, and say what the least is") {
  const int32_t rows = 403, pivots = 340, trailing = 127, all = pivots + trailing;
  const uint64_t least = elimination_bytes(rows, pivots, 1, 1);
  const uint64_t in_core = elimination_bytes_in_core(rows, pivots, trailing);
  EliminationPlan plan;
  uint64_t needed = 0;
  CHECK(plan_elimination(least - 1, rows, pivots, trailing, 0, plan, &needed) == C2D_ERR_MEMORY);
  CHECK(needed == least);
  CHECK(plan_elimination(least, rows, pivots, trailing, 0, plan, nullptr) == C2D_OK);
  CHECK(plan.panel_columns == 1);
  CHECK(plan_elimination(in_core, rows, pivots, trailing, 0, plan, nullptr) == C2D_OK);
  CHECK(plan.panel_columns == all);
  CHECK(plan.block_columns == 64);
  int32_t widest = 1;
  for (uint64_t bytes = least; bytes < in_core + 5000; bytes += 4999) {
    REQUIRE(plan_elimination(bytes, rows, pivots, trailing, 0, plan, nullptr) == C2D_OK);
    REQUIRE(work_bytes(plan) <= bytes);
    REQUIRE(plan.block_columns >= 1);
    REQUIRE(plan.block_columns <= plan.panel_columns);
    // At most a fifth of the memory goes to the block, and a block's width to rounding.
    REQUIRE(plan.panel_columns >= 0.6 * static_cast<double>(bytes - least) / (rows * sizeof(Real)));
    widest = plan.panel_columns > widest ? plan.panel_columns : widest;
  }
  CHECK(widest == all);
  for (int32_t forced : {1, 3, 20, all, all + 7}) {
    const int32_t width = forced < all ? forced : all;
    const uint64_t enough = elimination_bytes(rows, pivots, width, 1);
    CHECK(plan_elimination(enough, rows, pivots, trailing, forced, plan, &needed) == C2D_OK);
    CHECK(plan.panel_columns == width);
    CHECK(plan.block_columns == 1);
    CHECK(plan_elimination(enough - 1, rows, pivots, trailing, forced, plan, &needed) == C2D_ERR_MEMORY);
    CHECK(needed == enough);
  }
  CHECK(plan_elimination(UINT64_MAX, 5, 6, 0, 0, plan, nullptr) == C2D_ERR_ARGUMENT);
  CHECK(plan_elimination(UINT64_MAX, 5, 5, INT32_MAX - 2, 0, plan, nullptr) == C2D_ERR_ARGUMENT);
  CHECK(plan_elimination(UINT64_MAX, 5, -1, 0, 0, plan, nullptr) == C2D_ERR_ARGUMENT);
  CHECK(elimination_bytes(INT32_MAX, INT32_MAX, INT32_MAX, INT32_MAX) == UINT64_MAX);
  CHECK(plan_elimination(1 << 20, 0, 0, 0, 0, plan, nullptr) == C2D_OK);
}

TEST_CASE("zero columns are reported as singular, without a trap") {
  for (int32_t zero : {0, 7, 24}) {
    for (int32_t width : {1, 3, 8, 25, 40}) {
      Problem p(30, 25, 15, 41);
      for (int32_t i = 0; i < p.rows; ++i) p.at(i, zero) = 0;
      for (int32_t i = 0; i < p.rows; ++i) p.at(i, 30) = 0; // a trailing column may be zero
      const EliminationPlan plan = plan_of(p, width, width < 4 ? 1 : 4);
      Store store;
      REQUIRE(open_for(plan, store.tapes) == C2D_OK);
      PivotStats stats;
      feclearexcept(FE_ALL_EXCEPT);
      feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
      const c2d_status status = run(p, plan, store.tapes, &stats);
      fedisableexcept(FE_ALL_EXCEPT);
      CHECK(status == C2D_ERR_SINGULAR);
      CHECK(stats.first_unusable == zero);
      CHECK(stats.unusable == 1);
    }
  }
}

TEST_CASE("zeros on the diagonal of a stranger's factors are not divided by") {
  Problem p(30, 25, 15, 41);
  const EliminationPlan plan = plan_of(p, 8, 4);
  Store store;
  REQUIRE(open_for(plan, store.tapes) == C2D_OK);
  REQUIRE(run(p, plan, store.tapes, nullptr) == C2D_OK);
  for (Chunk chunk = first_chunk(plan); chunk.count > 0; chunk = next_chunk(plan, chunk)) {
    const uint64_t bytes = upper_bytes(plan, chunk);
    std::vector<unsigned char> block(kBlockHeaderBytes + bytes, 0);
    REQUIRE(write_block(store.tapes, C2D_TAPE_UPPER, plan.upper_first_block + chunk.index, block.data(), bytes) == C2D_OK);
  }
  Numbers f(25, 1), w(15, 1), x(25, 1);
  const Numbers c(15, 1);
  Work work(back_substitution_bytes(plan));
  feclearexcept(FE_ALL_EXCEPT);
  feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
  const c2d_status forward = transposed_functional(plan, store.tapes, f.data(), w.data(), work.start);
  const c2d_status back = back_substitute(plan, store.tapes, c.data(), x.data(), work.start);
  fedisableexcept(FE_ALL_EXCEPT);
  CHECK(forward == C2D_OK);
  CHECK(back == C2D_OK);
  for (const Numbers& numbers : {f, w, x})
    for (Real number : numbers) CHECK(number == 0);
}

TEST_CASE("pivot statistics do not depend on the panels and name the weak column") {
  for (int32_t width : {1, 3, 8, 60}) {
    Problem p(45, 40, 20, 43);
    for (int32_t i = 0; i < p.rows; ++i) p.at(i, 33) = p.at(i, 2) + Real(1e-3) * p.at(i, 33);
    const EliminationPlan plan = plan_of(p, width, 1);
    Store store;
    REQUIRE(open_for(plan, store.tapes) == C2D_OK);
    PivotStats stats;
    REQUIRE(run(p, plan, store.tapes, &stats) == C2D_OK);
    CHECK(stats.smallest_column == 33);
    Reference reference(p);
    double norm = 0, growth = 0;
    for (int32_t i = 0; i < p.rows; ++i) norm = std::fmax(norm, std::fabs(static_cast<double>(p.at(i, 33))));
    for (int32_t j = 0; j < p.pivots; ++j) {
      double most = 0, most_u = 0;
      for (int32_t i = 0; i < p.rows; ++i) most = std::fmax(most, std::fabs(static_cast<double>(p.at(i, j))));
      for (int32_t i = 0; i <= j; ++i) most_u = std::fmax(most_u, std::fabs(static_cast<double>(reference.at(i, j))));
      growth = std::fmax(growth, most_u / most);
    }
    const double right = std::fabs(static_cast<double>(reference.at(33, 33))) / norm;
    CHECK(stats.smallest_ratio == doctest::Approx(right).epsilon(1e7 * kEps));
    CHECK(stats.growth == doctest::Approx(growth).epsilon(1e5 * kEps));
  }
}

TEST_CASE("with more memory strips beside panels of a given width are no narrower") {
  const int32_t rows = 2000, width = 600;
  const uint64_t panel = elimination_bytes(rows, rows, width, 0);
  int32_t before = 0;
  EliminationPlan plan;
  for (uint64_t bytes = panel + 200000; bytes < panel + 5000000; bytes += 1000) {
    REQUIRE(plan_elimination(bytes, rows, rows, 50, width, plan, nullptr) == C2D_OK);
    if (plan.block_rows == 0) continue;
    CAPTURE(bytes - panel);
    CHECK(plan.block_columns >= before);
    before = plan.block_columns;
  }
  CHECK(before == 256);
}

// Panels of new columns begin anywhere in the chunks of Y.
TEST_CASE("new columns in place of some trailing ones: what eliminating all of them gives") {
  for (int32_t width = 1; width <= 6; ++width)
    for (int32_t block = 1; block <= width; ++block)
      for (int32_t first = 0; first < 9; first += 2) {
        CAPTURE(width);
        CAPTURE(block);
        CAPTURE(first);
        Problem p(12, 8, 9, 3), q = p;
        const Problem other(12, 8, 9, 4);
        std::copy(other.a.begin() + 12 * (8 + first), other.a.end(), q.a.begin() + 12 * (8 + first));
        Problem all = q;
        EliminationPlan plan = plan_of(p, width, block);
        plan.keep_lower = 1;
        Store store, whole;
        REQUIRE(open_for(plan, store.tapes) == C2D_OK);
        REQUIRE(open_for(plan, whole.tapes) == C2D_OK);
        REQUIRE(run(p, plan, store.tapes, nullptr) == C2D_OK);
        REQUIRE(run(all, plan, whole.tapes, nullptr) == C2D_OK);
        Work work(work_bytes(plan));
        q.s = p.s;
        q.next_column = 8 + first;
        q.next_trailing = first;
        const uint64_t written = store.tapes.writes[C2D_TAPE_UPPER];
        REQUIRE(eliminate_again(plan, first, q.source(), q.sink(), store.tapes, work.start, q.watch()) == C2D_OK);
        CHECK(q.next_trailing == 9);
        uint64_t met = 0; // chunks of Y that have columns of a panel
        for (int32_t from = 8 + first; from < 17; from += width)
          for (Chunk chunk = next_chunk(plan, chunk_before(plan, 8)); chunk.count > 0; chunk = next_chunk(plan, chunk))
            met += chunk.first < from + width && chunk.first + chunk.count > from ? 1 : 0;
        CHECK(store.tapes.writes[C2D_TAPE_UPPER] - written == met);
        CHECK(work.intact());
        for (size_t i = 0; i < all.s.size(); ++i) CHECK(std::fabs(q.s[i] - all.s[i]) <= 1e3 * kEps);
        const Numbers c(9, 1);
        Numbers x(8), y(8);
        Work back(back_substitution_bytes(plan));
        REQUIRE(back_substitute(plan, store.tapes, c.data(), x.data(), back.start) == C2D_OK);
        REQUIRE(back_substitute(plan, whole.tapes, c.data(), y.data(), back.start) == C2D_OK);
        for (size_t i = 0; i < 8; ++i) CHECK(std::fabs(x[i] - y[i]) <= 1e4 * kEps * std::fmax(1.0, std::fabs(y[i])));
      }
}

// As of a body that is in contact all round: what it is is what is left of it.
TEST_CASE("no unknown is eliminated: rows go through as they are, new ones too") {
  Problem p(5, 0, 4, 3), q(5, 0, 4, 4);
  EliminationPlan plan = plan_of(p, 2, 1);
  plan.keep_lower = 1;
  Store store;
  REQUIRE(open_for(plan, store.tapes) == C2D_OK);
  Work work(work_bytes(plan));
  REQUIRE(eliminate(plan, p.source(), p.sink(), store.tapes, work.start, nullptr, p.watch()) == C2D_OK);
  CHECK(p.s == p.a);
  q.next_column = q.next_trailing = 1;
  REQUIRE(eliminate_again(plan, 1, q.source(), q.sink(), store.tapes, work.start, q.watch()) == C2D_OK);
  CHECK(q.next_trailing == 4);
  CHECK(std::equal(q.a.begin() + 5, q.a.end(), q.s.begin() + 5));
  Real f = 7, w[4] = {1, 2, 3, 4};
  CHECK(transposed_functional(plan, store.tapes, &f, nullptr, work.start) == C2D_OK);
  CHECK(transposed_functional(plan, store.tapes, &f, w, work.start) == C2D_OK);
  for (Real x : w) CHECK(x == 0);
  CHECK(work.intact());
}

TEST_CASE("a number that is not finite is refused") {
  Problem p(10, 8, 3, 47);
  p.at(9, 10) = std::numeric_limits<Real>::infinity();
  const EliminationPlan plan = plan_of(p, 3, 1);
  Store store;
  REQUIRE(open_for(plan, store.tapes) == C2D_OK);
  CHECK(run(p, plan, store.tapes, nullptr) == C2D_ERR_INTERNAL);
}

TEST_CASE("source, watch and sink can stop it at every call, at once") {
  int32_t n = 0;
  for (bool done = false; !done; ++n) {
    Problem p(14, 9, 6, 51);
    p.refuse_at = n;
    const EliminationPlan plan = plan_of(p, 4, 2);
    Store store;
    REQUIRE(open_for(plan, store.tapes) == C2D_OK);
    const c2d_status status = run(p, plan, store.tapes, nullptr);
    done = p.calls <= n;
    REQUIRE(status == (done ? C2D_OK : C2D_ERR_CANCELLED));
    REQUIRE(p.calls_after_refusal == 0);
  }
  CHECK(n > 2 * 15);
}

TEST_CASE("blocks hold the row exchanges, too, where strips of L are shorter") {
  EliminationPlan plan = {12, 8, 3, 4, 1, 0, 0, 0, 1, 1};
  CHECK(lower_use(plan).max_data_bytes == 8 * sizeof(int32_t));
  CHECK(lower_use(plan).blocks > 8 * 8 / 2);
  plan.block_rows = 12;
  CHECK(lower_use(plan).max_data_bytes == 12 * sizeof(Real));
}

TEST_CASE("the n-th transfer fails, for every n: the right error, and a new attempt succeeds") {
  int32_t n = 0;
  for (bool done = false; !done; ++n) {
    Problem p(14, 9, 6, 53);
    const EliminationPlan plan = plan_of(p, 4, 2);
    Store store;
    REQUIRE(open_for(plan, store.tapes) == C2D_OK);
    store.fail_at = store.operations + n;
    PivotStats stats;
    c2d_status status = run(p, plan, store.tapes, &stats);
    Numbers c = coefficients(p.trailing), x(static_cast<size_t>(p.pivots));
    Work work(back_substitution_bytes(plan));
    if (status == C2D_OK) status = back_substitute(plan, store.tapes, c.data(), x.data(), work.start);
    done = store.failed == ' ';
    REQUIRE(status == (done ? C2D_OK : store.failed == 'r' ? C2D_ERR_STORE_READ : C2D_ERR_STORE_WRITE));
    if (!done) REQUIRE(store.tapes.error.host_code == 77);
    store.fail_at = -1;
    Problem again(14, 9, 6, 53);
    REQUIRE(run(again, plan, store.tapes, &stats) == C2D_OK);
    REQUIRE(back_substitute(plan, store.tapes, c.data(), x.data(), work.start) == C2D_OK);
    Reference reference(again);
    REQUIRE(back_error(again, reference, c, x) < 1e4 * kEps);
  }
  CHECK(n > 20);
}

// As of a border that keeps less than its plan has room for: where its pivots end inside a panel there is a chunk more.
TEST_CASE("elimination: blocks of one with fewer pivots, cut alike, are within most_upper_use") {
  bool some_more = false; // than the whole plan has
  for (const auto& [width, block] : {std::pair(7, 3), std::pair(10, 5), std::pair(10, 1), std::pair(64, 9)}) {
    const EliminationPlan most{40, 35, 25, width, block, 0, 0, 0, 0, 0};
    const TapeUse room = c2d::most_upper_use(most);
    for (int32_t pivots = 1; pivots <= most.pivots; ++pivots) {
      EliminationPlan plan{pivots + 5, pivots, most.trailing, 1, 1, 0, 0, 0, 0, 0};
      c2d::cut_alike(most, plan);
      const TapeUse use = upper_use(plan);
      CHECK(use.blocks <= room.blocks);
      CHECK(use.max_data_bytes <= room.max_data_bytes);
      some_more = some_more || use.blocks > upper_use(most).blocks;
    }
  }
  CHECK(some_more);
}

TEST_CASE("factors of an earlier generation, and damaged ones, are never used") {
  Problem p(14, 9, 6, 57);
  const EliminationPlan plan = plan_of(p, 4, 2);
  Store store;
  REQUIRE(open_for(plan, store.tapes) == C2D_OK);
  REQUIRE(run(p, plan, store.tapes, nullptr) == C2D_OK);
  Numbers c = coefficients(p.trailing), x(static_cast<size_t>(p.pivots));
  Work work(back_substitution_bytes(plan));
  const uint64_t upper = store.memory.offset[C2D_TAPE_UPPER], size = store.memory.block_bytes[C2D_TAPE_UPPER];
  for (uint64_t block = 0; block < upper_use(plan).blocks; ++block) {
    unsigned char& byte = store.region[upper + block * size + 70];
    byte ^= 0x08;
    CHECK(back_substitute(plan, store.tapes, c.data(), x.data(), work.start) == C2D_ERR_STORE_CHECKSUM);
    CHECK(store.tapes.error.block == static_cast<int64_t>(block));
    byte ^= 0x08;
  }
  store.tapes.generation[C2D_TAPE_UPPER] += 1; // written anew
  CHECK(back_substitute(plan, store.tapes, c.data(), x.data(), work.start) == C2D_ERR_STORE_STALE);
}
