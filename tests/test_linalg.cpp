#include "contact/reduction/orthonormal.hpp"
#include "effort.hpp"
#include "linalg/dense.hpp"
#include "linalg/exchange.hpp"
#include "linalg/lu.hpp"
#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <fenv.h>
#include <initializer_list>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace c2d;

namespace {

const double kEps = static_cast<double>(std::numeric_limits<Real>::epsilon());

struct Matrix {
  int32_t rows, cols;
  int64_t ld;
  std::vector<Real> a;
  Matrix(int32_t r, int32_t c, int64_t gap = 0) : rows(r), cols(c), ld(r + gap > 0 ? r + gap : 1) {
    a.assign(static_cast<size_t>(ld * c + 1), Real(-77)); // the gap's number must survive
  }
  Real& operator()(int32_t i, int32_t j) { return a[static_cast<size_t>(i + j * ld)]; }
  Real operator()(int32_t i, int32_t j) const { return a[static_cast<size_t>(i + j * ld)]; }
  Real* data() { return a.data(); }
};

Matrix random_matrix(int32_t rows, int32_t cols, uint32_t seed, int64_t gap = 0) {
  Matrix m(rows, cols, gap);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int32_t j = 0; j < cols; ++j) {
    for (int32_t i = 0; i < rows; ++i) m(i, j) = static_cast<Real>(uniform(generator));
  }
  return m;
}

double norm1(const Matrix& m) {
  double most = 0;
  for (int32_t j = 0; j < m.cols; ++j) {
    double sum = 0;
    for (int32_t i = 0; i < m.rows; ++i) sum += std::fabs(static_cast<double>(m(i, j)));
    most = std::fmax(most, sum);
  }
  return most;
}

// norm(P A - L U) / (n norm(A) eps), products in long double.
double lu_residual(Matrix a, const Matrix& lu, const std::vector<int32_t>& pivots) {
  const int32_t n = a.cols;
  if (n == 0) return 0;
  const double norm = norm1(a);
  for (int32_t i = 0; i < n; ++i) {
    for (int32_t j = 0; j < n; ++j) std::swap(a(i, j), a(pivots[static_cast<size_t>(i)], j));
  }
  double most = 0;
  for (int32_t j = 0; j < n; ++j) {
    long double sum = 0;
    for (int32_t i = 0; i < a.rows; ++i) {
      long double product = i <= j ? static_cast<long double>(lu(i, j)) : 0;
      for (int32_t k = 0; k < i && k <= j; ++k) product += static_cast<long double>(lu(i, k)) * lu(k, j);
      sum += std::fabs(static_cast<double>(product - a(i, j)));
    }
    most = std::fmax(most, static_cast<double>(sum));
  }
  return norm == 0 ? most : most / (n * norm * kEps);
}

// Every form of the kernels that this build has and this machine runs: the plain one, and each instruction
// set with all the scratch it can use, with very little, and with too little.
struct TestEngine {
  std::string name;
  std::vector<Real> memory;
  Engine engine;
};
std::vector<TestEngine> test_engines() {
  std::vector<TestEngine> all;
  all.push_back({"plain", {}, kPlainEngine});
  for (int32_t set = 1; set <= static_cast<int32_t>(best_instructions()); ++set) {
    const Kernel* kernel = kernel_for(static_cast<Instructions>(set));
    if (!kernel) continue;
    const int64_t least = kernel->rows + kernel->cols;
    for (const int64_t numbers : {full_scratch(256, 384), 3 * least + 5, least - 1}) {
      TestEngine e{
          "set " + std::to_string(set) + ", scratch " + std::to_string(numbers), {}, {kernel, nullptr, numbers, nullptr}};
      e.memory.assign(static_cast<size_t>(numbers) + 9, Real(-55));
      all.push_back(std::move(e));
    }
  }
  for (TestEngine& e : all) // vectors have moved for the last time
    if (e.engine.kernel)
      e.engine.scratch = e.memory.data() + (64 - reinterpret_cast<uintptr_t>(e.memory.data()) % 64) % 64 / sizeof(Real);
  return all;
}

const TestEngine& best_engine() {
  static const std::vector<TestEngine> all = test_engines();
  return all.size() > 1 ? all[all.size() - 3] : all[0];
}

