// SIGINT, SIGTERM and SIGHUP end a run in order; a second one ends it at once.
#pragma once

#include <contact2d.h>

namespace app {

void catch_interrupts();
// The solver to be told, null for none.
void set_interrupt_target(c2d_solver* solver);
bool interrupted();
bool told_to_end(); // by SIGTERM: there is some time left
// What was reached by now is written first: nothing is interrupted any longer, unless a further signal comes.
void put_off_interrupt();
// The exit status that the signal that was put off ends the program with; 0: none was.
int exit_put_off();
// Until the next call SIGTERM does not cancel what the target does: who runs it looks at told_to_end().
void let_steps_end(bool let);

} // namespace app
