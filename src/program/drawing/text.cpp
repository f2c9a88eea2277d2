#include "program/drawing/text.hpp"

#include "program/words/read_number.hpp"

#include <cmath>

namespace drawing {

bool Lines::next(std::string_view& line) {
  if (text_.empty()) return false;
  const size_t end = text_.find_first_of("\r\n");
  line = text_.substr(0, end);
  const size_t ending = end == std::string_view::npos ? 0 : text_.substr(end, 2) == "\r\n" ? 2 : 1;
  text_.remove_prefix(line.size() + ending);
  ++number_;
  return true;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> out;
  for (size_t at = 0; at < line.size();) {
    const size_t first = line.find_first_not_of(" \t", at);
    if (first == std::string_view::npos) break;
    const size_t end = std::min(line.find_first_of(" \t", first), line.size());
    out.push_back(line.substr(first, end - first));
    at = end;
  }
  return out;
}

std::string printable(std::string_view text) {
  std::string out;
  for (const char c : text.substr(0, 40))
    out += static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7f ? '?' : c;
  return out + (text.size() > 40 ? "..." : "");
}

std::string shown(std::string_view text) { return "'" + printable(text) + "'"; }

namespace {

template <class Number> bool read_trimmed(std::string_view text, Number& number) {
  std::string_view digits = trimmed(text);
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
  return app::read_number(digits, number);
}

} // namespace

double real(std::string_view text, int line, const char* what) {
  double value = 0;
  if (read_trimmed(text, value) && std::fabs(value) <= 1e100) return value; // neither infinite nor NaN
  throw Fault{line, std::string(what) + " is " + shown(trimmed(text)) + ", expected a number"};
}

int64_t whole_number(std::string_view text, int line, const char* what) {
  int64_t value = 0;
  if (read_trimmed(text, value)) return value;
  throw Fault{line, std::string(what) + " is " + shown(trimmed(text)) + ", expected a whole number"};
}

} // namespace drawing
