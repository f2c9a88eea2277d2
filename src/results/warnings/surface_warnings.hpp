#pragma once
// At the end of a path: zones whose surfaces stay far apart, and surfaces whose uncertainty matters for the contact.
#include "solver/session.hpp"

namespace c2d {

// Warnings: C2D_WARN_FAR, C2D_WARN_SURFACE, one per zone each.
void warn_surfaces(Session& session);

} // namespace c2d
