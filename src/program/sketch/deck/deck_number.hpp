// Numbers on cards of generated decks.
#pragma once

#include <string>

namespace sketch {

constexpr double kMostInDeck = 1e100; // numbers on cards are smaller than this in magnitude

// A blank and the number, with the fewest digits that give the same double, and a decimal point in every locale.
std::string deck_number(double value);

} // namespace sketch
