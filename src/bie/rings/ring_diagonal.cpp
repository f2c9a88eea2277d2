// The diagonal blocks of bodies of revolution without a sum over all elements (METHOD 21.3).
//
// Both motions of METHOD (21.5) with their tractions, and the field of the ring force, are in equilibrium away from the source.
// By Betti's theorem the integral over a path then depends on its ends only. So the boundary without the elements at the source
// is replaced by a short path through the material round the source (and nothing else is singular for r > 0):
// 1. From the end of the last element at the source straight towards the source, up to the distance of the nearer end or half
//    the source's radius.
// 2. On a circle, by the angle of the material, to the ray of the other end.
// 3. Along that ray to its end.
// Symmetry: the path closes the boundary together with its image. Sources on the axis are summed over all elements.
#include "bie/integrals/batch.hpp"
#include "bie/integrals/integrals_detail.hpp"
#include "bie/rings/ring_batches.hpp"
#include "bie/rings/ring_elements.hpp"
#include "memory/math.hpp"
#include "model/shape.hpp"
#include "model/symmetry.hpp"
#include "quadrature/gauss.hpp"

namespace c2d {
namespace {

constexpr double kThinRing = 1e4; // radius over size

// From a source: to an end of its elements, and the direction in which the boundary leaves it towards that end.
struct EndRay {
  double to[2], tangent[2];
};

// The ends of the path, from the boundary's elements and their images at a source; the sums of these.
struct PathEnds {
  EndRay start, end;
  int starts, ends;
  double own[4];
};

double angle_between(const double a[2], const double b[2]) {
  return atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
}

double length_of(const double v[2]) { return sqrt(squared(v)); }

// Counter-clockwise from the ray of the start to that of the end, through the material.
double swept(const PathEnds& p) {
  const double principal = angle_between(p.start.to, p.end.to), between = angle_between(p.start.tangent, p.end.tangent);
  const double expected = (between < 0.0 ? between + 2.0 * kPi : between) - angle_between(p.start.tangent, p.start.to) +
                          angle_between(p.end.tangent, p.end.to);
  return principal + 2.0 * kPi * floor((expected - principal) / (2.0 * kPi) + 0.5);
}

// Sums along a path seen from a source.
struct PathSum {
  const BatchKernel& kernel;
  BatchRing element;
  double radius, factor;
  RingSums sums;

