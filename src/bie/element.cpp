#include "bie/element.hpp"

#include "bie/shape.hpp"

#include <math.h>

namespace c2d {
namespace {

double larger(double a, double b) {
  return a > b ? a : b;
}

// Are the coefficients of the second and third power explained by the rounding of the nodes' coordinates?
bool is_straight(const Element& e) {
  constexpr double kRounding = 16 * 2.22e-16;
  double size = e.half_length;
  for (int i = 0; i < e.nodes; ++i) size = larger(size, larger(fabs(e.x[i]), fabs(e.y[i])));
  const double bend =
      larger(larger(fabs(e.c[2][0]), fabs(e.c[2][1])), larger(fabs(e.c[3][0]), fabs(e.c[3][1])));
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
  // Coefficients relative to the first node, so that large coordinates do not spoil the small ones.
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
    for (int k = 2; k < 4; ++k) e.c[k][0] = e.c[k][1] = 0.0;
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

} // namespace c2d
