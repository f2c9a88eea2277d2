// Statements that draw bodies: consecutive curves with the material on the left.
#include "program/sketch/read/point_rows.hpp"
#include "program/sketch/read/reader.hpp"
#include "program/sketch/shapes/outline.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {
namespace {

const double kHalfTurn = std::acos(-1.0);

double degrees(Point p) { return std::atan2(p.y, p.x) * 180 / kHalfTurn; }

// The sweep from a to b about the origin, counter-clockwise or clockwise; a full turn if both directions coincide.
double sweep_between(Point a, Point b, bool clockwise) {
  double sweep = std::atan2(cross(a, b), dot(a, b)) * 180 / kHalfTurn;
  if (!clockwise && sweep <= 0) sweep += 360;
  if (clockwise && sweep >= 0) sweep -= 360;
  return sweep;
}

Motion reflection(size_t axis, double at) {
  return axis == 0 ? Motion{-1, 0, 0, 1, 2 * at, 0} : Motion{1, 0, 0, -1, 0, 2 * at};
}

} // namespace

std::string Reader::new_body_name(Statement& s, const std::string& expected) {
  const std::string name = s.name(expected);
  for (const Body& other : s_.bodies)
    if (other.name == name) s.fail("another body is called " + in_quotes(name) + ", expected a new name");
  if (name.size() > kLongestName) s.fail(in_quotes(name) + ": expected at most " + std::to_string(kLongestName) + " bytes");
  return name;
}

// `fatigue findley 0.3 ...`, the last words of the statement. k of Fatemi and Socie goes with the yield stress.
void Reader::fatigue_constants(Statement& s, FatigueConstants& out) {
  const std::vector<const char*> words = {"fatemi-socie", "yield", "findley", "crossland", "dang-van"};
  double* const values[] = {&out.fatemi_socie, &out.yield, &out.findley, &out.crossland, &out.dang_van};
  do {
    const size_t which = s.choice(words);
    if (which == 1) {
      out.yield = s.positive("the yield stress");
      continue;
    }
    *values[which] = s.number(std::string("the fatigue constant ") + words[which]);
    if (*values[which] < 0) s.fail(show(*values[which]) + ": expected a fatigue constant of at least 0");
  } while (s.has_more());
}

// The body is added even if its statement has errors, because the next statements draw it.
void Reader::body(Statement& s) {
  end_body();
  s_.bodies.emplace_back();
  in_body_ = true;
  Body& body = s_.bodies.back();
  body.at = s.at();
  body.name = new_body_name(s, "the name of a body");
  body.rigid = s.accept("rigid");
  while (s.has_more() && !body.rigid) {
    const size_t which = s.choice({"E", "nu", "fatigue"});
    if (which == 2) {
      fatigue_constants(s, body.fatigue);
      break;
    }
    if (which == 0) {
      body.youngs_modulus = s.positive("Young's modulus");
    } else {
      body.poisson_ratio = s.number("Poisson's ratio");
      if (!(body.poisson_ratio > -1 && body.poisson_ratio <= 0.5))
        s.fail(show(body.poisson_ratio) + ": expected Poisson's ratio, above -1 and at most 0.5");
    }
  }
  if (body.youngs_modulus == 0 && !body.rigid) s.fail("body " + in_quotes(body.name) + ": expected E and a value, or rigid");
}

Body& Reader::current_body(Statement& s) {
  if (!in_body_ && is_lost_) throw Fault{};
  if (!in_body_)
    throw Fault{s.at(), in_quotes(s.keyword().text) + " stands outside a body, expected it after a statement 'body'"};
  return s_.bodies.back();
}

Outline& Reader::current_outline(Statement& s) {
  Body& body = current_body(s);
  if (!in_outline_) {
    body.outlines.push_back({});
    body.outlines.back().at = s.at();
    in_outline_ = true;
  }
  return body.outlines.back();
}

void Reader::outline(Statement& s) {
  current_body(s);
  end_outline();
  current_outline(s);
}

void Reader::hole(Statement& s) {
  outline(s);
  s_.bodies.back().outlines.back().hole = true;
}

void Reader::from(Statement& s) {
  if (in_outline_ && !current_outline(s).curves.empty()) end_outline();
  current_outline(s);
  start_ = here_ = s.point("the start of the outline");
  has_start_ = true;
}

// Words after the optional name of a curve. They are not allowed as names.
const char* const kWords[] = {"to", "by", "through", "centre", "close", "radius", "cut", "turn", "t", "file"};

