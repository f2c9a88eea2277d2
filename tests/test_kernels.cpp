// The inner loops in every instruction set that this machine has, against their definitions, at awkward sizes, from any
// place in memory, with traps on; and the factors they lead to against a textbook elimination.
#include "bie/integrals/batch.hpp"
#include "linalg/dense.hpp"
#include "linalg/exchange.hpp"
#include "linalg/lu.hpp"

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
const int32_t kAwkward[] = {0, 1, 2, 3, 5, 7, 8, 15, 16, 17, 31, 33, 63, 65, 127, 129, 193};
const Real kMark = Real(-77); // stands around what may be written

struct Traps {
  Traps() {
    feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
  }
  ~Traps() { fedisableexcept(FE_ALL_EXCEPT); }
};

std::vector<const Kernel*> kernels() {
  std::vector<const Kernel*> all;
  for (int32_t set = 1; set <= static_cast<int32_t>(best_instructions()); ++set)
    if (const Kernel* kernel = kernel_for(static_cast<Instructions>(set))) all.push_back(kernel);
  return all;
}

// `n` numbers from -1 to 1, `shift` numbers away from a line of memory, between marks.
struct Numbers {
  std::vector<Real> room;
  Real* at;
  int64_t n;
  Numbers(int64_t count, int32_t shift, uint32_t seed) : room(static_cast<size_t>(count) + 48, kMark), n(count) {
    const size_t line = 64 / sizeof(Real), past = reinterpret_cast<uintptr_t>(room.data()) / sizeof(Real) % line;
    at = room.data() + (line - past) + static_cast<size_t>(shift);
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int64_t i = 0; i < n; ++i) at[i] = static_cast<Real>(uniform(generator));
  }
  Numbers(const Numbers&) = delete;
  Numbers& operator=(const Numbers&) = delete;
  bool marks_stand() const {
    return std::all_of(room.data(), static_cast<const Real*>(at), [](Real x) { return x == kMark; }) &&
           std::all_of(static_cast<const Real*>(at) + n, room.data() + room.size(), [](Real x) { return x == kMark; });
  }
};

double size(Real x) { return std::fabs(static_cast<double>(x)); }

using Square = std::vector<double>; // column-major, n x n

std::vector<int32_t> textbook(int32_t n, Square& a) {
  const size_t ld = static_cast<size_t>(n);
  std::vector<int32_t> pivots(ld);
  for (size_t j = 0; j < ld; ++j) {
    size_t p = j;
    for (size_t i = j; i < ld; ++i)
      if (std::fabs(a[i + j * ld]) > std::fabs(a[p + j * ld])) p = i;
    pivots[j] = static_cast<int32_t>(p);
    for (size_t c = 0; c < ld; ++c) std::swap(a[j + c * ld], a[p + c * ld]);
    for (size_t i = j + 1; i < ld; ++i) a[i + j * ld] /= a[j + j * ld];
    for (size_t c = j + 1; c < ld; ++c)
      for (size_t i = j + 1; i < ld; ++i) a[i + c * ld] -= a[i + j * ld] * a[j + c * ld];
  }
  return pivots;
}

// norm(b - A x) / (norm(A) norm(x) n eps) for the solution by these factors, in long double.
double scaled_residual(int32_t n, const Square& a, const std::vector<double>& x, const std::vector<double>& b) {
  const size_t ld = static_cast<size_t>(n);
  long double most = 0, norm = 0, norm_x = 0;
  for (size_t i = 0; i < ld; ++i) {
    long double r = b[i], row = 0;
    for (size_t j = 0; j < ld; ++j) {
      r -= static_cast<long double>(a[i + j * ld]) * x[j];
      row += std::fabs(a[i + j * ld]);
    }
    most = std::max(most, std::fabs(r));
    norm = std::max(norm, row);
    norm_x = std::max(norm_x, static_cast<long double>(std::fabs(x[i])));
  }
  return static_cast<double>(most / (norm * norm_x * static_cast<long double>(n) * static_cast<long double>(kEps)));
}

