// Contact zones, and what each body has of them in sum.
#include "deck/deck.hpp"

namespace c2d {
namespace {

// First and last of both bodies (I5 each) on one card; `count` of them must lie in each range.
bool read_ranges(Deck& deck, const char* name, int32_t count, const int32_t offset[2], const int32_t size[2], int32_t first[2],
                 int32_t last[2]) {
  Cards& cards = deck.cards;
  bool sound = true;
  for (int b = 0; b < 2; ++b) {
    const int32_t column = 1 + 10 * b;
    const int32_t old_faults = cards.faults;
    bool known = integer(cards, column, 5, name, 1 + offset[b], size[b] + offset[b], &first[b]);
    if (!integer(cards, column + 5, 5, name, 1 + offset[b], size[b] + offset[b], &last[b])) known = false;
    const int32_t distance = last[b] > first[b] ? last[b] - first[b] : first[b] - last[b];
    if (known && count > 0 && distance + 1 != count)
      field_fault(cards, column, column + 9, name, " ", first[b], " to ", last[b], " of body ", b + 1, " make ", distance + 1,
                  ", expected ", count);
    first[b] -= offset[b];
    last[b] -= offset[b];
    sound = sound && known && cards.faults == old_faults;
  }
  end_of_fields(cards, 21);
  return sound;
}

void count_zones(Deck& deck) {
  deck.counted = "number of contact zones";
  deck.counted_cards = deck.sizes.zones;
  deck.counted_line = deck.zones_line;
  deck.counted_body = 0;
}

bool read_zone(Deck& deck, bool* sound) {
  Cards& cards = deck.cards;
  c2d_zone zone = c2d_zone();
  zone.struct_size = static_cast<uint32_t>(sizeof zone);
  if (!next_card(cards, "the card with the bodies and sizes of a contact zone")) return false;
  if (cards.zone == 1 && !fits_count(deck, numbers_on(cards) < 5, deck.counted_cards)) return false;
  count_zones(deck);
  if (!fits_count(deck, numbers_on(cards) != 2, cards.zone - 1)) return false;
  int32_t body;
  const int32_t old_faults = cards.faults;
  integer(cards, 1, 5, "lower body of the zone", 1, 1, &body);
  integer(cards, 6, 5, "upper body of the zone", 2, 2, &body);
  const bool pairs_known = integer_from(cards, 11, "number of contact nodes of the zone", 1, &zone.pairs);
  int32_t elements = 0;
  const bool elements_known = integer_from(cards, 16, "number of contact elements of the zone", 1, &elements);
  end_of_fields(cards, 21);
  const int32_t order = deck.sizes.function_nodes;
  const int32_t most = order > 1 ? elements * (order - 1) + 1 : elements;
  if (pairs_known && elements_known && zone.pairs > most)
    field_fault(cards, 11, 15, "number of contact nodes of the zone is ", zone.pairs, ", expected at most ", most, " on ",
                elements, " elements of ", order, " nodes");
  const bool count_sound = pairs_known && !(elements_known && zone.pairs > most);
  deck.pairs += zone.pairs;
  deck.contact_elements += elements;

  zone.side1.elements = zone.side2.elements = elements;
  zone.side1.body = 1, zone.side2.body = 2;
  const int32_t element_offsets[2] = {0, element_offset(deck, 1)};
  const int32_t node_offsets[2] = {0, function_node_offset(deck, 1)};
  const int32_t nodes[2] = {function_node_count(deck, 0), function_node_count(deck, 1)};
  const int32_t body_elements[2] = {deck.body[0].elements, deck.body[1].elements};
  int32_t first[2] = {0, 0}, last[2] = {0, 0};
  *sound = cards.faults == old_faults && !cards.refused;
  if (!next_card(cards, "the card with the elements of a contact zone")) return false;
  if (!read_ranges(deck, "contact elements", elements, element_offsets, body_elements, first, last)) *sound = false;
  zone.side1.first_element = first[0], zone.side1.last_element = last[0];
  zone.side2.first_element = first[1], zone.side2.last_element = last[1];
  if (!next_card(cards, "the card with the nodes of a contact zone")) return false;
  if (!read_ranges(deck, "contact nodes", count_sound ? zone.pairs : 0, node_offsets, nodes, first, last)) *sound = false;
  zone.side1.first_node = first[0], zone.side1.last_node = last[0];
  zone.side2.first_node = first[1], zone.side2.last_node = last[1];
  if (deck.sink == nullptr || !*sound) return !cards.ended;
  place(deck, 1, 20);
  return accept(deck, deck.sink->add_zone(deck.sink->solver, &zone));
}

int32_t bounded(int64_t size) { return size > INT32_MAX ? INT32_MAX : static_cast<int32_t>(size); }

const char* const kNodeSum[] = {"number of contact nodes of body 1", "number of contact nodes of body 2"};
const char* const kElementSum[] = {"number of contact elements of body 1", "number of contact elements of body 2"};

// The sums stand once more on a card for each body; `sound`: the zones were read without a fault.
bool read_sums(Deck& deck, int b, bool sound) {
  Cards& cards = deck.cards;
  if (!next_card(cards, "the card with the numbers of contact nodes and elements of a body")) return false;
  count_zones(deck);
  if (!fits_count(deck, numbers_on(cards) != 4, deck.counted_cards)) return false;
  int32_t nodes = 0, elements = 0;
  const bool nodes_known = integer_from(cards, 1, kNodeSum[b], 0, &nodes);
  const bool elements_known = integer_from(cards, 6, kElementSum[b], 0, &elements);
  end_of_fields(cards, 11);
  if (sound && nodes_known && nodes != deck.pairs)
    field_fault(cards, 1, 5, kNodeSum[b], " is ", nodes, ", expected ", deck.pairs, ", the sum of the zones");
  if (sound && elements_known && elements != deck.contact_elements)
    field_fault(cards, 6, 10, kElementSum[b], " is ", elements, ", expected ", deck.contact_elements, ", the sum of the zones");
  return !cards.ended;
}

} // namespace

bool read_zones(Deck& deck) {
  bool all_sound = true;
  for (int32_t i = 0; i < deck.sizes.zones; ++i) {
    bool sound = false;
    deck.cards.zone = i + 1;
    if (!read_zone(deck, &sound)) return false;
    all_sound = all_sound && sound;
  }
  deck.cards.zone = 0;
  deck.sizes.pairs = bounded(deck.pairs);
  deck.sizes.contact_elements = bounded(deck.contact_elements);
  for (int b = 0; b < deck.sizes.bodies; ++b) {
    deck.cards.body = b + 1;
    if (!read_sums(deck, b, all_sound)) return false;
  }
  deck.cards.body = 0;
  return true;
}

} // namespace c2d
