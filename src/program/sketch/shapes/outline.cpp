#include "program/sketch/shapes/region.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {

bool Side::has(const std::string& name) const { return std::find(names.begin(), names.end(), name) != names.end(); }

bool same_target(const Drive& a, const Drive& b) {
  if (a.body != b.body || a.side.has_value() != b.side.has_value()) return false;
  return !a.side || std::is_permutation(a.side->names.begin(), a.side->names.end(), b.side->names.begin(), b.side->names.end());
}

namespace {

constexpr double kOverlap = 1e-5, kTieOverlap = 0.01, kPressFit = 0.05; // of the size of the smaller body

int corners_on(const Shape& shape) { return shape.form() == Form::kLine ? 1 : 48 + 2 * shape.pieces(); }

std::string text_of(Point p) { return "(" + rounded(p.x) + ", " + rounded(p.y) + ")"; }

std::string text_of(const Curve& curve) {
  return curve.name.empty() ? std::string("a curve") : "curve " + in_quotes(curve.name);
}

// A side of a polygon and the curve it belongs to.
struct Chord {
  Point a, b;
  const Curve* curve;
  size_t outline, index; // of the curve in it
};

std::vector<Chord> chords_of(const Body& body) {
  std::vector<Chord> out;
  for (size_t o = 0; o < body.outlines.size(); ++o)
    for (size_t i = 0; i < body.outlines[o].curves.size(); ++i) {
      const Curve& curve = body.outlines[o].curves[i];
      const int n = corners_on(*curve.shape);
      for (int k = 0; k < n; ++k)
        out.push_back(
            {curve.shape->at(static_cast<double>(k) / n), curve.shape->at(static_cast<double>(k + 1) / n), &curve, o, i});
    }
  return out;
}

// Do two chords cross at an interior point of both?
bool cross_at(const Chord& p, const Chord& q, Point& at) {
  if (std::max(p.a.x, p.b.x) < std::min(q.a.x, q.b.x) || std::max(q.a.x, q.b.x) < std::min(p.a.x, p.b.x)) return false;
  if (std::max(p.a.y, p.b.y) < std::min(q.a.y, q.b.y) || std::max(q.a.y, q.b.y) < std::min(p.a.y, p.b.y)) return false;
  const Point d = p.b - p.a, e = q.b - q.a;
  const double det = cross(d, e);
  if (std::fabs(det) <= 1e-12 * length(d) * length(e)) return false;
  const double s = cross(q.a - p.a, e) / det, t = cross(q.a - p.a, d) / det;
  at = p.a + s * d;
  return s > 1e-9 && s < 1 - 1e-9 && t > 1e-9 && t < 1 - 1e-9;
}

class Check {
public:
  explicit Check(const Sketch& sketch) : s_(sketch) {}
  std::vector<Fault> run() {
    for (const Body& body : s_.bodies) {
      const size_t before = faults_.size();
      for (const Outline& outline : body.outlines) check_outline(body, outline);
      for (const Outline& outline : body.outlines)
        if (faults_.size() == before) check_symmetry(body, outline);
      if (faults_.size() == before) check_crossings(body);
      for (const Outline& outline : body.outlines)
        if (faults_.size() == before) check_direction(body, outline);
      if (faults_.size() == before) check_holes(body);
      if (faults_.size() == before) sound_.push_back(&body);
    }
    std::vector<Region> regions;
    for (const Body* body : sound_) regions.emplace_back(s_, *body);
    for (size_t i = 0; i < sound_.size(); ++i)
      for (size_t j = i + 1; j < sound_.size(); ++j)
        if (!regions[i].is_apart(regions[j])) check_overlap(*sound_[i], regions[i], *sound_[j], regions[j]);
    return faults_;
  }

private:
  void fault(Place at, const std::string& text) { faults_.push_back({at, text}); }
  bool is_on_symmetry(Point p, double size) const {
    return (s_.symmetry[0] && std::fabs(p.x - *s_.symmetry[0]) < kJoint * size) ||
           (s_.symmetry[1] && std::fabs(p.y - *s_.symmetry[1]) < kJoint * size);
  }
  void check_outline(const Body& body, const Outline& outline);
  void check_direction(const Body& body, const Outline& outline);
  void check_crossings(const Body& body);
  void check_holes(const Body& body);
  void check_nesting(const Body& body, const Outline& inner);
  void check_symmetry(const Body& body, const Outline& outline);
  void check_overlap(const Body& a, const Region& first, const Body& b, const Region& second);

