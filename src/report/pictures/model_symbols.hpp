// Symbols at the bodies in the picture of the model: supports, and the loads of all cases.
#pragma once

#include "report/drawn/axes.hpp"
#include "report/drawn/scene.hpp"

#include <vector>

namespace app {

// Kinds of symbols; forces have filled heads, prescribed motions open ones.
enum class Symbol {
  kTraction,
  kPointLoad,
  kDisplacement,
  kBodyForce,
  kRotation,
  kRigidMotion,
  kRigidForce,
  kRigidMoment,
  kSymbols
};

// Kinds of symbols present, for the legend, and where they stand.
struct Present {
  bool support = false;
  std::vector<Box> taken;
  std::vector<bool> load[static_cast<size_t>(Symbol::kSymbols)]; // per load case
  void note(Symbol symbol, size_t load_case);
  void cover(Point from, Point to, double half); // boxes along a line
};

// Draws into a view and records what it drew. Symbols that would crowd each other are omitted.
void draw_supports(Svg& svg, const Scene& scene, const Chart& view, Present& present);
void draw_loads(Svg& svg, const Scene& scene, const Chart& view, Present& present);
// Entries for supports and loads; they name their case if there are several.
std::vector<LegendEntry> symbol_legend(const Scene& scene, const Present& present);

} // namespace app
