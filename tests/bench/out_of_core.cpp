// The streamed elimination with a part of the memory, blocks in files, against all of it at once.
#include "bench.hpp"
#include "c2d_memory.h"
#include "c2d_posix.h"
#include "elimination/eliminate.hpp"
#include "ours.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <unistd.h>

namespace bench {

namespace {

using c2d::Real;

struct System {
  int32_t n;
  std::vector<Real> a; // and a right-hand side behind the last column
  explicit System(int32_t size) : n(size), a(static_cast<size_t>(size) * static_cast<size_t>(size + 1)) {
    uint32_t seed = 1;
    for (Real& v : a) v = static_cast<Real>((seed = seed * 1664525u + 1013904223u) >> 8) / 8388608 - 1;
  }
  static c2d_status fill(void* context, int32_t first, int32_t count, Real* panel, int64_t ld) {
    const System* m = static_cast<const System*>(context);
    const size_t rows = static_cast<size_t>(m->n);
    for (int32_t j = 0; j < count; ++j)
      std::memcpy(panel + j * ld, m->a.data() + static_cast<size_t>(first + j) * rows, rows * sizeof(Real));
    return C2D_OK;
  }
};

// A plan with its work area and its tapes, in memory or in files of a folder.
class Streamed {
public:
  Streamed(int32_t n, uint64_t bytes, const std::string& folder) : folder_(folder), own_(c2d::best_instructions(), n, 1) {
    if (c2d::plan_elimination(bytes, n, n, 1, 0, plan_, nullptr) != C2D_OK) give_up("no plan for the elimination");
    work_.resize(std::max(c2d::elimination_bytes(plan_), c2d::back_substitution_bytes(plan_)) + 64);
    const c2d::TapeUse lower = c2d::lower_use(plan_), upper = c2d::upper_use(plan_);
    port_ = C2D_INIT(c2d_port);
    if (folder.empty()) {
      const uint64_t block = std::max(lower.max_data_bytes, upper.max_data_bytes);
      region_.resize((lower.blocks + upper.blocks + 2) * (block + c2d::kBlockHeaderBytes + 64) + (1 << 16));
      c2d_memory_store_init(&memory_, region_.data(), region_.size());
      c2d_memory_store_port(&memory_, &port_);
    } else {
      if (c2d_posix_store_init(&files_, folder.c_str()) != 0) give_up("no folder " + folder);
      c2d_posix_store_port(&files_, &port_);
    }
    tapes_.port = &port_;
    tapes_.run_id = 1;
    if (c2d::open_tape(tapes_, C2D_TAPE_LOWER, lower.blocks, lower.max_data_bytes) != C2D_OK ||
        c2d::open_tape(tapes_, C2D_TAPE_UPPER, upper.blocks, upper.max_data_bytes) != C2D_OK)
      give_up("no tapes for the elimination");
  }
  ~Streamed() {
    c2d::close_all(tapes_);
    if (folder_.empty()) return;
    c2d_posix_store_remove(&files_);
    c2d_posix_store_discard(&files_, folder_.c_str());
  }
  Streamed(const Streamed&) = delete;
  Streamed& operator=(const Streamed&) = delete;

