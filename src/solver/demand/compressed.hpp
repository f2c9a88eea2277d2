#pragma once
// Compressed elimination (METHOD 7.6) as a part of the solver: which bodies it takes, in what memory, and what solutions are
// worth. A body that it takes has the plan of its border among the plans; every other one is eliminated as ever.
#include "elimination/compressed.hpp"
#include "solver/phases.hpp"

namespace c2d {

// Plans of a model's bodies, in place of those for dense elimination where they may be. `most`: of the limits; the bytes are
// those of the phase area. Errors: C2D_ERR_MEMORY.
c2d_status plan_compression(const PhaseSizes& most, uint64_t bytes, const Model& m, EliminationPlan* out);
// Bytes of the phase area that will do where cells ask for this rank, as far as can be told; 0: it is not known.
uint64_t compression_that_will_do(const PhaseSizes& most, int32_t rank);
// Blocks and their data on LOWER or UPPER of any model within the limits whose bodies are all compressed. Errors: as above.
c2d_status compression_tape(const PhaseSizes& most, uint64_t bytes, bool upper, TapeUse& out);

// The plan of a body by that of its border.
CompressedPlan compression_of(const Model& m, int b, const EliminationPlan& border);
// What the functions of elimination/compressed.hpp tell of a body by the plan of its border.
bool is_compression_of(const Model& m, int b, const EliminationPlan& border);
uint64_t compression_bytes(const Model& m, int b, const EliminationPlan& border);
uint64_t compression_back_bytes(const Model& m, int b, const EliminationPlan& border);
uint64_t later_bytes(const Model& m, int b, const EliminationPlan& border); // on demand (solver/demand/on_demand.hpp)
void compression_uses(const Model& m, int b, const EliminationPlan& border, TapeUse& lower, TapeUse& upper);

// *rank, with C2D_ERR_MEMORY: what a cell asks for.
c2d_status compress(const EliminationPlan& border, const ColumnSystem& system, const RowSink& sink, Tapes& tapes, void* work,
                    PivotStats* stats, int32_t* rank, const Watch& watch, const Engine& engine);

struct Session;
// Displacements and tractions of a body outside its contact, in area.outer, by area.coefficient; how exact they are is noted.
c2d_status solve_compressed(Session& session, int b);
// As transposed_functional.
c2d_status compression_functional(Session& session, int b, Real* f, Real* w);
// Of all displacements of a body: what round-off of size one in the equations makes of them, mean square times their number.
c2d_status compression_growth(Session& session, int b, double* growth);

} // namespace c2d