double textbook_residual(int32_t n, const Square& a, const std::vector<double>& b) {
  const size_t ld = static_cast<size_t>(n);
  Square lu = a;
  const std::vector<int32_t> pivots = textbook(n, lu);
  std::vector<double> x = b;
  for (size_t j = 0; j < ld; ++j) std::swap(x[j], x[static_cast<size_t>(pivots[j])]);
  for (size_t j = 0; j < ld; ++j)
    for (size_t i = j + 1; i < ld; ++i) x[i] -= lu[i + j * ld] * x[j];
  for (size_t j = ld; j-- > 0;) {
    x[j] /= lu[j + j * ld];
    for (size_t i = 0; i < j; ++i) x[i] -= lu[i + j * ld] * x[j];
  }
  return scaled_residual(n, a, x, b);
}

double our_residual(const Kernel* kernel, int32_t n, const Square& a, const std::vector<double>& b) {
  std::vector<Real> lu(a.begin(), a.end()), y(b.begin(), b.end()), norms(static_cast<size_t>(n));
  std::vector<Real> scratch(static_cast<size_t>(full_scratch(n, n)) + 16);
  std::vector<int32_t> pivots(static_cast<size_t>(n));
  const Engine engine = {kernel, scratch.data(), full_scratch(n, n), nullptr};
  CHECK(lu_factor(engine, n, lu.data(), n, pivots.data(), norms.data(), nullptr) == 0);
  lu_solve(engine, n, 1, lu.data(), n, pivots.data(), y.data(), n);
  return scaled_residual(n, a, std::vector<double>(y.begin(), y.end()), b);
}

// A boundary integral operator as they look: logarithms of distances on a closed curve, and a jump on the diagonal.
double boundary_entry(int32_t n, int32_t i, int32_t j) {
  const double s = 6.283185307179586 * i / n, t = 6.283185307179586 * j / n;
  if (i == j) return 0.5;
  const double dx = 2 * (std::cos(s) - std::cos(t)), dy = std::sin(s) - std::sin(t);
  return -std::log(dx * dx + dy * dy) / n;
}

} // namespace

TEST_CASE("kernels: a column is updated and searched as its definition says") {
  for (const Kernel* kernel : kernels()) {
    for (int32_t m : kAwkward) {
      for (int32_t k : {0, 1, 2, 15, 16}) {
        for (int32_t shift : {0, 1, 5, 7}) {
          const int64_t ld = m + 3;
          Numbers l(ld * k + 1, shift, 1), u(k, 0, 2), x(m, shift, 3);
          std::vector<long double> expected(static_cast<size_t>(m));
          for (int32_t i = 0; i < m; ++i) {
            long double& sum = expected[static_cast<size_t>(i)] = x.at[i];
            for (int32_t p = 0; p < k; ++p) sum -= static_cast<long double>(l.at[i + p * ld]) * u.at[p];
          }
          int32_t row;
          {
            Traps traps;
            row = kernel->column(m, k, l.at, ld, u.at, x.at);
          }
          INFO("tile of ", kernel->rows, " rows, m ", m, " k ", k, " shift ", shift);
          CHECK(x.marks_stand());
          int32_t first = -1;
          for (int32_t i = 0; i < m; ++i) {
            CHECK(std::fabs(static_cast<double>(x.at[i] - expected[static_cast<size_t>(i)])) <= (k + 1) * kEps * (k + 1));
            if (first < 0 ? size(x.at[i]) > 0 : size(x.at[i]) > size(x.at[first])) first = i;
          }
          CHECK(row == first);
        }
      }
    }
  }
}

TEST_CASE("kernels: of equal largest entries the first is found, of zeros none") {
  for (const Kernel* kernel : kernels()) {
    for (int32_t m : kAwkward) {
      for (int32_t shift : {0, 3}) {
        Numbers x(m, shift, 4);
        std::fill(x.at, x.at + m, Real(0));
        CHECK(kernel->column(m, 0, nullptr, 1, nullptr, x.at) == -1);
        for (int32_t first = 0; first < m; first += 1 + m / 9) {
          std::fill(x.at, x.at + m, Real(0.25));
          for (int32_t i = first; i < m; i += 3) x.at[i] = (i - first) % 2 == 0 ? Real(-2) : Real(2);
          CHECK(kernel->column(m, 0, nullptr, 1, nullptr, x.at) == first);
        }
      }
    }
  }
}

