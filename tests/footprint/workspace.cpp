// Workspace as a table and a formula: two bodies of N linear elements each, p pairs, panels of w columns
// (numbers of 8 bytes). Ends with 1 if the formula is more than 2 % off anywhere.
#include "contact2d.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace {

uint64_t need(int nodes, int pairs, int width) {
  c2d_body_limits bodies[2] = {{nodes, nodes, 1, 0}, {nodes, nodes, 1, 0}};
  c2d_limits limits = C2D_INIT(c2d_limits);
  limits.bodies = 2;
  limits.function_nodes = 2;
  limits.body = bodies;
  limits.zones = 1;
  limits.pairs = pairs;
  limits.contact_elements = pairs - 1;
  limits.coefficients = 1;
  limits.paths = 1;
  limits.panel_columns = width;
  uint64_t minimum = 0;
  return c2d_memory_need(&limits, &minimum, nullptr, nullptr) == C2D_OK ? minimum : 0;
}

double formula(double N, double p, double w) {
  const double eliminate = 3776 + 240 * N + 504 * p + 8 * (2 * N + 9) * w, results = 72 + 292 * N + 820 * p + 32 * p * p,
               reduce = 164 * N + 808 * p + 64 * p * p;
  return 4183 + std::max(eliminate, std::max(results, reduce));
}

} // namespace

int main() {
  const int widths[] = {1, 8, 32};
  std::printf("workspace, two bodies of N linear elements, p pairs, panels of w columns, one load case, "
              "double precision:\n"
              "  4183 + max(3776 + 240 N + 504 p + 8 (2 N + 9) w, 72 + 292 N + 820 p + 32 p^2, 164 N + 808 p + 64 "
              "p^2) bytes\n"
              "| p | N | w = 1 | w = 8 | w = 32 |\n| --- | --- | --- | --- | --- |\n");
  double worst = 0.0;
  for (const int pairs : {8, 15, 30, 60})
    for (const int nodes : {32, 64, 128, 256}) {
      std::printf("| %d | %d |", pairs, nodes);
      for (const int width : widths) {
        const double bytes = static_cast<double>(need(nodes, pairs, width));
        worst = std::max(worst, std::fabs(formula(nodes, pairs, width) / bytes - 1.0));
        std::printf(" %.0f |", bytes);
      }
      std::printf("\n");
    }
  std::printf("the formula is at most %.1f %% off\n", 100.0 * worst);
  return worst < 0.02 ? 0 : 1;
}
