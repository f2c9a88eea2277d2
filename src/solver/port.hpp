#pragma once
// The caller's port comes in here. In the hostile build (memory/hostile.hpp) what stands in tests/hostile is hung in
// between; no other build compiles that.
#include "memory/hostile.hpp"
#include "solver/solver.hpp"

namespace c2d {

// The solver's tapes go through a port that uses every freedom there is, on top of solver->port; a port without
// parallel_for gets one that takes the tasks in the wrong order.
void make_port_hostile(c2d_solver* s);
// Panels of kHostileWidth where the caller leaves that to the library, and no more memory than they need with two buffers, if
// there is that much; or than compressed elimination may need, if there is that much.
void make_memory_hostile(Sizes& sizes, Layout& layout, size_t& bytes);
// Run `prepare` with a store that fails somewhere on the way, unseen by the caller's other functions. The model must be
// none the worse for it, and what it left on the tapes must not be taken for the next preparation's.
void rehearse(c2d_solver* s, c2d_status (*prepare)(c2d_solver* s));

// At the beginning of every call: a workspace may have been moved since the last.
inline void connect_port(c2d_solver* s) {
  s->tapes.port = &s->port;
  s->tapes.busy = &s->busy;
  if constexpr (kHostile) make_port_hostile(s);
}

} // namespace c2d
