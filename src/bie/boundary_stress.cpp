// Stress tensor on the boundary from traction and tangential strain, METHOD (16.1): s_ss = 2G/(1 - nu) e_ss + nu/(1 - nu)
// s_nn. The traction gives the normal and shear components directly; only s_ss needs Hooke's law. So no hypersingular integral
// is evaluated at the boundary.
// Literature: Brebbia and Dominguez, Boundary Elements: An Introductory Course, on stresses on the boundary.
#include "bie/boundary_stress.hpp"

#include "memory/math.hpp"

namespace c2d {

PlaneStress boundary_stress(const double n[2], const double t[2], const double du_ds[2], double across, double shear_modulus,
                            double nu, double* hoop) {
  const double s[2] = {-n[1], n[0]};
  const double nn = t[0] * n[0] + t[1] * n[1], ns = t[0] * s[0] + t[1] * s[1];
  const double strain = du_ds[0] * s[0] + du_ds[1] * s[1] + nu * across;
  const double ss = (2.0 * shear_modulus * strain + nu * nn) / (1.0 - nu);
  *hoop = ss;
  return {nn * n[0] * n[0] + 2.0 * ns * n[0] * s[0] + ss * s[0] * s[0],
          nn * n[1] * n[1] + 2.0 * ns * n[1] * s[1] + ss * s[1] * s[1],
          nn * n[0] * n[1] + ns * (n[0] * s[1] + n[1] * s[0]) + ss * s[0] * s[1]};
}

double stress_across(const PlaneStress& s, bool plane_strain, double nu) { return plane_strain ? nu * (s.xx + s.yy) : 0.0; }

double von_mises(const PlaneStress& s, double szz) {
  const double a = s.xx - s.yy, b = s.yy - szz, c = szz - s.xx;
  return sqrt(0.5 * (a * a + b * b + c * c) + 3.0 * s.xy * s.xy);
}

double largest_shear(const PlaneStress& s) { return hypot(0.5 * (s.xx - s.yy), s.xy); }

} // namespace c2d
