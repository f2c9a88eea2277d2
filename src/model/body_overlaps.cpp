// Finds bodies that overlap outside their contact zones.
//
// Phases: bounding boxes exclude most pairs of bodies; element ends of one body inside the box of the other, and in no zone
// between the two, are tested against its boundary as a polygon of chords: crossing number for inside, smallest distance to a
// chord for the depth. The deepest point is reported. Chords instead of curves are accurate enough because depths below a
// fraction of an element are ignored: touching curves overlap by that much as polygons.
#include "model/body_overlaps.hpp"

#include "memory/math.hpp"
#include "model/geometry.hpp"
#include "model/validate/validate_finding.hpp"

namespace c2d {

namespace {

// A model in its undeformed or deformed state: `start` gives the position of the first node of an element.
struct Moved {
  const Model& m;
  ElementStart start;
  const void* context;
  void at(int b, int32_t element, double p[2]) const { start(context, m, b, element, p); }
};

// Bounding box of the element ends of a body.
Box box_of(const Moved& moved, int b) {
  double p[2];
  moved.at(b, 0, p);
  Box box{p[0], p[0], p[1], p[1]};
  for (int32_t e = 1; e < moved.m.body[b].elements; ++e) {
    moved.at(b, e, p);
    box = Box{fmin(box.x_min, p[0]), fmax(box.x_max, p[0]), fmin(box.y_min, p[1]), fmax(box.y_max, p[1])};
  }
  return box;
}

double square_to_chord(const double p[2], const double a[2], const double b[2]) {
  const double dx = b[0] - a[0], dy = b[1] - a[1], square = dx * dx + dy * dy;
  const double along = square > 0.0 ? ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square : 0.0;
  const double part = along < 0.0 ? 0.0 : along > 1.0 ? 1.0 : along;
  const double x = p[0] - a[0] - part * dx, y = p[1] - a[1] - part * dy;
  return x * x + y * y;
}

// Even-odd test of a point, chord by chord, with the distance to the nearest chord.
struct Inside {
  const double* p;
  bool odd = false;
  double nearest = HUGE_VAL; // square of the distance

