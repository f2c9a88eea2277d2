#include "program/drawing/loops.hpp"

#include "program/drawing/graph.hpp"
#include "program/sketch/outline.hpp"

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
  Notes told_ones(notes, " other curves without length were left out");
  for (const Curve& curve : curves) {
    if (!(rough_length(curve) > tolerance)) {
      told_ones.add(told(curve) + " at " + told(curve.begin) + " has no length and was left out");
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
  Notes told_ones(notes, " other curves lie on curves that are there already");
  for (size_t i = 0; i < graph.curves.size(); ++i) {
    std::vector<size_t>& others = between[std::minmax(graph.ends[i][0], graph.ends[i][1])];
    for (const size_t j : others) {
      if (!coincide(graph.curves[j], graph.curves[i], graph.ends[j][0] == graph.ends[i][0], tolerance)) continue;
      kept[i] = false;
      told_ones.add(told(graph.curves[i]) + " from " + told(graph.curves[i].begin) + " to " + told(graph.curves[i].end) +
                    " lies on " + told(graph.curves[j]) + " and was left out");
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
void tell_open_ends(const Graph& graph, double tolerance, std::vector<std::string>& notes) {
  const std::vector<int> count = degrees(graph);
  Notes told_ones(notes, " other ends are open");
  for (size_t i = 0; i < graph.curves.size(); ++i)
    for (const size_t e : {size_t{0}, size_t{1}}) {
      const size_t joint = graph.ends[i][e];
      if (count[joint] != 1 || told_ones.only_counts()) continue;
      const Point p = graph.joints[joint];
      size_t nearest = joint;
      double distance = HUGE_VAL;
      for (size_t j = 0; j < graph.joints.size(); ++j)
        if (j != joint && j != graph.ends[i][1 - e] && sketch::length(graph.joints[j] - p) < distance)
          distance = sketch::length(graph.joints[j] - p), nearest = j;
      std::string text = told(graph.curves[i]) + " has an open end at " + told(p);
      if (nearest != joint)
        text += "; the nearest other end is at " + told(graph.joints[nearest]) + ", " + told(distance) + " away";
      const auto on =
          std::find_if(graph.curves.begin(), graph.curves.end(), [&](const Curve& c) { return is_on(c, p, tolerance); });
      if (on != graph.curves.end()) text += "; it lies on " + told(*on) + ", which is to be broken there";
      told_ones.add(text);
    }
}

// Takes away what leads nowhere: curves with an open end, again and again, and bridges between loops.
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
                    " part of no closed outline and left out");
}

struct Contour { // of curves that are connected: what it looks like from outside, and the faces in it
  std::vector<Point> polygon;
  Loop outside; // as a hole: clockwise
  std::vector<Loop> inside;
  std::vector<std::vector<Point>> polygons; // of those
  Point low, high;                          // the box around it
  double area = 0;
  int depth = 0;
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
  c.polygon = polygon_of(loop);
  c.area = sketch::area_of(c.polygon);
  if (c.area < 0) { // what is whole turns left: the sketch turns it round in a hole
    loop.curves = {reversed(whole)};
    c.polygon = polygon_of(loop);
    c.area = -c.area;
  }
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
      contour.area = -area;
      contour.outside = std::move(loop);
      contour.polygon = std::move(polygon);
    }
  }
  std::vector<Contour> out;
  for (auto& entry : contours)
    if (!entry.second.inside.empty() && !entry.second.polygon.empty()) out.push_back(std::move(entry.second));
  return out;
}

// Is most of `inner` in `outer`? Contours that touch in a point make one point no judge.
bool encloses(const std::vector<Point>& outer, const std::vector<Point>& inner) {
  int in = 0, all = 0;
  const size_t step = std::max<size_t>(1, inner.size() / 9);
  for (size_t i = 0; i < inner.size(); i += step, ++all) {
    const Point middle = 0.5 * (inner[i] + inner[(i + 1) % inner.size()]);
    if (sketch::holds(outer, middle)) ++in;
  }
  return 2 * in > all;
}

