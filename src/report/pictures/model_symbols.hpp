// Symbols at the bodies in the picture of the model: supports, and the loads of all cases.
#pragma once

#include "report/drawn/axes.hpp"
#include "report/drawn/scene.hpp"

#include <vector>

namespace app {

// Kinds of symbols; forces have filled heads, prescribed motions open ones.
enum class Symbol { kTraction, kPointLoad, kDisplacement, kBodyForce, kRotation, kRigidMotion, kSymbols };

// Kinds of symbols present, for the legend.
struct Present {
  bool support = false;
  std::vector<bool> load[static_cast<size_t>(Symbol::kSymbols)]; // per load case
  void note(Symbol symbol, size_t load_case);
};

// Draws into a view and records what it drew. Symbols that would crowd each other are omitted.
void draw_supports(Svg& svg, const Scene& scene, const Chart& view, Present& present);
void draw_loads(Svg& svg, const Scene& scene, const Chart& view, Present& present);
// What body forces, rotations and motions of rigid bodies cover, which stand inside bodies.
std::vector<Box> inner_symbols(const Scene& scene, const Chart& view);
// Entries for supports and loads; they name their case if there are several.
std::vector<LegendEntry> symbol_legend(const Scene& scene, const Present& present);

} // namespace app
