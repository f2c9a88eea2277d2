// Change of the gap of a pair due to slip along curved surfaces (METHOD 8.7).
//
// Small-displacement contact measures the gap along the normal at a fixed pair of points, g + (u_2 - u_1).n, which is right to
// first order in the slip s. Where a surface changes its curvature, as at the end of a fillet, the first-order profiles have a
// kink after the slip that the real ones have not, and the pressure shows a spurious peak. METHOD (8.4) replaces the profiles
// by those of the points that have come to face each other: c(s) = eta_2(-(1 - m) s) - eta_1(m s) - k s^2/2. The last term
// removes the share of evenly curved surfaces, which linear kinematics omits everywhere, as for a pin that turns in its hole.
// Phases: find_slip_gaps decides once per zone whether the correction is needed and finds k; slip_gap evaluates c(s) by
// following both surfaces for the distances m s and (1 - m) s.
#include "model/slip_gap.hpp"

#include "memory/math.hpp"
#include "model/geometry.hpp"

namespace c2d {

namespace {

constexpr double kSame = 1e-9;    // relative difference below which two curvatures are equal
constexpr double kNoPart = 1e-9;  // share of the slip below which a side does not move along its surface
constexpr double kCorner = 0.1;   // radians: a kink of this angle ends a curve
constexpr double kNoSlope = 1e-3; // cosine: a curve that runs along the normal ends here
constexpr double kExact = 1e-14;  // relative tolerance of the position along a curve

// The point of a pair on a side.
FacePoint point_of_pair(const Model& m, int32_t pair, int side) {
  const Pair& p = m.pair[pair];
  if (p.node[side] < 0) return FacePoint{p.element, 0, p.eta};
  const int b = body_on(m, p, side), f = m.head->function_nodes;
  int32_t ends[2];
  const int count = ends_at_node(m, b, p.node[side], ends);
  int32_t end = -1;
  for (int i = 0; i < count; ++i)
    if (end < 0 || pair_of_end(m, b, ends[i] / f, ends[i] % f).pair == pair) end = ends[i];
  return end < 0 ? FacePoint{-1, 0, 0.0} : FacePoint{end / f, 0, node_eta(f, end % f)};
}

// A surface seen from one of its points: x along t from there, y along n.
struct View {
  double x0, y0, n[2];
  void see(const SurfacePoint& p, double* x, double* y) const {
    const double dx = p.x - x0, dy = p.y - y0;
    *x = dx * n[1] - dy * n[0];
    *y = dx * n[0] + dy * n[1];
  }
};

struct Place {
  double x, y;
};

// The point of an element at tangential coordinate x, between eta `from` and `to`, by regula falsi (Illinois variant).
Place place_at(const SurfaceElement& element, const View& view, double from, double to, double x) {
  constexpr int kMost = 60;
  double a = from, b = to, xa, xb, y;
  view.see(surface_point(element, a), &xa, &y);
  view.see(surface_point(element, b), &xb, &y);
  const double exact = kExact * fabs(xb - xa);
  double fa = xa - x, fb = xb - x;
  Place out{xb, y};
  for (int i = 0; i < kMost && fb != 0.0 && fa != fb; ++i) {
    const double at = b - fb * (b - a) / (fb - fa);
    view.see(surface_point(element, at), &out.x, &out.y);
    const double f = out.x - x;
    if (fabs(f) <= exact) break;
    if (f * fb < 0.0)
      a = b, fa = fb;
    else
      fa *= 0.5;
    b = at, fb = f;
  }
  return out;
}

// The element that continues the surface beyond one end of another, or -1. It must have a given curve and meet without a
// corner: beyond that the shape is not known well enough for second-order terms.
int32_t goes_on(const Model& m, int b, int32_t element, int way) {
  const int32_t next = element_beside(m, b, element, way);
  if (next < 0 || is_zero_length(m, b, next) || curve_of(m, b, next) == nullptr || !is_integrated(m, b, next)) return -1;
  const SurfacePoint here = surface_point(m, b, element, way), there = surface_point(m, b, next, -way);
  const double n[2] = {here.nx, here.ny}, beside[2] = {there.nx, there.ny};
  return angle_between(n, beside) > kCorner ? -1 : next;
}

// The point of the surface at the distance x along t from one of its points, or the end of the given curves if that comes
// first.
Place follow_surface(const Model& m, int b, const FacePoint& at, const double n[2], double x) {
  int32_t element = at.element;
  double eta = at.eta;
  SurfaceElement surface = surface_element(m, b, element);
  const SurfacePoint start = surface_point(surface, eta);
  const View view{start.x, start.y, {n[0], n[1]}};
  // The direction of travel along the boundary is (-ny, nx) of its normal; its component along t = (n_y, -n_x) gives the sense.
  const double along = -(start.nx * n[0] + start.ny * n[1]);
  if (x == 0.0 || fabs(along) < kNoSlope) return Place{0.0, 0.0};
  const int way = (x > 0.0) == (along > 0.0) ? 1 : -1;
  Place last{0.0, 0.0};
  for (int32_t left = body_of(m, b).elements; element >= 0 && left > 0; --left) {
    Place end;
    view.see(surface_point(surface, way), &end.x, &end.y);
    if (fabs(end.x) >= fabs(x) && end.x * x > 0.0) return place_at(surface, view, eta, way, x);
    if ((end.x - last.x) * x < 0.0) break; // the surface turns back: x is beyond its extent
    last = end;
    element = goes_on(m, b, element, way);
    if (element >= 0) surface = surface_element(m, b, element);
    eta = -way;
  }
  return last;
}

// ---- which pairs ----

// Mean curvature of an element, positive where the body is convex: turn of the normal over the length, exact for arcs.
double curvature_of(const Model& m, int b, int32_t element) {
  const Curve* const curve = curve_of(m, b, element);
  if (curve != nullptr && curve->kind == C2D_CURVE_LINE) return 0.0;
  const SurfaceElement surface = surface_element(m, b, element);
  const SurfacePoint from = surface_point(surface, -1), to = surface_point(surface, 1);
  const double turn = atan2(from.nx * to.ny - from.ny * to.nx, from.nx * to.nx + from.ny * to.ny);
  if (curve != nullptr && curve->kind == C2D_CURVE_ARC) return turn > 0.0 ? 1.0 / curve->radius : -1.0 / curve->radius;
  return turn / element_length(m, b, element);
}

// Share of the slip by which the surface of a side moves past the pair; METHOD (8.4): m and 1 - m.
double part_of(const Zone& z, int side) { return side == 0 ? z.normal_part : 1.0 - z.normal_part; }

// Scans the pairs of a zone in order: are all curves given, does the curvature change, and which curvature has the longest
// stretch?
struct Course {
  const Curve* curve[2] = {nullptr, nullptr};
  double length = 0.0, bend = 0.0;    // current stretch on the same two curves: length, integral of the curvature of both
  double longest = 0.0, even = 0.0;   // longest stretch: length, mean curvature
  double curvature[2] = {0.0, 0.0};   // of the previous pair
  bool given = true, changes = false; // all pairs have given curves; the curvature of a side that slides varies

