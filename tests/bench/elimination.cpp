// Elimination with one solution against the libraries that people would have linked, and against the loops of
// 1987.
#include "bench.hpp"
#include "children.hpp"
#include "ours.hpp"

#include <cstdio>
#include <memory>
#include <unistd.h>

namespace bench {

namespace {

using c2d::Instructions;

struct Contender {
  std::string name;   // in the table
  std::string absent; // why it is not here; empty: it is
  bool own, slow;     // slow: measured once where it takes seconds, and not at all where it takes minutes
  int threads;
  std::unique_ptr<Child> child;
  std::vector<Answer> answers;
};

const std::string kForget = "OPENBLAS_CORETYPE=";

class Field {
public:
  explicit Field(const Options& options) : options_(options) {
    for (int threads = 1; threads <= 2; ++threads) {
      for (int set = 3; set >= 1; --set) add_own(static_cast<Instructions>(set), threads);
      add_openblas("openblas", kForget, threads);
    }
    if (!options.openblas.empty()) {
      best_core_ = best_core();
      for (int threads = 1; threads <= 2; ++threads) add_openblas("openblas_best", "OPENBLAS_CORETYPE=" + best_core_, threads);
    }
    add("eigen", {options.folder + "/rival_eigen"}, {}, false, 1);
    add("eigen_native", {options.folder + "/rival_eigen_native"}, {}, false, 1);
    const bool lapack = !options.lapack.empty();
    add("lapack", {lapack ? options.folder + "/rival_lapack" : "", options.blas, options.lapack}, {}, true, 1);
    add("rows_c", {options.folder + "/rival_rows"}, {}, true, 1);
    add("rows_fortran", {options.folder + "/rival_rows_fortran"}, {}, true, 1);
  }
  std::vector<Contender>& all() { return all_; }
  const std::string& best_core_name() const { return best_core_; }

private:
  void add(const std::string& name, const std::vector<std::string>& words, const std::vector<std::string>& environment,
           bool slow, int threads) {
    Contender c = {name + (threads > 1 ? ".two_threads" : ""), "", false, slow, threads, nullptr, {}};
    if (!is_program(words[0])) c.absent = "not installed when this was built";
    if (c.absent.empty()) {
      std::vector<std::string> all = environment;
      for (const char* variable : {"OPENBLAS_NUM_THREADS=", "OMP_NUM_THREADS="})
        all.push_back(variable + std::to_string(threads));
      c.child = std::make_unique<Child>(words, all);
      if (!c.child->alive()) c.absent = "does not start";
    }
    all_.push_back(std::move(c));
  }
  void add_own(Instructions set, int threads) {
    const std::string name = name_of(set);
    if (threads > 1 && set != c2d::best_instructions()) return;
    add(name, {options_.self, "--serve", name, std::to_string(threads)}, {}, false, threads);
    all_.back().own = true;
    if (!has(set)) all_.back().absent = "not on this machine";
  }
  void add_openblas(const std::string& name, const std::string& core, int threads) {
    add(name, {options_.openblas.empty() ? "" : options_.folder + "/rival_lapack", options_.openblas}, {core}, false, threads);
  }
  // The kernels of OpenBLAS that are fastest here, whatever it would choose by itself.
  std::string best_core() const {
    std::string best;
    double least = 0;
    for (const char* core : {"Haswell", "Zen", "SkylakeX", "Cooperlake", "Sapphirerapids"}) {
      Child child({options_.folder + "/rival_lapack", options_.openblas},
                  {std::string("OPENBLAS_CORETYPE=") + core, "OPENBLAS_NUM_THREADS=1"});
      std::vector<double> seconds;
      for (int turn = 0; turn < 3 && child.alive(); ++turn) {
        const Answer a = ask(child, "time", "random:1", 1000);
        if (a.ok) seconds.push_back(a.processor);
      }
      if (seconds.empty() || (least > 0 && median(seconds) >= least)) continue;
      least = median(seconds);
      best = core;
    }
    return best;
  }