  // Seconds by the clock for the elimination and one solution.
  double run(const System& system) {
    const double start = seconds_now();
    unsigned char* work = work_.data() + (64 - reinterpret_cast<uintptr_t>(work_.data()) % 64) % 64;
    const c2d::ColumnSource source = {const_cast<System*>(&system), System::fill};
    std::vector<Real> x(static_cast<size_t>(system.n));
    const Real one = 1;
    for (int t = 0; t < C2D_TAPES; ++t) tapes_.bytes_written[t] = tapes_.bytes_read[t] = 0;
    ++tapes_.run_id;
    if (c2d::eliminate(plan_, source, {nullptr, nullptr}, tapes_, work, nullptr, {nullptr, nullptr}, own_.engine()) != C2D_OK ||
        c2d::back_substitute(plan_, tapes_, &one, x.data(), work) != C2D_OK)
      give_up("elimination failed");
    return seconds_now() - start;
  }
  double bytes_moved() const {
    double sum = 0;
    for (int t = 0; t < C2D_TAPES; ++t) sum += static_cast<double>(tapes_.bytes_written[t] + tapes_.bytes_read[t]);
    return sum;
  }
  double bytes_expected() const {
    const c2d::TapeUse lower = c2d::lower_use(plan_), upper = c2d::upper_use(plan_);
    return static_cast<double>(lower.bytes_written + lower.bytes_read + upper.bytes_written + upper.bytes_read);
  }
  int32_t width() const { return plan_.panel_columns; }

private:
  std::string folder_;
  OwnEngine own_;
  c2d::EliminationPlan plan_ = {};
  std::vector<unsigned char> region_, work_;
  c2d_memory_store memory_ = {};
  c2d_posix_store files_ = {};
  c2d_port port_ = {};
  c2d::Tapes tapes_ = {};
};

void compare(int32_t n, const std::string& folder) {
  const System system(n);
  const uint64_t all = c2d::elimination_bytes_in_core(n, n, 1);
  const int parts[] = {2, 8, 32};
  const int turns = n <= 2000 ? 5 : 3;
  std::vector<double> whole, seconds[3], ratios[3];
  double moved[3] = {}, expected[3] = {};
  int32_t width[3] = {};
  for (int turn = 0; turn < turns; ++turn) { // in turns, so that a slow spell of the machine strikes all
    {
      Streamed in_core(n, all, "");
      in_core.run(system); // the first use of memory is not what is compared
      whole.push_back(in_core.run(system));
    }
    for (int p = 0; p < 3; ++p) {
      Streamed streamed(n, all / static_cast<uint64_t>(parts[p]), folder);
      streamed.run(system);
      seconds[p].push_back(streamed.run(system));
      ratios[p].push_back(seconds[p].back() / whole.back());
      moved[p] = streamed.bytes_moved(), expected[p] = streamed.bytes_expected(), width[p] = streamed.width();
    }
  }
  const std::string name = "out_of_core." + std::to_string(n) + ".";
  const double m = n, matrix = m * m * sizeof(Real);
  row(name + "in_core", median(whole), "s", "all in memory, one thread");
  for (int p = 0; p < 3; ++p) {
    const std::string key = name + "1/" + std::to_string(parts[p]);
    const double figure = parts[p] == 8 && n == 4000 ? 1.15 : parts[p] == 8 && n == 8000 ? 1.05 : 0;
    row(key, median(seconds[p]), "s",
        judged(key + ".ratio", median(ratios[p]), "<=", figure, "of in core, panels of " + std::to_string(width[p])));
    const double most = m / (3.0 * width[p]) + 2.5;
    row(key + ".moved", moved[p] / matrix, "matrices",
        judged(key + ".moved_over_most", moved[p] / matrix / most, "<=", 1,
               std::string("of n/(3w) + 2.5, ") + (moved[p] == expected[p] ? "as the plan says" : "NOT WHAT THE PLAN SAYS")));
  }
}

} // namespace

void out_of_core(const Options& options) {
  const std::string folder = std::filesystem::temp_directory_path() / ("contact2d-bench-tapes-" + std::to_string(getpid()));
  heading("Out of core: elimination and one solution with a part of the memory, blocks in files of " +
          std::filesystem::temp_directory_path().string() + "; seconds by the clock");
  for (const int32_t n : {1000, 2000}) compare(n, folder);
  if (options.large)
    for (const int32_t n : {4000, 8000}) compare(n, folder);
  else
    note("out_of_core.4000, out_of_core.8000", "make bench LARGE=1");
  std::filesystem::remove_all(folder);
}

} // namespace bench
