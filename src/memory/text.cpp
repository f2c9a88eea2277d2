// Text for messages, without heap, locale or printf. Numbers are converted exactly with wide integers and no floating-point
// operation, so a message has the same characters on every machine.
// Literature: Steele and White, How to Print Floating-Point Numbers Accurately, PLDI 1990 (exact conversion with integers).
#include "memory/text.hpp"

#include "memory/config.hpp"
#include "memory/hostile.hpp"
#include "memory/wide_integer.hpp"

#include <string.h>

namespace c2d {

Text text_in(char* bytes, size_t size) {
  if (size > 0) bytes[0] = '\0';
  return Text{bytes, size, 0};
}

Text& put_character(Text& text, char character) {
  if (text.used + 1 >= text.size) return text;
  text.data[text.used++] = character;
  text.data[text.used] = '\0';
  return text;
}

Text& put(Text& text, const char* characters, size_t count) {
  if (characters == nullptr) return text;
  for (size_t i = 0; i < count && characters[i] != '\0'; ++i) put_character(text, characters[i]);
  return text;
}

Text& put(Text& text, const char* characters) { return put(text, characters, SIZE_MAX); }

namespace {

// Removes the last decimal digit. Small code divides in pieces of 16 bits, because the compiler's division of 64-bit numbers
// is long on a small processor.
char take_digit(uint64_t& number) {
  uint64_t quotient = 0;
  uint32_t rest = 0;
  if (!kSmallCode) {
    quotient = number / 10;
    rest = static_cast<uint32_t>(number % 10);
  }
  for (int32_t shift = 48; kSmallCode && shift >= 0; shift -= 16) {
    rest = rest << 16 | static_cast<uint32_t>(number >> shift & 0xffff);
    quotient = quotient << 16 | rest / 10;
    rest %= 10;
  }
  number = quotient;
  return static_cast<char>('0' + rest);
}

} // namespace

Text& put_unsigned(Text& text, uint64_t number) {
  char digits[20];
  size_t first = sizeof digits;
  do digits[--first] = take_digit(number);
  while (number != 0);
  return put(text, digits + first, sizeof digits - first);
}

Text& put_signed(Text& text, int64_t number) {
  if (number < 0) put_character(text, '-');
  return put_unsigned(text, number < 0 ? 0 - static_cast<uint64_t>(number) : static_cast<uint64_t>(number));
}

Text& put_with_integer(Text& text, const char* characters, int32_t number) { return put_signed(put(text, characters), number); }

Text& put_with_name(Text& text, const char* characters, int32_t number, const char* name) {
  put_with_integer(text, characters, number);
  if (name == nullptr || name[0] == '\0') return text;
  put(text, " (");
  // Whole characters only: text that is cut inside a character of UTF-8 would be invalid.
  for (size_t bytes = 0; name[0] != '\0'; name += bytes) {
    for (bytes = 1; (name[bytes] & 0xc0) == 0x80;) ++bytes; // of one character
    // A character that does not fit ends the text: a shorter one behind it must not follow.
    if (text.size > 0 && text.used + bytes >= text.size) text.size = text.used + 1;
    put(text, name, bytes);
  }
  return put_character(text, ')');
}

Text& put_with_number(Text& text, const char* characters, double number) { return put(put(text, characters), number); }

Text& put(Text& text, double number) { return put(text, number, 6); }

namespace {

uint64_t power_of_10(int32_t power) {
  uint64_t value = 1;
  for (; power > 0; --power) value *= 10;
  return value;
}

// round(mantissa * 2^exponent * 10^scale), ties to even, for a result below 2^63: the quotient of two wide integers. Powers of
// 2 are shifts, so only powers of 5 are multiplied.
uint64_t scaled_and_rounded(uint64_t mantissa, int32_t exponent, int32_t scale) {
  WideInteger above, below;
  wide_set(above, mantissa);
  wide_set(below, 1);
  if (scale >= 0)
    wide_multiply_by_power_of_5(above, scale);
  else
    wide_multiply_by_power_of_5(below, -scale);
  exponent += scale;
  if (exponent >= 0)
    wide_shift_left(above, exponent);
  else
    wide_shift_left(below, -exponent);
  // The quotient is developed bit by bit, only as many bits as it can have.
  const int32_t bits = wide_bits(above) - wide_bits(below) + 1;
  if (C2D_NEVER(bits < 0)) return 0; // the first digit requested is not 0
  const uint64_t quotient = wide_divide(above, below, bits);
  wide_multiply(above, 2); // the remainder against one half
  const int32_t half = wide_compare(above, below);
  return quotient + (half > 0 || (half == 0 && (quotient & 1) != 0) ? 1 : 0);
}

struct Decimal {
  uint64_t digits;  // 10^(n-1) <= digits < 10^n
  int32_t exponent; // of the first digit
};

// The n significant decimal digits of mantissa * 2^exponent, mantissa > 0.
Decimal decimal(uint64_t mantissa, int32_t exponent, int32_t n) {
  int32_t bits = 0;
  for (uint64_t m = mantissa; m != 0; m >>= 1) ++bits;
  // The value lies in [2^top, 2^(top+1)); floor(top * log10(2)) is the decimal exponent or one less.
  const int32_t top = exponent + bits - 1;
  int32_t e10 = top * 30103 / 100000;
  if (top < 0) --e10;
  // log10(2) is rounded down in the estimate above: it is never too large.
  for (;; ++e10) {
    const uint64_t digits = scaled_and_rounded(mantissa, exponent, n - 1 - e10);
    if (digits < power_of_10(n)) return Decimal{digits, e10};
    // Either the estimate was one too small, or rounding carried into a new digit: the next turn serves both.
  }
}

void put_digits(Text& text, const char* digits, int32_t count, int32_t exponent, bool scientific) {
  if (scientific) {
    put(text, digits, 1);
    if (count > 1) put_character(text, '.');
    put(text, digits + 1, static_cast<size_t>(count - 1));
    put(text, exponent < 0 ? "e-" : "e+");
    const int32_t size = exponent < 0 ? -exponent : exponent;
    if (size < 10) put_character(text, '0');
    put(text, size);
    return;
  }
  if (exponent < 0) {
    put(text, "0.");
    for (int32_t i = exponent + 1; i < 0; ++i) put_character(text, '0');
  }
  for (int32_t i = 0; i < count || i <= exponent; ++i) {
    if (i == exponent + 1 && exponent >= 0) put_character(text, '.');
    put_character(text, i < count ? digits[i] : '0');
  }
}

} // namespace

Text& put(Text& text, double number, int32_t digits) {
  uint64_t pattern;
  static_assert(sizeof pattern == sizeof number, "a double has 64 bits");
  memcpy(&pattern, &number, sizeof pattern);
  const int32_t biased = static_cast<int32_t>(pattern >> 52 & 0x7ff);
  uint64_t mantissa = pattern & 0xfffffffffffffu;
  if (biased == 0x7ff && mantissa != 0) return put(text, "nan");
  if (pattern >> 63 != 0) put_character(text, '-');
  if (biased == 0x7ff) return put(text, "inf");
  if (biased == 0 && mantissa == 0) return put(text, "0");
  if (biased != 0) mantissa |= uint64_t{1} << 52;
  if (digits < 1) digits = 1;
  if (digits > 17) digits = 17;
  const Decimal value = decimal(mantissa, (biased == 0 ? 1 : biased) - 1075, digits);

  char shown[17];
  uint64_t rest = value.digits;
  for (int32_t i = digits - 1; i >= 0; --i) shown[i] = take_digit(rest);
  int32_t count = digits;
  while (count > 1 && shown[count - 1] == '0') --count;
  put_digits(text, shown, count, value.exponent, value.exponent < -4 || value.exponent >= digits);
  return text;
}

} // namespace c2d