int32_t factor(const Engine& engine, Matrix& a, std::vector<int32_t>& pivots, PivotStats* stats) {
  std::vector<Real> norms(static_cast<size_t>(a.cols) + 1);
  return lu_factor(engine, a.cols, a.data(), a.ld, pivots.data(), norms.data(), stats);
}

// Traps on for the length of a scope: what must not raise anything ends the program if it does.
struct Traps {
  Traps() {
    feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
  }
  ~Traps() { fedisableexcept(FE_ALL_EXCEPT); }
};

} // namespace

TEST_CASE("a product of a few tiles, by every engine") {
  const int32_t n = 40;
  const Matrix a = random_matrix(n, n, 3), b = random_matrix(n, n, 4);
  for (const TestEngine& e : test_engines()) {
    INFO(e.name);
    Matrix c = random_matrix(n, n, 5), known = c;
    gemm_minus(e.engine, n, n, n, &a.a[0], a.ld, &b.a[0], b.ld, c.data(), c.ld);
    double worst = 0;
    for (int32_t j = 0; j < n; ++j)
      for (int32_t i = 0; i < n; ++i) {
        for (int32_t k = 0; k < n; ++k) known(i, j) -= a(i, k) * b(k, j);
        worst = std::fmax(worst, std::fabs(static_cast<double>(c(i, j) - known(i, j))));
      }
    CHECK(worst < 2 * n * kEps);
  }
}

TEST_CASE("product subtracts what the definition says, for every remainder of the tiling") {
  const std::vector<TestEngine> engines = test_engines();
  for (int32_t m : {0, 1, 2, 3, 5, 7, 15, 16, 17, 31, 33, 63, 65, 127, 129, 259}) {
    for (int32_t n : {0, 1, 4, 7, 9, 16, 17, 33}) {
      for (int32_t k : {0, 1, 2, 5, 63, 65, 130}) {
        Matrix a = random_matrix(m, k, 1, 3), b = random_matrix(k, n, 2, 1), c = random_matrix(m, n, 3, 2);
        Matrix exact = c;
        for (int32_t j = 0; j < n; ++j) {
          for (int32_t i = 0; i < m; ++i) {
            long double sum = c(i, j);
            for (int32_t p = 0; p < k; ++p) sum -= static_cast<long double>(a(i, p)) * b(p, j);
            exact(i, j) = static_cast<Real>(sum);
          }
        }
        for (const TestEngine& e : engines) {
          Matrix d = c;
          {
            Traps traps;
            gemm_minus(e.engine, m, n, k, a.data(), a.ld, b.data(), b.ld, d.data(), d.ld);
          }
          double worst = 0;
          bool kept = true;
          for (int32_t j = 0; j < n; ++j) {
            for (int32_t i = 0; i < m; ++i) worst = std::fmax(worst, std::fabs(static_cast<double>(exact(i, j) - d(i, j))));
            for (int64_t g = m; g < d.ld; ++g) kept = kept && d(static_cast<int32_t>(g), j) == Real(-77);
          }
          INFO(e.name, " m ", m, " n ", n, " k ", k);
          CHECK(kept);
          CHECK(worst <= (k + 1) * kEps * (k + 1)); // |a b| <= 1: the usual bound for a sum of k + 1 terms
        }
      }
    }
  }
}

TEST_CASE("an update is a triangular solve and a product, and writes nowhere else") {
  for (const TestEngine& e : test_engines()) {
    for (int32_t w : {0, 1, 2, 3, 5, 16, 31, 33, 127, 129, 150}) {
      for (int32_t m : {0, 1, 7, 25, 64}) {
        for (int32_t n : {1, 3, 8, 17, 40}) {
          if (w > 33 && (m + n) % (w > 129 ? 5 : 3) != 0 && !test::in_full()) continue;
          Matrix l = random_matrix(w + m, w, 51, 2), x = random_matrix(w + m, n, 52, 3), y = x;
          for (Real& entry : l.a) entry /= static_cast<Real>(w + 1); // well conditioned
          {
            Traps traps;
            update_by(e.engine, w, m, n, l.data(), l.ld, y.data(), y.ld);
          }
          double worst = 0;
          bool kept = true;
          for (int32_t j = 0; j < n; ++j) {
            for (int32_t i = 0; i < w + m; ++i) {
              long double sum = y(i, j);
              for (int32_t p = 0; p < w && p < i; ++p) sum += static_cast<long double>(l(i, p)) * y(p, j);
              worst = std::fmax(worst, std::fabs(static_cast<double>(sum - x(i, j))));
            }
            for (int64_t g = w + m; g < y.ld; ++g) kept = kept && y(static_cast<int32_t>(g), j) == Real(-77);
          }
          INFO(e.name, " w ", w, " m ", m, " n ", n);
          CHECK(kept);
          CHECK(worst <= 10 * (w + 1) * kEps);
        }
      }
    }
  }
}

