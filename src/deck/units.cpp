// *UNITS length force: what the numbers of the deck are measured in, for titles of axes; nothing is
// converted.
#include "deck/keywords.hpp"

namespace c2d {

void read_units(Deck& deck, const Words& keyword_card) {
  char length[16], force[16];
  Cards& cards = deck.cards;
  const bool length_known = text_word(cards, keyword_card, 0, "name of the unit of length", length, sizeof length);
  const bool force_known = text_word(cards, keyword_card, 1, "name of the unit of force", force, sizeof force);
  if (!end_of_words(cards, keyword_card, 2) || !length_known || !force_known || deck.sink == nullptr) return;
  place_words(deck, keyword_card);
  accept(deck, deck.sink->set_units(deck.sink->solver, length, force));
}

} // namespace c2d
