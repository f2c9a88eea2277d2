#pragma once
// Stress close to a node. Tractions and slopes of displacement jump there from element to element by what the
// discretisation is off, and the integrals answer with a logarithm that the exact solution lacks. It is taken out at its
// root: on both elements a cubic is added that makes their tractions and slopes at the node those of one uniform
// state, the boundary's tensor there, and that vanishes with its slope at the elements' other ends. Where the state is
// uniform nothing is added. A step of the tractions, as at the end of a load, stays, with the jump of the slopes that
// goes with it at a straight boundary; so does the logarithm of a step of shear, which is real.
// The addition fades with the distance from the node and is none from half the shorter element on. It lies on the
// boundary, as the integrals do, so it does not matter what else is near the point.
#include "bie/integrals/interior.hpp"
#include "solver/session.hpp"

namespace c2d {

// What is added to one element for one of its ends (0, 1): coefficients of powers of eta, as in FieldElement; made when the
// first point is that near.
struct NodeSmoothing {
  bool ready;
  double range; // length unit
  Complex t[kElementNodes], u[kElementNodes];
};
struct ElementSmoothing {
  bool ready;
  NodeSmoothing end[2];
};

// Adds it for a point at (x, y), length unit, to the sums of `e`, the element with all of its own displacements.
void smooth_at_nodes(const Session& session, int b, int32_t element, const FieldElement& e, double x, double y,
                     ElementSmoothing& smoothing, PointField& sum);

} // namespace c2d
