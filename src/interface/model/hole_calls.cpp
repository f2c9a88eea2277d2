// c2d_link_holes.
#include "bie/holes.hpp"

const c2d::HolePart c2d::kHolePart = {true, next_hole, hole_row, hole_load, hole_normal};

extern "C" void c2d_link_holes(void) {}
