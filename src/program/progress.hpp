// A line on standard error with the progress of the run.
#pragma once

#include "program/options.hpp"

#include <contact2d.h>

#include <cstdint>
#include <string>
#include <vector>

namespace app {

// Seconds from any origin, monotonic: for c2d_port.clock.
double clock_seconds(void* context);

// The completed share of the work: first of preparing all bodies, by the operations of their columns, then of the load path, by
// increments. It never decreases within either.
class WorkDone {
public:
  // Equations of every body; increments of one coefficient, and how many of those there are.
  void expect(const std::vector<int64_t>& equations, int32_t steps, int32_t coefficients);
  // The end of an increment.
  void reached(int32_t coefficient, int32_t step, double load);
  double share(const c2d_progress& now); // 0 ... 1
  static bool follows_load(const c2d_progress& now) { return now.phase >= C2D_PHASE_CONTACT; }
  int32_t coefficient() const { return coefficient_; }
  int32_t step() const { return step_; } // the last that ended
  int32_t steps() const { return steps_; }
  int32_t coefficients() const { return coefficients_; }

private:
  double prepared(const c2d_progress& now) const;
  double followed(const c2d_progress& now) const;
  std::vector<double> assembly_, elimination_; // operations of each body
  int32_t steps_ = 0, coefficients_ = 1, coefficient_ = 1, step_ = 0;
  double load_ = 0.0, most_ = 0.0;
  bool follows_ = false;
};

// "4 s", "3 min", "2 h".
std::string duration_text(double seconds);

class ProgressLine {
public:
  explicit ProgressLine(Progress wanted);
  ~ProgressLine() { clear(); }
  bool active() const { return active_; }
  WorkDone work;
  // For c2d_port.progress, through a pointer to the ProgressLine.
  void show(const c2d_progress& now);
  void clear();
  std::string text(const c2d_progress& now, double time); // at so many seconds

private:
  bool active_, shown_ = false, follows_ = false;
  double last_ = -1.0, begun_ = -1.0; // seconds; of this half of the work
};

} // namespace app
