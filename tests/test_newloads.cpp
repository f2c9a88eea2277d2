// Other loads through a factorisation that is there: c2d_change_loads and what goes with it.
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>

using namespace runs;

namespace {

constexpr double kRoundOff = 1e-12; // of the largest of its kind; 4e-14 were seen

struct Host : RamStore {
  c2d_port port = C2D_INIT(c2d_port);
  int64_t columns = 0;  // from the first that was assembled to the last of a body
  int32_t chances = -1; // to cancel; negative: never
  Host() {
    serve(port);
    port.progress = [](void* c, const c2d_progress* now) {
      Host& h = static_cast<Host&>(self(c));
      if (now->phase == C2D_PHASE_ELIMINATE) h.columns = std::max(h.columns, now->total - now->done);
    };
    port.cancel = [](void* c) {
      Host& h = static_cast<Host&>(self(c));
      return h.chances >= 0 && h.chances-- == 0 ? 1 : 0;
    };
  }
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;
};

uint64_t memory_for(const c2d_limits& limits, bool in_core) {
  uint64_t minimum = 0, most = 0;
  REQUIRE(c2d_memory_need(&limits, &minimum, &most, nullptr) == C2D_OK);
  return in_core ? most : minimum;
}
c2d_options keeping() {
  c2d_options options = C2D_INIT(c2d_options);
  options.keep_factors = 1;
  return options;
}

c2d_status set_weight(c2d_solver* s, double weight) {
  const double force[2] = {0, -weight};
  return c2d_set_body_force(s, 2, 1, force, 0, nullptr);
}

// Every prescribed value of case 1 times a factor that differs from body to body, element to element if `uneven`.
int change_values(c2d_solver* s, double factor, bool uneven) {
  const host::Summary summary = summary_of(s);
  int changed = 0;
  for (int32_t body = 1; body <= summary.bodies; ++body)
    for (int32_t element = 1; element <= summary.body[body - 1].elements; ++element)
      for (int32_t local = 1; local <= summary.function_nodes; ++local) {
        int32_t codes[4];
        double values[4];
        REQUIRE(c2d_get_condition(s, body, element, local, 1, codes, values) == C2D_OK);
        if (std::all_of(values, values + 4, [](double v) { return v == 0.0; })) continue;
        // A displacement belongs to its node, which two elements share.
        const bool tractions = values[2] == 0.0 && values[3] == 0.0;
        for (double& value : values) value *= factor * (uneven && tractions ? 1.0 + 0.3 * std::sin(element + local) : 1.0);
        REQUIRE(c2d_set_values(s, body, element, local, 1, values) == C2D_OK);
        ++changed;
      }
  for (int32_t i = 1;; ++i) {
    int32_t body, load_case;
    double at[2], force[2];
    if (c2d_get_point_load(s, i, &body, &load_case, at, force) != C2D_OK) break;
    const double bend = uneven ? 0.1 * i : 0.0;
    REQUIRE(c2d_replace_point_load(s, i, at[0], at[1], factor * force[0] + bend * force[1], factor * force[1]) == C2D_OK);
    ++changed;
  }
  return changed;
}

double largest(const std::vector<double>& a) {
  double out = 0;
  for (double x : a) out = std::max(out, std::fabs(x));
  return out;
}
// Largest difference of one field over its largest value.
double difference(c2d_solver* a, c2d_solver* b) {
  const host::Summary summary = summary_of(a);
  double worst = 0.0;
  const auto compare = [&](int32_t field, int32_t body, int32_t count) {
    std::vector<double> x(static_cast<size_t>(count)), y(x);
    REQUIRE(c2d_get(a, field, body, 1, count, x.data(), 1) == C2D_OK);
    REQUIRE(c2d_get(b, field, body, 1, count, y.data(), 1) == C2D_OK);
    const double size = std::max(largest(x), largest(y));
    for (size_t i = 0; i < x.size(); ++i)
      if (size > 0) worst = std::max(worst, std::fabs(x[i] - y[i]) / size);
  };
  if (summary.pairs > 0) {
    compare(C2D_STATUS, 1, summary.pairs);
    compare(C2D_TN, 1, summary.pairs);
    compare(C2D_GAP, 1, summary.pairs);
  }
  for (int32_t body = 1; body <= summary.bodies; ++body)
    for (int32_t field : {C2D_END_UX, C2D_END_UY, C2D_END_TX, C2D_END_TY, C2D_END_HOOP}) {
      // Components that are zero but for round-off are measured against the other one.
      compare(field, body, summary.body[body - 1].elements * summary.function_nodes);
    }
  return worst;
}

struct Runner {
  Deck deck;
  Host host;
  Machine machine;
  c2d_solver* s;
  Runner(const std::string& name, bool in_core, bool keeps)
      : deck(deck_named(name)), machine(deck.limits(), memory_for(deck.limits(), in_core), &host.port), s(machine.solver) {
    const c2d_options options = keeping();
    if (keeps) REQUIRE(c2d_set_options(s, &options) == C2D_OK);
    REQUIRE(read_deck(s, deck) == C2D_OK);
  }
  void follow(std::initializer_list<double> loads) {
    const double mu = 0.3;
    REQUIRE(c2d_begin(s, &mu, 1) == C2D_OK);
    for (double load : loads) {
      c2d_outcome outcome = -1;
      REQUIRE(c2d_advance(s, &load, 1, &outcome) == C2D_OK);
      CHECK(outcome == C2D_REACHED);
    }
  }
};

} // namespace

