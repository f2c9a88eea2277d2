#pragma once
// Is the mesh fine enough for the contact that came out? At an edge where a zone goes on the pressure rises from zero to its
// first highest value; fewer than kFewElements on that way, and a single element decides where the edge lies and how high
// the pressure is. The same for the zone that slips behind such an edge, and for one that sticks between two that slip.
// Edges at a corner, where the zone ends, are no matter of this, but for one or two pairs alone that slip up to it; there the
// pressure may have no bound, and an element that carries much of the force is too long.
#include "memory/text.hpp"
#include "solver/session.hpp"

namespace c2d {

constexpr int32_t kFewElements = 4;
constexpr double kMostAtCorner = 0.03; // of the force of a stretch of contact, in its last element

// Appends what is too coarse, and by how much it may be off; zones and pairs from 0. False: nothing is. Zones of stick and
// slip are small wherever they begin: they are looked at where `at_peak` says that the loads are at their largest.
bool tell_coarse_contact(const Session& session, bool at_peak, Text& out, int32_t* zone, int32_t* pair);

// Does the surface of a side go on beyond an end (-1: first, +1: last) of a zone without a corner, and out of contact zones?
bool goes_on(const Model& m, const Zone& z, int side, int end);

} // namespace c2d
