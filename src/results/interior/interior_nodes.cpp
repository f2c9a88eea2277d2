// Smoothed stress at interior points close to a node (METHOD 16.3).
//
// Tractions and slopes of the discrete solution jump at a node by the discretisation error. The stress integrals of such a jump
// grow like ln r towards the node, although the exact stress is bounded.
// Phases, per node and only when a point is near:
//   1. find_joint: the states on both sides, one uniform stress tensor for the node (results/boundary_stress.cpp), the mean
//      rotation, and real steps of traction, which must stay.
//   2. smooth_joint: cubics in eta for both elements. At the node they change traction and slope to those of the uniform state;
//      at the far end they vanish with their slope.
//   3. smoothing_at: the field of these cubics at the point; it is added with a weight that falls from 1 at the node to 0 at
//   half
//      the shorter element, so that the stress stays continuous.
// A uniform state is already exact, so the correction is zero there. A real step of pressure changes the slope at a straight
// boundary by (1 - 2 nu)/(2G) times the step; a real step of shear has a logarithm also in the exact solution (Johnson, Contact
// Mechanics, chapter 2, on uniform tangential tractions).
#include "results/interior/interior_nodes.hpp"

#include "bie/body_force.hpp"
#include "bie/boundary_stress.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "model/symmetry.hpp"
#include "results/interior/interior.hpp"
#include "solver/particular.hpp"

