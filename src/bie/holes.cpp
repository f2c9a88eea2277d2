#include "bie/holes.hpp"

#include <math.h>

#include "bie/interior.hpp"
#include "bie/kernels.hpp"
#include "model/geometry.hpp"
#include "model/symmetry.hpp"

namespace c2d {

namespace {

// ---- runs of elements -------------------------------------------------------------------------------------------------

bool ends_run(const Model& m, int b, int32_t element) { return element < 0 || is_axis_element(m, b, element); }

// Where the first run of a region begins: behind elements on a line of symmetry, if there are any.
int32_t first_of_runs(const Model& m, int b, const Region& region) {
  if (region.open) return region.first;
  for (int32_t e = region.first; e <= region.last && m.head->symmetry != 0; ++e)
    if (is_axis_element(m, b, e)) return e;
  return region.first;
}

// Twice the area between a run and the lines of symmetry it ends on; negative: a hole.
double twice_area(const Model& m, int b, const Hole& run) {
  const double* at = m.head->line_at; // where there is no line any point will do
  double sum = 0.0;
  int32_t element = run.first;
  for (int32_t k = 0; k < run.elements; ++k) {
    Chords c;
    chords_of(m, b, element, c);
    for (int i = 0; i < c.count; ++i)
      sum += (c.x[i] - at[0]) * (c.y[i + 1] - at[1]) - (c.x[i + 1] - at[0]) * (c.y[i] - at[1]);
    element = element_after(m, b, element);
  }
  return sum;
}

// ---- a point inside ---------------------------------------------------------------------------------------------------

// Visits the chords of a run and of its images: visit(p, q, element, image).
template <class Visit> void visit_chords(const Model& m, int b, const Hole& run, Visit visit) {
  int32_t element = run.first;
  for (int32_t k = 0; k < run.elements; ++k) {
    Chords c;
    chords_of(m, b, element, c);
    for (int image = 0; image <= m.head->symmetry; ++image) {
      if (!is_image(*m.head, image)) continue;
      for (int i = 0; i < c.count; ++i) {
        const double p[2] = {mirrored(*m.head, image, 0, c.x[i]), mirrored(*m.head, image, 1, c.y[i])};
        const double q[2] = {mirrored(*m.head, image, 0, c.x[i + 1]), mirrored(*m.head, image, 1, c.y[i + 1])};
        visit(p, q, element, image);
      }
    }
    element = element_after(m, b, element);
  }
}

// Distance from p along the unit vector n to the chord (a, c); negative: the ray does not meet it.
double ray_hit(const double p[2], const double n[2], const double a[2], const double c[2]) {
  const double dx = c[0] - a[0], dy = c[1] - a[1], rx = a[0] - p[0], ry = a[1] - p[1];
  const double det = n[1] * dx - n[0] * dy;
  if (fabs(det) <= 1e-9 * (fabs(dx) + fabs(dy))) return -1.0;
  const double along = (n[0] * ry - n[1] * rx) / det;
  return along < -1e-9 || along > 1.0 + 1e-9 ? -1.0 : (ry * dx - rx * dy) / det;
}

double chord_distance2(const double p[2], const double a[2], const double c[2]) {
  const double dx = c[0] - a[0], dy = c[1] - a[1], d2 = dx * dx + dy * dy;
  double s = d2 > 0.0 ? ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / d2 : 0.0;
  s = s < 0.0 ? 0.0 : (s > 1.0 ? 1.0 : s);
  const double rx = a[0] + s * dx - p[0], ry = a[1] + s * dy - p[1];
  return rx * rx + ry * ry;
}

// Half way across the hole from the middle of an element; returns the distance across, 0 if there is none.
double across(const Model& m, int b, const Hole& run, int32_t element, double p[2]) {
  const CurvePoint middle = curve_point(m, b, element, 0.0);
  const double start[2] = {middle.x, middle.y}, least = 1e-3 * element_length(m, b, element);
  double n[2], nearest = -1.0;
  outward_normal(m, b, element, 0.0, n);
  visit_chords(m, b, run, [&](const double* a, const double* c, int32_t, int) {
    const double hit = ray_hit(start, n, a, c);
    if (hit > least && (nearest < 0.0 || hit < nearest)) nearest = hit;
  });
  for (int i = 0; i < 2; ++i) p[i] = start[i] + 0.5 * nearest * n[i];
  return nearest > 0.0 ? nearest : 0.0;
}

// Of a few such points the one that is farthest from the boundary; of equals the first.
bool find_inside(const Model& m, int b, Hole& run) {
  constexpr int32_t kTries = 8;
  const double unit = m.head->length_unit;
  double best2 = 0.0;
  int32_t element = run.first;
  for (int32_t k = 0; k < run.elements; ++k, element = element_after(m, b, element)) {
    const int32_t step = run.elements / kTries + 1;
    if (k % step != 0 || !is_integrated(m, b, element)) continue;
    double p[2], distance2 = -1.0;
    const double length = across(m, b, run, element, p);
    if (!(length > 0.0)) continue;
    visit_chords(m, b, run, [&](const double* a, const double* c, int32_t, int) {
      const double d2 = chord_distance2(p, a, c);
      if (distance2 < 0.0 || d2 < distance2) distance2 = d2;
    });
    if (!(distance2 > (1.0 + 1e-6) * best2)) continue;
    best2 = distance2;
    run.x = p[0] / unit;
    run.y = p[1] / unit;
    run.length = length / unit;
  }
  return best2 > 0.0;
}

// The next run of a region, whatever it encloses; false at the region's end.
bool next_run(const Model& m, int b, HoleWalk& walk, Hole& out) {
  const Region& region = m.region[b][walk.region];
  const int32_t size = region.last - region.first + 1;
  if (walk.done == 0) walk.element = first_of_runs(m, b, region);
  while (walk.done < size && ends_run(m, b, walk.element)) {
    walk.element = element_after(m, b, walk.element);
    ++walk.done;
  }
  if (walk.done >= size) return false;
  out = Hole{walk.region, walk.element, 0, 0.0, 0.0, 0.0};
  for (; walk.done < size && !ends_run(m, b, walk.element); ++walk.done, ++out.elements)
    walk.element = element_after(m, b, walk.element);
  return true;
}

} // namespace

bool next_hole(const Model& m, int b, HoleWalk& walk, Hole& out) {
  const int32_t regions = m.head->body[b].regions;
  if (regions == 1 && m.head->symmetry == 0) return false; // the outer boundary alone
  while (walk.region < regions) {
    if (!next_run(m, b, walk, out)) {
      walk = HoleWalk{walk.region + 1, 0, 0};
      continue;
    }
    if (twice_area(m, b, out) < 0.0 && find_inside(m, b, out)) return true;
  }
  return false;
}

void hole_row(const Model& m, const Hole& hole, const Integrator& in, bool want_h, bool want_g, FieldElement& e,
              HoleRow& out) {
  e.in = in;
  const double inside[2] = {hole.x, hole.y};
  for (int l = 0; l < in.functions; ++l)
    for (int c = 0; c < 2; ++c)
      for (int kind = 0; kind < 2; ++kind) { // 0: displacement, 1: traction
        double& to = kind == 0 ? out.h[l][c] : out.g[l][c];
        to = 0.0;
        if (!(kind == 0 ? want_h : want_g)) continue;
        Complex zero[4] = {}, one[4] = {};
        one[l] = c == 0 ? Complex{1.0, 0.0} : Complex{0.0, 1.0};
        prepare_field(kind == 0 ? zero : one, kind == 0 ? one : nullptr, e);
        PointField field = {};
        for (int image = 0; image <= m.head->symmetry; ++image) {
          if (!is_image(*m.head, image)) continue;
          const Source p = mirrored_source(*m.head, image, inside);
          add_field(e, Complex{0.0, 0.0}, p.x, p.y, field);
        }
        to = (kind == 0 ? 1.0 : -1.0) * hole.length * field.trace;
      }
}

double hole_load(const Model& m, int b, const Hole& hole, const PointLoad& load) {
  const double unit = m.head->length_unit, nu = strain_poisson_ratio(m, b);
  const double scale = 1.0 / (2.0 * shear_modulus(m, b) * unit), inside[2] = {hole.x, hole.y};
  PointField field = {};
  for (int image = 0; image <= m.head->symmetry; ++image) {
    if (!is_image(*m.head, image)) continue;
    const Source p = mirrored_source(*m.head, image, inside);
    add_force_field(Complex{load.fx * scale, load.fy * scale}, nu, load.x / unit, load.y / unit, p.x, p.y, field);
  }
  return -hole.length * field.trace;
}

void hole_normal(const Model& m, int b, int32_t node, double n[2]) {
  const int32_t f = m.head->function_nodes;
  int32_t ends[2];
  const int count = ends_at_node(m, b, node, ends);
  n[0] = n[1] = 0.0;
  for (int i = 0; i < count; ++i) {
    double one[2];
    outward_normal(m, b, ends[i] / f, local_eta(f, ends[i] % f), one);
    n[0] += one[0] / count;
    n[1] += one[1] / count;
  }
}

} // namespace c2d
