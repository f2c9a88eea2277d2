#pragma once
// Stress tensor on the boundary from the traction and the derivative of the displacement along the boundary.

namespace c2d {

struct PlaneStress {
  double xx, yy, xy;
};

// t = traction, n = unit outward normal, du_ds = derivative of the displacement by arc length in the direction of
// travel (material on the left), nu of the equivalent plane strain, across = strain e_zz across the plane. *hoop: stress along
// the boundary,
//   s_ss = 2G/(1-nu) (e_ss + nu e_zz) + nu/(1-nu) s_nn   (METHOD 16.2).
PlaneStress boundary_stress(const double n[2], const double t[2], const double du_ds[2], double across, double shear_modulus,
                            double nu, double* hoop);

// Out of the plane: nu (sxx + syy) in plane strain, 0 in plane stress.
double stress_across(const PlaneStress& s, bool plane_strain, double nu);
// Invariants: von Mises stress with szz, and the largest shear stress in the plane.
double von_mises(const PlaneStress& s, double szz);
double largest_shear(const PlaneStress& s);

} // namespace c2d