TEST_CASE("kernels: scaling, adding and the largest entry") {
  for (const Kernel* kernel : kernels()) {
    for (int32_t n : kAwkward) {
      for (int32_t shift : {0, 1, 6}) {
        Numbers x(n, shift, 5), y(n, shift, 6);
        const std::vector<Real> x0(x.at, x.at + n), y0(y.at, y.at + n);
        Real most;
        {
          Traps traps;
          kernel->scale(n, Real(-1.75), x.at);
          kernel->add(n, Real(0.3), x.at, y.at);
          most = kernel->largest(n, x.at);
        }
        CHECK(x.marks_stand());
        CHECK(y.marks_stand());
        Real expected = 0;
        for (int32_t i = 0; i < n; ++i) {
          const size_t at = static_cast<size_t>(i);
          CHECK(x.at[i] == x0[at] * Real(-1.75));
          CHECK(std::fabs(static_cast<double>(y.at[i] - (static_cast<long double>(Real(0.3)) * x.at[i] + y0[at]))) <= 2 * kEps);
          expected = std::max(expected, static_cast<Real>(size(x.at[i])));
        }
        CHECK(most == expected);
      }
    }
  }
}

TEST_CASE("kernels: columns become rows and columns again, and slices are copied") {
  for (const Kernel* kernel : kernels()) {
    for (int32_t k : kAwkward) {
      for (int32_t shift : {0, 3}) {
        const int64_t ld = k + 2;
        const int32_t cols = kernel->cols, rows = kernel->rows;
        Numbers b(ld * cols, shift, 7), packed(static_cast<int64_t>(k) * cols, 0, 8), back(ld * cols, shift, 9);
        Numbers a(static_cast<int64_t>(rows + 1) * k, shift, 10), slice(static_cast<int64_t>(rows) * k, 0, 11);
        {
          Traps traps;
          kernel->to_rows(k, b.at, ld, packed.at);
          kernel->from_rows(k, packed.at, back.at, ld);
          kernel->pack(k, a.at, rows + 1, slice.at);
        }
        CHECK(packed.marks_stand());
        CHECK(back.marks_stand());
        CHECK(slice.marks_stand());
        for (int32_t j = 0; j < cols; ++j) {
          for (int32_t i = 0; i < k; ++i) {
            CHECK(packed.at[static_cast<int64_t>(i) * cols + j] == b.at[i + j * ld]);
            CHECK(back.at[i + j * ld] == b.at[i + j * ld]);
          }
        }
        for (int32_t p = 0; p < k; ++p) {
          for (int32_t i = 0; i < rows; ++i) CHECK(slice.at[p * rows + i] == a.at[p * (rows + 1) + i]);
        }
      }
    }
  }
}

TEST_CASE("kernels: triangles solve their own products") {
  for (const Kernel* kernel : kernels()) {
    for (int32_t n : kAwkward) {
      const int32_t cols = kernel->cols;
      const int64_t ld = n + 1;
      Numbers t(ld * n + 1, 0, 12), x(static_cast<int64_t>(n) * cols, 0, 13), low(x.n, 0, 13), up(x.n, 0, 13);
      for (int32_t j = 0; j < n; ++j) {
        for (int32_t i = 0; i < n; ++i) t.at[i + j * ld] = i == j ? t.at[i + j * ld] + 3 : t.at[i + j * ld] / Real(n);
      }
      {
        Traps traps;
        kernel->solve(n, t.at, ld, low.at);
        kernel->solve_upper(n, t.at, ld, up.at);
      }
      CHECK(low.marks_stand());
      CHECK(up.marks_stand());
      for (int32_t i = 0; i < n; ++i) {
        for (int32_t c = 0; c < cols; ++c) {
          long double l = low.at[i * cols + c], u = 0;
          for (int32_t p = 0; p < i; ++p) l += static_cast<long double>(t.at[i + p * ld]) * low.at[p * cols + c];
          for (int32_t p = i; p < n; ++p) u += static_cast<long double>(t.at[i + p * ld]) * up.at[p * cols + c];
          CHECK(std::fabs(static_cast<double>(l - x.at[i * cols + c])) <= 10 * (n + 1) * kEps);
          CHECK(std::fabs(static_cast<double>(u - x.at[i * cols + c])) <= 10 * (n + 1) * kEps);
        }
      }
    }
  }
}

