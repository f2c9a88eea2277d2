// SIGINT, SIGTERM and SIGHUP end a run in order; a second one ends it at once.
#pragma once

#include <contact2d.h>

namespace app {

void catch_interrupts();
// The solver to be cancelled; null: none.
void set_interrupt_target(c2d_solver* solver);
bool interrupted();
bool told_to_end(); // by SIGTERM, with some time left
// Results are written first: only another signal interrupts from now on.
void put_off_interrupt();
// Exit status of the deferred signal; 0: none.
int exit_put_off();
// Until the next call SIGTERM does not cancel the target; the caller checks told_to_end().
void let_steps_end(bool let);

} // namespace app
