#pragma once
// Vectors of C2D_VECTOR_BYTES, their logarithm and arctangent: part of batch_loops.hpp, included nowhere else. Both functions
// are polynomials after the usual reductions, interpolated at Chebyshev points to 1e-17; neither raises a floating-point
// exception for its intended arguments. tests/test_batch.cpp compares them with the C library.
#include <stdint.h>

#define INLINED __attribute__((always_inline))
#define INLINE inline INLINED
#define OUTLINE __attribute__((noinline))

namespace c2d {
namespace {

constexpr int kDoubles = C2D_VECTOR_BYTES / 8;

typedef double Doubles __attribute__((vector_size(C2D_VECTOR_BYTES)));
typedef int64_t Bits __attribute__((vector_size(C2D_VECTOR_BYTES)));
typedef uint64_t Unsigned __attribute__((vector_size(C2D_VECTOR_BYTES)));
// Vectors at any address of a number.
typedef double Loose __attribute__((vector_size(C2D_VECTOR_BYTES), aligned(8), may_alias));

INLINE Doubles load(const double* from) { return *reinterpret_cast<const Loose*>(from); }
INLINE void save(double* to, Doubles v) { *reinterpret_cast<Loose*>(to) = v; }
INLINE Doubles all(double x) {
  return x - Doubles{}; // not the sum, which costs an addition for the sake of -0
}

INLINE Doubles lower(Doubles a, Doubles b) { return a < b ? a : b; } // (lanes)

// Pairs of lanes 0, 2, ... of a and b; of lanes 1, 3, ...: cheap on every machine. The same two functions separate x y x y ...
// after loading and restore that order before storing. low_pairs, high_pairs: alternating pairs of a and b, from the first and
// from the second halves.
#if defined(__clang__) || __GNUC__ >= 12
#define C2D_SHUFFLE(a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#else
#define C2D_SHUFFLE(a, b, ...) __builtin_shuffle(a, b, Bits{__VA_ARGS__})
#endif
#if C2D_VECTOR_BYTES == 64
INLINE Doubles evens(Doubles a, Doubles b) { return C2D_SHUFFLE(a, b, 0, 8, 2, 10, 4, 12, 6, 14); }
INLINE Doubles odds(Doubles a, Doubles b) { return C2D_SHUFFLE(a, b, 1, 9, 3, 11, 5, 13, 7, 15); }
INLINE Doubles low_pairs(Doubles a, Doubles b) { return C2D_SHUFFLE(a, b, 0, 1, 8, 9, 2, 3, 10, 11); }
INLINE Doubles high_pairs(Doubles a, Doubles b) { return C2D_SHUFFLE(a, b, 4, 5, 12, 13, 6, 7, 14, 15); }
#elif C2D_VECTOR_BYTES == 32
INLINE Doubles evens(Doubles a, Doubles b) { return C2D_SHUFFLE(a, b, 0, 4, 2, 6); }
INLINE Doubles odds(Doubles a, Doubles b) { return C2D_SHUFFLE(a, b, 1, 5, 3, 7); }
INLINE Doubles low_pairs(Doubles a, Doubles b) { return C2D_SHUFFLE(a, b, 0, 1, 4, 5); }
INLINE Doubles high_pairs(Doubles a, Doubles b) { return C2D_SHUFFLE(a, b, 2, 3, 6, 7); }
#else
INLINE Doubles evens(Doubles a, Doubles b) { return C2D_SHUFFLE(a, b, 0, 2); }
INLINE Doubles odds(Doubles a, Doubles b) { return C2D_SHUFFLE(a, b, 1, 3); }
INLINE Doubles low_pairs(Doubles a, Doubles) { return a; }
INLINE Doubles high_pairs(Doubles, Doubles b) { return b; }
#endif
INLINE double least(Doubles v) {
#if C2D_VECTOR_BYTES == 64
  v = lower(v, C2D_SHUFFLE(v, v, 4, 5, 6, 7, 0, 1, 2, 3));
  v = lower(v, C2D_SHUFFLE(v, v, 2, 3, 0, 1, 6, 7, 4, 5));
#elif C2D_VECTOR_BYTES == 32
  v = lower(v, C2D_SHUFFLE(v, v, 2, 3, 0, 1));
#endif
  return v[0] < v[1] ? v[0] : v[1];
}
#undef C2D_SHUFFLE

INLINE Doubles magnitude(Doubles x) { return x < 0.0 ? -x : x; } // (lanes)

constexpr double kLn2 = 0x1.62e42fefa0000p-1,
                 kLn2Rest = 1.6465949582897081e-12; // the first times 1100 is exact

// (ln((1+s)/(1-s)) / s - 2) / s^2 in powers of s^2, |s| <= (sqrt 2 - 1)/(sqrt 2 + 1).
constexpr double kLogarithm[] = {0.66666666666666696862, 0.3999999999989950449,  0.28571428625975484921, 0.22222211134795079855,
                                 0.1818288912526172208,  0.15331721600556041269, 0.1461644968504340586};

// ln x, x > 0 and normal: x = 2^k (1+f), 1+f within a factor sqrt 2 of 1, s = f/(2+f).
INLINE Doubles logarithm(Doubles x) {
  constexpr int64_t kHalfRoot = 0x3fe6a09e667f3bcd, kBias = int64_t(1023) << 52, kTwo52 = 0x4330000000000000;
  const Bits bits = (Bits)x;
  const Bits e = (Bits)((Unsigned)(bits + (kBias - kHalfRoot)) >> 52); // k + 1023
  const Doubles k = (Doubles)(e | kTwo52) - (4503599627370496.0 + 1023.0);
  const Doubles f = (Doubles)(bits - (e << 52) + kBias) - 1.0;
  const Doubles s = f / (2.0 + f), z = s * s;
  Doubles p = all(kLogarithm[6]);
#pragma GCC unroll 6
  for (int i = 5; i >= 0; --i) p = p * z + kLogarithm[i];
  return k * kLn2 + (f - (s * (f - z * p) - k * kLn2Rest));
}

// (atan(t)/t - 1) / t^2 in powers of t^2, |t| <= sqrt 2 - 1.
constexpr double kArctangent[] = {-0.3333333333333333016,   0.19999999999995520678,   -0.14285714284666542922,
                                  0.11111111015256361727,   -0.090909045781239018905, 0.076921831908260865637,
                                  -0.066645114473819480001, 0.058581489128022098816,  -0.050854497379402598613,
                                  0.039231658295587191303,  -0.019176887119062258989};

// atan2(y, x), sizes below 1e300; 0 where both are 0. The smaller over the larger, less atan 1 = pi/4 where
// that leaves a smaller number.
INLINE Doubles angle(Doubles y, Doubles x) {
  constexpr double kQuarter = 0x1.921fb54442d00p-1, kQuarterRest = 2.6951514290790595e-15; // times 4 exact
  const Doubles ax = magnitude(x), ay = magnitude(y);
  const Bits steep = ay > ax;
  const Doubles small = steep ? ax : ay, large = steep ? ay : ax; // (lanes)
  const Bits turned = small > 0.41421356237309503 * large;
  const Doubles over = turned ? small - large : small, under = (turned ? small + large : large) + 1e-300; // (lanes)
  const Doubles t = over / under, z = t * t;
  Doubles p = all(kArctangent[10]);
#pragma GCC unroll 10
  for (int i = 9; i >= 0; --i) p = p * z + kArctangent[i];
  // In quarters of pi: 1 if turned; steep: 2 - that; x < 0: 4 - that.
  const Doubles one = all(1.0), zero = all(0.0);
  Doubles quarters = turned ? one : zero, sign = one; // (lanes)
  quarters = steep ? 2.0 - quarters : quarters;       // (lanes)
  sign = steep ? -sign : sign;                        // (lanes)
  quarters = x < 0.0 ? 4.0 - quarters : quarters;     // (lanes)
  sign = x < 0.0 ? -sign : sign;                      // (lanes)
  const Doubles part = sign * t;
  const Doubles a = quarters * kQuarter + (part + (part * (z * p) + quarters * kQuarterRest));
  return y < 0.0 ? -a : a; // (lanes)
}

} // namespace
} // namespace c2d
