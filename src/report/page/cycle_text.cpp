// What a cycle that was repeated came to, in words.
#include "report/record.hpp"

#include "report/text.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

std::string in_cycle(const CycleSeen& last) { return "steady in cycle " + std::to_string(last.cycles) + ": "; }

// "body 2 on body 1 by 0.1 (zone 1)" of each zone that walks.
std::string walks_of(const CycleSeen& last, const Summary& s) {
  constexpr double kSmall = 1e-6; // of the largest: no walk
  double most = 0;
  for (const ZoneCycle& zone : last.zones) most = std::max(most, std::fabs(zone.walk));
  std::string out;
  for (size_t z = 0; z < last.zones.size() && z < s.zone.size(); ++z) {
    if (!(std::fabs(last.zones[z].walk) > kSmall * most)) continue;
    out +=
        (out.empty() ? "" : ", ") + body_text(s, s.zone[z].side2.body) + " on " + body_text(s, s.zone[z].side1.body) + " by ";
    append_general(out, last.zones[z].walk, 0);
  }
  return out;
}

} // namespace

const CoefficientRecord* RunRecord::unsteady() const {
  for (const CoefficientRecord& c : coefficients)
    if (c.outcome == C2D_REACHED && !c.cycles.empty() && c.cycles.back().result == C2D_CYCLE_NOT_STEADY) return &c;
  return nullptr;
}

std::string cycle_text(const CoefficientRecord& c, const Summary& s) {
  const CycleSeen& last = c.cycles.back();
  switch (last.result) {
  case C2D_CYCLE_SHAKES_DOWN: return in_cycle(last) + "it shakes down, no pair slips any more";
  case C2D_CYCLE_SLIPS: return in_cycle(last) + "pairs slip forth and back by the same amount";
  case C2D_CYCLE_RATCHETS:
    return in_cycle(last) + "it ratchets, surfaces move on in each cycle" +
           (walks_of(last, s).empty() ? "" : ": " + walks_of(last, s) + " along t");
  default: break;
  }
  std::string out = "not steady after " + std::to_string(last.cycles) + (last.cycles == 1 ? " cycle" : " cycles");
  append_general(out += ": over the last one pressures, friction or gaps changed by ", last.change, 0, 3);
  return out + " of the largest";
}

std::string other_start_text(const CoefficientRecord& c) {
  const OtherStart& other = c.other_start[0];
  if (!other.why.empty()) return "the start without friction is not known: " + other.why;
  std::string out = "a start without friction ends ";
  if (other.last.result == C2D_CYCLE_NOT_STEADY)
    out += "in no steady cycle after " + std::to_string(other.last.cycles) + " cycles";
  else
    out += other.same ? "in the same cycle" : "in another cycle: the state depends on how the loads began";
  append_general(out += "; pressures and friction differ by ", other.apart, 0, 3);
  append_general(out += " of the largest pressure, the energy dissipated in a cycle is ", other.last.dissipated, 0);
  append_general(out += " instead of ", c.cycles.back().dissipated, 0);
  return out;
}

std::string unsteady_text(const CoefficientRecord& c, const Summary& s) {
  std::string text = "mu ";
  append_number(text, c.mu);
  return text + ": the cycle is " + cycle_text(c, s);
}

const char* cycle_word(int32_t result) {
  switch (result) {
  case C2D_CYCLE_SHAKES_DOWN: return "shakes down";
  case C2D_CYCLE_SLIPS: return "slips";
  case C2D_CYCLE_RATCHETS: return "ratchets";
  case C2D_CYCLE_STOPPED: return "stopped";
  default: return "not steady";
  }
}

c2d_status keep_cycle(RunRecord& record, const c2d_step& step, c2d_solver* solver, int32_t zones) {
  const size_t index = step.coefficient > 0 ? static_cast<size_t>(step.coefficient) - 1 : 0;
  if (record.coefficients.size() <= index) record.coefficients.resize(index + 1);
  CycleSeen now;
  const c2d_status status = find_cycle_seen(solver, zones, now);
  now.elastic = step.elastic;
  CoefficientRecord& c = record.coefficients[index];
  c.changes += step.changes;
  c.cycles.push_back(now);
  for (size_t p = 0; p < c.slip.size(); ++p) // that of the turn at which the recorded cycle begins
    c.slip[p] = step.table[static_cast<int64_t>(p) * step.stride + C2D_SLIP_SUM];
  return status;
}

} // namespace app
