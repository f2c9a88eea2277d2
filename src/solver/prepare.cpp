// Assemble, eliminate, reduce: from the model to the contact tableau on the tape.

#include "solver/prepare.hpp"
#include "bie/integrals/batch.hpp"
#include "bie/panel.hpp"
#include "contact/basis.hpp"
#include "contact/frictionless.hpp"
#include "contact/reduction/reduction.hpp"
#include "contact/reduction/reduction_plan.hpp"
#include "elimination/far_sums.hpp"
#include "memory/hostile.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "memory/text.hpp"
#include "model/free_zones.hpp"
#include "model/rigid.hpp"
#include "model/validate/validate.hpp"
#include "model/validate/validate_finding.hpp"
#include "solver/energy/energy.hpp"
#include "solver/judge.hpp"
#include "solver/model_hash.hpp"
#include "solver/phases.hpp"
#include "solver/port.hpp"
#include "solver/session.hpp"
#include "solver/support.hpp"

namespace c2d {

C2D_USES(EnergyPart);
C2D_USES(CompressedPart);
C2D_USES(NewLoadsPart);
C2D_USES(WarningPart);

void plan_bodies(c2d_solver* s, const Model& m) {
  find_support(s, m);
  plan_reduction(m);
  if (!kSmallCode) kCompressedPart.plan_demand(s, m);
}

TapeShapes shape_tapes(c2d_solver* s, const Model& m) {
  TapeShapes out = {};
  uint64_t *const blocks = out.blocks, *const data = out.data;
  for (int b = 0; b < m.head->bodies; ++b) {
    if (is_rigid(m, b)) continue;
    EliminationPlan& plan = plan_of(s, b);
    TapeUse lower, upper;
    if (is_compressed(plan)) {
      kCompressedPart.compression_uses(m, b, plan, lower, upper);
    } else {
      lower = lower_use(plan);
      upper = upper_use(plan);
    }
    plan.lower_first_block = blocks[C2D_TAPE_LOWER];
    plan.upper_first_block = blocks[C2D_TAPE_UPPER];
    blocks[C2D_TAPE_LOWER] += lower.blocks;
    blocks[C2D_TAPE_UPPER] += upper.blocks;
    if (lower.max_data_bytes > data[C2D_TAPE_LOWER]) data[C2D_TAPE_LOWER] = lower.max_data_bytes;
    if (upper.max_data_bytes > data[C2D_TAPE_UPPER]) data[C2D_TAPE_UPPER] = upper.max_data_bytes;
  }
  blocks[C2D_TAPE_CONTACT] = static_cast<uint64_t>(place_contact_blocks(m));
  data[C2D_TAPE_CONTACT] = contact_block_numbers(model_sizes(m).widest) * sizeof(Real);
  return out;
}

namespace {

c2d_status open_tapes(c2d_solver* s, const Model& m) {
  const TapeShapes shape = shape_tapes(s, m);
  for (int32_t tape = C2D_TAPE_LOWER; tape < C2D_TAPES; ++tape) {
    if (shape.blocks[tape] == 0) continue;
    const c2d_status status = open_tape(s->tapes, tape, shape.blocks[tape], shape.data[tape]);
    if (status != C2D_OK) return status;
  }
  return C2D_OK;
}

// ---- one body -----------------------------------------------------------------------------------------------------

struct BodyJob {
  c2d_solver* solver;
  ColumnSystem system;
  ContactTape tape;
  int64_t total; // columns
  double assembling;
  Engine engine;
};

c2d_status watch_column(void* context, int32_t column) {
  BodyJob& job = *static_cast<BodyJob*>(context);
  tell_progress(job.solver, C2D_PHASE_ELIMINATE, job.system.body + 1, column, job.total);
  return asked_to_stop(job.solver) ? C2D_ERR_CANCELLED : C2D_OK;
}

// Columns are assembled a few at a time, so that a watchdog is fed also while a wide panel is filled.
constexpr int32_t kColumnsAtOnce = 256;

// Not so few that kernels stand idle, and no more than this.
int32_t at_once(int64_t columns, int32_t most) {
  return static_cast<int32_t>(columns < 16 ? 16 : columns < most ? columns : most);
}

// So few that they stay in the second-level cache until all elements have added to them.
int32_t columns_at_once(int64_t ld) {
  constexpr int64_t kCachedBytes = 1 << 20;
  return at_once(kCachedBytes / (ld * static_cast<int64_t>(sizeof(Real))), kColumnsAtOnce);
}

struct Columns { // of a panel, `step` at a time
  const BodyJob& job;
  int32_t first, count, step;
  Real* data;
  int64_t ld;
  bool shared; // several steps at once: what an element needs comes from the engine's memory
};
static_assert(kDepth * 4 * sizeof(Real) >= sizeof(AssemblyScratch), "a part of an engine's memory has room for it");

void fill_step(void* argument, const Engine& engine, int32_t i) {
  const Columns& c = *static_cast<const Columns*>(argument);
  ColumnSystem system = c.job.system;
  if (c.shared) system.scratch = reinterpret_cast<AssemblyScratch*>(engine.scratch);
  const int32_t done = i * c.step, rest = c.count - done;
  fill_columns(system, c.first + done, rest < c.step ? rest : c.step, c.data + done * c.ld, c.ld);
}

// The first of these columns, one step for each part of the engine; how many.
int32_t fill_some(BodyJob& job, int32_t first, int32_t count, Real* data, int64_t ld) {
  if (kSmallCode) {
    const int32_t now = count < kColumnsAtOnce ? count : kColumnsAtOnce;
    fill_columns(job.system, first, now, data, ld);
    return now;
  }
  const int32_t parts = parts_of(job.engine), each = count / parts + 1;
  const int32_t step = at_once(each, columns_at_once(ld));
  const int32_t now = count < parts * step ? count : parts * step, items = (now + step - 1) / step;
  Columns columns{job, first, now, step, data, ld, parts > 1 && items > 1};
  run_items(job.engine, items, fill_step, &columns);
  return now;
}

c2d_status assemble_columns(void* context, int32_t first, int32_t count, Real* panel, int64_t ld) {
  BodyJob& job = *static_cast<BodyJob*>(context);
  const double start = clock_now(job.solver);
  for (int32_t done = 0; done < count;) {
    done += fill_some(job, first + done, count - done, panel + done * ld, ld);
    tell_progress(job.solver, C2D_PHASE_ASSEMBLE, job.system.body + 1, first + done, job.total);
    if (asked_to_stop(job.solver)) return C2D_ERR_CANCELLED;
  }
  job.assembling += clock_now(job.solver) - start;
  return C2D_OK;
}

c2d_status keep_reduced(void* context, int32_t first, int32_t count, const Real* rows, int64_t ld) {
  BodyJob& job = *static_cast<BodyJob*>(context);
  const int b = job.system.body;
  const int32_t n = job.system.model.body[b].contact;
  for (int32_t j = 0; j < count && n > 0; ++j) {
    const int32_t k = first + j, part = k < 2 * n ? k / n : 2;
    constexpr BodyMatrix kMatrix[] = {BodyMatrix::displacement, BodyMatrix::traction, BodyMatrix::load}; // S_u, S_t, s
    const c2d_status status = write_column(job.tape, b, kMatrix[part], k - part * n, rows + j * ld);
    if (status != C2D_OK) return status;
  }
  return C2D_OK;
}

[[gnu::noinline]] void note_pivots(c2d_solver* s, const PivotStats& stats) {
  if (stats.smallest_column < 0) return;
  if (stats.smallest_ratio < s->smallest_pivot) s->smallest_pivot = stats.smallest_ratio;
  if (stats.largest_ratio > s->largest_pivot) s->largest_pivot = stats.largest_ratio;
  if (stats.growth > s->pivot_growth) s->pivot_growth = stats.growth;
}

// The phase before has left nothing that the next one may use.
void clear_phases(c2d_solver* s) { poison(array_of<char>(s, kPhase), s->bytes - s->layout.persistent); }

// What a phase that uses `area` bytes leaves of the phase area, for the kernels of this machine.
[[gnu::noinline]] Engine engine_beside(c2d_solver* s, const PhaseSizes& sizes, Instructions set, uint64_t area, int64_t* used) {
  C2D_ASSERT(s->layout.persistent <= s->bytes && area <= s->bytes - s->layout.persistent);
  if (kSmallCode) return kPlainEngine;
  const Workers workers = workers_of(&s->port);
  const uint64_t left = s->bytes - s->layout.persistent - area;
  const uint64_t full = scratch_bytes(sizes) * static_cast<uint64_t>(workers.count);
  const uint64_t bytes = left < full ? left : full;
  return Engine{kernel_for(set), reinterpret_cast<Real*>(array_of<char>(s, kPhase) + area),
                static_cast<int64_t>(bytes / sizeof(Real)), used, workers};
}

void note_scratch(c2d_solver* s, uint64_t area, int64_t used) {
  const uint64_t bytes = s->layout.persistent + area + static_cast<uint64_t>(used) * sizeof(Real);
  if (bytes > s->peak_bytes) s->peak_bytes = bytes;
}

BodyJob job_of(c2d_solver* s, const Model& m, int b, const EliminationArea& area, const BatchKernel* batch) {
  const EliminationPlan& plan = plan_of(s, b);
  const Quadrature quadrature = s->options.quadrature == C2D_QUADRATURE_THESIS ? Quadrature::thesis : Quadrature::accurate;
  return BodyJob{
      s,
      ColumnSystem{m, b, quadrature, area.diagonal, area.point, area.twin, static_cast<AssemblyScratch*>(area.scratch), batch},
      ContactTape{&s->tapes, &m, area.buffer},
      static_cast<int64_t>(plan.pivots) + plan.trailing,
      0.0,
      kPlainEngine};
}

// With `loads_only` the matrix has been eliminated, and the loads have changed.
[[gnu::noinline]] c2d_status eliminate_body(c2d_solver* s, const Model& m, const PhaseSizes& sizes, Instructions set, int b,
                                            bool loads_only) {
  clear_phases(s);
  const EliminationPlan& plan = plan_of(s, b);
  EliminationArea area;
  const uint64_t bytes = elimination_area(sizes, b, plan, array_of<char>(s, kPhase), &area);
  BodyJob job = job_of(s, m, b, area, batch_for(set));
  int64_t scratch = 0;
  job.engine = engine_beside(s, sizes, set, bytes, &scratch);
  const double start = clock_now(s);
  job.system.some_passed_over = place_sources(job.system);
  const bool diagonal_later = is_compressed(plan) && has_diagonal_by_cells(job.system);
  for (int32_t node = 0; node < m.body[b].nodes && !diagonal_later; node += kColumnsAtOnce) {
    const int32_t rest = m.body[b].nodes - node;
    fill_diagonal(job.system, node, rest < kColumnsAtOnce ? rest : kColumnsAtOnce);
    tell_progress(s, C2D_PHASE_ASSEMBLE, b + 1, 0, job.total);
    if (asked_to_stop(s)) return C2D_ERR_CANCELLED;
  }
  job.assembling += clock_now(s) - start;
  const ColumnSource source{&job, assemble_columns};
  const RowSink sink{&job, keep_reduced};
  const Watch watch{&job, watch_column};
  const Engine& engine = job.engine;
  c2d_status status;
  if (is_compressed(plan)) {
    PivotStats stats{};
    status = kCompressedPart.compress(plan, job.system, sink, s->tapes, area.work, &stats, &s->rank_needed, watch, engine);
    note_pivots(s, stats);
  } else if (loads_only) {
    status = kNewLoadsPart.eliminate_again(plan, 2 * m.body[b].contact, source, sink, s->tapes, area.work, watch, engine);
  } else {
    PivotStats stats{};
    status = eliminate(plan, source, sink, s->tapes, area.work, &stats, watch, engine);
    note_pivots(s, stats);
  }
  note_scratch(s, bytes, scratch);
  s->seconds[C2D_PHASE_ASSEMBLE] += job.assembling;
  s->seconds[C2D_PHASE_ELIMINATE] += clock_now(s) - start - job.assembling;
  return status;
}

// ---- several bodies -----------------------------------------------------------------------------------------------

// Bodies too small for the workers to share their columns: each is assembled and factored by one of them, in memory of its own,
// and what comes of it is written in the order of the bodies, as if they had come one after the other.
struct Together {
  c2d_solver* s;
  const Model& m;
  const PhaseSizes& sizes;
  Instructions set;
  int first;
  int32_t count;
  uint64_t each; // bytes