TEST_CASE("kernels: where the diagonal of a triangle is zero the row of the solution is zero, and nothing traps") {
  for (const Kernel* kernel : kernels()) {
    const int32_t n = 9, cols = kernel->cols;
    Numbers t(n * n, 0, 21), x(static_cast<int64_t>(n) * cols, 0, 22);
    for (int32_t j : {0, 4, n - 1}) t.at[j + j * n] = 0;
    {
      Traps traps;
      kernel->solve_upper(n, t.at, n, x.at);
    }
    CHECK(x.marks_stand());
    for (int32_t c = 0; c < cols; ++c) {
      for (int32_t j : {0, 4, n - 1}) CHECK(x.at[j * cols + c] == 0);
      CHECK(x.at[(n - 2) * cols + c] != 0);
    }
  }
}

TEST_CASE("kernels: an exchange is the plain one to the last digits") {
  for (const Kernel* kernel : kernels()) {
    for (int32_t n : {1, 2, 3, 7, 16, 33, 129}) {
      const int64_t size_of_all = static_cast<int64_t>(n) * (n + 2);
      Numbers plain(size_of_all, 1, 14), fast(size_of_all, 1, 14);
      const int32_t r = n / 2;
      plain.at[r + r * n] = fast.at[r + r * n] = Real(1.5);
      REQUIRE(exchange(n, n + 2, plain.at, n, r, r));
      {
        Traps traps;
        REQUIRE(exchange(n, n + 2, fast.at, n, r, r, kernel));
      }
      CHECK(fast.marks_stand());
      for (int64_t i = 0; i < size_of_all; ++i) CHECK(size(plain.at[i] - fast.at[i]) <= 4 * kEps);
      // Two at once are two, one after the other.
      const int32_t q = n / 3;
      if (q == r || n < 2) continue;
      Numbers one(size_of_all, 1, 15), two(size_of_all, 1, 15), both(size_of_all, 1, 15);
      for (Numbers* each : {&one, &two, &both}) each->at[r + r * n] = each->at[q + q * n] = Real(2.5);
      REQUIRE(exchange(n, n + 2, one.at, n, r, r));
      REQUIRE(exchange(n, n + 2, one.at, n, q, q));
      {
        Traps traps;
        REQUIRE(exchange_two(n, n + 2, two.at, n, r, q));
        REQUIRE(exchange_two(n, n + 2, both.at, n, r, q, kernel));
      }
      CHECK(both.marks_stand());
      for (int64_t i = 0; i < size_of_all; ++i) {
        CHECK(size(one.at[i] - two.at[i]) <= 16 * kEps);
        CHECK(size(one.at[i] - both.at[i]) <= 16 * kEps);
      }
    }
  }
}

