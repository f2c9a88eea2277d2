// Work per contact event against the number of pairs: loading and unloading the cylinder again and again.
#include "bench.hpp"
#include "linalg/exchange.hpp"
#include "model.hpp"

#include <cmath>

namespace bench {

namespace {

// Median seconds of one exchange alone, on a full tableau of m unknowns and one load case.
double exchange_seconds(int32_t m) {
  std::vector<c2d::Real> t(static_cast<size_t>(m) * static_cast<size_t>(m + 2));
  uint32_t seed = 12345;
  for (c2d::Real& v : t) v = static_cast<c2d::Real>((seed = seed * 1664525u + 1013904223u) >> 8) / 16777216;
  int32_t place = 0;
  const int32_t some = 4;
  return time_of(10, 0.1,
                 [&] { // there and back: the numbers stay as they are
                   for (int32_t i = 0; i < some; ++i, place = (place + 7) % m)
                     for (int twice = 0; twice < 2; ++twice)
                       c2d::exchange(m, m + 2, t.data(), m, place, place);
                 }) /
         (2 * some);
}

} // namespace

void contact_events() {
  heading("Contact events: cylinder on foundation, mu = 0.4, load 0 -> 0.9 -> 0.02 -> 0.9 ...");
  std::vector<double> unknowns, per_event, per_change, alone;
  for (const int32_t pairs : {50, 100, 200, 400}) {
    const Cylinder model(pairs);
    const Solver solver(model.limits());
    model.build(solver);
    solver.must(c2d_prepare(solver));
    const double mu = 0.4;
    solver.must(c2d_begin(solver, &mu, 1));
    c2d_outcome outcome = C2D_REACHED;
    double load = 0.9, spent = 0;
    std::vector<double> rates, change_rates;
    c2d_summary before = solver.summary();
    for (int sweep = 0; sweep < 5 || (sweep < 100 && spent < 2); ++sweep, load = load > 0.5 ? 0.02 : 0.9) {
      const double start = processor_seconds();
      solver.must(c2d_advance(solver, &load, 1, &outcome));
      const double time = processor_seconds() - start;
      if (outcome != C2D_REACHED) give_up(c2d_outcome_message(outcome));
      const c2d_summary after = solver.summary();
      const double events = static_cast<double>(after.events - before.events);
      const double exchanges = static_cast<double>(after.exchanges - before.exchanges);
      before = after;
      spent += time;
      if (events < 1 || exchanges < 1) continue;
      rates.push_back(time / events);
      change_rates.push_back(time / exchanges);
    }
    const c2d_summary now = solver.summary();
    const double m = now.contact_unknowns;
    unknowns.push_back(m);
    per_event.push_back(median(rates));
    per_change.push_back(median(change_rates));
    alone.push_back(exchange_seconds(now.contact_unknowns));
    const std::string name = "events." + std::to_string(pairs) + ".";
    row(name + "time", per_event.back() * 1e6, "us/event",
        "m = " + std::to_string(now.contact_unknowns) + ", " + std::to_string(now.events) + " events, " +
            std::to_string(now.tableau_rebuilds) + " rebuilds, residual " +
            std::to_string(now.max_residual * 1e15) + "e-15");
    row(name + "exchanges", static_cast<double>(now.exchanges) / static_cast<double>(now.events), "/event");
    row(name + "time_per_exchange", per_change.back() * 1e6, "us",
        "all the work of the path over its exchanges");
    row(name + "exchange_alone", alone.back() * 1e6, "us",
        std::to_string(alone.back() * 1e9 / (m * m)) + " ns per m^2");
  }
  row("events.exponent", exponent(unknowns, per_event), "",
      "of m in the time per event: 2 is the square, 3 the cube");
  row("events.exponent_per_exchange", exponent(unknowns, per_change), "");
  row("events.exponent_alone", exponent(unknowns, alone), "", "of one exchange: caches count in it");
}

} // namespace bench