  const Options& options_;
  std::string best_core_;
  std::vector<Contender> all_;
};

double seconds_of(const Answer& a, int threads) {
  return threads > 1 ? a.wall : a.processor; // what others do on the machine counts least in processor time
}

double asked_over_openblas(int n, bool best, int threads) {
  if (threads > 1) return best || n < 320 ? 0 : n <= 1000 ? 1.8 : n == 2000 ? 1.25 : 1.0;
  if (best) return n < 200 || n > 4000 ? 0 : n <= 2000 ? 1.1 : 1.0;
  return n < 200 ? 0 : n <= 520 ? 1.4 : n <= 1000 ? 1.3 : n <= 2000 ? 1.1 : n <= 4000 ? 1.0 : 0.95;
}

bool takes_part(const Contender& c, int n) {
  if (!c.absent.empty()) return false;
  if (n > 2000)
    return !c.slow && c.name != "eigen" &&
           (n <= 4000 || !c.own || c.name == name_of(c2d::best_instructions()) || c.threads > 1);
  return true;
}

void tell(const Contender& c, const Contender* own, int n) {
  const std::string key = "lu." + std::to_string(n) + "." + c.name;
  if (!c.absent.empty()) return note(key, c.absent);
  if (c.answers.empty()) return;
  std::vector<double> seconds, ratios, shares;
  for (size_t i = 0; i < c.answers.size(); ++i) {
    const double t = seconds_of(c.answers[i], c.threads);
    seconds.push_back(t);
    if (own && i < own->answers.size()) ratios.push_back(t / seconds_of(own->answers[i], c.threads));
    if (c.answers[i].peak > 0) shares.push_back(c.answers[i].peak);
  }
  const double m = n, work = 2.0 / 3 * m * m * m + 2 * m * m;
  std::string remark;
  const bool openblas = c.name.compare(0, 8, "openblas") == 0;
  if (!shares.empty()) {
    for (size_t i = 0; i < shares.size(); ++i) shares[i] = work / seconds[i] * 1e-9 / shares[i];
    const bool baseline = c.name == "baseline", best = c.name == name_of(c2d::best_instructions());
    const double figure = best && n >= 1000 ? (n >= 2000 ? 0.80 : 0.75) : baseline && n >= 520 ? 0.55 : 0;
    remark = judged(key + ".share", median(shares), ">=", figure, "of the peak");
  } else if (!ratios.empty() && !c.own) {
    const double figure = openblas ? asked_over_openblas(n, c.name.compare(0, 13, "openblas_best") == 0, c.threads) : 0;
    remark = judged(key + ".ratio", median(ratios), ">=", figure, "times as long as ours");
  }
  row(key, work / median(seconds) * 1e-9, "GFLOP/s", remark);
}

void race(Field& field, int n) {
  const int turns = n <= 1000 ? 7 : n <= 4000 ? 3 : 1;
  for (Contender& c : field.all()) c.answers.clear();
  for (int turn = 0; turn < turns; ++turn)
    for (Contender& c : field.all()) {
      if (!takes_part(c, n) || (c.slow && turn > 0 && n >= 1000)) continue;
      const Answer a = ask(*c.child, "time", "random:1", n);
      if (a.ok) c.answers.push_back(a);
      if (n > 2000) ask(*c.child, "time", "random:1", 10); // gives the large matrix back
    }
  const Contender* own[3] = {};
  for (const Contender& c : field.all())
    if (c.own && !own[c.threads] && !c.answers.empty()) own[c.threads] = &c;
  for (const Contender& c : field.all()) tell(c, own[c.threads], n);
}

// Residuals beside those of LAPACK on three kinds of matrices.
void residuals(Field& field) {
  Contender* lapack = nullptr;
  for (Contender& c : field.all())
    if (c.absent.empty() && (c.name == "lapack" || (!lapack && c.name == "openblas"))) lapack = &c;
  if (!lapack) return note("residual", "no LAPACK to compare with");
  const int n = 800;
  const std::string file = "/tmp/contact2d-bench-matrix-" + std::to_string(getpid());
  write_boundary_matrix(file, n / 2);
  const struct {
    const char* name;
    std::vector<std::string> matrices;
  } kinds[] = {{"random", {"random:1", "random:2", "random:3", "random:4", "random:5"}},
               {"graded", {"graded:1", "graded:2", "graded:3", "graded:4", "graded:5"}},
               {"boundary", {"file:" + file}}};
  heading("Scaled residual |b - A x| / (n eps |A| |x|), n = 800: medians, and over " + lapack->name + "'s");
  for (const auto& kind : kinds)
    for (Contender& c : field.all()) {
      if (!c.own || c.threads > 1 || !c.absent.empty()) continue;
      std::vector<double> ours, ratios;
      for (const std::string& matrix : kind.matrices) {
        const Answer a = ask(*c.child, "residual", matrix, n), b = ask(*lapack->child, "residual", matrix, n);
        if (!a.ok || !b.ok) continue;
        ours.push_back(a.residual);
        ratios.push_back(a.residual / b.residual);
      }
      const std::string key = std::string("residual.") + kind.name + "." + c.name;
      row(key, median(ours), "", judged(key + ".ratio", median(ratios), "<=", 2, "times LAPACK's"));
    }
  unlink(file.c_str());
}

} // namespace

void elimination(const Options& options) {
  Field field(options);
  heading("Elimination with one solution, n x n, partial pivoting; one thread by processor time, two by the "
          "clock\n"
          "openblas: the kernels it chooses; openblas_best: " +
          (field.best_core_name().empty() ? "none" : field.best_core_name()) +
          "; eigen: -O2; eigen_native: -O3 -march=native; rows: the loops of 1987");
  for (const int n : {100, 200, 320, 520, 1000, 2000}) race(field, n);
  if (options.large)
    for (const int n : {4000, 8000}) race(field, n);
  else
    note("lu.4000, lu.8000", "make bench LARGE=1 (some minutes more)");
  residuals(field);
}

} // namespace bench