TEST_CASE("triangular solves reproduce the right-hand side") {
  const std::vector<TestEngine> engines = test_engines();
  for (int32_t n : {0, 1, 2, 5, 31, 32, 33, 100, 129, 300}) {
    for (int32_t nrhs : {0, 1, 3, 8, 21}) {
      Matrix t = random_matrix(n, n, 5), b = random_matrix(n, nrhs, 6, 1);
      for (int32_t j = 0; j < n; ++j) {
        for (int32_t i = 0; i < n; ++i) t(i, j) = i == j ? t(i, j) + 3 : t(i, j) / static_cast<Real>(n);
      }
      for (const TestEngine& e : engines) {
        Matrix x = b, y = b;
        update_by(e.engine, n, 0, nrhs, t.data(), t.ld, x.data(), x.ld);
        trsm_upper(e.engine, n, nrhs, t.data(), t.ld, y.data(), y.ld);
        double worst = 0;
        for (int32_t j = 0; j < nrhs; ++j) {
          for (int32_t i = 0; i < n; ++i) {
            long double low = x(i, j), up = 0;
            for (int32_t k = 0; k < i; ++k) low += static_cast<long double>(t(i, k)) * x(k, j);
            for (int32_t k = i; k < n; ++k) up += static_cast<long double>(t(i, k)) * y(k, j);
            worst = std::fmax(worst, std::fabs(static_cast<double>(low - b(i, j))));
            worst = std::fmax(worst, std::fabs(static_cast<double>(up - b(i, j))));
          }
        }
        INFO(e.name, " n ", n, " right-hand sides ", nrhs);
        CHECK(worst <= 10 * (n + 1) * kEps);
      }
    }
  }
}

TEST_CASE("LU residual ratio for many sizes, and for panels of many widths") {
  for (const TestEngine& e : test_engines()) {
    for (int32_t n : {0, 1, 2, 3, 5, 7, 15, 16, 17, 31, 33, 63, 65, 127, 129, 200, 257, 270}) {
      for (int32_t width : {1, 3, 20, 140, n}) {
        if (width > n || (n > 129 && width != 20 && !test::in_full())) continue;
        INFO(e.name, " n ", n, " width ", width);
        Matrix a = random_matrix(n, width, static_cast<uint32_t>(n + 7)), lu = a;
        std::vector<int32_t> pivots(static_cast<size_t>(n) + 1);
        PivotStats stats;
        start_stats(stats);
        std::vector<Real> norms(static_cast<size_t>(width) + 1);
        for (int32_t j = 0; j < width; ++j) norms[static_cast<size_t>(j)] = largest(kPlainEngine, n, &a(0, j));
        CHECK(lu_panel({e.engine, n, width, width, lu.data(), lu.ld, pivots.data(), norms.data(), &stats}) == 0);
        lu_settle(n, width, lu.data(), lu.ld, pivots.data());
        CHECK(lu_residual(a, lu, pivots) < 30);
        CHECK(stats.unusable == 0);
        for (int32_t j = 0; j < width; ++j) {
          for (int32_t i = j + 1; i < n; ++i) REQUIRE(std::fabs(lu(i, j)) <= 1); // partial pivoting
        }
      }
    }
  }
}

namespace {

void check_columns_without_pivot(std::initializer_list<int32_t> sizes) {
  for (const TestEngine& e : test_engines()) {
    for (const int32_t n : sizes) {
      for (int32_t which = 0; which < 4; ++which) { // the first, the last, or every second column is zero
        Matrix a = random_matrix(n, n, 11);
        int32_t zero = 0, first = -1;
        for (int32_t j = 0; j < n; ++j) {
          if (!(which == 0 ? j == 0 : which == 1 ? j == n - 1 : j % 2 == which % 2)) continue;
          if (first < 0) first = j;
          ++zero;
          for (int32_t i = 0; i < n; ++i) a(i, j) = 0;
        }
        Matrix lu = a, b = random_matrix(n, 2, 12);
        std::vector<int32_t> pivots(static_cast<size_t>(n));
        PivotStats stats;
        {
          Traps traps;
          CHECK(factor(e.engine, lu, pivots, &stats) == zero);
          lu_solve(e.engine, n, 2, lu.data(), lu.ld, pivots.data(), b.data(), b.ld);
        }
        CHECK(stats.unusable == zero);
        CHECK(stats.first_unusable == first);
        lu_settle(n, n, lu.data(), lu.ld, pivots.data());
        CHECK(lu_residual(a, lu, pivots) < 30);
      }
    }
  }
}

} // namespace

