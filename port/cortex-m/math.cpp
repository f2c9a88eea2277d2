// The C library's mathematics for images without errno: its wrappers keep an error number in a struct for
// every thread (some 100 bytes of RAM and a kilobyte of code), which is not used here, and the functions behind
// them is long. Names of the C library, so that the core needs no other. Errors of log, exp, sin and cos are
// below 1.5 units in the last place, those of hypot and atan2 below 3.5; fmod is exact. Arguments are as the core
// has them: finite, in the domain.
#include <math.h>
#include <stdint.h>
#include <string.h>

extern "C" {

#if !defined(__ARM_FP) || !(__ARM_FP & 8)
double __ieee754_sqrt(double);

double sqrt(double x) { return __ieee754_sqrt(x); }
#endif

double hypot(double x, double y) {
  const double a = fabs(x), b = fabs(y), larger = a > b ? a : b;
  if (larger == 0.0) return 0.0;
  const double p = a / larger, q = b / larger;
  return larger * sqrt(p * p + q * q);
}

// The angle in the first octant, of tangent t <= 1, is halved twice: tan(a/2) = t / (1 + sqrt(1 + t^2)). Then
// thirteen terms of the series suffice.
double atan2(double y, double x) {
  const double width = fabs(x), height = fabs(y);
  const bool steep = height > width;
  const double longer = steep ? height : width;
  double t = longer == 0.0 ? 0.0 : (steep ? width : height) / longer;
  for (int i = 0; i < 2; ++i) t /= 1.0 + sqrt(1.0 + t * t);
  double sum = 0.0;
  for (int n = 25; n > 1; n -= 2) sum = t * t * (1.0 / n - sum);
  double angle = 4.0 * (t - t * sum);
  if (steep) angle = 1.57079632679489661923 - angle;
  if (signbit(x)) angle = 3.14159265358979323846 - angle;
  return copysign(angle, y);
}

// For |power| <= 2044. What becomes less than a normal number may be rounded twice.
static double power_of_two(int power) {
  const uint64_t pattern = static_cast<uint64_t>(power + 1023) << 52;
  double value;
  memcpy(&value, &pattern, sizeof value);
  return value;
}
double ldexp(double x, int power) {
  const int half = power / 2;
  return x * power_of_two(half) * power_of_two(power - half);
}

// Subtracts the largest multiple by a power of two repeatedly: no difference is rounded.
double fmod(double x, double y) {
  const double step = fabs(y);
  double rest = fabs(x);
  while (rest >= step) {
    int to, from;
    frexp(rest, &to);
    frexp(step, &from);
    const double part = ldexp(step, to - from);
    rest -= part > rest ? 0.5 * part : part;
  }
  return copysign(rest, x);
}

constexpr double kLog2High = 0x1.62e42fefa38p-1; // 41 bits: times an exponent it is exact
constexpr double kLog2Low = 0x1.ef35793c7673p-45;

// x = 2^power m, sqrt(1/2) <= m < sqrt(2); log m = 2 artanh(s), s = (m - 1) / (m + 1), |s| < 0.172: ten
// terms.
double log(double x) {
  int power;
  double m = frexp(x, &power);
  if (m < 0.70710678118654752) {
    m *= 2.0;
    --power;
  }
  const double f = m - 1.0, s = f / (2.0 + f), z = s * s;
  static const double kOdd[] = {2.0 / 21, 2.0 / 19, 2.0 / 17, 2.0 / 15, 2.0 / 13, 2.0 / 11, 2.0 / 9, 2.0 / 7, 2.0 / 5, 2.0 / 3};
  double sum = 0.0;
  for (const double term : kOdd) sum = (sum + term) * z;
  // 2 s = f - s f, and s f = f^2/2 - s f^2/2: the leading term f is exact.
  const double half = 0.5 * f * f;
  return power * kLog2High - ((half - (s * (half + sum) + power * kLog2Low)) - f);
}

// x = power log 2 + r, |r| <= 0.347: fourteen terms.
double exp(double x) {
  if (x < -700.0) return 0.0; // the core has no such arguments
  if (x > 709.0) x = 709.0;
  const int power = static_cast<int>(x * 1.44269504088896340736 + (x < 0.0 ? -0.5 : 0.5));
  const double r = (x - power * kLog2High) - power * kLog2Low;
  double sum = 1.0;
  for (int n = 14; n > 1; --n) sum = 1.0 + sum * r / n;
  return ldexp(1.0 + sum * r, power);
}

// x less the nearest multiple of pi/2, of which `quarter` is the number; |x| < 1e5.
static double first_quarter(double x, int* quarter) {
  *quarter = static_cast<int>(x * 0.63661977236758134308 + (x < 0.0 ? -0.5 : 0.5));
  const double n = *quarter;
  return ((x - n * 0x1.921fb544p+0) - n * 0x1.0b4611a6p-34) - n * 0x1.3198a2e037073p-69;
}
// z/(n(n+1)) (1 - z/((n+2)(n+3)) (1 - ...)), nine terms: n = 2 of the sine, n = 1 of the cosine.
static double series(double z, int n) {
  double sum = 0.0;
  for (int k = n + 16; k >= n; k -= 2) sum = z / (k * (k + 1)) * (1.0 - sum);
  return sum;
}
static double turned(double r, int quarter) {
  const double value = quarter & 1 ? 1.0 - series(r * r, 1) : r - r * series(r * r, 2);
  return quarter & 2 ? -value : value;
}
double sin(double x) {
  int quarter;
  const double r = first_quarter(x, &quarter);
  return turned(r, quarter);
}
double cos(double x) {
  int quarter;
  const double r = first_quarter(x, &quarter);
  return turned(r, quarter + 1);
}

} // extern "C"