TEST_CASE("new loads: through the old factorisation as from the beginning, at a small part of the work") {
  for (const char* name : {"hertz_lin_l", "sample", "layer_mu", "plate", "ring3", "half_cylinder"})
    for (bool in_core : {false, true}) {
      CAPTURE(std::string(name));
      CAPTURE(in_core);
      Runner kept(name, in_core, true), fresh(name, in_core, false);
      REQUIRE(c2d_prepare(kept.s) == C2D_OK);
      CHECK(kept.host.columns > 40);
      kept.follow({0.4, 1.0});
      const Host& host = kept.host;
      const uint64_t written[] = {host.bytes_written[1], host.bytes_written[2]}, read = host.bytes_read[1];
      REQUIRE(c2d_change_loads(kept.s) == C2D_OK);
      CHECK(c2d_get_state(kept.s) == C2D_STATE_MODEL);
      CHECK(change_values(kept.s, 0.7, true) > 0);
      kept.host.columns = 0;
      REQUIRE(c2d_prepare(kept.s) == C2D_OK);
      // Of all columns only the last is assembled; of U and Y only the block with it is written.
      CHECK(kept.host.columns == 1);
      CHECK(host.bytes_written[1] == written[0]); // L as it was
      const uint64_t new_upper = host.bytes_written[2] - written[1];
      CHECK(new_upper < (in_core ? 0.5 : 0.05) * static_cast<double>(written[1]));
      const uint64_t lower = host.bytes_read[1] - read; // L once
      CHECK(lower > 0);
      CHECK(lower <= written[0]);
      CHECK(change_values(fresh.s, 0.7, true) > 0);
      REQUIRE(c2d_prepare(fresh.s) == C2D_OK);
      kept.follow({0.4, 1.0, 0.6});
      fresh.follow({0.4, 1.0, 0.6});
      const double worst = difference(kept.s, fresh.s);
      MESSAGE(std::string(name) << std::string(in_core ? ": in core" : ": streamed") << ", difference " << worst
                                << ", bytes of UPPER rewritten " << new_upper << " of " << written[1]);
      // The same sums in another order: kernels round by the shape of what they are given.
      CHECK(worst <= kRoundOff);
      CHECK(summary_of(kept.s).work == doctest::Approx(summary_of(fresh.s).work).epsilon(1e-12));
    }
}

