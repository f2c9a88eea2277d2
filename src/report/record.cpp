#include "report/record.hpp"

#include "report/text.hpp"

#include <cmath>
#include <cstddef>

namespace app {

const CoefficientRecord* RunRecord::incomplete() const {
  for (const CoefficientRecord& c : coefficients)
    if (c.outcome != C2D_REACHED || c.singular) return &c;
  return nullptr;
}

void RunRecord::take_stated_errors() {
  if (coefficients.empty() || coefficients.front().steps.empty()) return;
  for (Quantity& q : coefficients.front().steps.back().quantities)
    for (const Stated& s : meshes.stated)
      if (s.zone == q.zone && s.item == q.item && s.what == q.what) q.error = s.error;
}

const char* RunRecord::outcome() const {
  const CoefficientRecord* stopped = incomplete();
  if (checked_only) return "checked";
  if (stopped != nullptr && stopped->singular) return "singular";
  if (stopped == nullptr && unsteady() != nullptr) return "not steady";
  return outcome_word(stopped == nullptr ? C2D_REACHED : stopped->outcome);
}

std::string fault_of_steps(const c2d_summary& model) {
  const int64_t all = int64_t{model.steps} * model.coefficients;
  if (all <= kMostSteps) return {};
  return "the load cards make " + std::to_string(model.steps) +
         (model.steps == INT32_MAX ? " increments or more" : " increments") + ", with " + std::to_string(model.coefficients) +
         (model.coefficients == 1 ? " coefficient" : " coefficients") + " of friction; expected at most " +
         std::to_string(kMostSteps) + " in all, each of which is kept and printed";
}

CoefficientRecord& keep_step(RunRecord& record, const c2d_step& step) {
  const size_t index = step.coefficient > 0 ? static_cast<size_t>(step.coefficient) - 1 : 0;
  if (record.coefficients.size() <= index) record.coefficients.resize(index + 1);
  CoefficientRecord& c = record.coefficients[index];
  c.mu = step.mu;
  if (step.kind == C2D_STEP_CHANGE) return c;
  c.load = step.load;
  c.loads.assign(step.loads, step.loads + step.cases);
  c.step = step.step;
  c.changes += step.changes;
  c.outcome = step.kind == C2D_STEP_STOPPED ? step.outcome : C2D_REACHED;
  c.table.resize(static_cast<size_t>(step.pairs) * C2D_PAIR_FIELDS);
  for (int32_t p = 0; p < step.pairs; ++p)
    for (int32_t k = 0; k < C2D_PAIR_FIELDS; ++k)
      c.table[static_cast<size_t>(p) * C2D_PAIR_FIELDS + static_cast<size_t>(k)] = step.table[p * step.stride + k];
  return c;
}

bool is_repeated(const CoefficientRecord& c, size_t i) {
  return c.outcome != C2D_REACHED && i + 2 == c.steps.size() && c.steps[i].loads == c.steps[i + 1].loads;
}

std::string load_reached(const CoefficientRecord& c) {
  std::string text = c.loads.size() > 1 ? "load factors " : "load factor ";
  if (c.loads.size() < 2) append_number(text, c.load);
  for (size_t k = 0; k < c.loads.size() && c.loads.size() > 1; ++k) {
    if (k > 0) text += ", ";
    append_number(text, c.loads[k]);
  }
  return text;
}

std::string incomplete_text(const CoefficientRecord& c) {
  std::string text = "incomplete: mu ";
  append_number(text, c.mu);
  return text + ", step " + std::to_string(c.step) + ", " + load_reached(c) + ": " + c.why;
}

namespace {

// Do the loads leave the last step in another direction than they arrived?
bool has_turned(const std::vector<StepRecord>& steps, const c2d_step& step) {
  if (steps.empty()) return false;
  double before = 0, after = 0, product = 0;
  for (size_t k = 0; k < steps.back().loads.size(); ++k) {
    const double now = step.loads[k] - steps.back().loads[k];
    const double then = steps.back().loads[k] - (steps.size() > 1 ? steps[steps.size() - 2].loads[k] : 0.0);
    before += then * then, after += now * now, product += then * now;
  }
  return after > 0 && product < (1 - 1e-9) * std::sqrt(before * after);
}

// Slip is summed over the whole path; stick borders follow from the slip since the last reversal.
void note_slip(CoefficientRecord& c, const c2d_step& step) {
  if (has_turned(c.steps, step)) c.slip_at_turn = c.slip;
  c.slip.resize(static_cast<size_t>(step.pairs));
  for (int32_t p = 0; p < step.pairs; ++p) c.slip[static_cast<size_t>(p)] = step.table[p * step.stride + C2D_SLIP_SUM];
}

StepRecord read_step(const CoefficientRecord& c, const c2d_step& step, c2d_solver* solver, const std::vector<CrackTip>& tips,
                     const std::vector<ZoneLine>& lines) {
  StepRecord now;
  now.step = step.step;
  now.work = step.work;
  now.dissipated = step.dissipated;
  now.elastic = step.elastic;
  now.defect = step.energy_defect;
  now.loads.assign(step.loads, step.loads + step.cases);
  now.work_by_case.assign(step.work_by_case, step.work_by_case + step.cases);
  c2d_zone_state zone = C2D_INIT(c2d_zone_state);
  for (int32_t i = 1; solver != nullptr && c2d_get_zone_state(solver, i, &zone) == C2D_OK; ++i) now.zones.push_back(zone);
  turn_forces(lines, now.zones);
  c2d_body_state body = C2D_INIT(c2d_body_state);
  for (int32_t b = 1; solver != nullptr && c2d_get_body_state(solver, b, &body) == C2D_OK; ++b) now.bodies.push_back(body);
  for (const CrackTip& tip : tips) now.cracks.push_back(stress_intensity(tip, step.table, step.stride));
  CycleResults cycle;
  const bool repeats = solver != nullptr && !c.cycles.empty() &&
                       find_cycle_results(solver, static_cast<int32_t>(lines.size()), step.pairs, cycle) == C2D_OK;
  if (solver != nullptr)
    now.quantities = quantities_of(lines, step.table, step.stride, now.zones, step.dissipated, c.slip_at_turn, now.bodies,
                                   repeats ? &cycle : nullptr);
  return now;
}

} // namespace

void keep_history(CoefficientRecord& c, const c2d_step& step, c2d_solver* solver, const std::vector<CrackTip>& tips,
                  const std::vector<ZoneLine>& lines) {
  if (step.kind == C2D_STEP_CHANGE) return;
  note_slip(c, step);
  c.steps.push_back(read_step(c, step, solver, tips, lines));
}

void keep_cycle_start(CoefficientRecord& c, const c2d_step& step, c2d_solver* solver, const std::vector<ZoneLine>& lines) {
  c.cycle_start.assign(1, read_step(c, step, solver, {}, lines));
}

void keep_corners(CoefficientRecord& c, const c2d_step& step, const std::vector<Corner>& corners) {
  if (step.kind == C2D_STEP_CHANGE || step.kind == C2D_STEP_CYCLE || c.steps.empty()) return;
  for (const Corner& corner : corners) {
    if (corner.zone == 0) continue;
    const CornerState now = corner_state(corner, step.table, step.stride);
    if (!now.exponents.empty()) c.steps.back().corners.push_back(now);
  }
}

void explain(CoefficientRecord& c, const c2d_summary& summary, const Summary& model, const std::string& said) {
  c.why = c2d_outcome_message(c.outcome);
  if (!said.empty() && said != c.why) c.why += ": " + said;
  if (summary.breach != C2D_BREACH_NONE) c.why += std::string(": ") + breach_word(summary.breach);
  if (summary.breach_size > 0.0) append_general(c.why += ", relative ", summary.breach_size, 0);
  c.body = summary.outcome_body;
  c.pair = summary.outcome_pair;
  const double* motion = summary.free_motion;
  if (c.body > 0 && (motion[0] != 0.0 || motion[1] != 0.0 || motion[2] != 0.0)) {
    c.why += "; " + body_text(model, c.body) + " can move by (";
    append_general(c.why, motion[0], 0);
    c.why += ", ";
    append_general(c.why, motion[1], 0);
    c.why += ") and turn by ";
    append_general(c.why, motion[2], 0);
    c.why += " about the origin";
  } else if (c.body > 0) {
    c.why += "; " + body_text(model, c.body) + " can move";
  }
  if (c.pair > 0) c.why += "; last pair " + std::to_string(c.pair);
}

namespace {

// Pairs of a free zone by their places on side 1.
c2d_status add_places(c2d_solver* solver, const Summary& summary, int32_t zone, std::vector<ContactEnd>& ends) {
  std::vector<double> v[5];
  const c2d_status status = get_pairs(
      solver, summary, {{C2D_PAIR_ZONE, v[0]}, {C2D_PAIR_ELEMENT1, v[1]}, {C2D_PAIR_ETA1, v[2]}, {C2D_X, v[3]}, {C2D_Y, v[4]}});
  if (status != C2D_OK) return status;
  for (size_t p = 0; p < v[0].size(); ++p)
    if (static_cast<int32_t>(v[0][p]) == zone)
      ends.push_back({zone, static_cast<int32_t>(v[1][p]), 0, static_cast<int32_t>(p) + 1, 1, v[3][p], v[4][p], v[2][p]});
  return C2D_OK;
}

// The pair at a node of a body and the side on which the body is; pair 0: none.
struct NodePair {
  int32_t pair = 0, side = 0;
};

// For every functional node of a body, from 1.
c2d_status find_pairs(c2d_solver* solver, const Summary& summary, int32_t body, std::vector<NodePair>& out) {
  std::vector<double> v[3];
  const c2d_status status = get_pairs(solver, summary, {{C2D_PAIR_NODE1, v[0]}, {C2D_PAIR_NODE2, v[1]}, {C2D_PAIR_ZONE, v[2]}});
  if (status != C2D_OK) return status;
  out.assign(static_cast<size_t>(summary.body[body - 1].nodes) + 1, NodePair{});
  for (size_t p = 0; p < v[2].size(); ++p) {
    const c2d_zone& zone = summary.zone[static_cast<size_t>(v[2][p]) - 1];
    const int32_t bodies[2] = {zone.side1.body, zone.side2.body};
    for (int32_t side = 1; side <= 2; ++side) {
      const size_t node = static_cast<size_t>(v[side - 1][p]); // 0: a point between nodes
      if (bodies[side - 1] == body && node > 0 && node < out.size()) out[node] = {static_cast<int32_t>(p) + 1, side};
    }
  }
  return C2D_OK;
}

} // namespace

c2d_status find_contact_ends(c2d_solver* solver, const Summary& summary, int32_t body, std::vector<ContactEnd>& ends) {
  ends.clear();
  if (summary.pairs == 0) return C2D_OK;
  std::vector<NodePair> at;
  c2d_status status = find_pairs(solver, summary, body, at);
  if (status != C2D_OK) return status;
  const int32_t fields[] = {C2D_END_NODE, C2D_END_X, C2D_END_Y};
  std::vector<std::vector<double>> values;
  status = get_ends(solver, summary, body, fields, 3, values);
  if (status != C2D_OK) return status;
  for (int32_t z = 1; z <= summary.zones; ++z) {
    const c2d_zone& zone = summary.zone[static_cast<size_t>(z) - 1];
    if (zone.side1.body != body && zone.side2.body != body) continue;
    const c2d_side& side = zone.side1.body == body ? zone.side1 : zone.side2;
    if (side.first_node == 0) {
      status = add_places(solver, summary, z, ends);
      if (status != C2D_OK) return status;
      continue;
    }
    const int32_t first = side.first_element, last = side.last_element;
    const int32_t low = first < last ? first : last, high = first < last ? last : first;
    for (int32_t e = low; e <= high; ++e)
      for (int32_t local = 1; local <= summary.function_nodes; ++local) {
        const size_t i = static_cast<size_t>((e - 1) * summary.function_nodes + local - 1);
        const size_t node = i < values[0].size() ? static_cast<size_t>(values[0][i]) : 0;
        if (node < at.size() && at[node].pair != 0)
          ends.push_back({z, e, local, at[node].pair, at[node].side, values[1][i], values[2][i], 0.0});
      }
  }
  return C2D_OK;
}

} // namespace app
