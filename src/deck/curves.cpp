// *CURVE kind body first last: given surface over elements of a body.
//   *CURVE LINE body first last
//   *CURVE ARC body first last x0 y0 radius      in global coordinates
//   *CURVE SPLINE body first last
#include "deck/keywords.hpp"

namespace c2d {

void read_curve(Deck& deck, const Words& keyword_card) {
  static const char* const kKinds[] = {"LINE", "ARC", "SPLINE"};
  Cards& cards = deck.cards;
  c2d_curve curve = c2d_curve();
  curve.struct_size = static_cast<uint32_t>(sizeof curve);
  while (curve.kind < 3 && !word_is(keyword_card, 0, kKinds[curve.kind])) ++curve.kind;
  if (curve.kind == 3) return word_fault(cards, keyword_card, 0, "expected one of: line, arc, spline");
  bool sound = integer_word(cards, keyword_card, 1, "body number", 1, deck.sizes.bodies, &curve.body);
  int32_t* const range[2] = {&curve.first_element, &curve.last_element};
  for (int i = 0; i < 2 && sound; ++i) {
    const int32_t offset = element_offset(deck, curve.body - 1), most = deck.body[curve.body - 1].elements;
    sound = integer_word(cards, keyword_card, 2 + i, "element of the curve", 1 + offset, most + offset, range[i]);
    *range[i] -= offset;
  }
  const bool arc = curve.kind == C2D_CURVE_ARC;
  if (arc && sound) {
    sound = real_word(cards, keyword_card, 4, "x of the centre", &curve.centre[0]);
    sound = real_word(cards, keyword_card, 5, "y of the centre", &curve.centre[1]) && sound;
    sound = real_word(cards, keyword_card, 6, "radius", &curve.radius) && sound;
  }
  if (!sound || !end_of_words(cards, keyword_card, arc ? 7 : 4)) return;
  ++deck.sizes.curves;
  if (deck.sink == nullptr) return;
  place_words(deck, keyword_card);
  accept(deck, deck.sink->add_curve(deck.sink->solver, &curve));
}

} // namespace c2d
