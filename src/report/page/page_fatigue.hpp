// The table of fatigue parameters on the page.
#pragma once

#include "post/stated.hpp"
#include "report/drawn/scene.hpp"

#include <string>

namespace app {

// Is a number a fatigue parameter?
bool is_fatigue(const Stated& s);

// Nothing if a sketch requests none.
void append_page_fatigue(std::string& out, const Scene& scene);

} // namespace app
