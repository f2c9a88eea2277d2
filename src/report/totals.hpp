// Forces and moments of a body: of the modelled part, and of the whole if a line of symmetry cuts it.
#pragma once

#include "post/summary.hpp"

#include <string>
#include <vector>

namespace app {

struct BodyTotal {
  std::string of; // "loads and supports", "contact", "lines of symmetry", "sum", or the same of the whole body
  double force[3];
  bool is_sum = false; // zero but for round-off and the error of the solution
};

// Body from 1. If the body meets lines of symmetry, their share completes the balance of the part. With one line there are
// totals of the whole, too; a body beside the lines is whole.
std::vector<BodyTotal> totals_of(const Summary& summary, int32_t body);

// What the rows mean, with lines of symmetry; else empty.
const char* words_of_totals(const Summary& summary);

} // namespace app
