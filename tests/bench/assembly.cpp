// Speed of assembly: pairs of source node and element integrated in a second.
#include "bench.hpp"
#include "model.hpp"

namespace bench {

namespace {

// Source-element pairs per second of one ring; several rings are prepared, the median counts.
double pairs_per_second(const Ring& ring, int32_t quadrature) {
  std::vector<double> rates;
  for (double spent = 0; rates.size() < 5 || (spent < 0.3 && rates.size() < 100);) {
    const Solver solver(ring.limits());
    ring.build(solver);
    c2d_options options = C2D_INIT(c2d_options);
    options.quadrature = quadrature;
    solver.must(c2d_set_options(solver, &options));
    const double start = processor_seconds();
    solver.must(c2d_prepare(solver));
    spent += processor_seconds() - start;
    const c2d_summary now = solver.summary();
    rates.push_back(static_cast<double>(now.nodes[0]) * now.elements[0] / now.seconds[C2D_PHASE_ASSEMBLE]);
  }
  return median(rates);
}

} // namespace

void assembly() {
  heading(
      "Assembly: millions of source-element pairs per second, all in one panel (ring of 2 x 60 elements)");
  for (const int order : {2, 3, 4}) {
    for (const bool round : {false, true}) {
      if (round && order == 2) continue;
      const Ring ring = {60, order, order, round};
      const std::string name = std::string("assembly.") + (round ? "curved." : "straight.") +
                               (order == 2   ? "linear."
                                : order == 3 ? "quadratic."
                                             : "cubic.");
      const double accurate = pairs_per_second(ring, C2D_QUADRATURE_ACCURATE) * 1e-6;
      const double thesis = pairs_per_second(ring, C2D_QUADRATURE_THESIS) * 1e-6;
      row(name + "accurate", accurate, "M/s", times(accurate / thesis) + " of the rule of 1987");
      row(name + "thesis", thesis, "M/s");
    }
  }
}

} // namespace bench
