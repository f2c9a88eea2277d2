#pragma once
// Gauss quadrature: Legendre rules on [-1,1], rules for the weight ln(1/x) on (0,1), and the number of
// points an analytic integrand needs.

namespace c2d {

// An n-point Gauss-Legendre rule: sum_i w_i f(x_i) = int_-1^1 f, exact for polynomials up to degree 2n-1.
// `x`, `w` are the (n+1)/2 points with x >= 0 in ascending order; x[0] == 0 if n is odd.
struct GaussRule {
  const double* x;
  const double* w;
  int n;
};

struct GaussPoint {
  double x, w;
};

// The rule with n = 1, 2, 3, 4, 5, 6, 8, 10, 12, 16 or 20 points, as the core needs; any other n gives { nullptr, nullptr, 0
// }.
GaussRule gauss_legendre(int n);

// Point i = 0..n-1 of a rule, from left to right.
inline GaussPoint gauss_point(const GaussRule& rule, int i) {
  const int half = rule.n / 2;
  if (i < half) return {-rule.x[rule.n - half - 1 - i], rule.w[rule.n - half - 1 - i]};
  return {rule.x[i - half], rule.w[i - half]};
}

// An n-point rule for a logarithm: sum_i w_i f(x_i) = int_0^1 ln(1/x) f(x) dx, exact up to degree 2n-1.
// `x` ascending in (0,1), all n points stored.
struct LogRule {
  const double* x;
  const double* w;
  int n;
};

// The logarithmic rule with n = 2, 4, 10 or 16 points; any other n gives { nullptr, nullptr, 0 }.
LogRule log_gauss(int n);

// Smallest semi-major axis (rho + 1/rho)/2 of the ellipse in which an integrand with a pole of order two just
// outside must be analytic, so that n points integrate it times a polynomial of degree `degree` to a relative
// `tolerance`. 0 if n points cannot (2 n - degree < 2).
double gauss_semi_axis(int n, int degree, double tolerance);

} // namespace c2d
