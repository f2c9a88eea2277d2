// A line on standard error that says how far the run is.
#pragma once

#include "program/options.hpp"

#include <contact2d.h>

namespace app {

// Seconds from any origin, monotonic: for c2d_port.clock.
double clock_seconds(void* context);

class ProgressLine {
public:
  explicit ProgressLine(Progress wanted);
  ~ProgressLine() { clear(); }
  bool active() const { return active_; }
  // For c2d_port.progress, through a pointer to the ProgressLine.
  void show(const c2d_progress& now);
  void clear();

private:
  bool active_, shown_ = false;
  double last_ = -1.0;
};

} // namespace app
