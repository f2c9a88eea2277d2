#pragma once
// A model as a deck of the free form, every number with all its digits.
#include "../problem.hpp"

#include <string>

namespace random_decks {

std::string deck_of(const problem::Problem& problem, const std::string& title);

} // namespace random_decks
