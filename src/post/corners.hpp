// Sharp corners with unbounded stress: positions, exponents of growth, and generalised stress intensities
// (METHOD 10.9). Tips of cracks are in cracks.hpp.
#pragma once

#include "post/corner_exponent.hpp"
#include "post/summary.hpp"

#include <contact2d.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace app {

enum class CornerKind {
  kNotch,   // a re-entrant corner between free faces
  kSupport, // where a support ends, or meets another one
  kContact, // where contact ends at a corner of a body
  kTie      // where a tie ends
};
// "notch", "end of a support", "edge of a contact", "end of a tie".
const char* name_of(CornerKind kind);

struct Corner {
  CornerKind kind = CornerKind::kNotch;
  int32_t zone = 0;         // of a contact or a tie, from 1
  bool linear = false;      // the functions
  int32_t body[2] = {0, 0}; // counter-clockwise, elastic ones only; 0: none
  double at[2] = {0, 0};
  double element = 0; // the shortest one at the corner
  double size = 0;    // distance to the next corner of the bodies
  // Elastic bodies and their faces, counter-clockwise. Of a contact the joint has the kind for which stress grows most.
  CornerShape shape;
  size_t joint = 0;     // of a contact or a tie: index of its face; of a support: the fixed face
  int32_t after = 0;    // of a contact or a tie: the side, 1 or 2, that follows the joint counter-clockwise
  double least = 1;     // the lowest exponent of all states that the joint may be in: for meshes
  bool half = false;    // a notch on a line of symmetry by images: its first or its last face is the image of the other
  double direction = 0; // of the first face, into the body, radians from the x axis
  struct Sample {
    int32_t row; // from 0: a pair of the zone, or an element's end of body[0]
    double distance;
    bool first;       // on the first face
    double normal[2]; // outward, of an element's end
  };
  std::vector<Sample> samples; // by their distance
  // Exponents below 2.6 for the states of the joint that occurred, computed once.
  struct Known {
    Face joint;
    std::vector<Complex> exponents;
  };
  mutable std::vector<Known> known;
};

// All corners of a complete model where stress is singular in some state: contacts first, in the order of the zones, then by
// bodies. None where functions are constant.
c2d_status find_corners(c2d_solver* solver, const Summary& summary, std::vector<Corner>& out);

// The field at a corner in a state. Pressure on a contact, tie or support: p = K d^(lambda - 1), d the distance, lambda the
// lowest exponent; if that is complex K is the amplitude. Notch: s_tt = K d^(lambda - 1) / sqrt(2 pi) on the bisector, and K2
// likewise with s_rt and lambda2 (Gross and Mendelson). NaN: none, as `why` says.
struct CornerState {
  CornerKind kind = CornerKind::kNotch;
  int32_t zone = 0, body[2] = {0, 0};
  double at[2] = {0, 0};
  const char* joint = "";         // "stick", "slip" or "tied"; "free" for a notch, "held" for a support
  std::vector<Complex> exponents; // those that are singular; empty: stress is bounded
  double K = NAN, K2 = NAN;
  double K_error = NAN, K2_error = NAN; // estimates
  std::string why;
};
// Of contacts and ties, from a table of the pairs, of any recorded step.
CornerState corner_state(const Corner& corner, const double* table, int64_t stride);
// Of all corners, at the load reached. Only those where stress is singular.
c2d_status corner_states(c2d_solver* solver, const Summary& summary, const std::vector<Corner>& corners,
                         std::vector<CornerState>& out);

} // namespace app
