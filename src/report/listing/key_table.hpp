// The key table: key numbers of the contact of a zone, a row per recorded step, for the listing and the page.
#pragma once

#include "report/record.hpp"

#include <string>
#include <vector>

namespace app {

struct KeyTable {
  std::vector<std::string> heading;
  std::vector<std::vector<std::string>> rows; // as long as the heading; "-": there is none
  bool is_list(size_t column) const;          // of values with commas between them
};

// Of a zone, from 1. `digits` that are significant. Places between nodes are distances along the second side (Quantity::along);
// of edges and borders all in their order. Empty without recorded steps or if nothing sums up their contact. Of very many steps
// the last kMostKeyRows alone.
constexpr size_t kMostKeyRows = 400;
KeyTable key_table(const CoefficientRecord& coefficient, int32_t zone, int digits);

} // namespace app
