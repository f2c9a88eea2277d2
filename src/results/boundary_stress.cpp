// Stress tensor on the boundary (METHOD 16.2).
//
// Equation. The traction gives two components, t_n = s_nn and t_s = s_ns. The third follows from the strain along the boundary,
// e_ss = (du/ds).s, by Hooke's law in plane strain, METHOD (16.1): s_ss = 2G/(1 - nu) e_ss + nu/(1 - nu) s_nn.
// No boundary integral is evaluated: the stress integral is hypersingular there (Brebbia, Telles and Wrobel, Boundary Element
// Techniques, 1984, on stresses at boundary points).
//
// Phases for a point of the boundary:
//   1. Interpolate displacement and traction on its element.
//   2. Recover the slope du/ds. The derivative of the shape functions is one order less accurate than u, except at the Gauss
//      points, where it gains an order (Barlow, Int. J. Numer. Meth. Eng. 10, 1976). So slopes are sampled at the Gauss points
//      of the element and of neighbours that join smoothly, and interpolated in arc length by a polynomial.
//   3. Apply METHOD (16.1). At a node average both sides; at a corner the tractions of both sides determine the tensor.
#include "bie/boundary_stress.hpp"
#include "bie/columns.hpp"
#include "memory/math.hpp"
#include "model/shape.hpp"
#include "model/symmetry.hpp"
#include "quadrature/gauss.hpp"
#include "results/back.hpp"
#include "results/interior/interior.hpp"

