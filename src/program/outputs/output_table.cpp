#include "program/outputs/output_row.hpp"
#include "program/outputs/results.hpp"
#include "report/csv.hpp"
#include "report/json/json.hpp"
#include "report/listing/listing.hpp"
#include "report/page/page.hpp"
#include "report/vtk.hpp"

namespace app {
namespace {

template <void (*header)(std::string&)> c2d_status heading(RunResults&, std::string& out) {
  header(out);
  return C2D_OK;
}
template <void (*header)(std::string&, int32_t)> c2d_status heading(RunResults& run, std::string& out) {
  header(out, run.summary.load_cases);
  return C2D_OK;
}

template <void (*append)(std::string&, const RunRecord&, const Summary&)> c2d_status ending(RunResults& run, std::string& out) {
  append(out, run.record, run.summary);
  return C2D_OK;
}

void step_contact(RunResults& run, const StepResults& now, std::string& out) {
  if (now.adds_row) append_contact_rows(out, now.step, run.summary);
}

c2d_status end_boundary(RunResults& run, std::string& out) {
  return run.solved ? append_boundary(out, run.session.solver, run.summary) : C2D_OK;
}

c2d_status end_interior(RunResults& run, std::string& out) {
  if (run.record.interior != nullptr) append_interior_rows(out, *run.record.interior);
  return C2D_OK;
}

// With the requested points, or a grid over each body.
c2d_status end_vtk(RunResults& run, std::string& out) {
  InteriorPoints all;
  c2d_status status = C2D_OK;
  if (!run.interior.any() && run.solved) status = all.take_bodies(run.session.solver, run.summary);
  if (status == C2D_OK && all.any()) status = all.evaluate(run.session.solver, run.summary.bodies);
  if (status != C2D_OK) return status;
  return append_vtk(out, run.scene, all.any() ? all.results() : run.interior.results());
}

c2d_status end_report(RunResults& run, std::string& out) {
  append_page(out, run.scene, run.pictures, run.session.deck.name());
  return C2D_OK;
}

void step_trace(RunResults& run, const StepResults& now, std::string& out) { run.path.trace.append(out, now.step); }

void step_bodies(RunResults& run, const StepResults& now, std::string& out) {
  if (now.adds_row) append_bodies_rows(out, now.step, run.session.solver);
}

void step_stresses(RunResults& run, const StepResults& now, std::string& out) {
  if (now.adds_row) append_stresses_rows(out, now.step, run.places, run.stresses);
}

void step_ranges(RunResults& run, const StepResults& now, std::string&) {
  if (now.adds_row) now.record->steps.back().stresses = run.stresses;
}

c2d_status end_ranges(RunResults& run, std::string& out) {
  append_ranges(out, run.record, run.places);
  return C2D_OK;
}

void step_json(RunResults& run, const StepResults& now, std::string&) {
  if (now.record != nullptr) keep_corners(*now.record, now.step, run.corners);
}

// Complete, or its summary alone (has_short_listing).
c2d_status begin_listing(RunResults& run, std::string& out) {
  if (run.has_short_listing) return C2D_OK;
  c2d_solver* const solver = run.session.solver;
  c2d_status status = append_model(out, solver, run.summary, run.session.deck.heading());
  run.ends.resize(static_cast<size_t>(run.summary.bodies));
  for (int32_t body = 1; body <= run.summary.bodies && status == C2D_OK && run.summary.pairs > 0; ++body)
    status = find_contact_ends(solver, run.summary, body, run.ends[static_cast<size_t>(body) - 1]);
  return status;
}

void step_listing(RunResults& run, const StepResults& now, std::string& out) {
  if (run.has_short_listing || now.record == nullptr) return;
  const bool first = run.path.coefficient_shown != now.step.coefficient; // of its coefficient of friction
  if (first && run.path.coefficient_shown > 0) append_contact_zone(out, *(now.record - 1), run.ends.data(), run.summary);
  append_step(out, now.step, first);
  run.path.coefficient_shown = now.step.coefficient;
}

c2d_status end_listing(RunResults& run, std::string& out) {
  if (run.has_short_listing) return ending<append_short_ending>(run, out);
  if (!run.record.coefficients.empty()) append_contact_zone(out, run.record.coefficients.back(), run.ends.data(), run.summary);
  const bool all = run.summary.analysis == C2D_ANALYSIS_STRESS || run.summary.analysis >= C2D_ANALYSIS_FULL;
  if (run.solved && all) {
    c2d_status status = append_global(out, run.session.solver, run.summary, run.loads_reached());
    if (status == C2D_OK) status = run.refresh();
    if (status != C2D_OK) return status;
  }
  if (run.record.interior != nullptr) append_interior_section(out, *run.record.interior, run.summary, run.loads_reached());
  if (run.solved && (run.needs & kNeedsTables) != 0) append_key_tables(out, run.record, run.summary);
  return ending<append_ending>(run, out);
}

} // namespace

const std::array<OutputRow, kOutputs> kOutputTable = {{
    {"--listing", "listing.txt", kNeedsLastSums | kNeedsTimes, begin_listing, step_listing, end_listing},
    {"--csv", "contact.csv", kInputsBeside, heading<append_contact_header>, step_contact, nullptr},
    {"--boundary", "boundary.csv", kInputsBeside, heading<append_boundary_header>, nullptr, end_boundary},
    {"--interior", "interior.csv", kInputsBeside, heading<append_interior_header>, nullptr, end_interior},
    {"--json", "run.json", kNeedsSums | kNeedsCorners | kNeedsTimes, nullptr, step_json, ending<append_json>},
    {"--report", "report.html", kNeedsPictures | kNeedsScene | kNeedsChanges | kNeedsSums | kNeedsCorners, nullptr, nullptr,
     end_report},
    {"--vtk", "boundary.vtk", kNeedsScene | kInputsBeside, nullptr, nullptr, end_vtk},
    {"--trace", "trace.csv", kInputsBeside | kNeedsChanges, heading<append_trace_header>, step_trace, nullptr},
    {"--bodies", "bodies.csv", kInputsBeside, heading<append_bodies_header>, step_bodies, nullptr},
    {"--summary", "summary.csv", kInputsBeside | kNeedsSums | kNeedsTables, nullptr, nullptr, ending<append_summary>},
    {"--stresses", nullptr, kInputsBeside | kNeedsPlaces, heading<append_stresses_header>, step_stresses, nullptr},
    {"--ranges", nullptr, kInputsBeside | kNeedsPlaces, nullptr, step_ranges, end_ranges},
}};

} // namespace app
