#pragma once
// Contribution of one boundary element to the sums of points, from the results of back substitution.
#include "bie/integrals/interior.hpp"
#include "results/interior/interior_nodes.hpp"
#include "results/interior/interior_placing.hpp"

namespace c2d {

// The contribution of an image is that of the element itself at the reflected point, reflected back.
inline void add_stress(int image, const PointField& sum, PointSums& p) {
  p.stress[0] += sum.trace;
  p.stress[1] += sum.deviator.re;
  p.stress[2] += image_sign(image, 0) * image_sign(image, 1) * sum.deviator.im;
  if (kRings) p.round += sum.round;
}
inline void add_displacement(int image, const PointField& sum, PointSums& p) {
  p.u[0] += image_sign(image, 0) * sum.u.re;
  p.u[1] += image_sign(image, 1) * sum.u.im;
}

// Nodal values of an element in the units of the equations. Contact tractions on side 1 are per length of side 0 and stored
// separately.
struct NodalValues {
  Complex u[kElementNodes], own[kElementNodes], contact[kElementNodes];
  bool any_contact;
};
void nodal_values(const Session& session, int b, int32_t element, NodalValues& out);

// Reports progress, the number of finished elements of the body. Errors: CANCELLED, recorded.
c2d_status pause_at_points(const Session& session, int b, int32_t elements);

// The element on points that lie inside: displacements and stresses, or displacements alone.
void integrate_element(const Session& session, int b, int32_t element, const Points& points);
void integrate_displacements(const Session& session, int b, int32_t element, const Points& points);

// An element as a source of fields at points. With displacements, and if stresses are wanted, it also smooths the stress close
// to its nodes.
struct Acting {
  const Session* session;
  int b;
  int32_t element;
  ElementSmoothing* smoothing; // null: no smoothing
  FieldElement e;
};
// Without smoothing.
void add_element(Acting& acting, const Points& points);

} // namespace c2d
