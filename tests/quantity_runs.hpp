// Families and models, followed step by step with what sums up their contact.
#pragma once

#include "family_runs.hpp"
#include "many_bodies.hpp"
#include "post/quantities.hpp"
#include "report/record.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <sstream>
#include <string>

namespace quantities_test {

using namespace app;

struct Run {
  Summary summary;
  std::vector<ZoneLine> lines;
  CoefficientRecord record;

  const std::vector<Quantity>& last() const { return record.steps.back().quantities; }
  std::vector<Quantity> all(Measure what, int32_t zone = 1) const { return all(last(), what, zone); }
  static std::vector<Quantity> all(const std::vector<Quantity>& from, Measure what, int32_t zone = 1) {
    std::vector<Quantity> out;
    for (const Quantity& q : from)
      if (q.what == what && q.zone == zone) out.push_back(q);
    return out;
  }
  Quantity one(Measure what, int32_t zone = 1) const {
    const std::vector<Quantity> found = all(what, zone);
    REQUIRE_MESSAGE(found.size() == 1, name_of(what));
    return found.front();
  }
};

struct Follower {
  c2d_solver* solver;
  Run& run;
};

inline Run follow(many::Machine& machine) {
  Run run;
  REQUIRE(machine.status == C2D_OK);
  REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
  REQUIRE(get_summary(machine.solver, run.summary) == C2D_OK);
  REQUIRE(find_zone_lines(machine.solver, run.summary, run.lines) == C2D_OK);
  Follower follower{machine.solver, run};
  const auto note = [](void* context, const c2d_step* step) {
    Follower& f = *static_cast<Follower*>(context);
    keep_history(f.run.record, *step, f.solver, {}, f.run.lines);
    return int32_t{0};
  };
  REQUIRE(c2d_run(machine.solver, note, &follower) == C2D_OK);
  REQUIRE(!run.record.steps.empty());
  return run;
}
inline Run follow(const many::Model& model) {
  many::Machine machine(model);
  return follow(machine);
}
inline Run make(const std::string& family, const std::vector<std::string>& settings = {}) {
  std::string deck, error;
  REQUIRE_MESSAGE(families::make_deck(family, settings, deck, error), error);
  many::Machine machine(deck);
  return follow(machine);
}
inline std::string number(const char* key, double value) {
  std::ostringstream out;
  out << key << "=" << value;
  return out.str();
}

} // namespace quantities_test