TEST_CASE("new loads: twice the values at half the factor are the same state") {
  for (const char* name : {"hertz_lin_l", "ring3", "plate"}) {
    CAPTURE(std::string(name));
    Runner kept(name, false, true), plain(name, false, false);
    REQUIRE(c2d_prepare(kept.s) == C2D_OK);
    REQUIRE(c2d_change_loads(kept.s) == C2D_OK);
    change_values(kept.s, 2.0, false);
    REQUIRE(c2d_prepare(kept.s) == C2D_OK);
    kept.follow({0.25, 0.5});
    REQUIRE(c2d_prepare(plain.s) == C2D_OK);
    plain.follow({0.5, 1.0});
    CHECK(difference(kept.s, plain.s) <= kRoundOff);
    // And back again, over and over: nothing gathers.
    for (int turn = 0; turn < 5; ++turn) {
      REQUIRE(c2d_change_loads(kept.s) == C2D_OK);
      change_values(kept.s, turn % 2 == 0 ? 0.5 : 2.0, false);
      REQUIRE(c2d_prepare(kept.s) == C2D_OK);
    }
    kept.follow({0.5, 1.0});
    CHECK(difference(kept.s, plain.s) <= kRoundOff);
  }
}

TEST_CASE("new loads: another load case, weights and the motion of a rigid body") {
  // Case 2 is there from the beginning with any load in it.
  Deck deck = deck_named("block");
  host::Limits limits = deck.limits();
  REQUIRE(limits.load_cases >= 1);
  const auto with = [&](Host& host, bool keeps, double weight) {
    auto machine = std::make_unique<Machine>(limits, memory_for(limits, false), &host.port);
    c2d_solver* s = machine->solver;
    const c2d_options options = keeping();
    if (keeps) REQUIRE(c2d_set_options(s, &options) == C2D_OK);
    REQUIRE(read_deck(s, deck) == C2D_OK);
    REQUIRE(set_weight(s, weight) == C2D_OK);
    REQUIRE(c2d_prepare(s) == C2D_OK);
    return machine;
  };
  const auto follow = [](c2d_solver* s) {
    const double mu = 0.3;
    REQUIRE(c2d_begin(s, &mu, 1) == C2D_OK);
    const std::vector<double> load(static_cast<size_t>(summary_of(s).load_cases), 1.0);
    c2d_outcome outcome;
    REQUIRE(c2d_advance(s, load.data(), static_cast<int32_t>(load.size()), &outcome) == C2D_OK);
  };
  Host one, two;
  const auto kept = with(one, true, 0.001), fresh = with(two, false, 0.02);
  REQUIRE(c2d_change_loads(kept->solver) == C2D_OK);
  REQUIRE(set_weight(kept->solver, 0.02) == C2D_OK);
  CHECK(c2d_get_state(kept->solver) == C2D_STATE_MODEL);
  one.columns = 0;
  REQUIRE(c2d_prepare(kept->solver) == C2D_OK);
  CHECK(one.columns == summary_of(kept->solver).load_cases);
  follow(kept->solver);
  follow(fresh->solver);
  CHECK(difference(kept->solver, fresh->solver) <= kRoundOff);
  // Not rigid before, not rigid now.
  REQUIRE(c2d_change_loads(kept->solver) == C2D_OK);
  const double down[3] = {0, 0.1, 0};
  CHECK(c2d_set_rigid(kept->solver, 1, 1, down, down) == C2D_ERR_STATE);
}

