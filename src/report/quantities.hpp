// The numbers that sum up a state of the contact: where it ends, where stick ends, peaks, resultants, what friction took.
// Edges and borders lie between nodes (METHOD 17). A number may carry a stated error, which is an estimate.
#pragma once

#include "report/summary.hpp"

#include <contact2d.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace app {

enum class Measure {
  kPeakPressure, // and where
  kMeanPressure, // over what touches
  kContactEdge,  // where contact ends: value is the length along side 2, from its first pair
  kStickBorder,  // where stick meets slip, likewise
  kForceX,
  kForceY,
  kMoment, // on side 2, the moment about the origin
  kApproach,
  kShift,        // c2d_zone_state
  kDissipated,   // by the whole contact since zero load
  kEdgePressure, // L of p = L sqrt(d) at a contact edge, d the distance inside
  kEdgeFriction, // K of q = K / sqrt(d) where a stuck contact ends
};

struct Quantity {
  Measure what = Measure::kPeakPressure;
  int32_t zone = 0; // from 1; 0: of all
  int32_t item = 0; // of several of a zone, from 1 along side 2
  double value = 0;
  double at[2] = {NAN, NAN};
  double error = NAN; // stated, absolute; NaN: none is
};

// The pairs of a zone in order along side 2, and the length along the surface from the first to each.
struct ZoneLine {
  int32_t zone = 0;
  std::vector<int32_t> pair; // from 0: rows of a step's table
  std::vector<double> s;
  std::vector<double> x, y; // on side 2
  bool round = false;       // the side is a whole closed curve
  double length = 0;        // of side 2; of a round one all of it
};

// Of a complete model, in the order of the zones.
c2d_status find_zone_lines(c2d_solver* solver, const Summary& summary, std::vector<ZoneLine>& out);

// Of the state that a table shows (a step callback's, or one filled by c2d_get).
// Zones without a touching pair have forces alone. `states` is one per zone (c2d_get_zone_state), `dissipated` as in c2d_step.
std::vector<Quantity> quantities_of(const std::vector<ZoneLine>& lines, const double* table, int64_t stride,
                                    const std::vector<c2d_zone_state>& states, double dissipated);

// "peak pressure", "contact edge", in the words of listing, JSON and CSV.
const char* name_of(Measure what);

} // namespace app
