// The call that asks for new loads, and the only references to what they alone need: without the call the linker leaves
// it all out.
#include "solver/new_loads.hpp"

#include "solver/solver.hpp"

namespace c2d {

c2d_status eliminate_new_loads(const EliminationPlan& plan, int32_t first_trailing, const ColumnSource& source,
                               const RowSink& sink, Tapes& tapes, void* work, const Watch& watch, const Engine& engine) {
  return eliminate_again(plan, first_trailing, source, sink, tapes, work, watch, engine);
}

c2d_status reduce_new_loads(const Reduction& reduction) { return reduce_loads(reduction); }

} // namespace c2d

using namespace c2d;

extern "C" c2d_status c2d_change_loads(c2d_solver* s) {
  const c2d_status status = enter(s, state_bit(C2D_STATE_PREPARED) | state_bit(C2D_STATE_RUNNING));
  if (status != C2D_OK) return status;
  s->loads_changed = 1;
  s->state = C2D_STATE_MODEL;
  return C2D_OK;
}
