// Filled contours of a field known at some nodes of a rectangular grid.
#pragma once

#include "report/drawn/svg.hpp"

#include <vector>

namespace app {

struct Grid {
  size_t columns = 0, rows = 0; // nodes
  double x0 = 0.0, y0 = 0.0, dx = 1.0, dy = 1.0;
  std::vector<double> values; // columns * rows, row by row
  std::vector<char> known;    // the same
  size_t at(size_t column, size_t row) const { return row * columns + column; }
  Point place(size_t column, size_t row) const {
    return {x0 + static_cast<double>(column) * dx, y0 + static_cast<double>(row) * dy};
  }
};

// Extrapolates the field by `rings` nodes, linearly from two known nodes in a row, so
// that the cells cut by a body's boundary can be filled and then clipped.
void extend(Grid& grid, int rings);

// Polygons of the places where levels[k] <= value <= levels[k + 1] (linear on half cells); below the first
// level counts as the first band, above the last as the last. Cells with an unknown node are left out. Runs
// of cells inside one band are one rectangle.
using Polygons = Outlines;
std::vector<Polygons> fill_bands(const Grid& grid, const std::vector<double>& levels);

// Is a point inside closed curves, by the even-odd rule?
bool is_inside(const Outlines& curves, Point p);
double distance_to_outline(const Outlines& curves, Point p);

// "#rrggbb" of a place 0 ... 1 on a scale from light to dark.
std::string scale_colour(double place);

} // namespace app
