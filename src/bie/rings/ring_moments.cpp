// K(n,k) from complete elliptic integrals, or by the trapezoidal rule where the ring is far from the source or near the axis
// (METHOD 21.1). All K(n,k) are linear in K(m) and E(m), m = 4 r R / ((r + R)^2 + Z^2). K(m) and E(m) contain ln(1/(1 - m))
// times K(1 - m)/pi and (K(1 - m) - E(1 - m))/pi: the same linear combinations of these are the factors of the logarithm.
// Literature: Abramowitz and Stegun, Handbook of Mathematical Functions, 17.3 and 17.6.
#include "bie/rings/ring_moments.hpp"

#include "bie/integrals/kernels.hpp"

namespace c2d {
namespace {

constexpr double kFewPoints = 0.4; // m below which the trapezoidal rule has all digits

struct Distances {
  double b, c, s2, s; // s2 = b + 2 c, the squared distance at the far side of the ring
};

Distances distances(const RingPlace& at) {
  const double r = at.radius + at.a, sum = r + at.radius;
  const double s2 = sum * sum + at.z * at.z;
  return {at.a * at.a + at.z * at.z, 2.0 * r * at.radius, s2, sqrt(s2)};
}

// K and (K - E)/K of the parameter 1 - m1, by the arithmetic-geometric mean.
struct Elliptic {
  double k, gap;
};
Elliptic elliptic(double m1) {
  double a = 1.0, b = sqrt(m1), c = (1.0 - m1) / (2.0 * (1.0 + b)), weight = 1.0; // c: the next (a - b)/2
  double gap = 0.5 * (1.0 - m1);
  for (int i = 0; i < 12 && c > 1e-17 * a; ++i) { // twelve steps reach m1 = 1e-300
    const double mean = 0.5 * (a + b);
    gap += weight * c * c;
    b = sqrt(a * b);
    a = mean;
    c = c * c / (2.0 * (a + b));
    weight *= 2.0;
  }
  return {kPi / (a + b), gap};
}

// All K(n,k), of K(m) and E(m), or the same combinations of other numbers in their place.
RingMoments combine(const Distances& d, double k, double e) {
  const double big = d.b + d.c, product = d.b * d.s2, root = 4.0 * d.s * e; // K(-1,0)
  RingMoments out;
  out.n1[0] = 4.0 * k / d.s;
  out.n3[0] = root / product;
  out.n5[0] = (4.0 * big * out.n3[0] - out.n1[0]) / (3.0 * product);
  out.n1[1] = (root - d.b * out.n1[0]) / d.c;
  for (int i = 0; i < 2; ++i) out.n3[i + 1] = (out.n1[i] - d.b * out.n3[i]) / d.c;
  for (int i = 0; i < 3; ++i) out.n5[i + 1] = (out.n3[i] - d.b * out.n5[i]) / d.c;
  return out;
}

// 24 points on the circle, in pairs: 1 - cos f.
constexpr int kHalf = 12;
constexpr double kRise[kHalf + 1] = {
    0.0, 0.03407417371093170, 0.13397459621556135, 0.29289321881345248, 0.5, 0.74118095489747926, 1.0, 1.25881904510252074,
    1.5, 1.70710678118654752, 1.86602540378443865, 1.96592582628906830, 2.0};

double weight_of_point(int i) { return i == 0 || i == kHalf ? kPi / kHalf : 2.0 * kPi / kHalf; }

RingMoments by_points(const Distances& d) {
  RingMoments out = {};
  for (int i = 0; i <= kHalf; ++i) {
    const double u = kRise[i], q = 1.0 / (d.b + d.c * u), weight = weight_of_point(i);
    const double n1 = weight * sqrt(q), n3 = n1 * q, n5 = n3 * q;
    out.n1[0] += n1, out.n1[1] += n1 * u;
    out.n3[0] += n3, out.n3[1] += n3 * u, out.n3[2] += n3 * u * u;
    out.n5[0] += n5, out.n5[1] += n5 * u, out.n5[2] += n5 * u * u, out.n5[3] += n5 * u * u * u;
  }
  return out;
}

bool is_by_points(const Distances& d) { return 2.0 * d.c < kFewPoints * d.s2; }

} // namespace

RingMoments ring_moments(const RingPlace& at) {
  const Distances d = distances(at);
  if (is_by_points(d)) return by_points(d);
  const Elliptic whole = elliptic(d.b / d.s2);
  return combine(d, whole.k, whole.k * (1.0 - whole.gap));
}

void ring_moments_7(const RingPlace& at, const RingMoments& k, double n7[5]) {
  const Distances d = distances(at);
  if (is_by_points(d)) {
    for (int j = 0; j < 5; ++j) n7[j] = 0.0;
    for (int i = 0; i <= kHalf; ++i) {
      const double u = kRise[i], q = 1.0 / (d.b + d.c * u);
      double term = weight_of_point(i) * q * q * q * sqrt(q);
      for (int j = 0; j < 5; ++j, term *= u) n7[j] += term;
    }
    return;
  }
  n7[0] = (8.0 * (d.b + d.c) * k.n5[0] - 3.0 * k.n3[0]) / (5.0 * d.b * d.s2);
  for (int i = 0; i < 4; ++i) n7[i + 1] = (k.n5[i] - d.b * n7[i]) / d.c;
}

RingMoments ring_logarithms(const RingPlace& at) {
  const Distances d = distances(at);
  const Elliptic rest = elliptic(2.0 * d.c / d.s2);
  return combine(d, rest.k / kPi, rest.k * rest.gap / kPi);
}

} // namespace c2d
