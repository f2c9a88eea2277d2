// The warnings of a run in an order that serves a reader.
#pragma once

#include <contact2d.h>

#include <vector>

namespace app {

// Those first that make all numbers doubtful, then what is about the contact, its mesh, and last a single place; of a kind
// (C2D_WARN_...) the order stays.
void order_warnings(std::vector<c2d_error>& warnings);

} // namespace app
