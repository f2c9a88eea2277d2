#pragma once
// The frame of a pair: n, from side 0 to side 1 of its zone, and t = (ny, -nx). Slot 0 is the normal one, slot 1 the tangential
// one.
#include "model/model.hpp"

namespace c2d {

// The global component of a slot's direction.
inline double along(const Pair& pair, int slot, int component) {
  return slot == component ? (slot == 0 ? pair.nx : -pair.nx) : pair.ny;
}
// A vector in the frame as global components, and the reverse.
inline void to_global(const Pair& pair, double normal, double tangential, double out[2]) {
  out[0] = normal * pair.nx + tangential * pair.ny;
  out[1] = normal * pair.ny - tangential * pair.nx;
}
inline void to_frame(const Pair& pair, double x, double y, double out[2]) {
  out[0] = x * pair.nx + y * pair.ny;
  out[1] = x * pair.ny - y * pair.nx;
}

} // namespace c2d
