// The CSV of --points: rows body,x,y, with or without that as a heading.
#pragma once

#include "program/messages.hpp"

#include <cstdint>
#include <vector>

namespace app {

// A point inside a body with requested results.
struct WantedPoint {
  int32_t body;
  double x, y;
  int32_t line; // of the file, or of the card in the deck
};

// Takes the rows of a file that has been read; bodies are 1 ... `bodies`. Blank lines count for nothing.
// Reports every fault to `messages`; false after any, and if there is no row.
bool read_points(const DeckFile& file, int32_t bodies, Messages& messages, std::vector<WantedPoint>& points);

} // namespace app
