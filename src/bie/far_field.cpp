// Far field of a group of elements: multipole series of displacement and stress (METHOD (16.10)).
//
// With w = P - c from the centre c of the group's circle, METHOD (16.2) summed over the group depends on two analytic
// functions:
//   F = T ln w + sum f_j (R/w)^j,   X = -(kappa/2) T* ln w + sum x_j (R/w)^j,
// the Kolosov-Muskhelishvili functions of the group's forces and displacements.
// 1. Element to group: a Gauss rule gives point sources, whose coefficients are powers of q = (x - c)/R.
// 2. Group to larger group: the series is shifted to the new centre by the binomial theorem.
// 3. Evaluation at a point: one sum of kFarTerms terms for displacement, trace and deviator.
// At kFarDistance radii from the centre the terms decay like 3^-j, so 30 of them are as accurate as the integrals.
// Literature: Greengard and Rokhlin, J. Comput. Phys. 73 (1987); Muskhelishvili, Some Basic Problems of the Mathematical
// Theory of Elasticity.
#include "bie/far_field.hpp"

#include "bie/integrals/integrals_detail.hpp"
#include "memory/math.hpp"
#include "model/shape.hpp"
#include "quadrature/gauss.hpp"

namespace c2d {
namespace {

// The Gauss rule for an element: a point at kFarDistance of the group's radius is so far from each of its elements that this
// rule meets its bound.
int far_order(const FieldElement& e, double radius) {
  const Integrator& in = e.in;
  const double away = (kFarDistance - 1.0) * radius;
  constexpr int kLast = kFarOrderCount - 1;
  for (int i = 0; i < kLast; ++i) {
    const double reach =
        e.closed_form ? gauss_semi_axis(kFarOrders[i], in.functions - 1, 1e-13) * in.radius : sqrt(in.reach2[i]);
    if (reach > 0.0 && reach < away) return kFarOrders[i];
  }
  return kFarOrders[kLast];
}

// A quadrature point of the element: force t, n u and n . u, all times the weight, at the place q, in radii from the centre.
struct PointSource {
  Complex t, nu, q;
  double along;
};

// Expands 1/(q - w) in powers of q/w. X contains conj(q) explicitly, because displacements are not analytic in the place of
// the source.
void add_source(const PointSource& s, double kappa, FarField& out) {
  const Complex tq = s.t * conj(s.q), nq = s.nu * conj(s.q);
  Complex power = {1.0, 0.0}, before = {0.0, 0.0}; // q^(j-1), q^(j-2)
  add(out.force, s.t);
  for (int j = 1; j <= kFarTerms; ++j) {
    const Complex next = power * s.q;
    add(out.f[j - 1], s.nu * power - (1.0 / j) * (s.t * next));
    add(out.x[j - 1],
        (0.5 * kappa / j) * (conj(s.t) * next) - 0.5 * (tq * power) - s.along * power + (0.5 * (j - 1)) * (nq * before));
    before = power;
    power = next;
  }
}

// Coefficients of sum over j of c_j (w - d)^-j in powers of 1/w, row by row: each step adds one power.
struct Shift {
  double ratio;             // of the radii
  Complex by;               // distance of the centres, in the larger radius
  Complex table[kFarTerms]; // binomial (l-1 over j-1) ratio^j by^(l-j), of the row l

