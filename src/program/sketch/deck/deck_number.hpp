// Numbers on the cards of decks that the program writes.
#pragma once

#include <string>

namespace sketch {

constexpr double kMostInDeck = 1e100; // cards hold numbers of less than this in size

// A blank and the number: as few digits as read as the same double, with a point in every locale.
std::string deck_number(double value);

} // namespace sketch
