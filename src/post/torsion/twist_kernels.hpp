// Kernels of torsion round an axis (METHOD 21.10): the angle phi = v/r of the displacement v round the axis, and the shear
// traction tau round it. With these kernels, for a source on the boundary at the radius R, after division by R:
//   int t (phi - phi_P) ds = (1/G) int u tau ds.
// A rigid rotation, phi = const, satisfies it whatever the mesh is.
#pragma once

namespace app {

struct TwistKernels {
  double u, t; // factors of tau and of phi, per unit of length of the section
};

// The ring at the radius R + a > 0, the height z above the source, with the outward normal n. R >= 0, not both at one place.
TwistKernels twist_kernels(double radius, double a, double z, const double n[2]);

} // namespace app