namespace c2d {

C2D_USES(BodyForcePart);

namespace {

constexpr double kRange = 0.5; // range of the smoothing, over the length of the shorter element at the node

constexpr double kStep = 0.05;       // of the tractions: a larger jump is a real step of the load
constexpr double kCornerStep = 0.25; // at a corner, for the two values of its shear stress

double size_of(Complex v) { return hypot(v.re, v.im); }
Complex complex_of(const double v[2]) { return {v[0], v[1]}; }

// The two sides of a node and the uniform state to which both are moved.
struct Joint {
  BoundaryState side[2]; // before and after the node
  bool corner;
  PlaneStress stress;
  double rotation;
  double across() const { return 0.5 * (side[0].across + side[1].across); } // strain round the axis
  Complex apart[2]; // real steps: tractions of the sides minus those of the uniform state
};

Complex traction_of(const PlaneStress& s, const double n[2]) { return {s.xx * n[0] + s.xy * n[1], s.xy * n[0] + s.yy * n[1]}; }

// du/ds along the boundary in a uniform stress state without rotation, by Hooke's law: (sigma s - nu tr(sigma) s)/(2G), less nu
// times the strain across the plane.
Complex stretch(const Session& session, int b, const PlaneStress& s, double across, const double n[2]) {
  const double along[2] = {-n[1], n[0]}, g = shear_modulus(session.model, b);
  const double nu = strain_poisson_ratio(session.model, b), mean = nu * (s.xx + s.yy);
  if (is_axisymmetric(session.model))
    return (0.5 / g) * (traction_of(s, along) - (mean + 2.0 * g * nu * across) * complex_of(along));
  return (0.5 / g) * (traction_of(s, along) - mean * complex_of(along));
}

// Is the jump of tractions real? They are compared in the frames of their elements: along a polygon that approximates a curve
// a constant pressure turns with the sides, which is not a step.
bool tractions_step(const Joint& j) {
  Complex t[2];
  for (int k = 0; k < 2; ++k) t[k] = complex_of(j.side[k].t) * conj(complex_of(j.side[k].n));
  const double size = size_of(t[0]) + size_of(t[1]);
  return j.corner ? size_of(j.apart[0]) + size_of(j.apart[1]) > kCornerStep * size : size_of(t[0] - t[1]) > kStep * size;
}

// Not inlined, like smooth_joint: this function calls deeply, the other has a large frame, and the two must not add up.
[[gnu::noinline]] void find_joint(const Session& session, int b, int32_t element, int end, const Neighbour& other, Joint& j) {
  const double eta = end == 0 ? -1.0 : 1.0;
  j.side[1 - end] = boundary_state(session, b, element, eta);
  j.side[end] = beyond(session, b, j.side[1 - end], other, eta);
  const BoundaryState &before = j.side[0], &behind = j.side[1];
  j.stress = joint_stress(session, b, j.side[1 - end], j.side[end], other.image);
  j.corner = is_corner(session, before, behind);
  j.rotation = 0.0;
  // A rotation omega adds omega times the tangent turned by 90 degrees, which is minus the normal. Mean of both sides.
  for (const BoundaryState& s : j.side)
    j.rotation -= 0.5 * dot(complex_of(s.du_ds) - stretch(session, b, j.stress, j.across(), s.n), complex_of(s.n));
  for (int k = 0; k < 2; ++k) j.apart[k] = complex_of(j.side[k].t) - traction_of(j.stress, j.side[k].n);
  const Complex half = 0.5 * (j.apart[0] - j.apart[1]);
  if (!tractions_step(j))
    j.apart[0] = j.apart[1] = Complex{0.0, 0.0};
  else if (!j.corner)
    j.apart[0] = half, j.apart[1] = -1.0 * half;
}

// Displacement at the node, extrapolated along the slopes from the middle nodes of constant elements; mean of both sides.
Complex value_at_node(const Joint& j, const Complex slope[2], double before, double behind) {
  return 0.5 * (complex_of(j.side[0].u) + before * slope[0] + complex_of(j.side[1].u) - behind * slope[1]);
}

// Particular displacement u_p of the body forces at the distance `part` (in length units) from a point along the element.
Complex particular_at(const Session& session, int b, const double at[2], const double n[2], double part) {
  const double h = part * session.model.head->length_unit, place[2] = {at[0] - h * n[1], at[1] + h * n[0]};
  double u[2] = {0.0, 0.0}, stress[3] = {0.0, 0.0, 0.0};
  kBodyForcePart.add_particular_at(session, b, place, u, stress);
  return complex_of(u);
}

// `next`: half length of the element beyond the node, length unit.
[[gnu::noinline]] void smooth_joint(const Session& session, int b, const FieldElement& e, int end, double next, const Joint& j,
                                    NodeSmoothing& out) {
  const Model& m = session.model;
  const Element& shape = e.in.element;
  const int last = end == 0 ? 0 : shape.nodes - 1;
  const double unit = m.head->length_unit, own = shape.half_length;
  const double g2 = 2.0 * shear_modulus(m, b), nu = strain_poisson_ratio(m, b);
  Complex slope[2];
  for (int k = 0; k < 2; ++k) { // at a straight boundary a step of pressure causes a stretch, a step of shear a rotation
    const double* n = j.side[k].n;
    const double share = j.corner ? 0.0 : (1.0 - 2.0 * nu) / g2;
    slope[k] = stretch(session, b, j.stress, j.across(), n) - j.rotation * complex_of(n) +
               share * Complex{-j.apart[k].im, j.apart[k].re};
  }
  const BoundaryState& here = j.side[1 - end];
  const Complex traction = traction_of(j.stress, here.n) + j.apart[1 - end] - complex_of(here.t);
  Complex value = (1.0 / unit) * value_at_node(j, slope, unit * (end == 0 ? next : own), unit * (end == 0 ? own : next));
  Complex along = slope[1 - end];
  // The integrals represent u - u_p. u_p is a polynomial of the third degree, and its slope by a central difference over a
  // small interval is exact to 1e-8.
  if (has_body_force(m, b)) {
    constexpr double kPart = 1e-4;
    const double at[2] = {unit * shape.x[last], unit * shape.y[last]};
    const Complex rise = particular_at(session, b, at, here.n, kPart) - particular_at(session, b, at, here.n, -kPart);
    value = value - particular_at(session, b, at, here.n, 0.0);
    along = along - (0.5 / kPart) * rise;
  }

  // The correction is the wanted value and slope minus those of the polynomial of the element.
  const double eta = end == 0 ? -1.0 : 1.0, jacobian = element_point(shape, eta).jacobian;
  Complex have = {0.0, 0.0};
  double power = 1.0;
  for (int k = 1; k < e.in.functions; ++k, power *= eta) add(have, (k * power) * e.u[k]);
  const Complex turned = conj(e.axis), rise = jacobian * (along * turned) - have;
  const Complex start = e.in.functions == 1 ? value * turned - e.u[0] : Complex{0.0, 0.0};
  const Complex force = (1.0 / g2) * (traction * turned);
  // (2 + 3 x - x^3)/4 is 1 at x = 1 and flat there and at -1; (1 + x)^2 (x - 1)/4 rises by 1 there.
  const double flat[4] = {0.5, 0.75 * eta, 0.0, -0.25 * eta}, steep[4] = {-0.25 * eta, -0.25, 0.25 * eta, 0.25};
  for (int k = 0; k < 4; ++k) {
    out.t[k] = flat[k] * force;
    out.u[k] = flat[k] * start + steep[k] * rise;
  }
}

[[gnu::noinline]] double half_length_of(const Model& m, int b, int32_t element) {
  return element_of(m, b, element).half_length / m.head->length_unit;
}

void prepare_smoothing(const Session& session, int b, int32_t element, const FieldElement& e, int end, NodeSmoothing& out) {
  const Neighbour other = region_neighbour(session.model, b, element, end == 0 ? -1 : 1);
  const double own = e.in.element.half_length, next = half_length_of(session.model, b, other.element);
  out.ready = true;
  out.range = 2.0 * kRange * (own < next ? own : next);
  Joint j;
  find_joint(session, b, element, end, other, j);
  smooth_joint(session, b, e, end, next, j, out);
}

// Field of the correction at a point. Not inlined: the copy of the element must not add to the frames that make the correction.
[[gnu::noinline]] PointField smoothing_at(const FieldElement& e, const NodeSmoothing& node, double x, double y) {
  FieldElement field = e;
  field.in.functions = 4;
  field.displaced = true;
  for (int k = 0; k < 4; ++k) {
    field.t[k] = node.t[k];
    field.u[k] = node.u[k];
  }
  PointField added = {};
  add_field(field, Complex{0.0, 0.0}, x, y, added);
  return added;
}

} // namespace

void smooth_at_nodes(const Session& session, int b, int32_t element, const FieldElement& e, double x, double y,
                     ElementSmoothing& smoothing, PointField& sum) {
  const Element& shape = e.in.element;
  for (int end = 0; end < 2; ++end) {
    const int last = end == 0 ? 0 : shape.nodes - 1;
    const double dx = x - shape.x[last], dy = y - shape.y[last], square = dx * dx + dy * dy;
    NodeSmoothing& node = smoothing.end[end];
    const double reach = 2.0 * kRange * shape.half_length;
    if (square >= reach * reach) continue;
    // Corrections are made on first use: most elements have no interior point close to a node.
    if (!smoothing.ready) smoothing.end[0].ready = smoothing.end[1].ready = false;
    smoothing.ready = true;
    if (!node.ready) prepare_smoothing(session, b, element, e, end, node);
    const double range2 = node.range * node.range;
    if (square >= range2) continue;
    const PointField added = smoothing_at(e, node, x, y);
    const double part = square / range2, weight = (1.0 - part) * (1.0 - part);
    sum.trace += weight * added.trace;
    add(sum.deviator, weight * added.deviator);
    add_round(sum, weight * added.round);
  }
}

} // namespace c2d
