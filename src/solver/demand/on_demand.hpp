#pragma once
// Contact on demand (METHOD 10.12): where far more pairs may touch than ever do, no matrix of the contact is formed. Nodes in
// contact are nodes of the bodies' trees, and a column of the contact system, what a traction at a pair makes of all pairs, is
// solved for when the pair is about to touch.
#include "elimination/later_sides.hpp"
#include "solver/session.hpp"

namespace c2d {

// Is the model's contact on demand? Limits, options, supports and zones say so: sets ModelHeader::columns and Body::on_demand,
// and numbers the unknowns of the bodies.
void plan_demand(c2d_solver* solver, const Model& model);

// Of the path area: what a body's columns are made with, for a plan of its tree and m contact unknowns.
uint64_t later_bytes(const CompressedPlan& plan, int64_t m);

// Told, with its status, where there is no room for more columns: pairs and bytes that will do as far as can be known.
c2d_status tell_touching(c2d_solver* solver);

// After elimination: what each load case makes of the contact of each body, and its motions and balances that supports leave,
// to the tape. Errors: the block store's.
c2d_status respond_on_demand(c2d_solver* solver);
// ContactTape::make, of a session. C2D_ERR_MEMORY: more pairs touch, or are about to, than there is room for; then nothing is
// made.
c2d_status make_columns(void* session, const int32_t* pair, int32_t count);
// The same, for pairs whose columns may be there already; `counts`: what they bring to checks and energies is added.
c2d_status make_some(Session& session, const int32_t* pair, int32_t count, bool counts);
// For 2 kMostSides columns of the contact, between calls of these functions.
Real* room_for_columns(const Session& session);
// solve_motions of a body's tree.
c2d_status solve_body_motions(const Session& session, int b, Real** x);
// With the displacements of the contact in area.u: motions of rigid bodies that the contact alone holds, to area.motion.
c2d_status fit_rigid(const Session& session);
// Unknowns outside the contact of a body, in area.outer, by tractions and load factors as trailing_coefficients lists them.
c2d_status solve_on_demand(Session& session, int b, const CompressedPlan& plan, const Real* coefficient);

} // namespace c2d
