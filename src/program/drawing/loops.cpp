#include "program/drawing/loops.hpp"

#include "program/drawing/course.hpp"
#include "program/drawing/crossings.hpp"
#include "program/drawing/graph.hpp"
#include "program/drawing/text.hpp"
#include "program/sketch/shapes/outline.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

namespace drawing {
namespace {

constexpr size_t kMostNotes = 20; // of one sort

// Notes of one sort: the first ones in full, the others by their number.
class Notes {
public:
  Notes(std::vector<std::string>& out, std::string more) : out_(out), more_(std::move(more)) {}
  ~Notes() {
    if (count_ > kMostNotes) out_.push_back("and " + std::to_string(count_ - kMostNotes) + more_);
  }
  Notes(const Notes&) = delete;
  Notes& operator=(const Notes&) = delete;
  void add(const std::string& text) {
    if (++count_ <= kMostNotes) out_.push_back(text);
  }
  bool only_counts() { // and has counted one more
    if (count_ < kMostNotes) return false;
    ++count_;
    return true;
  }

private:
  std::vector<std::string>& out_;
  std::string more_;
  size_t count_ = 0;
};

double rough_length(const Curve& curve) {
  std::vector<Point> points;
  append_polygon(points, curve);
  points.push_back(curve.end);
  double sum = 0;
  for (size_t i = 1; i < points.size(); ++i) sum += sketch::length(points[i] - points[i - 1]);
  return sum;
}

// Takes out what has no length; halves of what ends where it begins.
std::vector<Curve> with_length(const std::vector<Curve>& curves, double tolerance, std::vector<std::string>& notes) {
  std::vector<Curve> out;
  Notes repeated(notes, " other curves without length were left out");
  for (const Curve& curve : curves) {
    if (!(rough_length(curve) > tolerance)) {
      repeated.add(text_of(curve) + " at " + text_of(curve.begin) + " has no length and was left out");
    } else if (!curve.whole && sketch::length(curve.end - curve.begin) <= tolerance) {
      for (Curve& half : halves(curve)) out.push_back(std::move(half));
    } else {
      out.push_back(curve);
    }
  }
  return out;
}

// Do two curves between the same joints lie on each other?
bool coincide(const Curve& a, const Curve& b, bool same_way, double tolerance) {
  const sketch::ShapePtr p = shape_of(a), q = shape_of(b);
  for (const double u : {0.25, 0.5, 0.75}) { // quarters of different kinds of curves need not lie on each other, middles do
    if (a.kind != b.kind && u != 0.5) continue;
    if (sketch::length(p->at(u) - q->at(same_way ? u : 1 - u)) > tolerance) return false;
  }
  return true;
}

void drop_doubles(Graph& graph, double tolerance, std::vector<std::string>& notes) {
  std::map<std::pair<size_t, size_t>, std::vector<size_t>> between;
  std::vector<bool> kept(graph.curves.size(), true);
  Notes repeated(notes, " other curves coincide with earlier curves");
  for (size_t i = 0; i < graph.curves.size(); ++i) {
    std::vector<size_t>& others = between[std::minmax(graph.ends[i][0], graph.ends[i][1])];
    for (const size_t j : others) {
      if (!coincide(graph.curves[j], graph.curves[i], graph.ends[j][0] == graph.ends[i][0], tolerance)) continue;
      kept[i] = false;
      repeated.add(text_of(graph.curves[i]) + " from " + text_of(graph.curves[i].begin) + " to " +
                   text_of(graph.curves[i].end) + " coincides with " + text_of(graph.curves[j]) + " and was left out");
      break;
    }
    if (kept[i]) others.push_back(i);
  }
  graph.keep(kept);
}

// Is p on a line or an arc, between its ends?
bool is_on(const Curve& c, Point p, double tolerance) {
  if (std::min(sketch::length(p - c.begin), sketch::length(p - c.end)) <= tolerance) return false;
  if (c.kind == Curve::kLine) {
    const Point d = c.end - c.begin;
    const double along = sketch::dot(p - c.begin, d) / sketch::dot(d, d);
    return along > 0 && along < 1 && sketch::length(p - (c.begin + along * d)) <= tolerance;
  }
  if (c.kind != Curve::kArc || std::fabs(sketch::length(p - c.centre) - c.a) > tolerance) return false;
  const Point arm = p - c.centre;
  const double turn = std::atan2(arm.y, arm.x) * 180 / std::acos(-1.0) - c.from;
  const double on = std::fmod(std::fmod(c.sweep > 0 ? turn : -turn, 360) + 360, 360);
  return on < std::fabs(c.sweep);
}

// Every open end, and what is nearest to it.
void note_open_ends(const Graph& graph, double tolerance, std::vector<std::string>& notes) {
  const std::vector<int> count = degrees(graph);
  Notes repeated(notes, " other ends are open");
  for (size_t i = 0; i < graph.curves.size(); ++i)
    for (const size_t e : {size_t{0}, size_t{1}}) {
      const size_t joint = graph.ends[i][e];
      if (count[joint] != 1 || repeated.only_counts()) continue;
      const Point p = graph.joints[joint];
      size_t nearest = joint;
      double distance = HUGE_VAL;
      for (size_t j = 0; j < graph.joints.size(); ++j)
        if (j != joint && j != graph.ends[i][1 - e] && sketch::length(graph.joints[j] - p) < distance)
          distance = sketch::length(graph.joints[j] - p), nearest = j;
      std::string text = text_of(graph.curves[i]) + " has an open end at " + text_of(p);
      if (nearest != joint)
        text += "; the nearest other end is at " + text_of(graph.joints[nearest]) + ", " + text_of(distance) + " away";
      const auto on =
          std::find_if(graph.curves.begin(), graph.curves.end(), [&](const Curve& c) { return is_on(c, p, tolerance); });
      if (on != graph.curves.end()) text += "; it lies on " + text_of(*on) + "; split that curve there";
      repeated.add(text);
    }
}

// Removes curves with an open end, repeatedly, and bridges between loops.
void prune(Graph& graph, std::vector<std::string>& notes) {
  const size_t before = graph.curves.size();
  std::vector<std::vector<size_t>> at(graph.joints.size());
  for (size_t i = 0; i < before; ++i)
    for (const size_t end : graph.ends[i]) at[end].push_back(i);
  std::vector<int> count = degrees(graph);
  std::vector<bool> kept(before, true);
  std::vector<size_t> open;
  for (size_t j = 0; j < count.size(); ++j)
    if (count[j] == 1) open.push_back(j);
  while (!open.empty()) {
    const size_t joint = open.back();
    open.pop_back();
    for (const size_t i : at[joint]) {
      if (!kept[i]) continue;
      kept[i] = false;
      for (const size_t end : graph.ends[i])
        if (--count[end] == 1) open.push_back(end);
    }
  }
  graph.keep(kept);
  std::vector<size_t> face(2 * graph.curves.size());
  const std::vector<std::vector<size_t>> faces = faces_of(graph);
  for (size_t f = 0; f < faces.size(); ++f)
    for (const size_t half : faces[f]) face[half] = f;
  kept.assign(graph.curves.size(), true);
  for (size_t i = 0; i < graph.curves.size(); ++i) kept[i] = face[2 * i] != face[2 * i + 1];
  graph.keep(kept);
  const size_t left_out = before - graph.curves.size();
  if (left_out > 0)
    notes.push_back(std::to_string(left_out) + (left_out == 1 ? " curve is" : " curves are") +
                    " left out: not part of a closed outline");
}

struct Contour { // of curves that are connected: what it looks like from outside, and the faces in it
  std::vector<Point> polygon;
  Loop outside; // as a hole: clockwise
  std::vector<Loop> inside;
  std::vector<std::vector<Point>> polygons; // of those
  Point low, high;                          // the box around it
  double area = 0;
  int depth = 0;
  size_t body = SIZE_MAX, loop = 0; // where its outside is, or its only face
  Course course() const { return Course(outside.curves); }
  double size() const { return std::max(high.x - low.x, high.y - low.y); }
  std::string place() const { // its middle
    const auto rounded = [&](double a, double b) { return std::fabs(a + b) > 1e-9 * size() ? (a + b) / 2 : 0; };
    return text_of(Point{rounded(low.x, high.x), rounded(low.y, high.y)});
  }
};

std::vector<Point> polygon_of(const Loop& loop) {
  std::vector<Point> out;
  for (const Curve& curve : loop.curves) append_polygon(out, curve);
  return out;
}

Contour contour_of(const Curve& whole) {
  Contour c;
  Loop loop;
  loop.curves = {whole};
  c.area = Course(loop.curves).area();
  if (c.area < 0) { // a whole curve is counter-clockwise: the sketch reverses it in a hole
    loop.curves = {reversed(whole)};
    c.area = -c.area;
  }
  c.polygon = polygon_of(loop);
  c.outside = loop;
  c.inside = {loop};
  c.polygons = {c.polygon};
  return c;
}

std::vector<Contour> contours_of(const Graph& graph) {
  std::map<size_t, Contour> contours;
  const std::vector<size_t> part = parts_of(graph);
  for (const std::vector<size_t>& face : faces_of(graph)) {
    Loop loop;
    for (const size_t half : face)
      loop.curves.push_back(half % 2 == 0 ? graph.curves[half / 2] : reversed(graph.curves[half / 2]));
    std::vector<Point> polygon = polygon_of(loop);
    const double area = sketch::area_of(polygon);
    Contour& contour = contours[part[graph.start(face.front())]];
    if (area > 0) {
      contour.inside.push_back(std::move(loop));
      contour.polygons.push_back(std::move(polygon));
    } else {
      contour.outside = std::move(loop);
      contour.polygon = std::move(polygon);
      contour.area = -contour.course().area();
    }
  }
  std::vector<Contour> out;
  for (auto& entry : contours)
    if (!entry.second.inside.empty() && !entry.second.polygon.empty()) out.push_back(std::move(entry.second));
  return out;
}

// Is most of `inner` inside `outer`? Several points are tested, because contours may touch at one.
bool encloses(const std::vector<Point>& outer, const std::vector<Point>& inner) {
  int in = 0, all = 0;
  const size_t step = std::max<size_t>(1, inner.size() / 9);
  for (size_t i = 0; i < inner.size(); i += step, ++all) {
    const Point middle = 0.5 * (inner[i] + inner[(i + 1) % inner.size()]);
    if (sketch::holds(outer, middle)) ++in;
  }
  return 2 * in > all;
}

constexpr double kAlike = 0.9; // area ratio above which polygons are too inaccurate and the curves are used

// Is most of `inner` on the inner side of `outer`?
bool encloses(const Course& outer, const Course& inner) {
  const bool is_left = outer.area() > 0;
  int in = 0, all = 0;
  for (const Point& p : inner.samples(9)) {
    in += outer.nearest(p).is_left == is_left ? 1 : 0;
    ++all;
  }
  return 2 * in > all;
}

bool encloses(const Contour& outer, const Contour& inner) {
  if (inner.high.x < outer.low.x || inner.low.x > outer.high.x || inner.high.y < outer.low.y || inner.low.y > outer.high.y)
    return false;
  return inner.area > kAlike * outer.area ? encloses(outer.course(), inner.course()) : encloses(outer.polygon, inner.polygon);
}

// How far two contours are from each other at most; infinite if they are not alike.
double apart(const Contour& a, const Contour& b) {
  if (std::min(a.area, b.area) <= kAlike * std::max(a.area, b.area)) return HUGE_VAL;
  const double size = a.size();
  const Point low = b.low - a.low, high = b.high - a.high;
  if (std::max({std::fabs(low.x), std::fabs(low.y), std::fabs(high.x), std::fabs(high.y)}) > 0.1 * size) return HUGE_VAL;
  const Course p = a.course(), q = b.course();
  return std::max(p.farthest(q), q.farthest(p));
}

void find_boxes(std::vector<Contour>& contours) {
  for (Contour& c : contours) {
    c.low = c.high = c.polygon.front();
    for (const Point& p : c.polygon) {
      c.low = {std::min(c.low.x, p.x), std::min(c.low.y, p.y)};
      c.high = {std::max(c.high.x, p.x), std::max(c.high.y, p.y)};
    }
  }
}

// One outline drawn twice by other curves, such as a circle and two half circles. Contours come by their areas.
void drop_doubles(std::vector<Contour>& contours, double tolerance, std::vector<std::string>& notes) {
  std::vector<Contour> kept;
  for (Contour& c : contours) {
    bool is_double = false;
    for (size_t j = kept.size(); j-- > 0 && kept[j].area <= c.area * (1 + 1e-3) && !is_double;)
      is_double = apart(kept[j], c) <= tolerance;
    if (is_double)
      notes.push_back("left out: an outline around " + c.place() + " that coincides with another outline");
    else
      kept.push_back(std::move(c));
  }
  contours = std::move(kept);
}

// A hole in the body around it.
void add_hole(Contour& c, const Contour& around, const std::vector<size_t>& bodies, Drawing& drawing) {
  c.outside.hole = true;
  if (c.inside.size() > 1) drawing.notes.push_back("a hole around " + c.place() + " is crossed by curves, which were left out");
  size_t f = 0;
  while (f < bodies.size() && bodies.size() > 1 && !encloses(around.polygons[f], c.polygon)) ++f;
  if (f == bodies.size())
    return drawing.notes.push_back("a hole around " + c.place() + " lies in several bodies and was left out");
  c.body = bodies[f], c.loop = drawing.bodies[c.body].loops.size();
  drawing.bodies[c.body].loops.push_back(c.outside);
}

// The faces of a contour as bodies.
std::vector<size_t> add_bodies(Contour& c, Drawing& drawing) {
  std::vector<size_t> out;
  if (c.inside.size() == 1) c.body = drawing.bodies.size();
  for (const Loop& face : c.inside) {
    out.push_back(drawing.bodies.size());
    drawing.bodies.push_back({"", {face}});
  }
  if (c.inside.size() > 1)
    drawing.notes.push_back(std::to_string(c.inside.size()) +
                            " outlines share curves: each outline is a body, and both bodies have a curve of that name");
  return out;
}

// A pin that nearly fills its hole: the drawing does not show which outline belongs to which body.
void mark_press_fit(const Contour& hole, const Contour& pin, size_t& fits, Drawing& drawing) {
  constexpr double kNear = 0.02; // of the size
  if (hole.body == SIZE_MAX || pin.body == SIZE_MAX || hole.inside.size() != 1) return;
  const double gap = apart(hole, pin);
  if (!(gap <= kNear * hole.size())) return;
  Loop &outer = drawing.bodies[hole.body].loops[hole.loop], &inner = drawing.bodies[pin.body].loops[pin.loop];
  outer.press_fit = pin.outside.curves;
  inner.press_fit = hole.inside[0].curves;
  outer.fit = inner.fit = ++fits;
  drawing.notes.push_back(
      "a hole around " + hole.place() + " and the outline inside it are at most " + text_of(gap) +
      " apart: this is read as a clearance; for a press fit use the outlines in comments instead of those above them, " +
      "and the statement 'interference'");
}

// Contours by even depth give bodies, those by odd depth holes in the face around them.
void nest(std::vector<Contour>& contours, double tolerance, Drawing& drawing) {
  find_boxes(contours);
  std::stable_sort(contours.begin(), contours.end(), [](const Contour& a, const Contour& b) { return a.area > b.area; });
  drop_doubles(contours, tolerance, drawing.notes);
  size_t fits = 0;
  std::vector<std::vector<size_t>> body_of(contours.size()); // of each face
  for (size_t i = 0; i < contours.size(); ++i) {
    Contour& c = contours[i];
    size_t around = i;
    for (size_t j = 0; j < i; ++j)
      if (encloses(contours[j], c)) around = j, ++c.depth;
    if (c.depth % 2 == 0)
      body_of[i] = add_bodies(c, drawing);
    else
      add_hole(c, contours[around], body_of[around], drawing);
    if (c.depth % 2 == 0 && c.depth > 0) mark_press_fit(contours[around], c, fits, drawing);
  }
}

// Bodies come in the order in which the drawing has their first curves.
size_t first_order(const Body& body) {
  size_t first = SIZE_MAX;
  for (const Loop& loop : body.loops)
    for (const Curve& curve : loop.curves) first = std::min(first, curve.order);
  return first;
}

// Coincident closed curves.
bool is_same_whole(const Curve& a, const Curve& b, double tolerance) {
  if (a.kind != b.kind || a.points.size() != b.points.size() || sketch::length(a.centre - b.centre) > tolerance ||
      std::fabs(a.a - b.a) > tolerance || std::fabs(a.b - b.b) > tolerance)
    return false;
  for (size_t i = 0; i < a.points.size(); ++i)
    if (sketch::length(a.points[i] - b.points[i]) > tolerance) return false;
  const double turned = std::remainder(a.tilt - b.tilt, 180) * kHalfTurn / 180;
  return std::fabs(turned) * std::fabs(a.a - a.b) <= tolerance;
}

// Ends that were joined, if that was more than digits of a file.
void note_joined(const Graph& graph, double size, std::vector<std::string>& notes) {
  double most = 0;
  int count = 0;
  for (const double moved : graph.moved)
    if (moved > 0.1 * kRound * size) most = std::max(most, moved), ++count;
  if (count > 0)
    notes.push_back("joined: " + std::to_string(count) + (count == 1 ? " end" : " ends") + ", moved by " + text_of(most) +
                    " at most");
}

std::string outline_text(const Curve& c) {
  return "the outline" + (c.name.empty() ? std::string() : " of " + shown(c.name)) +
         (c.line > 0 ? " in line " + std::to_string(c.line) : std::string());
}

// Of outlines, or of all curves where no outline is closed.
void note_crossings(const std::vector<Curve>& curves, double tolerance, Drawing& drawing) {
  Notes repeated(drawing.notes, " other crossings");
  for (const Crossing& c : crossings_of(curves, tolerance)) {
    const Curve &a = curves[c.first], &b = curves[c.second];
    const bool itself = c.first == c.second || (a.line > 0 && a.line == b.line);
    const std::string text = (itself ? outline_text(b) + " crosses itself" : text_of(b) + " crosses " + text_of(a)) + " near " +
                             text_of(c.at) + ": outlines that cross bound no body";
    if (drawing.crossing.text.empty()) drawing.crossing = {b.line, text};
    repeated.add(text);
  }
}

} // namespace

void join_curves(Drawing& drawing, double join) {
  const double size = size_of(drawing.curves), tolerance = join > 0 ? join : kJoin * size;
  for (size_t i = 0; i < drawing.curves.size(); ++i) drawing.curves[i].order = i;
  std::vector<Curve> loose, wholes;
  for (Curve& curve : with_length(drawing.curves, tolerance, drawing.notes)) {
    if (!curve.whole) {
      loose.push_back(std::move(curve));
      continue;
    }
    const auto twin =
        std::find_if(wholes.begin(), wholes.end(), [&](const Curve& w) { return is_same_whole(w, curve, tolerance); });
    if (twin != wholes.end())
      drawing.notes.push_back(text_of(curve) + " coincides with " + text_of(*twin) + " and was left out");
    else
      wholes.push_back(std::move(curve));
  }
  drawing.curves.clear();
  Graph graph = graph_of(std::move(loose), tolerance);
  note_joined(graph, size, drawing.notes);
  drop_doubles(graph, tolerance, drawing.notes);
  note_open_ends(graph, tolerance, drawing.notes);
  const std::vector<Curve> drawn = graph.curves;
  prune(graph, drawing.notes);
  std::vector<Curve> outlines = graph.curves;
  outlines.insert(outlines.end(), wholes.begin(), wholes.end());
  note_crossings(outlines.empty() ? drawn : outlines, tolerance, drawing);
  std::vector<Contour> contours = contours_of(graph);
  for (const Curve& curve : wholes) contours.push_back(contour_of(curve));
  const size_t first = drawing.bodies.size();
  nest(contours, tolerance, drawing);
  std::stable_sort(drawing.bodies.begin() + static_cast<ptrdiff_t>(first), drawing.bodies.end(),
                   [](const Body& a, const Body& b) { return first_order(a) < first_order(b); });
  size_t tidied = 0;
  for (size_t b = first; b < drawing.bodies.size(); ++b)
    for (Loop& loop : drawing.bodies[b].loops) {
      tidied += tidy(loop);
      Loop other{loop.press_fit, loop.hole};
      tidy(other);
      loop.press_fit = std::move(other.curves);
    }
  note_tidied(tidied, drawing.notes);
}

} // namespace drawing
