// The load path as the pictures need it: every change of status in brief, and the whole table at a few steps.
#pragma once

#include "post/cycles.hpp"

#include <contact2d.h>

#include <cstdint>
#include <string>
#include <vector>

namespace app {

// Of a zone in the recorded cycle: (u2 - u1).t and tractions of the pair that is followed, and the mean of the former over the
// pairs that touch in the cycle.
struct ZonePoint {
  double shift, tn, tt, mean;
};
// One call of the step callback.
struct PathPoint {
  int32_t step = 0, kind = 0;   // C2D_STEP_...
  double load = 0.0;            // of load case 1
  double travel = 0.0;          // sum of the changes of all load factors so far
  double peak = 0.0;            // largest tn outside ties
  int32_t count[3] = {0, 0, 0}; // open, stick, slip
  int32_t events = 0;           // so far, this one included
  std::string status;           // a byte per pair: C2D_OPEN ...; empty once kMostStatusBytes are in use
  std::vector<ZonePoint> zones; // by CoefficientHistory::followed, in the recorded cycle
};
struct Snapshot {
  int32_t step = 0;
  bool is_quarter = false; // at about a quarter, a half or three quarters of the steps
  double load = 0.0;
  std::vector<double> loads; // factors of all load cases
  std::vector<double> table; // C2D_PAIR_FIELDS numbers per pair
};
// Work, elastic and dissipated energy at a recorded step.
struct EnergyPoint {
  double travel, load, work, dissipated, elastic, defect;
};
struct CoefficientHistory {
  double mu = 0.0;
  std::vector<PathPoint> points;
  std::vector<double> loads;       // factors reached, per load case
  std::vector<Snapshot> frames;    // recorded steps, at most kMostFrames, spread evenly over the steps
  std::vector<Snapshot> reversals; // the last kMostReversals recorded steps from which the loads went back
  Snapshot last, before;           // of recorded steps; of the one before the loads alone
  std::vector<EnergyPoint> energy;
  size_t cycle = 0; // the point at which the recorded cycle begins; 0: none
  std::vector<FollowedZone> followed;
};

class History {
public:
  // `steps`: increments of all load cards.
  void begin(int32_t steps) { steps_ = steps; }
  void note(const c2d_step& step);
  // A cycle that has ended, at which the recorded one may begin: `followed` as in CoefficientHistory.
  void note_cycle(const c2d_step& step, std::vector<FollowedZone> followed);
  const std::vector<CoefficientHistory>& coefficients() const { return coefficients_; }
  // All members, for an archive that reads or writes them.
  template <class Archive> void archive(Archive& a) { a(coefficients_), a(status_bytes_); }

private:
  static constexpr size_t kMostReversals = 3;
  static constexpr int32_t kMostFrames = 20; // a multiple of four
  bool is_frame(int32_t step) const;
  CoefficientHistory& history_of(const c2d_step& step);
  PathPoint point_of(const CoefficientHistory& history, const c2d_step& step);
  static void note_reversal(CoefficientHistory& history, Snapshot now);
  static constexpr size_t kMostStatusBytes = size_t{1} << 26;
  std::vector<CoefficientHistory> coefficients_;
  int32_t steps_ = 0;
  size_t status_bytes_ = 0;
};

// Points from the beginning of the recorded cycle on; empty: there is none.
std::vector<const PathPoint*> points_of_cycle(const CoefficientHistory& history);

// Earlier states drawn as thin curves beside the last one: at load reversals with a state different from
// `table`; on a path without reversals, intermediate states.
std::vector<const Snapshot*> earlier_states(const CoefficientHistory& history, int32_t last_step,
                                            const std::vector<double>& table);

// Recorded steps in their order: frames, reversals and the last.
std::vector<const Snapshot*> frames_of(const CoefficientHistory& history);

// Does the path consist of one load factor that only grows? Then charts are drawn over the load, else over
// the steps.
bool rises(const CoefficientHistory& history);
// Where each point of the path lies between the ends of the steps: step - 1 and the part of its way that is
// done.
std::vector<double> positions_by_step(const CoefficientHistory& history);

} // namespace app
