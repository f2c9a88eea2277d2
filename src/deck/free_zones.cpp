// *ZONE first1 last1 first2 last2 [count1 count2]: elements of bodies 1 and 2 between which there may be
// contact, meshed independently of each other. Counts serve ranges that go round the end of their region.
#include "deck/keywords.hpp"

namespace c2d {

namespace {

int32_t larger(int32_t a, int32_t b) { return a > b ? a : b; }

// As far as the deck tells: which of the elements face body 1 is found out later.
void count_sizes(Deck& deck, int32_t elements) {
  const int64_t order = deck.sizes.function_nodes;
  const int64_t pairs = order > 1 ? elements * (order - 1) + 1 : elements;
  deck.pairs += pairs;
  deck.contact_elements += elements;
  const auto bounded = [](int64_t size) { return size > INT32_MAX ? INT32_MAX : static_cast<int32_t>(size); };
  deck.sizes.pairs = bounded(deck.pairs);
  deck.sizes.contact_elements = bounded(deck.contact_elements);
  deck.sizes.free_pairs = bounded(deck.sizes.free_pairs + pairs);
  ++deck.sizes.zones;
}

} // namespace

void read_free_zone(Deck& deck, const Words& keyword_card) {
  Cards& cards = deck.cards;
  if (deck.sizes.bodies < 2 || deck.problem.analysis == C2D_ANALYSIS_STRESS) {
    fault(cards, 0, 0,
          deck.sizes.bodies < 2 ? "a contact zone with one body only, expected two bodies"
                                : "a contact zone in a stress analysis (IOUT 0), expected IOUT 1 or 2, which is contact");
    return;
  }
  c2d_zone zone = c2d_zone();
  zone.struct_size = static_cast<uint32_t>(sizeof zone);
  zone.kind = C2D_ZONE_FREE;
  const bool counted = keyword_card.count > 4;
  const int32_t old_faults = cards.faults;
  for (int b = 0; b < 2; ++b) {
    const int32_t offset = element_offset(deck, b), most = deck.body[b].elements;
    c2d_side& side = b == 0 ? zone.side1 : zone.side2;
    side.body = b + 1;
    int32_t* range[2] = {&side.first_element, &side.last_element};
    for (int i = 0; i < 2; ++i)
      if (integer_word(cards, keyword_card, 2 * b + i, b == 0 ? "element of body 1" : "element of body 2", 1 + offset,
                       most + offset, range[i]))
        *range[i] -= offset;
    if (counted) integer_word(cards, keyword_card, 4 + b, "number of elements", 1, most, &side.elements);
  }
  if (!end_of_words(cards, keyword_card, counted ? 6 : 4) || cards.faults != old_faults) return;
  const int32_t first = zone.side2.first_element, last = zone.side2.last_element;
  count_sizes(deck, counted ? zone.side2.elements : larger(first - last, last - first) + 1);
  if (deck.sink == nullptr) return;
  place_words(deck, keyword_card);
  accept(deck, deck.sink->add_zone(deck.sink->solver, &zone));
}

} // namespace c2d
