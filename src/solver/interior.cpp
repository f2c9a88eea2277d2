// Interior points (3.32)-(3.34) and the stress tensor of the boundary.
#include "solver/interior.hpp"

#include <math.h>
#include <string.h>

#include "bie/boundary_stress.hpp"
#include "bie/columns.hpp"
#include "bie/interior_detail.hpp"
#include "bie/shape.hpp"
#include "quadrature/gauss.hpp"

namespace c2d {

namespace {

constexpr double kOnBoundary = 1e-9; // of the element's length
constexpr double kNearNode = 0.1;    // of the shorter element that meets there
constexpr double kSmooth = 0.985;    // cosine of 10 degrees: less is a kink
constexpr double kCorner = 0.5;      // sine of 30 degrees: from there on two tractions make a tensor
constexpr double kStep = 0.05;       // of the tractions at a node: more is a step

double length_of(double x, double y) { return sqrt(x * x + y * y); }

// ---- the boundary's own stress ------------------------------------------------------------------------------------

int32_t region_neighbour(const Model& m, int b, int32_t element, int32_t step) {
  const Region& region = m.region[b][region_of_element(m, b, element)];
  const int32_t count = region.last - region.first + 1;
  int32_t other = element;
  do other = region.first + (other - region.first + step + count) % count;
  while (other != element && is_zero_length(m, b, other));
  return other;
}

Element element_of(const Model& m, int b, int32_t element) {
  double x[4], y[4];
  element_coordinates(m, b, element, x, y);
  return make_element(m.head->body[b].element_nodes, x, y);
}

// From the middle to eta.
double arc_length(const Element& e, double eta) {
  const GaussRule rule = gauss_legendre(6);
  double sum = 0.0;
  for (int i = 0; i < rule.n; ++i) {
    const GaussPoint p = gauss_point(rule, i);
    sum += 0.5 * eta * p.w * element_point(e, 0.5 * eta * (1.0 + p.x)).jacobian;
  }
  return sum;
}

struct BoundaryState {
  double u[2], t[2], du_ds[2], n[2];
};

// Nothing jumps between the end of one element and the start of the next: no kink, double node or step of traction.
bool joins_smoothly(const Session& session, int b, int32_t element, int32_t next) {
  const Model& m = session.model;
  const int nf = m.head->function_nodes;
  const Point p = element_point(element_of(m, b, element), 1.0), q = element_point(element_of(m, b, next), -1.0);
  if (p.nx * q.nx + p.ny * q.ny < kSmooth || geometry_node(m, b, element, m.head->body[b].element_nodes - 1) !=
                                                 geometry_node(m, b, next, 0))
    return false;
  const double* t = session.area.traction[b] + 2 * (static_cast<int64_t>(element) * nf + nf - 1);
  const double* v = session.area.traction[b] + 2 * (static_cast<int64_t>(next) * nf);
  return length_of(t[0] - v[0], t[1] - v[1]) <= kStep * (length_of(t[0], t[1]) + length_of(v[0], v[1]));
}

// Derivatives of displacement by arc length where they are most accurate: the Gauss points of an element, one fewer than
// functional nodes. Constant elements have their value in the middle, and differences in place of derivatives.
struct Slopes {
  int count;
  double s[9], du_ds[9][2];
};

// Those of one element, with `start` the arc length of its middle less that of the point sought.
void add_slopes(const Session& session, int b, int32_t element, double start, Slopes& out) {
  const Model& m = session.model;
  const int nf = m.head->function_nodes;
  const Element e = element_of(m, b, element);
  const GaussRule rule = gauss_legendre(nf - 1);
  for (int i = 0; i < rule.n; ++i) {
    const double eta = gauss_point(rule, i).x;
    const Point p = element_point(e, eta);
    double slope[4];
    shape_derivative(nf, eta, slope);
    if (!(p.jacobian > 0.0)) continue;
    double* du_ds = out.du_ds[out.count];
    du_ds[0] = du_ds[1] = 0.0;
    for (int l = 0; l < nf; ++l) {
      const double* u = session.area.displacement[b] + 2 * static_cast<int64_t>(functional_node(m, b, element, l));
      for (int c = 0; c < 2; ++c) du_ds[c] += slope[l] * u[c] / p.jacobian;
    }
    out.s[out.count++] = start + arc_length(e, eta);
  }
}

// The polynomial through the (at most four) samples nearest to s = 0, there.
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

// From this element and the neighbours that join it smoothly.
void recover_slope(const Session& session, int b, int32_t element, double eta, double du_ds[2]) {
  const Model& m = session.model;
  const int32_t next = region_neighbour(m, b, element, 1), previous = region_neighbour(m, b, element, -1);
  const Element e = element_of(m, b, element);
  const double here = -arc_length(e, eta);
  Slopes slopes = {};
  if (previous != next && joins_smoothly(session, b, previous, element)) {
    const Element p = element_of(m, b, previous);
    add_slopes(session, b, previous, here + arc_length(e, -1.0) - arc_length(p, 1.0), slopes);
  }
  add_slopes(session, b, element, here, slopes);
  if (previous != next && joins_smoothly(session, b, element, next)) {
    const Element n = element_of(m, b, next);
    add_slopes(session, b, next, here + arc_length(e, 1.0) - arc_length(n, -1.0), slopes);
  }
  interpolate_slopes(slopes, du_ds);
}

// Constant elements tell nothing of slopes: difference of the neighbours, along the chords between the three middles.
void slope_of_neighbours(const Session& session, int b, int32_t element, double du_ds[2]) {
  const Model& m = session.model;
  int32_t next = region_neighbour(m, b, element, 1), previous = region_neighbour(m, b, element, -1);
  if (!joins_smoothly(session, b, element, next)) next = element;
  if (!joins_smoothly(session, b, previous, element)) previous = element;
  const Point at = element_point(element_of(m, b, element), 0.0), after = element_point(element_of(m, b, next), 0.0),
              before = element_point(element_of(m, b, previous), 0.0);
  const double run = length_of(after.x - at.x, after.y - at.y) + length_of(at.x - before.x, at.y - before.y);
  const double* u = session.area.displacement[b] + 2 * static_cast<int64_t>(functional_node(m, b, next, 0));
  const double* v = session.area.displacement[b] + 2 * static_cast<int64_t>(functional_node(m, b, previous, 0));
  for (int c = 0; c < 2; ++c) du_ds[c] = run > 0.0 ? (u[c] - v[c]) / run : 0.0;
}

BoundaryState boundary_state(const Session& session, int b, int32_t element, double eta) {
  const Model& m = session.model;
  const int nf = m.head->function_nodes;
  const Point p = element_point(element_of(m, b, element), eta);
  double value[4];
  shape(nf, eta, value);
  BoundaryState s = {{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}, {p.nx, p.ny}};
  for (int l = 0; l < nf; ++l) {
    const double* u = session.area.displacement[b] + 2 * static_cast<int64_t>(functional_node(m, b, element, l));
    const double* t = session.area.traction[b] + 2 * (static_cast<int64_t>(element) * nf + l);
    for (int c = 0; c < 2; ++c) {
      s.u[c] += value[l] * u[c];
      s.t[c] += value[l] * t[c];
    }
  }
  if (nf == 1) slope_of_neighbours(session, b, element, s.du_ds);
  else recover_slope(session, b, element, eta, s.du_ds);
  return s;
}

PlaneStress stress_at(const Session& session, int b, int32_t element, double eta, double* hoop) {
  const BoundaryState s = boundary_state(session, b, element, eta);
  const Model& m = session.model;
  return boundary_stress(s.n, s.t, s.du_ds, shear_modulus(m, b), strain_poisson_ratio(m, b), hoop);
}

double across(const Session& session, int b, const PlaneStress& s) {
  const ModelHeader& head = *session.model.head;
  return stress_across(s, head.plane == C2D_PLANE_STRAIN, head.body[b].poisson_ratio);
}

// Two sides of a corner: with s_ij = n_i.sigma n_j and the reciprocal vectors m_i, sigma = sum s_ij m_i m_j.
PlaneStress corner_stress(const BoundaryState& a, const BoundaryState& c) {
  const double cross = a.n[0] * c.n[1] - a.n[1] * c.n[0];
  const double m1[2] = {c.n[1] / cross, -c.n[0] / cross}, m2[2] = {-a.n[1] / cross, a.n[0] / cross};
  const double s11 = a.n[0] * a.t[0] + a.n[1] * a.t[1], s22 = c.n[0] * c.t[0] + c.n[1] * c.t[1];
  const double s12 = 0.5 * (a.n[0] * c.t[0] + a.n[1] * c.t[1] + c.n[0] * a.t[0] + c.n[1] * a.t[1]);
  return {s11 * m1[0] * m1[0] + 2.0 * s12 * m1[0] * m2[0] + s22 * m2[0] * m2[0],
          s11 * m1[1] * m1[1] + 2.0 * s12 * m1[1] * m2[1] + s22 * m2[1] * m2[1],
          s11 * m1[0] * m1[1] + s12 * (m1[0] * m2[1] + m1[1] * m2[0]) + s22 * m2[0] * m2[1]};
}

// On an element; at its ends from both elements that meet there: from their tractions at a corner, else the mean.
PlaneStress joint_stress(const Session& session, int b, int32_t element, double eta) {
  double hoop;
  const PlaneStress here = stress_at(session, b, element, eta, &hoop);
  if (fabs(eta) < 1.0) return here;
  const int32_t other = region_neighbour(session.model, b, element, eta < 0.0 ? -1 : 1);
  const BoundaryState s = boundary_state(session, b, element, eta), t = boundary_state(session, b, other, -eta);
  if (fabs(s.n[0] * t.n[1] - s.n[1] * t.n[0]) > kCorner && session.model.head->function_nodes > 1)
    return corner_stress(s, t);
  const PlaneStress there = stress_at(session, b, other, -eta, &hoop);
  return {0.5 * (here.xx + there.xx), 0.5 * (here.yy + there.yy), 0.5 * (here.xy + there.xy)};
}

// ---- points under way ---------------------------------------------------------------------------------------------

// What is known of a point until its results are complete, kept in its row of the caller's answer.
struct PointState {
  double u[2], stress[3];    // sums: trace, deviator
  double reference[2];       // displacement of the nearest boundary point; before that [0] counts windings
  double element;            // with the nearest boundary point
  double eta, distance;      // of that point; once placed inside: x, y at which the stress is taken
  double place;              // kUnplaced, or 4 * (body + 1) + flag
};
static_assert(sizeof(PointState) == C2D_POINT_FIELDS * sizeof(double), "fills a row of the answer");
constexpr double kUnplaced = 0.0;

struct Points {
  int32_t count;
  const double* xy;
  int64_t xy_stride;
  double* out;
  int64_t out_stride;
  double unit;