std::string Reader::curve_name(Statement& s) {
  current_body(s);
  for (const char* word : kWords) {
    if (!s.is_next(word)) continue;
    const bool is_name = std::any_of(std::begin(kWords), std::end(kWords), [&](const char* w) { return s.is_next(w, 1); });
    const bool closes = s.is_next("close") && !s.is_next("to", 1) && !s.is_next("by", 1) && !s.is_next("close", 1);
    if (!is_name || closes) return "";
    std::string all;
    for (const char* w : kWords) all += (all.empty() ? "" : ", ") + std::string(w);
    s.missing("another name of the curve: " + all + " are reserved");
  }
  return s.has_more() ? s.name("the name of the curve") : "";
}

Point Reader::target(Statement& s) {
  if (!has_start_) s.fail("this curve has no start point, expected a statement 'from' before it");
  if (s.accept("close")) return start_;
  if (s.accept("by")) return here_ + s.point("the vector from its start to its end");
  if (!s.accept("to")) s.missing("to x y, by dx dy, or close");
  return s.point("its end");
}

void Reader::draw(Statement& s, const std::string& name, ShapePtr shape) {
  Outline& outline = current_outline(s);
  if (!has_start_) start_ = shape->at(0), has_start_ = true;
  here_ = shape->at(1);
  outline.curves.push_back({name, std::move(shape), s.at()});
  if (!corner_) return;
  const Corner corner = *corner_;
  corner_.reset();
  Curve& before = outline.curves[outline.curves.size() - 2];
  const auto join = corner.round ? sketch::fillet : sketch::chamfer;
  const Curve between = join(before, outline.curves.back(), corner.name, corner.size, corner.at);
  outline.curves.insert(outline.curves.end() - 1, between);
}

void Reader::straight(Statement& s) {
  const std::string name = curve_name(s);
  const Point begin = here_, end = target(s);
  if (length(end - begin) == 0) s.fail("this line has length zero, expected an end different from its start");
  draw(s, name, line(begin, end));
}

void Reader::arc(Statement& s) {
  const std::string name = curve_name(s);
  const Point begin = here_;
  if (s.accept("centre")) { // a given angle
    if (!has_start_) s.fail("this arc has no start point, expected a statement 'from' before it");
    const Point centre = s.point("the centre");
    if (!s.accept("turn")) s.missing("turn and an angle in degrees");
    const double turn = s.number("the angle in degrees");
    if (turn == 0) s.fail("this arc has length zero, expected an angle different from 0");
    return draw(s, name, sketch::arc(centre, length(begin - centre), degrees(begin - centre), turn));
  }
  const Point end = target(s), chord = end - begin;
  if (s.accept("through")) {
    const Point middle = s.point("a point of the arc");
    const double area = cross(middle - begin, chord);
    if (std::fabs(area) <= 1e-12 * dot(chord, chord)) s.fail("the three points are on one line, expected points of an arc");
    const Point centre = app::circle_centre(begin, middle, end);
    return draw(s, name,
                sketch::arc(centre, length(begin - centre), degrees(begin - centre),
                            sweep_between(begin - centre, end - centre, area < 0)));
  }
  if (s.accept("centre")) {
    const Point centre = s.point("the centre");
    const double r = length(begin - centre), q = length(end - centre);
    if (std::fabs(r - q) > kJoint * r)
      s.fail("the centre has the distance " + rounded(r) + " from the start of the arc and " + rounded(q) +
             " from its end, expected equal distances");
    const bool right = s.accept("right");
    return draw(s, name, sketch::arc(centre, r, degrees(begin - centre), sweep_between(begin - centre, end - centre, right)));
  }
  if (!s.accept("radius")) s.missing("radius, through or centre");
  const double radius = s.positive("the radius"), half = length(chord) / 2;
  const bool right = s.accept("right"), is_long = s.accept("long");
  if (half == 0 || radius < half * (1 - 1e-12))
    s.fail("the distance of the ends is " + rounded(2 * half) + ", expected at most twice the radius " + show(radius));
  const double height = std::sqrt(std::max(radius * radius - half * half, 0.0)) * (right != is_long ? -1 : 1);
  const Point centre = begin + 0.5 * chord + (height / (2 * half)) * turned_left(chord);
  draw(s, name, sketch::arc(centre, radius, degrees(begin - centre), sweep_between(begin - centre, end - centre, right)));
}

// A curve that is a whole outline; reversed for a hole.
void Reader::draw_whole(Statement& s, const std::string& name, ShapePtr shape) {
  if (!current_outline(s).curves.empty()) end_outline();
  Outline& outline = current_outline(s);
  if (outline.hole) shape = part(shape, 1, 0);
  start_ = shape->at(0), has_start_ = true;
  draw(s, name, std::move(shape));
  end_outline();
}

