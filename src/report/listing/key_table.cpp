#include "report/listing/key_table.hpp"

#include "report/listing/listing_items.hpp"
#include "report/text.hpp"

#include <algorithm>

namespace app {
namespace {

std::string number(double value, int digits) {
  std::string out;
  append_general(out, value, 0, digits);
  return out;
}

const Quantity* find(const StepRecord& step, Measure what, int32_t zone) {
  for (const Quantity& q : step.quantities)
    if (q.what == what && q.zone == zone) return &q;
  return nullptr;
}

// Of all steps: at the end of a cycle nothing may be left beside which a number is round-off.
RoundOff round_off_of(const CoefficientRecord& c) {
  RoundOff out{0.0, 0.0};
  for (const StepRecord& step : c.steps) {
    const RoundOff own = round_off(step.quantities, extent_of(step.quantities));
    out = {std::max(out.force, own.force), std::max(out.size, own.size)};
  }
  return out;
}

struct RowMaker {
  const StepRecord& step;
  int32_t zone;
  int digits;
  const RoundOff& noise;

  std::string value_of(Measure what) const {
    const Quantity* q = find(step, what, zone);
    return q != nullptr ? number(noise.shown(what, q->value, q->error), digits) : "-";
  }

  // Of all items of a kind.
  std::string values_of(Measure what) const {
    std::string out;
    for (const Quantity& q : step.quantities)
      if (q.what == what && q.zone == zone)
        out += (out.empty() ? "" : ", ") + number(shown_value(q.what, q.value, q.along), digits);
    return out.empty() ? "-" : out;
  }

  std::vector<std::string> row() const {
    std::vector<std::string> row{std::to_string(step.step)};
    for (const double load : step.loads) row.push_back(number(load, digits));
    const Quantity* peak = find(step, Measure::kPeakPressure, zone);
    row.push_back(value_of(Measure::kPeakPressure));
    if (peak != nullptr)
      for (const double place : {peak->at[0], peak->at[1], peak->along}) row.push_back(number(place, digits));
    else
      row.insert(row.end(), 3, "-");
    for (const Measure what : {Measure::kForceX, Measure::kForceY, Measure::kMoment, Measure::kShift, Measure::kSlipRange})
      row.push_back(value_of(what));
    row.push_back(value_of(Measure::kDissipated));
    for (const Measure what : {Measure::kContactEdge, Measure::kStickBorder}) row.push_back(values_of(what));
    for (const Measure what : {Measure::kContactWidth, Measure::kStuckWidth, Measure::kEccentricity})
      row.push_back(value_of(what));
    return row;
  }
};

} // namespace

bool KeyTable::is_list(size_t column) const {
  const std::string& name = heading[column];
  return !name.empty() && name.find(' ') != std::string::npos && name.back() == 's';
}

KeyTable key_table(const CoefficientRecord& c, int32_t zone, int digits) {
  KeyTable out;
  const RoundOff noise = round_off_of(c);
  const size_t first = c.steps.size() > kMostKeyRows ? c.steps.size() - kMostKeyRows : 0;
  for (size_t i = first; i < c.steps.size(); ++i)
    if (!c.steps[i].quantities.empty() && !is_repeated(c, i))
      out.rows.push_back(RowMaker{c.steps[i], zone, digits, noise}.row());
  if (out.rows.empty()) return out;
  out.heading = {"step"};
  for (size_t k = 1; k <= c.steps.back().loads.size(); ++k) out.heading.push_back(k == 1 ? "load" : "load" + std::to_string(k));
  for (const char* name : {"peak pressure", "at x", "at y", "peak along", "force x", "force y", "moment", "shift", "slip range",
                           "dissipated", "contact edges", "stick borders", "contact width", "stuck width", "eccentricity"})
    out.heading.emplace_back(name);
  return out;
}

} // namespace app
