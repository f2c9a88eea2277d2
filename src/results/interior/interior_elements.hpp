#pragma once
// What one element of a boundary adds to the sums of points, from what back substitution has found.
#include "bie/integrals/interior.hpp"
#include "results/interior/interior_nodes.hpp"
#include "results/interior/interior_placing.hpp"

namespace c2d {

// What an image contributes is what the element itself does at the mirrored point, mirrored.
inline void add_stress(int image, const PointField& sum, PointSums& p) {
  p.stress[0] += sum.trace;
  p.stress[1] += sum.deviator.re;
  p.stress[2] += image_sign(image, 0) * image_sign(image, 1) * sum.deviator.im;
}
inline void add_displacement(int image, const PointField& sum, PointSums& p) {
  p.u[0] += image_sign(image, 0) * sum.u.re;
  p.u[1] += image_sign(image, 1) * sum.u.im;
}

// Nodal values of an element in the units of the equations. Contact tractions on side 1 are per length of side 0 and
// come apart from the others.
struct NodalValues {
  Complex u[kElementNodes], own[kElementNodes], contact[kElementNodes];
  bool any_contact;
};
void nodal_values(const Session& session, int b, int32_t element, NodalValues& out);

// Progress is told: so many elements of the body are done with. Errors: CANCELLED, recorded.
c2d_status pause_at_points(const Session& session, int b, int32_t elements);

// The element on points that lie inside: displacements and stresses, or displacements alone.
void integrate_element(const Session& session, int b, int32_t element, const Points& points);
void integrate_displacements(const Session& session, int b, int32_t element, const Points& points);

// An element that acts on points. One with displacements, and so with all that the element has of them, smooths the
// stress close to its nodes, where stresses are asked for.
struct Acting {
  const Session* session;
  int b;
  int32_t element;
  ElementSmoothing* smoothing; // of those that smooth
  FieldElement e;
};
// Without smoothing.
void add_element(Acting& acting, const Points& points);

} // namespace c2d
