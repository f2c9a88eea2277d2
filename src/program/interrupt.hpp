// SIGINT, SIGTERM and SIGHUP end a run in order; a second one ends it at once.
#pragma once

#include <contact2d.h>

namespace app {

void catch_interrupts();
// The solver to be told, null for none.
void set_interrupt_target(c2d_solver* solver);
bool interrupted();

} // namespace app
