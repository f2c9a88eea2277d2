// *ZONE first1 last1 first2 last2 [count1 count2]: ranges of elements of bodies 1 and 2 that may come into
// contact, with independent meshes. Counts are needed for ranges across the end of their region.
// BODIES b1 b2, before or after these numbers, selects other bodies.
#include "deck/keywords.hpp"

namespace c2d {

namespace {

int32_t larger(int32_t a, int32_t b) { return a > b ? a : b; }

// Position of the words BODIES b1 b2; -1: absent.
int32_t place_of_bodies(const Words& words) {
  for (int32_t i = 0; i < words.count; ++i)
    if (word_is(words, i, "BODIES")) return i;
  return -1;
}
constexpr int32_t kWordsOfBodies = 3;

// The bodies of both sides; false after a fault.
bool read_bodies(Deck& deck, const Words& words, int32_t at, c2d_zone& zone) {
  Cards& cards = deck.cards;
  zone.side1.body = 1, zone.side2.body = 2;
  if (at < 0 && deck.sizes.bodies < 2) {
    fault(cards, 0, 0, "a contact zone in a deck of one body, expected two bodies, or BODIES 1 -1 for self-contact");
    return false;
  }
  if (at < 0) return true;
  const int32_t bodies = deck.sizes.bodies;
  if (!integer_word(cards, words, at + 1, "first body of the zone", 1, bodies, &zone.side1.body)) return false;
  if (!integer_word(cards, words, at + 2, "second body of the zone", INT32_MIN, INT32_MAX, &zone.side2.body)) return false;
  if (zone.side2.body == -zone.side1.body) { // self-contact
    zone.side2.body = zone.side1.body;
    zone.kind |= C2D_ZONE_SELF;
    return true;
  }
  if (zone.side2.body < 1 || zone.side2.body > bodies) {
    word_fault(cards, words, at + 2, "second body of the zone is ", zone.side2.body, ", expected 1 to ", bodies, ", or -",
               zone.side1.body, " for self-contact");
    return false;
  }
  if (zone.side1.body != zone.side2.body) return true;
  word_fault(cards, words, at + 2, "bodies of the zone are ", zone.side1.body, " and ", zone.side2.body,
             ", expected two different ones, or the second as -", zone.side1.body, " for self-contact");
  return false;
}

// First and last element of a side in two words from `at` on.
void read_range(Deck& deck, const Words& words, int32_t at, c2d_side& side) {
  const int32_t offset = element_offset(deck, side.body - 1), most = deck.body[side.body - 1].elements;
  char name[32];
  Text text = text_in(name);
  put_all(text, "element of body ", side.body);
  int32_t* const range[2] = {&side.first_element, &side.last_element};
  for (int i = 0; i < 2; ++i)
    if (integer_word(deck.cards, words, at + i, name, 1 + offset, most + offset, range[i])) *range[i] -= offset;
}

} // namespace

int32_t bounded(int64_t size) { return size > INT32_MAX ? INT32_MAX : static_cast<int32_t>(size); }

void count_zone(Deck& deck, int32_t elements, int32_t kind) {
  const int64_t order = deck.sizes.function_nodes;
  const int64_t pairs = order > 1 ? elements * (order - 1) + 1 : elements;
  const bool self = (kind & C2D_ZONE_SELF) != 0;
  if (self) deck.self_pairs += pairs;
  deck.pairs += pairs;
  deck.contact_elements += elements;
  deck.sizes.pairs = bounded(deck.pairs + deck.self_pairs);
  deck.sizes.contact_elements = bounded(deck.contact_elements);
  if ((kind & C2D_ZONE_FREE) != 0) deck.sizes.free_pairs = bounded(deck.sizes.free_pairs + (self ? 2 : 1) * pairs);
  ++deck.sizes.zones;
}

void read_free_zone(Deck& deck, const Words& keyword_card) {
  Cards& cards = deck.cards;
  if (deck.problem.analysis == C2D_ANALYSIS_STRESS)
    return void(fault(cards, 0, 0, "a contact zone or platen in a stress analysis (IOUT 0), expected IOUT 1 or 2"));
  c2d_zone zone = c2d_zone();
  zone.struct_size = static_cast<uint32_t>(sizeof zone);
  zone.kind = C2D_ZONE_FREE;
  const int32_t old_faults = cards.faults;
  const int32_t at = place_of_bodies(keyword_card);
  if (!read_bodies(deck, keyword_card, at, zone)) return;
  const int32_t from = at == 0 ? kWordsOfBodies : 0, others = at < 0 ? 0 : kWordsOfBodies; // words
  const bool counted = (at > 0 ? at : keyword_card.count - from) > 4;
  for (int s = 0; s < 2; ++s) {
    c2d_side& side = s == 0 ? zone.side1 : zone.side2;
    read_range(deck, keyword_card, from + 2 * s, side);
    const int32_t most = deck.body[side.body - 1].elements;
    if (counted) integer_word(cards, keyword_card, from + 4 + s, "number of elements", 1, most, &side.elements);
  }
  if (!end_of_words(cards, keyword_card, others + (counted ? 6 : 4)) || cards.faults != old_faults) return;
  const int32_t first = zone.side2.first_element, last = zone.side2.last_element;
  count_zone(deck, counted ? zone.side2.elements : larger(first - last, last - first) + 1, zone.kind);
  if (deck.sink == nullptr) return;
  place_words(deck, keyword_card);
  accept(deck, deck.sink->add_zone(deck.sink->solver, &zone));
}

} // namespace c2d
