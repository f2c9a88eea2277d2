// Result of mesh refinement: its rounds, and numbers with their stated errors.
#pragma once

#include "post/measure.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace app {

// A number of the last state of the history, or over all of it. An error is an estimate: METHOD 16.5.
struct Stated {
  Measure what = Measure::kTractions;
  std::string of;                       // name of the curve that it is along or on, else empty
  int32_t zone = 0, body = 0, item = 0; // if applicable, else 0
  double value = 0, error = NAN;        // absolute
  double scale = 0;                     // reference of the tolerance
  double tolerance = NAN;               // NaN: not requested
  double at[2] = {NAN, NAN};
  double along = NAN;    // Quantity::along of that place
  int32_t images = 1;    // Quantity::images
  bool endless = false;  // it does not converge as the mesh is refined: it may be unbounded; without an error it is
  bool confirmed = true; // confirmed by another round or another error estimate
  // What the error was made of, the terms of METHOD (16.7), for the next round and for fits of the weights: the difference of
  // the two meshes, that of the round before reduced, the distance of the tractions times the scale, the spacing of pairs, the
  // difference from another method on the same mesh; and the error with the second in place of the first.
  double apart = NAN, before = NAN, hidden = NAN, spacing = 0, doubt = 0, error_by_before = NAN;
  int way = 0; // method by which it was found: higher is better
  std::string name() const { return name_of(what) + of; }
  bool has_value() const { return what != Measure::kTractions; }
  double relative_error() const { return scale > 0 ? error / scale : NAN; }
  bool is_unbounded() const { return endless && std::isnan(error); }
  bool is_within() const { return std::isnan(tolerance) || error <= tolerance * scale; }
  bool is_met() const { return is_within() && (confirmed || std::isnan(tolerance)); }
};

// Where the elements of a curve begin and end, in their order; closed: round an outline, the first is the last.
struct MeshCurve {
  int32_t body = 1;
  bool closed = false;
  std::vector<std::array<double, 2>> ends;
};

// A mesh that was solved, beside the one with elements twice as long.
struct MeshRound {
  int32_t elements = 0, pairs = 0, equations = 0;
  double seconds = 0;
  double pressure = NAN;         // relative distance of the tractions from those on the mesh before, L1, of the worst contact
  double energy = NAN;           // the same of the energy
  bool adapted = false;          // the previous mesh was not this one with elements twice as long: no distance is defined
  std::vector<MeshCurve> curves; // of all bodies that have elements
  std::vector<Stated> stated;    // numbers with errors stated on this mesh; empty without a distance
};

struct MeshLoop {
  std::vector<MeshRound> rounds;
  size_t taken = 0; // the round, from 0, with the mesh of the results
  std::vector<Stated> stated;
  std::string stopped; // why it ended before all tolerances were met; empty: they are
  bool ran() const { return !rounds.empty(); }
  // Is a requested tolerance not met? Meshes of a deck are not adapted and have no tolerances.
  bool missed() const {
    for (const Stated& s : stated)
      if (!s.is_met()) return true;
    return stated.empty() && !stopped.empty() && ran() && rounds.front().adapted;
  }
  // In a sentence; empty if nothing was asked for.
  std::string ending() const {
    if (!stopped.empty()) return "It ended here: " + stopped;
    for (const Stated& s : stated)
      if (!std::isnan(s.tolerance)) return "Every number that was asked for is as accurate as was asked";
    return std::string();
  }
};

} // namespace app