TEST_CASE("columns without a pivot are counted, not divided by, and the factors still multiply to the matrix") {
  check_columns_without_pivot({1, 2, 3, 5, 10, 50});
}
TEST_CASE("columns without a pivot in matrices of many blocks") { check_columns_without_pivot({200}); }

TEST_CASE("a column too small to divide by is emptied, so that later divisions cannot overflow") {
  const int32_t n = 40, tiny = 20;
  Matrix a = random_matrix(n, n, 13), b = random_matrix(n, 1, 14);
  for (int32_t i = 0; i < n; ++i) a(i, tiny) *= std::numeric_limits<Real>::min() / 4; // subnormal
  std::vector<int32_t> pivots(n);
  PivotStats stats;
  {
    Traps traps;
    CHECK(factor(best_engine().engine, a, pivots, &stats) == 1);
    lu_solve(best_engine().engine, n, 1, a.data(), a.ld, pivots.data(), b.data(), b.ld);
  }
  CHECK(stats.first_unusable == tiny);
  CHECK(pivots[tiny] == tiny);
  for (int32_t i = tiny; i < n; ++i) CHECK(a(i, tiny) == 0);
  for (int32_t i = 0; i < n; ++i) CHECK(std::isfinite(b(i, 0)));
}

TEST_CASE("a pivot whose reciprocal would lose digits is divided by") {
  const Real most = std::numeric_limits<Real>::max() / 2;
  Matrix a = random_matrix(5, 1, 3);
  const Real parts[5] = {Real(0.375), -1, Real(0.1), Real(0.7), Real(-0.5)};
  for (int32_t i = 0; i < 5; ++i) a(i, 0) = parts[i] * most;
  int32_t pivot = -1;
  Real norm = most;
  PivotStats stats;
  start_stats(stats);
  CHECK(lu_panel({best_engine().engine, 5, 1, 1, a.data(), a.ld, &pivot, &norm, &stats}) == 0);
  CHECK(pivot == 1);
  const Real left[5] = {-most, Real(-0.375), Real(-0.1), Real(-0.7), Real(0.5)};
  for (int32_t i = 0; i < 5; ++i)
    CHECK(std::fabs(a(i, 0) - left[i]) <= std::fabs(left[i]) * std::numeric_limits<Real>::epsilon());
}

TEST_CASE("columns of wildly different scale neither trap nor spoil the judgement of pivots") {
  const int32_t n = 60;
  const double span = sizeof(Real) == 8 ? 280 : 30;
  Matrix a = random_matrix(n, n, 21), scaled = a;
  for (int32_t j = 0; j < n; ++j) {
    const double scale = std::pow(10.0, span * (2.0 * j / (n - 1) - 1));
    for (int32_t i = 0; i < n; ++i) scaled(i, j) = static_cast<Real>(a(i, j) * scale);
  }
  std::vector<int32_t> pivots(n), scaled_pivots(n);
  PivotStats stats, scaled_stats;
  {
    Traps traps;
    factor(best_engine().engine, a, pivots, &stats);
    CHECK(factor(best_engine().engine, scaled, scaled_pivots, &scaled_stats) == 0);
  }
  CHECK(pivots == scaled_pivots);
  CHECK(stats.smallest_column == scaled_stats.smallest_column);
  CHECK(scaled_stats.smallest_ratio == doctest::Approx(stats.smallest_ratio).epsilon(1e4 * kEps));
  CHECK(scaled_stats.growth == doctest::Approx(stats.growth).epsilon(1e4 * kEps));
}

