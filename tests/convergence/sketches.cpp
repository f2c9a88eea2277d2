// The sketches of examples/ on ever finer meshes, with linear and with quadratic functions.
#include "sketches.hpp"

#include "sketch_runs.hpp"

#include <chrono>
#include <cstdio>

using namespace sketch_test;

namespace {

// The highest pressures of zones at the end, and what that of the first is known to be; 0: only by the rows of the table.
struct Problem {
  const char* name;
  std::vector<int> zones;
  double exact;
};

void table(const Problem& problem) {
  std::printf("\nSketch %s, highest pressure of zone", problem.name);
  for (const int zone : problem.zones) std::printf(" %d", zone);
  if (problem.exact > 0) std::printf(", known to be %.6g", problem.exact);
  std::printf("\n   order fineness  elements   pairs   seconds\n");
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
      std::printf(" %7d %9.2f", static_cast<int>(s.last().size()), seconds);
      for (const int zone : problem.zones) std::printf(" %11.6g", at_peak(s.zone(zone)).tn);
      if (problem.exact > 0) std::printf(" %9.1e", std::fabs(at_peak(s.zone(problem.zones[0])).tn / problem.exact - 1));
      std::printf("\n");
    }
}

} // namespace

void sketches() {
  const double p0 = 374.0541, lame = 31.6319, rounded = 86.08985, persson = 219.06, gears = 1114.303;
  const Problem problems[] = {{"fretting_pad", {1}, p0}, {"rounded_pad", {1}, rounded}, {"press_fit", {1}, lame},
                              {"pin", {1}, persson},     {"dovetail", {1}, 0},          {"lap_joint", {1, 2, 3}, 0},
                              {"coated_roller", {2}, 0}, {"gear_pair", {1}, gears},     {"crack", {1}, 0},
                              {"rough_profile", {1}, 0}, {"seal", {1, 2, 3}, 0}};
  for (const Problem& problem : problems) table(problem);
}
