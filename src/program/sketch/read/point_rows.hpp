// The points of a text file, for splines.
#pragma once

#include "program/sketch/shapes/shape.hpp"

#include <string_view>

namespace sketch {

struct PointRow {
  Point at;
  int line; // of the file
};

// Two numbers per line, separated by a comma, a semicolon, a tab or blanks. A comma is a decimal comma if another character
// separates the numbers. Skips empty lines, comments after # or !, and headings before the first point: rows without a number,
// or that begin with a word. Throws a Fault with the line of any other row.
std::vector<PointRow> point_rows(std::string_view text);

} // namespace sketch
