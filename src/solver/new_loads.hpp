#pragma once
// New right-hand sides through the factorisation that is on the tapes. Optional (memory/optional.hpp), with c2d_change_loads:
// a program without it never has them. Arguments as for what these stand for.
#include "contact/reduction.hpp"
#include "elimination/eliminate.hpp"

namespace c2d {

c2d_status eliminate_new_loads(const EliminationPlan& plan, int32_t first_trailing, const ColumnSource& source,
                               const RowSink& sink, Tapes& tapes, void* work, const Watch& watch, const Engine& engine);
c2d_status reduce_new_loads(const Reduction& reduction);

} // namespace c2d
