#pragma once
// The first state of a load path, and the flight of a body that nothing touches yet (METHOD 12, start (a)).
#include "contact/path.hpp"

namespace c2d {

// What the contact has to hold: how it can move. Motions: (ux, uy, rotation * length unit) about the centre.
struct FreeBody {
  int32_t body;    // the only one with free motions; -1: there are several, or none, and what follows `motions` is not known
  int32_t motions; // free rigid motions of all bodies in contact,
  int32_t slides;  // 1: along one of these it slides without friction whatever touches, and nothing fixes its place there; or 0
  double motion[3]; // of the others, if it is one
  double slide[3];  // METHOD 13.6
  double centre[2];
  int32_t others() const { return motions - slides; }
};

// Zero load, no history: statuses (touching pairs stick, or slide if mu = 0; everything else open), tableau, books.
// If these statuses would leave the body free, *floating is 1 and the tableau is not valid until fly().
// Errors: the block store's.
c2d_status start_path(Follower& f, const FreeBody& body, const Model& model, int32_t* floating);

// Change of w of a pair per unit of a rigid motion of body b (as FreeBody::motion), in the length unit; none where the pair is
// not on b.
void motion_at_pair(const Model& model, int b, const double motion[3], const double centre[2], const Pair& pair, double out[2]);
// The j-th free motion of a body: displacements of its contact unknowns.
void motion_column(const Model& model, int b, int32_t j, Real* out);

// Nothing is loaded yet and the body floats with one motion: follow it without force in the direction in which the
// load does work (`work` per unit of the motion, along the path's direction) until the first pair touches.
// C2D_FREE_MOTION if it never does, if there is no work, or if more than one motion is free.
c2d_status fly(Follower& f, const FreeBody& body, const Model& model, double work, c2d_outcome* outcome);

// Nothing is loaded yet and the body floats, but the loads along the path's direction do not move it: it lies where the model
// has it (contact/let_go.hpp), C2D_REACHED. C2D_FREE_MOTION if they do. Errors: the block store's.
c2d_status lie_apart(Follower& f, const Model& model, c2d_outcome* outcome);

} // namespace c2d
