// The cards after the last load card, for a deck with bisected elements. Cards without element numbers are copied.
#pragma once

#include "program/estimate/mesh/cut_body.hpp"

#include <string>
#include <vector>

namespace estimate {

// The words of a card without its comment; case is kept.
std::vector<std::string> words_of(const std::string& card);
bool is_keyword(const std::vector<std::string>& words, const char* name); // "*ZONE", in capitals

// The words of a *ZONE card. Elements are counted from 0 in their body.
struct FreeZoneCard {
  int32_t body[2]; // from 0
  bool is_self;
  Range elements[2];
  int32_t count[2]; // 0: by their numbers
};
// `offset`: per body, the offset of its element numbers in the deck.
FreeZoneCard free_zone_card(const std::vector<std::string>& words, const std::vector<int32_t>& offset);
std::string free_zone_card(const FreeZoneCard& card, const std::vector<CutBody>& bodies);
std::string curve_card(const c2d_curve& curve, const CutBody& body);
std::string platen_card(const std::vector<std::string>& words, const std::vector<int32_t>& offset,
                        const std::vector<CutBody>& bodies);

} // namespace estimate
