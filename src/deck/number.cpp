#include "deck/number.hpp"

#include "memory/characters.hpp"
#include "memory/config.hpp"
#include "memory/wide_integer.hpp"

#include <string.h>

namespace c2d {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Removes outer blanks; the rest is text[0 .. width).
void trim(const char*& text, int32_t& width) {
  while (width > 0 && text[width - 1] == ' ') --width;
  while (width > 0 && text[0] == ' ') {
    ++text;
    --width;
  }
}

FieldFault malformed(const char* text, int32_t width) {
  // "1 2" is a number with a blank inside; "abc def" is not a number at all.
  bool numeric = true, blank = false;
  for (int32_t i = 0; i < width; ++i) {
    blank = blank || text[i] == ' ';
    numeric = numeric && (is_digit(text[i]) || one_of(text[i], " +-.EDed"));
  }
  return numeric && blank ? FieldFault::blank_inside : FieldFault::not_a_number;
}

// A decimal number: the digits of first[0 .. length) as an integer, times 10^exponent.
struct Parts {
  bool negative;
  const char* first; // digits, possibly with a point
  int32_t length;
  int32_t exponent;
};

// The exponent part text[at .. width), which may be missing. Large exponents are limited to +-100000: they are
// far out of range, whatever 80 columns of digits precede them.
bool exponent_part(const char* text, int32_t at, int32_t width, int32_t* exponent) {
  *exponent = 0;
  if (at == width) return true;
  const bool letter = one_of(text[at], "EDed");
  if (letter) ++at;
  const bool sign = at < width && (text[at] == '+' || text[at] == '-');
  if (!letter && !sign) return false;
  const bool negative = sign && text[at] == '-';
  if (sign) ++at;
  if (at == width) return false;
  for (; at < width; ++at) {
    if (!is_digit(text[at])) return false;
    if (*exponent < 100000) *exponent = *exponent * 10 + (text[at] - '0');
  }
  if (*exponent > 100000) *exponent = 100000;
  if (negative) *exponent = -*exponent;
  return true;
}

bool split(const char* text, int32_t width, Parts& parts) {
  int32_t at = 0;
  parts.negative = text[0] == '-';
  if (text[0] == '+' || text[0] == '-') ++at;
  parts.first = text + at;
  int32_t digits = 0, decimals = 0;
  bool point = false;
  for (; at < width && (is_digit(text[at]) || (text[at] == '.' && !point)); ++at) {
    if (text[at] == '.') {
      point = true;
      continue;
    }
    ++digits;
    if (point) ++decimals;
  }
  parts.length = static_cast<int32_t>(text + at - parts.first);
  if (digits == 0 || !exponent_part(text, at, width, &parts.exponent)) return false;
  parts.exponent -= decimals;
  return true;
}

constexpr int32_t kPrecision = 53;
constexpr int32_t kSmallestExponent = -1022; // of a normal number
constexpr int32_t kLargestExponent = 1023;

// The double nearest to mantissa * 2^exponent (plus a little if `sticky`), where mantissa has `bits` >= 54 digits.
FieldFault assemble(uint64_t mantissa, int32_t bits, int32_t exponent, bool sticky, double* value) {
  const int32_t drop = bits - kPrecision;
  const uint64_t rest = mantissa & ((uint64_t{1} << drop) - 1);
  const uint64_t half = uint64_t{1} << (drop - 1);
  mantissa >>= drop;
  exponent += drop;
  if (rest > half || (rest == half && (sticky || (mantissa & 1) != 0))) ++mantissa;
  if (mantissa >> kPrecision != 0) {
    mantissa >>= 1;
    ++exponent;
  }
  const int32_t leading = exponent + kPrecision - 1;
  if (leading > kLargestExponent) return FieldFault::too_large;
  uint64_t pattern = 0;
  if (leading >= kSmallestExponent) pattern = static_cast<uint64_t>(leading + 1023) << 52 | (mantissa & 0xfffffffffffffu);
  memcpy(value, &pattern, sizeof pattern);
  return FieldFault::none;
}

// digits * 10^exponent, where `digits` has `count` decimal digits; positive or zero.
FieldFault convert(WideInteger& digits, int32_t count, int32_t exponent, double* value) {
  *value = 0;
  if (digits.used == 0 || count + exponent < -330) return FieldFault::none;
  if (count + exponent > 330) return FieldFault::too_large;
  // 10^exponent is 5^exponent here; 2^exponent goes into the binary exponent.
  WideInteger divisor;
  wide_set(divisor, 1);
  if (exponent >= 0)
    wide_multiply_by_power_of_5(digits, exponent);
  else
    wide_multiply_by_power_of_5(divisor, -exponent);
  // Scaled by a power of two, the quotient has 62 or 63 binary digits.
  const int32_t shift = 62 - (wide_bits(digits) - wide_bits(divisor));
  if (shift >= 0)
    wide_shift_left(digits, shift);
  else
    wide_shift_left(divisor, -shift);
  const uint64_t quotient = wide_divide(digits, divisor, 63);
  const int32_t bits = quotient >> 62 != 0 ? 63 : 62;
  return assemble(quotient, bits, exponent - shift, digits.used != 0, value);
}

// As convert(), in single words, for few digits and small powers of five, as most numbers have. Small code
// omits it.
constexpr int32_t kNarrowDigits = 18, kNarrowPower = 27;

int32_t raise_to_bit_62(uint64_t& a) {
  int32_t shift = 0;
  for (; a >> 62 == 0; ++shift) a <<= 1;
  return shift;
}

FieldFault convert_narrow(uint64_t digits, int32_t exponent, double* value) {
  *value = 0;
  if (digits == 0) return FieldFault::none;
  uint64_t divisor = 1;
  for (int32_t i = exponent; i < 0; ++i) divisor *= 5;
  const int32_t shift = 62 + raise_to_bit_62(digits) - raise_to_bit_62(divisor);
  uint64_t quotient = digits >= divisor ? 1 : 0, rest = quotient != 0 ? digits - divisor : digits;
  for (int i = 0; i < 62; ++i) {
    rest <<= 1, quotient <<= 1;
    if (rest < divisor) continue;
    rest -= divisor, quotient |= 1;
  }
  return assemble(quotient, quotient >> 62 != 0 ? 63 : 62, exponent - shift, rest != 0, value);
}

FieldFault convert(const Parts& parts, double* value) {
  WideInteger digits;
  wide_set(digits, 0);
  uint64_t narrow = 0;
  int32_t count = 0; // without leading zeros
  for (int32_t i = 0; i < parts.length; ++i) {
    if (parts.first[i] == '.') continue;
    narrow = 10 * narrow + static_cast<uint64_t>(parts.first[i] - '0'); // unused if there are too many digits
    if (narrow != 0 || count > 0) ++count;
  }
  if (!kSmallCode && count <= kNarrowDigits && parts.exponent <= 0 && parts.exponent >= -kNarrowPower)
    return convert_narrow(narrow, parts.exponent, value);
  for (int32_t i = 0; i < parts.length; ++i)
    if (parts.first[i] != '.') wide_multiply(digits, 10, static_cast<uint32_t>(parts.first[i] - '0'));
  return convert(digits, count, parts.exponent, value);
}

} // namespace

