// The run summary as one JSON object; its keys are part of the program's contract.
#pragma once

#include "report/record.hpp"

#include <contact2d.h>

#include <string>

namespace app {

// How the mesh was found, and the numbers with their stated errors, as an object.
void append_accuracy(std::string& out, const MeshLoop& loop);
// The influence of parameters with tolerances, as an object.
void append_tolerances(std::string& out, const ToleranceTable& table);
// The cycles of the load path, of each coefficient of friction (json_cycles.cpp).
void append_json_cycles(std::string& out, const RunRecord& record, const Summary& summary);
void append_json(std::string& out, const RunRecord& record, const Summary& summary);

} // namespace app
