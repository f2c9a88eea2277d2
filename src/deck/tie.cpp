// *TIE zone: a zone of the cards before, matching or free, is bonded.
#include "deck/keywords.hpp"

namespace c2d {

void read_tie(Deck& deck, const Words& keyword_card) {
  Cards& cards = deck.cards;
  int32_t zone = 0;
  if (deck.sizes.zones == 0)
    return void(word_fault(cards, keyword_card, 0, "no contact zone is defined yet, expected *TIE after the zones"));
  const bool known = integer_word(cards, keyword_card, 0, "contact zone", 1, deck.sizes.zones, &zone);
  if (!end_of_words(cards, keyword_card, 1) || !known || deck.sink == nullptr) return;
  place_words(deck, keyword_card);
  accept(deck, deck.sink->tie_zone(deck.sink->solver, zone));
}

} // namespace c2d
