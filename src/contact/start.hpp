#pragma once
// The first state of a load path, and how bodies that float come to rest (METHOD 12, start (a)).
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

// Zero load, no history: statuses (touching pairs stick, or slide without friction; everything else open), tableau, books.
// If these statuses would leave the body free, *floating is 1 and the tableau is not valid until seat().
// Errors: the block store's.
c2d_status start_path(Follower& f, int32_t* floating);

// Change of w of a pair per unit of a rigid motion of body b (as FreeBody::motion), in the length unit; none where the pair is
// not on b.
void motion_at_pair(const Model& model, int b, const double motion[3], const double centre[2], const Pair& pair, double out[2]);
// The j-th free motion of a body: displacements of its contact unknowns.
void motion_column(const Model& model, int b, int32_t j, Real* out);
// Of two motions of body b, the sum over the pairs that METHOD (13.3) is about.
double pair_product(const Model& m, int b, const double u[3], const double v[3]);

// Nothing is loaded yet and some bodies float, or are pulled off what they touch. Where the loads along the path's direction do
// not move them they lie as the model has them. Else they slide as if rigid, without friction, until what touches balances
// these loads with its friction (METHOD 12, start (a)), and it holds them: C2D_REACHED. C2D_FREE_MOTION if that never comes, or
// what touches leaves a motion free; then all is as it was. `floating`: there is no tableau. Errors: the block store's.
c2d_status seat(Follower& f, int32_t floating, c2d_outcome* outcome);

} // namespace c2d
