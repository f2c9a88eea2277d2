#include "program/interrupt.hpp"

#include "program/exit_code.hpp"

#include <csignal>

namespace app {
namespace {

volatile std::sig_atomic_t caught = 0; // the number of the signal
volatile std::sig_atomic_t put_off = 0;
volatile std::sig_atomic_t steps_end = 0;
c2d_solver* volatile target = nullptr;

void on_signal(int number) {
  caught = number;
  if (target != nullptr && (number != SIGTERM || steps_end == 0)) c2d_cancel(target);
}

} // namespace

void catch_interrupts() {
  struct sigaction action = {};
  action.sa_handler = on_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  const int numbers[] = {SIGINT, SIGTERM, SIGHUP};
  for (const int number : numbers) {
    struct sigaction old = {};
    if (sigaction(number, nullptr, &old) == 0 && old.sa_handler == SIG_IGN) continue; // nohup, background jobs
    sigaction(number, &action, nullptr);
  }
  std::signal(SIGPIPE, SIG_IGN); // a closed pipe or a full file is a failed write
  std::signal(SIGXFSZ, SIG_IGN);
}

void set_interrupt_target(c2d_solver* solver) { target = solver; }
bool interrupted() { return caught != 0; }
bool told_to_end() { return caught == SIGTERM; }
void put_off_interrupt() {
  put_off = caught;
  caught = 0;
  catch_interrupts();
}
int exit_put_off() { return put_off == 0 ? 0 : put_off == SIGTERM ? kExitStopped : kExitCancelled; }
void let_steps_end(bool let) { steps_end = let ? 1 : 0; }

} // namespace app
