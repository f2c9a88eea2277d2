#pragma once
// Stress close to a node. Tractions and displacement slopes jump there by the discretisation error, which gives the integrals a
// logarithmic singularity that the exact solution has not. The correction acts at its cause: on both elements a cubic is added
// that moves tractions and slopes at the node to those of one uniform state, the stress tensor of the boundary, and vanishes
// with its slope at the other ends. For a uniform state the correction is zero. A real step of the tractions, as at the end of
// a load, stays, with the jump of slope that belongs to it at a straight boundary; so does the logarithm of a step of shear.
// The correction fades with the distance from the node and is zero beyond half the shorter element. It is a boundary density
// like the others, so other boundaries near the point do not matter.
#include "bie/integrals/interior.hpp"
#include "solver/session.hpp"

namespace c2d {

// Correction of one element for one of its ends (0, 1): coefficients of powers of eta, as in FieldElement; computed for the
// first point in range.
struct NodeSmoothing {
  bool ready;
  double range; // length unit
  Complex t[kElementNodes], u[kElementNodes];
};
struct ElementSmoothing {
  bool ready;
  NodeSmoothing end[2];
};

// Adds the corrections at a point (x, y), in the length unit, to the sums of `e`, the element with all its own displacements.
void smooth_at_nodes(const Session& session, int b, int32_t element, const FieldElement& e, double x, double y,
                     ElementSmoothing& smoothing, PointField& sum);

} // namespace c2d
