// Contribution of one boundary element to displacements and stresses at interior points (METHOD 16.3).
//
// Phases:
//   1. nodal_values: displacements and tractions of the element in the units of the equations. Particular solutions of body
//      forces are subtracted, because the integrals represent u - u_p. Contact tractions of side 1 are measured per length of
//      side 0 and form a separate set; mortar-transferred tractions are omitted, they are integrated by pieces.
//   2. prepare_field: polynomial coefficients in the local frame of the element.
//   3. For every inside point and every image of a symmetric model: the integrals of METHOD (16.2) and METHOD (16.3), in closed
//      form on straight elements. Eight points at a time where vector instructions exist; points near the element one by one,
//      because their integrals need other formulas.
//   4. Close to a node the stress is smoothed (results/interior/interior_nodes.cpp).
#include "results/interior/interior_elements.hpp"

#include "bie/body_force.hpp"
#include "bie/columns.hpp"
#include "memory/parts.hpp"
#include "results/back.hpp"
#include "solver/particular.hpp"

namespace c2d {

C2D_USES(BodyForcePart);

namespace {

// One point. For an image the point is reflected instead of the element: the element is prepared once, and its field is
// reflected back when it is added.
template <bool smooths> void add_element_at(Acting& acting, const Points& points, int32_t i) {
  PointSums& p = points.sums(i);
  if (!is_inside(p.place, acting.b)) return;
  const int32_t lines = points.images(acting.b);
  for (int image = 0; image <= lines; ++image) {
    if (!is_image(lines, image)) continue;
    const Complex reference = {image_sign(image, 0) * p.reference[0], image_sign(image, 1) * p.reference[1]};
    const double x = points.seen(image, 0, p.x), y = points.seen(image, 1, p.y);
    PointField sum = {};
    add_field(acting.e, reference, x, y, sum);
    add_displacement(image, sum, p);
    if constexpr (smooths) smooth_at_nodes(*acting.session, acting.b, acting.element, acting.e, x, y, *acting.smoothing, sum);
    add_stress(image, sum, p);
  }
}

// Batches of eight points; those near the element one by one. Lanes without an inside point get a place far from the element,
// where the kernel is regular, and their results are discarded: this avoids branches in the vector code. False: not available.
template <bool smooths> bool add_element_batches(Acting& acting, const Points& points) {
  const FieldElement& e = acting.e;
  const BatchKernel* kernel = points.kernel;
  BatchFieldElement element;
  if (!kernel || kSmallCode || points.lines(acting.b) != 0 || !batch_field_element(e, element)) return false;
  const double away = 64.0 * e.in.radius;
  BatchPoints at;
  BatchField sum;
  sum.some_near = false;
  for (int32_t first = 0; first < points.count; first += kBatch) {
    const int count = points.count - first < kBatch ? points.count - first : kBatch;
    bool any = false;
    for (int s = 0; s < kBatch; ++s) {
      const bool has = s < count && is_inside(points.place(first + s), acting.b);
      const PointSums& p = points.sums(has ? first + s : first);
      at.x[s] = has ? p.x : element.x0 + away;
      at.y[s] = has ? p.y : element.y0;
      at.reference_x[s] = has ? p.reference[0] : 0.0;
      at.reference_y[s] = has ? p.reference[1] : 0.0;
      any = any || has;
    }
    if (any) kernel->field(element, at, sum);
    for (int s = 0; s < count; ++s) {
      PointSums& p = points.sums(first + s);
      if (!is_inside(p.place, acting.b)) continue;
      if (sum.some_near && sum.near[s] != 0.0) {
        add_element_at<smooths>(acting, points, first + s);
        continue;
      }
      p.stress[0] += sum.trace[s];
      p.stress[1] += sum.deviator_re[s];
      p.stress[2] += sum.deviator_im[s];
      p.u[0] += sum.ux[s];
      p.u[1] += sum.uy[s];
    }
  }
  return true;
}

template <bool smooths> void add_element(Acting& acting, const Points& points) {
  if (add_element_batches<smooths>(acting, points)) return;
  for (int32_t i = 0; i < points.count; ++i) add_element_at<smooths>(acting, points, i);
}

} // namespace

// Not inlined, like the functions below that call it: each has a large frame and calls deep functions.
[[gnu::noinline]] void nodal_values(const Session& session, int b, int32_t element, NodalValues& out) {
  const Model& m = session.model;
  const int nf = m.head->function_nodes;
  const double stress = 1.0 / (2.0 * shear_modulus(m, b)), length = 1.0 / m.head->length_unit;
  out.any_contact = false;
  for (int l = 0; l < nf; ++l) {
    const int32_t node = functional_node(m, b, element, l);
    double d[2], t[2];
    get_displacement(session, b, node, d);
    get_traction(session, b, element * nf + l, t);
    out.u[l] = {length * d[0], length * d[1]};
    double part[2][2] = {{0.0, 0.0}, {0.0, 0.0}};
    double transferred[2]; // from free zones: integrated by pieces, hence subtracted here
    transferred_traction(session, b, element, l, transferred);
    const PairSide at = pair_of_end(m, b, element, l);
    const bool shared = at.pair >= 0 && at.side == 1;
    for (int c = 0; c < 2; ++c) {
      const bool foreign = shared && is_of_contact(m, at, node, c, unknown_at(m, b, node, c));
      part[foreign ? 1 : 0][c] = stress * (t[c] - transferred[c]) / (foreign ? traction_ratio(m, b, element, l) : 1.0);
    }
    if (has_body_force(m, b)) {
      double up[2], tp[2];
      kBodyForcePart.particular_at_end(session, b, element, l, up, tp);
      out.u[l] = {length * (d[0] - up[0]), length * (d[1] - up[1])};
      for (int c = 0; c < 2; ++c) part[0][c] -= stress * tp[c];
    }
    out.own[l] = {part[0][0], part[0][1]};
    out.contact[l] = {part[1][0], part[1][1]};
    out.any_contact = out.any_contact || shared;
  }
}

namespace {

[[gnu::noinline]] void add_own_values(const Session& session, int b, int32_t element, const NodalValues& values,
                                      const Points& points) {
  ElementSmoothing smoothing;
  smoothing.ready = false;
  Acting acting{&session, b, element, &smoothing, {}};
  make_integrator(session.model, b, element, Quadrature::accurate, Measure::own_length, acting.e.in);
  prepare_field(values.own, values.u, acting.e);
  add_element<true>(acting, points);
}

// The own values of the element, or its contact tractions, without smoothing: displacements need none, and a contact traction
// of side 1 acts together with the own values, to which the smoothing has been applied.
[[gnu::noinline]] void add_values(const Session& session, int b, int32_t element, Measure measure, const Complex* t,
                                  const Complex* u, const Points& points) {
  Acting acting{&session, b, element, nullptr, {}};
  make_integrator(session.model, b, element, Quadrature::accurate, measure, acting.e.in);
  prepare_field(t, u, acting.e);
  add_element<false>(acting, points);
}

template <bool stresses> void integrate(const Session& session, int b, int32_t element, const Points& points) {
  NodalValues values;
  nodal_values(session, b, element, values);
  if constexpr (stresses)
    add_own_values(session, b, element, values, points);
  else
    add_values(session, b, element, Measure::own_length, values.own, values.u, points);
  if (values.any_contact) add_values(session, b, element, Measure::contact, values.contact, nullptr, points);
}

} // namespace

// Reports progress and checks for cancellation between elements.
c2d_status pause_at_points(const Session& session, int b, int32_t elements) {
  c2d_solver* s = session.solver;
  tell_progress(s, C2D_PHASE_BACK, b + 1, elements, session.model.body[b].elements);
  return asked_to_stop(s) ? fail(s, C2D_ERR_CANCELLED, "cancelled while computing interior points") : c2d_status{C2D_OK};
}

void integrate_element(const Session& session, int b, int32_t element, const Points& points) {
  integrate<true>(session, b, element, points);
}
void integrate_displacements(const Session& session, int b, int32_t element, const Points& points) {
  integrate<false>(session, b, element, points);
}
void add_element(Acting& acting, const Points& points) { add_element<false>(acting, points); }

} // namespace c2d
