#pragma once
// At the end of a path: zones that nothing brings together, and surfaces that are not known well enough for what they decide.
#include "solver/session.hpp"

namespace c2d {

// Warnings: C2D_WARN_FAR, C2D_WARN_SURFACE, one for a zone each.
void warn_surfaces(Session& session);

} // namespace c2d
