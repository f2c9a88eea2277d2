// c2d_tape_need: bounds of the tapes of models within given limits.
#include <stddef.h>

#include "contact/contact_tape.hpp"
#include "interface/entry.hpp"
#include "memory/parts.hpp"
#include "solver/phases.hpp"
#include "solver/save.hpp"

namespace c2d {

C2D_USES(CompressedPart);

namespace {

struct Tape {
  uint64_t blocks, data_bytes; // data bytes of a block, without its header
};

// With space for two saved states of a path.
Tape control_tape(const Sizes& sizes, const Layout& layout) {
  const uint64_t m = static_cast<uint64_t>(sizes.contact), cases = static_cast<uint64_t>(sizes.load_cases);
  const uint64_t room = static_cast<uint64_t>(columns_of(sizes));
  const uint64_t path = C2D_PATH_ARRAYS_(C2D_ADD_, m, room, m, cases + C2D_SLIP_(sizes.curves)),
                 columns = C2D_COLUMN_ARRAYS_(C2D_ADD_, m);
  const uint64_t surface = C2D_SURFACE_ARRAYS_(C2D_ADD_, m);
  return {save_blocks(layout.persistent - offsetof(c2d_solver, model) + round_up(path) + 2 * surface + columns), kPieceBytes};
}

Tape contact_tape(const Sizes& sizes) {
  if (sizes.contact == 0) return {0, 0};
  return {static_cast<uint64_t>(contact_blocks(sizes.bodies, columns_of(sizes), sizes.motions, sizes.load_cases)),
          contact_block_numbers(sizes.contact) * sizeof(Real)};
}

// LOWER and UPPER contain the blocks of all bodies, one after the other.
void factor_tape(const Sizes& sizes, uint64_t bytes, bool keep, bool upper, Tape& out) {
  const PhaseSizes phases = phase_sizes(sizes);
  PlanRule rule;
  choose_rule(phases, bytes, sizes.panel_columns, rule);
  out = {0, 0};
  for (int b = 0; b < sizes.bodies; ++b) {
    if (phases.of(b).rows == 0) continue;
    EliminationPlan plan = plan_by(rule, phases, b);
    plan.keep_lower = keep;
    const TapeUse use = upper ? most_upper_use(plan) : lower_use(plan);
    out.blocks += use.blocks;
    if (use.max_data_bytes > out.data_bytes) out.data_bytes = use.max_data_bytes;
  }
}

// The same with compressed elimination. Any body may be dense all the same: with equations of free zones, or if elements on
// lines of symmetry divide its curves into many holes.
c2d_status compressed_tape(const Sizes& sizes, uint64_t bytes, const c2d_options& options, bool upper, Tape& out) {
  TapeUse use{};
  const c2d_status status = kCompressedPart.compression_tape(phase_sizes(sizes), bytes, upper, use);
  if (status != C2D_OK) return status;
  out = {0, 0};
  if (sizes.free_pairs > 0 || options.symmetry == C2D_SYMMETRY_IMAGES) factor_tape(sizes, bytes, false, upper, out);
  out.blocks += use.blocks;
  if (use.max_data_bytes > out.data_bytes) out.data_bytes = use.max_data_bytes;
  return C2D_OK;
}

// Checks the tape and copies the caller's options, or the defaults.
bool take_choice(int32_t tape, const c2d_options* options, c2d_options& chosen, c2d_error* why) {
  char what[128] = "";
  Text fault = text_in(what);
  if (tape < 0 || tape >= C2D_TAPES)
    put_all(fault, "tape is ", tape, ", expected 0 to ", C2D_TAPES - 1);
  else if (options && !is_begun(options))
    put_not_begun(fault, "c2d_options", options);
  else if (options)
    copy_in(options, &chosen, sizeof chosen);
  if (what[0] == '\0') return true;
  explain(why, C2D_ERR_ARGUMENT, 0, what);
  return false;
}

} // namespace
} // namespace c2d

using namespace c2d;

extern "C" c2d_status c2d_tape_need(const c2d_limits* limits, const c2d_options* options, uint64_t workspace_bytes,
                                    int32_t tape, uint64_t* blocks, uint64_t* block_bytes, c2d_error* why) {
  c2d_options chosen{};
  uint64_t minimum = 0;
  const c2d_status status = c2d_memory_need(limits, &minimum, nullptr, why);
  if (status != C2D_OK) return status;
  if (!take_choice(tape, options, chosen, why)) return C2D_ERR_ARGUMENT;
  if (workspace_bytes < minimum) {
    explain(why, C2D_ERR_MEMORY, minimum);
    return C2D_ERR_MEMORY;
  }
  c2d_limits ours;
  Sizes sizes;
  Layout layout;
  copy_in(limits, &ours, sizeof ours);
  derive_sizes(ours, sizes); // limits with a computable need have sizes and a layout
  lay_out(sizes, sizeof(c2d_solver), layout);
  if (!kSmallCode && chosen.elimination == C2D_ELIMINATION_BY_SIZE)
    chosen.elimination = kCompressedPart.elimination_by_size(sizes);
  Tape need = {0, 0};
  if (tape == C2D_TAPE_CONTROL)
    need = control_tape(sizes, layout);
  else if (tape == C2D_TAPE_CONTACT)
    need = contact_tape(sizes);
  else if (!kSmallCode && chosen.elimination == C2D_ELIMINATION_COMPRESSED) {
    const c2d_status fits =
        compressed_tape(sizes, workspace_bytes - (kAlignment - 1) - layout.persistent, chosen, tape == C2D_TAPE_UPPER, need);
    if (fits != C2D_OK) {
      explain(why, fits, layout.persistent + kCompressedPart.compression_that_will_do(phase_sizes(sizes), 0) + kAlignment - 1);
      return fits;
    }
  } else
    factor_tape(sizes, workspace_bytes - (kAlignment - 1) - layout.persistent, chosen.keep_factors != 0, tape == C2D_TAPE_UPPER,
                need);
  if (blocks) *blocks = need.blocks;
  if (block_bytes) *block_bytes = need.blocks > 0 ? kBlockHeaderBytes + need.data_bytes : 0;
  return C2D_OK;
}
