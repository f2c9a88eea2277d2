#pragma once
// The scalar of stored matrices and inner arithmetic. The C interface and the geometry are always double.
#ifndef C2D_REAL
#define C2D_REAL double
#endif

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "contact2d must not be compiled with -ffast-math or -ffinite-math-only: its checks for numbers would vanish"
#endif

namespace c2d {
using Real = C2D_REAL;
} // namespace c2d
