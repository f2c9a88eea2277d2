#pragma once
// Long vectors made orthonormal.
#include "linalg/engine.hpp"

namespace c2d {

double product(const Real* a, const Real* b, int32_t n);
void subtract(int32_t n, Real* from, double part, const Real* what); // part * what
// x[0 ... count) of n numbers, made orthonormal in place; the same sums of y, of rows numbers each (or null). Twice, so that
// they are so to the last digit. False if one is no direction of its own.
bool orthonormalise(int32_t n, int32_t count, Real* x, int32_t rows, Real* y);
// The same of many, count <= n, as products of matrices. `scratch`: n n numbers are enough.
bool orthonormalise(const Engine& engine, int32_t n, int32_t count, Real* x, int32_t rows, Real* y, Real* scratch);

} // namespace c2d
