#pragma once
// The two ways in which interior.cpp evaluates an element.
#include "bie/interior.hpp"

namespace c2d {

inline Complex operator+(Complex a, Complex b) { return {a.re + b.re, a.im + b.im}; }
inline Complex operator-(Complex a, Complex b) { return {a.re - b.re, a.im - b.im}; }
inline Complex operator*(Complex a, Complex b) { return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re}; }
inline Complex operator*(double s, Complex a) { return {s * a.re, s * a.im}; }
inline Complex conj(Complex a) { return {a.re, -a.im}; }
inline double dot(Complex a, Complex b) { return a.re * b.re + a.im * b.im; }
inline void add(Complex& sum, Complex a) { sum = sum + a; }

// Closed forms on a straight element whose measure is constant.
void add_field_straight(const FieldElement& e, Complex reference, double x, double y, PointField& sum);

} // namespace c2d
