#pragma once
// Interior points of large bodies (METHOD 16.7): the elements are grouped in clusters of a binary tree along the contour
// (FarCell). For each part of the contour a point uses the largest cluster that is far enough away, or the elements themselves.
// Only with compressed elimination (solver/demand/compressed.hpp): the tree uses the work memory that back substitution no
// longer needs.
#include "results/interior/interior_placing.hpp"

namespace c2d {

// Is the tree used for this body? It depends on its size and elimination only, so that results do not depend on which points
// are evaluated together.
bool has_far_cells(const Session& session, int b);
// Locates the points that have no place yet and sums the contributions of all elements to those inside. Errors: CANCELLED.
c2d_status evaluate_by_cells(const Session& session, int b, const Points& points);

} // namespace c2d