TEST_CASE("kernels: residuals are at most twice those of a textbook elimination, for random, graded and boundary matrices") {
  // The largest of several right-hand sides and sizes on each side: single ones scatter.
  for (int kind = 0; kind < 3; ++kind) {
    std::vector<const Kernel*> forms = kernels();
    forms.push_back(nullptr);
    std::vector<double> ours(forms.size(), 0.0);
    double theirs = 0.0;
    for (int32_t n : {33, 129, 260}) {
      std::mt19937 generator(static_cast<uint32_t>(100 * kind + n));
      std::uniform_real_distribution<double> uniform(-1, 1);
      const size_t ld = static_cast<size_t>(n);
      Square a(ld * ld);
      for (int32_t j = 0; j < n; ++j) {
        for (int32_t i = 0; i < n; ++i) {
          double& entry = a[static_cast<size_t>(i) + static_cast<size_t>(j) * ld];
          entry = kind == 2 ? boundary_entry(n, i, j) : uniform(generator);
          if (kind == 1) entry *= std::pow(10.0, -6.0 * (i + j) / n);
          entry = static_cast<double>(static_cast<Real>(entry));
        }
      }
      for (int turn = 0; turn < 4; ++turn) {
        std::vector<double> b(ld);
        for (double& each : b) each = static_cast<double>(static_cast<Real>(uniform(generator)));
        // With stored numbers of single precision the textbook's double is no measure: 1 is what is expected of any.
        theirs = std::max(theirs, sizeof(Real) == 8 ? textbook_residual(n, a, b) : 0.5);
        for (size_t f = 0; f < forms.size(); ++f) ours[f] = std::max(ours[f], our_residual(forms[f], n, a, b));
      }
    }
    for (size_t f = 0; f < forms.size(); ++f)
      CHECK_MESSAGE(ours[f] <= 2 * theirs, "kind " << kind << " form " << f << ": " << ours[f] << ", textbook " << theirs);
  }
}

TEST_CASE("kernels: the set of instructions is what the processor has and the operating system keeps registers for") {
  const uint32_t fma = 1u << 12, asks = 1u << 27, avx2 = 1u << 5, avx512 = 1u << 16, both = avx2 | avx512;
  struct {
    ProcessorSays says;
    Instructions best;
  } const cases[] = {{{0, 0, 0}, Instructions::baseline},
                     {{asks, both, 0xe7}, Instructions::baseline}, // no fused additions
                     {{fma, both, 0xe7}, Instructions::baseline},  // nobody knows what is kept
                     {{fma | asks, 0, 0xe7}, Instructions::baseline},
                     {{fma | asks, avx2, 0x03}, Instructions::baseline},
                     {{fma | asks, avx2, 0x07}, Instructions::avx2},
                     {{fma | asks, both, 0x07}, Instructions::avx2}, // the widest registers are not kept
                     {{fma | asks, both, 0xe7}, Instructions::avx512},
                     {{fma | asks, avx512, 0xe7}, Instructions::avx512},
                     {{fma | asks, avx512, 0x07}, Instructions::baseline}};
  for (const auto& one : cases) {
    CAPTURE(one.says.more_features);
    CAPTURE(one.says.kept);
    CHECK(instructions_of(one.says) == one.best);
  }
}

TEST_CASE("kernels: a build without the best set takes the next, and the plain forms where it has none") {
  static const Kernel kernel = {};
  CHECK(best_there(Instructions::avx512, [](Instructions) { return &kernel; }) == Instructions::avx512);
  CHECK(best_there(Instructions::avx512, [](Instructions set) -> const Kernel* {
          return set == Instructions::baseline ? &kernel : nullptr;
        }) == Instructions::baseline);
  CHECK(best_there(Instructions::avx2, [](Instructions) -> const Kernel* { return nullptr; }) == Instructions::plain);
  CHECK(kernel_for(Instructions::plain) == nullptr);
}

TEST_CASE("kernels: each set of instructions that this build has, for numbers and for integrals, and none for plain code") {
  CHECK((kernel_for(Instructions::plain) == nullptr));
  CHECK((batch_for(Instructions::plain) == nullptr));
  for (const Instructions set : {Instructions::baseline, Instructions::avx2, Instructions::avx512}) {
    CAPTURE(static_cast<int>(set));
    CHECK((kernel_for(set) == nullptr) == (batch_for(set) == nullptr));
    for (const Instructions other : {Instructions::baseline, Instructions::avx2, Instructions::avx512})
      if (other != set && kernel_for(set) != nullptr) CHECK((kernel_for(set) != kernel_for(other)));
  }
  CHECK((kernel_for(best_instructions()) == nullptr) == (best_instructions() == Instructions::plain));
}
