// Contact edges and stick-slip borders between the pairs of a zone (METHOD 16.4).
#pragma once

#include "post/zone_line.hpp"

#include <contact2d.h>

#include <cstdint>
#include <vector>

namespace app {

// The state of one zone, in the order of its line.
struct LineState {
  const ZoneLine& line;
  std::vector<int32_t> status;
  std::vector<double> tn, tt, gap;
  std::vector<double> nx, ny;
  std::vector<double> slip; // on the current segment of the load path
};
constexpr double kNoFriction = 1e-8; // of the largest pressure: less friction is round-off
// `slip_at_turn`: of all pairs at the last load reversal; empty: unknown, or 0.
LineState line_state(const ZoneLine& line, const double* table, int64_t stride, const std::vector<double>& slip_at_turn);

struct ContactEdge {
  double s = 0;      // along the line; on a round one it may lie beyond the length, or before 0
  int32_t last = 0;  // place in the line of the last pair that touches
  int direction = 1; // 1: the contact ends as s rises, -1: as it falls
  bool at_corner = false;
};
// For every stretch of contact, in the order of s. Stretches that end on a line of symmetry or with the zone have no edge
// there.
std::vector<ContactEdge> find_contact_edges(const LineState& state);

// Where stick meets slip within a stretch of contact, in the order of s.
std::vector<double> find_stick_borders(const LineState& state);

// A quantity at an edge from the pairs inside the contact. `doubt`: its uncertainty, the change with other pairs.
struct EdgeValue {
  double value = 0, doubt = 0;
};

// Magnitude of the slip at an edge that slips; 0: it sticks, or ends at a corner.
EdgeValue edge_slip(const LineState& state, const ContactEdge& edge);

// L of p = L sqrt(d), d the distance inside, and K of tt = K / sqrt(d) where the contact sticks up to its edge. NaN: too few
// pairs near the edge, a corner, or no such state.
EdgeValue edge_pressure(const LineState& state, const ContactEdge& edge);
EdgeValue edge_friction(const LineState& state, const ContactEdge& edge);

} // namespace app
