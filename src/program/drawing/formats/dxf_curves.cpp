#include "program/drawing/formats/dxf_curves.hpp"

#include "program/drawing/formats/nurbs.hpp"
#include "program/sketch/shapes/outline.hpp"

#include <algorithm>
#include <cmath>

namespace drawing {

const Motion kFromBehind{-1, 0, 0, 1, 0, 0};

namespace {

double degrees(double radians) { return radians * 180 / kHalfTurn; }

// From corner to corner of a polyline: bulge is the tangent of a quarter of the angle, above 0 counter-clockwise.
Curve with_bulge(Point from, Point to, double bulge) {
  if (std::fabs(bulge) < 1e-12) return straight(from, to);
  const Point chord = to - from;
  const Point centre = 0.5 * (from + to) + ((1 - bulge * bulge) / (4 * bulge)) * sketch::turned_left(chord);
  const Point arm = from - centre;
  Curve c = circular(centre, sketch::length(arm), degrees(std::atan2(arm.y, arm.x)), degrees(4 * std::atan(bulge)));
  if (!c.whole) move_ends(c, from, to);
  return c;
}

struct Vertex {
  Point at;
  double bulge = 0;
};

class Maker {
public:
  Maker(const Entity& entity, const Motion& motion, Account& account) : e_(entity), motion_(motion), account_(account) {}
  std::vector<Curve> make(const std::vector<Entity>& corners);

private:
  void line();
  void arc();
  void circle();
  void ellipse();
  void spline();
  void light_polyline();
  void old_polyline(const std::vector<Entity>& corners);
  void polyline(const std::vector<Vertex>& vertices);
  void follow(Nurbs n);
  double radius() const;
  double sweep(double first, double last, double whole);
  void check_height(std::vector<double> z);
  void add(Curve curve) { out_.push_back(placed(std::move(curve), motion_)); }