  PointState& state(int32_t i) const { return *reinterpret_cast<PointState*>(out + i * out_stride); }
  double x(int32_t i) const { return xy[i * xy_stride] / unit; }
  double y(int32_t i) const { return xy[i * xy_stride + 1] / unit; }
};

double place_of(int b, int32_t flag) { return 4 * (b + 1) + flag; }
bool is_near_node(const PointState& p, int b) { return p.place == place_of(b, C2D_POINT_NEAR_NODE); }
bool is_inside(const PointState& p, int b) {
  return p.place == place_of(b, C2D_POINT_INSIDE) || is_near_node(p, b);
}

c2d_status pause(const Session& session, int b, int32_t element) {
  c2d_solver* s = session.solver;
  tell_progress(s, C2D_PHASE_BACK, b + 1, element, s->model.body[b].elements);
  return asked_to_stop(s) ? fail(s, C2D_ERR_CANCELLED, "cancelled while computing interior points") : C2D_OK;
}

// Nearest boundary point and winding number of the points not yet placed, from one element.
void look_at_element(const Integrator& in, int b, int32_t element, const Points& points) {
  const Element& e = in.element;
  for (int32_t i = 0; i < points.count; ++i) {
    PointState& p = points.state(i);
    if (p.place != kUnplaced) continue;
    const double x = points.x(i), y = points.y(i);
    if (length_of(x - e.c[0][0], y - e.c[0][1]) - in.radius <= p.distance) {
      const Nearest near = nearest_point(e, x, y);
      if (near.distance < p.distance) {
        p.distance = near.distance;
        p.element = element;
        p.eta = near.eta;
      }
      if (near.distance <= 2.0 * kOnBoundary * in.radius) p.place = place_of(b, C2D_POINT_BOUNDARY);
    }
    if (p.place == kUnplaced) p.reference[0] += winding(in, x, y);
  }
}

// Close to a node, where tractions and slopes of displacement jump from element to element, the integrals have a
// logarithm that the exact solution lacks. Their stress is then taken farther away, at a point that lies to the boundary
// as this one does, `part` times farther from the node, and joined to the boundary's tensor at the node.
struct NearNode {
  int end;      // 0: first, else last node of the element
  double part;  // distance from the node over the range, < 1
};

bool find_near_node(const Model& m, int b, const PointState& p, double x, double y, NearNode& out) {
  const int32_t element = static_cast<int32_t>(p.element);
  const Element e = element_of(m, b, element);
  const double unit = m.head->length_unit;
  const int last = e.nodes - 1;
  const double first_distance = length_of(unit * x - e.x[0], unit * y - e.y[0]),
               last_distance = length_of(unit * x - e.x[last], unit * y - e.y[last]);
  out.end = first_distance <= last_distance ? 0 : 1;
  const Element other = element_of(m, b, region_neighbour(m, b, element, out.end == 0 ? -1 : 1));
  const double length = 2.0 * (e.half_length < other.half_length ? e.half_length : other.half_length);
  const double distance = out.end == 0 ? first_distance : last_distance, range = kNearNode * length;
  out.part = range > 0.0 ? distance / range : 1.0;
  return out.part < 1.0;
}

void place_inside(const Session& session, int b, double x, double y, PointState& p) {
  const Model& m = session.model;
  const int32_t element = static_cast<int32_t>(p.element);
  const double unit = m.head->length_unit, eta = p.eta;
  const BoundaryState s = boundary_state(session, b, element, eta);
  for (int c = 0; c < 2; ++c) p.reference[c] = s.u[c] / unit;
  p.place = place_of(b, C2D_POINT_INSIDE);
  NearNode near;
  if (find_near_node(m, b, p, x, y, near)) {
    const Element e = element_of(m, b, element);
    const double node = near.end == 0 ? -1.0 : 1.0;
    const Point foot = element_point(e, eta), moved = element_point(e, node + (eta - node) / near.part);
    x = moved.x / unit + (x - foot.x / unit) / near.part;
    y = moved.y / unit + (y - foot.y / unit) / near.part;
    p.place = place_of(b, C2D_POINT_NEAR_NODE);
    p.element = 2.0 * element + near.end;
  }
  p.eta = x;
  p.distance = y;
}

c2d_status place_points(const Session& session, int b, const Points& points) {
  const Model& m = session.model;
  for (int32_t i = 0; i < points.count; ++i) {
    PointState& p = points.state(i);
    if (p.place != kUnplaced) continue;
    p = PointState{};
    p.distance = 1e300;
  }
  for (int32_t element = 0; element < m.head->body[b].elements; ++element) {
    if (is_zero_length(m, b, element)) continue;
    const c2d_status status = pause(session, b, element);
    if (status != C2D_OK) return status;
    Integrator in;
    make_integrator(m, b, element, Quadrature::accurate, Measure::own_length, in);
    look_at_element(in, b, element, points);
  }
  for (int32_t i = 0; i < points.count; ++i) {
    PointState& p = points.state(i);
    if (p.place == kUnplaced && p.reference[0] > 0.5) place_inside(session, b, points.x(i), points.y(i), p);
  }
  return C2D_OK;
}

// ---- the integrals ------------------------------------------------------------------------------------------------

void add_stress(const PointField& sum, PointState& p) {
  p.stress[0] += sum.trace;
  p.stress[1] += sum.deviator.re;
  p.stress[2] += sum.deviator.im;
}

void add_element(const FieldElement& e, int b, const Points& points) {
  for (int32_t i = 0; i < points.count; ++i) {
    PointState& p = points.state(i);
    if (!is_inside(p, b)) continue;
    const Complex reference = {p.reference[0], p.reference[1]};
    PointField sum = {};
    add_field(e, reference, p.eta, p.distance, sum);
    add_stress(sum, p);
    if (is_near_node(p, b)) {
      sum = PointField{};
      add_field(e, reference, points.x(i), points.y(i), sum);
    }
    p.u[0] += sum.u.re;
    p.u[1] += sum.u.im;
  }
}

// Nodal values of an element in the units of the equations. Contact tractions of body 2 are per length of body 1 and
// come apart from the others; false if there are none.
bool nodal_values(const Session& session, int b, int32_t element, Complex u[4], Complex own[4], Complex contact[4]) {
  const Model& m = session.model;
  const int nf = m.head->function_nodes;
  const double stress = 1.0 / (2.0 * shear_modulus(m, b)), length = 1.0 / m.head->length_unit;
  bool any = false;
  for (int l = 0; l < nf; ++l) {
    const int32_t node = functional_node(m, b, element, l);
    const double* d = session.area.displacement[b] + 2 * static_cast<int64_t>(node);
    const double* t = session.area.traction[b] + 2 * (static_cast<int64_t>(element) * nf + l);
    u[l] = {length * d[0], length * d[1]};
    double part[2][2] = {{0.0, 0.0}, {0.0, 0.0}};
    const bool shared = b == 1 && pair_of_end(m, b, element, l) >= 0;
    for (int c = 0; c < 2; ++c) {
      const bool foreign = shared && unknown_at(m, b, node, c).kind == UnknownKind::contact;
      part[foreign ? 1 : 0][c] = stress * t[c] / (foreign ? traction_ratio(m, b, element, l) : 1.0);
    }
    own[l] = {part[0][0], part[0][1]};
    contact[l] = {part[1][0], part[1][1]};
    any = any || shared;
  }
  return any;
}

void add_elements_values(const Session& session, int b, int32_t element, const Points& points) {
  Complex u[4], own[4], contact[4];
  Integrator in;
  FieldElement e;
  const bool shared = nodal_values(session, b, element, u, own, contact);
  make_integrator(session.model, b, element, Quadrature::accurate, Measure::own_length, in);
  prepare_field(in, own, u, e);
  add_element(e, b, points);
  if (!shared) return;
  make_integrator(session.model, b, element, Quadrature::accurate, Measure::contact, in);
  prepare_field(in, contact, nullptr, e);
  add_element(e, b, points);
}

// Whatever is known in closed form at a point: so far point loads.
PointField known_field(const Session& session, int b, double x, double y) {
  const Model& m = session.model;
  const double nu = strain_poisson_ratio(m, b), unit = m.head->length_unit;
  PointField sum = {};
  for (int32_t i = 0; i < m.head->point_loads; ++i) {
    const PointLoad& load = m.point_load[i];
    if (load.body != b) continue;
    const double scale = session.follower.load[load.load_case] / (2.0 * shear_modulus(m, b) * unit);
    add_force_field({scale * load.fx, scale * load.fy}, nu, load.x / unit, load.y / unit, x, y, sum);
  }
  return sum;
}

// That, the reference, and rho + omega e_z x (x - x0) of the balanced equations.
void complete_sums(const Session& session, int b, double x, double y, PointState& p) {
  const double unit = session.model.head->length_unit;
  const double* rigid = session.solver->multiplier[b];
  const double* centre = session.model.head->body[b].centre;
  const PointField here = known_field(session, b, x, y);
  p.u[0] += here.u.re + p.reference[0] + rigid[0] - rigid[2] * (y - centre[1] / unit);
  p.u[1] += here.u.im + p.reference[1] + rigid[1] + rigid[2] * (x - centre[0] / unit);
  add_stress(known_field(session, b, p.eta, p.distance), p);
}

// ---- results ------------------------------------------------------------------------------------------------------

void join_to_node(const Session& session, int b, const PointState& p, double x, double y, PlaneStress& stress) {
  PointState at = p;
  NearNode near;
  at.element = floor(0.5 * p.element);
  const bool last = p.element > 2.0 * at.element;
  find_near_node(session.model, b, at, x, y, near);
  const PlaneStress node = joint_stress(session, b, static_cast<int32_t>(at.element), last ? 1.0 : -1.0);
  const double w = near.part;
  stress = {w * stress.xx + (1.0 - w) * node.xx, w * stress.yy + (1.0 - w) * node.yy,
            w * stress.xy + (1.0 - w) * node.xy};
}

void write_point(const Session& session, int b, const double u[2], const PlaneStress& s, int32_t flag, double* out) {
  const double szz = across(session, b, s), shear = largest_shear(s), mean = 0.5 * (s.xx + s.yy);
  out[C2D_POINT_UX] = u[0];
  out[C2D_POINT_UY] = u[1];
  out[C2D_POINT_SXX] = s.xx;
  out[C2D_POINT_SYY] = s.yy;
  out[C2D_POINT_SXY] = s.xy;
  out[C2D_POINT_SZZ] = szz;
  out[C2D_POINT_VON_MISES] = von_mises(s, szz);
  out[C2D_POINT_MAX_SHEAR] = shear;
  out[C2D_POINT_PRINCIPAL1] = mean + shear;
  out[C2D_POINT_PRINCIPAL2] = mean - shear;
  out[C2D_POINT_FLAG] = flag;
}

void finish_point(const Session& session, int b, const Points& points, int32_t i) {
  const Model& m = session.model;
  PointState p = points.state(i);
  double* out = points.out + i * points.out_stride;
  if (p.place == place_of(b, C2D_POINT_BOUNDARY)) {
    const int32_t element = static_cast<int32_t>(p.element);
    const BoundaryState s = boundary_state(session, b, element, p.eta);
    write_point(session, b, s.u, joint_stress(session, b, element, p.eta), C2D_POINT_BOUNDARY, out);
  } else if (is_inside(p, b)) {
    const double x = points.x(i), y = points.y(i), g = shear_modulus(m, b);
    complete_sums(session, b, x, y, p);
    const double u[2] = {p.u[0] * points.unit, p.u[1] * points.unit};
    PlaneStress s = {g * (p.stress[0] + p.stress[1]), g * (p.stress[0] - p.stress[1]), -g * p.stress[2]};
    if (is_near_node(p, b)) join_to_node(session, b, p, x, y, s);
    write_point(session, b, u, s, is_near_node(p, b) ? C2D_POINT_NEAR_NODE : C2D_POINT_INSIDE, out);
  }
}

// The points of one body that are not in an earlier one, complete but for writing them out.
c2d_status evaluate_body(const Session& session, int b, const Points& points) {
  c2d_status status = place_points(session, b, points);
  for (int32_t element = 0; element < session.model.head->body[b].elements && status == C2D_OK; ++element) {
    if (is_zero_length(session.model, b, element)) continue;
    status = pause(session, b, element);
    if (status == C2D_OK) add_elements_values(session, b, element, points);
  }
  return status;
}

void finish_points(const Session& session, const Points& points) {
  for (int32_t i = 0; i < points.count; ++i) {
    const double place = points.state(i).place;
    if (place == kUnplaced) {
      double* out = points.out + i * points.out_stride;
      for (int c = 0; c < C2D_POINT_FLAG; ++c) out[c] = 0.0;
      out[C2D_POINT_FLAG] = C2D_POINT_OUTSIDE;
    } else {
      finish_point(session, static_cast<int>(place) / 4 - 1, points, i);
    }
  }
}

// Results while nothing is solved yet.
void clear_boundary(const Session& session) {
  const ModelHeader& head = *session.model.head;
  for (int b = 0; b < head.bodies; ++b) {
    const int64_t ends = static_cast<int64_t>(head.body[b].elements) * head.function_nodes;
    memset(session.area.displacement[b], 0, 2 * sizeof(double) * static_cast<uint64_t>(head.body[b].nodes));
    memset(session.area.traction[b], 0, 2 * sizeof(double) * static_cast<uint64_t>(ends));
    memset(session.solver->multiplier[b], 0, sizeof session.solver->multiplier[b]);
  }
}

} // namespace

double end_stress(const Session& session, int32_t field, int b, int32_t end) {
  const int32_t nf = session.model.head->function_nodes;
  double hoop;
  const PlaneStress s = stress_at(session, b, end / nf, node_eta(nf, end % nf), &hoop);
  switch (field) {
  case C2D_END_SXX: return s.xx;
  case C2D_END_SYY: return s.yy;
  case C2D_END_SXY: return s.xy;
  case C2D_END_SZZ: return across(session, b, s);
  default: return hoop;
  }
}

} // namespace c2d

