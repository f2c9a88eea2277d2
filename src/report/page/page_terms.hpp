// Names, units and meanings of the quantities on the page.
#pragma once

#include "post/measure.hpp"
#include "report/drawn/scene.hpp"

#include <string>

namespace app {

// Empty without units.
std::string unit_of(Measure what, const Scene& scene);

// Words that name a quantity, as they end a link to its meaning.
std::string term_of(Measure what);

// A sentence; empty for a number whose name says it.
const char* meaning_of(Measure what);

// The name as a link to the meaning.
std::string term_link(Measure what);

} // namespace app
