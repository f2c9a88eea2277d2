// Lines and numbers of drawings, in every locale alike.
#pragma once

#include "program/drawing/drawing.hpp"

#include <cstdint>
#include <string_view>

namespace drawing {

// The lines of a text, one after the other; without line ends and a byte order mark.
class Lines {
public:
  explicit Lines(std::string_view text) : text_(text) {
    if (text_.substr(0, 3) == "\xef\xbb\xbf") text_.remove_prefix(3);
  }
  bool next(std::string_view& line);
  int number() const { return number_; } // of the last one, from 1

private:
  std::string_view text_;
  int number_ = 0;
};

std::string_view trimmed(std::string_view text);
// The words of a line, at blanks.
std::vector<std::string_view> words_of(std::string_view line);
// Text of a file, shortened and printable; `shown`: in quotes.
std::string printable(std::string_view text);
std::string shown(std::string_view text);

// Throw a Fault that names the line and what was expected.
double real(std::string_view text, int line, const char* what);
int64_t whole_number(std::string_view text, int line, const char* what);

} // namespace drawing
