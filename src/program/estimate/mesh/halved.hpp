// The problem of a deck with every element bisected, for the comparison of two solutions.
#pragma once

#include <contact2d.h>

#include <string>

namespace estimate {

// Returns the bisected deck of `deck`, in the free form. `solver` has its model (state model or later). Each element becomes
// two, except elements of zero length. Existing boundary points, functional nodes and conditions keep their bits. New boundary
// points lie on the surface: on the line or arc of a *CURVE card; on the circle through the adjacent boundary points; in
// contact zones and on splines on the surface of METHOD 8.1; otherwise on the curve of the element. Empty on failure; `error`
// gives the reason.
std::string halved_deck(c2d_solver* solver, const std::string& deck, std::string& error);

} // namespace estimate
