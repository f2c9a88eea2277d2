// The report: one HTML page that needs nothing else, with the pictures inline.
#pragma once

#include "report/pictures/pictures.hpp"

#include <string>

namespace app {

void append_page(std::string& out, const Scene& scene, const Pictures& pictures, const std::string& deck_name);

} // namespace app
