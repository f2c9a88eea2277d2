// The smooth surface over boundary elements (METHOD 8.1).
//
// Gaps and normals of contact must be more accurate than the elements: a polygon instead of a circle changes gaps by L^2/8
// times the curvature, comparable with the approach of the bodies. Phases for one element:
//   1. A given curve (line, arc, spline) is used as it is.
//   2. Otherwise collect up to three chords on either side (Chain), across lines of symmetry by reflection, up to corners.
//   3. At each end estimate the tangent from circles through three points, corrected for the change of curvature, METHOD (8.2).
//      Several point rows give several estimates; rows with little change of curvature get high weights, so that a jump of
//      curvature or a kink inside a row removes its influence.
//   4. Two-node elements: the conic METHOD (8.1) with these end tangents, a rational quadratic Bezier curve (Farin, Curves and
//      Surfaces for CAGD); for equal angles it is a circle. Curved elements: their own polynomial plus one that vanishes at
//      their nodes and gives neighbours a common tangent.
// The largest difference between the estimates is the uncertainty of the surface (METHOD 8.6).
#include "model/surface.hpp"

#include "memory/math.hpp"
#include "model/geometry.hpp"
#include "model/symmetry.hpp"

namespace c2d {

namespace {

constexpr int kReach = 3;             // chords on either side from which the curve is estimated
constexpr double kCorner = 0.66;      // turn in radians: 38 degrees; a regular decagon is still a circle
constexpr double kSplineCorner = 1.5; // the same along a given spline
constexpr double kOneTangent = 0.1;   // difference of both tangents over the turn of the chords: below, one common tangent;
constexpr double kTwoTangents = 0.3;  // above, a kink; in between a linear transition
constexpr double kFlat = 2e-3;        // relative change of curvature that counts as constant
constexpr double kSteepest = 0.05;    // cosine of the largest angle between a chord and its curve
constexpr double kSideWeight = 0.02;  // weight of point rows on one side only, relative to those across the point
constexpr double kUnlike = 100;       // largest ratio of the two angles between a chord and its curve

double arc_sine(double sine) { return atan2(sine, sqrt(1 - sine * sine)); }

double limited(double value, double least, double most) { return value < least ? least : value > most ? most : value; }

// Angle from direction a to direction b, positive to the left.
double turn_between(const double a[2], const double b[2]) {
  return atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
}

// 0: one common tangent, 1: separate tangents on both sides. The linear transition keeps the surface continuous in the data.
double kink_part(double kink_by_turn) { return limited((kink_by_turn - kOneTangent) / (kTwoTangents - kOneTangent), 0, 1); }

// ---- the boundary points around ----

// Chords -before ... after; chord 0 is the element's. Joint j is where chord j begins.
struct Chain {
  int before, after;
  double dx[2 * kReach + 1], dy[2 * kReach + 1], length[2 * kReach + 1];
  double turn[2 * kReach + 1], bend[2 * kReach + 1]; // at the joints: angle, curvature of the circle through three points
};

// A position on a region or on its reflection across lines of symmetry.
struct Walk {
  int32_t element;
  int way;        // 1 or -1
  double sign[2]; // of the image
};

} // namespace

int32_t element_beside(const Model& m, int b, int32_t element, int way) {
  if (way > 0) return element_after(m, b, element);
  const Region& r = m.region[b][region_of_element(m, b, element)];
  if (element != r.first) return element - 1;
  return r.open != 0 ? -1 : r.last;
}

const Curve* curve_of(const Model& m, int b, int32_t element) {
  for (int32_t i = 0; i < m.head->curves; ++i) {
    const Curve& c = m.curve[i];
    if (c.body == b && c.first <= element && element <= c.last) return &c;
  }
  return nullptr;
}

namespace {

// Moves to the next element; at a line of symmetry to the reflection of the same element, walked backwards. False: the curve
// ends.
bool go_on(const Model& m, int b, Walk& walk) {
  const int32_t next = element_beside(m, b, walk.element, walk.way);
  if (m.body[b].lines != 0) {
    const double* end = m.xy[b] + 2 * geometry_node(m, b, walk.element, walk.way > 0 ? body_of(m, b).element_nodes - 1 : 0);
    const int32_t lines = lines_through(*m.head, end[0], end[1]);
    if (lines != 0 && (next < 0 || is_axis_element(m, b, next))) {
      if (lines == 3) return false; // crossing of both lines: refused by validation
      walk.sign[lines - 1] = -walk.sign[lines - 1];
      walk.way = -walk.way;
      return true;
    }
  }
  if (next < 0) return false; // an open region that does not end on a line: refused as well
  const Curve* const own = curve_of(m, b, walk.element);
  walk.element = next;
  return !is_zero_length(m, b, next) && curve_of(m, b, next) == own;
}

void add_chord(const Model& m, int b, const Walk& walk, int place, Chain& chain) {
  const double* p = m.xy[b] + 2 * geometry_node(m, b, walk.element, 0);
  const double* q = m.xy[b] + 2 * geometry_node(m, b, walk.element, 1);
  const int at = kReach + place, sense = place < 0 ? -walk.way : walk.way; // chords point forwards
  chain.dx[at] = sense * walk.sign[0] * (q[0] - p[0]);
  chain.dy[at] = sense * walk.sign[1] * (q[1] - p[1]);
  chain.length[at] = sqrt(chain.dx[at] * chain.dx[at] + chain.dy[at] * chain.dy[at]);
}

// Turn and curvature at a joint; false at a corner. The curvature is that of the circle through three points: 4 times the area
// of the triangle over the product of its sides.
bool add_joint(Chain& chain, int joint, double corner) {
  const int at = kReach + joint, from = at - 1;
  const double cross = chain.dx[from] * chain.dy[at] - chain.dy[from] * chain.dx[at],
               along = chain.dx[from] * chain.dx[at] + chain.dy[from] * chain.dy[at], x = chain.dx[from] + chain.dx[at],
               y = chain.dy[from] + chain.dy[at];
  chain.turn[at] = atan2(cross, along);
  if (fabs(chain.turn[at]) > corner) return false;
  chain.bend[at] = 2 * cross / (chain.length[from] * chain.length[at] * sqrt(x * x + y * y));
  return true;
}

int follow(const Model& m, int b, int32_t element, int way, bool spline, Chain& chain) {
  Walk walk = {element, way, {1, 1}};
  for (int i = 1; i <= kReach; ++i) {
    if (!go_on(m, b, walk)) return i - 1;
    add_chord(m, b, walk, way * i, chain);
    if (!add_joint(chain, way > 0 ? i : 1 - i, spline ? kSplineCorner : kCorner)) return i - 1;
  }
  return kReach;
}

// ---- the tangent at one end of chord 0 ----

// The chain viewed towards one end of chord 0: there it is joint 1, for either end, so that one formula serves both.
struct View {
  const Chain* chain;
  int way;
  bool has(int joint) const { // with the chords on either side of it
    const int ahead = way > 0 ? chain->after : chain->before, behind = way > 0 ? chain->before : chain->after;
    return joint <= ahead && joint >= 1 - behind;
  }
  double length(int chord) const { return chain->length[kReach + way * chord]; }
  double turn(int joint) const { return chain->turn[kReach + (way > 0 ? joint : 1 - joint)]; }
  double bend(int joint) const { return chain->bend[kReach + (way > 0 ? joint : 1 - joint)]; }
};

// Tangents at joint 1 as turns from chord 0, weighted.
struct Mean {
  double weight, sum;
  void add(double w, double angle) {
    weight += w;
    sum += w * angle;
  }
};

double circle_angle(const View& v, int joint, int chord) {
  return arc_sine(limited(0.5 * v.bend(joint) * v.length(chord), -1, 1));
}

// The turn from chord 0 to the tangent at joint 1 by the joints `pair`, pair + 1.
double tangent_by(const View& v, int pair, double change) {
  const double l = v.length(0), next = v.length(1);
  if (pair == -1) return circle_angle(v, 0, 0) + change / 6 * l * (l + v.length(-1));
  if (pair == 2) return v.turn(1) - circle_angle(v, 2, 1) + change / 6 * next * (next + v.length(2));
  return circle_angle(v, 1, 0) - change / 6 * l * next;
}

// How the curve goes on at joint 1: the turns from chord 0 to its tangent before and behind it.
struct Tangents {
  double before, behind, doubt;
};

[[gnu::noinline]] Tangents tangents_at(const View& v, bool spline) {
  if (!v.has(1)) { // no chord beyond this end: the tangent comes from this side, by one circle or two
    if (!v.has(0)) return Tangents{0, 0, 0};
    double angle = circle_angle(v, 0, 0);
    if (v.has(-1)) {
      const double change = 3 * (v.bend(0) - v.bend(-1)) / (v.length(-2) + v.length(-1) + v.length(0));
      angle = limited(tangent_by(v, -1, change), -kCorner, kCorner);
    }
    const double corner = 0.5 * v.turn(1); // each side may take half of the turn of a corner; 0: the curve ends here
    if (corner * angle > 0) angle = limited(angle, -fabs(corner), fabs(corner));
    return Tangents{angle, angle, fabs(angle - circle_angle(v, 0, 0))};
  }
  double largest = 0;
  for (int j = -1; j <= 3; ++j)
    if (v.has(j)) largest = fmax(largest, fabs(v.bend(j)));
  // Weighted mean over the four point rows. The weight falls with the fourth power of the relative change of curvature: a row
  // across a jump or kink loses against one that ends there, although all rows are always evaluated.
  const double single = circle_angle(v, 1, 0), turn = v.turn(1);
  double least = single, most = single;
  Mean before = {0, 0}, behind = {0, 0};
  for (int pair = -1; pair <= 2 && largest > 0; ++pair) {
    if (!v.has(pair) || !v.has(pair + 1)) continue;
    const double rate = 3 * (v.bend(pair + 1) - v.bend(pair)) / (v.length(pair - 1) + v.length(pair) + v.length(pair + 1));
    const double size = rate * 0.5 * (v.length(0) + v.length(1)) / largest, square = size * size + kFlat * kFlat;
    const bool beside = pair == -1 || pair == 2;
    if (spline && beside) continue; // a spline is smooth by definition: no one-sided rows
    const double weight = spline ? 1 : (beside ? kSideWeight : 1) / (square * square), angle = tangent_by(v, pair, rate);
    least = fmin(least, angle);
    most = fmax(most, angle);
    if (pair < 2) before.add(weight, angle);
    if (pair > -1) behind.add(weight, angle);
  }
  Tangents t = {before.weight > 0 ? before.sum / before.weight : single,
                behind.weight > 0 ? behind.sum / behind.weight : single, 0};
  // One common tangent, unless both differ clearly and in the sense of the turn of the chords.
  const double kink = t.behind - t.before, mean = 0.5 * (t.before + t.behind);
  const double part = turn == 0 || spline ? 0 : kink_part(kink / turn);
  t.before = mean + part * (t.before - mean);
  t.behind = mean + part * (t.behind - mean);
  const double low = fmin(turn, 0), high = fmax(turn, 0);
  t.before = limited(t.before, low, high);
  t.behind = limited(t.behind, low, high);
  t.doubt = most - least;
  return t;
}

// ---- elements that are curved themselves ----

void tangent_at(const double* x, const double* y, int nodes, double eta, double out[2]) {
  const CurvePoint p = curve_point(nodes, x, y, eta);
  out[0] = p.dx;
  out[1] = p.dy;
}

// Half the angle at which a curved element meets its neighbour at one end, positive where the common tangent lies farther out;
// 0 at a kink, which is kept. *known: there is a neighbour.
double half_kink(const Model& m, int b, int32_t element, const SurfaceElement& s, bool spline, int way, bool* known) {
  Walk walk = {element, way, {1, 1}};
  *known = go_on(m, b, walk);
  if (!*known) return 0;
  double x[kElementNodes], y[kElementNodes], own[2][2], next[2][2];
  element_coordinates(m, b, walk.element, x, y);
  for (int i = 0; i < 2; ++i) {
    tangent_at(s.x, s.y, s.nodes, way * (1 - 2 * i), own[i]); // the end here, the far one
    tangent_at(x, y, s.nodes, walk.way * (2 * i - 1), next[i]);
  }
  const double own_turn = fabs(turn_between(own[0], own[1])), next_turn = fabs(turn_between(next[0], next[1]));
  for (int c = 0; c < 2; ++c) next[0][c] *= way * walk.way * walk.sign[c]; // forwards along the element's own curve
  const double kink = way * turn_between(own[0], next[0]), turn = fmin(own_turn, next_turn);
  *known = fabs(kink) <= (spline ? kSplineCorner : kCorner);
  if (!*known || (turn == 0 && !spline)) return 0;
  return 0.5 * kink * (spline ? 1 : 1 - kink_part(fabs(kink) / turn));
}

// Not inlined, like bend_chords: the frames of the two alternatives must not add up.
[[gnu::noinline]] void bend_curved(const Model& m, int b, int32_t element, bool spline, SurfaceElement& s) {
  bool known[2];
  for (int end = 0; end < 2; ++end) s.bend[end] = half_kink(m, b, element, s, spline, 2 * end - 1, &known[end]);
  for (int end = 0; end < 2; ++end)
    if (!known[end] && known[1 - end])
      s.bend[end] = s.bend[1 - end]; // no neighbour: assume the same correction as at the other end
  s.length = element_length(m, b, element);
  s.doubt = 0.025 * s.length * fmax(fabs(s.bend[0]), fabs(s.bend[1]));
}

// Adds to the curve of the element the polynomial that gives the end tangents and vanishes at its boundary points, which must
// stay on the surface. Degree four with three nodes and five with four, the least that has these zeros and two free slopes.
void add_bend(const SurfaceElement& s, double eta, double size, SurfacePoint& p) {
  const double c = s.nodes == 3 ? 0 : 1.0 / 9, scale = 0.25 * s.length * (s.nodes == 3 ? 1 : 1.125);
  const double mean = 0.5 * (s.bend[0] + s.bend[1]), half = 0.5 * (s.bend[1] - s.bend[0]), square = eta * eta;
  const double zeros = (1 - square) * (square - c), rise = 2 * eta * (1 + c - 2 * square);
  const double over = scale * zeros * (mean + half * eta);
  const double slope = scale * (rise * (mean + half * eta) + zeros * half) / size;
  const double nx = p.nx, ny = p.ny, unit = 1 / sqrt(1 + slope * slope);
  p.x += over * nx;
  p.y += over * ny;
  p.nx = unit * (nx + slope * ny); // less slope times the tangent (-ny, nx)
  p.ny = unit * (ny - slope * nx);
}

// Two boundary points: end tangents of the conic from the chords around.
[[gnu::noinline]] void bend_chords(const Model& m, int b, int32_t element, bool spline, SurfaceElement& s) {
  Chain chain = Chain();
  add_chord(m, b, Walk{element, 1, {1, 1}}, 0, chain);
  chain.after = follow(m, b, element, 1, spline, chain);
  chain.before = follow(m, b, element, -1, spline, chain);
  double sum = 0;
  for (int end = 0; end < 2; ++end) {
    const Tangents t = tangents_at(View{&chain, end == 0 ? -1 : 1}, spline);
    s.bend[end] = sin(t.before) / fmax(cos(t.before), kSteepest);
    sum += t.before;
    s.doubt = fmax(s.doubt, 0.15 * chain.length[kReach] * t.doubt);
  }
  // Towards a straight part both angles must tend to zero together; otherwise round-off of the small one decides the shape.
  for (int end = 0; end < 2; ++end)
    s.bend[end] = limited(s.bend[end], -kUnlike * fabs(s.bend[1 - end]), kUnlike * fabs(s.bend[1 - end]));
  s.weight = cos(0.5 * sum);
}

} // namespace

SurfaceElement surface_element(const Model& m, int b, int32_t element) {
  SurfaceElement s = SurfaceElement();
  s.nodes = body_of(m, b).element_nodes;
  element_coordinates(m, b, element, s.x, s.y);
  const Curve* const given = curve_of(m, b, element);
  if (given != nullptr && given->kind == C2D_CURVE_ARC) {
    for (int c = 0; c < 2; ++c) s.centre[c] = given->centre[c];
    s.radius = given->radius;
  }
  if (given != nullptr && given->kind != C2D_CURVE_SPLINE) return s;
  if (s.nodes > 2)
    bend_curved(m, b, element, given != nullptr, s);
  else if (!is_zero_length(m, b, element))
    bend_chords(m, b, element, given != nullptr, s);
  return s;
}

SurfacePoint surface_point(const SurfaceElement& s, double eta) {
  const CurvePoint p = curve_point(s.nodes, s.x, s.y, eta);
  const double size = sqrt(p.dx * p.dx + p.dy * p.dy);
  SurfacePoint out = {p.x, p.y, 0, 0};
  if (size == 0) return out;
  const double ux = p.dx / size, uy = p.dy / size;
  out.nx = uy;
  out.ny = -ux;
  if (s.radius > 0) { // along the radius
    const double x = p.x - s.centre[0], y = p.y - s.centre[1], from = sqrt(x * x + y * y);
    if (from == 0) return out;
    const double outward = x * out.nx + y * out.ny > 0 ? 1 / from : -1 / from;
    return SurfacePoint{s.centre[0] + s.radius * x / from, s.centre[1] + s.radius * y / from, outward * x, outward * y};
  }
  if (s.nodes > 2) add_bend(s, eta, size, out);
  if (s.nodes > 2 || s.bend[0] * s.bend[1] <= 0) return out;
  // In units of the chord: the end tangents cross at (q, h), the Bezier control point with weight w. a + b = 1 are the
  // parameters of the conic point above the fraction t of the chord: root of a quadratic equation, in the form without
  // cancellation, since one tangent may be nearly parallel to the chord.
  const double sum = s.bend[0] + s.bend[1], p0 = s.bend[0] / sum, q = s.bend[1] / sum, h = s.bend[0] * q, w = s.weight;
  const double t = 0.5 * (1 + eta), rest = 0.5 * (1 - eta), k = w * (eta < 0 ? q - t : rest - p0);
  const double root = sqrt(k * k + rest * t), to = k > 0 ? t : root - k, from = k > 0 ? root + k : rest;
  const double a = from / (from + to), b = to / (from + to);
  const double over = 2 * w * a * b * h / (a * a + b * b + 2 * w * a * b);
  const double slope = w * h * (a - b) / (w * (a * a * q + b * b * p0) + a * b);
  out.x += 2 * size * over * uy;
  out.y -= 2 * size * over * ux;
  const double scale = 1 / sqrt(1 + slope * slope);
  out.nx = scale * (uy - slope * ux);
  out.ny = scale * (-ux - slope * uy);
  return out;
}

SurfacePoint surface_point(const Model& m, int b, int32_t element, double eta) {
  return surface_point(surface_element(m, b, element), eta);
}

namespace {

// Mean curvature of a side of a zone: turn over length; practically 0 where it is concave or flat. Input of METHOD (8.3).
double roundness(const Model& m, const Zone& z, int side) {
  constexpr double kNoTurn = 1e-15; // not 0: with both sides flat the ratio of METHOD (8.3) becomes one half
  const int b = z.body[side], step = z.element_step[side];
  double turn = 0, length = 0, end[2] = {0, 0};
  for (int32_t k = 0; k < zone_elements(z, side); ++k) {
    const int32_t element = zone_element(m, z, side, k);
    const SurfaceElement surface = surface_element(m, b, element);
    const SurfacePoint from = surface_point(surface, -step), to = surface_point(surface, step);
    const double n[2] = {from.nx, from.ny}, last[2] = {to.nx, to.ny};
    if (k > 0) turn += turn_between(end, n);
    turn += turn_between(n, last);
    end[0] = to.nx, end[1] = to.ny;
    length += element_length(m, b, element);
  }
  return length > 0 ? fmax(step * turn, kNoTurn) / length : 1;
}

} // namespace

double find_normal_part(const Model& m, const Zone& z) {
  const double k1 = roundness(m, z, 0), k2 = roundness(m, z, 1);
  return k2 / (k1 + k2);
}

} // namespace c2d
