// Contact zones, and what each body has of them in sum.
#include "deck/deck.hpp"

namespace c2d {
namespace {

// The numbers that one kind of range may name on a side of a zone, counted as on the cards.
struct SideNumbers {
  int32_t body, offset, size;
};

// First and last of both sides (I5 each) on one card; `count` of them must lie in each range.
bool read_ranges(Deck& deck, const char* name, int32_t count, const SideNumbers numbers[2], int32_t first[2], int32_t last[2]) {
  Cards& cards = deck.cards;
  bool sound = true;
  for (int s = 0; s < 2; ++s) {
    const int32_t column = 1 + 10 * s, offset = numbers[s].offset, most = numbers[s].size + offset;
    const int32_t old_faults = cards.faults;
    bool known = integer(cards, column, 5, name, 1 + offset, most, &first[s]);
    if (!integer(cards, column + 5, 5, name, 1 + offset, most, &last[s])) known = false;
    const int32_t distance = last[s] > first[s] ? last[s] - first[s] : first[s] - last[s];
    if (known && count > 0 && distance + 1 != count)
      field_fault(cards, column, column + 9, name, " ", first[s], " to ", last[s], " of body ", numbers[s].body, " make ",
                  distance + 1, ", expected ", count);
    first[s] -= offset;
    last[s] -= offset;
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

// The zone's two bodies; the second with a minus sign is the first again.
bool read_bodies(Deck& deck, c2d_zone& zone) {
  Cards& cards = deck.cards;
  bool known = integer(cards, 1, 5, "lower body of the zone", 1, deck.sizes.bodies, &zone.side1.body);
  known = any_integer(cards, 6, "upper body of the zone", &zone.side2.body) && known;
  if (known && zone.side2.body == -zone.side1.body) {
    zone.side2.body = zone.side1.body;
    zone.kind = C2D_ZONE_SELF;
    return known;
  }
  if (known && (zone.side2.body < 1 || zone.side2.body > deck.sizes.bodies))
    field_fault(cards, 6, 10, "upper body of the zone is ", zone.side2.body, ", expected 1 to ", deck.sizes.bodies);
  else if (known && zone.side1.body == zone.side2.body)
    field_fault(cards, 6, 10, "both bodies of the zone are ", zone.side2.body, ", expected two different ones, or -",
                zone.side2.body, " for self-contact");
  return known && zone.side2.body >= 1 && zone.side2.body <= deck.sizes.bodies;
}

// Numbers of contact nodes and elements of a zone, which are added to those of earlier zones. `pairs`: 0 if it was refused.
struct ZoneSizes {
  int32_t pairs, elements;
};
ZoneSizes read_sizes(Deck& deck, c2d_zone& zone) {
  Cards& cards = deck.cards;
  int32_t elements = 0;
  const bool pairs_known = integer_from(cards, 11, "number of contact nodes of the zone", 1, &zone.pairs);
  const bool elements_known = integer_from(cards, 16, "number of contact elements of the zone", 1, &elements);
  end_of_fields(cards, 21);
  const int32_t order = deck.sizes.function_nodes;
  const int64_t most = order > 1 ? int64_t{elements} * (order - 1) + 1 : elements;
  const bool too_many = pairs_known && elements_known && zone.pairs > most;
  if (too_many)
    field_fault(cards, 11, 15, "number of contact nodes of the zone is ", zone.pairs, ", expected at most ", most, " on ",
                elements, " elements of ", order, " nodes");
  deck.pairs += zone.pairs;
  if ((zone.kind & C2D_ZONE_SELF) != 0) deck.self_pairs += zone.pairs;
  deck.contact_elements += elements;
  zone.side1.elements = zone.side2.elements = elements;
  return {pairs_known && !too_many ? zone.pairs : 0, elements};
}

// The numbers that the zone's ranges may name; where its bodies are not known, any.
void find_numbers(const Deck& deck, const c2d_zone& zone, bool known, SideNumbers elements[2], SideNumbers nodes[2]) {
  for (int side = 0; side < 2; ++side) {
    const int32_t body = side == 0 ? zone.side1.body : zone.side2.body;
    elements[side] = nodes[side] = SideNumbers{body, 0, INT32_MAX};
    if (!known) continue;
    elements[side] = SideNumbers{body, element_offset(deck, body - 1), deck.body[body - 1].elements};
    nodes[side] = SideNumbers{body, function_node_offset(deck, body - 1), function_node_count(deck, body - 1)};
  }
}

// The cards with the elements and the nodes of a zone; false at the end of the deck.
bool read_sides(Deck& deck, const ZoneSizes& sizes, bool bodies_known, c2d_zone& zone, bool* sound) {
  SideNumbers elements[2], nodes[2];
  find_numbers(deck, zone, bodies_known, elements, nodes);
  int32_t first[2] = {0, 0}, last[2] = {0, 0};
  if (!next_card(deck.cards, "the elements of a contact zone")) return false;
  if (!read_ranges(deck, "contact elements", sizes.elements, elements, first, last)) *sound = false;
  zone.side1.first_element = first[0], zone.side1.last_element = last[0];
  zone.side2.first_element = first[1], zone.side2.last_element = last[1];
  if (!next_card(deck.cards, "the nodes of a contact zone")) return false;
  if (!read_ranges(deck, "contact nodes", sizes.pairs, nodes, first, last)) *sound = false;
  zone.side1.first_node = first[0], zone.side1.last_node = last[0];
  zone.side2.first_node = first[1], zone.side2.last_node = last[1];
  return true;
}

bool read_zone(Deck& deck, bool* sound) {
  Cards& cards = deck.cards;
  c2d_zone zone = c2d_zone();
  zone.struct_size = static_cast<uint32_t>(sizeof zone);
  if (!next_card(cards, "the bodies and sizes of a contact zone")) return false;
  if (cards.zone == 1 && !fits_count(deck, numbers_on(cards) < 5, deck.counted_cards)) return false;
  count_zones(deck);
  if (!fits_count(deck, numbers_on(cards) != 2, cards.zone - 1)) return false;
  const int32_t old_faults = cards.faults;
  const bool bodies_known = read_bodies(deck, zone);
  const ZoneSizes sizes = read_sizes(deck, zone);
  *sound = cards.faults == old_faults && !cards.refused;
  if (!read_sides(deck, sizes, bodies_known, zone, sound)) return false;
  if (deck.sink == nullptr || !*sound) return !cards.ended;
  place(deck, 1, 20);
  return accept(deck, deck.sink->add_zone(deck.sink->solver, &zone));
}

// What a card for each body says once more of its zones.
struct Sum {
  const char* what;
  int32_t column;
  int64_t of_zones, of_bodies; // of those whose cards were read
  bool sound;                  // as those cards are
};

// Zones join two bodies. With two bodies all zones are on each of them, and each card is compared; with more of them, or one
// that meets itself, the sum over all bodies is, at the last card.
void check_sum(const Deck& deck, Cards& cards, const Sum& sum, const char* name, int32_t value) {
  const int32_t bodies = deck.sizes.bodies;
  const bool each = (bodies == 2 && deck.self_pairs == 0) || deck.sizes.zones == 0;
  if (each && value != sum.of_zones)
    field_fault(cards, sum.column, sum.column + 4, name, " is ", value, ", expected ", sum.of_zones, ", the sum of the zones");
  else if (!each && cards.body == bodies && sum.sound && sum.of_bodies != 2 * sum.of_zones)
    field_fault(cards, sum.column, sum.column + 4, "numbers of contact ", sum.what, " of all bodies make ", sum.of_bodies,
                ", expected ", 2 * sum.of_zones, ": the sum of the zones, each of which has two sides");
}

void read_sum(Deck& deck, bool zones_sound, Sum& sum) {
  Cards& cards = deck.cards;
  char name[48];
  Text text = text_in(name);
  put_all(text, "number of contact ", sum.what, " of body ", cards.body);
  int32_t value = 0;
  const bool known = integer_from(cards, sum.column, name, 0, &value);
  sum.of_bodies += value;
  sum.sound = sum.sound && known;
  if (known && zones_sound) check_sum(deck, cards, sum, name, value);
}

// `sound`: the zones were read without a fault.
bool read_sums(Deck& deck, bool sound) {
  Cards& cards = deck.cards;
  Sum nodes = {"nodes", 1, deck.pairs, 0, true}, elements = {"elements", 6, deck.contact_elements, 0, true};
  for (int b = 0; b < deck.sizes.bodies; ++b) {
    cards.body = b + 1;
    if (!next_card(cards, "the numbers of contact nodes and elements of a body")) return false;
    count_zones(deck);
    if (!fits_count(deck, numbers_on(cards) != 4, deck.counted_cards)) return false;
    read_sum(deck, sound, nodes);
    read_sum(deck, sound, elements);
    end_of_fields(cards, 11);
    if (cards.ended) return false;
  }
  cards.body = 0;
  return true;
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
  deck.sizes.pairs = bounded(deck.pairs + deck.self_pairs);
  deck.sizes.contact_elements = bounded(deck.contact_elements);
  return read_sums(deck, all_sound);
}

} // namespace c2d
