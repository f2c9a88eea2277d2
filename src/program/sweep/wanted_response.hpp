// Responses about numbers that a sketch requests and no step has: "SWT of top", "SWT of top plane", "stress xx 2".
#pragma once

#include "program/sweep/responses.hpp"

namespace app {

// Does the name of a requested number begin with these words?
bool is_name_of_wanted(const std::string& text);

// Takes the words of a response about a number that no step has. False: they are none such.
bool take_wanted_words(const std::vector<std::string>& words, Response& r);

// `stated` are the numbers of the run. NaN: there is no such number, or it has no place or plane.
double of_wanted(const Response& r, const std::vector<Stated>& stated);

} // namespace app
