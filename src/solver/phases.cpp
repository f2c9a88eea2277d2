#include "solver/phases.hpp"

#include <stddef.h>
#include <string.h>

#include "bie/columns.hpp"
#include "contact/basis.hpp"
#include "contact2d_memory.h"
#include "memory/hostile.hpp"
#include "memory/parts.hpp"

namespace c2d {

C2D_USES(CompressedPart);

// What the lists of contact2d_memory.h say in numbers.
static_assert(kStripColumns == 4 && tableau_columns(5, 2) == 5 + 1 + 2 && kBlockHeaderBytes == 64, "columns, header");

namespace {

// Carves from a base, or only counts where there is none.
struct PhaseCarver : Carver {
  char* base;

  explicit PhaseCarver(char* from) : Carver{0, true}, base(from) {}
  template <class T> void take(T*& out, uint64_t count, uint32_t size) { out = static_cast<T*>(items(count, size)); }
  void* items(uint64_t count, uint32_t size);
  uint64_t total() const { return fits ? used : UINT64_MAX; }
};
// An array of a list, to a member of `area` or to that of a side.
#define C2D_TAKE(type, name, count, each) carver.take(area.name, (count) * (each), C2D_BYTES_OF_##type);
#define C2D_TAKE_OF_SIDE(type, name, count, each) carver.take(area.name[side], (count) * (each), C2D_BYTES_OF_##type);

void* PhaseCarver::items(uint64_t count, uint32_t size) {
  const uint64_t at = carve(count, size);
  return base ? base + at : nullptr;
}

uint64_t larger(uint64_t a, uint64_t b) { return a > b ? a : b; }

} // namespace

PhaseSizes phase_sizes(const Sizes& sizes) {
  PhaseSizes s{};
  s.m = s.widest = sizes.contact;
  s.columns = s.square = columns_of(sizes);
  s.motions = sizes.motions;
  s.cases = sizes.load_cases;
  s.slip = C2D_SLIP_(sizes.curves);
  s.bodies = sizes.bodies;
  s.limits = &sizes;
  for (int b = 0; b < sizes.bodies; ++b) {
    const BodySizes body = sizes_of_body(sizes, b);
    s.nodes += body.nodes;
    s.ends += body.ends;
  }
  // Every contact unknown belongs to two bodies, of two one is solved for. (Beyond 2^31 unknowns no memory is enough, anyway.)
  const int64_t side = s.columns < INT32_MAX ? s.columns : INT32_MAX;
  s.flexibility = (sizes.bodies > 2 ? 2 : 1) * side * side;
  return s;
}

PhaseSizes model_sizes(const Model& m) {
  PhaseSizes s{};
  s.m = s.widest = s.columns = m.head->contact;
  s.motions = m.head->motions;
  s.further = further_unknowns(m);
  s.cases = m.head->load_cases;
  s.slip = C2D_SLIP_(m.head->curves);
  s.bodies = m.head->bodies;
  s.model = &m;
  for (int b = 0; b < s.bodies; ++b) {
    const Body& body = m.body[b];
    s.nodes += body.nodes;
    if (body.contact > s.widest) s.widest = body.contact;
    s.ends += static_cast<int64_t>(body.elements) * m.head->function_nodes;
    if (!is_rigid(m, b) && body.keeps_equations == kSolvedFor)
      s.flexibility += static_cast<int64_t>(body.contact) * body.contact;
  }
  s.square = s.widest;
  if (is_on_demand(m)) {
    s.columns = m.head->columns;
    s.flexibility = s.square = 0;
  }
  return s;
}

BodyPhase PhaseSizes::of(int b) const {
  if (!model) {
    const BodySizes body = sizes_of_body(*limits, b);
    return {body.nodes, body.rows, body.rows > 0 ? 2 * body.nodes + 3 : 0,
            columns}; // without contact, every unknown is an outer one
  }
  const Body& body = model->body[b];
  if (is_rigid(*model, b)) return {body.nodes, 0, 0, body.contact};
  return {body.nodes, system_rows(*model, b), outer_columns(*model, b), body.contact};
}

namespace {

EliminationPlan plan_of(const PhaseSizes& s, int b, int32_t panel_columns, int32_t block_columns) {
  const BodyPhase body = s.of(b);
  return EliminationPlan{static_cast<int32_t>(body.rows),
                         static_cast<int32_t>(body.outer),
                         static_cast<int32_t>(2 * body.contact + s.cases),
                         panel_columns,
                         block_columns,
                         0,
                         0,
                         0,
                         0,
                         0};
}

} // namespace

namespace {

uint64_t work_bytes(const PhaseSizes& s, int b, const EliminationPlan& plan) {
  return is_compressed(plan) ? kCompressedPart.compression_bytes(*s.model, b, plan) : elimination_bytes(plan);
}
uint64_t later_bytes(const PhaseSizes& s, int b, const EliminationPlan& plan) {
  return is_compressed(plan) && is_on_demand(*s.model) ? kCompressedPart.later_bytes(*s.model, b, plan) : 0;
}
uint64_t back_bytes(const PhaseSizes& s, int b, const EliminationPlan& plan) {
  return is_compressed(plan) ? kCompressedPart.compression_back_bytes(*s.model, b, plan) : back_substitution_bytes(plan);
}

} // namespace

uint64_t elimination_area(const PhaseSizes& s, int b, const EliminationPlan& plan, char* base, EliminationArea* out) {
  PhaseCarver carver(base);
  EliminationArea area{};
  const uint64_t nodes = static_cast<uint64_t>(s.of(b).nodes), m = static_cast<uint64_t>(s.widest);
  C2D_ELIMINATION_ARRAYS_(C2D_TAKE, nodes, m, work_bytes(s, b, plan))
  if (out) *out = area;
  return carver.total();
}

uint64_t reduction_area(const PhaseSizes& s, char* base, ReductionArea* out) {
  PhaseCarver carver(base);
  ReductionArea area{};
  const uint64_t m = static_cast<uint64_t>(s.widest), border = static_cast<uint64_t>(s.motions + s.further);
  const uint64_t columns = static_cast<uint64_t>(s.square);
  C2D_REDUCTION_ARRAYS_(C2D_TAKE, m, columns, border)
  if (out) *out = area;
  return carver.total();
}

namespace {

// n of the rates' numbers, n (n + 4): those of the rate problem; and where columns are made on demand, of bodies that the
// contact alone holds, seven of each contact unknown and two squares of the motions (contact/rates/force_cone.cpp) are more
// than these may be.
uint64_t side_of_rates(const PhaseSizes& s) {
  uint64_t n = static_cast<uint64_t>(s.columns) + 1;
  if (kSmallCode || s.columns >= s.m || s.motions == 0) return n;
  const uint64_t motions = static_cast<uint64_t>(s.motions < kMostHeld ? s.motions : kMostHeld);
  const uint64_t needed = 7 * static_cast<uint64_t>(s.m) + 32 + 2 * motions * motions * (8 / sizeof(Real));
  while (n * (n + 4) < needed) ++n;
  return n;
}

void add_back_need(const PhaseSizes& s, int b, const EliminationPlan& plan, BackNeed& out) {
  if (s.of(b).rows == 0) return;
  out.work = larger(out.work, back_bytes(s, b, plan));
  out.outer = larger(out.outer, static_cast<uint64_t>(s.of(b).outer));
  if (!kSmallCode) out.later = larger(out.later, later_bytes(s, b, plan));
}

} // namespace

BackNeed back_need(const PhaseSizes& s, const EliminationPlan* plan) {
  BackNeed out = {0, 0, 0};
  for (int b = 0; b < s.bodies; ++b) add_back_need(s, b, plan[b], out);
  return out;
}

uint64_t path_area(const PhaseSizes& s, const BackNeed& back, bool flexibility, char* base, PathArea* out) {
  PhaseCarver carver(base);
  PathArea area{};
  const uint64_t m = static_cast<uint64_t>(s.m), cases = static_cast<uint64_t>(s.cases);
  const uint64_t loads = static_cast<uint64_t>(s.cases + s.slip);
  const uint64_t nodes = static_cast<uint64_t>(s.nodes), ends = static_cast<uint64_t>(s.ends);
  const uint64_t widest = static_cast<uint64_t>(s.widest);
  const uint64_t columns = static_cast<uint64_t>(s.columns);
  C2D_PATH_ARRAYS_(C2D_TAKE, m, columns, widest, loads)
  carver.align();
  PhaseCarver rates = carver;
  for (int side = 0; side < 2; ++side) C2D_SURFACE_ARRAYS_(C2D_TAKE_OF_SIDE, m)
  C2D_COLUMN_ARRAYS_(C2D_TAKE, widest)
  carver.align();
  if (flexibility) {
    carver.take(area.flexibility, static_cast<uint64_t>(s.flexibility), sizeof(Real));
    carver.align();
    rates = carver;
  }
  C2D_RESULT_ARRAYS_(C2D_TAKE, nodes, ends)
  carver.align();
  C2D_BACK_ARRAYS_(C2D_TAKE, widest, cases, back.outer, back.work)
  const uint64_t used = carver.total();
  carver = rates;
  C2D_RATES_ARRAYS_(C2D_TAKE, side_of_rates(s))
  const uint64_t bytes = larger(used, carver.total());
  if (kSmallCode || back.later == 0 || bytes == UINT64_MAX) {
    if (out) *out = area;
    return bytes;
  }
  carver.used = round_up(bytes);
  area.later = carver.items(back.later, 1);
  if (out) *out = area;
  return carver.total();
}

uint64_t scratch_bytes(const PhaseSizes& s) {
  if (kSmallCode) return 0; // plain products take none
  const int64_t system = s.widest + s.motions + s.further;
  int64_t most = full_scratch(system, system);
  for (int b = 0; b < s.bodies; ++b) {
    const BodyPhase body = s.of(b);
    const int64_t numbers = full_scratch(body.outer, body.outer + 2 * body.contact + s.cases);
    if (numbers > most) most = numbers;
  }
  return static_cast<uint64_t>(most) * sizeof(Real);
}

namespace {

// The largest of all phases, with plan(b) for each body.
template <class Plan> uint64_t use_with(const PhaseSizes& s, Plan plan, bool flexibility) {
  uint64_t need = reduction_area(s, nullptr, nullptr);
  BackNeed back = {0, 0, 0};
  for (int b = 0; b < s.bodies; ++b) {
    if (s.of(b).rows == 0) continue;
    const EliminationPlan own = plan(b);
    need = larger(need, elimination_area(s, b, own, nullptr, nullptr));
    add_back_need(s, b, own, back);
  }
  return larger(need, path_area(s, back, flexibility, nullptr, nullptr));
}
uint64_t use_of(const PhaseSizes& s, const PlanRule& rule, bool flexibility) {
  return use_with(
      s, [&](int b) { return plan_by(rule, s, b); }, flexibility);
}

// What elimination_area holds beside the work of the elimination.
uint64_t beside_elimination(const PhaseSizes& s, int b) {
  return elimination_area(s, b, EliminationPlan{}, nullptr, nullptr) - elimination_bytes(EliminationPlan{});
}

int64_t all_columns(const BodyPhase& body, const PhaseSizes& s) { return body.outer + 2 * body.contact + s.cases; }

// The least memory: panels of the forced width, or of one column, written column by column.
EliminationPlan narrow_plan(const PhaseSizes& s, int b, int32_t forced) {
  const int64_t most = all_columns(s.of(b), s);
  const int64_t width = forced < 1 ? 1 : (forced < most ? forced : most);
  return plan_of(s, b, static_cast<int32_t>(width), 1);
}

c2d_status plan_within(const PhaseSizes& s, int b, const PlanRule& rule, EliminationPlan& out) {
  const BodyPhase body = s.of(b);
  const uint64_t beside = beside_elimination(s, b);
  if (rule.bytes < beside) return C2D_ERR_MEMORY;
  return plan_elimination(rule.bytes - beside, static_cast<int32_t>(body.rows), static_cast<int32_t>(body.outer),
                          static_cast<int32_t>(2 * body.contact + s.cases), rule.forced, out, nullptr);
}

bool is_possible(const PhaseSizes& s, const PlanRule& rule) {
  EliminationPlan plan;
  for (int b = 0; b < s.bodies; ++b)
    if (s.of(b).rows > 0 && plan_within(s, b, rule, plan) != C2D_OK) return false;
  return true;
}

} // namespace

EliminationPlan plan_by(const PlanRule& rule, const PhaseSizes& s, int b) {
  EliminationPlan plan{};
  if (s.of(b).rows > 0 && (rule.bytes == 0 || plan_within(s, b, rule, plan) != C2D_OK)) plan = narrow_plan(s, b, rule.forced);
  return plan;
}

uint64_t phases_use(const PhaseSizes& s, const EliminationPlan* plan, bool flexibility) {
  return use_with(
      s, [&](int b) { return plan[b]; }, flexibility);
}

void choose_rule(const PhaseSizes& s, uint64_t bytes, int32_t forced, PlanRule& out) {
  // Wide blocks also cost memory in back substitution, beside the tableau: give the panels less until all fits.
  // Where memory is not scarce, panels leave the kernels their scratch; panels of a given width are no wider for it.
  const uint64_t scratch = scratch_bytes(s);
  for (uint64_t share = bytes / 8 > scratch && forced < 1 ? bytes - scratch : bytes;; share -= share / 8 + 1) {
    out = PlanRule{share, forced};
    if (!is_possible(s, out)) break;
    if (use_of(s, out, false) <= bytes) return;
  }
  out = PlanRule{0, forced};
  C2D_ASSERT(use_of(s, out, false) <= bytes);
}

namespace {

// The hostile build: whole blocks go through two buffers where there is room for that, with transfers on their way.
template <bool hostile> void double_buffers(const PhaseSizes& s, uint64_t bytes, EliminationPlan* plan) {
  if constexpr (hostile)
    for (int b = 0; b < s.bodies; ++b)
      for (int32_t width = plan[b].block_columns; s.of(b).rows > 0 && plan[b].block_rows == 0 && width > 0; width /= 2) {
        const EliminationPlan single = plan[b];
        plan[b].block_rows = plan[b].rows;
        plan[b].block_columns = width;
        if (phases_use(s, plan, false) > bytes) plan[b] = single;
      }
}

// (Nothing that stood on the stack reaches a tape with a plan, solver/save.cpp.)
static_assert(sizeof(EliminationPlan) == 8 * sizeof(int32_t) + 2 * sizeof(uint64_t), "no padding");

} // namespace

void plan_phases(const Sizes& limits, const PhaseSizes& s, uint64_t bytes, EliminationPlan* out) {
  const PhaseSizes most = phase_sizes(limits);
  PlanRule rule;
  choose_rule(most, bytes, limits.panel_columns, rule);
  for (int b = 0; b < s.bodies; ++b) {
    out[b] = plan_of(s, b, 1, 1);
    if (s.of(b).rows > 0) cut_alike(plan_by(rule, most, b), out[b]);
  }
  double_buffers<kHostile>(s, bytes, out);
}

bool is_plan_of(const PhaseSizes& s, int b, const EliminationPlan& plan) {
  if (is_compressed(plan)) return kCompressedPart.is_compression_of(*s.model, b, plan);
  const EliminationPlan least = plan_of(s, b, 1, 1);
  const int32_t most = s.of(b).rows > 0 ? least.pivots + least.trailing : 1;
  return plan.rank == 0 && plan.rows == least.rows && plan.pivots == least.pivots && plan.trailing == least.trailing &&
         plan.panel_columns >= 1 && plan.panel_columns <= most && plan.block_columns >= 1 &&
         plan.block_columns <= plan.panel_columns && plan.block_rows >= 0 && plan.block_rows <= plan.rows &&
         (plan.keep_lower == 0 || plan.keep_lower == 1);
}

namespace {

// Slender bodies upon each other (contact/reduction/reduction_plan.hpp) are three bodies and more with what holds them; in
// layers every other one's displacements are unknowns, and of a contact unknown one side's.
uint64_t slender_need(const PhaseSizes& s) {
  PhaseSizes slender = s;
  slender.further = !kSmallCode && s.bodies > 2 ? s.square : 0;
  return reduction_area(slender, nullptr, nullptr);
}

} // namespace

c2d_status phase_need(const Sizes& sizes, uint64_t* minimum, uint64_t* in_core) {
  const PhaseSizes s = phase_sizes(sizes);
  *minimum = use_of(s, PlanRule{0, sizes.panel_columns}, false);
  const uint64_t on_demand = !kSmallCode && s.columns < s.m ? kCompressedPart.compression_that_will_do(s, 0) : 0;
  *minimum = larger(*minimum, on_demand);
  // What choose_rule would do with all the memory there is.
  const PlanRule all = {UINT64_MAX - 1, sizes.panel_columns};
  if (!is_possible(s, all)) return C2D_ERR_OVERFLOW;
  if (!in_core) return C2D_OK;
  *in_core = larger(larger(use_of(s, all, true), slender_need(s)), on_demand);
  const uint64_t scratch = scratch_bytes(s);
  if (*in_core >= UINT64_MAX - scratch) return C2D_ERR_OVERFLOW; // (without scratch, too: of what does not fit the sum is that)
  *in_core += round_up(scratch);
  return C2D_OK;
}

} // namespace c2d
