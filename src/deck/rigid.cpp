// *RIGID [body]: the body (default 1) is rigid. Below it, cards `load_case ux uy rotation x0 y0`: prescribed
// motion, rotation in radians about (x0, y0); a case may be one more than the deck otherwise has.
#include "deck/keywords.hpp"

namespace c2d {

namespace {

// A card `load_case value ...` below a keyword. False if it has faults, or there is no sink to call.
bool read_case(Deck& deck, const Words& words, const char* const names[], int32_t count, int32_t* load_case, double* value) {
  Cards& cards = deck.cards;
  bool sound = integer_word(cards, words, 0, "load case", 1, 10000, load_case);
  for (int32_t i = 0; i < count; ++i) sound = real_word(cards, words, 1 + i, names[i], &value[i]) && sound;
  sound = end_of_words(cards, words, 1 + count) && sound;
  if (sound && *load_case > 1 && *load_case > deck.sizes.load_cases) deck.sizes.load_cases = *load_case;
  if (!sound || deck.sink == nullptr) return false;
  place_words(deck, words);
  return true;
}

} // namespace

void read_rigid(Deck& deck, const Words& keyword_card) {
  static const char* const kNames[] = {"motion ux", "motion uy", "rotation", "x of the centre of rotation",
                                       "y of the centre of rotation"};
  Cards& cards = deck.cards;
  int32_t body = 1;
  const int32_t old_faults = cards.faults;
  if (keyword_card.count > 0) integer_word(cards, keyword_card, 0, "body number", 1, deck.sizes.bodies, &body);
  end_of_words(cards, keyword_card, 1);
  if (cards.faults == old_faults && deck.rigid.again(body))
    word_fault(cards, keyword_card, 0, "body ", body, " has two *RIGID keywords, expected one");
  const bool named = cards.faults == old_faults;
  if (named && deck.sink != nullptr) {
    place_words(deck, keyword_card);
    accept(deck, deck.sink->set_rigid(deck.sink->solver, body, 0, nullptr, nullptr));
  }
  for (Words words; next_data_card(deck, words);) {
    int32_t load_case = 0;
    double value[5] = {0.0, 0.0, 0.0, 0.0, 0.0};
    if (!read_case(deck, words, kNames, 5, &load_case, value) || !named) continue;
    if (!accept(deck, deck.sink->set_rigid(deck.sink->solver, body, load_case, value, value + 3))) return;
  }
}

namespace {

// X, Y, TURN: free motions; if none is named, all are free.
bool read_free_motions(Cards& cards, const Words& words, int32_t from, int32_t is_free[3]) {
  static const char* const kMotions[] = {"X", "Y", "TURN"};
  for (int32_t i = from; i < words.count; ++i) {
    int32_t k = 0;
    while (k < 3 && !word_is(words, i, kMotions[k])) ++k;
    if (k == 3 || is_free[k] != 0) {
      word_fault(cards, words, i, "expected the free motions X, Y or TURN, each at most once, or none of them if all are free");
      return false;
    }
    is_free[k] = 1;
  }
  if (words.count <= from) is_free[0] = is_free[1] = is_free[2] = 1;
  return true;
}

} // namespace

// *RIGID LOAD body x y [X] [Y] [TURN]: the body is rigid; these motions of the point (x, y), or all, are free. Below it,
// cards `load_case fx fy moment`: load on the body, the moment about the point.
void read_rigid_load(Deck& deck, const Words& keyword_card) {
  static const char* const kNames[] = {"force fx", "force fy", "moment"};
  Cards& cards = deck.cards;
  int32_t body = 1, is_free[3] = {0, 0, 0};
  double point[2] = {0.0, 0.0};
  const int32_t old_faults = cards.faults;
  integer_word(cards, keyword_card, 0, "body number", 1, deck.sizes.bodies, &body);
  real_word(cards, keyword_card, 1, "x of the point", &point[0]);
  real_word(cards, keyword_card, 2, "y of the point", &point[1]);
  read_free_motions(cards, keyword_card, 3, is_free);
  const bool named = cards.faults == old_faults;
  if (named && deck.sink != nullptr) {
    place_words(deck, keyword_card);
    accept(deck, deck.sink->set_rigid_load(deck.sink->solver, body, 0, is_free, nullptr, point));
  }
  for (Words words; next_data_card(deck, words);) {
    int32_t load_case = 0;
    double load[3] = {0.0, 0.0, 0.0};
    if (!read_case(deck, words, kNames, 3, &load_case, load) || !named) continue;
    if (!accept(deck, deck.sink->set_rigid_load(deck.sink->solver, body, load_case, nullptr, load, nullptr))) return;
  }
}

} // namespace c2d