  void first() {
    for (Complex& entry : table) entry = Complex{0.0, 0.0};
    table[0] = Complex{ratio, 0.0};
  }
  // Pascal's rule, from row l - 1 to l: (l-1 over j-1) = (l-2 over j-1) + (l-2 over j-2).
  void next(int l) {
    for (int j = l; j > 1; --j) table[j - 1] = table[j - 1] * by + ratio * table[j - 2];
    table[0] = table[0] * by;
  }
};

} // namespace

void add_to_far_field(const FieldElement& e, Complex rest, FarField& out) {
  const GaussRule rule = gauss_legendre(far_order(e, out.radius));
  const Expansion x = expand(e.in, 0.0, out.middle.re, out.middle.im, false);
  // Powers of (x - c)/R stay below 1, so no coefficient overflows, however many terms there are.
  const double part = 1.0 / out.radius;
  for (int i = 0; i < rule.n; ++i) {
    const GaussPoint point = gauss_point(rule, i);
    const Sample s = sample(e.in, x, point.x);
    const Complex n = point.w * Complex{s.nx, s.ny};
    Complex u = {0.0, 0.0};
    if (e.displaced) u = polynomial(e.u, e.in.functions, point.x) * e.axis - rest;
    const Complex t = (point.w * s.jacobian) * (polynomial(e.t, e.in.functions, point.x) * e.axis);
    add_source({t, part * (n * u), {part * s.rx, part * s.ry}, part * dot(n, u)}, e.in.kappa, out);
  }
}

// Shift to the larger group's centre. With w = w' - d, w' from that centre, the term w conj(F')/2 contributes -d* F'/2 to X.
void add_to_far_field(const FarField& part, double kappa, FarField& out) {
  if (!(part.radius > 0.0)) return;
  const Complex d = part.middle - out.middle;
  Complex x[kFarTerms];
  const Complex step = (0.5 / part.radius) * conj(d);
  x[0] = part.x[0] - step * part.force;
  for (int j = 1; j < kFarTerms; ++j) x[j] = part.x[j] + j * (step * part.f[j - 1]);
  Shift shift{part.radius / out.radius, (1.0 / out.radius) * d, {}};
  Complex power = {1.0, 0.0};
  shift.first();
  add(out.force, part.force);
  for (int l = 1; l <= kFarTerms; ++l) {
    if (l > 1) shift.next(l);
    power = power * shift.by;
    Complex f = (-1.0 / l) * (part.force * power), g = (0.5 * kappa / l) * (conj(part.force) * power);
    for (int j = 0; j < l; ++j) {
      add(f, part.f[j] * shift.table[j]);
      add(g, x[j] * shift.table[j]);
    }
    add(out.f[l - 1], f);
    add(out.x[l - 1], g);
  }
}

constexpr double kNothing = 1e-38; // squared size of a power, relative to 1, below which the rest vanishes

void add_far_field(const FarField& group, double k, double kappa, double x, double y, PointField& sum) {
  const Complex w = Complex{x, y} - group.middle;
  const double w2 = dot(w, w);
  const Complex inverse = (1.0 / w2) * conj(w), s = group.radius * inverse;
  const double s2 = dot(s, s);
  Complex power = s, f = {0.0, 0.0}, f1 = f, f2 = f, g = f, g1 = f;
  double size = s2;
  for (int j = 1; j <= kFarTerms && size > kNothing; ++j, size *= s2) {
    const Complex a = group.f[j - 1] * power, b = group.x[j - 1] * power;
    add(f, a);
    add(f1, j * a);
    add(f2, (j * (j + 1.0)) * a);
    add(g, b);
    add(g1, j * b);
    power = power * s;
  }
  // F', F'' and X' from the sums weighted by j and j (j + 1): no second series is needed.
  const Complex slope = inverse * (group.force - f1), bend = (inverse * inverse) * (f2 - group.force);
  const Complex rise = (-1.0) * (inverse * ((0.5 * kappa) * conj(group.force) + g1));
  const double far = 0.5 * log(w2);
  add(sum.u, k * ((0.5 - kappa * far) * group.force - (0.5 * kappa) * f + conj(g) + 0.5 * (w * conj(slope))));
  sum.trace -= 2.0 * k * slope.re;
  add(sum.deviator, k * (conj(w) * bend + 2.0 * rise));
}

Complex far_displacement(const FarField& group, double k, double kappa, double x, double y) {
  const Complex w = Complex{x, y} - group.middle;
  const double w2 = dot(w, w);
  const Complex inverse = (1.0 / w2) * conj(w), s = group.radius * inverse;
  Complex power = s, f = {0.0, 0.0}, f1 = f, g = f;
  double size = dot(s, s);
  for (int j = 1; j <= kFarTerms && size > kNothing; ++j, size *= dot(s, s)) {
    const Complex a = group.f[j - 1] * power;
    add(f, a);
    add(f1, j * a);
    add(g, group.x[j - 1] * power);
    power = power * s;
  }
  const Complex slope = inverse * (group.force - f1);
  return k * ((0.5 - 0.5 * kappa * log(w2)) * group.force - (0.5 * kappa) * f + conj(g) + 0.5 * (w * conj(slope)));
}

// A uniform displacement on a chain. With n ds = -i dz the integrands are total differentials, so only the ends count.
void add_uniform_chain(const Chain& chain, Complex u, double k, double kappa, double x, double y, PointField& sum) {
  const Complex a = chain.from - Complex{x, y}, b = chain.to - Complex{x, y};
  const double a2 = dot(a, a), b2 = dot(b, b);
  const Complex ia = (1.0 / a2) * conj(a), ib = (1.0 / b2) * conj(b), ratio = b * conj(a);
  const Complex log_ratio = {0.5 * log(b2 / a2), atan2(ratio.im, ratio.re)};
  const Complex turn = b * conj(ib) - a * conj(ia), rise = ib - ia, other = conj(b) * (ib * ib) - conj(a) * (ia * ia);
  const Complex iu = {-u.im, u.re}, iu_bar = {u.im, u.re}; // i u, i u*
  add(sum.u, (0.5 * k) * (iu * conj(log_ratio) - kappa * (iu * log_ratio) - iu_bar * turn));
  sum.trace += 2.0 * k * (iu * rise).re;
  add(sum.deviator, k * (iu_bar * rise + iu * other));
}

} // namespace c2d
