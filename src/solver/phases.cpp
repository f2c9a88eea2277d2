#include "solver/phases.hpp"

#include "contact2d_memory.h"
#include "memory/hostile.hpp"

namespace c2d {

// What the lists of contact2d_memory.h say in numbers.
static_assert(kStripColumns == 4 && tableau_columns(5, 2) == 5 + 1 + 2 && kBlockHeaderBytes == 64, "columns, header");

namespace {

// Carves, or only counts when base is null.
struct Carver {
  char* base;
  uint64_t used;
  bool fits;

  template <class T> void take(T*& out, uint64_t count, uint32_t size) { out = static_cast<T*>(items(count, size)); }
  void* items(uint64_t count, uint32_t size);
  uint64_t total() const { return fits ? used : UINT64_MAX; }
};
// An array of a list, to a member of `area` or to that of body b.
#define C2D_TAKE(type, name, count, each) carver.take(area.name, (count) * (each), C2D_BYTES_OF_##type);
#define C2D_TAKE_OF_BODY(type, name, count, each) carver.take(area.name[b], (count) * (each), C2D_BYTES_OF_##type);

void* Carver::items(uint64_t count, uint32_t size) {
  void* const first = base ? base + used : nullptr;
  fits = fits && add_bytes(used, count, size) && used <= UINT64_MAX - 2 * kAlignment;
  if (fits) used = round_up(used);
  return first;
}

uint64_t larger(uint64_t a, uint64_t b) { return a > b ? a : b; }

} // namespace

PhaseSizes phase_sizes(const Sizes& sizes) {
  PhaseSizes s{};
  s.m = sizes.contact;
  s.cases = sizes.load_cases;
  for (int b = 0; b < sizes.bodies; ++b) {
    s.nodes[b] = sizes.body[b].nodes;
    s.ends[b] = sizes.body[b].ends;
    s.rows[b] = sizes.body[b].rows;
    s.outer[b] = 2 * s.nodes[b] + 3; // without contact, every unknown is an outer one
  }
  return s;
}

EliminationPlan plan_of(const PhaseSizes& s, int b, int32_t panel_columns, int32_t block_columns) {
  return EliminationPlan{static_cast<int32_t>(s.rows[b]),
                         static_cast<int32_t>(s.outer[b]),
                         static_cast<int32_t>(2 * s.m + s.cases),
                         panel_columns,
                         block_columns,
                         0,
                         0,
                         0,
                         0};
}

uint64_t elimination_area(const PhaseSizes& s, int b, const EliminationPlan& plan, char* base, EliminationArea* out) {
  Carver carver{base, 0, true};
  EliminationArea area{};
  const uint64_t nodes = static_cast<uint64_t>(s.nodes[b]), m = static_cast<uint64_t>(s.m);
  C2D_ELIMINATION_ARRAYS_(C2D_TAKE, nodes, m, elimination_bytes(plan))
  if (out) *out = area;
  return carver.total();
}

uint64_t reduction_area(const PhaseSizes& s, char* base, ReductionArea* out) {
  Carver carver{base, 0, true};
  ReductionArea area{};
  const uint64_t m = static_cast<uint64_t>(s.m);
  C2D_REDUCTION_ARRAYS_(C2D_TAKE, m)
  if (out) *out = area;
  return carver.total();
}

namespace {

// Of whichever body needs more.
void take_back_substitution(Carver& carver, const PhaseSizes& s, const EliminationPlan plan[2], PathArea& area) {
  const uint64_t m = static_cast<uint64_t>(s.m), cases = static_cast<uint64_t>(s.cases);
  uint64_t work = 0, outer = 0;
  for (int b = 0; b < 2; ++b) {
    if (s.rows[b] == 0) continue;
    work = larger(work, back_substitution_bytes(plan[b]));
    outer = larger(outer, static_cast<uint64_t>(s.outer[b]));
  }
  C2D_BACK_ARRAYS_(C2D_TAKE, m, cases, outer, work)
}

} // namespace

uint64_t path_area(const PhaseSizes& s, const EliminationPlan plan[2], bool flexibility, char* base, PathArea* out) {
  Carver carver{base, 0, true};
  PathArea area{};
  const uint64_t m = static_cast<uint64_t>(s.m), cases = static_cast<uint64_t>(s.cases);
  C2D_PATH_ARRAYS_(C2D_TAKE, m, cases)
  Carver rates = carver;
  for (int b = 0; b < 2; ++b) C2D_SURFACE_ARRAYS_(C2D_TAKE_OF_BODY, m)
  C2D_COLUMN_ARRAYS_(C2D_TAKE, m)
  if (flexibility) {
    carver.take(area.flexibility, m * m, sizeof(Real));
    rates = carver;
  }
  for (int b = 0; b < 2; ++b) {
    const uint64_t nodes = static_cast<uint64_t>(s.nodes[b]), ends = static_cast<uint64_t>(s.ends[b]);
    C2D_RESULT_ARRAYS_(C2D_TAKE_OF_BODY, nodes, ends)
  }
  take_back_substitution(carver, s, plan, area);
  const uint64_t used = carver.total();
  carver = rates;
  C2D_RATES_ARRAYS_(C2D_TAKE, m + 1)
  if (out) *out = area;
  return larger(used, carver.total());
}

uint64_t scratch_bytes(const PhaseSizes& s) {
  if (kSmallCode) return 0; // plain products take none
  int64_t most = full_scratch(s.m, s.m);
  for (int b = 0; b < 2; ++b) {
    const int64_t numbers = full_scratch(s.outer[b], s.outer[b] + 2 * s.m + s.cases);
    if (numbers > most) most = numbers;
  }
  return static_cast<uint64_t>(most) * sizeof(Real);
}

uint64_t phases_use(const PhaseSizes& s, const EliminationPlan plan[2], bool flexibility) {
  uint64_t need = larger(reduction_area(s, nullptr, nullptr), path_area(s, plan, flexibility, nullptr, nullptr));
  for (int b = 0; b < 2; ++b)
    if (s.rows[b] > 0) need = larger(need, elimination_area(s, b, plan[b], nullptr, nullptr));
  return need;
}

namespace {

// What elimination_area holds beside the work of the elimination.
uint64_t beside_elimination(const PhaseSizes& s, int b) {
  return elimination_area(s, b, EliminationPlan{}, nullptr, nullptr) - elimination_bytes(EliminationPlan{});
}

int64_t all_columns(const PhaseSizes& s, int b) { return s.outer[b] + 2 * s.m + s.cases; }

// The least memory: panels of the forced width, or of one column, written column by column.
void narrow_plans(const PhaseSizes& s, int32_t forced, EliminationPlan out[2]) {
  for (int b = 0; b < 2; ++b) {
    const int64_t most = all_columns(s, b) > 0 ? all_columns(s, b) : 1;
    const int64_t width = forced < 1 ? 1 : (forced < most ? forced : most);
    out[b] = plan_of(s, b, static_cast<int32_t>(width), 1);
  }
}

c2d_status plan_within(const PhaseSizes& s, uint64_t bytes, int32_t forced, EliminationPlan out[2]) {
  for (int b = 0; b < 2; ++b) {
    if (s.rows[b] == 0) continue;
    const uint64_t beside = beside_elimination(s, b);
    if (bytes < beside) return C2D_ERR_MEMORY;
    const c2d_status status =
        plan_elimination(bytes - beside, static_cast<int32_t>(s.rows[b]), static_cast<int32_t>(s.outer[b]),
                         static_cast<int32_t>(2 * s.m + s.cases), forced, out[b], nullptr);
    if (status != C2D_OK) return status;
  }
  return C2D_OK;
}

// The hostile build: whole blocks go through two buffers where there is room for that, with transfers on their way.
void double_buffers(const PhaseSizes& s, uint64_t bytes, EliminationPlan plan[2]) {
  for (int b = 0; b < 2 && kHostile; ++b)
    for (int32_t width = plan[b].block_columns; s.rows[b] > 0 && plan[b].block_rows == 0 && width > 0; width /= 2) {
      const EliminationPlan single = plan[b];
      plan[b].block_rows = plan[b].rows;
      plan[b].block_columns = width;
      if (phases_use(s, plan, false) > bytes) plan[b] = single;
    }
}

} // namespace

c2d_status choose_plans(const PhaseSizes& s, uint64_t bytes, int32_t forced, EliminationPlan out[2]) {
  // Wide blocks also cost memory in back substitution, beside the tableau: give the panels less until all fits.
  // Where memory is not scarce, panels leave the kernels their scratch; panels of a given width are no wider for it.
  const uint64_t scratch = scratch_bytes(s);
  for (uint64_t share = bytes / 8 > scratch && forced < 1 ? bytes - scratch : bytes;; share -= share / 8 + 1) {
    const c2d_status status = plan_within(s, share, forced, out);
    if (status != C2D_OK) break;
    if (phases_use(s, out, false) <= bytes) {
      double_buffers(s, bytes, out);
      return C2D_OK;
    }
    if (share < kAlignment) break;
  }
  narrow_plans(s, forced, out);
  if (phases_use(s, out, false) > bytes) return C2D_ERR_MEMORY;
  double_buffers(s, bytes, out);
  return C2D_OK;
}

c2d_status plan_phases(const Sizes& limits, const PhaseSizes& s, uint64_t bytes, EliminationPlan out[2]) {
  EliminationPlan most[2];
  const c2d_status status = choose_plans(phase_sizes(limits), bytes, limits.panel_columns, most);
  if (status != C2D_OK) return status;
  for (int b = 0; b < 2; ++b) {
    out[b] = plan_of(s, b, 1, 1);
    cut_alike(most[b], out[b]);
  }
  // (Strips of fewer rows are cut into wider blocks of UPPER, which round up otherwise.)
  return phases_use(s, out, false) <= bytes ? c2d_status{C2D_OK} : choose_plans(s, bytes, limits.panel_columns, out);
}

c2d_status phase_need(const Sizes& sizes, uint64_t* minimum, uint64_t* in_core) {
  const PhaseSizes s = phase_sizes(sizes);
  EliminationPlan plan[2];
  narrow_plans(s, sizes.panel_columns, plan);
  *minimum = phases_use(s, plan, false);
  // What choose_plans would do with all the memory there is.
  const c2d_status status = plan_within(s, UINT64_MAX - 1, sizes.panel_columns, plan);
  if (status != C2D_OK) return C2D_ERR_OVERFLOW;
  *in_core = phases_use(s, plan, true);
  const uint64_t scratch = scratch_bytes(s);
  if (*minimum == UINT64_MAX || *in_core > UINT64_MAX - scratch) return C2D_ERR_OVERFLOW;
  *in_core += round_up(scratch);
  return C2D_OK;
}

} // namespace c2d
