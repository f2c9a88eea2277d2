// Particular solutions for weight and rotation, and their resultants (METHOD 6, equations METHOD (6.1) to (6.3); of
// bodies of revolution METHOD 21.6).
//   weight b:                  sigma_p = -(b.x) I
//   rotation rho omega^2 x:    u_p = -rho omega^2 (1 - 2 nu) / (16 G (1 - nu)) r^2 x
// u - u_p then satisfies the equations without body force, and no integral over the area is needed. Resultants and work are
// integrals of polynomials over the area. By the divergence theorem they are integrals along the boundary, exact by Gauss
// rules.
// Literature: Brebbia and Dominguez, Boundary Elements: An Introductory Course, on body forces (particular solutions).
#include "bie/body_force.hpp"

#include "bie/measure.hpp"
#include "model/element.hpp"
#include "model/geometry.hpp"
#include "model/shape.hpp"
#include "quadrature/gauss.hpp"

namespace c2d {

namespace {

void add_weight(const BodyForce& f, double nu, double g, double x, double y, Particular& out) {
  const double k = -(1.0 - 2.0 * nu) / (2.0 * g);
  out.u[0] += k * (0.5 * f.bx * (x * x - y * y) + f.by * x * y);
  out.u[1] += k * (0.5 * f.by * (y * y - x * x) + f.bx * x * y);
  for (int c = 0; c < 2; ++c) out.stress[c] -= f.bx * x + f.by * y;
}

void add_rotation(const BodyForce& f, double nu, double g, double x, double y, Particular& out) {
  const double k1 = -f.rho_omega2 / (16.0 * g * (1.0 - nu)), k = (1.0 - 2.0 * nu) * k1; // k1 = k / (1 - 2 nu)
  const double r2 = x * x + y * y;
  out.u[0] += k * r2 * x;
  out.u[1] += k * r2 * y;
  const double mean = 8.0 * g * nu * k1 * r2 + 2.0 * g * k * r2;
  out.stress[0] += mean + 4.0 * g * k * x * x;
  out.stress[1] += mean + 4.0 * g * k * y * y;
  out.stress[2] += 4.0 * g * k * x * y;
}

// Bodies of revolution: weight along the axis, and rotation about it, whose field is that of the plane in any direction.
void add_ring_weight(const BodyForce& f, double nu, double g, double r, double z, Particular& out) {
  const double k = -f.by * (1.0 - 2.0 * nu) / (2.0 * g * (1.0 + nu));
  out.u[0] += k * r * z;
  out.u[1] += 0.5 * k * (z * z - r * r);
  for (int c = 0; c < 2; ++c) out.stress[c] -= f.by * z;
}

void add_ring_rotation(const BodyForce& f, double nu, double g, double r, Particular& out) {
  const double k1 = -f.rho_omega2 / (16.0 * g * (1.0 - nu)), k = (1.0 - 2.0 * nu) * k1, r2 = r * r;
  out.u[0] += k * r2 * r;
  out.stress[0] += (8.0 * nu * k1 + 6.0 * k) * g * r2;
  out.stress[1] += 8.0 * nu * k1 * g * r2;
}

// Area and first moments about a point, from the boundary alone.
struct AreaMoments {
  double area, x, y;

  // A piece of boundary at (px, py) from there, with its derivatives: area = half the integral of x dy - y dx,
  // moments = half that of x^2 dy and minus half that of y^2 dx.
  void add(double weight, double px, double py, double dx, double dy) {
    area += 0.5 * weight * (px * dy - py * dx);
    x += 0.5 * weight * px * px * dy;
    y -= 0.5 * weight * py * py * dx;
  }
};

// Five points are exact up to degree nine; x^2 dy has degree eight on cubic elements.
constexpr int kPoints = 5;
constexpr double kPlace[kPoints] = {-0.9061798459386640, -0.5384693101056831, 0.0, 0.5384693101056831, 0.9061798459386640};
constexpr double kWeight[kPoints] = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889, 0.4786286704993665,
                                     0.2369268850561891};

AreaMoments area_moments(const Model& m, int b, double ox, double oy) {
  AreaMoments sum = {0.0, 0.0, 0.0};
  for (int32_t e = 0; e < body_of(m, b).elements; ++e)
    for (int i = 0; i < kPoints; ++i) {
      const CurvePoint p = curve_point(m, b, e, kPlace[i]);
      sum.add(kWeight[i], p.x - ox, p.y - oy, p.dx, p.dy);
    }
  for (int32_t r = 0; r < body_of(m, b).regions; ++r) { // closed along lines of symmetry: x is constant, or dy is 0
    double x[3], y[3];
    const int corners = closing_way(m, b, r, x, y);
    for (int k = 0; k + 1 < corners; ++k) {
      const double dx = 0.5 * (x[k + 1] - x[k]), dy = 0.5 * (y[k + 1] - y[k]);
      for (int i = 0; i < kPoints; ++i)
        sum.add(kWeight[i], x[k] + dx * (1.0 + kPlace[i]) - ox, y[k] + dy * (1.0 + kPlace[i]) - oy, dx, dy);
    }
  }
  return sum;
}

} // namespace

