#pragma once
// Operations on a tableau y = T z (METHOD 11: contact statuses change by exchanging a basic y with a nonbasic z). T is
// column-major, rows x cols; constants and rates of loads are further columns, treated like any other.
#include "linalg/kernel.hpp"
#include <stdint.h>

namespace c2d {

// Gauss-Jordan exchange: y_r and z_c change places. With p = T_rc: T_rc' = 1/p, T_rj' = -T_rj/p, T_ic' = T_ic/p, T_ij' = T_ij
// - T_ic T_rj / p. Returns false, with T unchanged, if |p| is below the smallest normal number. The caller decides whether a
// pivot is too small relative to its row or column. Applied twice it gives T back, up to round-off. Cost: 2 rows cols
// operations; with a kernel it runs at memory speed.
bool exchange(int32_t rows, int32_t cols, Real* t, int64_t ld, int32_t r, int32_t c, const Kernel* kernel = nullptr);

// exchange(a, a) and then exchange(b, b), in one pass: for a tableau larger than the caches as fast as one of them. Returns
// false, with nothing changed, if either pivot is below the smallest normal number.
bool exchange_two(int32_t rows, int32_t cols, Real* t, int64_t ld, int32_t a, int32_t b, const Kernel* kernel = nullptr);

// Row `target` += factor * row `source`: y_target is replaced by y_target + factor y_source.
void row_add(int32_t cols, Real* t, int64_t ld, int32_t target, int32_t source, Real factor);

// Column `target` += factor * column `source`: z_source is replaced by z_source - factor z_target, z_target staying.
void column_add(int32_t rows, Real* t, int64_t ld, int32_t target, int32_t source, Real factor);

} // namespace c2d