void Reader::circle(Statement& s) {
  const std::string name = curve_name(s);
  if (!s.accept("centre")) s.missing("centre x y radius r");
  const Point centre = s.point("the centre");
  if (!s.accept("radius")) s.missing("radius r");
  const double radius = s.positive("the radius");
  draw_whole(s, name, sketch::arc(centre, radius, s.accept("from") ? s.number("the start angle in degrees") : -90, 360));
}

void Reader::ellipse(Statement& s) {
  const std::string name = curve_name(s);
  if (!s.accept("centre")) s.missing("centre x y axes a b");
  const Point centre = s.point("the centre");
  if (!s.accept("axes")) s.missing("axes a b");
  const double a = s.positive("its first semi-axis"), b = s.positive("its second semi-axis");
  const double tilt = s.accept("tilt") ? s.number("the angle of the first axis, in degrees") : 0;
  if (!s.accept("from")) return draw_whole(s, name, sketch::ellipse(centre, a, b, tilt, -90, 360));
  const double from = s.number("the eccentric angle of its start in degrees");
  if (!s.accept("turn")) s.missing("turn and an angle in degrees");
  draw(s, name, sketch::ellipse(centre, a, b, tilt, from, s.number("its range of the eccentric angle in degrees")));
}

void Reader::curve(Statement& s) {
  const std::string name = curve_name(s);
  const std::string variable = s.name("the name of the variable");
  const double first = s.number("the variable at the start of the curve"), last = s.number("the variable at its end");
  if (!s.accept("x")) s.missing("x and its formula");
  const Expression x = s.formula("the formula of x", variable);
  if (!s.accept("y")) s.missing("y and its formula");
  const ShapePtr shape = formula(x, s.formula("the formula of y", variable), first, last);
  for (int i = 0; i <= 64; ++i)
    if (const Point p = shape->at(i / 64.0); !std::isfinite(p.x) || !std::isfinite(p.y))
      s.fail("the formulas have no finite value at " + variable + " = " + show(first + (last - first) * i / 64.0));
  draw(s, name, shape);
}

std::vector<Point> Reader::listed_points(Statement& s) {
  std::vector<Point> out;
  while (s.has_more() && !s.is_next("closed")) out.push_back(s.point("a point of the spline"));
  return out;
}

std::vector<Point> Reader::points_of_file(Statement& s) {
  const std::string name = s.take("the name of a file with points").text;
  std::string text;
  if (!file_(name, text)) s.fail("the file " + in_quotes(name) + " " + (text.empty() ? "cannot be read" : text));
  const auto fail = [&](int line, const std::string& why) {
    s.fail("file " + in_quotes(name) + ", line " + std::to_string(line) + ": " + why);
  };
  std::vector<Point> out;
  try {
    for (const PointRow& row : point_rows(text)) {
      if (!out.empty() && length(row.at - out.back()) == 0)
        fail(row.line, "the point repeats the one before it, expected another place");
      out.push_back(row.at);
    }
  } catch (const Fault& fault) {
    if (fault.at.column > 0) throw; // an error of the statement itself
    fail(fault.at.line, fault.text);
  }
  return out;
}

void Reader::spline(Statement& s) {
  const std::string name = curve_name(s);
  const bool listed = s.accept("through");
  if (!listed && !s.accept("file")) s.missing("through x y x y ..., or file NAME");
  std::vector<Point> points = listed ? listed_points(s) : points_of_file(s);
  const bool closed = s.accept("closed"), backwards = s.accept("reversed");
  if (listed && !closed && has_start_) points.insert(points.begin(), here_);
  if (backwards) std::reverse(points.begin(), points.end());
  for (size_t i = 1; i < points.size(); ++i)
    if (length(points[i] - points[i - 1]) == 0)
      s.fail("point " + std::to_string(i + 1) + " of the spline repeats the one before it, expected another place");
  if (points.size() < (closed ? 3u : 2u))
    s.fail("the spline has too few points, expected at least " + std::string(closed ? "three" : "two"));
  if (!closed) return draw(s, name, sketch::spline(points, false));
  if (length(points.front() - points.back()) == 0) points.pop_back();
  const ShapePtr whole = sketch::spline(points, true);
  draw_whole(s, name, whole);
}

