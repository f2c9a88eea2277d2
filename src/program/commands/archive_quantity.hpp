// A key number of a contact, in an archive.
#pragma once

#include "post/quantities.hpp"

namespace app {

template <class Archive> void members(Archive& a, Quantity& q) {
  auto& [what, zone, item, value, at, s, along, spacing, error, images, at_corner, unbounded, doubt] =
      q; // (all members: a new one breaks the build here)
  a(what), a(zone), a(item), a(value), a(at), a(s), a(along), a(spacing), a(error), a(images), a(at_corner), a(unbounded),
      a(doubt);
}

} // namespace app
