#pragma once
// Contact zones whose sides are meshed independently: which point of body 1 faces a point of body 2. Body 1's
// outward normals, joined continuously across its corners, are the lines along which points face each other.
#include "model/model.hpp"
#include "model/validate.hpp"

namespace c2d {

// A point on the elements of body 1 in a zone: element number, its place in the order of the zone, local
// coordinate.
struct FacePoint {
  int32_t element, place;
  double eta;
};

// The point of body 1 whose normal passes through (x, y), the nearest one; false if none does. Coordinates
// within 1e-9 of a functional node's or of an end's are that node's.
bool face_point(const Model& m, const Zone& z, double x, double y, FacePoint& out);
// Unit normal there, continuous along the zone.
void face_normal(const Model& m, const Zone& z, const FacePoint& at, double n[2]);
// How far the smooth surface that a body's elements stand for lies outside them at a point of the zone, from
// the angles at which neighbours meet: zero at the boundary points. *doubt: what of it may be wrong.
double bulge_at(const Model& m, const Zone& z, int b, const FacePoint& at, double* doubt);
// The reverse: element of body 2 in the zone and local coordinate of the point that a point of body 1 faces.
bool facing_point(const Model& m, const Zone& z, const FacePoint& at, int32_t* element, double* eta);
// Functional node of body 1 at a point, -1 between nodes.
int32_t node_at(const Model& m, const FacePoint& at);

// A piece of an element of body 2 and what it faces on body 1; matching is linear in the local coordinates of
// both. [0] comes first in the order of the zone.
struct FacingPiece {
  int32_t element1;
  double eta1[2], eta2[2];
};
// The pieces of one element of body 2, cut at the nodes of both sides: start, then next until it is false.
struct PieceWalk {
  const Model* m;
  const Zone* z;
  int32_t element2, stop; // stop: how many functional nodes or ends of element2 have been passed
  FacePoint now, target;
  double eta2, target_eta2;
};
PieceWalk start_pieces(const Model& m, const Zone& z, int32_t place2);
bool next_piece(PieceWalk& walk, FacingPiece& out);

// Cut the zone down to the elements of body 2 that face body 1 wholly, and fill its nodes and pairs. Faults:
// no such element, several runs of them, sides that do not face each other. Warning: C2D_WARN_LEFT_OUT, elements
// that face body 1 in part. Returns false if it told a fault.
bool fit_free_zone(const Model& m, int32_t zone, Reporter& reporter);

// The parts of these zones are optional (memory/optional.hpp): this file, contact/facing_pairs.hpp, bie/transfer.hpp and
// solver/transferred.hpp.

} // namespace c2d
