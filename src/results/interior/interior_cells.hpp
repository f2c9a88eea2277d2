#pragma once
// Points inside a large body (METHOD 16.7): its elements are taken together in cells of a binary tree along the contour, and
// each point meets of every part of the contour the largest cell that is far from it, or the elements themselves. With
// compressed elimination (solver/compressed.hpp) alone: the tree lies in what back substitution has left of its work.
#include "results/interior/interior_placing.hpp"

namespace c2d {

// Does this body have one? By its size and elimination alone, so that no number depends on which points are asked for together.
bool has_far_cells(const Session& session, int b);
// Places the points that are not placed yet and sums up all that the body's elements add to those inside. Errors: CANCELLED.
c2d_status evaluate_by_cells(const Session& session, int b, const Points& points);

} // namespace c2d
