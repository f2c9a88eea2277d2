#include "program/outputs/results.hpp"

#include "program/commands/drawn_words.hpp"
#include "program/outputs/output_row.hpp"
#include "program/progress.hpp"
#include "report/warnings.hpp"

namespace app {

c2d_status RunResults::begin(uint32_t needs_) {
  needs = needs_;
  path.history.begin(summary.steps);
  c2d_solver* const solver = session.solver;
  c2d_status status = find_crack_tips(solver, summary, tips);
  if (status == C2D_OK) status = find_zone_lines(solver, summary, lines);
  if (session.deck.is_made()) take_statements(session.deck.text(), lines);
  for (int32_t i = 1; i <= summary.coefficients && status == C2D_OK; ++i) {
    record.friction.push_back(0.0);
    status = c2d_get_friction(solver, 0, i, &record.friction.back());
  }
  for (int32_t i = 1; i <= summary.zones && status == C2D_OK; ++i) {
    c2d_zone zone = C2D_INIT(c2d_zone);
    status = c2d_get_zone(solver, i, &zone);
    record.zone_friction.push_back(0.0);
    if (status == C2D_OK) status = c2d_get_friction(solver, i, 1, &record.zone_friction.back());
    const bool is_free = (zone.kind & C2D_ZONE_FREE) != 0;
    record.measure.push_back(is_free ? zone.side2.body : zone.side1.body); // the first has nodes on side 2
  }
  if (status == C2D_OK && (needs & kNeedsPlaces) != 0) {
    status = add_end_places(solver, summary, places);
    interior.add_places(places);
  }
  // They cost more time than the solution of a small deck.
  if (status == C2D_OK && (needs & kNeedsCorners) != 0) status = find_corners(solver, summary, corners);
  return status;
}

c2d_status RunResults::read_stresses() {
  stresses.clear();
  const c2d_status status = add_end_stresses(session.solver, summary, stresses);
  return status == C2D_OK ? interior.add_stresses(session.solver, summary.bodies, stresses) : status;
}

c2d_status RunResults::take(const c2d_step& step, StepResults& now) {
  if (step.kind == C2D_STEP_CYCLE) {
    c2d_status status = keep_cycle(record, step, session.solver, summary.zones);
    now.record = &record.coefficients[static_cast<size_t>(step.coefficient) - 1];
    keep_cycle_start(*now.record, step, (needs & kNeedsSums) != 0 ? session.solver : nullptr, lines);
    std::vector<FollowedZone> followed;
    if (status == C2D_OK && (needs & kNeedsPictures) != 0) {
      status = find_followed(session.solver, lines, step.pairs, followed);
      path.history.note_cycle(step, std::move(followed));
    }
    if (status != C2D_OK || now.record->steps.empty() || now.record->steps.back().stresses.empty()) return status;
    const c2d_status read = read_stresses(); // ranges of the last cycle begin with them
    now.record->steps.back().stresses = stresses;
    return read;
  }
  if ((needs & kNeedsPictures) != 0) path.history.note(step);
  if (step.kind == C2D_STEP_CHANGE && !shows_changes) return C2D_OK;
  const size_t index = static_cast<size_t>(step.coefficient) - 1;
  const CoefficientRecord* const before = index < record.coefficients.size() ? &record.coefficients[index] : nullptr;
  const bool again = before != nullptr && !before->table.empty() && before->load == step.load;
  now.record = &keep_step(record, step);
  const bool stopped = step.kind == C2D_STEP_STOPPED, ends_here = stopped || step.step == summary.steps;
  const bool sums_up = (needs & kNeedsSums) != 0 || ((needs & kNeedsLastSums) != 0 && ends_here);
  keep_history(*now.record, step, sums_up ? session.solver : nullptr, tips, lines);
  if (c2d_get_state(session.solver) == C2D_STATE_BROKEN) return session.last_error().status; // by a fault of the store
  now.adds_row = step.kind == C2D_STEP_RECORDED || (stopped && !again);
  if (stopped) {
    c2d_summary at_stop = C2D_INIT(c2d_summary);
    c2d_get_summary(session.solver, &at_stop);
    explain(*now.record, at_stop, summary, session.messages.latest());
    if (session.deck.is_made()) now.record->why = in_words_of_drawing(now.record->why, session.deck.text());
    session.messages.forget_latest();
  }
  return now.adds_row && !places.empty() ? read_stresses() : C2D_OK;
}

void RunResults::stop_before_load(c2d_status status) {
  for (int32_t i = 1; i <= summary.coefficients; ++i) {
    CoefficientRecord none;
    none.singular = true;
    none.why = session.messages.latest().empty() ? c2d_message(status) : session.messages.latest();
    c2d_get_friction(session.solver, 0, i, &none.mu);
    record.coefficients.push_back(none);
  }
}

c2d_status RunResults::finish() {
  c2d_solver* const solver = session.solver;
  solved = c2d_get_state(solver) == C2D_STATE_RUNNING;
  c2d_status status = get_summary(solver, summary);
  record.take_stated_errors();
  if (status == C2D_OK && solved) status = corner_states(solver, summary, corners, record.corners);
  if (status != C2D_OK || !solved || !interior.any()) return status;
  status = interior.evaluate(solver, summary.bodies);
  if (status == C2D_OK) record.interior = &interior.results();
  return status;
}

c2d_status RunResults::draw() {
  record.warnings = session.messages.warnings();
  if (record.interior != nullptr) interior.report_places(session.messages, summary, record.warnings);
  order_warnings(record.warnings);
  c2d_status status = C2D_OK;
  if ((needs & kNeedsScene) != 0) status = gather_scene(session.solver, record, path.history, scene);
  if (status != C2D_OK || (needs & kNeedsPictures) == 0) return status;
  status = draw_pictures(scene, pictures);
  return status == C2D_OK ? get_summary(session.solver, scene.summary) : status;
}

c2d_status RunResults::refresh() {
  const c2d_status status = get_summary(session.solver, summary);
  record.write_seconds = time_left() - record.read_seconds;
  return status;
}

double RunResults::time_left() const {
  double left = clock_seconds(nullptr) - begun;
  for (const double seconds : summary.seconds) left -= seconds;
  return left;
}

std::vector<double> RunResults::loads_reached() const {
  return record.coefficients.empty() ? std::vector<double>{summary.load} : record.coefficients.back().loads;
}

} // namespace app
