// New boundary points of a matching zone. Where the two surfaces coincide, each side interpolates from its own adjacent points,
// which differ beyond the zone; this file makes the new points of both sides consistent.
#include "program/estimate/mesh/cut_body.hpp"

#include <cmath>

namespace estimate {
namespace {

// Times the length of an element: ends this close coincide, as where the library sets all gaps of a zone to zero
// (METHOD 8.3).
constexpr double kOnePoint = 1e-5;

Point between(Point a, Point b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }

// One element of each side with its boundary points, those of side 2 in reverse order.
struct FacingElements {
  int32_t element[2];
  std::vector<Point> p[2];
  // Position of the new point after point i, in the order of side 1.
  static size_t place(const CutBody& body, int32_t element, int32_t i) {
    const int32_t region = body.region_of(element), chords = body.element_nodes - 1;
    const int32_t open = body.first_point(region, element) - element * chords;
    return CutBody::at(body.children[CutBody::at(element)] * chords + open + 2 * i + 1);
  }
};

// From side 1 to side 2 along the normal out of side 1.
double gap(const FacingElements& f, Point a, Point b) {
  const Point first = f.p[0].front(), last = f.p[0].back();
  const double length = distance(first, last);
  return ((b.x - a.x) * (last.y - first.y) - (b.y - a.y) * (last.x - first.x)) / length;
}

void match(const FacingElements& f, int32_t i, bool overlaps, Point& a, bool sure_a, Point& b, bool sure_b) {
  const double near = kOnePoint * distance(f.p[0].front(), f.p[0].back());
  const size_t k = CutBody::at(i);
  const bool one = distance(f.p[0][k], f.p[1][k]) <= near && distance(f.p[0][k + 1], f.p[1][k + 1]) <= near;
  const bool overlap = !overlaps && gap(f, a, b) < 0;
  if (!one && !overlap) return;
  // (Touching in whatever direction the gap is measured.)
  const Point common = sure_a == sure_b || !one ? between(a, b) : sure_a ? a : b;
  a = b = common;
}

} // namespace

void match_points(const c2d_zone& zone, const std::vector<CutBody>& bodies, bool overlaps, std::vector<CutPoints>& points) {
  const c2d_side* const side[2] = {&zone.side1, &zone.side2};
  const CutBody* body[2];
  std::vector<int32_t> elements[2];
  bool up[2];
  for (int s = 0; s < 2; ++s) {
    body[s] = &bodies[CutBody::at(side[s]->body - 1)];
    up[s] = goes_up(*body[s], zone, s + 1);
    elements[s] = elements_of(*body[s], {side[s]->first_element - 1, side[s]->last_element - 1}, up[s]);
  }
  if (body[0]->element_nodes != body[1]->element_nodes || up[0] == up[1]) return;
  const int32_t chords = body[0]->element_nodes - 1;
  for (size_t k = 0; k < elements[0].size(); ++k) {
    FacingElements f{{elements[0][k], elements[1][k]}, {}};
    if (body[0]->child_count(f.element[0]) == 1 || body[1]->child_count(f.element[1]) == 1) continue;
    for (int s = 0; s < 2; ++s) f.p[s] = body[s]->points_of(body[s]->region_of(f.element[s]), f.element[s]);
    f.p[1] = std::vector<Point>(f.p[1].rbegin(), f.p[1].rend());
    for (int32_t i = 0; i < chords; ++i) {
      const size_t at[2] = {FacingElements::place(*body[0], f.element[0], i),
                            FacingElements::place(*body[1], f.element[1], chords - 1 - i)};
      CutPoints &one = points[CutBody::at(side[0]->body - 1)], &two = points[CutBody::at(side[1]->body - 1)];
      match(f, i, overlaps, one.points[at[0]], one.sure[at[0]], two.points[at[1]], two.sure[at[1]]);
    }
  }
}

} // namespace estimate
