// What the steps of a run have left so far, as a text: a saved state of the path goes on with it as if there had been no end.
#pragma once

#include "program/options.hpp"
#include "report/history.hpp"
#include "report/record.hpp"
#include "report/trace.hpp"

#include <array>
#include <string>
#include <vector>

namespace app {

struct PathRecord {
  std::vector<CoefficientRecord> coefficients;
  History history;
  Trace trace;
  int32_t coefficient_shown = 0; // the coefficient whose heading stands in the listing
  std::vector<c2d_error> warnings;
  std::string latest;                        // text of the latest fault or note
  std::array<std::string, kOutputs> outputs; // by Output
};

// Every number to its last bit.
std::string text_of(PathRecord& record);
// What the text was made of; false if it is no such text, or not of this model: then `out` has no meaning.
bool read_path_record(const std::string& text, const Summary& model, PathRecord& out);

} // namespace app