  // at(t, place, slope) for t from 0 to 1: the place, and its derivative.
  template <class At> void add(At at) {
    const GaussRule rule = gauss_legendre(kNearOrder);
    RingPanel p;
    for (int i = 0; i < kNearOrder; ++i) {
      const GaussPoint point = gauss_point(rule, i);
      const int lane = i % kBatch;
      double place[2], slope[2];
      at(0.5 + 0.5 * point.x, place, slope);
      p.a[lane] = place[0], p.z[lane] = place[1], p.nx[lane] = slope[1], p.ny[lane] = -slope[0], p.stretch[lane] = 1.0;
      p.own[lane] = p.h[0][lane] = -0.25 * factor * point.w * (radius + place[0]);
      p.g[0][lane] = 0.0;
      if (lane == kBatch - 1) kernel.ring_panel(element, radius, p, false, sums);
    }
  }
  // Along a ray between the fractions `from` and `to` of it, from < to; towards the source if sign < 0.
  void add_ray(const double ray[2], double from, double to, double sign) {
    while (from < to) {
      const double next = 2.0 * from < to ? 2.0 * from : to, step = next - from;
      add([&](double t, double place[2], double slope[2]) {
        for (int i = 0; i < 2; ++i) place[i] = (from + t * step) * ray[i], slope[i] = sign * step * ray[i];
      });
      from = next;
    }
  }
  void add_arc(double size, double first, double angle) {
    const int parts = 1 + static_cast<int>(fabs(angle) / (0.501 * kPi));
    const double step = angle / parts;
    for (int n = 0; n < parts; ++n)
      add([&](double t, double place[2], double slope[2]) {
        const double at = first + (n + t) * step, x = size * cos(at), y = size * sin(at);
        place[0] = x, place[1] = y, slope[0] = -step * y, slope[1] = step * x;
      });
  }
};

double sum_of_lanes(const double lane[kBatch]) {
  double sum = 0.0;
  for (int i = 0; i < kBatch; ++i) sum += lane[i];
  return sum;
}

// Subtracts the path's integral from the diagonal.
void take_ring_path_off(const ColumnSystem& system, const Integrator& any, double radius, const PathEnds& p, double* diagonal) {
  PathSum sum = {*system.batch, {0.0, 0.0, any.kappa, any.t1, 1}, radius, any.k, {}};
  const double first = length_of(p.start.to), last = length_of(p.end.to), nearer = first < last ? first : last;
  const double size = nearer < 0.5 * radius ? nearer : 0.5 * radius;
  sum.add_ray(p.start.to, size / first, 1.0, -1.0);
  sum.add_arc(size, atan2(p.start.to[1], p.start.to[0]), swept(p));
  sum.add_ray(p.end.to, size / last, 1.0, 1.0);
  for (int i = 0; i < 4; ++i) diagonal[i] -= sum_of_lanes(sum.sums.h[0][i]);
  for (int i = 0; i < 2; ++i) diagonal[2 * i] -= sum_of_lanes(sum.sums.motion[i]) / radius;
}

struct DiagonalJob {
  const ColumnSystem& system;
  Integrator& in;   // of the element made last
  int32_t element;  // that one, -1: none yet
  const double* at; // the source
};

void use_element(DiagonalJob& job, int32_t element) {
  if (job.element == element) return;
  make_integrator(job.system.model, job.system.body, element, job.system.quadrature, Measure::own_length, job.in);
  job.element = element;
}

// The ray to the image of an element's last (or first) point, with the direction in which the image leaves the source.
void aim_ring(const DiagonalJob& job, int image, int l, bool last, EndRay& out) {
  const Element& e = job.in.element;
  const int end = last ? e.nodes - 1 : 0;
  const double point[2] = {e.x[end], e.y[end]}, sign = last ? 1.0 : -1.0;
  const Source p = mirrored_source(*job.system.model.head, image, point);
  out.to[0] = p.x - job.at[0], out.to[1] = p.y - job.at[1];
  const Expansion x = expand(job.in, node_eta(job.in.functions, l), 0.0, 0.0, true);
  for (int i = 0; i < 2; ++i) out.tangent[i] = image_sign(image, i) * sign * x.b[0][i];
}

// Finds the path's ends at a node's elements, or at their images, and adds their own sums. (A reflection reverses the direction
// of travel.)
void visit_own(DiagonalJob& job, int32_t node, int image, PathEnds& ends) {
  const int f = job.system.model.head->function_nodes;
  int32_t of[2];
  const int count = ends_at_node(job.system.model, job.system.body, node, of);
  for (int n = 0; n < count; ++n) {
    const int l = of[n] % f;
    use_element(job, of[n] / f);
    if (job.in.degenerate) continue;
    double own[2][2];
    ring_panel_sum(job.in, *job.system.batch, job.at[0], job.at[1], l, own);
    for (int i = 0; i < 4; ++i) ends.own[i] += image_sign(image, i / 2) * image_sign(image, i % 2) * own[i / 2][i % 2];
    const bool to_start = f == 1 || l < f - 1, to_end = f == 1 || l > 0;
    if (to_start) aim_ring(job, image, l, true, image == 0 ? ends.start : ends.end), ++(image == 0 ? ends.starts : ends.ends);
    if (to_end) aim_ring(job, image, l, false, image == 0 ? ends.end : ends.start), ++(image == 0 ? ends.ends : ends.starts);
  }
}

// All images of a node, and of its twin, that are where the node is.
void visit_images(DiagonalJob& job, int32_t node, PathEnds& ends) {
  const Model& m = job.system.model;
  const int32_t lines = image_lines(m, job.system.body), twin = job.system.twin[node];
  for (int image = 0; image <= lines; ++image) {
    if (!is_image(lines, image) || !mirrored_source(*m.head, image, job.at).on_itself) continue;
    visit_own(job, node, image, ends);
    if (twin >= 0) visit_own(job, twin, image, ends);
  }
}

bool is_path(const DiagonalJob& job, const PathEnds& p) {
  return job.at[0] > 0.0 && p.starts == 1 && p.ends == 1 && squared(p.start.to) > 0.0 && squared(p.end.to) > 0.0;
}

// Is a body too far from the axis, compared with its size?
bool is_thin_ring(const ColumnSystem& system) {
  const double* first = system.point;
  double size = 0.0;
  for (int32_t node = 0; node < system.model.body[system.body].nodes; ++node)
    for (int i = 0; i < 2; ++i) {
      const double away = fabs(system.point[2 * static_cast<int64_t>(node) + i] - first[i]);
      if (away > size) size = away;
    }
  return first[0] > kThinRing * size;
}

} // namespace

bool fill_ring_diagonal(const ColumnSystem& system, int32_t first_node, int32_t count) {
  if (kSmallCode || !system.batch || is_thin_ring(system)) return false;
  const Model& m = system.model;
  DiagonalJob job = {system, system.scratch->integrator, -1, nullptr};
  for (int32_t node = first_node; node < first_node + count; ++node) {
    if (system.twin[node] == kSecondTwin || system.twin[node] == kAxisNode) continue;
    job.at = system.point + 2 * static_cast<int64_t>(node);
    double* diagonal = system.diagonal + 4 * static_cast<int64_t>(node);
    PathEnds ends = {};
    visit_images(job, node, ends);
    if (is_path(job, ends)) {
      for (int i = 0; i < 4; ++i) diagonal[i] -= ends.own[i];
      take_ring_path_off(system, job.in, job.at[0], ends, diagonal);
      continue;
    }
    for (int32_t element = 0; element < m.body[system.body].elements; ++element)
      if (is_integrated(m, system.body, element)) take_rigid_sums(system, element, node, 1);
    job.element = -1; // they used its place
  }
  return true;
}

} // namespace c2d
