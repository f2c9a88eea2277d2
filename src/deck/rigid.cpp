// *RIGID: body 1 is a rigid obstacle. Below it, cards `load_case ux uy rotation x0 y0`: how it moves, rotation in radians
// about (x0, y0); a case may be one more than the deck has otherwise.
#include "deck/keywords.hpp"

namespace c2d {

void read_rigid(Deck& deck, const Words& keyword_card) {
  static const char* const kNames[] = {"motion ux", "motion uy", "rotation", "x of the centre of rotation",
                                       "y of the centre of rotation"};
  Cards& cards = deck.cards;
  end_of_words(cards, keyword_card, 0);
  if (deck.sink != nullptr) {
    place_words(deck, keyword_card);
    accept(deck, deck.sink->set_rigid(deck.sink->solver, 1, 0, nullptr, nullptr));
  }
  for (Words words; next_data_card(deck, words) && !cards.ended;) {
    int32_t load_case = 0;
    double value[5] = {0.0, 0.0, 0.0, 0.0, 0.0};
    bool sound = integer_word(cards, words, 0, "load case", 1, 10000, &load_case);
    for (int32_t i = 0; i < 5; ++i) sound = real_word(cards, words, 1 + i, kNames[i], &value[i]) && sound;
    sound = end_of_words(cards, words, 6) && sound;
    if (sound && load_case > 1 && load_case > deck.sizes.load_cases) deck.sizes.load_cases = load_case;
    if (!sound || deck.sink == nullptr) continue;
    place_words(deck, words);
    if (!accept(deck, deck.sink->set_rigid(deck.sink->solver, 1, load_case, value, value + 3))) return;
  }
}

} // namespace c2d
