#pragma once
// One frame per contact pair, for everything: tractions, displacements, gaps (METHOD 8).
#include "model/model.hpp"
#include "model/validate/validate.hpp"

namespace c2d {

// Fills every Pair, Zone::shift and the numbers of contact unknowns. The normal is METHOD (8.3), of thesis (5.3) with its sign
// put right, from the normals of both surfaces where they face each other; where symmetry fixes one global direction it is the
// other. Contact unknowns of the model are numbered in the order of pairs, the normal one before the tangential one; those of a
// body (Body::contact) likewise over its own zones. Needs zones that validate_zones has passed. Faults: interference; normals
// that do not oppose each other; prescribed displacements that are no symmetry condition. Warnings: C2D_WARN_NORMALS,
// C2D_WARN_KINK, C2D_WARN_OVERLAP, C2D_WARN_SIZES. Returns false if it told a fault.
bool build_frames(const Model& m, Reporter& reporter);

// How far the surfaces may be off at a pair, as far as the boundary points tell.
double surface_doubt(const Model& m, int32_t pair);

// All checks and everything derived from the input, in the order that model/validate/validate.hpp lists: units,
// frames, contact unknowns, free rigid motions. Returns false if there were faults; the model is then of no
// use.
bool complete_model(const Model& m, Reporter& reporter);

} // namespace c2d
