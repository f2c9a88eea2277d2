#pragma once
// The scalar of stored matrices and inner arithmetic. The C interface and the geometry are always double.
#ifndef C2D_REAL
#define C2D_REAL double
#endif

#ifdef __FAST_MATH__
#error "contact2d must not be compiled with -ffast-math: its checks for non-finite numbers would vanish"
#endif

namespace c2d {
using Real = C2D_REAL;
} // namespace c2d
