#include "program/drawing/formats/dxf_layers.hpp"

#include <algorithm>

namespace drawing {
namespace {

constexpr const char* kFrozen = "is frozen";

// Data that LibreCAD adds to a layer: a construction layer has 1 there.
bool is_for_construction(const Entity& layer) {
  const Group* const own =
      std::find_if(layer.first, layer.last, [](const Group& g) { return g.code == 1001 && folded(g.value) == "librecad"; });
  for (const Group* g = own; g != layer.last && (g == own || g->code != 1001); ++g)
    if (g->code == 1070) return g->value == "1";
  return false;
}

std::string why_hidden(const Entity& layer) {
  if ((layer.flags(70) & 1) != 0) return kFrozen;
  if (layer.flags(62) < 0) return "is off";
  if (is_for_construction(layer)) return "is a construction layer";
  return layer.has(290) && layer.flags(290) == 0 ? "is not plotted" : "";
}

} // namespace

std::string folded(std::string_view name) {
  std::string out(name);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

void Layers::add(const Entity& layer) {
  layers_[folded(layer.text(2))] = {std::string(layer.text(2)), drawing::why_hidden(layer)};
}

std::string Layers::spelled(std::string_view name) {
  return layers_.try_emplace(folded(name), Layer{std::string(name), ""}).first->second.name;
}

bool Layers::is_frozen(std::string_view name) const { return why_hidden(name) == kFrozen; }

std::string Layers::why_hidden(std::string_view name) const {
  const auto layer = layers_.find(folded(name));
  return layer == layers_.end() ? "" : layer->second.hidden;
}

} // namespace drawing
