// A table of true errors beside stated ones: make estimate-truth. Arguments: a part of a problem's name, tolerances;
// `mesh` behind them: against a finer mesh instead of the closed form.
#include "estimate_truth.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

struct Count {
  int rows = 0, above = 0, below = 0, low = 0, high = 0;
} counts;

void print(const truth::Problem& problem, const truth::Judged& j, double tolerance) {
  std::printf("%s, asked %g %%: %d pairs, %d elements, %zu meshes, %.3f s, the last %.3f s%s%s\n", problem.name.c_str(),
              100 * tolerance, j.pairs, j.elements, j.meshes, j.seconds, j.last,
              j.stopped.empty() ? "" : "; stopped: ", j.stopped.c_str());
  if (!j.fault.empty()) std::printf("  %s\n", j.fault.c_str());
  for (const truth::Row& r : j.rows) {
    std::printf("  %-16s %d %c  %14.8g  true %10.3e  stated %10.3e  ratio %8.2f%s%s\n", r.name.c_str(), r.item,
                r.wanted ? 'w' : ' ', r.value, r.error, r.stated, r.ratio(),
                r.wanted && r.error > r.asked ? "  above asked" : "", r.ratio() < 0.8 ? "  TOO SMALL" : "");
    if (!r.wanted) continue;
    ++counts.rows;
    counts.above += r.error > r.asked, counts.below += r.ratio()<0.8, counts.low += r.ratio() < 1, counts.high += r.ratio()> 5;
  }
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
  const char* part = argc > 1 ? argv[1] : "";
  const bool by_mesh = argc > 2 && std::strcmp(argv[argc - 1], "mesh") == 0;
  if (by_mesh) --argc;
  for (const truth::Problem& problem : truth::problems()) {
    if (std::strstr(problem.name.c_str(), part) == nullptr) continue;
    for (int i = 2; i < argc; ++i) {
      const double tolerance = std::atof(argv[i]);
      print(problem, truth::judge(problem, tolerance, by_mesh), tolerance);
    }
  }
  std::printf("%d wanted numbers: %d above what was asked, stated over true error: %d below 0.8, %d below 1, %d above 5\n",
              counts.rows, counts.above, counts.below, counts.low, counts.high);
  return 0;
}
