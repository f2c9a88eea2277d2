// The statement `part`: names a part of a curve, so that a side may end within a curve.
#include "program/sketch/read/reader.hpp"
#include "program/sketch/shapes/outline.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {
namespace {

constexpr int kSamples = 720; // samples in the search for a coordinate; a spline has more

// The only zero of a function of u, where it changes sign; an error at the last word if there are none or several.
template <class Function> double only_root(const Statement& s, int samples, const Function& f, const std::string& what) {
  std::vector<double> roots;
  const auto add = [&roots](double u) {
    if (roots.empty() || u - roots.back() > 1e-9) roots.push_back(u);
  };
  for (int i = 0; i < samples; ++i) {
    double low = static_cast<double>(i) / samples, high = static_cast<double>(i + 1) / samples;
    const double begin = f(low), end = f(high);
    if (begin == 0) add(low);
    if (end == 0) add(high);
    if (!(begin * end < 0)) continue;
    while (high - low > 1e-15) {
      const double middle = (low + high) / 2;
      if (middle <= low || middle >= high) break;
      ((f(middle) < 0) == (begin < 0) ? low : high) = middle;
    }
    add((low + high) / 2);
  }
  if (roots.empty()) s.fail("the curve has no point with " + what);
  if (roots.size() > 1)
    s.fail("the curve has " + std::to_string(roots.size()) + " points with " + what +
           ", expected one: give a length, a percentage of the length, or an angle");
  return roots[0];
}

// The place of a curve with a given coordinate; its ends match up to round-off.
double coordinate(const Statement& s, const Shape& shape, size_t axis, double value) {
  const auto off = [&](double u) {
    const Point p = shape.at(u);
    return (axis == 0 ? p.x : p.y) - value;
  };
  const double size = std::max({std::fabs(off(0)), std::fabs(off(0.5)), std::fabs(off(1))});
  const auto rounded = [&](double u) {
    const double d = off(u);
    return std::fabs(d) <= 1e-12 * (size + std::fabs(value)) ? 0 : d;
  };
  return only_root(s, kSamples + 4 * shape.pieces(), rounded, (axis == 0 ? "x = " : "y = ") + show(value));
}

// The place of an arc at a given angle about its centre.
double angle(const Statement& s, const Shape& arc, double degrees) {
  if (arc.form() != Form::kArc) s.fail("the curve has no centre, expected an arc or a circle for an angle");
  const double degree = std::acos(-1.0) / 180, bend = arc.curvature(0);
  const double sweep = length(arc.local(0).d) * bend / degree;
  const Point out = (-1 / bend) * turned_left(arc.tangent(0)); // from the centre
  const double begin = std::atan2(out.y, out.x) / degree, turn = sweep > 0 ? 360 : -360;
  double way = std::fmod(degrees - begin, 360);
  if (way * turn < 0) way += turn;
  if (std::fabs(way - turn) < 1e-9) way = 0;
  if (std::fabs(way) > std::fabs(sweep) + 1e-9)
    s.fail("the arc goes from " + rounded(begin) + " to " + rounded(begin + sweep) + " degrees, " + show(degrees) +
           " degrees is not on it");
  return std::min(way / sweep, 1.0);
}

// A place along a curve, as u.
double place(Statement& s, const ShapePtr& curve, const std::string& which) {
  if (s.accept("start")) return 0;
  if (s.accept("end")) return 1;
  if (s.accept("angle")) return angle(s, *curve, s.number("an angle in degrees"));
  for (const size_t axis : {0u, 1u})
    if (s.accept(axis == 0 ? "x" : "y")) return coordinate(s, *curve, axis, s.number("the coordinate"));
  const Measure measure(curve);
  const bool is_share = s.is_share();
  const double value = s.share(which + ": a length along the curve, a percentage such as 25 %, x, y, angle, start or end");
  const double at = is_share ? value * measure.length() : value;
  if (at < 0 || at > measure.length() * (1 + 1e-9))
    s.fail("the length " + show(at) + " is not on the curve, expected a length from 0 to " + rounded(measure.length()));
  return measure.u_at(at);
}

Curve piece_of(const Curve& curve, const ShapePtr& whole, const std::string& name, double first, double last) {
  Curve out{name, part(whole, first, last), curve.at};
  if (name == curve.name) out.drawn = whole, out.first = first, out.last = last; // the rest may be cut again
  return out;
}

} // namespace