  void add(const double a[2], const double b[2]) {
    if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) odd = !odd;
  }
  void add_boundary(const double a[2], const double b[2]) {
    add(a, b);
    const double square = square_to_chord(p, a, b);
    if (square < nearest) nearest = square;
  }
};

// Depth of a point inside a body, 0: outside. The straight closing of an open region along lines of symmetry counts for the
// inside test, but not for the depth: it is no boundary of the complete body.
double depth_in(const Moved& moved, int b, const double p[2]) {
  const Model& m = moved.m;
  Inside inside{p};
  for (int32_t region = 0; region < m.body[b].regions; ++region) {
    const Region& r = m.region[b][region];
    double from[2], first[2], to[2];
    moved.at(b, r.first, first);
    from[0] = first[0], from[1] = first[1];
    for (int32_t e = r.first + 1; e <= r.last; ++e) {
      moved.at(b, e, to);
      inside.add_boundary(from, to);
      from[0] = to[0], from[1] = to[1];
    }
    double x[3], y[3];
    const int corners = closing_way(m, b, region, x, y);
    if (corners == 0) inside.add_boundary(from, first);
    for (int i = 0; i < corners; ++i) { // the last element, then the closing along the lines
      to[0] = i + 1 < corners ? x[i] : first[0], to[1] = i + 1 < corners ? y[i] : first[1];
      if (i == 0)
        inside.add_boundary(from, to);
      else
        inside.add(from, to);
      from[0] = to[0], from[1] = to[1];
    }
  }
  return inside.odd ? sqrt(inside.nearest) : 0.0;
}

bool have_zone(const Model& m, int a, int b) {
  for (int32_t i = 0; i < m.head->zones; ++i)
    if ((m.zone[i].body[0] == a && m.zone[i].body[1] == b) || (m.zone[i].body[0] == b && m.zone[i].body[1] == a)) return true;
  return false;
}

// Is the point inside the box by more than `by`? A point less deep in the box cannot be deeper in the body.
bool is_within(const Box& box, const double p[2], double by) {
  return p[0] > box.x_min + by && p[0] < box.x_max - by && p[1] > box.y_min + by && p[1] < box.y_max - by;
}

bool is_in_zone(const Model& m, int b, int32_t element, int other) {
  ZonePlace place;
  return find_contact_element(m, b, element, &place) && m.zone[place.zone].body[1 - place.side] == other;
}

// Element ends of a inside b. Both elements at the point must be outside the zones between a and b: in a zone the contact
// conditions decide, and small overlaps are round-off or interference.
void look_inside(const Moved& moved, int a, int b, const Box& box, double part, double least, BodyOverlap& worst) {
  const Model& m = moved.m;
  for (int32_t region = 0; region < m.body[a].regions; ++region)
    for (int32_t e = m.region[a][region].first; e <= m.region[a][region].last; ++e) {
      double p[2];
      moved.at(a, e, p);
      if (!is_within(box, p, least)) continue;
      const double wanted = fmax(least, part * element_length(m, a, e));
      if (!is_within(box, p, wanted)) continue;
      const int32_t before = e > m.region[a][region].first ? e - 1 : m.region[a][region].last;
      if (is_in_zone(m, a, e, b) || is_in_zone(m, a, before, b)) continue;
      const double depth = depth_in(moved, b, p);
      if (depth > wanted && depth > worst.depth) worst = BodyOverlap{{a, b}, depth, p[0], p[1]};
    }
}

double size_of(const Box& box) { return hypot(box.x_max - box.x_min, box.y_max - box.y_min); }

} // namespace

void start_as_made(const void*, const Model& m, int b, int32_t element, double p[2]) {
  const double* xy = m.xy[b] + 2 * geometry_node(m, b, element, 0);
  p[0] = xy[0], p[1] = xy[1];
}

BodyOverlap deepest_overlap(const Model& m, ElementStart start, const void* context, double part, double of_body,
                            bool without_zone_alone) {
  const Moved moved{m, start, context};
  BodyOverlap worst{{0, 0}, 0.0, 0.0, 0.0};
  for (int a = 0; a < m.head->bodies; ++a) {
    if (is_platen(m, a)) continue;
    const Box own = box_of(moved, a);
    for (int b = a + 1; b < m.head->bodies; ++b) {
      if (is_platen(m, b) || (without_zone_alone && have_zone(m, a, b))) continue;
      const Box other = box_of(moved, b);
      if (!boxes_meet(own, other)) continue;
      const double least = of_body * fmin(size_of(own), size_of(other));
      look_inside(moved, a, b, other, part, least, worst);
      look_inside(moved, b, a, own, part, least, worst);
    }
  }
  return worst;
}

Text& put_overlap(Text& text, const Model& m, const BodyOverlap& overlap) {
  put_all(text, "bodies ", body_named(m, overlap.body[0]), " and ", body_named(m, overlap.body[1]), " overlap by ");
  put(text, overlap.depth, 3);
  return put_all(text, " at (", overlap.x, ", ", overlap.y,
                 ") outside any zone between them: contact is checked in zones only; define a zone there");
}

void warn_overlapping_bodies(const Model& m, Reporter& reporter) {
  constexpr double kMost = 0.02; // of an element: polygons of chords of touching curves overlap by up to this much
  if (kSmallCode) return;
  const BodyOverlap found = deepest_overlap(m, start_as_made, nullptr, kMost, 0.0, true);
  if (found.depth == 0.0) return;
  Finding f(C2D_WARN_OVERLAPPING, in_body(found.body[0]));
  put_overlap(f.text, m, found);
  report(reporter, f);
}

} // namespace c2d
