// Boundaries: simple closed curves with the material on their left.
//
// Phases per body: single elements (zero length, Jacobian, spikes); coincident points; crossings of elements; orientation and
// nesting of regions. Each phase needs the previous one: coincident points would also be reported as crossings, and winding
// numbers of crossing curves have no meaning.
#include "memory/config.hpp"
#include "memory/math.hpp"
#include "model/geometry.hpp"
#include "model/validate/meeting_boxes.hpp"
#include "model/validate/validate.hpp"
#include "model/validate/validate_finding.hpp"

namespace c2d {

namespace {

constexpr int32_t kMostListed = 10; // coincidences, and crossings, per body

// Reports one more finding of a kind, at most kMostListed; the last one states that more were omitted.
void report_some(Finding& f, int32_t& found, Reporter& reporter) {
  if (++found > kMostListed) return;
  if (found == kMostListed) say(f, " (further ones are not listed)");
  report(reporter, f);
}

// ---- single elements ----

void check_zero_length(const Model& m, int b, int32_t element, Reporter& reporter) {
  const int32_t next = element_after(m, b, element);
  const char* trouble = nullptr;
  if (m.head->function_nodes != 2)
    trouble = "a double node needs linear functions (2 functional nodes per element)";
  else if (next >= 0 && is_zero_length(m, b, next))
    trouble = "two elements of zero length follow one another";
  if (trouble == nullptr) return;
  report(reporter, at_element(m, b, element), "element ", element + 1, " has zero length: ", trouble);
}

// The tangent dx/deta of a curved element must neither vanish nor reverse: otherwise the mapping is not one-to-one, as with
// inner nodes far from their equidistant positions.
void check_jacobian(const Model& m, int b, int32_t element, Reporter& reporter) {
  constexpr int kSamples = 64;
  const double least = 1e-6 * 0.5 * element_length(m, b, element);
  CurvePoint before = curve_point(m, b, element, -1);
  const char* trouble = nullptr;
  double eta = -1;
  for (int i = 0; i <= kSamples && trouble == nullptr; ++i) {
    eta = -1 + 2.0 * i / kSamples;
    const CurvePoint p = curve_point(m, b, element, eta);
    if (sqrt(p.dx * p.dx + p.dy * p.dy) <= least)
      trouble = "its Jacobian vanishes";
    else if (p.dx * before.dx + p.dy * before.dy <= 0)
      trouble = "it folds back on itself";
    before = p;
  }
  if (trouble == nullptr) return;
  report(reporter, at_element(m, b, element), "element ", element + 1, " is distorted: ", trouble, " near eta = ", eta,
         "; expected inner nodes near equal divisions of the curve");
}

void check_spike(const Model& m, int b, int32_t element, Reporter& reporter) {
  if (is_zero_length(m, b, element)) return;
  int32_t next = element;
  do next = element_after(m, b, next);
  while (next >= 0 && is_zero_length(m, b, next));
  if (next < 0) return; // the end of an open region
  double n1[2], n2[2];
  outward_normal(m, b, element, 1, n1);
  outward_normal(m, b, next, -1, n2);
  if (n1[0] * n2[0] + n1[1] * n2[1] >= 0 || fabs(n1[0] * n2[1] - n1[1] * n2[0]) > 1e-9) return;
  Where where = at_element(m, b, next);
  where.node = geometry_node(m, b, next, 0) + 1;
  report(reporter, where, "the boundary reverses its direction from element ", element + 1, " to element ", next + 1,
         ", expected an angle between them");
}

// ---- pairs of elements ----

// `near`: of coincidence_of.
bool same_point(double ax, double ay, double bx, double by, double near) {
  return fabs(ax - bx) <= near && fabs(ay - by) <= near;
}

// Are these the two points of a linear element?
bool joined(const Model& m, int b, int32_t i, int32_t j) {
  for (int32_t r = 0; r < body_of(m, b).regions; ++r) {
    const Region& region = m.region[b][r];
    const int32_t first = geometry_node(m, b, region.first, 0), last = geometry_node(m, b, region.last, 0) + region.open;
    if (i < first || j > last) continue;
    return j == i + 1 || (!region.open && i == first && j == last);
  }
  return false;
}

// All pairs of points and of elements must be compared. A first pass (model/validate/meeting_boxes.hpp) decides quickly whether
// there is any fault; only then are all pairs visited in order, so that messages come in the order of the model. Small code
// omits it.

bool some_coincide(const Model& m, int b, double near) {
  if (kSmallCode) return true;
  const double half = 0.6 * near; // slightly more than half the tolerance: boxes of coincident points overlap for certain
  const auto box_of = [&](int32_t i) {
    const double* p = m.xy[b] + 2 * static_cast<int64_t>(i);
    return Box{p[0] - half, p[0] + half, p[1] - half, p[1] + half};
  };
  const IndexRange all{0, body_of(m, b).geometry_nodes};
  return visit_meeting(all, all, box_of, [&](int32_t i, int32_t j) {
    return i != j && !(body_of(m, b).element_nodes == 2 && joined(m, b, i, j));
  });
}

// Boundary points of a body must be distinct, except the two of a double node.
int32_t check_coincidence(const Model& m, int b, Reporter& reporter) {
  const Body& body = body_of(m, b);
  int32_t found = 0;
  const double near = coincidence_of(m, b);
  if (!some_coincide(m, b, near)) return found;
  for (int32_t i = 0; i < body.geometry_nodes; ++i) {
    const double* p = m.xy[b] + 2 * i;
    for (int32_t j = i + 1; j < body.geometry_nodes; ++j) {
      const double* q = m.xy[b] + 2 * j;
      if (!same_point(p[0], p[1], q[0], q[1], near)) continue;
      if (body.element_nodes == 2 && joined(m, b, i, j)) continue; // an element of zero length: has its own check
      Finding f(at_point(m, b, j));
      say(f, "boundary points ", i + 1, " and ", j + 1, " of body ", body_named(m, b), " coincide at (", p[0], ", ", p[1],
          "), expected different points");
      report_some(f, found, reporter);
    }
  }
  return found;
}

// Do the polylines of two elements meet elsewhere than at the point that joins them? after, before: the
// second element begins where the first ends, or ends where the first begins.
bool elements_cross(const Chords& p, const Chords& q, bool after, bool before) {
  for (int i = 0; i < p.count; ++i) {
    for (int j = 0; j < q.count; ++j) {
      if ((after && i == p.count - 1 && j == 0) || (before && i == 0 && j == q.count - 1)) continue;
      const double p0[2] = {p.x[i], p.y[i]}, p1[2] = {p.x[i + 1], p.y[i + 1]};
      const double q0[2] = {q.x[j], q.y[j]}, q1[2] = {q.x[j + 1], q.y[j + 1]};
      if (chords_cross(p0, p1, q0, q1)) return true;
    }
  }
  return false;
}

// Fast test for neighbours: if all chords of two joined elements advance in one direction they cannot cross. It decides nearly
// all cases on real boundaries; small code omits it. Does every chord advance along d, by more than rounding?
bool advances(const Chords& c, const double d[2]) {
  double most = 0, least = HUGE_VAL;
  for (int i = 0; i <= c.count; ++i) most = fmax(most, fmax(fabs(c.x[i]), fabs(c.y[i])));
  for (int i = 0; i < c.count; ++i) least = fmin(least, (c.x[i + 1] - c.x[i]) * d[0] + (c.y[i + 1] - c.y[i]) * d[1]);
  return least > 1e-13 * most * hypot(d[0], d[1]);
}

// The direction from the start of one polyline to the end of the next.
bool advance_together(const Chords& p, const Chords& q) {
  const double d[2] = {q.x[q.count] - p.x[0], q.y[q.count] - p.y[0]};
  return advances(p, d) && (&p == &q || advances(q, d));
}

Box box_around_chords(const Chords& c) {
  Box out{c.x[0], c.x[0], c.y[0], c.y[0]};
  for (int i = 1; i <= c.count; ++i) widen(out, Box{c.x[i], c.x[i], c.y[i], c.y[i]});
  return out;
}

bool crosses_itself(const Chords& c) {
  if (!kSmallCode && advance_together(c, c)) return false;
  for (int i = 0; i < c.count; ++i) {
    for (int j = i + 2; j < c.count; ++j) {
      const double p0[2] = {c.x[i], c.y[i]}, p1[2] = {c.x[i + 1], c.y[i + 1]};
      const double q0[2] = {c.x[j], c.y[j]}, q1[2] = {c.x[j + 1], c.y[j + 1]};
      if (chords_cross(p0, p1, q0, q1)) return true;
    }
  }
  return false;
}

// Enlarged by the rounding of the coordinates.
Box widened(const Box& b) {
  const double by = 1e-14 * fmax(fmax(fabs(b.x_min), fabs(b.x_max)), fmax(fabs(b.y_min), fabs(b.y_max)));
  return Box{b.x_min - by, b.x_max + by, b.y_min - by, b.y_max + by};
}

bool pair_crosses(const Chords& p, const Chords& q, double near) {
  // Joined directly or through a double node; comparing positions covers both.
  const bool after = same_point(p.x[p.count], p.y[p.count], q.x[0], q.y[0], near);
  const bool before = same_point(p.x[0], p.y[0], q.x[q.count], q.y[q.count], near);
  if (!kSmallCode && after != before && advance_together(after ? p : q, after ? q : p)) return false;
  if (!kSmallCode && !after && !before && !boxes_meet(box_around_chords(p), widened(box_around_chords(q)))) return false;
  return elements_cross(p, q, after, before);
}

bool some_cross(const Model& m, int b, double near) {
  if (kSmallCode) return true;
  Chords p, q;
  int32_t last = -1; // element whose chords p stores
  const IndexRange all{0, body_of(m, b).elements};
  return visit_meeting(
      all, all, [&](int32_t i) { return box_around(m, b, i); },
      [&](int32_t i, int32_t j) {
        if (is_zero_length(m, b, i) || is_zero_length(m, b, j)) return false;
        if (i != last) chords_of(m, b, i, p);
        last = i;
        if (i == j) return crosses_itself(p);
        chords_of(m, b, j, q);
        return pair_crosses(p, q, near);
      });
}

void check_crossing(const Model& m, int b, Reporter& reporter) {
  const int32_t elements = body_of(m, b).elements;
  int32_t found = 0;
  const double near = coincidence_of(m, b);
  if (!some_cross(m, b, near)) return;
  Chords p, q;
  for (int32_t i = 0; i < elements; ++i) {
    if (is_zero_length(m, b, i)) continue;
    chords_of(m, b, i, p);
    const Box around = box_around(m, b, i);
    for (int32_t j = i; j < elements; ++j) {
      if (!boxes_meet(around, box_around(m, b, j)) || is_zero_length(m, b, j)) continue;
      chords_of(m, b, j, q);
      if (i == j ? !crosses_itself(p) : !pair_crosses(p, q, near)) continue;
      Finding f(at_element(m, b, j));
      if (i == j)
        say(f, "element ", i + 1, " of body ", body_named(m, b), " crosses itself");
      else
        say(f, "elements ", i + 1, " and ", j + 1, " of body ", body_named(m, b), " cross or touch each other");
      say(f, ", expected a boundary without crossings");
      report_some(f, found, reporter);
    }
  }
}

// ---- whole regions ----

void report_region(const Model& m, int b, int32_t region, const char* what, const char* expected, Reporter& reporter) {
  report(reporter, at_element(m, b, m.region[b][region].first), "region ", region + 1, " of body ", body_named(m, b), " ", what,
         ", expected ", expected);
}

int32_t outer_region(const Model& m, int b) {
  int32_t outer = 0;
  double largest = -1;
  for (int32_t r = 0; r < body_of(m, b).regions; ++r) {
    const double area = fabs(region_area(m, b, r));
    if (area <= largest) continue;
    largest = area;
    outer = r;
  }
  return outer;
}

void check_nesting(const Model& m, int b, int32_t outer, int32_t hole, Reporter& reporter) {
  // For an open region not its end, which lies on the closing of the outer boundary along the line of symmetry.
  const Region& curve = m.region[b][hole];
  const CurvePoint middle = curve_point(m, b, curve.first, 0.0);
  const double* corner = m.xy[b] + 2 * geometry_node(m, b, curve.first, 0);
  const double p[2] = {curve.open ? middle.x : corner[0], curve.open ? middle.y : corner[1]};
  if (winding_number(m, b, outer, p[0], p[1]) == 0)
    report_region(m, b, hole, "lies outside the outer boundary", "a hole inside it", reporter);
  for (int32_t r = 0; r < body_of(m, b).regions; ++r) {
    if (r == outer || r == hole || winding_number(m, b, r, p[0], p[1]) == 0) continue;
    report(reporter, at_element(m, b, m.region[b][hole].first), "region ", hole + 1, " of body ", body_named(m, b),
           " lies inside region ", r + 1, ", expected holes side by side");
  }
}

void check_orientation(const Model& m, int b, bool crossings, Reporter& reporter) {
  const int32_t outer = outer_region(m, b);
  for (int32_t r = 0; r < body_of(m, b).regions; ++r) {
    const double area = region_area(m, b, r);
    double half = 0; // half of the perimeter: the length of a degenerate (flat) region
    for (int32_t e = m.region[b][r].first; e <= m.region[b][r].last; ++e) half += 0.5 * element_length(m, b, e);
    if (fabs(area) <= 1e-12 * half * half)
      report_region(m, b, r, "encloses no area", "a closed curve", reporter);
    else if (r == outer && area < 0)
      report_region(m, b, r, "is the outer boundary and runs clockwise", "counter-clockwise, material on the left", reporter);
    else if (r != outer && area > 0)
      report_region(m, b, r, "is a hole and runs counter-clockwise", "clockwise, material on the left", reporter);
    if (r != outer && !crossings) check_nesting(m, b, outer, r, reporter);
  }
}

} // namespace

bool validate_geometry(const Model& m, Reporter& reporter) {
  const int32_t before = reporter.faults;
  for (int b = 0; b < m.head->bodies; ++b) {
    const int32_t start = reporter.faults;
    for (int32_t e = 0; e < body_of(m, b).elements; ++e) {
      if (is_zero_length(m, b, e))
        check_zero_length(m, b, e, reporter);
      else if (body_of(m, b).element_nodes > 2)
        check_jacobian(m, b, e, reporter);
      check_spike(m, b, e, reporter);
    }
    if (check_coincidence(m, b, reporter) == 0) check_crossing(m, b, reporter);
    check_orientation(m, b, reporter.faults != start, reporter);
  }
  return reporter.faults == before;
}

} // namespace c2d
