// The results of the steps so far, as a text: with it a run continues from a saved state as if not interrupted.
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

// Numbers keep all bits.
std::string text_of(PathRecord& record);
// Reads the text; false if it is not such a text or belongs to another model: `out` is then undefined.
bool read_path_record(const std::string& text, const Summary& model, PathRecord& out);

} // namespace app
