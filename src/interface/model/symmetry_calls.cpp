// c2d_set_symmetry.
#include "interface/model/refuse.hpp"
#include "memory/parts.hpp"
#include "model/symmetry.hpp"

const c2d::SymmetryPart c2d::kSymmetryPart = {
    true, c2d_set_symmetry, validate_lines, lines_along, lines_at_corner, is_held_by_lines, fold_across};

namespace c2d {
C2D_BRINGS(c2d_link_holes); // a boundary and its image can form a hole
} // namespace c2d

using namespace c2d;

extern "C" c2d_status c2d_set_symmetry(c2d_solver* s, int32_t axis, double value) {
  const c2d_status status = enter_building(s);
  if (status != C2D_OK) return status;
  if (!in_range(axis, 0, 1)) return refuse_number(s, C2D_ERR_ARGUMENT, "axis of symmetry", axis, 0, 1);
  if (!is_usable(value)) return refuse_value(s, "place of the line of symmetry", value, "a finite number");
  ModelHeader& m = s->model;
  if ((m.symmetry_asked >> axis & 1) != 0)
    return refuse(s, C2D_ERR_ARGUMENT, "a second line of symmetry in this direction, expected one at most");
  m.symmetry_asked |= 1 << axis;
  m.line_at[axis] = value;
  return built(s);
}