TEST_CASE("pivot growth of Wilkinson's matrix is 2^(n-1)") {
  const int32_t n = 40;
  Matrix a(n, n);
  for (int32_t j = 0; j < n; ++j) {
    for (int32_t i = 0; i < n; ++i) a(i, j) = i == j || j == n - 1 ? Real(1) : i > j ? Real(-1) : Real(0);
  }
  std::vector<int32_t> pivots(n);
  PivotStats stats;
  CHECK(factor(best_engine().engine, a, pivots, &stats) == 0);
  CHECK(stats.growth == std::pow(2.0, n - 1));
  CHECK(stats.largest_ratio == std::pow(2.0, n - 1));
  CHECK(stats.smallest_ratio == 1);
}

TEST_CASE("a nearly dependent column is named with the size of its pivot") {
  const int32_t n = 90, bad = 70;
  const double distance = 1e-4;
  Matrix a = random_matrix(n, n, 31);
  for (int32_t i = 0; i < n; ++i) {
    a(i, bad) = a(i, 3) + a(i, 64) + static_cast<Real>(i == 17 ? distance : 0);
  }
  std::vector<int32_t> pivots(n);
  PivotStats stats;
  CHECK(factor(best_engine().engine, a, pivots, &stats) == 0);
  CHECK(stats.smallest_column == bad);
  CHECK(stats.smallest_ratio < 10 * distance);
  CHECK(stats.smallest_ratio > 0.01 * distance);
}

TEST_CASE("solutions satisfy the equations") {
  for (int32_t n : {0, 1, 2, 33, 150}) {
    Matrix a = random_matrix(n, n, 41), lu = a, x = random_matrix(n, 5, 42, 4), b = x;
    std::vector<int32_t> pivots(static_cast<size_t>(n) + 1);
    factor(best_engine().engine, lu, pivots, nullptr);
    lu_solve(best_engine().engine, n, 5, lu.data(), lu.ld, pivots.data(), x.data(), x.ld);
    gemm_minus(kPlainEngine, n, 5, n, a.data(), a.ld, x.data(), x.ld, b.data(), b.ld);
    double residual = 0;
    for (int32_t j = 0; j < 5; ++j) {
      for (int32_t i = 0; i < n; ++i) residual = std::fmax(residual, std::fabs(static_cast<double>(b(i, j))));
    }
    CHECK(residual <= 30 * (n + 1) * kEps * norm1(a) * std::fmax(1.0, norm1(x)));
  }
}

TEST_CASE("after an exchange the same y and z still satisfy the tableau") {
  const int32_t rows = 9, cols = 12; // 3 columns beyond the square part
  for (int32_t r = 0; r < rows; ++r) {
    for (int32_t c : {0, 4, 8}) {
      Matrix t = random_matrix(rows, cols, static_cast<uint32_t>(100 + r), 2);
      t(r, c) = Real(0.7);
      t(r, 1) = c == 1 ? t(r, 1) : Real(0);
      const Matrix before = t;
      std::vector<double> z(cols), y(rows, 0.0);
      for (int32_t j = 0; j < cols; ++j) z[static_cast<size_t>(j)] = std::sin(1.0 + j);
      for (int32_t i = 0; i < rows; ++i) {
        for (int32_t j = 0; j < cols; ++j) y[static_cast<size_t>(i)] += double(t(i, j)) * z[static_cast<size_t>(j)];
      }
      REQUIRE(exchange(rows, cols, t.data(), t.ld, r, c));
      std::swap(y[static_cast<size_t>(r)], z[static_cast<size_t>(c)]);
      double worst = 0;
      for (int32_t i = 0; i < rows; ++i) {
        double sum = 0;
        for (int32_t j = 0; j < cols; ++j) sum += double(t(i, j)) * z[static_cast<size_t>(j)];
        worst = std::fmax(worst, std::fabs(sum - y[static_cast<size_t>(i)]));
      }
      CHECK(worst < 200 * kEps);
      REQUIRE(exchange(rows, cols, t.data(), t.ld, r, c));
      for (int32_t j = 0; j < cols; ++j) {
        for (int32_t i = 0; i < rows; ++i) worst = std::fmax(worst, std::fabs(double(t(i, j)) - double(before(i, j))));
        for (int64_t g = rows; g < t.ld; ++g) CHECK(t(static_cast<int32_t>(g), j) == Real(-77));
      }
      CHECK(worst < 200 * kEps);
    }
  }
}

