// Work per contact event against the number of pairs: loading and unloading the cylinder again and again.
#include "../callable.hpp"
#include "bench.hpp"
#include "linalg/exchange.hpp"
#include "model.hpp"

#include <cstdio>
#include <memory>

namespace bench {

namespace {

// Exchanges alone, on a full tableau of m unknowns and one load case.
class Exchanges {
public:
  explicit Exchanges(int32_t m) : m_(m) {
    const size_t numbers = static_cast<size_t>(m) * static_cast<size_t>(m + 2);
    t_.reserve(numbers);
    ask_for_huge_pages(t_.data(), numbers * sizeof(c2d::Real));
    t_.resize(numbers);
    uint32_t seed = 12345;
    for (c2d::Real& v : t_) v = static_cast<c2d::Real>((seed = seed * 1664525u + 1013904223u) >> 8) / 16777216;
  }
  // Median seconds of one, there and back: the numbers stay as they are.
  double seconds() {
    return time_of(5, 0.03,
                   [&] {
                     for (int twice = 0; twice < 2; ++twice) c2d::exchange(m_, m_ + 2, t_.data(), m_, place_, place_, kernel_);
                     place_ = (place_ + 7) % m_;
                   }) /
           2;
  }

private:
  const c2d::Kernel* kernel_ = c2d::kernel_for(c2d::best_instructions());
  int32_t m_, place_ = 0;
  std::vector<c2d::Real> t_;
};

// One size of the cylinder, on its way up and down the load.
class Family {
public:
  explicit Family(int32_t pairs) : model_(pairs), solver_(model_.limits()) {
    model_.build(solver_);
    solver_.must(c2d_prepare(solver_));
    const double mu = 0.4;
    solver_.must(c2d_begin(solver_, &mu, 1));
  }
  host::Summary summary() const { return solver_.summary(); }

  // Sweeps for at least this many processor seconds; keeps seconds per event and per exchange.
  void sweep(double enough) {
    const host::Summary before = solver_.summary();
    const double start = processor_seconds();
    double spent = 0;
    do {
      load_ = load_ > 0.5 ? 0.02 : 0.9;
      c2d_outcome outcome = C2D_REACHED;
      solver_.must(c2d_advance(solver_, &load_, 1, &outcome));
      if (outcome != C2D_REACHED) give_up(c2d_outcome_message(outcome));
      spent = processor_seconds() - start;
    } while (spent < enough || load_ > 0.5);
    const host::Summary after = solver_.summary();
    per_event.push_back(spent / static_cast<double>(after.events - before.events));
    per_exchange.push_back(spent / static_cast<double>(after.exchanges - before.exchanges));
  }
  std::vector<double> per_event, per_exchange;

private:
  Cylinder model_;
  Solver solver_;
  double load_ = 0;
};

} // namespace

namespace {

// A long history; a part of it stands for the rest, because every event costs the same.
void history(bool whole) {
  const int64_t asked = 100000, counted = whole ? asked : asked / 20;
  Family family(400);
  const double start = processor_seconds();
  while (family.summary().events < counted) family.sweep(0);
  const double spent = processor_seconds() - start, events = static_cast<double>(family.summary().events);
  const double all = spent * static_cast<double>(asked) / events;
  row("events.history", all, "s",
      judged("events.history_seconds", all, "<=", 8, "") + " for 100000 events on 400 pairs" +
          (whole ? std::string() : ", from the first " + std::to_string(static_cast<long long>(events))));
  row("events.rate", events / spent, "events/s", "on 400 pairs");
}

// Where the tableau is far beyond the caches: an event against one pass of it through memory.
void large_tableau() {
  const int32_t pairs = 1000;
  Family family(pairs);
  Exchanges exchange(family.summary().contact_unknowns);
  std::vector<double> alone;
  for (int i = 0; i < 3; ++i) {
    family.sweep(0);
    alone.push_back(exchange.seconds());
  }
  const double event = median(family.per_event), one = median(alone);
  row("events.1000.time", event * 1e6, "us/event");
  row("events.1000.exchange_alone", one * 1e6, "us");
  row("events.1000.over_exchange", event / one, "",
      judged("events.1000.over_one_exchange", event / one, "<=", 0.15, "of what an exchange of the whole tableau takes"));
}

} // namespace

test::Callable<void()> contact_job(int32_t pairs, int sweeps) {
  const auto family = std::make_shared<Family>(pairs);
  return [family, sweeps] {
    for (int i = 0; i < sweeps; ++i) family->sweep(0);
  };
}

void contact_events(const Options& options) {
  heading("Contact events: cylinder on foundation, mu = 0.4, load 0 -> 0.9 -> 0.02 -> 0.9 ...");
  const int32_t sizes[] = {50, 100, 200, 400};
  std::vector<std::unique_ptr<Family>> families;
  std::vector<Exchanges> exchanges;
  for (const int32_t pairs : sizes) {
    families.push_back(std::make_unique<Family>(pairs));
    exchanges.emplace_back(families.back()->summary().contact_unknowns);
  }
  // In turns, so that a slow spell of the machine strikes all sizes.
  std::vector<double> alone[4];
  for (int round = 0; round < 5; ++round) {
    for (size_t i = 0; i < families.size(); ++i) {
      families[i]->sweep(0.2);
      alone[i].push_back(exchanges[i].seconds());
    }
  }
  std::vector<double> unknowns, per_event, per_exchange, one;
  for (size_t i = 0; i < families.size(); ++i) {
    const host::Summary now = families[i]->summary();
    const double m = now.contact_unknowns, changes = static_cast<double>(now.exchanges) / static_cast<double>(now.events);
    unknowns.push_back(m);
    per_event.push_back(median(families[i]->per_event));
    per_exchange.push_back(median(families[i]->per_exchange));
    one.push_back(median(alone[i]));
    const std::string name = "events." + std::to_string(sizes[i]) + ".";
    char remark[160];
    std::snprintf(remark, sizeof remark, "m = %d, %lld events, %lld rebuilds, residual %.1e", now.contact_unknowns,
                  static_cast<long long>(now.events), static_cast<long long>(now.tableau_rebuilds), now.max_residual);
    row(name + "time", per_event.back() * 1e6, "us/event", remark);
    row(name + "exchanges", changes, "/event");
    row(name + "time_per_exchange", per_exchange.back() * 1e6, "us", "all the work of the path over its exchanges");
    std::snprintf(remark, sizeof remark, "%.3f ns per m^2", one.back() * 1e9 / (m * m));
    row(name + "exchange_alone", one.back() * 1e6, "us", remark);
    row(name + "overhead", per_exchange.back() / one.back(), "", "time per exchange over that of an exchange alone");
  }
  const double power = exponent(unknowns, per_event);
  row("events.exponent", power, "of m", judged("events.exponent_of_m", power, "<=", 2.1, ""));
  row("events.exponent_per_exchange", exponent(unknowns, per_exchange), "");
  row("events.exponent_alone", exponent(unknowns, one), "", "of one exchange: caches count in it");
  history(options.large);
  large_tableau();
}

} // namespace bench
