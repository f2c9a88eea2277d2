// The points of a text file, for splines.
#pragma once

#include "program/sketch/shape.hpp"

#include <string_view>

namespace sketch {

struct PointRow {
  Point at;
  int line; // of the file
};

// Two numbers to a line, separated by a comma, a semicolon, a tab or blanks; decimal commas where something else separates.
// Skips empty lines, comments behind # or !, and
// before the first point headings: rows without a number, or that begin with a word. Throws a Fault with the line of any other
// row.
std::vector<PointRow> point_rows(std::string_view text);

} // namespace sketch
