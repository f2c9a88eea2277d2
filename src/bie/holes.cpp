// Holes of a body, and the place inside each where METHOD (4.1) takes the trace of the stress (METHOD 4).
//
// Phases:
// 1. Runs: a region is cut at its elements on lines of symmetry. Each run, completed by its images, is one closed outline.
// 2. Area of the polygon of chords: negative if the material is outside. Then the outline is a hole.
// 3. A point inside: the centroid of the area. If it is outside the hole or too close to its boundary: the centre of the
//    largest circle in the hole, with preference for circles near the centroid.
// 4. Rows: L tr V at that point from every element, L = 4 A / S.
// The place must not depend on numbering, rotation or reflection of the mesh: results would change with it in the digits of
// the discretisation error. Therefore two circles that are mirror images of each other both count.
// Literature: own method, METHOD 20.
#include "bie/holes.hpp"

#include "bie/integrals/interior.hpp"
#include "bie/integrals/kernels.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "model/geometry.hpp"
#include "model/symmetry.hpp"

namespace c2d {

C2D_USES(RingPart);

namespace {

// ---- runs of elements -------------------------------------------------------------------------------------------------

// The first element of the first run: behind elements on a line of symmetry, if there are any, so that no run is cut in two.
int32_t first_of_runs(const Model& m, int b, const Region& region) {
  if (region.open) return region.first;
  for (int32_t e = region.first; e <= region.last && m.body[b].lines != 0; ++e)
    if (is_axis_element(m, b, e)) return e;
  return region.first;
}

// ---- outlines ---------------------------------------------------------------------------------------------------------

// Visits the chords of a run and of its images: visit(p, q, element, image).
template <class Visit> void visit_chords(const Model& m, int b, const Hole& run, Visit visit) {
  const int32_t lines = m.body[b].lines;
  int32_t element = run.first;
  for (int32_t k = 0; k < run.elements; ++k) {
    Chords c;
    chords_of(m, b, element, c);
    for (int image = 0; image <= lines; ++image) {
      if (!is_image(lines, image)) continue;
      for (int i = 0; i < c.count; ++i) {
        const double p[2] = {mirrored(*m.head, image, 0, c.x[i]), mirrored(*m.head, image, 1, c.y[i])};
        const double q[2] = {mirrored(*m.head, image, 0, c.x[i + 1]), mirrored(*m.head, image, 1, c.y[i + 1])};
        visit(p, q, element, image);
      }
    }
    element = element_after(m, b, element);
  }
}

// The outline of a run, closed along the lines of symmetry on which it ends, without its images.
struct Outline {
  double area; // negative: a hole
  double length;
  double centroid[2];       // of a hole
  double first[2], last[2]; // its ends
};

Outline outline_of(const Model& m, int b, const Hole& run) {
  const double* at = m.head->line_at; // without a line any point is as good
  Outline out{};
  double moment[2] = {0.0, 0.0};
  int32_t element = run.first;
  for (int32_t k = 0; k < run.elements; ++k) {
    Chords c;
    chords_of(m, b, element, c);
    if (k == 0) out.first[0] = c.x[0], out.first[1] = c.y[0];
    out.last[0] = c.x[c.count], out.last[1] = c.y[c.count];
    for (int i = 0; i < c.count; ++i) {
      const double px = c.x[i] - at[0], py = c.y[i] - at[1], qx = c.x[i + 1] - at[0], qy = c.y[i + 1] - at[1];
      // Twice the area of the triangle (at, p, q). `at` is on the lines of symmetry, so the segments along them that close the
      // outline contribute nothing.
      const double twice = px * qy - qx * py;
      out.area += 0.5 * twice;
      moment[0] += twice * (px + qx) / 6.0;
      moment[1] += twice * (py + qy) / 6.0;
      out.length += hypot(qx - px, qy - py);
    }
    element = element_after(m, b, element);
  }
  if (!(out.area < 0.0)) return out;
  for (int i = 0; i < 2; ++i) out.centroid[i] = at[i] + moment[i] / out.area;
  // Images complete a run that begins or ends on a line: their common centroid lies on it.
  if (out.first[0] == out.last[0] && out.first[1] == out.last[1]) return out;
  for (int i = 0; i < 2; ++i) {
    const double from = fabs(out.first[i] - at[i]), to = fabs(out.last[i] - at[i]);
    if ((m.body[b].lines >> i & 1) != 0 && (from < to ? from : to) < 1e-6 * out.length) out.centroid[i] = at[i];
  }
  return out;
}

// ---- points inside ----------------------------------------------------------------------------------------------------

double chord_distance2(const double p[2], const double a[2], const double c[2]) {
  const double dx = c[0] - a[0], dy = c[1] - a[1], d2 = dx * dx + dy * dy;
  double s = d2 > 0.0 ? ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / d2 : 0.0;
  s = s < 0.0 ? 0.0 : (s > 1.0 ? 1.0 : s);
  const double rx = a[0] + s * dx - p[0], ry = a[1] + s * dy - p[1];
  return rx * rx + ry * ry;
}

// Does the hole wind round p, with p farther from its boundary than `least`? A hole is traversed clockwise, so the angle is -2
// pi.
bool is_well_inside(const Model& m, int b, const Hole& run, const double p[2], double least) {
  double turned = 0.0, distance2 = -1.0;
  visit_chords(m, b, run, [&](const double* a, const double* c, int32_t, int image) {
    const double d2 = chord_distance2(p, a, c);
    if (distance2 < 0.0 || d2 < distance2) distance2 = d2;
    const double ax = a[0] - p[0], ay = a[1] - p[1], cx = c[0] - p[0], cy = c[1] - p[1];
    const double angle = atan2(ax * cy - cx * ay, ax * cx + ay * cy);
    turned += (image & 1) != (image >> 1 & 1) ? -angle : angle; // one reflection runs the other way
  });
  return turned < -3.0 && distance2 > least * least;
}

// Radius of the largest circle that touches the chord (a, c) from its right at its middle and contains no other point of the
// boundary; p: its centre. It is the smallest of the circles through the middle and one point of any other chord.
double touching_circle(const Model& m, int b, const Hole& run, const double a[2], const double c[2], double p[2]) {
  const double middle[2] = {0.5 * (a[0] + c[0]), 0.5 * (a[1] + c[1])}, length = hypot(c[0] - a[0], c[1] - a[1]);
  const double n[2] = {(c[1] - a[1]) / length, (a[0] - c[0]) / length};
  double radius = -1.0;
  // A point at (x, y) from the middle, t = n.(x, y) ahead, lies on the circle of radius (x^2 + y^2) / (2 t).
  visit_chords(m, b, run, [&](const double* from, const double* to, int32_t, int) {
    const double x = from[0] - middle[0], y = from[1] - middle[1], dx = to[0] - from[0], dy = to[1] - from[1];
    const double ahead = n[0] * x + n[1] * y, slope = n[0] * dx + n[1] * dy, across = n[0] * dy - n[1] * dx;
    const double least = 1e-9 * length;
    double s; // along this chord
    if (fabs(slope) > 1e-9 * (fabs(dx) + fabs(dy))) {
      // Where the line meets the tangent at u from the middle, circles that touch it do so at the distance |u| from there.
      const double u = (n[0] * y - n[1] * x) - across * ahead / slope;
      s = (fabs(u) * fabs(slope) / hypot(dx, dy) - ahead) / slope;
    } else {
      const double d2 = dx * dx + dy * dy;
      s = d2 > 0.0 ? -(x * dx + y * dy) / d2 : 0.0;
    }
    s = s < 0.0 ? 0.0 : (s > 1.0 ? 1.0 : s);
    const double px = x + s * dx, py = y + s * dy, t = ahead + s * slope;
    if (t > least && (radius < 0.0 || px * px + py * py < 2.0 * t * radius)) radius = (px * px + py * py) / (2.0 * t);
  });
  for (int i = 0; i < 2; ++i) p[i] = middle[i] + radius * n[i];
  return radius;
}

// The centre of the largest of these circles, weighted by its distance from the centroid. A hole whose centroid lies outside
// is at most a mirror image of itself: two equal centres both count. Returns false in a slit that has no width beyond
// rounding.
bool find_widest(const Model& m, int b, const Outline& outline, Hole& run) {
  double best = -1.0, centre[2][2] = {};
  run.points = 0;
  int32_t element = run.first;
  for (int32_t k = 0; k < run.elements; ++k, element = element_after(m, b, element)) {
    Chords c;
    chords_of(m, b, element, c);
    for (int i = 0; i < c.count; ++i) {
      const double from[2] = {c.x[i], c.y[i]}, to[2] = {c.x[i + 1], c.y[i + 1]};
      if (from[0] == to[0] && from[1] == to[1]) continue;
      double p[2];
      const double radius = touching_circle(m, b, run, from, to, p);
      const double away = hypot(p[0] - outline.centroid[0], p[1] - outline.centroid[1]) / outline.length;
      const double merit = radius * (1.0 - away * away);
      if (!(radius > 0.0) || merit < best * (1.0 - 1e-6)) continue;
      // A tolerance of 1e-6 decides "equal": the two centres of a symmetric hole differ by rounding.
      const bool better = merit > best * (1.0 + 1e-6);
      if (better) run.points = 0;
      if (better) best = merit;
      const bool known = run.points > 0 && hypot(p[0] - centre[0][0], p[1] - centre[0][1]) < 1e-5 * outline.length;
      if (known || run.points == 2) continue;
      centre[run.points][0] = p[0];
      centre[run.points++][1] = p[1];
    }
  }
  for (int32_t k = 0; k < run.points; ++k)
    for (int i = 0; i < 2; ++i) run.at[k][i] = centre[k][i] / m.head->length_unit;
  return run.points > 0;
}

// The centroid of the area, if it is well inside or if there is no circle. Rotation, reflection and numbering do not change
// the result.
void find_inside(const Model& m, int b, const Outline& outline, Hole& run) {
  constexpr double kWell = 0.31; // of the radius of a circle with this ratio of area to length
  const double radius = -2.0 * outline.area / outline.length, unit = m.head->length_unit;
  run.length = 2.0 * radius / unit;
  if (!is_well_inside(m, b, run, outline.centroid, kWell * radius) && find_widest(m, b, outline, run)) return;
  run.points = 1;
  for (int i = 0; i < 2; ++i) run.at[0][i] = outline.centroid[i] / unit;
}

// The next run of a region, whether a hole or not; false at the region's end.
bool next_run(const Model& m, int b, HoleWalk& walk, Hole& out) {
  const Region& region = m.region[b][walk.region];
  const int32_t size = region.last - region.first + 1;
  if (walk.done == 0) walk.element = first_of_runs(m, b, region);
  while (walk.done < size && is_axis_element(m, b, walk.element)) {
    walk.element = element_after(m, b, walk.element);
    ++walk.done;
  }
  if (walk.done >= size) return false;
  out = Hole{walk.region, walk.element, 0, 0, {}, 0.0};
  for (; walk.done < size && !is_axis_element(m, b, walk.element); ++walk.done, ++out.elements)
    walk.element = element_after(m, b, walk.element);
  return true;
}

} // namespace

bool next_hole(const Model& m, int b, HoleWalk& walk, Hole& out) {
  const int32_t regions = m.body[b].regions;
  if (regions == 1 && m.body[b].lines == 0) return false; // the outer boundary alone
  while (walk.region < regions) {
    if (!next_run(m, b, walk, out)) {
      walk = HoleWalk{walk.region + 1, 0, 0};
      continue;
    }
    const Outline outline = outline_of(m, b, out);
    if (!(outline.area < 0.0)) continue;
    find_inside(m, b, outline, out);
    return true;
  }
  return false;
}

namespace {

// add(x, y) at every point inside and its images. Sums over the points are divided by their number.
template <class Add> void at_points(const Model& m, int b, const Hole& hole, Add add) {
  const int32_t lines = image_lines(m, b);
  for (int32_t k = 0; k < hole.points; ++k)
    for (int image = 0; image <= lines; ++image) {
      if (!is_image(lines, image)) continue;
      const Source p = mirrored_source(*m.head, image, hole.at[k]);
      add(p.x, p.y);
    }
}

// A cavity of a body of revolution: a point beyond the axis is one of the same ring.
void cavity_row(const Model& m, int b, const Hole& hole, const Integrator& in, HoleRow& out) {
  out = HoleRow{};
  at_points(m, b, hole, [&](double x, double y) { kRingPart.add_ring_trace(in, fabs(x), y, out.h, out.g); });
  for (int l = 0; l < in.functions; ++l)
    for (int c = 0; c < 2; ++c) {
      out.h[l][c] *= hole.length / hole.points;
      out.g[l][c] *= -hole.length / hole.points;
    }
}

} // namespace

void hole_row(const Model& m, int b, const Hole& hole, const Integrator& in, bool want_h, bool want_g, FieldElement& e,
              HoleRow& out) {
  if (is_ring(in)) return cavity_row(m, b, hole, in, out);
  e.in = in;
  for (int l = 0; l < in.functions; ++l)
    for (int c = 0; c < 2; ++c)
      for (int kind = 0; kind < 2; ++kind) { // 0: displacement, 1: traction
        double& to = kind == 0 ? out.h[l][c] : out.g[l][c];
        to = 0.0;
        if (!(kind == 0 ? want_h : want_g)) continue;
        // The field of one unit nodal value: interior.cpp evaluates it as for any other point off the boundary.
        Complex zero[kElementNodes] = {}, one[kElementNodes] = {};
        one[l] = c == 0 ? Complex{1.0, 0.0} : Complex{0.0, 1.0};
        prepare_field(kind == 0 ? zero : one, kind == 0 ? one : nullptr, e);
        PointField field = {};
        at_points(m, b, hole, [&](double x, double y) { add_field(e, Complex{0.0, 0.0}, x, y, field); });
        to = (kind == 0 ? 1.0 : -1.0) * hole.length * field.trace / hole.points;
      }
}

// A point load acts on the filling like a traction: it goes to the side of G t, hence the sign.
double hole_load(const Model& m, int b, const Hole& hole, const PointLoad& load) {
  const double unit = m.head->length_unit, nu = strain_poisson_ratio(m, b);
  const double scale = balance_scale(m) / (2.0 * shear_modulus(m, b) * unit);
  PointField field = {};
  at_points(m, b, hole, [&](double x, double y) {
    const double force[2] = {load.fx * scale, load.fy * scale}, from[2] = {load.x / unit, load.y / unit}, at[2] = {fabs(x), y};
    if (is_axisymmetric(m))
      kRingPart.add_ring_force(force, nu, from, at, field);
    else
      add_force_field(Complex{force[0], force[1]}, nu, from[0], from[1], x, y, field);
  });
  return -hole.length * (field.trace + field.round) / hole.points;
}

void hole_normal(const Model& m, int b, int32_t node, double n[2]) {
  const int32_t f = m.head->function_nodes;
  int32_t ends[2];
  const int count = ends_at_node(m, b, node, ends);
  n[0] = n[1] = 0.0;
  // At a corner the mean of both elements' normals.
  for (int i = 0; i < count; ++i) {
    double one[2];
    outward_normal(m, b, ends[i] / f, node_eta(f, ends[i] % f), one);
    n[0] += one[0] / count;
    n[1] += one[1] / count;
  }
}

} // namespace c2d
