// The table of fatigue parameters on the page.
#pragma once

#include "report/drawn/scene.hpp"

#include <string>

namespace app {

// Nothing if a sketch requests none.
void append_page_fatigue(std::string& out, const Scene& scene);

} // namespace app
