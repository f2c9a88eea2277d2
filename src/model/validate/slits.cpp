// Finds slits narrower than half an element.
//
// For two elements whose outward normals are opposite and point at each other, the width is the distance from the middle of the
// shorter one to the longer one; for an element beside a line of symmetry of its body it is twice the distance from the line.
// Elements that share a point are the two sides of a notch and are skipped.
#include "model/validate/slits.hpp"

#include "memory/math.hpp"
#include "model/symmetry.hpp"
#include "model/validate/meeting_boxes.hpp"
#include "model/validate/validate_finding.hpp"

namespace c2d {

namespace {

constexpr double kPart = 0.5;      // of the longer element: a wider slit costs less than the mesh at its tip does
constexpr double kOpposite = 0.97; // cosine of 14 degrees: a wider angle between the faces is a notch

struct Slit {
  int32_t element = -1, other = -1; // the longer element; the one opposite, -1: its image
  double width = 0.0, length = 0.0; // of the slit there; of the longer element
};

void keep_narrower(Slit& worst, const Slit& s) {
  if (s.width >= kPart * s.length) return;
  if (worst.element < 0 || s.width * worst.length < (1.0 - 1e-9) * worst.width * s.length) worst = s;
}

// From the first to the last point of an element. Slits are narrow beside what elements are curved.
struct Chord {
  double x, y, dx, dy;
  double square() const { return dx * dx + dy * dy; }
  double length() const { return sqrt(square()); }
};

Chord chord_of(const Model& m, int b, int32_t e) {
  const double* from = m.xy[b] + 2 * geometry_node(m, b, e, 0);
  const double* to = m.xy[b] + 2 * geometry_node(m, b, e, m.body[b].element_nodes - 1);
  return Chord{from[0], from[1], to[0] - from[0], to[1] - from[1]};
}

// Its bounding box and half of what makes a slit, so that the boxes of the two faces meet.
Box reach_of(const Model& m, int b, int32_t e) {
  const Chord c = chord_of(m, b, e);
  const double by = kPart * c.length();
  return Box{fmin(c.x, c.x + c.dx) - by, fmax(c.x, c.x + c.dx) + by, fmin(c.y, c.y + c.dy) - by, fmax(c.y, c.y + c.dy) + by};
}

bool are_opposite(const Chord& a, const Chord& b) {
  return a.dx * b.dx + a.dy * b.dy < -kOpposite * a.length() * b.length(); // (squares of products would overflow)
}

bool are_neighbours(const Model& m, int b, int32_t i, int32_t j) {
  return element_after(m, b, i) == j || element_after(m, b, j) == i;
}

bool may_touch(const Model& m, int b, int32_t i, int32_t j) {
  ZonePlace a, c;
  return find_contact_element(m, b, i, &a) && find_contact_element(m, b, j, &c) && a.zone == c.zone && a.side != c.side;
}

void look_across(const Model& m, int b, int32_t i, int32_t j, Slit& worst) {
  const Chord one = chord_of(m, b, i), two = chord_of(m, b, j);
  if (!are_opposite(one, two) || are_neighbours(m, b, i, j)) return;
  if (!is_integrated(m, b, i) || !is_integrated(m, b, j)) return;
  const bool first = one.square() < two.square();
  const Chord &shorter = first ? one : two, &longer = first ? two : one;
  const double x = shorter.x + 0.5 * shorter.dx, y = shorter.y + 0.5 * shorter.dy; // its middle
  // The outward normal is (dy, -dx). To the left of the longer one there is material between them.
  if ((x - longer.x) * longer.dy - (y - longer.y) * longer.dx <= 0.0 || may_touch(m, b, i, j)) return;
  keep_narrower(worst, {first ? j : i, first ? i : j, distance_to_element(m, b, first ? j : i, x, y), longer.length()});
}

void look_at_image(const Model& m, int b, int32_t e, Slit& worst) {
  const Chord c = chord_of(m, b, e);
  const double middle[2] = {c.x + 0.5 * c.dx, c.y + 0.5 * c.dy}, normal[2] = {c.dy, -c.dx}, length = c.length();
  for (int k = 0; k < 2; ++k) {
    const double across = m.head->line_at[k] - middle[k];
    if ((image_lines(m, b) >> k & 1) != 0 && normal[k] * across > 0.0 && fabs(normal[k]) > kOpposite * length)
      keep_narrower(worst, {e, -1, 2.0 * fabs(across), length});
  }
}

Slit narrowest(const Model& m, int b) {
  Slit worst;
  const IndexRange all{0, m.body[b].elements};
  const auto reach = [&](int32_t e) { return reach_of(m, b, e); };
  visit_meeting(all, all, reach, [&](int32_t i, int32_t j) {
    if (i != j) look_across(m, b, i, j, worst);
    return false;
  });
  for (int32_t e = 0; e < m.body[b].elements && image_lines(m, b) != 0; ++e)
    if (is_integrated(m, b, e)) look_at_image(m, b, e, worst);
  return worst;
}

} // namespace

void warn_slits(const Model& m, Reporter& reporter) {
  if (kSmallCode || m.head->function_nodes != 2) return;
  for (int b = 0; b < m.head->bodies; ++b) {
    if (is_rigid(m, b) || is_platen(m, b)) continue;
    const Slit s = narrowest(m, b);
    if (s.element < 0) continue;
    Finding f(C2D_WARN_SLIT, in_body(b));
    f.entry.element = s.element + 1;
    put_all(f.text, "body ", body_named(m, b), ": element ", s.element + 1, ", ", s.length, " long, lies beside a slit ");
    put(f.text, s.width, 3);
    if (s.other < 0)
      put(f.text, " wide, opposite its image");
    else
      put_all(f.text, " wide, opposite element ", s.other + 1);
    put(f.text, ": linear functions open it too little, by about 1 to 2 elements' share of its length; take 3 functional "
                "nodes, or elements as short as it is wide");
    report(reporter, f);
  }
}

} // namespace c2d