bool encloses(const Contour& outer, const Contour& inner) {
  if (inner.high.x < outer.low.x || inner.low.x > outer.high.x || inner.high.y < outer.low.y || inner.low.y > outer.high.y)
    return false;
  return encloses(outer.polygon, inner.polygon);
}

// Contours by even depth give bodies, those by odd depth holes in the face around them.
void nest(std::vector<Contour>& contours, Drawing& drawing) {
  for (Contour& c : contours) {
    c.low = c.high = c.polygon.front();
    for (const Point& p : c.polygon) {
      c.low = {std::min(c.low.x, p.x), std::min(c.low.y, p.y)};
      c.high = {std::max(c.high.x, p.x), std::max(c.high.y, p.y)};
    }
  }
  std::stable_sort(contours.begin(), contours.end(), [](const Contour& a, const Contour& b) { return a.area > b.area; });
  std::vector<std::vector<size_t>> body_of(contours.size()); // of each face
  for (size_t i = 0; i < contours.size(); ++i) {
    Contour& c = contours[i];
    size_t around = i;
    for (size_t j = 0; j < i; ++j)
      if (encloses(contours[j], c)) around = j, ++c.depth;
    if (c.depth % 2 == 0) {
      for (Loop& face : c.inside) {
        body_of[i].push_back(drawing.bodies.size());
        drawing.bodies.push_back({"", {std::move(face)}});
      }
      if (c.inside.size() > 1)
        drawing.notes.push_back(std::to_string(c.inside.size()) +
                                " outlines share curves: each is a body, and both sides of a shared curve bear its name");
      continue;
    }
    c.outside.hole = true;
    if (c.inside.size() > 1)
      drawing.notes.push_back("a hole near " + told(c.polygon.front()) + " has curves across it, which were left out");
    const std::vector<size_t>& bodies = body_of[around];
    size_t f = 0;
    while (f < bodies.size() && !encloses(contours[around].polygons[f], c.polygon)) ++f;
    if (f < bodies.size())
      drawing.bodies[bodies[f]].loops.push_back(std::move(c.outside));
    else
      drawing.notes.push_back("a hole near " + told(c.polygon.front()) + " lies in several bodies and was left out");
  }
}

// Bodies come in the order in which the drawing has their first curves.
size_t first_order(const Body& body) {
  size_t first = SIZE_MAX;
  for (const Loop& loop : body.loops)
    for (const Curve& curve : loop.curves) first = std::min(first, curve.order);
  return first;
}

// Circles and the like that lie twice.
bool is_same_whole(const Curve& a, const Curve& b, double tolerance) {
  return a.kind == b.kind && a.kind != Curve::kSpline && sketch::length(a.centre - b.centre) <= tolerance &&
         std::fabs(a.a - b.a) <= tolerance && std::fabs(a.b - b.b) <= tolerance;
}

} // namespace

void join_curves(Drawing& drawing, double join) {
  const double tolerance = join > 0 ? join : kJoin * size_of(drawing.curves);
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
      drawing.notes.push_back(told(curve) + " lies on " + told(*twin) + " and was left out");
    else
      wholes.push_back(std::move(curve));
  }
  drawing.curves.clear();
  Graph graph = graph_of(std::move(loose), tolerance);
  drop_doubles(graph, tolerance, drawing.notes);
  tell_open_ends(graph, tolerance, drawing.notes);
  prune(graph, drawing.notes);
  std::vector<Contour> contours = contours_of(graph);
  for (const Curve& curve : wholes) contours.push_back(contour_of(curve));
  const size_t first = drawing.bodies.size();
  nest(contours, drawing);
  std::stable_sort(drawing.bodies.begin() + static_cast<ptrdiff_t>(first), drawing.bodies.end(),
                   [](const Body& a, const Body& b) { return first_order(a) < first_order(b); });
  for (size_t b = first; b < drawing.bodies.size(); ++b)
    for (Loop& loop : drawing.bodies[b].loops) tidy(loop);
}

} // namespace drawing
