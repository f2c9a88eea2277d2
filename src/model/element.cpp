// Geometry of one boundary element: x(eta) = sum_k c_k eta^k (isoparametric Lagrange element, thesis (4.7) to (4.10); Brebbia,
// Telles and Wrobel, Boundary Element Techniques, 1984).
//
// Powers of eta instead of shape functions, because the closed-form integrals need them and evaluation by Horner's rule is
// cheaper. Collinear equally spaced nodes give a constant Jacobian; such elements are treated as straight, which selects the
// closed-form integrals (METHOD 3.2) also for quadratic and cubic elements.
#include "model/element.hpp"

#include "memory/math.hpp"
#include "model/shape.hpp"

namespace c2d {
namespace {

double larger(double a, double b) { return a > b ? a : b; }

// Are the coefficients of eta^2 and eta^3 within the rounding of the node coordinates? Then the element is straight.
bool is_straight(const Element& e) {
  constexpr double kRounding = 16 * 2.22e-16;
  double size = e.half_length;
  for (int i = 0; i < e.nodes; ++i) size = larger(size, larger(fabs(e.x[i]), fabs(e.y[i])));
  const double bend = larger(larger(fabs(e.c[2][0]), fabs(e.c[2][1])), larger(fabs(e.c[3][0]), fabs(e.c[3][1])));
  return bend <= kRounding * size;
}

} // namespace

Element make_element(int nodes, const double* x, const double* y) {
  Element e = {};
  e.nodes = nodes;
  for (int i = 0; i < nodes; ++i) {
    e.x[i] = x[i];
    e.y[i] = y[i];
  }
  const int last = nodes - 1;
  const double ex = 0.5 * (x[last] - x[0]), ey = 0.5 * (y[last] - y[0]);
  e.half_length = sqrt(ex * ex + ey * ey);
  // Coefficients relative to the first node: with coordinates far from the origin, differences keep their digits.
  for (int i = 1; i < nodes; ++i) {
    const double* s = shape_coefficients(nodes, i);
    for (int k = 0; k < nodes; ++k) {
      e.c[k][0] += s[k] * (x[i] - x[0]);
      e.c[k][1] += s[k] * (y[i] - y[0]);
    }
  }
  e.c[0][0] += x[0];
  e.c[0][1] += y[0];
  e.straight = nodes == 2 || is_straight(e);
  if (e.straight) {
    e.c[0][0] = x[0] + ex;
    e.c[0][1] = y[0] + ey;
    e.c[1][0] = ex;
    e.c[1][1] = ey;
    for (int k = 2; k < kElementNodes; ++k) e.c[k][0] = e.c[k][1] = 0.0;
  }
  return e;
}

Point element_point(const Element& e, double eta) {
  Point p = {};
  double* position[2] = {&p.x, &p.y};
  double* slope[2] = {&p.dx, &p.dy};
  for (int i = 0; i < 2; ++i) {
    *position[i] = e.c[0][i] + eta * (e.c[1][i] + eta * (e.c[2][i] + eta * e.c[3][i]));
    *slope[i] = e.c[1][i] + eta * (2.0 * e.c[2][i] + eta * 3.0 * e.c[3][i]);
  }
  p.jacobian = sqrt(p.dx * p.dx + p.dy * p.dy);
  if (p.jacobian > 0.0) {
    p.nx = p.dy / p.jacobian;
    p.ny = -p.dx / p.jacobian;
  }
  return p;
}

namespace {

struct Offset { // of a point of the element from P, with its first and second derivatives by eta
  double rx, ry, dx, dy, ddx, ddy;
  double distance2() const { return rx * rx + ry * ry; }
};

Offset offset_at(const Element& e, double eta, double x, double y) {
  const double(&c)[kElementNodes][2] = e.c;
  return {(c[0][0] - x) + eta * (c[1][0] + eta * (c[2][0] + eta * c[3][0])),
          (c[0][1] - y) + eta * (c[1][1] + eta * (c[2][1] + eta * c[3][1])),
          c[1][0] + eta * (2.0 * c[2][0] + 3.0 * eta * c[3][0]),
          c[1][1] + eta * (2.0 * c[2][1] + 3.0 * eta * c[3][1]),
          2.0 * c[2][0] + 6.0 * eta * c[3][0],
          2.0 * c[2][1] + 6.0 * eta * c[3][1]};
}

double clamped(double eta) { return eta < -1.0 ? -1.0 : (eta > 1.0 ? 1.0 : eta); }

// Newton step for the minimum of |x(eta) - P|^2 / 2: slope r.x', second derivative |x'|^2 + r.x''. Where that is small or
// negative Newton would go to a maximum; the Gauss-Newton value |x'|^2 is used instead. On a straight element one step is
// exact.
double newton_step(const Offset& o) {
  const double slope = o.rx * o.dx + o.ry * o.dy, speed = o.dx * o.dx + o.dy * o.dy;
  const double curvature = speed + o.rx * o.ddx + o.ry * o.ddy;
  const double divisor = curvature > 0.1 * speed ? curvature : speed;
  return divisor > 0.0 ? slope / divisor : 0.0;
}

} // namespace

Nearest nearest_point(const Element& e, double x, double y) {
  // A curved element may have several local minima: begin at the best of nine equally spaced points, then only accept steps
  // that reduce the distance.
  double best = 0.0, best2 = offset_at(e, 0.0, x, y).distance2();
  for (int i = 0; i <= 8 && !e.straight; ++i) {
    const double eta = -1.0 + 0.25 * i, d2 = offset_at(e, eta, x, y).distance2();
    if (!(d2 < best2)) continue;
    best = eta;
    best2 = d2;
  }
  for (int i = 0; i < 20; ++i) {
    const double eta = clamped(best - newton_step(offset_at(e, best, x, y)));
    const double d2 = offset_at(e, eta, x, y).distance2();
    if (!(d2 < best2)) break;
    best = eta;
    best2 = d2;
  }
  return {best, sqrt(best2)};
}

} // namespace c2d
