// The cycles of a load path on the page: their numbers, and the steps of the recorded one.
#pragma once

#include "report/drawn/scene.hpp"

#include <string>

namespace app {

// Nothing without a cycle that is repeated.
void append_page_cycles(std::string& out, const Scene& scene);

} // namespace app
