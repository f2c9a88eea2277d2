// Responses about tolerances of parameters: "derivative peak pressure by R", "worst case contact edge 1".
#pragma once

#include "program/sweep/responses.hpp"

namespace app {

// Takes the words before the name of a number, and `by R` at the end. False: the words are none such.
bool take_tolerance_words(std::vector<std::string>& words, Response& r);

// NaN: there is no such number, it has no derivative, or the parameter has no tolerance.
double of_tolerances(const Response& r, const ToleranceTable& table);

// The words besides those of numbers.
std::vector<std::string> tolerance_words();

} // namespace app
