#pragma once
// Models on demand against the same models with all of the contact system formed.
#include "many_bodies.hpp"
#include "memory/config.hpp"
#include "solver/solver.hpp"

#include "effort.hpp"
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>

namespace demand {

struct Apart {
  double tractions = 0, lengths = 0, energies = 0;
  int statuses = 0;
};

inline double over(double apart, double size) { return size > 0 ? apart / size : apart; }

// Results of the same model: how far apart, over the largest.
inline Apart apart(const many::Result& a, const many::Result& b) {
  Apart out;
  REQUIRE(a.steps.size() == b.steps.size());
  double t = 0, u = 0, dt = 0, du = 0, most = 0;
  for (const many::Step& step : a.steps) most = std::max({most, std::fabs(step.work), std::fabs(step.elastic)});
  for (size_t s = 0; s < a.steps.size(); ++s) {
    REQUIRE(a.steps[s].rows.size() == b.steps[s].rows.size());
    for (size_t i = 0; i < a.steps[s].rows.size(); ++i) {
      const many::Row &x = a.steps[s].rows[i], &y = b.steps[s].rows[i];
      if (x[C2D_STATUS] != y[C2D_STATUS]) ++out.statuses;
      for (size_t f : {size_t{C2D_TN}, size_t{C2D_TT}})
        t = std::max(t, std::fabs(x[f])), dt = std::max(dt, std::fabs(x[f] - y[f]));
      for (size_t f :
           {size_t{C2D_UN1}, size_t{C2D_UN2}, size_t{C2D_UT1}, size_t{C2D_UT2}, size_t{C2D_GAP}, size_t{C2D_SLIP_SUM}})
        u = std::max(u, std::fabs(x[f])), du = std::max(du, std::fabs(x[f] - y[f]));
    }
    const many::Step &p = a.steps[s], &q = b.steps[s];
    const double own = std::max(std::fabs(p.work), std::fabs(p.elastic));
    const double size = own > 1e-13 * most ? own : most; // where bodies are let go all energies are round-off
    for (const auto& [x, y] :
         {std::pair(p.work, q.work), std::pair(p.dissipated, q.dissipated), std::pair(p.elastic, q.elastic)})
      out.energies = std::max(out.energies, over(std::fabs(x - y), size));
    out.energies = std::max(out.energies, std::fabs(p.defect - q.defect));
  }
  REQUIRE(a.boundary.size() == b.boundary.size());
  for (size_t k = 0; k < a.boundary.size(); ++k)
    for (size_t i = 0; i < a.boundary[k].size(); ++i) {
      const many::EndResult &x = a.boundary[k][i], &y = b.boundary[k][i];
      t = std::max({t, std::fabs(x.tx), std::fabs(x.ty)}), u = std::max({u, std::fabs(x.ux), std::fabs(x.uy)});
      dt = std::max({dt, std::fabs(x.tx - y.tx), std::fabs(x.ty - y.ty)});
      du = std::max({du, std::fabs(x.ux - y.ux), std::fabs(x.uy - y.uy)});
    }
  out.tractions = over(dt, t), out.lengths = over(du, u);
  return out;
}

const bool kIsDouble = C2D_REAL_BYTES == 8;
const double kNear = kIsDouble ? 1e-9 : 1e-2;

inline many::Model on_demand(many::Model m, int32_t touching) {
  m.elimination = C2D_ELIMINATION_COMPRESSED;
  m.touching = touching;
  return m;
}

inline void check_alike(const many::Model& m, int32_t touching) {
  const many::Result dense = many::solve(m);
  REQUIRE_MESSAGE(dense.status == C2D_OK, dense.messages());
  many::Machine machine(on_demand(m, touching));
  const many::Result own = machine.run();
  REQUIRE_MESSAGE(own.status == C2D_OK, own.messages());
  CHECK(own.outcome == dense.outcome);
  CHECK(machine.solver->model.columns > 0);
  CHECK(machine.solver->made > 0);
  const Apart by = apart(dense, own);
  if (std::getenv("SHOW"))
    MESSAGE("tractions " << by.tractions << " lengths " << by.lengths << " energies " << by.energies << " made "
                         << machine.solver->made << " events " << machine.solver->stats.events);
  CHECK(by.statuses == 0);
  CHECK(by.tractions < kNear);
  CHECK(by.lengths < kNear);
  CHECK(by.energies < 10 * kNear);
}

inline many::Model quadratic(many::Model m, int32_t nodes) {
  m.function_nodes = nodes;
  for (many::Body& body : m.bodies) {
    const std::vector<many::End> ends = body.ends; // two for each element: every end of an element like its first
    body.ends.clear();
    for (size_t e = 0; e < ends.size() / 2; ++e) body.ends.insert(body.ends.end(), static_cast<size_t>(nodes), ends[2 * e]);
  }
  return m;
}

// The upper block is pushed along after it has been pressed, and back.
inline many::Model pushed(many::Model m) {
  m.cases = 2;
  for (many::Body& body : m.bodies) body.second.assign(body.ends.size(), many::End());
  for (const auto& [number, side] : {std::pair<int32_t, int32_t>(1, 1), std::pair<int32_t, int32_t>(2, 3)})
    m.set_second(number, side, many::end_of(many::kHeld, 0, 0, number == 2 ? 1e-4 : 0, 0));
  m.paths = {{2, 1.0, 0.0}, {2, 1.0, 1.0}, {1, 1.0, -0.5}, {1, 0.5, 0.0}, {1, 0.0, 0.0}};
  return m;
}

// The upper block is held at the middle of its upper side alone, about which a pressure turns it.
inline many::Model hinged(many::Model m, double down) {
  m.set(2, 3, [](double x, double) { return many::end_of(many::kPulled, 0, -0.01 * x); });
  const many::Range top = m.side(2, 3);
  const size_t middle = static_cast<size_t>((top.first + top.last) / 2), nodes = static_cast<size_t>(m.function_nodes);
  for (size_t end : {middle * nodes - 1, middle * nodes}) m.body(2).ends[end] = many::end_of(many::kHeld, 0, 0, 0, -down);
  return m;
}

// A solver on a store that fails or ends when told, and is cut off.
struct Host {
  runs::RamStore own;
  runs::RamStore* store;
  c2d_port port = C2D_INIT(c2d_port);
  std::unique_ptr<runs::Machine> machine;
  int64_t chances = -1; // at how many more it is not cancelled; below 0: at none
  uint64_t bytes = 0;
  c2d_limits limits = C2D_INIT(c2d_limits);
  std::vector<c2d_body_limits> list;
  explicit Host(const many::Model& m, runs::RamStore* shared = nullptr, uint64_t least = 0)
      : store(shared != nullptr ? shared : &own) {
    port.context = this;
    const auto at = [](void* c) -> void* { return static_cast<Host*>(c)->store; };
    static const auto stored = at;
    port.open = [](void* c, int32_t t, uint64_t n, uint64_t each) { return runs::RamStore::open(stored(c), t, n, each); };
    port.read = [](void* c, int32_t t, uint64_t k, void* d, uint64_t n) { return runs::RamStore::read(stored(c), t, k, d, n); };
    port.write = [](void* c, int32_t t, uint64_t k, const void* d, uint64_t n) {
      return runs::RamStore::write(stored(c), t, k, d, n);
    };
    port.sync = [](void* c, int32_t t) { return runs::RamStore::sync(stored(c), t); };
    port.close = [](void* c, int32_t t) { return runs::RamStore::close(stored(c), t); };
    port.cancel = [](void* c) { return static_cast<Host*>(c)->chances-- == 0 ? 1 : 0; };
    limits = many::limits_of(m, list);
    REQUIRE(c2d_memory_need(&limits, &bytes, nullptr, nullptr) == C2D_OK);
    bytes = std::max(bytes, least);
    machine = std::make_unique<runs::Machine>(limits, bytes, &port, 8);
    REQUIRE(machine->created == C2D_OK);
    c2d_options options = C2D_INIT(c2d_options);
    options.elimination = m.elimination;
    REQUIRE(c2d_set_options(solver(), &options) == C2D_OK);
    REQUIRE(many::feed(solver(), m) == C2D_OK);
  }
  c2d_solver* solver() const { return machine->solver; }
  c2d_status begin() {
    const c2d_status status = c2d_prepare(solver());
    const double mu = 0.3;
    return status == C2D_OK ? c2d_begin(solver(), &mu, 1) : status;
  }
  c2d_status go(double load) {
    c2d_outcome outcome = C2D_REACHED;
    const c2d_status status = c2d_advance(solver(), &load, 1, &outcome);
    if (status == C2D_OK) CHECK(outcome == C2D_REACHED);
    return status;
  }
  std::vector<double> results() const {
    const int32_t pairs = limits.pairs, fields[] = {C2D_TN, C2D_TT, C2D_UN1, C2D_UT2, C2D_STATUS, C2D_GAP};
    std::vector<double> out(6 * static_cast<size_t>(pairs));
    for (int f = 0; f < 6; ++f) REQUIRE(c2d_get(solver(), fields[f], 0, 1, pairs, out.data() + f * pairs, 1) == C2D_OK);
    c2d_summary sum = C2D_INIT(c2d_summary);
    REQUIRE(c2d_get_summary(solver(), &sum) == C2D_OK);
    out.insert(out.end(), {sum.work, sum.elastic, sum.dissipated, sum.energy_defect});
    return out;
  }
};

// Whichever operation of the store fails, that is told: of `before` of them before the path begins, and 40 behind.
inline void check_failing_store(const many::Model& m, size_t before) {
  size_t operations = 0, begun = 0;
  {
    Host whole(m);
    REQUIRE(whole.begin() == C2D_OK);
    begun = whole.own.done.size();
    REQUIRE(whole.go(1) == C2D_OK);
    whole.results();
    operations = whole.own.done.size();
  }
  REQUIRE(operations > begun + 100);
  const size_t sparse = test::effort<size_t>(9, 1); // in short, every ninth of the places
  for (size_t n = begun / 2; n < operations;
       n += sparse * (1 + (n < begun ? begun / (2 * before) : (operations - begun) / 40))) {
    CAPTURE(n);
    Host host(m);
    host.own.before = [n](const runs::RamStore::Operation&, size_t i) { return i == n ? 5 : 0; };
    c2d_status status = host.begin();
    if (status == C2D_OK) status = host.go(1);
    double one = 0;
    if (status == C2D_OK) status = c2d_get(host.solver(), C2D_TN, 0, 1, 1, &one, 1);
    if (host.own.done.size() <= n) continue;
    CHECK(status >= C2D_ERR_STORE_OPEN);
    CHECK(status <= C2D_ERR_STORE_SYNC);
    CHECK(c2d_get_state(host.solver()) == C2D_STATE_BROKEN);
  }
}

// Cancelled at any chance it goes on to the same bits.
inline void check_cancelled(const many::Model& m) {
  Host whole(m);
  REQUIRE(whole.begin() == C2D_OK);
  REQUIRE(whole.go(1) == C2D_OK);
  const std::vector<double> expected = whole.results();
  int cancelled = 0;
  for (int64_t chance : {0, 2, 20, 100, 1, 5, 9, 33, 60}) {
    if (chance % 2 == 1 && !test::in_full()) break;
    CAPTURE(chance);
    Host host(m);
    host.chances = chance;
    c2d_status status = host.begin();
    for (; status == C2D_ERR_CANCELLED; status = host.begin()) ++cancelled;
    REQUIRE(status == C2D_OK);
    for (status = host.go(1); status == C2D_ERR_CANCELLED; status = host.go(1)) ++cancelled;
    REQUIRE(status == C2D_OK);
    CHECK(host.results() == expected);
  }
  CHECK(cancelled > test::effort(1, 4));
}

} // namespace demand
