// Integers of up to 1568 bits in words of 32 bits, the classical algorithms with a carry in 64 bits: Knuth, The Art of
// Computer Programming, vol. 2, section 4.3.1. Division is done bit by bit: it is short, and only messages and numbers of
// cards need it.
#include "memory/wide_integer.hpp"

namespace c2d {

void wide_set(WideInteger& a, uint64_t value) {
  a.used = 0;
  for (; value != 0; value >>= 32) a.word[a.used++] = static_cast<uint32_t>(value);
}

void wide_multiply(WideInteger& a, uint32_t factor, uint32_t addend) {
  // word * factor + carry fits into 64 bits for any words of 32 bits.
  uint64_t carry = addend;
  for (int32_t i = 0; i < a.used; ++i) {
    carry += static_cast<uint64_t>(a.word[i]) * factor;
    a.word[i] = static_cast<uint32_t>(carry);
    carry >>= 32;
  }
  if (carry != 0 && a.used < WideInteger::kWords) a.word[a.used++] = static_cast<uint32_t>(carry);
}

void wide_multiply_by_power_of_5(WideInteger& a, int32_t power) {
  constexpr uint32_t kFiveTo13 = 1220703125u; // the largest power of 5 in 32 bits
  for (; power >= 13; power -= 13) wide_multiply(a, kFiveTo13);
  for (; power > 0; --power) wide_multiply(a, 5);
}

int32_t wide_bits(const WideInteger& a) {
  if (a.used == 0) return 0;
  int32_t bits = 32 * (a.used - 1);
  for (uint32_t top = a.word[a.used - 1]; top != 0; top >>= 1) ++bits;
  return bits;
}

void wide_shift_left(WideInteger& a, int32_t bits) {
  const int32_t words = bits / 32;
  const int32_t rest = bits % 32;
  if (a.used == 0) return;
  const int32_t old_used = a.used;
  a.used = old_used + words + 1;
  if (a.used > WideInteger::kWords) a.used = WideInteger::kWords;
  for (int32_t i = a.used - 1; i >= 0; --i) {
    const int32_t from = i - words;
    // From the top down, since the words move upwards in place.
    const uint64_t high = from >= 0 && from < old_used ? a.word[from] : 0;
    const uint64_t low = from >= 1 ? a.word[from - 1] : 0;
    a.word[i] = static_cast<uint32_t>(((high << 32 | low) << rest) >> 32);
  }
  while (a.used > 0 && a.word[a.used - 1] == 0) --a.used;
}

int32_t wide_compare(const WideInteger& a, const WideInteger& b) {
  if (a.used != b.used) return a.used < b.used ? -1 : 1;
  for (int32_t i = a.used - 1; i >= 0; --i)
    if (a.word[i] != b.word[i]) return a.word[i] < b.word[i] ? -1 : 1;
  return 0;
}

void wide_subtract(WideInteger& a, const WideInteger& b) {
  uint64_t borrow = 0;
  for (int32_t i = 0; i < a.used; ++i) {
    const uint64_t take = (i < b.used ? b.word[i] : 0) + borrow;
    borrow = a.word[i] < take ? 1 : 0;
    a.word[i] = static_cast<uint32_t>(a.word[i] - take);
  }
  while (a.used > 0 && a.word[a.used - 1] == 0) --a.used;
}

uint64_t wide_divide(WideInteger& a, WideInteger& b, int32_t bits) {
  // b becomes larger than any quotient bit can reach; a is doubled once per bit instead of b being halved.
  wide_shift_left(b, bits);
  uint64_t quotient = 0;
  for (int32_t i = 0; i < bits; ++i) {
    wide_multiply(a, 2);
    quotient <<= 1;
    if (wide_compare(a, b) >= 0) {
      wide_subtract(a, b);
      quotient |= 1;
    }
  }
  return quotient;
}

} // namespace c2d
