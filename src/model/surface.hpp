#pragma once
// The smooth surfaces that elements approximate: one curve for gaps, normals and facing points, in matching and free zones.
// Displacements and tractions remain functions on the elements.
//
// Elements of three and four boundary points are their own curve, bent by a polynomial of the fourth or fifth degree that
// vanishes at these points, so that neighbours have one tangent, which lies between theirs; not where they meet at more
// than a tenth of the angle by which either turns.
//
// Between two boundary points the curve is the conic with given tangents there whose weight is the cosine of their mean
// angle with the chord, a0 and a1:
//   (x, y) = (w 2s(1-s) (q, h) + s^2 (1, 0)) / (1 - 2 (1-w) s(1-s)),  w = cos((a0+a1)/2),
//   q = tan a1 / (tan a0 + tan a1),  h = q tan a0,
// in lengths of the chord; a circle where the angles are equal, the chord where they have unlike signs or one is zero. So
// it bends to one side only. The angles follow from up to three boundary points more on either side. The circle through
// three of them has a tangent that is wrong by k' b c / 6, b and c the distances to the other two; k' is taken from the
// curvatures of two neighbouring triples. Four such rows contain the point, two across it and one on either side; they are
// weighted with the inverse fourth power of k', so that one across a kink or a jump of curvature counts nothing beside one
// that ends there. The tangent may differ on either side of a point where the curve has a kink; where the two differ by
// less than a tenth of the turn of the chords, or such that the curve would bend back, they are one.
//
// Points on a circle give this circle. On a curve whose curvature varies smoothly and keeps its sign the error is of the
// fourth order in the chord's length L, with points of inflection of the third. Where the curvature jumps at a boundary
// point nothing is lost; elsewhere within an element it costs up to half of L^2/8 times the jump there, a quarter in its
// neighbours. Where the chords bend to one side, so does the curve. A turn of more than 38 degrees is a corner of the body:
// nothing is concluded across it. At a line of symmetry the curve goes on as its own image.
//
// A given curve (Curve: a line, an arc, a spline) is used as it is, and its ends are corners. A spline uses only the two rows
// across a point.
#include "model/model.hpp"

namespace c2d {

// A point of the surface and the unit normal out of the body there, of this element at its ends.
struct SurfacePoint {
  double x, y, nx, ny;
};
// The surface over one element.
struct SurfaceElement {
  int32_t nodes;
  double x[kElementNodes], y[kElementNodes];
  double bend[2];           // two boundary points: tan a0, tan a1; more: the turns of the tangent at either end
  double weight;            // of the conic
  double length;            // of curved elements
  double centre[2], radius; // of a given arc; 0: none
  double doubt;             // uncertainty of the curve between the boundary points
};
SurfaceElement surface_element(const Model& m, int b, int32_t element);
SurfacePoint surface_point(const SurfaceElement& element, double eta);
SurfacePoint surface_point(const Model& m, int b, int32_t element, double eta);
// The curve that is given for an element's surface; null: none.
const Curve* curve_of(const Model& m, int b, int32_t element);
// The element that follows (way 1) or goes before (-1) along the boundary; -1 at an end of an open region.
int32_t element_beside(const Model& m, int b, int32_t element, int way);

// The normal of the pairs of a zone is part n0 - (1 - part) n1, with n0 and n1 the outward normals of its sides. With
// part = k1 / (k0 + k1) and the curvatures k it is, near the point where two circles touch, the fixed direction along which
// half plane theory measures gaps and pressures: the normal of the flat where a cylinder meets a flat, whichever body is first
// and however stiff. k is the mean over a side of the zone, zero where it is concave: in a hole the normals are those of the
// hole. One half where both are flat.
double find_normal_part(const Model& m, const Zone& z);

} // namespace c2d
