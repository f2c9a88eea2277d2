// Key numbers of a contact state: contact edges, stick borders, peaks, resultants, dissipation.
// Edges and borders lie between nodes (METHOD 16.4). A number may carry a stated error, which is an estimate.
#pragma once

#include "post/cycles.hpp"
#include "post/measure.hpp"
#include "post/summary.hpp"
#include "post/zone_line.hpp"

#include <contact2d.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace app {

// Is a number the larger one, by more than round-off? Of equal pressures the first is then the peak on every machine.
inline bool is_larger(double value, double other) { return value > other + 1e-9 * std::fabs(other); }

struct Quantity {
  Measure what = Measure::kPeakPressure;
  int32_t zone = 0; // from 1; 0: of all
  int32_t item = 0; // of several of a zone, from 1 along side 2; 0: a zone has one
  double value = 0;
  double at[2] = {NAN, NAN};
  double s = NAN;         // the length along side 2, from its first pair, of that place
  double along = NAN;     // its distance along the second side of the statement: ZoneLine::along
  double spacing = NAN;   // of an edge: how far apart the pairs are there; of a border, that and the mean of the zone
  double error = NAN;     // stated, absolute; NaN: none
  int32_t images = 1;     // of a width: how many images of an edge it counts
  bool at_corner = false; // an edge: contact ends at a body's corner; a peak: it lies at one
  bool unbounded = false; // a peak: it grows as the mesh is refined; at a corner only a solver can tell (estimate/trial)
  double doubt = 0;       // difference from another method on the same mesh
  // Is it one of a rigid body or platen?
  bool is_of_body() const { return zone == 0 && item > 0; }
};

// Of the state that a table shows (a step callback's, or one filled by c2d_get).
// Tied zones have forces alone, those without a touching pair also what they have dissipated. `states` is one per zone
// (c2d_get_zone_state), `bodies` one per body (c2d_get_body_state), `dissipated` as in c2d_step. `slip_at_turn`: C2D_SLIP_SUM
// of every pair where the loads last changed their direction; without it (empty) stick borders are right on a load path that
// has not turned yet. `cycle`: null if no cycle has been repeated.
std::vector<Quantity> quantities_of(const std::vector<ZoneLine>& lines, const double* table, int64_t stride,
                                    const std::vector<c2d_zone_state>& states, double dissipated,
                                    const std::vector<double>& slip_at_turn = {},
                                    const std::vector<c2d_body_state>& bodies = {}, const CycleResults* cycle = nullptr);

// What is round-off: forces and moments beside the largest force of a state, lengths beside the size of the model.
struct RoundOff {
  double force, size;
  double of(Measure what) const; // numbers of at most this size
  // The value to show: 0 if it is round-off, or less than a hundredth of its stated error (NaN: none).
  double shown(Measure what, double value, double error = NAN) const;
};
RoundOff round_off(const std::vector<Quantity>& all, double size);

} // namespace app
