#include "report/text.hpp"

#include <contact2d.h>

#include <charconv>
#include <cstdio>
#include <cstring>

namespace app {
namespace {

enum class Form { kGeneral, kScientific };

// Writes value to text[0 .. 40); returns the length.
int print_double(char* text, double value, Form form, int digits) {
  if (value == 0.0) value = 0.0; // minus zero has no meaning here
#if defined(__cpp_lib_to_chars) && __cpp_lib_to_chars >= 201611L
  const auto format = form == Form::kGeneral ? std::chars_format::general : std::chars_format::scientific;
  return static_cast<int>(std::to_chars(text, text + 40, value, format, digits).ptr - text);
#else
  return std::snprintf(text, 40, form == Form::kGeneral ? "%.*g" : "%.*e", digits, value);
#endif
}

void append_right(std::string& out, const char* text, int length, int width) {
  if (length < width) out.append(static_cast<size_t>(width - length), ' ');
  out.append(text, static_cast<size_t>(length));
}

} // namespace

void append_number(std::string& out, double value) {
  char text[40];
  out.append(text, static_cast<size_t>(print_double(text, value, Form::kGeneral, 12)));
}

void append_integer(std::string& out, int64_t value) {
  char text[24];
  const auto end = std::to_chars(text, text + sizeof text, value);
  out.append(text, static_cast<size_t>(end.ptr - text));
}

void append_column(std::string& out, int64_t value, int width) {
  char text[24];
  const auto end = std::to_chars(text, text + sizeof text, value);
  append_right(out, text, static_cast<int>(end.ptr - text), width);
}

void append_column(std::string& out, const char* word, int width) {
  append_right(out, word, static_cast<int>(std::strlen(word)), width);
}

void append_scientific(std::string& out, double value, int width, int digits) {
  char text[40];
  append_right(out, text, print_double(text, value, Form::kScientific, digits), width);
}

void append_general(std::string& out, double value, int width, int digits) {
  char text[40];
  append_right(out, text, print_double(text, value, Form::kGeneral, digits), width);
}

const char* status_word(int32_t status) {
  switch (status) {
  case C2D_OPEN:
    return "open";
  case C2D_STICK:
    return "stick";
  case C2D_SLIP:
    return "slip";
  default:
    return "none";
  }
}

const char* outcome_word(int32_t outcome) {
  switch (outcome) {
  case C2D_REACHED:
    return "reached";
  case C2D_FREE_MOTION:
    return "free motion";
  case C2D_GROSS_SLIDING:
    return "gross sliding";
  case C2D_NO_ADMISSIBLE_CHANGE:
    return "no admissible change";
  case C2D_ENDLESS_EXCHANGE:
    return "endless exchange";
  default:
    return "unknown";
  }
}

const char* tape_word(int32_t tape) {
  switch (tape) {
  case C2D_TAPE_CONTROL:
    return "control";
  case C2D_TAPE_LOWER:
    return "lower";
  case C2D_TAPE_UPPER:
    return "upper";
  case C2D_TAPE_CONTACT:
    return "contact";
  default:
    return "unknown";
  }
}

} // namespace app
