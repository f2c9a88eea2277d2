#pragma once
// A bounded builder of ASCII text for messages: no locale, no heap, no printf. Text that does not fit is cut off; the result
// always ends with a zero byte.
#include <stddef.h>
#include <stdint.h>

namespace c2d {

struct Text {
  char* data;  // the caller's bytes
  size_t size; // how many there are, the zero byte included; 0 is allowed (then nothing is ever written)
  size_t used; // characters so far, without the zero byte; always < size unless size is 0
};

// An empty text in bytes[0 .. N) or bytes[0 .. size).
Text text_in(char* bytes, size_t size);
template <size_t N> Text text_in(char (&bytes)[N]) { return text_in(bytes, N); }

// Append, and return the text: a call on the result then needs no argument to be loaded. A null pointer appends nothing.
Text& put(Text& text, const char* characters);
Text& put(Text& text, const char* characters, size_t count); // exactly `count` of them, or up to a zero byte
Text& put_character(Text& text, char character);
Text& put_signed(Text& text, int64_t number);
Text& put_unsigned(Text& text, uint64_t number);
Text& put_with_integer(Text& text, const char* characters, int32_t number); // both
Text& put_with_number(Text& text, const char* characters, double number);
// A number and an optional name (null or "": none), as in "body 3 (bolt)", with the characters before it.
struct Named {
  int32_t number;
  const char* name; // UTF-8, cut off between its characters
};
Text& put_with_name(Text& text, const char* characters, int32_t number, const char* name);
inline Text& put_with_name(Text& text, const char* characters, Named of) {
  return put_with_name(text, characters, of.number, of.name);
}
// Any type of integer: which of them are int32_t and int64_t differs from machine to machine.
inline Text& put(Text& text, int number) { return put_signed(text, number); }
inline Text& put(Text& text, long number) { return put_signed(text, number); }
inline Text& put(Text& text, long long number) { return put_signed(text, number); }
inline Text& put(Text& text, unsigned number) { return put_unsigned(text, number); }
inline Text& put(Text& text, unsigned long number) { return put_unsigned(text, number); }
inline Text& put(Text& text, unsigned long long number) { return put_unsigned(text, number); }
// As C's "%.<digits>g" in the C locale, correctly rounded (ties to even), 1 <= digits <= 17; "nan", "inf",
// "-inf". No floating-point operation is carried out, so nothing can trap.
Text& put(Text& text, double number, int32_t digits);
Text& put(Text& text, double number); // 6 digits

#if defined(__GNUC__)
#define C2D_IN_PLACE [[gnu::always_inline]]
#else
#define C2D_IN_PLACE
#endif

template <class T> constexpr bool kIsCharacters = false;
template <> inline constexpr bool kIsCharacters<const char*> = true;
template <class T> constexpr bool kIsNumber = false;
template <> inline constexpr bool kIsNumber<double> = true;
template <class T> constexpr bool kIsInt32 = false;
template <> inline constexpr bool kIsInt32<int> = true;
template <> inline constexpr bool kIsInt32<long> = sizeof(long) == sizeof(int32_t);

template <class T> constexpr bool kIsNamed = false; // put_with_name(text, characters, T) appends it
template <> inline constexpr bool kIsNamed<Named> = true;

// Characters and numbers one after another, in as few calls as possible: messages are a large share of a small program.
template <class Last> C2D_IN_PLACE inline Text& put_all(Text& text, Last last) { return put(text, last); }
template <class First, class Second, class... More>
C2D_IN_PLACE inline Text& put_all(Text& text, First first, Second second, More... more) {
  constexpr bool names = kIsCharacters<First>, integer = kIsInt32<Second>;
  if constexpr (names && integer && sizeof...(more) == 0)
    return put_with_integer(text, first, static_cast<int32_t>(second));
  else if constexpr (names && integer)
    return put_all(put_with_integer(text, first, static_cast<int32_t>(second)), more...);
  else if constexpr (names && kIsNamed<Second> && sizeof...(more) == 0)
    return put_with_name(text, first, second);
  else if constexpr (names && kIsNamed<Second>)
    return put_all(put_with_name(text, first, second), more...);
  else if constexpr (names && kIsNumber<Second> && sizeof...(more) == 0)
    return put_with_number(text, first, second);
  else if constexpr (names && kIsNumber<Second>)
    return put_all(put_with_number(text, first, second), more...);
  else
    return put_all(put(text, first), second, more...);
}

} // namespace c2d
