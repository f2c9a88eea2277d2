// Numbers with their stated errors.
#pragma once

#include "post/measure.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace app {

// A number of the last state of the history, or over all of it. An error is an estimate: METHOD 16.5.
struct Stated {
  Measure what = Measure::kTractions;
  std::string of;                       // name of the curve that it is along or on, else empty
  int32_t zone = 0, body = 0, item = 0; // if applicable, else 0
  double value = 0, error = NAN;        // absolute
  double scale = 0;                     // reference of the tolerance
  double unseen = 0;                    // what a mesh may not resolve is judged by: where it is above `scale`, in place of it
  double tolerance = NAN;               // NaN: not requested
  double at[2] = {NAN, NAN};
  double along = NAN;    // Quantity::along of that place
  double angle = NAN;    // of a fatigue parameter: of the normal of its plane from x, in degrees
  int32_t images = 1;    // Quantity::images
  bool endless = false;  // it does not converge as the mesh is refined: it may be unbounded; without an error it is
  bool confirmed = true; // confirmed by another round or another error estimate
  // What the error was made of, the terms of METHOD (16.7), for the next round and for fits of the weights: the difference of
  // the two meshes, that of the round before reduced, the distance of the tractions times the scale, the spacing of pairs, the
  // difference from another method on the same mesh; and the error with the second in place of the first.
  double apart = NAN, before = NAN, hidden = NAN, spacing = 0, doubt = 0, error_by_before = NAN;
  bool other_rule = false; // of a cycle in which the pressure changes: slip follows the edges, and settles slowly
  int way = 0;             // method by which it was found: higher is better
  std::string name() const { return name_of(what) + of; }
  bool has_value() const { return what != Measure::kTractions; }
  double relative_error() const { return scale > 0 ? error / scale : NAN; }
  bool is_unbounded() const { return endless && std::isnan(error); }
  bool is_within() const { return std::isnan(tolerance) || error <= tolerance * scale; }
  bool is_met() const { return is_within() && (confirmed || std::isnan(tolerance)); }
};

} // namespace app
