#pragma once
// Frames of pairs (contact/pairs/frames.hpp): what a free zone needs beside the others, and what both share.
#include "model/free_zones.hpp"
#include "model/validate/validate_finding.hpp"

namespace c2d {

// What the contact elements that meet at one node of a pair say.
struct Surface {
  double n[2];   // normalised sum of the surface's outward normals
  double x, y;   // the point of the surface
  double length; // of the shortest element
  double doubt;  // how far the surface may be off there
};
// Adds one of them; start with zeros and length -1.
void add_surface(const Model& m, int b, int32_t element, double eta, Surface& out);

// False where there is no direction.
bool make_unit(double v[2]);
// "pair 3 (node 7 of body 1, node 9 of body 2)"
void say_pair(Finding& f, const Model& m, int32_t pair);

// ---- optional (memory/parts.hpp): of pairs of free zones alone ----
// Finds the point of side 0 that the pair's node of side 1 faces, and the surface there.
bool surface_faced(const Model& m, int32_t pair, Surface& out);
// Node of side 0 at that point, -1 between nodes.
int32_t faced_node(const Model& m, const Pair& p);
} // namespace c2d