  void end_stretch() {
    if (length > longest) {
      longest = length;
      even = bend / length;
    }
    length = bend = 0.0;
  }
  void add(const Model& m, const Zone& z, int32_t pair, bool first) {
    const Curve* now[2];
    double k[2] = {0.0, 0.0}, both = 0.0;
    for (int side = 0; side < 2; ++side) {
      const FacePoint at = point_of_pair(m, pair, side);
      const double part = part_of(z, side);
      now[side] = at.element >= 0 ? curve_of(m, z.body[side], at.element) : nullptr;
      if (part <= kNoPart || !given) continue;
      given = now[side] != nullptr;
      if (given) k[side] = curvature_of(m, z.body[side], at.element);
      both += part * part * k[side];
      const double size = fmax(fabs(k[side]), fabs(curvature[side]));
      changes = changes || (given && now[side]->kind == C2D_CURVE_SPLINE) ||
                (!first && fabs(k[side] - curvature[side]) > kSame * size);
    }
    if (now[0] != curve[0] || now[1] != curve[1]) end_stretch();
    for (int side = 0; side < 2; ++side) {
      curve[side] = now[side];
      curvature[side] = k[side];
    }
    length += m.pair[pair].length;
    bend += m.pair[pair].length * both;
  }
};

} // namespace

void find_slip_gaps(const Model& m) {
  for (int32_t i = 0; i < m.head->zones; ++i) {
    const Zone& z = m.zone[i];
    Course course;
    for (int32_t k = 0; k < z.pairs && z.is_tied == 0; ++k) course.add(m, z, z.first_pair + k, k == 0);
    course.end_stretch();
    const bool follows = z.is_tied == 0 && course.given && course.changes;
    for (int32_t k = 0; k < z.pairs; ++k) {
      SlipGap& out = m.slip_gap[z.first_pair + k];
      out = SlipGap{};
      out.follows = follows ? 1 : 0;
      out.even = course.even;
    }
  }
}

double slip_gap(const Model& m, const Zone& z, const FacePoint at[2], const double n[2], double s, double even) {
  // Two points face each other now that were s apart in the undeformed state.
  const double way[2] = {z.normal_part * s, -(1.0 - z.normal_part) * s};
  Place there[2];
  double part = 1.0; // fraction of the slip up to the end of a curve: beyond it c stays constant
  for (int side = 0; side < 2; ++side) {
    there[side] = follow_surface(m, z.body[side], at[side], n, way[side]);
    if (fabs(there[side].x) < (1.0 - kSame) * fabs(way[side])) part = fmin(part, fabs(there[side].x / way[side]));
  }
  for (int side = 0; side < 2 && part < 1.0; ++side)
    there[side] = follow_surface(m, z.body[side], at[side], n, part * way[side]);
  // Subtract the share of evenly curved surfaces, which linear kinematics neglects everywhere: otherwise a pin that turns in
  // its hole by an angle w would press against it by w^2 R/2.
  return there[1].y - there[0].y - 0.5 * even * part * part * s * s;
}

double slip_gap(const Model& m, int32_t pair, double s) {
  const Pair& p = m.pair[pair];
  const FacePoint at[2] = {point_of_pair(m, pair, 0), point_of_pair(m, pair, 1)};
  const double n[2] = {p.nx, p.ny};
  return slip_gap(m, zone_of(m, p), at, n, s, m.slip_gap[pair].even);
}

} // namespace c2d
