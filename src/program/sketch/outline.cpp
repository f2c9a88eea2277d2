#include "program/sketch/outline.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {

bool Side::has(const std::string& name) const { return std::find(names.begin(), names.end(), name) != names.end(); }

namespace {

int corners_on(const Shape& shape) { return shape.form() == Form::kLine ? 1 : 48 + 2 * shape.pieces(); }

std::string told(Point p) { return "(" + show(p.x) + ", " + show(p.y) + ")"; }

std::string told(const Curve& curve) { return curve.name.empty() ? std::string("a curve") : "curve " + quoted(curve.name); }

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

// Do two chords cross at a point inside both?
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
      if (faults_.size() == before) check_crossings(body);
      for (const Outline& outline : body.outlines)
        if (faults_.size() == before) check_direction(body, outline);
      if (faults_.size() == before) check_holes(body);
      if (faults_.size() == before) sound_.push_back(&body);
    }
    for (size_t i = 0; i < sound_.size(); ++i)
      for (size_t j = i + 1; j < sound_.size(); ++j) check_overlap(*sound_[i], *sound_[j]);
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
  void check_overlap(const Body& a, const Body& b);

  const Sketch& s_;
  std::vector<Fault> faults_;
  std::vector<const Body*> sound_;
};

void Check::check_outline(const Body& body, const Outline& outline) {
  const std::vector<Point> polygon = polygon_of(outline);
  const double size = size_of(polygon);
  for (const Curve& curve : outline.curves)
    if (!(Measure(curve.shape).length() > kJoint * size))
      return fault(curve.at, "body " + quoted(body.name) + ": " + told(curve) + " has no length");
  for (size_t i = 0; i < outline.curves.size(); ++i) {
    const bool last = i + 1 == outline.curves.size();
    if (last && outline.open) continue;
    const Curve &from = outline.curves[i], &to = outline.curves[last ? 0 : i + 1];
    const Point end = from.shape->at(1), begin = to.shape->at(0);
    if (length(end - begin) <= kJoint * size) continue;
    return fault(last ? from.at : to.at, "body " + quoted(body.name) + ": the outline is open: " + told(from) + " ends at " +
                                             told(end) + ", " + told(to) + " begins at " + told(begin) + ", " +
                                             show(length(end - begin)) + " from there");
  }
}

void Check::check_direction(const Body& body, const Outline& outline) {
  if (outline.open) return;
  const double area = area_of(polygon_of(outline));
  if ((area > 0) == outline.hole)
    fault(outline.at, "body " + quoted(body.name) + ": " +
                          (outline.hole ? "the hole runs counter-clockwise, expected clockwise"
                                        : "the outline runs clockwise, expected counter-clockwise") +
                          ", with the material on the left");
}

void Check::check_crossings(const Body& body) {
  const std::vector<Chord> chords = chords_of(body);
  for (size_t i = 0; i < chords.size(); ++i)
    for (size_t j = i + 1; j < chords.size(); ++j) {
      Point at;
      if (!cross_at(chords[i], chords[j], at)) continue;
      return fault(chords[j].curve->at, "body " + quoted(body.name) + ": " + told(*chords[j].curve) + " crosses " +
                                            (chords[i].curve == chords[j].curve ? "itself" : told(*chords[i].curve)) +
                                            " near " + told(at));
    }
}

void Check::check_holes(const Body& body) {
  for (const Outline& hole : body.outlines) {
    if (!hole.hole) continue;
    const Point p = hole.curves.front().shape->at(0);
    const bool inside = std::any_of(body.outlines.begin(), body.outlines.end(), [&](const Outline& outline) {
      return !outline.hole && (outline.open || holds(polygon_of(outline), p));
    });
    if (!inside) fault(hole.at, "body " + quoted(body.name) + ": the hole lies outside its outline");
  }
}

// Lie the boxes around two bodies apart? Of many bodies most do.
bool are_apart(const Body& a, const Body& b) {
  Point low[2], high[2];
  for (const int i : {0, 1}) {
    low[i] = {HUGE_VAL, HUGE_VAL}, high[i] = {-HUGE_VAL, -HUGE_VAL};
    for (const Outline& outline : (i == 0 ? a : b).outlines)
      for (const Point& p : polygon_of(outline)) {
        low[i] = {std::min(low[i].x, p.x), std::min(low[i].y, p.y)};
        high[i] = {std::max(high[i].x, p.x), std::max(high[i].y, p.y)};
      }
  }
  return high[0].x < low[1].x || high[1].x < low[0].x || high[0].y < low[1].y || high[1].y < low[0].y;
}

// How deep corners of one body's polygon lie in the other's: more than the polygons' own doubt.
void Check::check_overlap(const Body& a, const Body& b) {
  if (are_apart(a, b)) return;
  const auto is_inside = [](const Body& body, Point p) {
    bool inside = false;
    for (const Outline& outline : body.outlines) {
      if (outline.open) return false;
      if (holds(polygon_of(outline), p)) inside = !outline.hole ? true : false;
    }
    return inside;
  };
  for (const auto& [in, of] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    const std::vector<Chord> walls = chords_of(*in);
    double deepest = 0;
    Point where;
    double size = 0;
    for (const Outline& outline : in->outlines) size = std::max(size, size_of(polygon_of(outline)));
    for (const Chord& chord : chords_of(*of)) {
      if (!is_inside(*in, chord.a)) continue;
      double depth = HUGE_VAL;
      for (const Chord& wall : walls) {
        const Point d = wall.b - wall.a;
        const double t = std::clamp(dot(chord.a - wall.a, d) / dot(d, d), 0.0, 1.0);
        depth = std::min(depth, length(chord.a - (wall.a + t * d)));
      }
      if (depth > deepest) deepest = depth, where = chord.a;
    }
    if (deepest > 0.01 * size)
      return fault(b.at, "bodies " + quoted(a.name) + " and " + quoted(b.name) + " overlap by " + show(deepest) + " at " +
                             told(where));
  }
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
  Point low = polygon.front(), high = low;
  for (const Point& p : polygon) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return std::max(high.x - low.x, high.y - low.y);
}

std::vector<Fault> faults_of_shapes(const Sketch& sketch) { return Check(sketch).run(); }

} // namespace sketch