  const Sketch& s_;
  std::vector<Fault> faults_;
  std::vector<const Body*> sound_;
};

void Check::check_outline(const Body& body, const Outline& outline) {
  const std::vector<Point> polygon = polygon_of(outline);
  const double size = size_of(polygon);
  for (const Curve& curve : outline.curves)
    if (!(Measure(curve.shape).length() > kJoint * size))
      return fault(curve.at, "body " + in_quotes(body.name) + ": " + text_of(curve) + " has length zero");
  for (size_t i = 0; i < outline.curves.size(); ++i) {
    const bool last = i + 1 == outline.curves.size();
    if (last && outline.open) continue;
    const Curve &from = outline.curves[i], &to = outline.curves[last ? 0 : i + 1];
    const Point end = from.shape->at(1), begin = to.shape->at(0);
    if (length(end - begin) <= kJoint * size) continue;
    return fault(last ? from.at : to.at, "body " + in_quotes(body.name) + ": the outline is open: " + text_of(from) +
                                             " ends at " + text_of(end) + ", " + text_of(to) + " begins at " + text_of(begin) +
                                             "; the gap is " + rounded(length(end - begin)));
  }
}

void Check::check_direction(const Body& body, const Outline& outline) {
  const double area = outline.open ? Region(s_, body).area() : area_of(polygon_of(outline)); // of all outlines if they are open
  if ((area > 0) == (outline.hole && !outline.open))
    fault(outline.at, "body " + in_quotes(body.name) + ": " +
                          (outline.hole ? "the hole is drawn counter-clockwise, expected clockwise"
                                        : "the outline is drawn clockwise, expected counter-clockwise") +
                          ", with the material on the left");
}

void Check::check_crossings(const Body& body) {
  const std::vector<Chord> chords = chords_of(body);
  for (size_t i = 0; i < chords.size(); ++i)
    for (size_t j = i + 1; j < chords.size(); ++j) {
      Point at;
      if (!cross_at(chords[i], chords[j], at)) continue;
      return fault(chords[j].curve->at, "body " + in_quotes(body.name) + ": " + text_of(*chords[j].curve) + " crosses " +
                                            (chords[i].curve == chords[j].curve ? "itself" : text_of(*chords[i].curve)) +
                                            " near " + text_of(at));
    }
}

void Check::check_holes(const Body& body) {
  for (const Outline& hole : body.outlines) {
    if (!hole.hole) {
      check_nesting(body, hole);
      continue;
    }
    const Point p = hole.curves.front().shape->at(0);
    const bool inside = std::any_of(body.outlines.begin(), body.outlines.end(), [&](const Outline& outline) {
      return !outline.hole && (outline.open || holds(polygon_of(outline), p));
    });
    if (!inside) fault(hole.at, "body " + in_quotes(body.name) + ": the hole lies outside the outline of the body");
  }
}

// An outline inside another outline must be declared as a hole.
void Check::check_nesting(const Body& body, const Outline& inner) {
  for (const Outline& outer : body.outlines)
    if (&outer != &inner && !outer.open && !outer.hole && holds(polygon_of(outer), inner.curves.front().shape->at(0.5)))
      return fault(inner.at, "body " + in_quotes(body.name) + ": the outline lies inside the outline of line " +
                                 std::to_string(outer.at.line) + ", expected a statement 'hole' before it");
}

// The outline must lie on one side of a line of symmetry and must not run along it.
void Check::check_symmetry(const Body& body, const Outline& outline) {
  const std::vector<Point> polygon = polygon_of(outline);
  const double near = kJoint * size_of(polygon);
  const auto across = [](Point p, size_t axis) { return axis == 0 ? p.x : p.y; };
  for (size_t axis = 0; axis < 2; ++axis) {
    if (!s_.symmetry[axis]) continue;
    const bool is_axis = axis == 0 && s_.axisymmetric;
    const std::string line =
        std::string(is_axis ? "axis " : "line of symmetry ") + (axis == 0 ? "x = " : "y = ") + show(*s_.symmetry[axis]);
    bool below = false, above = false;
    for (const Point& p : polygon) {
      below = below || across(p, axis) < *s_.symmetry[axis] - near;
      above = above || across(p, axis) > *s_.symmetry[axis] + near;
    }
    if (below && (above || is_axis))
      return fault(outline.at,
                   "body " + in_quotes(body.name) + ": the outline crosses the " + line +
                       (is_axis ? ", expected a half section at x >= 0" : ", expected only the part on one side of it"));
    for (const Curve& curve : outline.curves) {
      const auto is_on = [&](double u) { return std::fabs(across(curve.shape->at(u), axis) - *s_.symmetry[axis]) <= near; };
      if (is_on(0) && is_on(0.5) && is_on(1))
        return fault(curve.at, "body " + in_quotes(body.name) + ": " + text_of(curve) + " lies on the " + line +
                                   "; do not draw this curve: the outline must begin and end on the line");
    }
  }
}

// The largest depth of boundary points of one body inside the other. Tied surfaces may overlap slightly: the tie closes this.
void Check::check_overlap(const Body& a, const Region& first, const Body& b, const Region& second) {
  const bool is_tied = std::any_of(s_.interfaces.begin(), s_.interfaces.end(), [&](const Interface& i) {
    const Body &p = s_.bodies[static_cast<size_t>(i.side[0].body)], &q = s_.bodies[static_cast<size_t>(i.side[1].body)];
    return i.tied && ((&p == &a && &q == &b) || (&p == &b && &q == &a));
  });
  const double size = std::min(first.size(), second.size());
  double deepest = 0;
  Point where;
  for (const auto& [in, of] : {std::pair(&first, &second), std::pair(&second, &first)})
    for (const Point& p : of->points()) {
      const double depth = in->may_contain(p) ? in->depth(p) : 0;
      if (depth > deepest) deepest = depth, where = p;
    }
  if (deepest > (s_.interference ? kPressFit : is_tied ? kTieOverlap : kOverlap) * size)
    fault(b.at, "bodies " + in_quotes(a.name) + " and " + in_quotes(b.name) + " overlap by " + rounded(deepest) + " at " +
                    text_of(where));
}

} // namespace

std::vector<Point> polygon_of(const Outline& outline) {
  std::vector<Point> out;
  for (const Curve& curve : outline.curves) {
    const int n = corners_on(*curve.shape);
    for (int k = 0; k < n; ++k) out.push_back(curve.shape->at(static_cast<double>(k) / n));
  }
  if (outline.open) out.push_back(outline.curves.back().shape->at(1));
  return out;
}

double area_of(const std::vector<Point>& polygon) {
  double sum = 0;
  for (size_t i = 0; i < polygon.size(); ++i)
    sum += cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]) / 2;
  return sum;
}

bool holds(const std::vector<Point>& polygon, Point p) {
  bool inside = false;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

double size_of(const std::vector<Point>& polygon) {
  const Point extent = app::extent_of(polygon);
  return std::max(extent.x, extent.y);
}

std::vector<Fault> faults_of_shapes(const Sketch& sketch) { return Check(sketch).run(); }

} // namespace sketch