void Reader::ask_corner(Statement& s, bool round) {
  Outline& outline = current_outline(s);
  if (outline.curves.empty() || corner_)
    throw Fault{s.at(), in_quotes(s.keyword().text) + " has no curve directly before it, expected it between two curves"};
  const std::string name = curve_name(s);
  if (!s.accept(round ? "radius" : "cut")) s.missing(round ? "radius and a value" : "cut and a value");
  corner_ = Corner{round, name, s.positive(round ? "the radius" : "the length cut off each curve"), s.at()};
}

// Appends the reflected curves of the outline in reverse order and direction.
void Reader::mirror(Statement& s) {
  Outline& outline = current_outline(s);
  const size_t axis = s.choice({"x", "y"});
  const Motion motion = reflection(axis, s.number("the coordinate of the line of reflection"));
  for (size_t i = outline.curves.size(); i-- > 0;) {
    const Curve own = outline.curves[i];
    outline.curves.push_back({own.name, moved(part(own.shape, 1, 0), motion), own.at});
  }
  if (outline.curves.empty()) s.fail("the outline has no curve to reflect, expected curves before 'mirror'");
  here_ = outline.curves.back().shape->at(1);
}

Motion Reader::motion(Statement& s) {
  Motion out;
  while (s.has_more()) {
    Motion m;
    const size_t kind = s.choice({"shift", "turn", "mirror"});
    if (kind == 0) {
      m.x0 = s.number("the shift along x"), m.y0 = s.number("the shift along y");
    } else if (kind == 1) {
      const double angle = s.number("the angle in degrees") * kHalfTurn / 180;
      const Point about = s.accept("about") ? s.point("the centre of rotation") : Point{};
      m = {std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle), 0, 0};
      const Point off = about - m(about);
      m.x0 = off.x, m.y0 = off.y;
    } else {
      const size_t axis = s.choice({"x", "y"});
      m = reflection(axis, s.number("the coordinate of the line of reflection"));
    }
    const Point o = m(out({0, 0}));
    out = {
        m.a * out.a + m.b * out.c, m.a * out.b + m.b * out.d, m.c * out.a + m.d * out.c, m.c * out.b + m.d * out.d, o.x, o.y};
  }
  return out;
}

void Reader::copy(Statement& s) {
  end_body();
  const std::string name = new_body_name(s, "the name of the copy");
  if (!s.accept("of")) s.missing("of and the name of a body");
  Body body = s_.bodies[static_cast<size_t>(body_named(s.take("the name of a body")))];
  body.name = name, body.at = s.at();
  const Motion m = motion(s);
  for (Outline& outline : body.outlines) {
    if (m.mirrors()) std::reverse(outline.curves.begin(), outline.curves.end());
    for (Curve& curve : outline.curves) {
      curve.shape = moved(m.mirrors() ? part(curve.shape, 1, 0) : curve.shape, m);
      curve.drawn.reset();
    }
  }
  s_.bodies.push_back(body);
}

void Reader::end_outline() {
  const bool broken = broken_, drawn = in_outline_;
  in_outline_ = has_start_ = broken_ = false;
  if (!drawn) return;
  Body& body = s_.bodies.back();
  Outline& outline = body.outlines.back();
  if (broken) {
    corner_.reset();
    return;
  }
  if (outline.curves.empty()) {
    body.outlines.pop_back();
    return;
  }
  if (corner_) { // between the last curve and the first
    const Corner corner = *corner_;
    corner_.reset();
    const auto join = corner.round ? sketch::fillet : sketch::chamfer;
    outline.curves.push_back(join(outline.curves.back(), outline.curves.front(), corner.name, corner.size, corner.at));
  }
  const std::vector<Point> polygon = polygon_of(outline);
  const double size = size_of(polygon);
  const auto is_on_line = [&](Point p) {
    return (s_.symmetry[0] && std::fabs(p.x - *s_.symmetry[0]) <= kJoint * size) ||
           (s_.symmetry[1] && std::fabs(p.y - *s_.symmetry[1]) <= kJoint * size);
  };
  const Point first = outline.curves.front().shape->at(0), last = outline.curves.back().shape->at(1);
  outline.open = length(first - last) > kJoint * size && is_on_line(first) && is_on_line(last);
}

void Reader::end_body() {
  if (!in_body_) return;
  const bool broken = broken_;
  try {
    end_outline();
  } catch (const Fault& fault) { // of a fillet or chamfer at the end of the outline; the next statement is still read
    faults_.push_back(fault);
  }
  in_body_ = false;
  const Body& body = s_.bodies.back();
  if (body.outlines.empty() && !broken)
    faults_.push_back({body.at, "body " + in_quotes(body.name) + " has no outline, expected curves after its statement"});
}

} // namespace sketch
