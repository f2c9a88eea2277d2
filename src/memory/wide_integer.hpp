#pragma once
// A non-negative integer of at most 1568 bits on the stack: as wide as exact conversion between decimal and
// binary needs. Used for numbers of cards and in messages, where exactness matters and speed does not.
#include <stdint.h>

namespace c2d {

struct WideInteger {
  static constexpr int kWords = 49;
  uint32_t word[kWords]; // least significant first; only word[0 .. used) is meaningful
  int32_t used;          // no leading zero words; 0 means the number 0
};

void wide_set(WideInteger& a, uint64_t value);
// a = a * factor + addend. The caller keeps the result below 2^1568.
void wide_multiply(WideInteger& a, uint32_t factor, uint32_t addend = 0);
// a = a * 5^power, power >= 0. A power of ten is this and a shift, which a caller folds into a binary exponent.
void wide_multiply_by_power_of_5(WideInteger& a, int32_t power);
// Number of binary digits; 0 for the number 0.
int32_t wide_bits(const WideInteger& a);
// a = a * 2^bits, bits >= 0. The caller keeps the result below 2^1568.
void wide_shift_left(WideInteger& a, int32_t bits);
// -1, 0, 1 as a is less than, equal to, greater than b.
int32_t wide_compare(const WideInteger& a, const WideInteger& b);
// a = a - b, where a >= b.
void wide_subtract(WideInteger& a, const WideInteger& b);
// The quotient floor(a / b), which must be below 2^bits (bits <= 64); a becomes the remainder times 2^bits, b stays. `a / b` is
// developed one binary digit at a time: a < b * 2^bits goes in, b must leave room for one more bit.
uint64_t wide_divide(WideInteger& a, WideInteger& b, int32_t bits);

} // namespace c2d
