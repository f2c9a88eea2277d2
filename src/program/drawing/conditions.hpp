// User statements for a drawing (--with), so that a changed drawing gives a complete sketch again.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace drawing {

struct Material {
  std::string body, text; // what stands behind its name
  int line;
};

struct Conditions {
  bool given = false;
  std::string head; // statements that concern the whole sketch
  std::vector<Material> materials;
  std::string tail; // contacts, loads, and bodies with an outline of their own
  bool has_title = false, has_units = false;
};

// Sorts the statements of a file: a `body` without an outline gives a body of the drawing its material.
Conditions read_conditions(std::string_view text);

} // namespace drawing
