#pragma once
// One frame per contact pair, for everything: tractions, displacements, gaps (2.3).
#include "model/model.hpp"
#include "model/validate.hpp"

namespace c2d {

// Fills every Pair and head->contact. n1, n2 are the normalised sums of the unit outward normals of the
// contact elements that meet at the pair's nodes; n = (n1 - n2) / |n1 - n2|, (5.3) with its sign put right,
// unless the initial gap vector is long enough, closes and lies between n1 and -n2: then n is its direction.
// Contact unknowns are numbered in the order of pairs, the normal one before the tangential one. Needs zones
// that validate_zones has passed. Faults: interference; normals that do not oppose each other; prescribed
// displacements that are no symmetry condition. Warnings: C2D_WARN_NORMALS, C2D_WARN_KINK, C2D_WARN_OVERLAP. Returns false if
// it told a fault.
bool build_frames(const Model& m, Reporter& reporter);

// All checks and everything derived from the input, in the order that model/validate.hpp lists: units,
// frames, contact unknowns, free rigid motions. Returns false if there were faults; the model is then of no
// use.
bool complete_model(const Model& m, Reporter& reporter);

} // namespace c2d
