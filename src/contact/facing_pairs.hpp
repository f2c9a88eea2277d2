#pragma once
// Frames of pairs (contact/frames.hpp): what a free zone needs beside the others, and what both share.
#include "model/free_zones.hpp"
#include "model/validate_finding.hpp"

namespace c2d {

// What the contact elements that meet at one node of a pair say.
struct Surface {
  double n[2];   // normalised sum of their outward normals
  double length; // of the shortest
};

// Overlaps of a free zone that are no longer than what its elements leave open.
struct Unsure {
  int32_t count, pair; // the worst
  double overlap, doubt;
  void add(const Model& m, int32_t of_pair, double of_doubt) {
    const double size = m.pair[of_pair].overlap;
    if (size <= 0 || size > of_doubt) return;
    if (count++ > 0 && size * doubt >= overlap * of_doubt) return;
    pair = of_pair;
    overlap = size;
    doubt = of_doubt;
  }
};

// False where there is no direction.
bool make_unit(double v[2]);
// "pair 3 (node 7 of body 1, node 9 of body 2)"
void say_pair(Finding& f, const Model& m, int32_t pair);

// ---- optional (memory/optional.hpp): of pairs of free zones alone ----
// Body 1's surface where a node of body 2 faces it.
bool surface_faced(const Model& m, int32_t pair, Surface& out);
// What the smooth surfaces of both bodies take off the gap between their elements.
double bulges(const Model& m, int32_t pair, double* doubt);
// Finds the point of body 1 that the pair's node faces.
void face_node(const Model& m, const Zone& z, Pair& p);
// Node of body 1 at that point, -1 between nodes.
int32_t faced_node(const Model& m, const Pair& p);
// One warning for a zone, about the worst of its overlaps that the elements leave open.
void warn_unsure(const Model& m, int32_t zone, const Unsure& unsure, Reporter& reporter);

} // namespace c2d
