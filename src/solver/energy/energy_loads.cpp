// Point loads in the energy's functionals.

#include "bie/body_force.hpp"
#include "bie/columns.hpp"
#include "bie/integrals/kernels.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "model/geometry.hpp"
#include "model/shape.hpp"
#include "model/symmetry.hpp"
#include "solver/energy/energy_adjoint.hpp"

namespace c2d {

C2D_USES(FreeZonePart);
C2D_USES(BodyForcePart);
C2D_USES(RingPart);

namespace {

// With more load cases what is looked up of an element serves several point loads. (Few have the digits that they always had.)
constexpr int32_t kManyPointCases = 16, kLoadsAtOnce = kSmallCode ? 1 : 24;

// Point loads of functionals: places and forces in the units of the model, as they are, and as an image of the body sees them.
struct LoadsSeen {
  int32_t taken;
  Adjoint* a[kLoadsAtOnce];
  const PointLoad* load[kLoadsAtOnce];
  double place[kLoadsAtOnce][2], force[kLoadsAtOnce][2];
  double at[kLoadsAtOnce][2], factor[kLoadsAtOnce][2];
  int32_t count() const { return kSmallCode ? 1 : taken; }
};

bool displacement_is_given(const Unknown& unknown) {
  return unknown.kind != UnknownKind::contact && unknown.kind != UnknownKind::displacement;
}

// The load cases that may prescribe something on an element.
CaseSpan cases_on(const Adjoint& a, int32_t element) {
  if (!a.cases) return {1, a.model().head->load_cases};
  return {static_cast<int32_t>(a.cases[2 * element]), static_cast<int32_t>(a.cases[2 * element + 1])};
}

double force_times(const double factor[2], const double block[2][2], int c) {
  return factor[0] * block[0][c] + factor[1] * block[1][c];
}

// What an element's tractions and displacements do to the displacements at the points.
[[gnu::noinline]] void add_element_at(const LoadsSeen& points, int32_t element, Measure measure) {
  const Adjoint& first = *points.a[0];
  const Model& m = first.model();
  const int b = first.b;
  const bool own = measure == Measure::own_length;
  Integrator integrator;
  make_integrator(m, b, element, Quadrature::accurate, measure, integrator);
  Blocks blocks[kLoadsAtOnce];
  double* lambda[kLoadsAtOnce];
  for (int32_t i = 0; i < points.count(); ++i) {
    integrate(integrator, points.at[i][0], points.at[i][1], -1, own, true, blocks[i]);
    lambda[i] = points.a[i]->lambda;
  }
  double part[kLoadsAtOnce];
  for (int l = 0; l < m.head->function_nodes; ++l) {
    const int32_t node = functional_node(m, b, element, l);
    Unknown unknown[2];
    unknowns_at(m, b, node, unknown);
    for (int c = 0; c < 2; ++c) {
      for (int32_t i = 0; i < points.count() && own; ++i) part[i] = -force_times(points.factor[i], blocks[i].h[l], c);
      if (!kSmallCode && own && displacement_is_given(unknown[c]))
        add_prescribed(prescribed_displacement(m, b, node, c), cases_on(first, element), points.count(), part, lambda);
      else
        for (int32_t i = 0; i < points.count() && own; ++i) add_displacement(*points.a[i], node, c, unknown[c], part[i]);
      const TractionKind kind = traction_kind(m, b, element, l, c, unknown[c]);
      const bool contact = kind == TractionKind::contact && pair_of_end(m, b, element, l).side == 1;
      if (contact == own) continue;
      for (int32_t i = 0; i < points.count(); ++i) part[i] = force_times(points.factor[i], blocks[i].g[l], c);
      if (!kSmallCode && kind == TractionKind::given)
        add_prescribed(prescribed_traction(m, b, element, l, c), cases_on(first, element), points.count(), part, lambda);
      else
        for (int32_t i = 0; i < points.count(); ++i) add_traction(*points.a[i], element, l, c, kind, part[i]);
    }
  }
  for (int32_t i = 0; i < points.count() && own && has_body_force(m, b); ++i)
    kBodyForcePart.take_particular(*points.a[i], element, blocks[i], points.factor[i]);
}

// The field of all point loads of the body.
void add_point_fields(Adjoint& a, const double at[2], const double factor[2]) {
  const Model& m = a.model();
  const double unit = m.head->length_unit, nu = strain_poisson_ratio(m, a.b);
  const Box box = box_of_body(m, a.b);
  const double width = (m.body[a.b].lines & 1 ? 2.0 : 1.0) * (box.x_max - box.x_min),
               height = (m.body[a.b].lines & 2 ? 2.0 : 1.0) * (box.y_max - box.y_min);
  const double size = hypot(width, height) / unit; // of the whole body
  for (int32_t i = 0; i < m.head->point_loads; ++i) {
    const PointLoad& other = m.point_load[i];
    if (other.body != a.b) continue;
    const double rx = other.x / unit - at[0], ry = other.y / unit - at[1], r2 = rx * rx + ry * ry;
    const bool own = r2 <= 1e-18 * size * size;
    double scale = 1.0 / (2.0 * shear_modulus(m, a.b) * unit * 4.0 * kPi * (1.0 - nu)), u[2][2];
    if (is_axisymmetric(m)) {
      scale = balance_scale(m) / (2.0 * shear_modulus(m, a.b) * unit);
      const double from[2] = {other.x / unit, other.y / unit}, seen[2] = {at[0], own ? from[1] + size : at[1]};
      kRingPart.ring_force(nu, from, seen, u);
      for (int k = 0; k < 4; ++k) u[k / 2][k % 2] *= scale;
    } else
      store(own ? displacement_kernel(0.0, 0.0, 0.0, size * size, 3.0 - 4.0 * nu)
                : displacement_kernel(rx, ry, r2, 3.0 - 4.0 * nu),
            scale, u);
    for (int c = 0; c < 2; ++c) a.lambda[other.load_case] += factor[c] * (u[c][0] * other.fx + u[c][1] * other.fy);
  }
}

// All elements and point loads as one of their images, which act as they themselves at the mirrored points, mirrored.
void add_image_at(const LoadsSeen& points) {
  const Model& m = points.a[0]->model();
  const int b = points.a[0]->b;
  for (int32_t element = 0; element < m.body[b].elements; ++element) {
    if (!is_integrated(m, b, element)) continue;
    add_element_at(points, element, Measure::own_length);
    ZonePlace place;
    if (find_contact_element(m, b, element, &place) && place.side == 1) add_element_at(points, element, Measure::contact);
  }
  for (int32_t i = 0; i < points.count(); ++i) {
    add_point_fields(*points.a[i], points.at[i], points.factor[i]);
    if (m.body[b].free_rows > 0) kFreeZonePart.add_transferred_at(*points.a[i], points.at[i], points.factor[i]);
  }
}

void take_load(LoadsSeen& points, Adjoint& a, const PointLoad& load) {
  const ModelHeader& head = *a.model().head;
  const double unit = head.length_unit, place[2] = {load.x / unit, load.y / unit};
  const double force[2] = {load.fx / (head.stress_unit * unit), load.fy / (head.stress_unit * unit)};
  points.a[points.taken] = &a;
  points.load[points.taken] = &load;
  for (int c = 0; c < 2; ++c) {
    points.place[points.taken][c] = place[c];
    points.force[points.taken][c] = force[c];
  }
  ++points.taken;
}

[[gnu::noinline]] void add_points(LoadsSeen& points) {
  const Model& m = points.a[0]->model();
  const double unit = m.head->length_unit;
  const Body& body = m.body[points.a[0]->b];
  const int32_t lines = image_lines(m, points.a[0]->b);
  for (int image = 0; image <= lines; ++image) {
    if (!is_image(lines, image)) continue;
    for (int32_t i = 0; i < points.count(); ++i)
      for (int c = 0; c < 2; ++c) {
        const double place = points.place[i][c];
        points.at[i][c] = (image >> c & 1) != 0 ? 2.0 * (m.head->line_at[c] / unit) - place : place;
        points.factor[i][c] = image_sign(image, c) * points.force[i][c];
      }
    add_image_at(points);
  }
  for (int32_t i = 0; i < points.count(); ++i) {
    Adjoint& a = *points.a[i];
    const double *const at = points.place[i], *const force = points.force[i];
    const double dx = at[0] - body.centre[0] / unit, dy = at[1] - body.centre[1] / unit;
    add_outer(a, body.columns, force[0]);
    add_outer(a, body.columns + 1, force[1]);
    add_outer(a, body.columns + 2, force[1] * dx - force[0] * dy);
    if (has_body_force(m, a.b)) kBodyForcePart.add_particular_at_load(a, *points.load[i], force);
  }
  points.taken = 0;
}

} // namespace

void add_point_loads(Adjoint* a, int32_t count) {
  const ModelHeader& head = *a->model().head;
  const int32_t most = !kSmallCode && head.load_cases > kManyPointCases ? kLoadsAtOnce : 1;
  LoadsSeen points;
  points.taken = 0;
  for (Adjoint* one = a; one < a + count; ++one)
    for (int32_t i = 0; i < head.point_loads && one->number % 2 == 0; ++i) { // (reactions have none)
      const PointLoad& load = one->model().point_load[i];
      if (load.body != one->b || 2 * load.load_case != one->number) continue;
      take_load(points, *one, load);
      if (points.taken == most) add_points(points);
    }
  if (!kSmallCode && points.taken > 0) add_points(points);
}

} // namespace c2d
