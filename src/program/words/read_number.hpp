// A number that is the whole of a text, in every locale.
#pragma once

#include <charconv>
#include <string>
#include <string_view>
#include <type_traits>

namespace app {

template <class Number> bool read_number(std::string_view text, Number& number) {
  const char* const end = text.data() + text.size();
  const std::from_chars_result result = std::from_chars(text.data(), end, number);
  return result.ec == std::errc() && result.ptr == end;
}

// The same with a plus sign, or of reals with D before the exponent, as in Fortran.
template <class Number> bool read_fortran_number(std::string text, Number& number) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.erase(0, 1);
  for (char& c : text)
    if (!std::is_integral_v<Number> && (c == 'd' || c == 'D')) c = 'e';
  return read_number(text, number);
}

} // namespace app