Particular particular_solution(const Model& m, int b, int32_t load_case, double x, double y) {
  const ModelHeader& head = *m.head;
  const BodyForce& f = body_force(m, b, load_case);
  const double nu = strain_poisson_ratio(m, b), g = shear_modulus(m, b);
  Particular out = {{0.0, 0.0}, {0.0, 0.0, 0.0}};
  double origin[2];
  // On a line of symmetry the origin is on the line: u_p is then as symmetric as the body force.
  for (int c = 0; c < 2; ++c) origin[c] = (m.body[b].lines >> c & 1) != 0 ? head.line_at[c] : m.body[b].centre[c];
  if (is_axisymmetric(m)) {
    add_ring_weight(f, nu, g, x, y - origin[1], out);
    add_ring_rotation(f, nu, g, x, out);
    return out;
  }
  add_weight(f, nu, g, x - origin[0], y - origin[1], out);
  add_rotation(f, nu, g, x - f.x0, y - f.y0, out);
  return out;
}

void particular_traction(const Model& m, int b, int32_t load_case, int32_t element, int l, double t[2]) {
  const Point p = element_point(element_of(m, b, element), node_eta(m.head->function_nodes, l));
  const Particular s = particular_solution(m, b, load_case, p.x, p.y);
  t[0] = s.stress[0] * p.nx + s.stress[2] * p.ny;
  t[1] = s.stress[2] * p.nx + s.stress[1] * p.ny;
}

void body_force_resultant(const Model& m, int b, int32_t load_case, double x, double y, double out[3]) {
  const BodyForce& f = body_force(m, b, load_case);
  out[0] = out[1] = out[2] = 0.0;
  if (!is_loaded(f)) return;
  const double* centre = body_of(m, b).centre;
  if (is_axisymmetric(m)) { // round the axis 2 pi r dA
    out[1] = kTurn * f.by * area_moments(m, b, 0.0, centre[1]).x;
    return;
  }
  const AreaMoments a = area_moments(m, b, centre[0], centre[1]);
  // Force density: weight plus rho omega^2 (place - axis), with the place counted from the body's centre. Moments of area
  // about a far axis would cancel.
  const double w = f.rho_omega2, ax = f.x0 - centre[0], ay = f.y0 - centre[1];
  out[0] = f.bx * a.area + w * (a.x - ax * a.area);
  out[1] = f.by * a.area + w * (a.y - ay * a.area);
  // About the centre (x times y cancels), then about the point.
  const double moment = a.x * f.by - a.y * f.bx + w * (ax * a.y - ay * a.x);
  out[2] = moment + (centre[0] - x) * out[1] - (centre[1] - y) * out[0];
}

namespace {

// Integral of b.u_p along a line y = constant from x = from to x = to, of bodies of revolution times 2 pi r: three Gauss points
// are exact for its fourth degree, and for the fifth with r.
double work_on_line(const Model& m, int b, const BodyForce& f, int32_t particular_case, double from, double to, double y) {
  const GaussRule rule = gauss_legendre(3);
  double sum = 0.0;
  for (int i = 0; i < rule.n; ++i) {
    const GaussPoint g = gauss_point(rule, i);
    const double x = 0.5 * (from + to) + 0.5 * (to - from) * g.x;
    const Particular p = particular_solution(m, b, particular_case, x, y);
    const double bx = f.bx + f.rho_omega2 * (x - f.x0), by = f.by + f.rho_omega2 * (y - f.y0);
    const double work =
        is_axisymmetric(m) ? kTurn * x * (f.rho_omega2 * x * p.u[0] + f.by * p.u[1]) : bx * p.u[0] + by * p.u[1];
    sum += 0.5 * (to - from) * g.w * work;
  }
  return sum;
}

} // namespace

double body_force_work(const Model& m, int b, int32_t load_case, int32_t particular_case) {
  const BodyForce& f = body_force(m, b, load_case);
  if (!is_loaded(f)) return 0.0;
  // Green's theorem: the area integral of f is the boundary integral of (int f dx) dy.
  const double origin = is_axisymmetric(m) ? 0.0 : body_of(m, b).centre[0];
  const GaussRule rule = gauss_legendre(is_axisymmetric(m) ? 12 : 10); // exact for the degree of cubic elements: 20 or 17
  double sum = 0.0;
  for (int32_t e = 0; e < body_of(m, b).elements; ++e)
    for (int i = 0; i < rule.n; ++i) {
      const GaussPoint g = gauss_point(rule, i);
      const CurvePoint p = curve_point(m, b, e, g.x);
      sum += g.w * p.dy * work_on_line(m, b, f, particular_case, origin, p.x, p.y);
    }
  for (int32_t r = 0; r < body_of(m, b).regions; ++r) { // closed along lines of symmetry: x is constant, or dy is 0
    double x[3], y[3];
    const int corners = closing_way(m, b, r, x, y);
    for (int k = 0; k + 1 < corners; ++k)
      for (int i = 0; i < rule.n; ++i) {
        const GaussPoint g = gauss_point(rule, i);
        const double s = 0.5 * (1.0 + g.x), dy = y[k + 1] - y[k];
        sum += 0.5 * g.w * dy * work_on_line(m, b, f, particular_case, origin, x[k], y[k] + s * dy);
      }
  }
  return sum;
}

} // namespace c2d
