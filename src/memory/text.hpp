#pragma once
// A bounded builder of ASCII text for messages: no locale, no heap, no printf. Text that does not fit is cut
// off; what is there always ends with a zero byte.
#include <stddef.h>
#include <stdint.h>

#include <type_traits>

namespace c2d {

struct Text {
  char* data;  // the caller's bytes
  size_t size; // how many there are, the zero byte included; 0 is allowed (then nothing is ever written)
  size_t used; // characters so far, without the zero byte; always < size unless size is 0
};

// An empty text in bytes[0 .. N) or bytes[0 .. size).
Text text_in(char* bytes, size_t size);
template <size_t N> Text text_in(char (&bytes)[N]) {
  return text_in(bytes, N);
}

// Append. A null pointer appends nothing.
void put(Text& text, const char* characters);
void put(Text& text, const char* characters, size_t count); // exactly `count` of them, or up to a zero byte
void put_character(Text& text, char character);
void put_signed(Text& text, int64_t number);
void put_unsigned(Text& text, uint64_t number);
// Any type of integer: which of them are int32_t and int64_t differs from machine to machine.
template <class Integer, class = std::enable_if_t<std::is_integral<Integer>::value>>
void put(Text& text, Integer number) {
  if (std::is_signed<Integer>::value)
    put_signed(text, static_cast<int64_t>(number));
  else
    put_unsigned(text, static_cast<uint64_t>(number));
}
// As C's "%.<digits>g" in the C locale, correctly rounded (ties to even), 1 <= digits <= 17; "nan", "inf",
// "-inf". No floating-point operation is carried out, so nothing can trap.
void put(Text& text, double number, int32_t digits = 6);

} // namespace c2d
