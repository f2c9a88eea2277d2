// c2d_get_summary: model, path and cost.
#include <string.h>

#include "interface/model/refuse.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "results/balance.hpp"
#include "solver/energy/energy.hpp"
#include "solver/energy/motion.hpp"

namespace c2d {

const EnergyPart kEnergyPart = {true,         build_energy,  add_demanded,        hold_demanded,  work_by_case,
                                begin_energy, note_turn,     add_segment,         before_jump,    after_jump,
                                release,      close_balance, find_outcome_motion, balance_forces, add_boundary_force};

C2D_BRINGS(c2d_link_warnings); // the summary contains condition and tension ratio

namespace {

int32_t total_steps(c2d_solver* s) {
  int64_t steps = 0;
  for (int32_t p = 0; p < s->model.paths; ++p) steps += array_of<Path>(s, kPaths)[p].increments;
  return steps > INT32_MAX ? INT32_MAX : static_cast<int32_t>(steps);
}

void fill_model(c2d_solver* s, c2d_summary& out) {
  const ModelHeader& m = s->model;
  out.bodies = m.bodies;
  out.function_nodes = m.function_nodes;
  out.pairs = m.pairs;
  out.zones = m.zones;
  out.steps = total_steps(s);
  out.coefficients = m.coefficients;
  out.paths = m.paths;
  out.point_loads = m.point_loads;
  out.point_sets = m.point_sets;
  out.curves = m.curves;
  out.analysis = m.analysis;
  out.plane = m.plane;
  out.iteration_limit = m.iteration_limit;
  out.stepping = s->options.stepping;
  out.quadrature = s->options.quadrature;
  out.contact_unknowns = m.contact;
  memcpy(out.title, m.title, sizeof out.title);
  memcpy(out.unit_length, m.unit_length, sizeof out.unit_length);
  memcpy(out.unit_force, m.unit_force, sizeof out.unit_force);
  out.load_cases = m.load_cases;
  out.symmetry = m.symmetry;
  memcpy(out.symmetry_at, m.line_at, sizeof out.symmetry_at);
}

void fill_motion(c2d_solver* s, c2d_summary& out) {
  if (s->outcome_body < 1) return;
  const Body& body = body_numbered(s, s->outcome_body);
  // (ux, uy) of the centre and a rotation about it, as a motion about the origin.
  const double* motion = s->outcome_motion;
  const double rotation = motion[2] / s->model.length_unit;
  const double turned[2] = {rotation * body.centre[1], -rotation * body.centre[0]};
  for (int c = 0; c < 2; ++c) {
    const double sum = motion[c] + turned[c];
    out.free_motion[c] = fabs(sum) > 1e-9 * (fabs(motion[c]) + fabs(turned[c])) ? sum : 0.0;
  }
  out.free_motion[2] = rotation;
}

void fill_work(c2d_solver* s, c2d_summary& out) {
  for (int b = 0; b < s->sizes.bodies; ++b) {
    const EliminationPlan& plan = plan_of(s, b);
    if (plan.panel_columns > out.panel_columns) out.panel_columns = plan.panel_columns;
    if (!kSmallCode && plan.rank > 0) ++out.compressed_bodies;
  }
  out.warnings = s->warnings;
  out.run_step = s->run_step > 0 ? s->run_step : 0;
  out.run_coefficient = s->run_step > 0 ? s->coefficient : 0;
  out.events = s->stats.events;
  out.exchanges = s->exchanges;
  out.tableau_rebuilds = s->rebuilds;
  for (int32_t tape = 0; tape < C2D_TAPES; ++tape) {
    out.tape_blocks[tape] = s->tapes.blocks[tape];
    out.tape_bytes_written[tape] = s->tapes.bytes_written[tape];
    out.tape_bytes_read[tape] = s->tapes.bytes_read[tape];
    out.tape_writes[tape] = s->tapes.writes[tape];
    out.tape_reads[tape] = s->tapes.reads[tape];
  }
  memcpy(out.seconds, s->seconds, sizeof out.seconds);
  out.max_residual = s->max_residual;
  out.elimination_residual = s->pivot_growth;
  out.condition = s->condition;
  if (!kSmallCode) {
    out.compression_residual = s->compression_residual;
    out.compression_error = s->compression_error;
  }
  out.force_applied = s->force_applied;
  out.force_contact = s->force_contact;
  out.force_error = s->force_error;
  out.breach = s->outcome == C2D_BEYOND_LIMITS ? s->breach : int32_t{C2D_BREACH_NONE};
  out.breach_size = out.breach != C2D_BREACH_NONE ? s->breach_size : 0.0;
  out.tension_ratio = s->tension_ratio;
  out.work = s->work;
  out.dissipated = s->dissipated;
  out.elastic = s->elastic;
  out.energy_defect = s->energy_defect;
  out.least_dissipation = s->least_dissipation;
}

} // namespace
} // namespace c2d

using namespace c2d;

extern "C" c2d_status c2d_get_summary(c2d_solver* s, c2d_summary* out) {
  if (!s || s->magic != kSolverMagic) return C2D_ERR_ARGUMENT;
  if (!s->busy) s->has_fault = 0;
  c2d_summary ours;
  memset(&ours, 0, sizeof ours);
  ours.state = s->state;
  ours.outcome = s->outcome;
  ours.outcome_body = s->outcome_body;
  ours.outcome_pair = s->model.pairs > 0 ? s->last_pair + 1 : 0;
  fill_model(s, ours);
  fill_motion(s, ours);
  fill_work(s, ours);
  const c2d_limits limits = limits_of(sizes_of(s));
  c2d_memory_need(&limits, &ours.minimum_bytes, &ours.in_core_bytes, nullptr);
  ours.workspace_bytes = s->bytes;
  ours.peak_bytes = s->peak_bytes;
  if (s->state == C2D_STATE_RUNNING) ours.load = array_of<double>(s, kLoads)[0];
  ours.mu = s->mu;
  return give(s, "c2d_summary", ours, out);
}

extern "C" c2d_status c2d_get_body_result(c2d_solver* s, int32_t body, c2d_body_result* out) {
  if (!s || s->magic != kSolverMagic) return C2D_ERR_ARGUMENT;
  if (!s->busy) s->has_fault = 0;
  if (body < 1 || body > s->sizes.bodies)
    return s->busy ? c2d_status{C2D_ERR_ARGUMENT} : check_ranges(s, {{"body", body, 1, s->sizes.bodies}});
  c2d_body_result ours;
  memset(&ours, 0, sizeof ours);
  const Body& given = body_numbered(s, body);
  ours.element_nodes = given.element_nodes;
  ours.elements = given.elements;
  ours.regions = given.regions;
  ours.open_regions = given.open_regions;
  ours.points = given.geometry_nodes;
  ours.nodes = given.nodes;
  ours.unknowns = given.nodes > 0 && given.rigid == 0 ? 2 * given.nodes + 3 : 0;
  ours.youngs_modulus = given.youngs_modulus;
  ours.poisson_ratio = given.poisson_ratio;
  const BodyResults& results = results_of(s, body - 1);
  memcpy(ours.applied, results.applied, sizeof ours.applied);
  memcpy(ours.contact, results.contact_force, sizeof ours.contact);
  return give(s, "c2d_body_result", ours, out);
}
