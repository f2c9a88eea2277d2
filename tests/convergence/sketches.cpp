// The sketches of examples/ on ever finer meshes, with linear and with quadratic functions.
#include "sketches.hpp"

#include "sketch_runs.hpp"

#include <chrono>
#include <cstdio>

using namespace sketch_test;

namespace {

// The highest pressure of a zone at the end, and what it is known to be; 0: only by the rows of the table.
struct Problem {
  const char* name;
  int zone;
  double exact;
};

void table(const Problem& problem) {
  std::printf("\nSketch %s, highest pressure of zone %d", problem.name, problem.zone);
  if (problem.exact > 0) std::printf(", known to be %.6g", problem.exact);
  std::printf("\n   order fineness  elements   pairs   seconds    pressure     error\n");
  for (const int order : {1, 2})
    for (const double fineness : {1.0, 2.0, 4.0}) {
      const auto begin = std::chrono::steady_clock::now();
      const Solution s = solve(std::string(problem.name), {fineness, order});
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      std::printf("%8d %8g %9d", order, fineness, s.elements);
      if (!s.error.empty()) {
        std::printf("  %s\n", s.error.c_str());
        continue;
      }
      const double peak = at_peak(s.zone(problem.zone)).tn;
      std::printf(" %7d %9.2f %11.6g", static_cast<int>(s.zone(problem.zone).size()), seconds, peak);
      if (problem.exact > 0) std::printf(" %9.1e", std::fabs(peak / problem.exact - 1));
      std::printf("\n");
    }
}

} // namespace

void sketches() {
  const double p0 = 374.0541, lame = 31.6319, rounded = 86.08985, persson = 219.06, gears = 1114.303;
  const Problem problems[] = {{"fretting_pad", 1, p0}, {"rounded_pad", 1, rounded},
                              {"press_fit", 1, lame},  {"pin", 1, persson},
                              {"dovetail", 1, 0},      {"lap_joint", 1, 0},
                              {"lap_joint", 2, 0},     {"coated_roller", 2, 0},
                              {"gear_pair", 1, gears}, {"crack", 1, 0},
                              {"rough_profile", 1, 0}, {"seal", 1, 0},
                              {"seal", 2, 0},          {"seal", 3, 0}};
  for (const Problem& problem : problems) table(problem);
}
