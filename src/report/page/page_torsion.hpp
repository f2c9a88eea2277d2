// The table of loads round the axis on the page.
#pragma once

#include "report/drawn/scene.hpp"

namespace app {

void append_page_torsion(std::string& out, const Scene& scene);

} // namespace app
