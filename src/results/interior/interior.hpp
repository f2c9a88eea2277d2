#pragma once
// Results at interior points, and the state of the boundary between its nodes, for interior points and c2d_get. The boundary
// results must be current; body and element count from 0. All values are in the caller's units.
#include "bie/boundary_stress.hpp"
#include "model/geometry.hpp"
#include "solver/session.hpp"

namespace c2d {

// The element before (step -1) or after (1) in its region, double nodes skipped; at a line of symmetry its own image.
struct Neighbour {
  int32_t element;
  int image;
};
Neighbour region_neighbour(const Model& m, int b, int32_t element, int32_t step);

struct BoundaryState {
  double u[2], t[2], du_ds[2], n[2];
  double across; // strain across the plane: round the axis, else 0
};

// du_ds: from this element and the neighbours that join it smoothly.
BoundaryState boundary_state(const Session& session, int b, int32_t element, double eta);

// The state of the reflected boundary.
BoundaryState mirrored_state(const BoundaryState& s, int image);
// The state on the other side of the node at the end eta of an element whose own state there is s.
BoundaryState beyond(const Session& session, int b, const BoundaryState& s, const Neighbour& other, double eta);
// Is a node a corner sharp enough that its two tractions determine the stress tensor? s, t: states of both sides.
bool is_corner(const Session& session, const BoundaryState& s, const BoundaryState& t);

// Stress on an element; at its ends from both elements that meet there: from their tractions at a corner, else the mean.
PlaneStress joint_stress(const Session& session, int b, int32_t element, double eta);
// At a node, from the states on its two sides; image: line of symmetry across which the second is the image of the first, or 0.
PlaneStress joint_stress(const Session& session, int b, const BoundaryState& s, const BoundaryState& t, int image);
double stress_across(const Session& session, int b, const PlaneStress& s);

// field: C2D_END_SXX ... C2D_END_PRINCIPAL2; end = element * function_nodes + local.
double end_stress(const Session& session, int32_t field, int b, int32_t end);

// The arguments of c2d_interior.
struct PointsAsked {
  int32_t count;
  const double* xy;
  int64_t xy_stride;
  double* out;
  int64_t out_stride;
};
// Evaluates them in one body (from 1) or in any (0), including back substitution. Errors are recorded.
c2d_status evaluate_points(Session& session, int32_t body, const PointsAsked& asked);

// A point of the boundary of a deformable body.
struct BoundaryPlace {
  int32_t element;
  double eta;
};
// Limited by the stack.
constexpr int32_t kPlacesAtOnce = kSmallCode ? 1 : 24;
void interpolated_displacement(const Session& session, int b, const BoundaryPlace& at, double u[2]);
// Residual of the boundary equation, added to the interpolated displacement in METHOD (16.8): count <= kPlacesAtOnce vectors.
// The boundary results must be current. Errors are recorded: STORE_..., CANCELLED.
c2d_status off_interpolation(const Session& session, int b, int32_t count, const BoundaryPlace* at, double* out);

} // namespace c2d
