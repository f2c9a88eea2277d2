// How stress grows towards a corner: stress ~ r^(lambda - 1), displacement ~ r^lambda, of wedges that meet at a point. Needs no
// solver (METHOD 10.9).
#pragma once

#include <complex>
#include <vector>

namespace app {

constexpr double kPi = 3.14159265358979323846;
constexpr double kSingular = 1 - 5e-3; // closer to 1 the stress hardly grows on any mesh

// Condition on a face, between a body and its surroundings or between two bodies (a joint).
enum class FaceKind {
  kFree,    // no traction
  kBonded,  // outside: fixed; between bodies: bonded
  kSmooth,  // outside: no normal motion, no shear; between bodies: no relative normal motion, no shear
  kRubbing, // as smooth, with the shear stress (r, theta) = friction times the normal stress
  kGuided   // only outside: no tangential motion, no normal stress; a line of antisymmetry
};
struct Face {
  FaceKind kind = FaceKind::kFree;
  // Under pressure friction > 0 is a force away from the corner on the body that follows counter-clockwise, and one towards it
  // on the body before.
  double friction = 0;
};

struct Sector {
  double angle = 0;         // radians
  double shear_modulus = 1; // G
  double kappa = 1.8;       // 3 - 4 nu in plane strain, (3 - nu)/(1 + nu) in plane stress
};
Sector sector_of(double angle, double youngs_modulus, double poisson_ratio, bool plane_strain);

// Counter-clockwise: face 0, sector 0, face 1, sector 1, ..., the last face. One face more than sectors.
struct CornerShape {
  std::vector<Sector> sectors;
  std::vector<Face> faces;
};

using Complex = std::complex<double>;

// Zero where a field of power lambda exists; analytic, and real on the real axis.
Complex corner_determinant(const CornerShape& shape, Complex lambda);

// All exponents with 0.002 < real part < `below`, by rising real part, one of each conjugate pair (imaginary part >= 0, below
// 1); a double one appears twice. Those within 1e-6 of 1 are omitted: a rotation, or uniform stress.
std::vector<Complex> corner_exponents(const CornerShape& shape, double below = 1);

// Real part of the lowest exponent; 1 where stress is bounded.
double exponent(const CornerShape& shape);

} // namespace app