// The curves of the current body with a name: one curve, or the remaining pieces of one.
std::vector<Curve*> Reader::pieces_named(Statement& s, const std::string& name) {
  std::vector<Curve*> out;
  for (Outline& outline : current_body(s).outlines)
    for (Curve& curve : outline.curves)
      if (curve.name == name) out.push_back(&curve);
  if (out.empty())
    s.fail("body " + in_quotes(s_.bodies.back().name) + " has no curve " + in_quotes(name) + " before this statement");
  for (const Curve* curve : out)
    if (out.size() > 1 && (!curve->drawn || curve->drawn != out[0]->drawn))
      s.fail("several curves are called " + in_quotes(name) + ", expected a name of one curve");
  return out;
}

// Names the part between two places `name`; the rest keeps its name.
void Reader::cut(Statement& s, const std::string& name, const std::string& of, double first, double last) {
  constexpr double kNothing = 1e-9;
  for (Outline& outline : current_body(s).outlines)
    for (size_t i = 0; i < outline.curves.size(); ++i) {
      const Curve curve = outline.curves[i];
      if (curve.name != of || first < curve.first - kNothing || last > curve.last + kNothing) continue;
      const ShapePtr whole = curve.drawn ? curve.drawn : curve.shape;
      std::vector<Curve> pieces;
      const bool has_before = first > curve.first + kNothing, has_behind = last < curve.last - kNothing;
      if (has_before) pieces.push_back(piece_of(curve, whole, of, curve.first, first));
      pieces.push_back(piece_of(curve, whole, name, has_before ? first : curve.first, has_behind ? last : curve.last));
      if (has_behind) pieces.push_back(piece_of(curve, whole, of, last, curve.last));
      const auto at = outline.curves.erase(outline.curves.begin() + static_cast<std::ptrdiff_t>(i));
      outline.curves.insert(at, pieces.begin(), pieces.end());
      return;
    }
  s.fail("this range contains a part with another name, expected a range without one");
}

// part tip of face from angle -135 to angle -45: places refer to the curve as drawn. A part of a closed curve may pass its
// start.
void Reader::part_of(Statement& s) {
  current_body(s);
  if (corner_)
    throw Fault{s.at(), "'part' stands between a fillet or chamfer and its second curve, expected it after that curve"};
  const std::string name = s.name("the name of the part");
  if (!s.accept("of")) s.missing("of and the name of a curve");
  const std::string of = s.name("the name of a curve");
  if (name == of) s.fail("the part has the name of its curve, expected another name");
  const std::vector<Curve*> pieces = pieces_named(s, of);
  const ShapePtr whole = pieces[0]->drawn ? pieces[0]->drawn : pieces[0]->shape;
  if (!s.accept("from")) s.missing("from and where the part begins");
  const double first = place(s, whole, "where it begins");
  if (!s.accept("to")) s.missing("to and where the part ends");
  const double last = place(s, whole, "where it ends");
  if (last - first > 1e-9) return cut(s, name, of, first, last);
  const bool is_closed = length(whole->at(0) - whole->at(1)) <= kJoint * Measure(whole).length();
  if (!is_closed || first - last < 1e-9)
    s.fail("the end of the part is not after its start, expected places in the direction of the curve");
  if (last > 0) cut(s, name, of, 0, last);
  if (first < 1) cut(s, name, of, first, 1);
}

} // namespace sketch
