// Every change of status on the load path, as CSV: place, statuses and reason.
#pragma once

#include <contact2d.h>

#include <string>
#include <vector>

namespace app {

// mu,step,event,load[,load2 ...],pair,from,to,why
void append_trace_header(std::string& out, int32_t load_cases);

// Sees every step of c2d_run's callback, changes included. Event 0 lists the statuses with which a coefficient begins;
// then there is a row for each pair that changed, with the same number for those that changed at one event.
class Trace {
public:
  struct State {
    int status, side; // side: of the friction on side 2, -1 or +1
  };
  void append(std::string& out, const c2d_step& step);
  // All members, for an archive that reads or writes them.
  template <class Archive> void archive(Archive& a) { a(before_), a(coefficient_), a(event_); }

private:
  std::vector<State> before_;
  int32_t coefficient_ = 0;
  int64_t event_ = 0;
};

} // namespace app
