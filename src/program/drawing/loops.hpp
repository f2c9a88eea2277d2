// From curves that lie loose to bodies: ends are joined, loops found, and what encloses what.
#pragma once

#include "program/drawing/drawing.hpp"

namespace drawing {

// Makes bodies of `drawing.curves`, which become empty: even depth of nesting is material, odd a hole in it. Ends that are not
// further apart than `join` are one; 0: kJoin of the drawing's size. Tells in the notes what is left out: curves without
// length, curves that lie twice, open ends.
void join_curves(Drawing& drawing, double join);

// Of lines that go on straight, and of arcs that go on along one circle, one is made if they bear one name.
void tidy(Loop& loop);

} // namespace drawing
