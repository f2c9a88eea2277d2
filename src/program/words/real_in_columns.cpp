#include "program/words/real_in_columns.hpp"

#include <charconv>
#include <cstdlib>

namespace app {
namespace {

// |value| = 0.DIGITS * 10^exponent, with as few digits as give the double again; the first is not zero.
struct Decimal {
  std::string digits;
  int exponent;
};

Decimal shortest_decimal(double value) {
  char buffer[40];
  const std::to_chars_result end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific);
  Decimal decimal;
  const char* c = buffer;
  for (; *c != 'e'; ++c)
    if (*c >= '0' && *c <= '9') decimal.digits += *c;
  int power = 0;
  const bool negative = c[1] == '-';
  std::from_chars(c + 2, end.ptr, power);
  decimal.exponent = (negative ? -power : power) + 1;
  return decimal;
}

std::string plain(const Decimal& d) {
  const int count = static_cast<int>(d.digits.size());
  if (d.exponent > 40 || d.exponent < -40) return std::string(80, '0'); // fits nowhere
  if (d.exponent <= 0) return "." + std::string(static_cast<size_t>(-d.exponent), '0') + d.digits;
  if (d.exponent >= count) return d.digits + std::string(static_cast<size_t>(d.exponent - count), '0');
  std::string text = d.digits;
  return text.insert(static_cast<size_t>(d.exponent), ".");
}

// All digits in front of the exponent, which needs no letter: its sign marks it.
std::string scaled(const Decimal& d) {
  const int power = d.exponent - static_cast<int>(d.digits.size());
  return d.digits + (power < 0 ? "-" : "+") + std::to_string(std::abs(power));
}

} // namespace

std::string real_in_columns(double value, size_t width) {
  if (value == 0) return width > 0 ? "0" : "";
  const Decimal decimal = shortest_decimal(value < 0 ? -value : value);
  const std::string sign = value < 0 ? "-" : "";
  std::string text = sign + plain(decimal);
  if (text.size() > width) {
    text = sign + scaled(decimal);
    return text.size() > width ? "" : text;
  }
  if (decimal.exponent <= 0 && text.size() < width) text.insert(sign.size(), "0");
  if (text.find('.') == std::string::npos && text.size() + 2 <= width) text += ".0";
  return text;
}

} // namespace app
