#pragma once
// Points of the plane, and coefficients, as complex numbers.

namespace c2d {

struct Complex {
  double re, im;
};

inline Complex operator+(Complex a, Complex b) { return {a.re + b.re, a.im + b.im}; }
inline Complex operator-(Complex a, Complex b) { return {a.re - b.re, a.im - b.im}; }
inline Complex operator*(Complex a, Complex b) { return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re}; }
inline Complex operator*(double s, Complex a) { return {s * a.re, s * a.im}; }
inline Complex conj(Complex a) { return {a.re, -a.im}; }
inline double dot(Complex a, Complex b) { return a.re * b.re + a.im * b.im; }
inline void add(Complex& sum, Complex a) { sum = sum + a; }
// c[0] + c[1] eta + ... + c[n - 1] eta^(n - 1).
inline Complex polynomial(const Complex* c, int n, double eta) {
  Complex sum = c[n - 1];
  for (int k = n - 2; k >= 0; --k) sum = eta * sum + c[k];
  return sum;
}

} // namespace c2d
