// *INTERFERENCE load_case: bodies may overlap before any load; the factor of this case removes the overlaps. It may be one
// case more than the deck otherwise has.
#include "deck/keywords.hpp"

namespace c2d {

void read_interference(Deck& deck, const Words& keyword_card) {
  Cards& cards = deck.cards;
  int32_t load_case = 0;
  const bool known = integer_word(cards, keyword_card, 0, "load case", 1, 10000, &load_case);
  if (!end_of_words(cards, keyword_card, 1) || !known) return;
  if (load_case > 1 && load_case > deck.sizes.load_cases) deck.sizes.load_cases = load_case;
  if (deck.sink == nullptr) return;
  place_words(deck, keyword_card);
  accept(deck, deck.sink->set_interference(deck.sink->solver, load_case));
}

} // namespace c2d
