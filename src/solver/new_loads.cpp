// The only references to what new loads alone need: without the call that asks for them the linker leaves it all out.
#include "solver/new_loads.hpp"

namespace c2d {

c2d_status eliminate_new_loads(const EliminationPlan& plan, int32_t first_trailing, const ColumnSource& source,
                               const RowSink& sink, Tapes& tapes, void* work, const Watch& watch, const Engine& engine) {
  return eliminate_again(plan, first_trailing, source, sink, tapes, work, watch, engine);
}

c2d_status reduce_new_loads(const Reduction& reduction) { return reduce_loads(reduction); }

} // namespace c2d
