// The layers of a DXF file, whose names are the same in capitals and small letters.
#pragma once

#include "program/drawing/formats/dxf_groups.hpp"

#include <map>
#include <string>

namespace drawing {

std::string folded(std::string_view name); // to small letters

class Layers {
public:
  void add(const Entity& layer); // an entry of the table
  // As the table, or else the first entity on it, spells it.
  std::string spelled(std::string_view name);
  bool is_frozen(std::string_view name) const;
  // Why entities on a layer are not to be seen; empty: they are.
  std::string why_hidden(std::string_view name) const;

private:
  struct Layer {
    std::string name, hidden;
  };
  std::map<std::string, Layer> layers_; // by folded names
};

} // namespace drawing