TEST_CASE("new loads: a second case with tractions and a point load, as another deck gives them") {
  const auto deck_with = [](const std::string& condition, const std::string& load) {
    Deck deck = deck_named("block");
    for (const std::string& line :
         {std::string("*CASES 2"), std::string("case 2"), "condition 2 25-48 0 " + condition, "load 2 " + load})
      deck.lines.push_back(line);
    return deck;
  };
  const Deck before = deck_with("0.05 0 0 0", "0 0.5 0 -0.1"), after = deck_with("-0.02 0.01 0 0", "0.1 0.4 0.03 -0.2");
  for (bool in_core : {false, true}) {
    Host one, two;
    Machine kept(before.limits(), memory_for(before.limits(), in_core), &one.port);
    Machine fresh(after.limits(), memory_for(after.limits(), in_core), &two.port);
    const c2d_options options = keeping();
    REQUIRE(c2d_set_options(kept.solver, &options) == C2D_OK);
    REQUIRE(read_deck(kept.solver, before) == C2D_OK);
    REQUIRE(read_deck(fresh.solver, after) == C2D_OK);
    REQUIRE(c2d_prepare(kept.solver) == C2D_OK);
    REQUIRE(c2d_prepare(fresh.solver) == C2D_OK);
    REQUIRE(c2d_change_loads(kept.solver) == C2D_OK);
    const double values[4] = {-0.02, 0.01, 0, 0};
    for (int32_t element = 25; element <= 48; ++element)
      REQUIRE(c2d_set_values(kept.solver, 2, element, 0, 2, values) == C2D_OK);
    int32_t body, load_case, i = 1;
    double at[2], force[2];
    while (c2d_get_point_load(kept.solver, i, &body, &load_case, at, force) == C2D_OK && at[1] != 0.5) ++i;
    REQUIRE(c2d_replace_point_load(kept.solver, i, 1e6, 0.4, 0.03, -0.2) == C2D_OK);
    CHECK(c2d_prepare(kept.solver) == C2D_ERR_INPUT); // out of its body: told as the deck's fault would be
    CHECK(std::string(error_of(kept.solver).text).find("outside body 2") != std::string::npos);
    CHECK(c2d_get_state(kept.solver) == C2D_STATE_MODEL);
    REQUIRE(c2d_replace_point_load(kept.solver, i, 0.1, 0.4, 0.03, -0.2) == C2D_OK);
    one.columns = 0;
    REQUIRE(c2d_prepare(kept.solver) == C2D_OK);
    CHECK(one.columns == 2);
    const double mu = 0.3, loads[3][2] = {{1.0, 0.0}, {1.0, 0.6}, {0.9, 1.0}};
    for (c2d_solver* s : {kept.solver, fresh.solver}) {
      REQUIRE(c2d_begin(s, &mu, 1) == C2D_OK);
      for (const auto& load : loads) {
        c2d_outcome outcome = -1;
        REQUIRE(c2d_advance(s, load, 2, &outcome) == C2D_OK);
        CHECK(outcome == C2D_REACHED);
      }
    }
    CHECK(difference(kept.solver, fresh.solver) <= kRoundOff);
    CHECK(summary_of(kept.solver).work == doctest::Approx(summary_of(fresh.solver).work).epsilon(1e-11));
  }
}