namespace c2d {

Neighbour region_neighbour(const Model& m, int b, int32_t element, int32_t step) {
  const Region& region = m.region[b][region_of_element(m, b, element)];
  const double* end = m.xy[b] + 2 * geometry_node(m, b, element, step > 0 ? body_of(m, b).element_nodes - 1 : 0);
  const int lines = lines_through(*m.head, end[0], end[1]);
  if (lines != 0) return Neighbour{element, lines};
  const int32_t count = region.last - region.first + 1;
  const auto beside = [&](int32_t e) { return region.first + (e - region.first + step + count) % count; };
  const int32_t next = beside(element);
  return Neighbour{is_zero_length(m, b, next) ? beside(next) : next, 0}; // (no two of no length follow one another)
}

namespace {

constexpr double kSmooth = 0.985; // cosine of 10 degrees: a larger angle between normals is a kink
constexpr double kCorner = 0.5;   // sine of 30 degrees: from here on the two tractions determine the tensor well enough
constexpr double kStep = 0.05;    // of the tractions at a node: a larger difference is a real step of the load

// Not inlined, to limit the stack: elements and slopes are large, and none is needed while neighbours are examined.
[[gnu::noinline]] Point point_of(const Model& m, int b, int32_t element, double eta) {
  return element_point(element_of(m, b, element), eta);
}

// Arc length along an element between two of its points. Six Gauss points are exact to round-off for a straight element, where
// the Jacobian is constant, and converge fast on curved ones, where it is the root of a polynomial of degree four at most.
double arc_length(const Element& e, double from, double to) {
  const GaussRule rule = gauss_legendre(6);
  double sum = 0.0;
  for (int i = 0; i < rule.n; ++i) {
    const GaussPoint p = gauss_point(rule, i);
    sum += 0.5 * (to - from) * p.w * element_point(e, 0.5 * (from + to) + 0.5 * (to - from) * p.x).jacobian;
  }
  return sum;
}

// Is the slope du/ds continuous from the end of one element to the start of the next? A kink, a double node or a step of the
// traction makes it jump, and a polynomial across the jump would oscillate.
bool joins_smoothly(const Session& session, int b, int32_t element, int32_t next) {
  const Model& m = session.model;
  const int nf = m.head->function_nodes;
  const Point p = point_of(m, b, element, 1.0), q = point_of(m, b, next, -1.0);
  if (p.nx * q.nx + p.ny * q.ny < kSmooth ||
      geometry_node(m, b, element, m.body[b].element_nodes - 1) != geometry_node(m, b, next, 0))
    return false;
  double t[2], v[2];
  get_traction(session, b, element * nf + nf - 1, t);
  get_traction(session, b, next * nf, v);
  return hypot(t[0] - v[0], t[1] - v[1]) <= kStep * (hypot(t[0], t[1]) + hypot(v[0], v[1]));
}

// The same for the neighbour beyond either end, which may be the image across a line of symmetry. The image is smooth if the
// boundary meets the line at a right angle and the traction has no component that symmetry reverses.
bool joins_neighbour(const Session& session, int b, int32_t element, int32_t step, const Neighbour& other) {
  if (other.image == 0)
    return step > 0 ? joins_smoothly(session, b, element, other.element) : joins_smoothly(session, b, other.element, element);
  const int nf = session.model.head->function_nodes, l = step > 0 ? nf - 1 : 0;
  const Point p = point_of(session.model, b, element, step > 0 ? 1.0 : -1.0);
  const double n[2] = {p.nx, p.ny};
  double cosine = 0.0, jump[2], t[2];
  get_traction(session, b, element * nf + l, t);
  for (int c = 0; c < 2; ++c) {
    cosine += image_sign(other.image, c) * n[c] * n[c];
    jump[c] = t[c] - image_sign(other.image, c) * t[c];
  }
  return cosine >= kSmooth && hypot(jump[0], jump[1]) <= 2.0 * kStep * hypot(t[0], t[1]);
}

// Samples of du/ds at the Gauss points of elements, one fewer per element than functional nodes; s is the arc length from the
// point where the slope is wanted.
struct Slopes {
  int count;
  double *s, (*du_ds)[2];
};

// Adds the samples of one element, whose point `eta` lies at arc length s from the point where the slope is wanted.
void add_slopes(const Session& session, int b, int32_t element, double eta, double s, Slopes& out) {
  const Model& m = session.model;
  const int nf = m.head->function_nodes;
  const Element e = element_of(m, b, element);
  const GaussRule rule = gauss_legendre(nf - 1);
  for (int i = 0; i < rule.n; ++i) {
    const double at = gauss_point(rule, i).x, jacobian = element_point(e, at).jacobian;
    double slope[kElementNodes];
    shape_derivative(nf, at, slope);
    if (!(jacobian > 0.0)) continue;
    double* du_ds = out.du_ds[out.count];
    du_ds[0] = du_ds[1] = 0.0;
    for (int l = 0; l < nf; ++l) {
      double u[2];
      get_displacement(session, b, functional_node(m, b, element, l), u);
      for (int c = 0; c < 2; ++c) du_ds[c] += slope[l] * u[c] / jacobian;
    }
    out.s[out.count++] = s + arc_length(e, eta, at);
  }
}

// Adds the samples of the image of an element beyond its end at arc length `end`. Reflection changes the sign of one component
// of u and reverses the direction of travel, hence the second minus sign.
void add_mirrored_slopes(const Slopes& own, double end, int image, Slopes& out) {
  for (int i = own.count - 1; i >= 0; --i) {
    out.s[out.count] = 2.0 * end - own.s[i];
    for (int c = 0; c < 2; ++c) out.du_ds[out.count][c] = -image_sign(image, c) * own.du_ds[i][c];
    ++out.count;
  }
}

// Value at s = 0 of the Lagrange polynomial through the (at most four) samples nearest to it. More samples would raise the
// degree and amplify the error of distant ones.
void interpolate_slopes(const Slopes& x, double du_ds[2]) {
  int first = 0, count = x.count < 4 ? x.count : 4;
  while (first + count < x.count && x.s[first + count] < -x.s[first]) ++first;
  du_ds[0] = du_ds[1] = 0.0;
  for (int i = first; i < first + count; ++i) {
    double weight = 1.0;
    for (int j = first; j < first + count; ++j)
      if (j != i) weight *= x.s[j] / (x.s[j] - x.s[i]);
    for (int c = 0; c < 2; ++c) du_ds[c] += weight * x.du_ds[i][c];
  }
}

// Collects samples in the order of arc length - previous, own, next - and interpolates them. Room: three elements of at most
// three Gauss points.
[[gnu::noinline]] void slope_from(const Session& session, int b, int32_t element, double eta, const Neighbour* previous,
                                  const Neighbour* next, bool mirrored, double du_ds[2]) {
  const Model& m = session.model;
  const double before = arc_length(element_of(m, b, element), -1.0, eta),
               after = arc_length(element_of(m, b, element), eta, 1.0);
  double s[9], du[9][2], own_s[3], own_du[3][2];
  Slopes slopes = {0, s, du}, own = {0, own_s, own_du};
  if (mirrored) add_slopes(session, b, element, eta, 0.0, own);
  if (previous && previous->image != 0)
    add_mirrored_slopes(own, -before, previous->image, slopes);
  else if (previous)
    add_slopes(session, b, previous->element, 1.0, -before, slopes);
  add_slopes(session, b, element, eta, 0.0, slopes);
  if (next && next->image != 0)
    add_mirrored_slopes(own, after, next->image, slopes);
  else if (next)
    add_slopes(session, b, next->element, -1.0, after, slopes);
  interpolate_slopes(slopes, du_ds);
}

// The slope from this element and the neighbours that join it smoothly. On a closed curve of two elements both neighbours are
// the same element, which must not enter twice.
void recover_slope(const Session& session, int b, int32_t element, double eta, double du_ds[2]) {
  const Model& m = session.model;
  const Neighbour next = region_neighbour(m, b, element, 1), previous = region_neighbour(m, b, element, -1);
  const bool apart = previous.element != next.element || previous.image != next.image;
  const bool joined[2] = {apart && joins_neighbour(session, b, element, -1, previous),
                          apart && joins_neighbour(session, b, element, 1, next)};
  slope_from(session, b, element, eta, joined[0] ? &previous : nullptr, joined[1] ? &next : nullptr,
             previous.image != 0 || next.image != 0, du_ds);
}

Point mirrored_middle(const Session& session, int b, const Neighbour& other) {
  Point p = point_of(session.model, b, other.element, 0.0);
  p.x = mirrored(*session.model.head, other.image, 0, p.x);
  p.y = mirrored(*session.model.head, other.image, 1, p.y);
  return p;
}

[[gnu::noinline]] void slope_between(const Session& session, int b, int32_t element, const Neighbour& previous,
                                     const Neighbour& next, double du_ds[2]) {
  const Model& m = session.model;
  const Point at = point_of(m, b, element, 0.0), after = mirrored_middle(session, b, next),
              before = mirrored_middle(session, b, previous);
  const double run = hypot(after.x - at.x, after.y - at.y) + hypot(at.x - before.x, at.y - before.y);
  double u[2], v[2];
  get_displacement(session, b, functional_node(m, b, next.element, 0), u);
  get_displacement(session, b, functional_node(m, b, previous.element, 0), v);
  for (int c = 0; c < 2; ++c)
    du_ds[c] = run > 0.0 ? (image_sign(next.image, c) * u[c] - image_sign(previous.image, c) * v[c]) / run : 0.0;
}

// Constant elements: u has no derivative on the element. The slope is the difference quotient between the neighbours, along the
// chords between the three middle nodes; where a neighbour does not join smoothly the element itself takes its place, and the
// difference is one-sided. Two functions, because the stack is deepest while joining elements are found.
[[gnu::noinline]] void slope_of_neighbours(const Session& session, int b, int32_t element, double du_ds[2]) {
  const Model& m = session.model;
  Neighbour next = region_neighbour(m, b, element, 1), previous = region_neighbour(m, b, element, -1);
  if (!joins_neighbour(session, b, element, 1, next)) next = Neighbour{element, 0};
  if (!joins_neighbour(session, b, element, -1, previous)) previous = Neighbour{element, 0};
  slope_between(session, b, element, previous, next, du_ds);
}

} // namespace

bool is_corner(const Session& session, const BoundaryState& s, const BoundaryState& t) {
  return fabs(s.n[0] * t.n[1] - s.n[1] * t.n[0]) > kCorner && session.model.head->function_nodes > 1;
}

BoundaryState boundary_state(const Session& session, int b, int32_t element, double eta) {
  const Model& m = session.model;
  const int nf = m.head->function_nodes;
  const Point p = point_of(m, b, element, eta);
  double value[kElementNodes];
  shape(nf, eta, value);
  BoundaryState s = {{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}, {p.nx, p.ny}, 0.0};
  for (int l = 0; l < nf; ++l) {
    double u[2], t[2];
    get_displacement(session, b, functional_node(m, b, element, l), u);
    get_traction(session, b, element * nf + l, t);
    for (int c = 0; c < 2; ++c) {
      s.u[c] += value[l] * u[c];
      s.t[c] += value[l] * t[c];
    }
  }
  if (nf == 1)
    slope_of_neighbours(session, b, element, s.du_ds);
  else
    recover_slope(session, b, element, eta, s.du_ds);
  if (is_axisymmetric(m)) s.across = p.x > 0.0 ? s.u[0] / p.x : s.du_ds[1] * p.nx - s.du_ds[0] * p.ny; // on the axis e_rr
  return s;
}

BoundaryState beyond(const Session& session, int b, const BoundaryState& s, const Neighbour& other, double eta) {
  return other.image != 0 ? mirrored_state(s, other.image) : boundary_state(session, b, other.element, -eta);
}

namespace {

PlaneStress stress_of(const Session& session, int b, const BoundaryState& s, double* hoop) {
  return boundary_stress(s.n, s.t, s.du_ds, s.across, shear_modulus(session.model, b), strain_poisson_ratio(session.model, b),
                         hoop);
}

// Tensor at a corner from the tractions of its two sides, without any slope. With n_i the normals, t_i = sigma n_i and the
// reciprocal vectors m_i (m_i.n_j = 1 for i = j, else 0): sigma = sum s_ij m_i m_j, s_ij = n_i.t_j. A symmetric tensor
// requires s_12 = s_21; the two tractions give both values and their mean is used.
PlaneStress corner_stress(const BoundaryState& a, const BoundaryState& c) {
  const double cross = a.n[0] * c.n[1] - a.n[1] * c.n[0];
  const double m1[2] = {c.n[1] / cross, -c.n[0] / cross}, m2[2] = {-a.n[1] / cross, a.n[0] / cross};
  const double s11 = a.n[0] * a.t[0] + a.n[1] * a.t[1], s22 = c.n[0] * c.t[0] + c.n[1] * c.t[1];
  const double s12 = 0.5 * (a.n[0] * c.t[0] + a.n[1] * c.t[1] + c.n[0] * a.t[0] + c.n[1] * a.t[1]);
  return {s11 * m1[0] * m1[0] + 2.0 * s12 * m1[0] * m2[0] + s22 * m2[0] * m2[0],
          s11 * m1[1] * m1[1] + 2.0 * s12 * m1[1] * m2[1] + s22 * m2[1] * m2[1],
          s11 * m1[0] * m1[1] + s12 * (m1[0] * m2[1] + m1[1] * m2[0]) + s22 * m2[0] * m2[1]};
}

} // namespace

double stress_across(const Session& session, int b, const PlaneStress& s) {
  const ModelHeader& head = *session.model.head;
  return stress_across(s, head.plane != C2D_PLANE_STRESS, session.model.body[b].poisson_ratio);
}

BoundaryState mirrored_state(const BoundaryState& s, int image) {
  BoundaryState out = s;
  for (int c = 0; c < 2; ++c) {
    out.u[c] *= image_sign(image, c);
    out.t[c] *= image_sign(image, c);
    out.n[c] *= image_sign(image, c);
    out.du_ds[c] *= -image_sign(image, c); // the direction of travel is reversed as well
  }
  return out;
}

PlaneStress joint_stress(const Session& session, int b, const BoundaryState& s, const BoundaryState& t, int image) {
  double hoop;
  if (is_corner(session, s, t)) return corner_stress(s, t);
  const PlaneStress here = stress_of(session, b, s, &hoop);
  if (image != 0) return {here.xx, here.yy, 0.0}; // shear stress vanishes on a line of symmetry
  const PlaneStress there = stress_of(session, b, t, &hoop);
  return {0.5 * (here.xx + there.xx), 0.5 * (here.yy + there.yy), 0.5 * (here.xy + there.xy)};
}

PlaneStress joint_stress(const Session& session, int b, int32_t element, double eta) {
  if (is_rigid(session.model, b)) return {0.0, 0.0, 0.0}; // the stress of a rigid body is undefined
  const BoundaryState s = boundary_state(session, b, element, eta);
  double hoop;
  if (fabs(eta) < 1.0) return stress_of(session, b, s, &hoop);
  const Neighbour other = region_neighbour(session.model, b, element, eta < 0.0 ? -1 : 1);
  return joint_stress(session, b, s, beyond(session, b, s, other, eta), other.image);
}

double end_stress(const Session& session, int32_t field, int b, int32_t end) {
  const int32_t nf = session.model.head->function_nodes;
  if (is_rigid(session.model, b)) return 0.0;
  double hoop;
  const BoundaryState at = boundary_state(session, b, end / nf, node_eta(nf, end % nf));
  const PlaneStress s = stress_of(session, b, at, &hoop);
  const double szz = stress_across(session, b, s) + body_of(session.model, b).youngs_modulus * at.across;
  switch (field) {
  case C2D_END_SXX: return s.xx;
  case C2D_END_SYY: return s.yy;
  case C2D_END_SXY: return s.xy;
  case C2D_END_SZZ: return szz;
  case C2D_END_VON_MISES: return von_mises(s, szz);
  case C2D_END_MAX_SHEAR: return largest_shear(s);
  case C2D_END_PRINCIPAL1: return 0.5 * (s.xx + s.yy) + largest_shear(s);
  case C2D_END_PRINCIPAL2: return 0.5 * (s.xx + s.yy) - largest_shear(s);
  default: return hoop;
  }
}

} // namespace c2d
