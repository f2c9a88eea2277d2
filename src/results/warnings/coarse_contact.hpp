#pragma once
// Is the mesh fine enough for the computed contact? From a contact edge the pressure rises from zero to its first maximum; with
// fewer than kFewElements in between a single element decides where the edge lies and how high the pressure is. The same
// applies to slip zones behind such an edge and to stick zones between two slip zones. At a corner the contact has a fixed
// edge: there only one or two slipping pairs alone, or a last element that carries much of the force (unbounded pressure), are
// reported.
#include "memory/text.hpp"
#include "solver/session.hpp"

namespace c2d {

constexpr int32_t kFewElements = 4;
constexpr double kMostAtCorner = 0.03; // of the force of a stretch of contact, in its last element

// Appends where the mesh is too coarse, with the uncertainties; zones and pairs from 0. False: nowhere. Stick and slip zones
// are small when they begin, so they are examined only at the largest loads (`at_peak`).
bool tell_coarse_contact(const Session& session, bool at_peak, Text& out, int32_t* zone, int32_t* pair);

// Does the surface of a side continue beyond an end (-1: first, +1: last) of a zone, without a corner and outside contact
// zones?
bool goes_on(const Model& m, const Zone& z, int side, int end);

} // namespace c2d