TEST_CASE("new loads: refused values, failures and cancels; saved states from before are stale") {
  Runner kept("hertz_lin_l", false, true);
  c2d_solver* s = kept.s;
  REQUIRE(c2d_prepare(s) == C2D_OK);
  kept.follow({1.0});
  REQUIRE(c2d_save(s) == C2D_OK);
  REQUIRE(c2d_change_loads(s) == C2D_OK);
  REQUIRE(c2d_prepare(s) == C2D_OK); // nothing was changed, but it might have been
  CHECK(c2d_restore(s) == C2D_ERR_STORE_STALE);
  CHECK(c2d_get_state(s) == C2D_STATE_PREPARED);
  {
    Machine other(kept.deck.limits(), memory_for(kept.deck.limits(), false), &kept.host.port);
    const c2d_options options = keeping();
    REQUIRE(c2d_set_options(other.solver, &options) == C2D_OK);
    REQUIRE(read_deck(other.solver, kept.deck) == C2D_OK);
    CHECK(c2d_restore(other.solver) == C2D_ERR_STORE_STALE);
    REQUIRE(c2d_save(s) == C2D_OK);
    REQUIRE(c2d_restore(other.solver) == C2D_OK); // the factorisation, with its L
    REQUIRE(c2d_change_loads(other.solver) == C2D_OK);
    kept.host.columns = 0;
    change_values(other.solver, 2.0, false);
    REQUIRE(c2d_prepare(other.solver) == C2D_OK);
    CHECK(kept.host.columns == 1);
  }
  // That was another solver on this one's tapes: begin anew.
  REQUIRE(c2d_change_loads(s) == C2D_OK);
  const int32_t contact_element = [&] {
    c2d_zone zone = C2D_INIT(c2d_zone);
    REQUIRE(c2d_get_zone(s, 1, &zone) == C2D_OK);
    return zone.side1.first_element;
  }();
  const double tx[4] = {1, 0, 0, 0}, nothing[4] = {0, 0, 0, 0}, bad[4] = {0, std::nan(""), 0, 0}, ux[4] = {0, 0, 0.1, 0};
  CHECK(c2d_set_values(s, 1, contact_element, 1, 1, tx) == C2D_ERR_ARGUMENT);
  CHECK(c2d_set_values(s, 1, contact_element, 1, 1, ux) == C2D_ERR_ARGUMENT);
  CHECK(c2d_set_values(s, 1, contact_element, 1, 1, nothing) == C2D_OK);
  CHECK(c2d_set_values(s, 1, 1, 1, 1, bad) == C2D_ERR_ARGUMENT);
  CHECK(c2d_set_values(s, 1, 1, 1, 1, nullptr) == C2D_ERR_ARGUMENT);
  CHECK(c2d_set_values(s, 3, 1, 1, 1, nothing) == C2D_ERR_ARGUMENT);
  CHECK(c2d_set_values(s, 1, 100000, 1, 1, nothing) == C2D_ERR_ARGUMENT);
  CHECK(c2d_set_values(s, 1, 1, 5, 1, nothing) == C2D_ERR_ARGUMENT);
  CHECK(c2d_set_values(s, 1, 1, 1, 2, nothing) == C2D_ERR_ARGUMENT);
  CHECK(c2d_replace_point_load(s, 1, 0, 0, 0, 0) == C2D_ERR_ARGUMENT); // there is none
  // Other options: from the beginning.
  c2d_options options = keeping();
  options.quadrature = C2D_QUADRATURE_THESIS;
  REQUIRE(c2d_set_options(s, &options) == C2D_OK);
  REQUIRE(c2d_prepare(s) == C2D_OK);
  CHECK(kept.host.columns > 40);
  options = keeping();
  REQUIRE(c2d_change_loads(s) == C2D_OK);
  REQUIRE(c2d_set_options(s, &options) == C2D_OK);
  REQUIRE(c2d_prepare(s) == C2D_OK);
  // Cancelled at every chance: state model, and then everything anew.
  Runner fresh("hertz_lin_l", false, false);
  change_values(fresh.s, 0.8, true);
  REQUIRE(c2d_prepare(fresh.s) == C2D_OK);
  fresh.follow({0.7});
  Runner again("hertz_lin_l", false, true);
  REQUIRE(c2d_prepare(again.s) == C2D_OK);
  REQUIRE(c2d_change_loads(again.s) == C2D_OK);
  change_values(again.s, 0.8, true);
  int cancels = 0;
  for (int32_t n = 0;; n += 1 + n / 4) {
    CAPTURE(n);
    again.host.chances = n;
    const c2d_status status = c2d_prepare(again.s);
    again.host.chances = -1;
    if (status == C2D_OK) break;
    REQUIRE(status == C2D_ERR_CANCELLED);
    REQUIRE(c2d_get_state(again.s) == C2D_STATE_MODEL);
    REQUIRE(c2d_prepare(again.s) == C2D_OK);
    ++cancels;
    REQUIRE(c2d_change_loads(again.s) == C2D_OK);
  }
  CHECK(cancels > 10);
  again.follow({0.7});
  CHECK(difference(again.s, fresh.s) <= kRoundOff);
  // A store that fails at every operation breaks the solver.
  int broken = 0;
  for (size_t n = 0; n < 400; n += 1 + n / 3) {
    Runner victim("hertz_lin_l", false, true);
    REQUIRE(c2d_prepare(victim.s) == C2D_OK);
    REQUIRE(c2d_change_loads(victim.s) == C2D_OK);
    const size_t from = victim.host.done.size();
    victim.host.before = [=](const RamStore::Operation&, size_t i) { return i == from + n ? 9 : 0; };
    const c2d_status status = c2d_prepare(victim.s);
    victim.host.before = nullptr;
    if (status == C2D_OK) continue;
    REQUIRE(status >= C2D_ERR_STORE_OPEN);
    CHECK(c2d_get_state(victim.s) == C2D_STATE_BROKEN);
    ++broken;
  }
  CHECK(broken > 8);
  // Nor does a preparation from the beginning find the tapes of the one before that will not close.
  Runner victim("hertz_lin_l", false, false);
  REQUIRE(c2d_prepare(victim.s) == C2D_OK);
  REQUIRE(c2d_change_loads(victim.s) == C2D_OK);
  victim.host.before = [](const RamStore::Operation& operation, size_t) { return operation.kind == 'c' ? 9 : 0; };
  CHECK(c2d_prepare(victim.s) == C2D_ERR_STORE_CLOSE);
  CHECK(c2d_get_state(victim.s) == C2D_STATE_BROKEN);
  CHECK(error_of(victim.s).host_code == 9);
  victim.host.before = nullptr;
}

