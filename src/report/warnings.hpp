// The warnings of a run in order of importance.
#pragma once

#include <contact2d.h>

#include <vector>

namespace app {

// First those that affect all results, then those about the contact, its mesh, and last a single place; within a kind
// (C2D_WARN_...) the order stays.
void order_warnings(std::vector<c2d_error>& warnings);

} // namespace app