using namespace c2d;

extern "C" c2d_status c2d_interior(c2d_solver* s, int32_t body, int32_t count, const double* xy, int64_t xy_stride,
                                   double* out, int64_t out_stride) {
  c2d_status status = enter(s, state_bit(C2D_STATE_RUNNING));
  if (status != C2D_OK) return status;
  if (body < 0 || body > s->model.bodies) return fail(s, C2D_ERR_ARGUMENT, "there is no such body");
  if (count < 0 || (count > 0 && (!xy || !out)))
    return fail(s, C2D_ERR_ARGUMENT, "no points, or no room for the answer");
  if (count > 1 && (xy_stride < 2 || out_stride < C2D_POINT_FIELDS))
    return fail(s, C2D_ERR_ARGUMENT, "strides too small: rows would overlap");
  if (count == 0) return C2D_OK;
  s->cancelled = 0;
  Session session;
  open_session(s, session);
  if (s->blocked || s->floating) clear_boundary(session);
  status = back_substitute_all(session);
  if (status != C2D_OK) return fail_store(s, status);
  const Points points = {count, xy, xy_stride, out, out_stride, s->model.length_unit};
  for (int32_t i = 0; i < count; ++i) points.state(i).place = kUnplaced;
  for (int b = 0; b < s->model.bodies && status == C2D_OK; ++b)
    if (body == 0 || body == b + 1) status = evaluate_body(session, b, points);
  if (status == C2D_OK) finish_points(session, points);
  return status;
}
