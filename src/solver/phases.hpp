#pragma once
// What the phase area of the workspace holds, one phase after another. The same functions tell the need and carve.
#include "contact/contact_tape.hpp"
#include "contact/reduction/reduction.hpp"
#include "contact/tableau.hpp"
#include "elimination/eliminate.hpp"
#include "memory/sizes.hpp"

namespace c2d {

// What each phase works with: the lists of contact2d_memory.h, a member for each array.
#define C2D_MEMBER_OF(type, name, count, each) type* name;
#define C2D_MEMBER_OF_EACH(type, name, count, each) type* name[2];
struct EliminationArea { // assembly and elimination of one body
  C2D_ELIMINATION_ARRAYS_(C2D_MEMBER_OF, , , )
};
struct ReductionArea { // reduction of the bodies to the contact
  C2D_REDUCTION_ARRAYS_(C2D_MEMBER_OF, , , )
};
struct PathArea { // the load path, and back substitution beside it
  C2D_PATH_ARRAYS_(C2D_MEMBER_OF, , , , )
  C2D_RATES_ARRAYS_(C2D_MEMBER_OF, )        // begin behind F where that is kept
  C2D_SURFACE_ARRAYS_(C2D_MEMBER_OF_EACH, ) // of the bodies on each side of the pairs
  C2D_COLUMN_ARRAYS_(C2D_MEMBER_OF, )
  Real* flexibility; // F of all bodies, one after another, or null
  C2D_RESULT_ARRAYS_(C2D_MEMBER_OF, , )
  C2D_BACK_ARRAYS_(C2D_MEMBER_OF, , , , )
  void* later; // behind all that: what columns on demand are made with
};
#undef C2D_MEMBER_OF
#undef C2D_MEMBER_OF_EACH

// Sizes of one model, or of the largest within limits.
struct BodyPhase {
  int64_t nodes, rows, outer, contact; // outer: columns eliminated; without equations rows is 0
};
struct PhaseSizes {
  int64_t m, motions, cases;
  int64_t slip;        // columns of the tableau for gaps that follow slip: 0 or 1
  int64_t further;     // displacements that are unknowns of the contact system (Enters)
  int64_t widest;      // contact unknowns of the model or of a body: one that meets itself has two for each of the model's
  int64_t columns;     // of the tableau: m, or as many as there is room for on demand
  int64_t square;      // contact unknowns of matrices that are reduced; on demand none are
  int64_t nodes, ends; // of all bodies
  int64_t flexibility; // numbers of all F
  int32_t bodies;
  const Model* model; // or null, and:
  const Sizes* limits;
  BodyPhase of(int b) const;
};
PhaseSizes phase_sizes(const Sizes& sizes); // the most that models within the limits need
PhaseSizes model_sizes(const Model& model);

// How the bodies' eliminations are cut, body by body. Block numbers are not yet set.
struct PlanRule {
  uint64_t bytes; // each elimination fits into so many of the phase area; 0: the least memory, panels of one column
  int32_t forced; // > 0: width of the panels
};
EliminationPlan plan_by(const PlanRule& rule, const PhaseSizes& s, int b);
// Widest panels with which every phase fits into `bytes`, no less than the need; forced > 0 is their width.
void choose_rule(const PhaseSizes& s, uint64_t bytes, int32_t forced, PlanRule& out);
// Those of a model, cut as the largest model within the limits is: so its tapes are known from the limits.
void plan_phases(const Sizes& limits, const PhaseSizes& s, uint64_t bytes, EliminationPlan* out);

// Can this be how the body's elimination is cut?
bool is_plan_of(const PhaseSizes& s, int b, const EliminationPlan& plan);

// What back substitution takes beside the path, of whichever body needs more.
struct BackNeed {
  uint64_t work, outer;
  uint64_t later; // of columns on demand
};
BackNeed back_need(const PhaseSizes& s, const EliminationPlan* plan);

// Bytes from the start of the phase area; with a base, *out is carved from it. UINT64_MAX: beyond any memory.
uint64_t elimination_area(const PhaseSizes& s, int b, const EliminationPlan& plan, char* base, EliminationArea* out);
uint64_t reduction_area(const PhaseSizes& s, char* base, ReductionArea* out);
uint64_t path_area(const PhaseSizes& s, const BackNeed& back, bool flexibility, char* base, PathArea* out);

// Scratch with which the dense kernels run at full speed; taken from what a phase leaves.
uint64_t scratch_bytes(const PhaseSizes& s);

// The largest of all phases with these plans, without scratch.
uint64_t phases_use(const PhaseSizes& s, const EliminationPlan* plan, bool flexibility);

// Least and useful most bytes of the whole phase area for models within limits; in_core may be null. Errors: C2D_ERR_OVERFLOW.
c2d_status phase_need(const Sizes& sizes, uint64_t* minimum, uint64_t* in_core);

} // namespace c2d
