// Boundary conditions and point loads of a body.
#include "deck/deck.hpp"

namespace c2d {
namespace {

struct ConditionCard {
  bool sound;             // element and local node are valid
  bool is_generated;      // I1 = 1: for all ends since the card before
  int32_t element, local; // within the body; local functional node from 1
  int32_t codes[4];
  double values[4]; // tx ty ux uy
  bool values_sound;
};

// On a free-form card the flag may be missing and the codes may be one field; the number of fields decides.
struct FieldCount {
  bool has_flag, codes_apart;
};
constexpr int32_t kFields = 7;     // element, node, codes, four values
constexpr int32_t kMoreFields = 3; // more, if each code is a field

bool count_fields(Cards& cards, FieldCount& count) {
  count.has_flag = count.codes_apart = true;
  if (!cards.free_form) return true;
  const int32_t fields = cards.words.count;
  count.codes_apart = fields >= kFields + kMoreFields;
  const int32_t least = kFields + (count.codes_apart ? kMoreFields : 0);
  count.has_flag = fields == least + 1;
  if (fields == least || fields == least + 1) return true;
  word_fault(cards, cards.words, fields, "the card has ", fields, " fields",
             ", expected 7: element, node, four codes as one field, four values; 10 with the codes apart; one "
             "more with the flag 1 in front");
  return false;
}

// Four codes in one field.
bool read_joined_codes(Cards& cards, int32_t codes[4]) {
  const Word at = cards.words.word[take_word(cards, 12, 4)];
  const char* text = cards.text + at.column - 1;
  bool sound = at.column_end - at.column == 3;
  for (int32_t i = 0; i < 4 && sound; ++i) sound = text[i] == '0' || text[i] == '1';
  if (!sound) {
    char shown[12] = {};
    copy_word(cards.words, cards.taken - 1, shown, sizeof shown);
    field_fault(cards, 12, 15, "the codes are '", shown,
                "', expected four digits 0 (known) or 1 (unknown): x and y traction, x and y displacement");
    return false;
  }
  for (int32_t i = 0; i < 4; ++i) {
    codes[i] = text[i] - '0';
    tell_field(cards, C2D_CARD_INTEGER, 12 + i, 1, text + i, 1, codes[i]);
  }
  return true;
}

// A value of an unknown quantity would be ignored: the code or the field is probably wrong.
bool read_value(Cards& cards, int32_t column, const char* name, int32_t code, double* value) {
  if (!real(cards, column, name, value)) return false;
  if (code == 0 || *value == 0.0) return true;
  field_fault(cards, column, column + 9, "the ", name, " is ", *value,
              ", but its code is 1 (unknown), expected 0, or the code 0");
  return false;
}

ConditionCard read_condition(Deck& deck, int b) {
  static const char* const kCode[4] = {
      "code of the x traction (0 known, 1 unknown)", "code of the y traction (0 known, 1 unknown)",
      "code of the x displacement (0 known, 1 unknown)", "code of the y displacement (0 known, 1 unknown)"};
  static const char* const kValue[4] = {"x traction", "y traction", "x displacement", "y displacement"};
  Cards& cards = deck.cards;
  ConditionCard card = ConditionCard();
  const int32_t offset = element_offset(deck, b);
  int32_t generated = 0;
  FieldCount count;
  if (!count_fields(cards, count)) return card;
  card.sound = !count.has_flag || integer(cards, 1, 1, "flag for generated conditions (blank, 0 or 1)", 0, 1, &generated);
  card.is_generated = generated == 1;
  if (!integer(cards, 2, 4, "element number", 1 + offset, deck.body[b].elements + offset, &card.element)) card.sound = false;
  card.element -= offset;
  if (!integer(cards, 6, 5, "local node number", 1, deck.sizes.function_nodes, &card.local)) card.sound = false;
  unused_column(cards, 11);
  card.values_sound = !cards.refused;
  if (!count.codes_apart && !read_joined_codes(cards, card.codes)) card.values_sound = false;
  for (int32_t i = 0; i < 4 && count.codes_apart; ++i)
    if (!integer(cards, 12 + i, 1, kCode[i], 0, 1, &card.codes[i])) card.values_sound = false;
  unused_column(cards, 16);
  for (int32_t i = 0; i < 4; ++i)
    if (!read_value(cards, 17 + 10 * i, kValue[i], card.codes[i], &card.values[i])) card.values_sound = false;
  end_of_fields(cards, 57);
  return card;
}

// Applies the condition of this card to all ends after `previous` up to its own; without generation only to its own.
bool set_conditions(Deck& deck, int b, const ConditionCard& previous, const ConditionCard& card) {
  if (deck.sink == nullptr || !card.values_sound) return true;
  place(deck, 1, 56);
  int32_t element = card.element, local = card.local;
  if (card.is_generated) {
    element = previous.element;
    local = previous.local + 1;
  }
  for (; element <= card.element; ++element, local = 1) {
    const int32_t last = element < card.element ? deck.sizes.function_nodes : card.local;
    for (; local <= last; ++local) {
      const c2d_status status = deck.sink->set_condition(deck.sink->solver, b + 1, element, local, 1, card.codes, card.values);
      if (!accept(deck, status)) return false;
    }
  }
  return true;
}

bool is_behind(const ConditionCard& card, const ConditionCard& previous) {
  if (card.element != previous.element) return card.element < previous.element;
  return card.local <= previous.local;
}

// A zone's card has four whole numbers.
bool may_be_point_load(const Cards& cards) {
  const int32_t numbers = numbers_on(cards);
  if (cards.free_form || numbers != 4) return numbers != 1 && (!cards.free_form || numbers != 4);
  for (int32_t i = 0; i < kCardColumns; ++i)
    if (cards.text[i] == '.') return true;
  return false;
}

bool read_point_load(Deck& deck, int b, int32_t i) {
  static const char* const kName[4] = {"x of a point load", "y of a point load", "x component of a point load",
                                       "y component of a point load"};
  Cards& cards = deck.cards;
  if (!next_card(cards, "a point load card")) return false;
  if (!fits_count(deck, may_be_point_load(cards), i)) return false;
  int32_t number; // read, but not used: the cards are counted
  any_integer(cards, 1, "number of the point load", &number);
  unused_column(cards, 6);
  double data[4] = {0, 0, 0, 0};
  bool sound = true;
  for (int32_t k = 0; k < 4; ++k)
    if (!real(cards, 7 + 10 * k, kName[k], &data[k])) sound = false;
  end_of_fields(cards, 47);
  if (deck.sink == nullptr || !sound) return !cards.ended;
  place(deck, 7, 46);
  const double* origin = deck.sink->origin[b];
  return accept(
      deck, deck.sink->add_point_load(deck.sink->solver, b + 1, 1, data[0] + origin[0], data[1] + origin[1], data[2], data[3]));
}

} // namespace

bool read_conditions(Deck& deck, int b) {
  Cards& cards = deck.cards;
  cards.body = b + 1;
  if (!next_card(cards, "the number of boundary conditions of a body")) return false;
  if (!fits_count(deck, numbers_on(cards) < 4, deck.counted_cards)) return false;
  int32_t conditions = 0;
  if (!read_count(deck, "number of boundary condition cards", &conditions)) return false;
  ConditionCard previous = ConditionCard();
  for (int32_t i = 0; i < conditions; ++i) {
    if (!next_card(cards, "a boundary condition card")) return false;
    if (!fits_count(deck, numbers_on(cards) != 1, i)) return false;
    const ConditionCard card = read_condition(deck, b);
    if (cards.ended) return false;
    const bool follows = !card.is_generated || previous.sound;
    if (card.sound && card.is_generated && i == 0)
      field_fault(cards, 1, 1, "this card generates conditions from the card before it, expected such a card");
    else if (card.sound && follows && card.is_generated && is_behind(card, previous))
      field_fault(cards, 2, 10, "conditions are generated up to element ", card.element + element_offset(deck, b), " node ",
                  card.local, ", expected an end after that of the card before (element ",
                  previous.element + element_offset(deck, b), " node ", previous.local, ")");
    else if (card.sound && follows && !set_conditions(deck, b, previous, card))
      return false;
    previous = card;
  }
  return !cards.ended;
}

bool read_point_loads(Deck& deck, int b) {
  Cards& cards = deck.cards;
  if (!next_card(cards, "the number of point loads of a body")) return false;
  if (!fits_count(deck, numbers_on(cards) < 4, deck.counted_cards)) return false;
  int32_t loads = 0;
  if (!read_count(deck, "number of point loads", &loads)) return false;
  deck.sizes.point_loads += loads;
  for (int32_t i = 0; i < loads; ++i)
    if (!read_point_load(deck, b, i)) return false;
  return !cards.ended;
}

} // namespace c2d
