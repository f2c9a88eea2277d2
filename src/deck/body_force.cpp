// *BODY FORCE body load_case bx by [rho_omega2 x0 y0]: force per area of a body, and centrifugal force of rotation about (x0,
// y0). The load case may be one more than the deck otherwise has.
#include "deck/keywords.hpp"

namespace c2d {

void read_body_force(Deck& deck, const Words& keyword_card) {
  static const char* const kNames[] = {"body force bx", "body force by", "density times angular velocity squared",
                                       "x of the axis of rotation", "y of the axis of rotation"};
  Cards& cards = deck.cards;
  int32_t body = 0, load_case = 0;
  double value[5] = {0.0, 0.0, 0.0, 0.0, 0.0};
  const int32_t old_faults = cards.faults;
  integer_word(cards, keyword_card, 0, "body number", 1, deck.sizes.bodies, &body);
  integer_word(cards, keyword_card, 1, "load case", 1, 10000, &load_case);
  if (load_case > 1 && load_case > deck.sizes.load_cases) deck.sizes.load_cases = load_case;
  const int32_t given = keyword_card.count > 4 ? 5 : 2;
  for (int32_t i = 0; i < given; ++i) real_word(cards, keyword_card, 2 + i, kNames[i], &value[i]);
  const bool ended = end_of_words(cards, keyword_card, 2 + given);
  const int64_t place = int64_t{load_case - 1} * deck.sizes.bodies + body;
  const bool noted = cards.faults == old_faults && place <= NumbersSeen::kNoted;
  if (noted && deck.body_forces.again(static_cast<int32_t>(place)))
    word_fault(cards, keyword_card, 1, "body ", body, " has two body forces in load case ", load_case,
               ", expected one card per body and load case");
  if (!ended || cards.faults != old_faults || deck.sink == nullptr) return;
  place_words(deck, keyword_card);
  accept(deck, deck.sink->set_body_force(deck.sink->solver, body, load_case, value, value[2], value + 3));
}

} // namespace c2d
