// Results at the requested interior points.
#pragma once

#include "post/summary.hpp"

#include <contact2d.h>

#include <cstdint>
#include <string>
#include <vector>

namespace app {

struct InteriorPoint {
  int32_t body;
  double x, y;
  double values[C2D_POINT_FIELDS];
};
inline int flag_of(const InteriorPoint& p) { return static_cast<int>(p.values[C2D_POINT_FLAG]); }

// Points that form a grid, row by row: `at` says which of the points, -1 outside the body.
struct InteriorGrid {
  int32_t body;
  size_t columns, rows;
  std::vector<int64_t> at;
};

struct Interior {
  std::vector<InteriorPoint> points; // in the requested order, without points of grids outside the body
  std::vector<InteriorGrid> grids;
  int64_t count[4] = {0, 0, 0, 0}; // of the points, by C2D_POINT_INSIDE ... C2D_POINT_OUTSIDE
  int64_t clipped = 0;             // omitted points of grids
};

// body,x,y,ux,uy,sxx,syy,sxy,szz,von_mises,max_shear, part of the program's contract. The results of a point
// outside its body are written as nan.
void append_interior_header(std::string& out);
void append_interior_rows(std::string& out, const Interior& interior);

// The section of the listing: the same with principal stresses, and where the point lies.
// `loads`: those reached, of every case.
void append_interior_section(std::string& out, const Interior& interior, const Summary& summary,
                             const std::vector<double>& loads);

} // namespace app
