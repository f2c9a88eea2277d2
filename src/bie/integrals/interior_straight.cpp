// Displacement and stress of a straight element in closed form (METHOD 16.3). In axes along the element, in units of its half
// length and about its middle, P is the complex number z = xi + i zeta, and rho = eta - z with real eta. Then rho* = rho + 2 i
// zeta and n = -i, so every kernel of interior.hpp is a sum of powers of 1/rho, and the integrals follow from the moments of
// bie/integrals/straight_moments.hpp. The terms with rho* - rho = 2 i zeta vanish with the distance from the element's line:
// written in this way nothing large cancels near it. Literature: Muskhelishvili, Some Basic Problems of the Mathematical Theory
// of Elasticity (complex notation).

#include "bie/integrals/interior_detail.hpp"
#include "bie/integrals/straight_moments.hpp"
#include "memory/math.hpp"

namespace c2d {
namespace {

// Integrals of both densities against each part of the kernels.
struct DensityMoments {
  Complex t_log;      // int t ln|rho|
  double t_mean;      // int Re t
  Complex tc, tc_bar; // int t/rho, int t*/rho
  Complex td;         // int t/rho^2
  Complex uc, uc_bar, ud, ud_bar, uf;
};

DensityMoments apply(const FieldElement& e, Complex reference, const Moments& m, const Complex f[kElementNodes]) {
  DensityMoments s = {};
  for (int k = 0; k < e.in.functions; ++k) {
    const Complex t = e.t[k], u = k == 0 ? e.u[0] - reference : e.u[k];
    // The logarithm is of |rho| in units of the half length, so ln|h| times the mean is added.
    const double mean = k % 2 == 0 ? 2.0 / (k + 1) : 0.0;
    add(s.t_log, (m.e[k] + mean * e.in.log_half) * t);
    s.t_mean += mean * t.re;
    add(s.tc, t * m.c[k]);
    add(s.tc_bar, conj(t) * m.c[k]);
    add(s.td, t * m.d[k]);
    add(s.uc, u * m.c[k]);
    add(s.uc_bar, conj(u) * m.c[k]);
    add(s.ud, u * m.d[k]);
    add(s.ud_bar, conj(u) * m.d[k]);
    add(s.uf, u * f[k]);
  }
  return s;
}

} // namespace

void add_field_straight(const FieldElement& e, Complex reference, double x, double y, PointField& sum) {
  const Integrator& in = e.in;
  const SeenPoint seen = see(in, x, y);
  Moments m;
  Complex f[kElementNodes];
  find_moments(seen, in.functions, true, m);
  find_third_moments(seen, in.functions, m, f);
  const DensityMoments s = apply(e, reference * conj(e.axis), m, f);
  const Complex n = {0.0, -1.0}, twice_zeta = {0.0, 2.0 * seen.z.im}; // rho* - rho
  const double per_length = sqrt(in.ux * in.ux + in.uy * in.uy);      // 1/|h|
  const double k_t = in.k * in.g_jacobian, k_d = k_t * per_length, k_s = 2.0 * in.k * per_length;

  // Signs and factors as in interior.hpp; the first line is U t, the next ones -T u.
  Complex u = k_t * (-in.kappa * s.t_log + Complex{s.t_mean, 0.0} + 0.5 * conj(twice_zeta * s.tc));
  const Complex nuc = n * s.uc;
  add(u, (0.5 * in.k) * (in.kappa * nuc + conj(n * (s.uc_bar - s.uc) + nuc + twice_zeta * (n * s.ud))));
  add(sum.u, u * e.axis);

  // Trace and deviator: D t with k_d, -S u with k_s. The deviator rotates back by twice the angle.
  const Complex nud = n * s.ud;
  sum.trace += 2.0 * k_d * s.tc.re + k_s * nud.re;
  const Complex deviator = k_d * (in.kappa * s.tc_bar + s.tc + twice_zeta * s.td) +
                           k_s * (0.5 * (n * (s.ud_bar - s.ud)) + nud + twice_zeta * (n * s.uf));
  add(sum.deviator, deviator * conj(e.axis * e.axis));
}

} // namespace c2d
