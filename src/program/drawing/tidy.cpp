// Curves that go on as one.
#include "program/drawing/loops.hpp"

#include <cmath>

namespace drawing {
namespace {

bool goes_on(const Curve& a, const Curve& b, double tolerance) {
  if (a.kind != b.kind || a.name.empty() || a.name != b.name || a.whole || b.whole) return false;
  if (a.kind == Curve::kLine) {
    const Point d = b.end - a.begin, m = b.begin - a.begin;
    const double whole = sketch::length(d);
    return whole > 0 && std::fabs(sketch::cross(d, m)) <= tolerance * whole && sketch::dot(d, m) > 0 &&
           sketch::dot(d, m) < whole * whole;
  }
  return a.kind == Curve::kArc && (a.sweep > 0) == (b.sweep > 0) && std::fabs(a.sweep + b.sweep) < 360 * (1 + 1e-9) &&
         sketch::length(a.centre - b.centre) <= tolerance && std::fabs(a.a - b.a) <= tolerance;
}

// a, and b behind it, as one.
Curve joined(const Curve& a, const Curve& b) {
  Curve c = a;
  c.end = b.end;
  c.sweep += b.sweep;
  return c;
}

} // namespace

size_t tidy(Loop& loop) {
  const size_t before = loop.curves.size();
  const double tolerance = kRound * size_of(loop.curves);
  std::vector<Curve> out;
  for (Curve& curve : loop.curves) {
    if (!out.empty() && goes_on(out.back(), curve, tolerance))
      out.back() = joined(out.back(), curve);
    else
      out.push_back(std::move(curve));
  }
  // A loop may begin in the middle of one.
  while (out.size() > 2 && goes_on(out.back(), out.front(), tolerance)) {
    out.front() = joined(out.back(), out.front());
    out.pop_back();
  }
  if (out.size() == 2 && goes_on(out[1], out[0], tolerance) && out[0].kind == Curve::kArc &&
      std::fabs(std::fabs(out[0].sweep + out[1].sweep) - 360) < 1e-6) {
    out[0] = joined(out[1], out[0]);
    out.pop_back();
  }
  if (out.size() == 1 && !out[0].whole && out[0].kind == Curve::kArc) {
    const Curve arc = out[0];
    out[0] = circular(arc.centre, arc.a, arc.sweep > 0 ? arc.from : arc.from + arc.sweep, 360);
    out[0].name = arc.name, out[0].line = arc.line;
  }
  loop.curves = std::move(out);
  return before - loop.curves.size();
}

void note_tidied(size_t count, std::vector<std::string>& notes) {
  if (count > 0)
    notes.push_back("merged: " + std::to_string(count) +
                    (count == 1 ? " curve that continues the one before it" : " curves that continue the one before them"));
}

} // namespace drawing
