#pragma once
// Coulomb's law of a pair in contact, |q| <= mu p, with p the pressure and q the friction (Johnson, Contact Mechanics, 7.1).
#include "memory/math.hpp"

namespace c2d {

struct FrictionLaw {
  double mu; // coefficient of friction: 0 without friction, infinite for full adhesion, where q has no bound

  bool is_smooth() const { return mu == 0.0; }
  bool has_bound() const { return mu < static_cast<double>(INFINITY); }
  double bound(double p) const { return mu * p; }
  double slope(int32_t sign) const { return sign * mu; } // dq/dp along that side of the cone
  // What q lacks of its bound, and by how much it is beyond it. With a sign: of the bound on that side.
  double margin(double p, double q) const { return mu * p - fabs(q); }
  double margin(double p, double q, int32_t sign) const { return mu * p - sign * q; }
  double excess(double p, double q) const { return fabs(q) - mu * p; }
  double excess(double p, double q, int32_t sign) const { return sign * q - mu * p; }
  // The size of a margin's terms, pressure and friction each 1.
  double scale() const { return 1.0 + mu; }
};
constexpr FrictionLaw kFullAdhesion{static_cast<double>(INFINITY)};

} // namespace c2d
