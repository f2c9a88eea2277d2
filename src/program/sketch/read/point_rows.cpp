#include "program/sketch/read/point_rows.hpp"

#include "program/words/read_number.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {
namespace {

using Fields = std::vector<std::string_view>;

std::string_view trimmed(std::string_view text) {
  const size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

// Splits at every `separator`; an empty last field is dropped.
Fields split_at(std::string_view text, char separator) {
  Fields out;
  while (true) {
    const size_t end = text.find(separator);
    out.push_back(trimmed(text.substr(0, end)));
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 1);
  }
  if (out.size() > 1 && out.back().empty()) out.pop_back();
  return out;
}

Fields split_at_blanks(std::string_view text) {
  Fields out;
  for (text = trimmed(text); !text.empty();) {
    const size_t end = std::min(text.find_first_of(" \t"), text.size());
    out.push_back(text.substr(0, end));
    text = trimmed(text.substr(end));
  }
  return out;
}

bool ends_in_comma(std::string_view field) { return !field.empty() && (field.front() == ',' || field.back() == ','); }

// A comma is a decimal comma if another character separates exactly two fields; otherwise it is a separator.
Fields fields_of(std::string_view row, bool& decimal_comma) {
  const bool has_semicolon = row.find(';') != std::string_view::npos;
  const Fields strong = has_semicolon ? split_at(row, ';') : split_at_blanks(row);
  decimal_comma = strong.size() == 2 && std::none_of(strong.begin(), strong.end(), ends_in_comma);
  if (decimal_comma || (has_semicolon && strong.size() > 1)) return strong;
  Fields out;
  for (const std::string_view field : split_at(strong.size() == 1 ? strong[0] : row, ',')) {
    const Fields words = split_at_blanks(field);
    if (words.empty()) out.push_back(field);
    out.insert(out.end(), words.begin(), words.end());
  }
  return out;
}

// Accepts a plus sign, quotes, and the Fortran exponent letter D.
bool read_number(std::string_view field, bool decimal_comma, double& value) {
  if (field.size() > 1 && field.front() == '"' && field.back() == '"') field = trimmed(field.substr(1, field.size() - 2));
  std::string text(field);
  if (decimal_comma && std::count(text.begin(), text.end(), ',') == 1 && text.find('.') == std::string::npos)
    text[text.find(',')] = '.';
  return app::read_fortran_number(text, value);
}

bool is_word(std::string_view field) {
  return !field.empty() &&
         std::all_of(field.begin(), field.end(), [](char c) { return (c | 0x20) >= 'a' && (c | 0x20) <= 'z'; });
}

Point point_of(const Fields& fields, bool decimal_comma, int line) {
  if (fields.size() != 2)
    throw Fault{{line, 0, 0},
                std::to_string(fields.size()) + (fields.size() == 1 ? " column" : " columns") +
                    ", expected two numbers: x and y"};
  double value[2] = {};
  for (size_t i = 0; i < 2; ++i)
    if (!read_number(fields[i], decimal_comma, value[i]) || !std::isfinite(value[i]))
      throw Fault{{line, 0, 0},
                  std::string(i == 0 ? "x" : "y") + " is " + in_quotes(std::string(fields[i])) + ", expected a number"};
  return {value[0], value[1]};
}

} // namespace

std::vector<PointRow> point_rows(std::string_view text) {
  if (text.substr(0, 3) == "\xef\xbb\xbf") text.remove_prefix(3); // a byte order mark
  if (text.find('\0') != std::string_view::npos || text.substr(0, 2) == "\xff\xfe" || text.substr(0, 2) == "\xfe\xff")
    throw Fault{{1, 0, 0}, "the file has two bytes per character, expected text in UTF-8 or ASCII"};
  std::vector<PointRow> out;
  for (int line = 1; !text.empty(); ++line) {
    const size_t end = std::min(text.find_first_of("\r\n"), text.size());
    std::string_view row = text.substr(0, end);
    text.remove_prefix(std::min(end + (text.substr(end, 2) == "\r\n" ? 2 : 1), text.size()));
    row = trimmed(row.substr(0, row.find_first_of("#!")));
    if (row.empty()) continue;
    bool decimal_comma = false;
    const Fields fields = fields_of(row, decimal_comma);
    double value = 0;
    const auto is_number = [&](std::string_view field) { return read_number(field, decimal_comma, value); };
    const bool is_heading = out.empty() && (std::none_of(fields.begin(), fields.end(), is_number) ||
                                            (is_word(fields.front()) && !is_number(fields.front())));
    if (!is_heading) out.push_back({point_of(fields, decimal_comma, line), line});
  }
  return out;
}

} // namespace sketch
