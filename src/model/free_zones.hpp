#pragma once
// Free contact zones, whose sides are meshed independently: points of the two surfaces (model/surface.hpp) that face each
// other. The line between them has the direction of the pair normal, a mixture of the outward normals of both surfaces, which
// are continuous across kinks. In names 1 stands for side 0 of the zone and 2 for side 1.
#include "model/surface.hpp"
#include "model/validate/validate.hpp"

namespace c2d {

// A point on a side of a zone: element number, its place in the order of the zone, local coordinate.
struct FacePoint {
  int32_t element, place;
  double eta;
};

// The point of the surface there, and its unit outward normal, continuous along the zone.
SurfacePoint normal_in_zone(const Model& m, const Zone& z, int side, const FacePoint& at, double n[2]);
// The nearest point of side 0 that a point of side 1 faces; false if there is none. Local coordinates within 1e-9 of a
// functional node or an end are moved onto it.
bool face_point(const Model& m, const Zone& z, const FacePoint& at2, FacePoint& out);
// The reverse.
bool facing_point(const Model& m, const Zone& z, const FacePoint& at1, FacePoint& out);
// The same with the known positions of the pairs: the whole zone is searched only if the point is not between its two pairs.
bool facing_point_by_pairs(const Model& m, const Zone& z, const FacePoint& at1, FacePoint& out);
// Unit direction of the line along which two points face each other, from side 0 to side 1.
void facing_direction(const Model& m, const Zone& z, const FacePoint& at1, const FacePoint& at2, double n[2]);
// Functional node of body b, which has the element, at a point; -1 between nodes.
int32_t node_at(const Model& m, int b, const FacePoint& at);
// The second element of the zone at a pair that faces a joint of two elements; -1: there is none.
int32_t element_beside_pair(const Model& m, const Pair& pair);

// A piece of an element of side 1 and the piece of side 0 that it faces, matched linearly in the local coordinates of both. [0]
// comes first in the order of the zone.
struct FacingPiece {
  int32_t element1;
  double eta1[2], eta2[2];
};
// The pieces of one element of side 1, cut at the nodes of both sides: start, then next until it is false.
struct PieceWalk {
  const Model* m;
  const Zone* z;
  int32_t element2, place2, stop; // stop: how many functional nodes or ends of element2 have been passed
  FacePoint now, target;
  double eta2, target_eta2;
};
PieceWalk start_pieces(const Model& m, const Zone& z, int32_t place2);
bool next_piece(PieceWalk& walk, FacingPiece& out);

// Reduces the zone to the elements of side 1 that face side 0 over their whole length, and sets its nodes and pairs. Faults: no
// such element, several ranges of them, sides that do not face each other. Warning: C2D_WARN_LEFT_OUT, elements that face side
// 0 in part. Returns false if it reported a fault.
bool fit_free_zone(const Model& m, int32_t zone, Reporter& reporter);

// The parts of these zones are optional (memory/parts.hpp): this file, contact/pairs/facing_pairs.hpp, bie/transfer.hpp and
// results/transferred.hpp.

} // namespace c2d