  EliminationArea area(int32_t i) const;
  BodyJob job(int32_t i) const { return job_of(s, m, first + i, area(i), batch_for(set)); }
  struct Outcome {
    c2d_status status;
    PivotStats stats;
  };
  Outcome& outcome(int32_t i) const { // behind the area
    return *reinterpret_cast<Outcome*>(array_of<char>(s, kPhase) + static_cast<uint64_t>(i + 1) * each - kOutcomeBytes);
  }
  static constexpr uint64_t kOutcomeBytes = (sizeof(Outcome) + kAlignment - 1) / kAlignment * kAlignment;
};

EliminationArea Together::area(int32_t i) const {
  EliminationArea out;
  elimination_area(sizes, first + i, plan_of(s, first + i), array_of<char>(s, kPhase) + static_cast<uint64_t>(i) * each, &out);
  return out;
}

// Measured with two workers: from some 600 columns on they gain as much by sharing them.
constexpr int32_t kColumnsForOne = 512;
constexpr int32_t kBodiesForOne = 8; // at once, so that whoever watches is told
constexpr uint64_t kScratchForOne = full_scratch(kDepth, 64) * sizeof(Real);

// Body `first` and those after it; a count of 1 or less: it is on its own.
Together together_from(c2d_solver* s, const Model& m, const PhaseSizes& sizes, Instructions set, int first) {
  Together all = {s, m, sizes, set, first, 0, 0};
  const int32_t workers = workers_of(&s->port).count, most = kBodiesForOne * workers;
  const uint64_t bytes = s->bytes - s->layout.persistent, scratch = kScratchForOne * static_cast<uint64_t>(workers);
  if (kSmallCode || workers == 1 || bytes < scratch) return all;
  for (int b = first; b < m.head->bodies && all.count < most; ++b, ++all.count) {
    const EliminationPlan& plan = plan_of(s, b);
    if (is_rigid(m, b) || is_compressed(plan) || panel_count(plan) != 1 || plan.pivots + plan.trailing > kColumnsForOne) break;
    const uint64_t own = elimination_area(sizes, b, plan, nullptr, nullptr) + Together::kOutcomeBytes;
    const uint64_t each = own > all.each ? own : all.each;
    if ((bytes - scratch) / each < static_cast<uint64_t>(all.count) + 1) break;
    all.each = each;
  }
  return all;
}

void assemble_one(void* argument, const Engine&, int32_t i) {
  const Together& all = *static_cast<const Together*>(argument);
  BodyJob job = all.job(i);
  job.system.some_passed_over = place_sources(job.system);
  fill_diagonal(job.system, 0, all.m.body[job.system.body].nodes);
  int64_t ld;
  Real* panel = only_panel(plan_of(all.s, job.system.body), all.area(i).work, &ld);
  const int32_t step = columns_at_once(ld), total = static_cast<int32_t>(job.total);
  for (int32_t j = 0; j < total; j += step)
    fill_columns(job.system, j, total - j < step ? total - j : step, panel + j * ld, ld);
}

void factor_one(void* argument, const Engine& engine, int32_t i) {
  const Together& all = *static_cast<const Together*>(argument);
  Together::Outcome& out = all.outcome(i);
  out.status = factor_only_panel(plan_of(all.s, all.first + i), all.s->tapes, all.area(i).work, out.stats, engine);
}

c2d_status write_one(const Together& all, int32_t i) {
  BodyJob job = all.job(i);
  const Together::Outcome& found = all.outcome(i);
  note_pivots(all.s, found.stats);
  if (found.status != C2D_OK) return found.status;
  tell_progress(all.s, C2D_PHASE_ASSEMBLE, job.system.body + 1, job.total, job.total);
  return write_only_panel(plan_of(all.s, job.system.body), RowSink{&job, keep_reduced}, all.s->tapes, all.area(i).work,
                          Watch{&job, watch_column});
}

[[gnu::noinline]] c2d_status eliminate_together(Together& all) {
  c2d_solver* s = all.s;
  clear_phases(s);
  const uint64_t bytes = static_cast<uint64_t>(all.count) * all.each;
  int64_t scratch = 0;
  const Engine engine = engine_beside(s, all.sizes, all.set, bytes, &scratch);
  const double start = clock_now(s);
  run_items(engine, all.count, assemble_one, &all);
  const double assembled = clock_now(s);
  c2d_status status = asked_to_stop(s) ? C2D_ERR_CANCELLED : C2D_OK;
  if (status == C2D_OK) run_items(engine, all.count, factor_one, &all);
  for (int32_t i = 0; i < all.count && status == C2D_OK; ++i) status = write_one(all, i);
  note_scratch(s, bytes, scratch);
  s->seconds[C2D_PHASE_ASSEMBLE] += assembled - start;
  s->seconds[C2D_PHASE_ELIMINATE] += clock_now(s) - assembled;
  return status;
}

[[gnu::noinline]] c2d_status eliminate_bodies(c2d_solver* s, const Model& m, const PhaseSizes& sizes, bool loads_only) {
  const Instructions set = s->instructions;
  c2d_status status = C2D_OK;
  for (int b = 0; b < m.head->bodies && status == C2D_OK;) {
    Together all = together_from(s, m, sizes, set, b);
    if (!kSmallCode && all.count > 1 && !loads_only) {
      status = eliminate_together(all);
      b += all.count;
      continue;
    }
    if (!is_rigid(m, b)) status = eliminate_body(s, m, sizes, set, b, loads_only);
    ++b;
  }
  return status;
}

c2d_status tick(void* context) {
  c2d_solver* s = static_cast<c2d_solver*>(context);
  tell_progress(s, C2D_PHASE_REDUCE, 0, 0, 0);
  return asked_to_stop(s) ? C2D_ERR_CANCELLED : C2D_OK;
}

// In none of the runs that the model names do pairs rub that may change, and no body slides freely.
bool is_frictionless(c2d_solver* s, const Model& m) {
  if (!has_sliding_form(m) || s->model.coefficients == 0) return false;
  for (int32_t zone = 0; zone < s->model.zones; ++zone)
    for (int32_t i = 0; i < s->model.coefficients && m.zone[zone].is_tied == 0; ++i)
      if (coefficient_of_zone(s, zone, i) != 0.0) return false;
  Session session;
  open_session(s, session);
  return session.free_body.slides == 0;
}

// Displacements that are unknowns of the contact system ask for more than the least memory, METHOD 10.2.
[[gnu::noinline]] c2d_status tell_system(c2d_solver* s, const PhaseSizes& sizes) {
  c2d_error e = blank_error();
  e.bytes_needed = s->layout.persistent + reduction_area(sizes, nullptr, nullptr) + kAlignment - 1;
  char what[160];
  Text text = text_in(what);
  put_all(text, status_text(C2D_ERR_MEMORY), " for slender bodies upon each other: ", e.bytes_needed, " bytes would do");
  return fail_with(s, e, C2D_ERR_MEMORY, what);
}

// Beyond the limit the model is refused: nothing in a state shows such errors (METHOD 10.2).
[[gnu::noinline]] c2d_status check_round_off(c2d_solver* s, const Model& m, const RoundOff& found) {
  constexpr double kMost = sizeof(Real) == 8 ? 2.5e-8 : 1e-1;
  const double loss = kDigit * found.growth;
  s->condition = fmax(s->condition, found.growth);
  if (!(loss > kMost)) return C2D_OK;
  char what[300];
  Text text = text_in(what);
  put_all(text, "body ", body_named(m, found.body), " and one that it touches are so slender that round-off may be up to ",
          loss < 1.0 ? loss : 1.0,
          " of the pressures, expected linear functions, or slender bodies that do not touch each other");
  return fail(s, C2D_ERR_SINGULAR, what);
}

using Tick = c2d_status (*)(void* context);
[[gnu::noinline]] c2d_status reduce_bodies(c2d_solver* s, const Model& m, const PhaseSizes& sizes, bool loads_only,
                                           bool sliding, Tick tick) {
  if (m.head->contact == 0) return C2D_OK;
  clear_phases(s);
  if (!kSmallCode) s->made = 0;
  ReductionArea area;
  const uint64_t bytes = reduction_area(sizes, array_of<char>(s, kPhase), &area);
  if (sizes.further > 0 && bytes > s->bytes - s->layout.persistent) return tell_system(s, sizes); // (restored into less)
  const double start = clock_now(s);
  int64_t scratch = 0;
  RoundOff round_off;
  const Reduction reduction{ContactTape{&s->tapes, &m, area.buffer},
                            m,
                            area.first,
                            area.second,
                            area.strip,
                            area.pivots,
                            sizes.widest + sizes.motions + sizes.further,
                            s,
                            tick,
                            engine_beside(s, sizes, s->instructions, bytes, &scratch),
                            sliding,
                            true,
                            &round_off};
  c2d_status status = C2D_OK;
  if (is_on_demand(m))
    status = reduce_on_demand(reduction);
  else
    status = loads_only ? kNewLoadsPart.reduce_loads(reduction) : reduce(reduction);
  note_scratch(s, bytes, scratch);
  if (!kSmallCode && status == C2D_OK) status = check_round_off(s, m, round_off);
  if (is_on_demand(m) && status == C2D_OK) status = kCompressedPart.hold_on_demand(s, sliding);
  s->seconds[C2D_PHASE_REDUCE] += clock_now(s) - start;
  return status;
}

// What checks and energies need.
c2d_status build_books(c2d_solver* s) {
  c2d_status status = build_judge(s);
  if (status == C2D_OK && s->keeps_energy) status = kEnergyPart.build_energy(s);
  return status == C2D_OK && !kSmallCode && s->model.columns > 0 ? kCompressedPart.count_held(s) : status;
}

c2d_status solve_bodies(c2d_solver* s, const Model& m, const PhaseSizes& sizes, bool loads_only) {
  c2d_status status = eliminate_bodies(s, m, sizes, loads_only);
  const bool sliding = !kSmallCode && !loads_only && is_frictionless(s, m);
  if (status == C2D_OK && is_on_demand(m)) status = kCompressedPart.respond_on_demand(s);
  if (status == C2D_OK) status = reduce_bodies(s, m, sizes, loads_only, sliding, tick);
  clear_phases(s);
  return status;
}

// For new loads, which compressed elimination has no short way for.
int32_t keeps_factors(const c2d_solver* s) { return is_compressed(s) ? 0 : s->options.keep_factors; }

// (Neither this nor the next is put into c2d_prepare: their frames would stand below that of build_energy.)
[[gnu::noinline]] c2d_status run_phases(c2d_solver* s, const Model& m) {
  const PhaseSizes sizes = model_sizes(m);
  const uint64_t bytes = s->bytes - s->layout.persistent;
  if (sizes.further > 0 && reduction_area(sizes, nullptr, nullptr) > bytes) return tell_system(s, sizes);
  EliminationPlan* const plans = &plan_of(s, 0);
  plan_phases(sizes_of(s), sizes, bytes, plans);
  if (is_compressed(s)) {
    s->rank_needed = 0;
    const c2d_status status = kCompressedPart.plan_compression(phase_sizes(sizes_of(s)), bytes, m, plans);
    if (status != C2D_OK) return status;
  }
  if (C2D_NEVER(phases_use(sizes, plans, false) > bytes)) return C2D_ERR_INTERNAL; // no array of a smaller model is longer
  const bool flexibility = phases_use(sizes, plans, true) <= bytes;
  s->keeps_flexibility = flexibility;
  for (int b = 0; b < m.head->bodies; ++b)
    if (!is_compressed(plans[b])) plans[b].keep_lower = keeps_factors(s);
  s->peak_bytes = s->layout.persistent + phases_use(sizes, plans, flexibility);
  c2d_status status = begin_run(s->tapes, hash_model(m, s->options), array_of<char>(s, kPhase));
  if (status == C2D_OK) status = open_tapes(s, m);
  return status == C2D_OK ? solve_bodies(s, m, sizes, false) : status;
}

// New right-hand sides go through the factorisation that is on the tapes.
[[gnu::noinline]] c2d_status run_loads(c2d_solver* s, const Model& m) {
  const c2d_status status = recount_run(s->tapes, array_of<char>(s, kPhase));
  return status == C2D_OK ? solve_bodies(s, m, model_sizes(m), true) : status;
}

// Pair::weight.
void weigh_pairs(const Model& m) {
  for (int32_t i = 0; i < m.head->pairs; ++i) m.pair[i].weight = 0.0;
  for (int32_t z = 0; z < m.head->zones; ++z)
    for (int32_t place = 0; place < m.zone[z].elements; ++place) {
      const int side = m.zone[z].is_free != 0 ? 1 : 0, b = m.zone[z].body[side];
      const int32_t element = zone_element(m, m.zone[z], side, place);
      EndResultant weight[kElementNodes];
      end_resultants(m, b, element, Measure::own_length, weight);
      for (int l = 0; l < m.head->function_nodes; ++l) {
        const int32_t pair = pair_of_end(m, b, element, l).pair;
        if (pair >= 0) m.pair[pair].weight += weight[l].w;
      }
    }
}

[[gnu::noinline]] c2d_status validate_changes(c2d_solver* s, const Model& m) {
  if (s->loads_changed == 0) return C2D_OK;
  Reporter reporter{s, [](void* solver, const c2d_error& e) { report_fault(static_cast<c2d_solver*>(solver), e); }, 0};
  return validate_loads(m, reporter) ? C2D_OK : C2D_ERR_INPUT;
}

[[gnu::noinline]] void note_path_alone(c2d_solver* s, const Model& m) {
  PathArea area;
  s->peak_bytes = s->layout.persistent + open_path_area(s, m, false, area);
}

// Compressed elimination asks for more than the least memory.
[[gnu::noinline]] c2d_status tell_need(c2d_solver* s) {
  const Sizes limits = sizes_of(s);
  c2d_error e = blank_error();
  e.bytes_needed =
      s->layout.persistent + kCompressedPart.compression_that_will_do(phase_sizes(limits), s->rank_needed) + kAlignment - 1;
  char what[128];
  Text text = text_in(what);
  put_all(text, status_text(C2D_ERR_MEMORY), " for compressed elimination: ", e.bytes_needed, " bytes would do");
  return fail_with(s, e, C2D_ERR_MEMORY, what);
}

// The whole contact system has no room, and it may not be on demand.
[[gnu::noinline]] c2d_status tell_contact(c2d_solver* s) {
  char what[240];
  Text text = text_in(what);
  put_all(
      text, "the contact has ", s->model.contact,
      " unknowns, more than c2d_limits.touching leaves room for, and cannot be on "
      "demand: that takes compressed elimination, no zone that is free, tied or on one body, and stout bodies that supports "
      "or the contact hold well");
  return fail(s, C2D_ERR_LIMIT, what);
}

c2d_status prepare_once(c2d_solver* s) {
  const Model m = model_of(s);
  c2d_status status = validate_changes(s, m);
  if (status != C2D_OK) return status;
  const bool loads_only = s->factors != 0 && kNewLoadsPart.linked;
  s->loads_changed = s->factors = s->mean_motions = 0;
  for (int32_t p = C2D_PHASE_ASSEMBLE; p < C2D_PHASES; ++p) s->seconds[p] = 0.0; // (what it took to read a deck stays)
  s->saves = 0;
  if (loads_only) {
    status = run_loads(s, m);
  } else {
    s->smallest_pivot = 1e300;
    s->largest_pivot = s->pivot_growth = s->condition = 0.0;
    if (!kSmallCode) s->compression_residual = s->compression_error = 0.0;
    plan_bodies(s, m);
    weigh_pairs(m);
    status = close_all(s->tapes);
    if (!kSmallCode && status == C2D_OK && model_sizes(m).columns > columns_of(s->sizes)) status = C2D_ERR_LIMIT;
    if (status == C2D_OK && !s->blocked) status = run_phases(s, m);
    if (s->blocked) note_path_alone(s, m);
  }
  s->keeps_energy = kEnergyPart.linked;
  const double start = clock_now(s);
  if (status == C2D_OK && !s->blocked && !loads_only) status = kWarningPart.find_condition(s);
  if (status == C2D_OK && !s->blocked) status = build_books(s);
  s->seconds[C2D_PHASE_REDUCE] += clock_now(s) - start;
  if (status == C2D_OK) {
    s->state = C2D_STATE_PREPARED;
    s->factors = keeps_factors(s) != 0 && !s->blocked;
    if (!s->blocked && !loads_only) kWarningPart.warn_condition(s);
    return C2D_OK;
  }
  if (is_store_error(status)) return fail_store(s, status);
  const c2d_status closed = close_all(s->tapes);
  if (closed != C2D_OK) return fail_store(s, closed);
  if ((status == C2D_ERR_SINGULAR || status == C2D_ERR_MEMORY) && s->has_fault != 0) return status; // reported where found
  if (status == C2D_ERR_SINGULAR)
    return fail(s, status, "the equations are singular: the conditions do not hold the bodies, or the mesh is degenerate");
  if (!kSmallCode && status == C2D_ERR_MEMORY) return tell_need(s);
  if (!kSmallCode && status == C2D_ERR_LIMIT) return tell_contact(s);
  return fail(s, status, status_text(status));
}

} // namespace

namespace {

c2d_status tell(void* context) {
  tell_progress(static_cast<c2d_solver*>(context), C2D_PHASE_REDUCE, 0, 0, 0);
  return C2D_OK;
}

// From the bodies' equations on the tape. Until all of it is written the tape says that it is not: where that is left,
// match_saved begins again.
[[gnu::noinline]] c2d_status change_form(c2d_solver* s, bool sliding) {
  Session session;
  open_session(s, session);
  s->mean_motions = 0; // they lie where the bodies are reduced
  const c2d_status status = write_unfinished(session.tape, session.area.column);
  return status == C2D_OK ? reduce_bodies(s, session.model, model_sizes(session.model), false, sliding, tell) : status;
}

bool rubs(const Model& m) {
  for (int32_t i = 0; i < m.head->path_pairs; ++i)
    if (m.pair[i].tangential != 0 && !m.pair[i].law.is_smooth()) return true;
  return false;
}

} // namespace

c2d_status allow_friction(c2d_solver* s) {
  if (kSmallCode || s->sliding == 0 || !rubs(model_of(s))) return C2D_OK;
  const c2d_status status = change_form(s, false);
  return status == C2D_OK ? build_books(s) : status;
}

c2d_status match_saved(c2d_solver* s, bool* again) {
  *again = false;
  if (kSmallCode || s->blocked) return C2D_OK;
  Session session;
  open_session(s, session);
  if (!has_sliding_form(session.model)) return C2D_OK;
  Form form;
  const c2d_status status = read_form(session.tape, session.area.column, &form);
  *again = status == C2D_OK && (!form.finished || form.sliding != (s->sliding != 0));
  return *again ? change_form(s, s->sliding != 0) : status;
}

c2d_status prepare(c2d_solver* s) {
  if constexpr (kHostile) rehearse(s, prepare_once);
  return prepare_once(s);
}

} // namespace c2d