bool is_blank(const char* text, int32_t width) {
  for (int32_t i = 0; i < width; ++i)
    if (text[i] != ' ') return false;
  return true;
}

FieldFault integer_field(const char* text, int32_t width, int32_t* value) {
  trim(text, width);
  if (width == 0) {
    *value = 0;
    return FieldFault::none;
  }
  const bool negative = text[0] == '-';
  const int32_t first = negative || text[0] == '+' ? 1 : 0;
  int64_t magnitude = 0;
  for (int32_t i = first; i < width; ++i) {
    if (!is_digit(text[i])) {
      double real;
      const FieldFault fault = real_field(text, width, &real);
      return fault == FieldFault::none || fault == FieldFault::too_large ? FieldFault::not_an_integer : fault;
    }
    if (magnitude <= INT32_MAX) magnitude = magnitude * 10 + (text[i] - '0');
  }
  if (first == width) return FieldFault::not_a_number;
  if (magnitude > INT32_MAX) return FieldFault::too_large;
  *value = static_cast<int32_t>(negative ? -magnitude : magnitude);
  return FieldFault::none;
}

FieldFault real_field(const char* text, int32_t width, double* value) {
  trim(text, width);
  if (width == 0) {
    *value = 0;
    return FieldFault::none;
  }
  Parts parts;
  if (width > 80 || !split(text, width, parts)) return malformed(text, width);
  const FieldFault fault = convert(parts, value);
  if (fault == FieldFault::none && parts.negative && *value > 0) *value = -*value;
  return fault;
}

const char* expectation(FieldFault fault, bool integer) {
  switch (fault) {
  case FieldFault::not_an_integer: return "an integer without point or exponent";
  case FieldFault::blank_inside: return "a number without a blank inside";
  case FieldFault::too_large: return "a number of less than 1e100 in size";
  default: return integer ? "an integer" : "a number";
  }
}

} // namespace c2d
