#include "program/drawing/placing.hpp"

#include <cmath>

namespace drawing {

Point Placing::operator()(Point p) const {
  const double t = angle * std::acos(-1.0) / 180, c = scale * std::cos(t), s = scale * std::sin(t);
  const Point d = p - base, m = {d.x, mirrors ? -d.y : d.y};
  return at + Point{c * m.x - s * m.y, s * m.x + c * m.y};
}

Curve placed(Curve c, const Placing& placing) {
  c.begin = placing(c.begin), c.end = placing(c.end), c.centre = placing(c.centre);
  for (Point& p : c.points) p = placing(p);
  c.a *= placing.scale, c.b *= placing.scale, c.doubt *= placing.scale;
  const double side = placing.mirrors ? -1 : 1;
  c.from *= side;
  if (!c.whole) c.sweep *= side;
  if (c.kind == Curve::kArc) // an arc has no axis
    c.from += placing.angle;
  else
    c.tilt = side * c.tilt + placing.angle;
  return c;
}

} // namespace drawing
