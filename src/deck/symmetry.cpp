// *SYMMETRY X value, or Y: bodies are mirrored across the line x = value, or y = value.
#include "deck/keywords.hpp"

namespace c2d {

void read_symmetry(Deck& deck, const Words& keyword_card) {
  Cards& cards = deck.cards;
  char letter[4];
  double value = 0;
  const int32_t old_faults = cards.faults;
  const bool letter_known = text_word(cards, keyword_card, 0, "coordinate of the line of symmetry", letter, sizeof letter);
  const bool is_x = word_is(keyword_card, 0, "X"), is_y = word_is(keyword_card, 0, "Y");
  if (letter_known && !is_x && !is_y)
    word_fault(cards, keyword_card, 0, "the line of symmetry is ", letter, " = value, expected X or Y");
  real_word(cards, keyword_card, 1, "place of the line of symmetry", &value);
  const bool ended = end_of_words(cards, keyword_card, 2);
  if (!ended || cards.faults != old_faults) return;
  const int32_t bit = is_x ? 1 : 2;
  if ((deck.symmetry & bit) != 0) {
    word_fault(cards, keyword_card, 0, "*SYMMETRY ", letter, " appears twice in the deck, expected it once");
    return;
  }
  deck.symmetry |= bit;
  if (deck.sink == nullptr) return;
  place_words(deck, keyword_card);
  accept(deck, deck.sink->set_symmetry(deck.sink->solver, is_x ? 0 : 1, value));
}

} // namespace c2d
