// The child's side of the comparison of eliminations. Every contender is a process of its own, so that each
// has its own threads, its own memory and its own choice of kernels; all read the same requests and time the
// same work.
//
//   request   time MATRIX N        seconds for one factorisation with one solution, the least of some
//             residual MATRIX N    largest |b - A x| / (n eps |A| |x|), norms of the largest row sum and
//             entry
//   answer    four numbers: wall seconds, processor seconds, peak GFLOP/s (0: not measured), residual
//   MATRIX    random:SEED, graded:SEED, or file:PATH with the N*N numbers
#pragma once

#include <sys/mman.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

namespace rival {

struct Matrix {
  std::vector<double> a, b; // column-major, and a right-hand side
  int32_t n;
};

// What is solved for, in pages of 2 MiB where there are: for all contenders as the program asks for its workspace.
class Work {
public:
  explicit Work(size_t numbers) {
    constexpr size_t kPage = size_t{1} << 21;
    const size_t bytes = numbers * sizeof(double), whole = (bytes + kPage - 1) / kPage * kPage;
    data_ = static_cast<double*>(std::aligned_alloc(kPage, whole));
    if (data_ == nullptr) std::exit(3);
    if (bytes >= kPage) madvise(data_, whole, MADV_HUGEPAGE);
  }
  ~Work() { std::free(data_); }
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;
  double* data() { return data_; }

private:
  double* data_;
};

inline Matrix make_matrix(const std::string& kind, int32_t n) {
  const size_t rows = static_cast<size_t>(n);
  Matrix m = {std::vector<double>(rows * rows), std::vector<double>(rows), n};
  if (kind.compare(0, 5, "file:") == 0) {
    FILE* file = std::fopen(kind.c_str() + 5, "rb");
    const size_t read = file ? std::fread(m.a.data(), sizeof(double), m.a.size(), file) : 0;
    if (file) std::fclose(file);
    if (read != m.a.size()) std::exit(3);
  }
  uint32_t seed = 1 + 2654435761u * static_cast<uint32_t>(std::atoi(kind.c_str() + kind.find(':') + 1));
  const auto next = [&seed] { return ((seed = seed * 1664525u + 1013904223u) >> 8) / 8388608.0 - 1; };
  if (kind[0] != 'f')
    for (double& v : m.a) v = next();
  for (double& v : m.b) v = next();
  if (kind[0] == 'g') // rows and columns from 1 to 1e-4
    for (size_t j = 0; j < rows; ++j)
      for (size_t i = 0; i < rows; ++i)
        m.a[i + j * rows] *= std::pow(10.0, -4.0 * static_cast<double>(i + j) / static_cast<double>(n));
  return m;
}

inline double residual_of(const Matrix& m, const std::vector<double>& x) {
  const size_t n = m.b.size();
  std::vector<long double> r(m.b.begin(), m.b.end());
  std::vector<double> sums(n);
  double largest = 0, most = 0, size = 0;
  for (size_t j = 0; j < n; ++j) {
    for (size_t i = 0; i < n; ++i) {
      r[i] -= static_cast<long double>(m.a[i + j * n]) * x[j];
      sums[i] += std::fabs(m.a[i + j * n]);
    }
    size = std::max(size, std::fabs(x[j]));
  }
  for (size_t i = 0; i < n; ++i) {
    largest = std::max(largest, static_cast<double>(std::fabs(r[i])));
    most = std::max(most, sums[i]);
  }
  return largest / (static_cast<double>(n) * 2.220446049250313e-16 * most * size);
}

inline double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
inline double processor_seconds() {
  timespec now = {};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}
inline double least(const std::vector<double>& values) { return *std::min_element(values.begin(), values.end()); }

// solve(n, a, x): a (column-major) may be overwritten, x is the right-hand side and becomes the solution.
// peak(): GFLOP/s.
template <class Solve, class Peak> int serve(Solve solve, Peak peak) {
  char what[16], kind[600];
  int n = 0;
  Matrix m = {};
  std::string held;
  std::printf("ready\n");
  std::fflush(stdout);
  while (std::scanf("%15s %599s %d", what, kind, &n) == 3) {
    if (held != kind || m.n != n) m = make_matrix(held = kind, n);
    Work a(m.a.size());
    std::vector<double> x, wall, processor;
    const double most = what[0] == 't' ? peak() : 0, start = wall_seconds();
    do {
      std::memcpy(a.data(), m.a.data(), m.a.size() * sizeof(double));
      x = m.b;
      const double w = wall_seconds(), p = processor_seconds();
      solve(n, a.data(), x.data());
      processor.push_back(processor_seconds() - p);
      wall.push_back(wall_seconds() - w);
    } while (what[0] == 't' && wall_seconds() - start < 0.03 && wall.size() < 200);
    std::printf("%.9g %.9g %.9g %.9g\n", least(wall), least(processor), most, what[0] == 'r' ? residual_of(m, x) : 0.0);
    std::fflush(stdout);
  }
  return 0;
}

} // namespace rival
