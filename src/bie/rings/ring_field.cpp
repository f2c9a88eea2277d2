// The field of an element of a body of revolution at a point off the boundary (METHOD 21.7), by the panels of curved elements.
#include "bie/rings/ring_field.hpp"

#include "bie/integrals/integrals_panels.hpp"
#include "bie/rings/ring_stress.hpp"

namespace c2d {
namespace {

// See integrals_panels.hpp. The motion `reference` at the point is subtracted from u, and its tractions from t.
struct RingPoint {
  const FieldElement& e;
  const Integrator& in;
  double radius, nu;           // of the point; Poisson's ratio
  double stretch, reference_z; // the motion: stretch (r, -2 (z - z_P)) + reference_z e_z
  PointField& sum;

  void add(const Sample& s, double weight, double, Sums&) const {
    const RingPlace at = {radius, s.rx, s.ry};
    const RingMoments k = ring_moments(at);
    const RingMaterial material = {in.kappa, in.t1};
    const double n[2] = {s.nx, s.ny}, own = weight * (radius + s.rx);
    double t[2], u[2] = {0.0, 0.0}, of_t[2][2], of_u[2][2] = {};
    const Complex pull = weight * s.jacobian * measured_radius(in, s.eta) * polynomial(e.t, in.functions, s.eta);
    t[0] = pull.re, t[1] = pull.im;
    ring_displacement(at, k, material, of_t);
    if (e.displaced) {
      const Complex v = polynomial(e.u, in.functions, s.eta);
      u[0] = own * (v.re - stretch * (radius + s.rx));
      u[1] = own * (v.im - reference_z + 2.0 * stretch * s.ry);
      t[0] -= own * stretch * n[0];
      t[1] += 2.0 * own * stretch * n[1];
      ring_traction(at, k, material, n, of_u);
    }
    const RingStress stress = ring_stress(at, k, nu, n, t, u);
    c2d::add(sum.u, {of_t[0][0] * t[0] + of_t[0][1] * t[1] - of_u[0][0] * u[0] - of_u[0][1] * u[1],
                     of_t[1][0] * t[0] + of_t[1][1] * t[1] - of_u[1][0] * u[0] - of_u[1][1] * u[1]});
    sum.trace += stress.rr + stress.zz;
    c2d::add(sum.deviator, {stress.rr - stress.zz, -2.0 * stress.rz});
    add_round(sum, stress.round);
  }
  bool has_logarithm() const { return false; }
  void add_logarithm(const Sample&, double, double, Sums&) const {}
  bool resolved(const Expansion& x, const Stretch& p, bool own) const { return c2d::resolved(in, x, p, own); }
};

} // namespace

void ring_force(double nu, const double from[2], const double at[2], double u[2][2]) {
  const RingPlace place = {at[0], from[0] - at[0], from[1] - at[1]};
  ring_displacement(place, ring_moments(place), {3.0 - 4.0 * nu, 1.0 - 2.0 * nu}, u);
  for (int i = 0; i < 4; ++i) u[i / 2][i % 2] /= 4.0 * kPi * (1.0 - nu);
}

void add_ring_force(const double force[2], double nu, const double from[2], const double at[2], PointField& sum) {
  const RingPlace place = {at[0], from[0] - at[0], from[1] - at[1]};
  if (!(place.a * place.a + place.z * place.z > 1e-30)) return;
  const double k = 1.0 / (4.0 * kPi * (1.0 - nu)), none[2] = {0.0, 0.0};
  double u[2][2];
  ring_force(nu, from, at, u);
  const RingStress stress = ring_stress(place, ring_moments(place), nu, none, force, none);
  c2d::add(sum.u, {u[0][0] * force[0] + u[0][1] * force[1], u[1][0] * force[0] + u[1][1] * force[1]});
  sum.trace += k * (stress.rr + stress.zz);
  c2d::add(sum.deviator, {k * (stress.rr - stress.zz), -2.0 * k * stress.rz});
  add_round(sum, k * stress.round);
}

void add_ring_field(const FieldElement& e, const Complex& reference, double x, double y, PointField& sum) {
  Sums none;
  PointField part = {};
  const double stretch = x > 0.0 ? reference.re / x : 0.0;
  add_element_integrals(RingPoint{e, e.in, x, 0.25 * (3.0 - e.in.kappa), stretch, reference.im, part}, x, y, -1, nullptr, none);
  add_scaled(sum, e.in.k, part);
}

} // namespace c2d
