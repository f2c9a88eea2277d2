#include "program/sketch/deck/deck_number.hpp"

#include <algorithm>
#include <charconv>

namespace sketch {

std::string deck_number(double value) {
  if (value == 0) return " 0"; // also for minus zero
  char text[32] = " ";
  char* end = std::to_chars(text + 1, text + sizeof text, value).ptr;
  std::replace(text, end, 'e', 'E');
  return std::string(text, end);
}

} // namespace sketch
