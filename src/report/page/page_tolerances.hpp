// Tolerances of parameters on the page.
#pragma once

#include "report/drawn/scene.hpp"

#include <string>

namespace app {

// The table of wanted numbers with their shares, and what has no derivative; nothing without tolerances.
void append_page_tolerances(std::string& out, const Scene& scene);

} // namespace app