TEST_CASE("new loads: a state that is taken up in less memory, and loads changed there, as from the beginning") {
  Runner kept("hertz_lin_l", true, true);
  REQUIRE(c2d_prepare(kept.s) == C2D_OK);
  kept.follow({0.4});
  REQUIRE(c2d_save(kept.s) == C2D_OK);
  const host::Limits limits = kept.deck.limits();
  const uint64_t least = memory_for(limits, false), most = memory_for(limits, true);
  int through = 0, anew = 0;
  for (int part = 0; part <= 12; ++part) {
    CAPTURE(part);
    Host host;
    static_cast<RamStore&>(host) = kept.host; // its tapes
    host.port.context = static_cast<RamStore*>(&host);
    Machine other(limits, least + (most - least) * static_cast<uint64_t>(part) / 12, &host.port);
    REQUIRE(other.created == C2D_OK);
    const c2d_options options = keeping();
    REQUIRE(c2d_set_options(other.solver, &options) == C2D_OK);
    REQUIRE(read_deck(other.solver, kept.deck) == C2D_OK);
    const c2d_status status = c2d_restore(other.solver);
    if (status == C2D_ERR_MEMORY) continue;
    REQUIRE(status == C2D_OK);
    host.columns = 0;
    REQUIRE(c2d_change_loads(other.solver) == C2D_OK);
    change_values(other.solver, 0.9, true);
    REQUIRE(c2d_prepare(other.solver) == C2D_OK);
    (host.columns > 1 ? anew : through) += 1;
    const double mu = 0.3, load = 0.7;
    c2d_outcome outcome = -1;
    REQUIRE(c2d_begin(other.solver, &mu, 1) == C2D_OK);
    REQUIRE(c2d_advance(other.solver, &load, 1, &outcome) == C2D_OK);
    Runner fresh("hertz_lin_l", true, false);
    change_values(fresh.s, 0.9, true);
    REQUIRE(c2d_prepare(fresh.s) == C2D_OK);
    fresh.follow({0.7});
    CHECK(difference(other.solver, fresh.s) <= kRoundOff);
  }
  CHECK(through > 0);
  CHECK(anew > 0);
}
