// Bodies from separate curves: joins ends, finds loops and their nesting.
#pragma once

#include "program/drawing/drawing.hpp"

namespace drawing {

// Makes bodies of `drawing.curves`, which become empty: even depth of nesting is material, odd a hole in it. Ends that are not
// further apart than `join` are one; 0: kJoin of the drawing's size. The notes say what is joined, what is left out (curves
// without length, curves that lie twice, open ends), what crosses, and what may be a press fit.
void join_curves(Drawing& drawing, double join);

// Of lines that go on straight, and of arcs that go on along one circle, one is made if they bear one name. Returns how many
// curves fewer there are.
size_t tidy(Loop& loop);
// The note of that.
void note_tidied(size_t count, std::vector<std::string>& notes);

} // namespace drawing
