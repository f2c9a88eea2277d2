// What a loop over meshes found: its rounds, and numbers with their stated errors.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace app {

// A mesh that was solved, beside the one with elements twice as long.
struct MeshRound {
  int32_t elements = 0, pairs = 0, equations = 0;
  double seconds = 0;
  double pressure = NAN; // relative distance of the tractions from those on the mesh before, L1, of the worst contact
  double energy = NAN;   // the same of the energy
  bool adapted = false;  // the mesh before was not this one with elements twice as long: there is no distance
};

// A number of the last state of the history, or over all of it. An error is an estimate: METHOD 19.
struct Stated {
  std::string name;
  int32_t zone = 0, body = 0, item = 0; // what applies, else 0
  double value = 0, error = NAN;        // absolute
  double scale = 0;                     // what the tolerance is relative to
  double tolerance = NAN;               // NaN: it was not asked for
  double at[2] = {NAN, NAN};
  bool is_met() const { return std::isnan(tolerance) || error <= tolerance * scale; }
};

struct MeshLoop {
  std::vector<MeshRound> rounds;
  std::vector<Stated> stated;
  std::string stopped; // why it ended before all tolerances were met; empty: they are
  bool ran() const { return !rounds.empty(); }
};

} // namespace app
