#pragma once
// Validation of a model before anything is computed. All faults are reported, not only the first. The order in which a model is
// completed (contact/pairs/frames.hpp runs all of it):
//   validate_data       bodies, regions and points exist, numbers are finite: the rest relies on it
//   set_units           (model/unknowns.hpp)
//   validate_symmetry   (model/symmetry.hpp) finds lines, moves points onto them, checks the model against them
//   validate_geometry   boundaries are simple closed curves
//   validate_curves     given curves fit the boundary points
//   validate_zones      references of contact zones are valid, sides face each other
//   validate_loads      point loads
//   build_frames        (contact/pairs/frames.hpp) needs valid zones
//   validate_conditions needs frames: the unknowns depend on whether a pair can slip
//   find_free_motions   (model/rigid.hpp)
#include "contact2d.h"
#include "model/model.hpp"

namespace c2d {

struct Reporter {
  void* context;
  void (*tell)(void* context, const c2d_error& entry); // may be null
  int32_t faults;                                      // number of faults reported; start with 0
};

// The following return false if they reported a fault.
bool validate_data(const Model& m, Reporter& reporter);
bool validate_geometry(const Model& m, Reporter& reporter);
bool validate_curves(const Model& m, Reporter& reporter);
bool validate_zones(const Model& m, bool sound, Reporter& reporter); // sound: the bodies passed validation
bool validate_loads(const Model& m, Reporter& reporter);
// frames = false: nodes of pairs are skipped.
bool validate_conditions(const Model& m, bool frames, Reporter& reporter);

// Finite, and at most 1e100 in magnitude, so that products and squares stay finite.
bool is_usable(double number);

} // namespace c2d
