// c2d_change_loads: new right-hand sides for the stored factorisation.
#include "contact/reduction/reduction.hpp"
#include "elimination/eliminate.hpp"
#include "interface/entry.hpp"
#include "memory/parts.hpp"

const c2d::NewLoadsPart c2d::kNewLoadsPart = {true, eliminate_again, reduce_loads};

using namespace c2d;

extern "C" c2d_status c2d_change_loads(c2d_solver* s) {
  const c2d_status status = enter(s, kStarted);
  if (status != C2D_OK) return status;
  s->loads_changed = 1;
  s->state = C2D_STATE_MODEL;
  return C2D_OK;
}
