#pragma once
// Contact on demand of bodies that the contact alone holds (METHOD 10.12): as in the open form of the whole contact system
// (contact/reduction/open_form.hpp) their motions are given by a few slots of the pairs, which are chosen from the model before
// anything is assembled.
#include "contact/basis.hpp"
#include "solver/session.hpp"

namespace c2d {

struct HeldSlots {
  int32_t count, slot[kMostHeld]; // ascending
};
// Slots that hold the motions of all bodies well: normals, or normals and tangents of pairs that may have friction. False:
// there are none such.
bool choose_held(c2d_solver* solver, const Model& model, HeldSlots& out);

// After the reduction: R and G with 1 in these slots, the motions of side 0, the basis, the columns of these pairs, and the
// rates of the loads, to the tape. `sliding`: without columns of tangents. Errors: the block store's; C2D_ERR_SINGULAR;
// C2D_ERR_LIMIT: a body that the contact alone holds bends too much.
c2d_status hold_on_demand(c2d_solver* solver, bool sliding);
// What the columns of the slots that hold motions bring to checks and energies, once the rest of their books is there.
c2d_status count_held(c2d_solver* solver);
// Where a state is taken up whose contact system was not on the tape any more: its columns, as they were counted. Errors: the
// block store's; C2D_ERR_INTERNAL: there are no such pairs.
c2d_status remake_columns(c2d_solver* solver);

// Of functionals of the energies (solver/energy/energy_functionals.cpp): what the outer unknowns of body b bring under its
// motions, in numbers of these; and motions of all bodies out of a functional, x = w' - (A tau + sum lambda_k h_k) in the slots
// that hold: `motion` goes to coefficients of w' and lambda; what tau brings comes with its columns.
c2d_status functional_of_motions(const Session& session, int b, const Real* outer, Real* motion);
c2d_status hold_functional(const Session& session, const Real* motion, Real* jump, double* lambda);

} // namespace c2d
