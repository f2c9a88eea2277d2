// A deck's problem once more, with every element cut in two: what a second solution is compared with.
#pragma once

#include <contact2d.h>

#include <string>

namespace estimate {

// The deck, in the free form, of the problem that `deck` describes, whose model `solver` holds (state model or later). Each
// element is two, but for those of zero length; boundary points, functional nodes and conditions that were there stay, bit for
// bit. New boundary points lie on the surface: on the line or the arc of a *CURVE card; on a circle that the boundary points
// around lie on; in contact zones, and where a spline is told, on the surface of METHOD 8.1; else on the element's own curve.
// Empty if it cannot be made, and `error` says why.
std::string halved_deck(c2d_solver* solver, const std::string& deck, std::string& error);

} // namespace estimate