TEST_CASE("an exchange on a zero entry is refused and changes nothing") {
  Matrix t = random_matrix(3, 4, 5);
  t(1, 2) = 0;
  const Matrix before = t;
  Traps traps;
  CHECK_FALSE(exchange(3, 4, t.data(), t.ld, 1, 2));
  CHECK(t.a == before.a);
}

TEST_CASE("row and column operations replace y and z as they say") {
  Matrix t = random_matrix(4, 5, 9, 1);
  const Matrix before = t;
  row_add(5, t.data(), t.ld, 2, 0, Real(0.25));
  column_add(4, t.data(), t.ld, 1, 3, Real(-0.5));
  std::vector<double> z = {0.3, -0.9, 0.8, 0.1, 0.6};
  std::vector<double> changed = z;
  changed[3] += 0.5 * z[1]; // z_source - factor z_target
  for (int32_t i = 0; i < 4; ++i) {
    double y = 0, y0 = 0, now = 0;
    for (int32_t j = 0; j < 5; ++j) {
      y += double(before(i, j)) * z[static_cast<size_t>(j)];
      y0 += double(before(0, j)) * z[static_cast<size_t>(j)];
      now += double(t(i, j)) * changed[static_cast<size_t>(j)];
    }
    CHECK(std::fabs(now - (i == 2 ? y + 0.25 * y0 : y)) < 50 * kEps);
  }
}

TEST_CASE("many vectors are made orthonormal, with what made them so") {
  for (const auto& size : {std::pair<int32_t, int32_t>{90, 1}, {90, 16}, {90, 17}, {90, 45}, {90, 64}, {30, 20}}) {
    const int32_t n = size.first, count = size.second;
    CAPTURE(n);
    CAPTURE(count);
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto at = [](const std::vector<Real>& a, int32_t rows, int32_t i, int32_t j) {
      return static_cast<double>(a[static_cast<size_t>(i + j * rows)]);
    };
    std::vector<Real> given(static_cast<size_t>(n * count)), mix(static_cast<size_t>(count * count)),
        scratch(static_cast<size_t>(n * n));
    for (Real& x : given) x = static_cast<Real>(1e3 * (1 + 0.1 * uniform(generator))); // nearly parallel
    for (int32_t j = 0; j < count; ++j) mix[static_cast<size_t>(j * (count + 1))] = 1;
    std::vector<Real> x = given;
    CHECK(orthonormalise(kPlainEngine, n, count, x.data(), count, mix.data(), scratch.data()));
    const double eps = static_cast<double>(std::numeric_limits<Real>::epsilon());
    double off = 0, off_mix = 0;
    for (int32_t j = 0; j < count; ++j) {
      for (int32_t k = 0; k < count; ++k)
        off = std::max(off, std::fabs(product(&x[static_cast<size_t>(j * n)], &x[static_cast<size_t>(k * n)], n) - (j == k)));
      for (int32_t i = 0; i < n; ++i) {
        double sum = 0;
        for (int32_t k = 0; k < count; ++k) sum += at(given, n, i, k) * at(mix, count, k, j);
        off_mix = std::max(off_mix, std::fabs(sum - at(x, n, i, j)));
      }
    }
    CHECK(off < 10 * eps);
    CHECK(off_mix < 1e4 * eps);
    if (count < 2) continue;
    x = given; // the last is the sum of the first and the one before it
    for (int32_t i = 0; i < n; ++i)
      x[static_cast<size_t>(i + (count - 1) * n)] = x[static_cast<size_t>(i)] + x[static_cast<size_t>(i + (count - 2) * n)];
    CHECK(!orthonormalise(kPlainEngine, n, count, x.data(), 0, nullptr, scratch.data()));
  }
}

TEST_CASE("a vector of zeros has no direction, and stays what it is") {
  std::vector<Real> x = {3, 4, 0, 0, 0, 0, 0, 0, 2}, mix = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  CHECK(!orthonormalise(3, 3, x.data(), 3, mix.data()));
  const double expected[] = {0.6, 0.8, 0, 0, 0, 0, 0, 0, 1}, mixed[] = {0.2, 0, 0, 0, 1, 0, 0, 0, 0.5};
  for (size_t i = 0; i < 9; ++i) {
    CHECK(static_cast<double>(x[i]) == doctest::Approx(expected[i]).epsilon(1e-6));
    CHECK(static_cast<double>(mix[i]) == doctest::Approx(mixed[i]).epsilon(1e-6));
  }
}
