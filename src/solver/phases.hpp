#pragma once
// What the phase area of the workspace holds, one phase after another. The same functions tell the need and carve.
#include "contact/contact_tape.hpp"
#include "contact/reduction.hpp"
#include "contact/tableau.hpp"
#include "elimination/eliminate.hpp"
#include "memory/sizes.hpp"

namespace c2d {

// Assembly and elimination of one body.
struct EliminationArea {
  double* diagonal; // [4 * nodes]
  double* point;    // [2 * nodes] collocation points in the length unit
  int32_t* twin;    // [nodes], see bie/columns.hpp
  void* scratch;    // AssemblyScratch of bie/panel.hpp
  void* work;       // of eliminate()
  void* buffer;     // of the contact tape
};
// Reduction of both bodies to the contact.
struct ReductionArea {
  Real *first, *second, *strip;
  int32_t* pivots;
  void* buffer;
};
// The load path, and back substitution beside it.
struct PathArea {
  Real* tableau;
  Real *y, *dy;
  Real* good;            // m: y of the last state found good (solver/judge.hpp)
  void* buffer;          // of the contact tape
  void* rates;           // numbers of the rate problem; share their place with all that follows, which is of no use while loads
                         // move, but begin behind F where that is kept
  Real* u[2];            // contact displacements of both bodies, m each
  Real* column;          // m
  Real* flexibility;     // m * m, or null
  Real* displacement[2]; // [2 * nodes] results, in length_unit
  Real* traction[2];     // [2 * ends] results, true tractions, in stress_unit
  Real* outer;           // outer unknowns of one body
  Real* coefficient;     // of its trailing columns
  void* work;            // of back_substitute()
};

// Sizes of one model (or of limits): what both bodies need at most.
struct PhaseSizes {
  int64_t m, cases;
  int64_t nodes[2], ends[2], rows[2], outer[2]; // outer: columns eliminated
};
PhaseSizes phase_sizes(const Sizes& sizes); // the most that models within the limits need

// Bytes from the start of the phase area; with a base, *out is carved from it. UINT64_MAX: beyond any memory.
uint64_t elimination_area(const PhaseSizes& s, int b, const EliminationPlan& plan, char* base, EliminationArea* out);
uint64_t reduction_area(const PhaseSizes& s, char* base, ReductionArea* out);
uint64_t path_area(const PhaseSizes& s, const EliminationPlan plan[2], bool flexibility, char* base, PathArea* out);

// Scratch with which the dense kernels run at full speed; taken from what a phase leaves.
uint64_t scratch_bytes(const PhaseSizes& s);

// The largest of all phases with these plans, without scratch.
uint64_t phases_use(const PhaseSizes& s, const EliminationPlan plan[2], bool flexibility);

// The plan of one body for these panel and block columns, block numbers not yet set.
EliminationPlan plan_of(const PhaseSizes& s, int b, int32_t panel_columns, int32_t block_columns);
// Widest panels with which every phase fits into `bytes`; forced > 0 is their width. Errors: C2D_ERR_MEMORY.
c2d_status choose_plans(const PhaseSizes& s, uint64_t bytes, int32_t forced, EliminationPlan out[2], bool* flexibility);

// Least and useful most bytes of the whole phase area for models within limits. Errors: C2D_ERR_OVERFLOW.
c2d_status phase_need(const Sizes& sizes, uint64_t* minimum, uint64_t* in_core);

} // namespace c2d
