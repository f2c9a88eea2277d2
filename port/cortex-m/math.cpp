// The C library's mathematics for images without errno: its wrappers keep an error number in a struct for
// every thread (some 100 bytes of RAM and a kilobyte of code), which nobody here reads. Names of the C
// library, so that the core needs no other; what lies behind them is newlib's where it comes without a
// wrapper. Errors of log, exp, sin and cos are below 1.5 units in the last place. Arguments are as the core
// has them: finite, in the domain.
#include <math.h>
#include <stdint.h>

extern "C" {

double __ieee754_atan2(double, double);
double __ieee754_fmod(double, double);
double __ieee754_hypot(double, double);
double __kernel_sin(double, double, int);
double __kernel_cos(double, double);
#if !defined(__ARM_FP) || !(__ARM_FP & 8)
double __ieee754_sqrt(double);

double sqrt(double x) {
  return __ieee754_sqrt(x);
}
#endif

double atan2(double y, double x) {
  return __ieee754_atan2(y, x);
}
double fmod(double x, double y) {
  return __ieee754_fmod(x, y);
}
double hypot(double x, double y) {
  return __ieee754_hypot(x, y);
}
double ldexp(double x, int power) {
  return scalbn(x, power);
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
  static const double kOdd[] = {2.0 / 21, 2.0 / 19, 2.0 / 17, 2.0 / 15, 2.0 / 13,
                                2.0 / 11, 2.0 / 9,  2.0 / 7,  2.0 / 5,  2.0 / 3};
  double sum = 0.0;
  for (const double term : kOdd) sum = (sum + term) * z;
  // 2 s = f - s f, and s f = f^2/2 - s f^2/2: the leading term f is exact.
  const double half = 0.5 * f * f;
  return power * kLog2High - ((half - (s * (half + sum) + power * kLog2Low)) - f);
}

// x = power log 2 + r, |r| <= 0.347: fourteen terms.
double exp(double x) {
  if (x < -700.0) return 0.0; // where no argument of the core lies
  if (x > 709.0) x = 709.0;
  const int power = static_cast<int>(x * 1.44269504088896340736 + (x < 0.0 ? -0.5 : 0.5));
  const double r = (x - power * kLog2High) - power * kLog2Low;
  double sum = 1.0;
  for (int n = 14; n > 1; --n) sum = 1.0 + sum * r / n;
  return scalbn(1.0 + sum * r, power);
}

// x less the nearest multiple of pi/2, of which `quarter` is the number; |x| < 1e5.
static double first_quarter(double x, int* quarter) {
  *quarter = static_cast<int>(x * 0.63661977236758134308 + (x < 0.0 ? -0.5 : 0.5));
  const double n = *quarter;
  return ((x - n * 0x1.921fb544p+0) - n * 0x1.0b4611a6p-34) - n * 0x1.3198a2e037073p-69;
}
static double turned(double r, int quarter) {
  const double value = quarter & 1 ? __kernel_cos(r, 0.0) : __kernel_sin(r, 0.0, 0);
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
