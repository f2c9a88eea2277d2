#pragma once
// Everything that can be wrong with a model, found before anything is computed. All faults are told, not only
// the first. The order in which a model is completed (contact/frames.hpp does all of it):
//   validate_data       bodies, regions and points are there, numbers are finite: the rest relies on it
//   set_units           (model/unknowns.hpp)
//   validate_symmetry   (model/symmetry.hpp) lines are found, points moved onto them, the model fits them
//   validate_geometry   the boundaries are proper closed curves
//   validate_curves     surfaces that are told fit the boundary points
//   validate_zones      contact zones refer to what is there, sides face each other
//   validate_loads      point loads
//   build_frames        (contact/frames.hpp) needs sound zones
//   validate_conditions needs frames: whether a pair may slip decides what is unknown
//   find_free_motions   (model/rigid.hpp)
#include "contact2d.h"
#include "model/model.hpp"

namespace c2d {

struct Reporter {
  void* context;
  void (*tell)(void* context, const c2d_error& entry); // may be null
  int32_t faults;                                      // how many were told; start with 0
};

// The following return false if they told a fault.
bool validate_data(const Model& m, Reporter& reporter);
bool validate_geometry(const Model& m, Reporter& reporter);
bool validate_curves(const Model& m, Reporter& reporter);
bool validate_zones(const Model& m, bool sound, Reporter& reporter); // sound: validate_geometry and its like say so
bool validate_loads(const Model& m, Reporter& reporter);
// With `frames` false the nodes of pairs are passed over.
bool validate_conditions(const Model& m, bool frames, Reporter& reporter);

// Finite and of a size (at most 1e100) whose products and squares stay finite.
bool is_usable(double number);

} // namespace c2d
