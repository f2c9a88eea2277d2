#pragma once
// Is the mesh fine enough for the work of friction? The external work between two states minus the change of elastic energy
// must equal the dissipated energy (METHOD 15). Both are compared from one load reversal to the next, and over two such
// segments, a cycle of a cyclic load. During first loading the elastic energy dominates and its error hides that of friction:
// segments are compared only where the dissipation is at least a tenth of the change of elastic energy.
#include "memory/text.hpp"
#include "solver/session.hpp"

namespace c2d {

// Appends the difference if it exceeds a tenth of the dissipation. `at_end`: also compare up to the current state, not only up
// to the last reversal. False: nothing to report.
bool tell_friction_work(const Session& session, bool at_end, Text& out);

} // namespace c2d