  const Entity& e_;
  Motion motion_;
  Account& account_;
  std::vector<Curve> out_;
};

void Maker::check_height(std::vector<double> z) {
  if (std::any_of(z.begin(), z.end(), [&](double height) { return height != z[0]; }))
    account_.repair(e_.type, "projected along z, because its points differ in z", e_.line);
}

// Counter-clockwise. Angles that are a whole turn apart, but for digits of the file, are one.
double Maker::sweep(double first, double last, double whole) {
  constexpr double kRounding = 1e-5; // of a turn
  const double wide = last - first, turns = std::round(wide / whole), beyond = wide - turns * whole;
  if (std::fabs(beyond) > kRounding * whole || (turns == 0 && beyond > 1e-9)) {
    const double sweep = std::fmod(wide, whole);
    return sweep > 0 ? sweep : sweep + whole;
  }
  if (std::fabs(beyond) > 1e-9 * whole)
    account_.repair(e_.type, "closed, because its end angles differ only by rounding", e_.line);
  return whole;
}

double Maker::radius() const {
  const double r = e_.number(40, "the radius");
  if (!(r > 0)) throw Fault{e_.line, "radius " + text_of(r) + ", expected a value above 0"};
  return r;
}

void Maker::line() {
  const Point first = e_.point(10, "the first end"), last = e_.point(11, "the last end");
  const double z = e_.number(30, 0, "z");
  check_height({z, e_.number(31, z, "z")});
  add(straight(first, last));
}

void Maker::arc() {
  const double from = e_.number(50, "the first angle");
  const double wide = sweep(from, e_.number(51, "the last angle"), 360);
  add(circular(e_.point(10, "the centre"), radius(), from, wide));
}

void Maker::circle() { add(circular(e_.point(10, "the centre"), radius(), -90, 360)); }

void Maker::polyline(const std::vector<Vertex>& v) {
  const bool closed = (e_.flags(70) & 1) != 0;
  const size_t n = v.size();
  for (size_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
    const Point from = v[i].at, to = v[(i + 1) % n].at;
    if (sketch::length(to - from) == 0) continue; // a closed one may repeat its first corner
    add(with_bulge(from, to, v[i].bulge));
  }
  if (out_.empty()) throw Fault{e_.line, "all of its vertices coincide"};
}

void Maker::light_polyline() {
  std::vector<Vertex> vertices;
  for (const Group* g = e_.first; g != e_.last; ++g) {
    if (g->code == 10) vertices.push_back({{real(g->value, g->line, "x of a vertex"), NAN}, 0});
    if ((g->code == 20 || g->code == 42) && vertices.empty()) throw Fault{g->line, "expected x of a vertex first"};
    if (g->code == 20) vertices.back().at.y = real(g->value, g->line, "y of a vertex");
    if (g->code == 42) vertices.back().bulge = real(g->value, g->line, "a bulge");
  }
  for (const Vertex& v : vertices)
    if (std::isnan(v.at.y)) throw Fault{e_.line, "a vertex has no y"};
  if (const int64_t n = e_.flags(90); e_.has(90) && n != static_cast<int64_t>(vertices.size()))
    throw Fault{e_.line, std::to_string(vertices.size()) + " vertices, expected " + std::to_string(n)};
  polyline(vertices);
}

void Maker::old_polyline(const std::vector<Entity>& corners) {
  constexpr int64_t kMesh = 16 | 64;
  if ((e_.flags(70) & kMesh) != 0) throw Fault{e_.line, "a three-dimensional mesh"};
  std::vector<Vertex> vertices;
  std::vector<double> z;
  for (const Entity& corner : corners) {
    constexpr int64_t kFrame = 16; // a control point of a spline that the other corners follow
    if ((corner.flags(70) & kFrame) != 0) continue;
    vertices.push_back({corner.point(10, "a vertex"), corner.number(42, 0, "a bulge")});
    z.push_back(corner.number(30, 0, "z"));
  }
  check_height(z);
  polyline(vertices);
}

void Maker::ellipse() {
  const Point centre = e_.point(10, "the centre"), axis = e_.point(11, "the end of the major axis");
  const double ratio = e_.number(40, "the ratio of the axes"), a = sketch::length(axis);
  if (!(ratio > 0)) throw Fault{e_.line, "ratio of the axes " + text_of(ratio) + ", expected a value above 0"};
  if (a == 0) throw Fault{e_.line, "the major axis has no length"};
  const double from = e_.number(41, 0, "the first parameter");
  const double wide = sweep(from, e_.number(42, from + 2 * kHalfTurn, "the last parameter"), 2 * kHalfTurn);
  const double side = is_seen_from_behind(e_) ? -1 : 1; // the minor axis lies on the other side
  add(elliptic(centre, a, a * ratio, degrees(std::atan2(axis.y, axis.x)), side * degrees(from), side * degrees(wide)));
}

// Control points are placed, and points of the curve chosen afterwards: of other scales it would be another spline.
void Maker::follow(Nurbs n) {
  for (Point& p : n.points) p = motion_(p);
  for (Curve& curve : drawing::curves_of(n, 1e-7 * sketch::size_of(n.points))) out_.push_back(std::move(curve));
}

void Maker::spline() {
  Nurbs n;
  n.degree = static_cast<int>(std::clamp<int64_t>(e_.flags(71), 0, 99));
  n.knots = e_.numbers(40, "a knot");
  n.points = e_.points(10, "a control point");
  n.weights = e_.numbers(41, "a weight");
  const bool closed = (e_.flags(70) & 1) != 0;
  check_height(e_.numbers(n.points.empty() ? 31 : 30, "z"));
  if (!n.points.empty()) {
    if (const std::string fault = n.fault(); !fault.empty()) throw Fault{e_.line, fault};
    if (!(sketch::size_of(n.points) > 0)) throw Fault{e_.line, "all of its control points coincide"};
    return follow(std::move(n));
  }
  std::vector<Point> through = e_.points(11, "a fit point"); // the only data
  if (through.size() < 2) throw Fault{e_.line, "it has neither control points nor two fit points"};
  const bool again = through.size() > 3 && sketch::length(through.back() - through.front()) == 0;
  const auto is_one = [](Point a, Point b) { return sketch::length(a - b) == 0; };
  through.erase(std::unique(through.begin(), through.end(), is_one), through.end());
  if (closed && again) through.pop_back();
  if (through.size() < 2) throw Fault{e_.line, "all of its fit points coincide"};
  if (through.size() == 2) return add(straight(through.front(), through.back()));
  const Point x = motion_({1, 0}) - motion_({}), y = motion_({0, 1}) - motion_({});
  const double size = sketch::length(x);
  if (std::fabs(sketch::dot(x, y)) + std::fabs(size - sketch::length(y)) * size > 1e-9 * size * size)
    return follow(nurbs_through(through, closed));
  add(smooth(through, closed));
}

std::vector<Curve> Maker::make(const std::vector<Entity>& corners) {
  const std::string_view type = e_.type;
  const bool has_plane = type != "LINE" && type != "SPLINE", behind = has_plane && is_seen_from_behind(e_);
  if (behind && type != "ELLIPSE") motion_ = after(motion_, kFromBehind); // that one has coordinates of the drawing
  if (type == "LINE") line();
  if (type == "ARC") arc();
  if (type == "CIRCLE") circle();
  if (type == "ELLIPSE") ellipse();
  if (type == "SPLINE") spline();
  if (type == "LWPOLYLINE") light_polyline();
  if (type == "POLYLINE") old_polyline(corners);
  return std::move(out_);
}

} // namespace

bool is_curve(std::string_view type) {
  for (const char* known : {"LINE", "ARC", "CIRCLE", "ELLIPSE", "SPLINE", "LWPOLYLINE", "POLYLINE"})
    if (type == known) return true;
  return false;
}

bool is_seen_from_behind(const Entity& e) {
  const double x = e.number(210, 0, "the normal of a plane"), y = e.number(220, 0, "the normal of a plane");
  const double z = e.number(230, 1, "the normal of a plane");
  if (std::fabs(x) > 1e-9 || std::fabs(y) > 1e-9 || z == 0)
    throw Fault{e.line, "its plane is inclined to the plane of the drawing"};
  return z < 0;
}

std::vector<Curve> curves_of(const Entity& e, const std::vector<Entity>& corners, const Motion& motion, Account& account) {
  return Maker(e, motion, account).make(corners);
}

} // namespace drawing
