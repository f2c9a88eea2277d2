// Kelvin's kernels D and S in space (thesis (3.33), (3.34)), contracted with the traction and the displacement of a ring before
// they are integrated round the axis. With u = 1 - cos f all factors are polynomials of u: in the axes e_R, e_z at the source
//   d_R = a - r u,   d_R t_R = (1 - u)(a - r u) t_r,   d_th^2 = r^2 u (2 - u),   d_th t_th = r u (2 - u) t_r,
// th being the direction round the axis, and d.t = T0 + T1 u for each of n, t and u (METHOD 21.7).
// Literature: Brebbia, Telles and Wrobel, Boundary Element Techniques (1984), on stresses at interior points.
#include "bie/rings/ring_stress.hpp"

namespace c2d {
namespace {

// c[0] + c[1] u + ... + c[n - 1] u^(n - 1)
template <int n> struct CosineSeries { double c[n]; };

template <int n, int m> CosineSeries<n + m - 1> operator*(const CosineSeries<n>& a, const CosineSeries<m>& b) {
  CosineSeries<n + m - 1> out = {};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) out.c[i + j] += a.c[i] * b.c[j];
  return out;
}
template <int n> CosineSeries<n> operator+(CosineSeries<n> a, const CosineSeries<n>& b) {
  for (int i = 0; i < n; ++i) a.c[i] += b.c[i];
  return a;
}
template <int n> CosineSeries<n> operator*(double factor, CosineSeries<n> a) {
  for (double& c : a.c) c *= factor;
  return a;
}
// Its integral over rho^n, with the moments K(n,k).
template <int n> double integral(const CosineSeries<n>& a, const double* moment) {
  double sum = 0.0;
  for (int i = 0; i < n; ++i) sum += a.c[i] * moment[i];
  return sum;
}

using Line = CosineSeries<2>;
using Square = CosineSeries<3>;

enum Part { kRR, kZZ, kRZ, kRound, kStressParts };

struct Ring {
  double a, z, big, r;

  Line along(const double v[2]) const { return {{v[0] * a + v[1] * z, v[0] * big}}; } // d.v
  Square distances(int part) const {                                                  // d_i d_j
    switch (part) {
    case kRR: return {{a * a, -2.0 * a * r, r * r}};
    case kZZ: return {{z * z, 0.0, 0.0}};
    case kRZ: return {{a * z, -r * z, 0.0}};
    default: return {{0.0, 2.0 * r * r, -r * r}};
    }
  }
  Square with(const double v[2], int part) const { // v_i d_j + v_j d_i
    switch (part) {
    case kRR: return {{2.0 * v[0] * a, -2.0 * v[0] * (a + r), 2.0 * v[0] * r}};
    case kZZ: return {{2.0 * v[1] * z, 0.0, 0.0}};
    case kRZ: return {{v[0] * z + v[1] * a, -v[0] * z - v[1] * r, 0.0}};
    default: return {{0.0, 4.0 * v[0] * r, -2.0 * v[0] * r}};
    }
  }
};

// n_i u_j + n_j u_i
Square pair(const double n[2], const double u[2], int part) {
  const double radial = 2.0 * n[0] * u[0], mixed = n[0] * u[1] + n[1] * u[0];
  switch (part) {
  case kRR: return {{radial, -2.0 * radial, radial}};
  case kZZ: return {{2.0 * n[1] * u[1], 0.0, 0.0}};
  case kRZ: return {{mixed, -mixed, 0.0}};
  default: return {{0.0, 2.0 * radial, -radial}};
  }
}

} // namespace

RingStress ring_stress(const RingPlace& at, const RingMoments& k, double nu, const double n[2], const double t[2],
                       const double u[2]) {
  const Ring ring = {at.a, at.z, at.radius, at.radius + at.a};
  double n7[5];
  ring_moments_7(at, k, n7);
  const double t1 = 1.0 - 2.0 * nu, same = n[0] * u[0] + n[1] * u[1];
  const Line dn = ring.along(n), dt = ring.along(t), du = ring.along(u);
  const Square product = dn * du;
  double out[kStressParts];
  for (int part = 0; part < kStressParts; ++part) {
    const double on_diagonal = part == kRZ ? 0.0 : 1.0; // delta_ij
    const Square d = ring.distances(part), with_t = ring.with(t, part);
    double sum = t1 * (integral(with_t, k.n3) - on_diagonal * integral(dt, k.n3)) + 3.0 * integral(dt * d, k.n5);
    sum += 15.0 * integral(product * d, n7);
    sum -= 3.0 * t1 * (on_diagonal * integral(product, k.n5) + same * integral(d, k.n5));
    sum -= 3.0 * nu * integral(dn * ring.with(u, part) + du * ring.with(n, part), k.n5);
    sum -= t1 * integral(pair(n, u, part), k.n3) - (1.0 - 4.0 * nu) * on_diagonal * same * k.n3[0];
    out[part] = 0.5 * sum;
  }
  return {out[kRR], out[kZZ], out[kRZ], out[kRound]};
}

} // namespace c2d
