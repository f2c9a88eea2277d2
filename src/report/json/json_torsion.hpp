// Results of loads round the axis in JSON.
#pragma once

#include "post/torsion/table.hpp"

namespace app {

void append_json_torsion(std::string& out, const TorsionTable& table);

} // namespace app
