// *PLATEN body first last x y [elements]: elements that move as one rigid body. Below it, cards `load_case word value ...`:
// UX, UY and TURN prescribe motions of the point (x, y), FX, FY and MOMENT loads on motions that are not prescribed.
#include "deck/keywords.hpp"

namespace c2d {

namespace {

// For each component: was its motion or its load given?
enum class Known { nothing, motion, load };
struct PlatenCards {
  Known known[3];
  NumbersSeen cases;
};

// The words of a card after the load case: value[0 ... 3) motions, [3 ... 6) loads; `has`: which are present.
bool read_words(Cards& cards, const Words& words, PlatenCards& platen, double value[6], bool has[2]) {
  static const char* const kWords[6] = {"UX", "UY", "TURN", "FX", "FY", "MOMENT"};
  for (int32_t i = 1; i < words.count; i += 2) {
    int k = 0;
    while (k < 6 && !word_is(words, i, kWords[k])) ++k;
    if (k == 6) {
      word_fault(cards, words, i, "expected UX, UY, TURN (prescribed motions), FX, FY or MOMENT, and its value");
      return false;
    }
    const Known found = k < 3 ? Known::motion : Known::load;
    Known& known = platen.known[k % 3];
    if (known != Known::nothing && known != found) {
      word_fault(cards, words, i, kWords[k], " of a platen whose ", kWords[(k + 3) % 6],
                 " is prescribed on this card or an earlier one, expected one of the two in all load cases");
      return false;
    }
    known = found;
    has[k / 3] = true;
    if (!real_word(cards, words, i + 1, kWords[k], &value[k])) return false;
  }
  return true;
}

bool read_card(Deck& deck, const Words& words, PlatenCards& platen, int32_t body, const double point[2], bool sound) {
  Cards& cards = deck.cards;
  int32_t load_case = 0;
  double value[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  bool has[2] = {false, false};
  if (!integer_word(cards, words, 0, "load case", 1, 10000, &load_case)) return !cards.ended;
  if (platen.cases.again(load_case)) {
    word_fault(cards, words, 0, "load case ", load_case, " of this platen has two cards, expected one");
    return !cards.ended;
  }
  if (!read_words(cards, words, platen, value, has)) return !cards.ended;
  if (load_case > 1 && load_case > deck.sizes.load_cases) deck.sizes.load_cases = load_case;
  if (!sound || deck.sink == nullptr) return true;
  place_words(deck, words);
  c2d_solver* const s = deck.sink->solver;
  if (has[0] && !accept(deck, deck.sink->set_rigid(s, body, load_case, value, point))) return false;
  return !has[1] || accept(deck, deck.sink->set_rigid_load(s, body, load_case, nullptr, value + 3, nullptr));
}

} // namespace

void read_platen(Deck& deck, const Words& keyword_card) {
  Cards& cards = deck.cards;
  if (deck.problem.analysis == C2D_ANALYSIS_STRESS)
    return void(fault(cards, 0, 0, "a contact zone or platen in a stress analysis (IOUT 0), expected IOUT 1 or 2"));
  const int32_t old_faults = cards.faults;
  int32_t body = 1, range[2] = {1, 1}, elements = 0;
  double point[2] = {0.0, 0.0};
  if (!integer_word(cards, keyword_card, 0, "body number", 1, deck.sizes.bodies, &body)) return;
  const int32_t offset = element_offset(deck, body - 1), most = deck.body[body - 1].elements;
  integer_word(cards, keyword_card, 1, "first element of the platen", 1 + offset, most + offset, &range[0]);
  integer_word(cards, keyword_card, 2, "last element of the platen", 1 + offset, most + offset, &range[1]);
  real_word(cards, keyword_card, 3, "x of the point", &point[0]);
  real_word(cards, keyword_card, 4, "y of the point", &point[1]);
  if (keyword_card.count > 5) integer_word(cards, keyword_card, 5, "number of elements", 1, most, &elements);
  end_of_words(cards, keyword_card, 6);
  if (cards.faults == old_faults && elements == 0 && range[1] < range[0])
    word_fault(cards, keyword_card, 2, "last element of the platen is ", range[1], ", expected ", range[0],
               " or more; for a range across the end of its curve give the number of elements after the point");
  const bool sound = cards.faults == old_faults;
  const int32_t number = deck.sizes.bodies + ++deck.sizes.platens;
  if (sound) count_zone(deck, elements > 0 ? elements : range[1] - range[0] + 1, 0);
  if (sound && deck.sink != nullptr) {
    static const int32_t kAll[3] = {1, 1, 1};
    place_words(deck, keyword_card);
    accept(deck, deck.sink->add_platen(deck.sink->solver, body, range[0] - offset, range[1] - offset, elements, kAll, point));
  }
  const bool made = cards.faults == old_faults;
  PlatenCards platen = PlatenCards();
  for (Words words; next_data_card(deck, words);)
    if (!read_card(deck, words, platen, number, point, made)) return;
  if (cards.faults != old_faults || deck.sink == nullptr) return;
  int32_t is_free[3];
  for (int i = 0; i < 3; ++i) is_free[i] = platen.known[i] == Known::motion ? 0 : 1;
  accept(deck, deck.sink->set_rigid_load(deck.sink->solver, number, 0, is_free, nullptr, point));
}

} // namespace c2d
