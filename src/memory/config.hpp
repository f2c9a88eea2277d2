#pragma once
// Every option of a build, its values and its cost. No other file of src/ reads these macros or the compiler's own option
// macros; other files use the constants below. A test checks this.
//
// -DC2D_REAL=float -DC2D_REAL_BYTES=4   Matrices are stored and eliminated in single precision (default: double, 8). Half
//     the memory, results to about 2e-4 in place of 1e-9. The interface and the geometry stay double. A program that
//     includes contact2d.h gives the second of the two as well.
// -DC2D_SMALL, or -Os   Small code: plain forms only, no second version for speed. Less code; a run takes about
//     twice as long (port/cortex-m/README.md).
// -DC2D_PARTS_BY_CALL   Functions that read models of any kind (deck reader, c2d_attach) do not link the optional parts of
//     the method into a program; only the call that declares a part does. memory/parts.hpp.
// -DC2D_RINGS   Small code with bodies of revolution (C2D_AXISYMMETRIC), which other builds always have.
// -DC2D_PLAIN   Standard C++17 only: neither vectors nor hints to the processor. Small code. Selected automatically for
//     compilers without GNU extensions.
// -DC2D_ONE_FILE   The library is one source file (make amalgamation), so that all parts are there.
// -DC2D_HOSTILE=width   For tests (make hostile): panels of that many columns and hostile conditions of every kind, see
//     memory/hostile.hpp. Many times slower.
// -DC2D_COUNTED   For `make coverage`: conditions declared impossible are constants (memory/hostile.hpp).
// -ffast-math and -ffinite-math-only are refused: the compiler would remove the checks for NaN and infinity.
#include <float.h>
#include <stdint.h>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "contact2d must not be compiled with -ffast-math or -ffinite-math-only: its checks for numbers would vanish"
#endif

#ifndef C2D_REAL
#define C2D_REAL double
#endif

#if defined(__GNUC__) && !defined(C2D_PLAIN)
#define C2D_EXTENSIONS 1
#define C2D_FETCH(address, write, level) __builtin_prefetch(address, write, level)
#define C2D_STOP() __builtin_trap()
#else
#define C2D_EXTENSIONS 0
#define C2D_FETCH(address, write, level) static_cast<void>(address)
#define C2D_STOP() static_cast<void>(0)
#endif

#if defined(C2D_SMALL) || defined(__OPTIMIZE_SIZE__) || !C2D_EXTENSIONS
#define C2D_SMALL_CODE true
#define C2D_WIDEST_VECTOR 0
#else
#define C2D_SMALL_CODE false
// Bytes of the widest vectors in this file's loops: used by the files that are named after an instruction set.
#if defined(__AVX512F__) && defined(__FMA__)
#define C2D_WIDEST_VECTOR 64
#elif defined(__AVX2__) && defined(__FMA__)
#define C2D_WIDEST_VECTOR 32
#else
#define C2D_WIDEST_VECTOR 16
#endif
#endif

// Do two stored numbers fill 16 bytes?
#if !defined(C2D_REAL_BYTES) || C2D_REAL_BYTES == 8
#define C2D_TWO_IN_16_BYTES 1
#else
#define C2D_TWO_IN_16_BYTES 0
#endif

// May a linker omit optional parts, and does only the call that declares a part link it?
#if defined(__ELF__) && C2D_EXTENSIONS && !defined(C2D_ONE_FILE)
#define C2D_PARTS_MAY_LACK 1
#else
#define C2D_PARTS_MAY_LACK 0
#endif
#ifdef C2D_PARTS_BY_CALL
#define C2D_ONLY_CALLS_BRING 1
#else
#define C2D_ONLY_CALLS_BRING 0
#endif

#if C2D_SMALL_CODE && !defined(C2D_RINGS)
#define C2D_HAS_RINGS 0
#else
#define C2D_HAS_RINGS 1
#endif

#ifdef C2D_COUNTED
#define C2D_COUNTS_BRANCHES 1
#else
#define C2D_COUNTS_BRANCHES 0
#endif

#ifndef C2D_HOSTILE
#define C2D_HOSTILE 0
#endif

namespace c2d {

using Real = C2D_REAL; // of stored matrices and inner arithmetic
constexpr Real kSmallestReal = static_cast<Real>(sizeof(Real) == sizeof(float) ? double{FLT_MIN} : DBL_MIN); // with all digits
constexpr bool kSmallCode = C2D_SMALL_CODE;
constexpr bool kRings = C2D_HAS_RINGS != 0;    // bodies of revolution
constexpr int32_t kHostileWidth = C2D_HOSTILE; // of panels
constexpr bool kHostile = kHostileWidth > 0;

} // namespace c2d
