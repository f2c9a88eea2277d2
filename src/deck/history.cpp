// *CASES n: values of load cases 1 ... n in addition to the other cards of the deck, which are case 1. Below it, cards
//   case k                                        the following cards belong to case k
//   condition body elements local tx ty ux uy     elements: e or e1-e2, numbered as on the condition cards; local 0:
//                                                 all ends; known quantities only, the codes are the deck's
//   load body x y fx fy                           a point load, in global coordinates
// *PATH: replaces the load cards; below it, cards `increments f1 ... fn` with the factors of all cases at the end of
//   a straight path segment, which begins at the end of the last one (the first at zero). The factors may be any number:
//   they are read a few at a time. A card `cycle [limit] [DIGITS n] [FRICTIONLESS or COMPARE]` between them: those below it are
//   repeated until steady.
// *FRICTION: below it, cards `zone mu ...`, as many coefficients as the deck has; INF is full adhesion.
#include "deck/keywords.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"

namespace c2d {
namespace {

// Element numbers e or e1-e2.
bool range_word(Cards& cards, const Words& words, int32_t i, int32_t least, int32_t most, int32_t range[2]) {
  char text[24];
  copy_word(words, i, text, sizeof text);
  int64_t value[2] = {0, 0};
  int32_t part = 0, digits = 0;
  bool sound = text[0] != '\0';
  for (const char* c = text; *c != '\0' && sound; ++c) {
    if (*c == '-' && part == 0 && digits > 0) {
      part = 1;
      digits = 0;
      continue;
    }
    sound = *c >= '0' && *c <= '9' && ++digits <= 10;
    if (sound) value[part] = 10 * value[part] + (*c - '0');
  }
  sound = sound && digits > 0;
  if (part == 0) value[1] = value[0];
  if (!sound || value[0] < least || value[1] > most || value[1] < value[0]) {
    word_fault(cards, words, i, "elements are '", text, "', expected a number or a range e1-e2 within ", least, " to ", most);
    return false;
  }
  range[0] = static_cast<int32_t>(value[0]);
  range[1] = static_cast<int32_t>(value[1]);
  return true;
}

bool body_word(Deck& deck, const Words& words, int32_t* body) {
  return integer_word(deck.cards, words, 1, "body number", 1, deck.sizes.bodies, body);
}

bool real_words(Deck& deck, const Words& words, int32_t first, int32_t count, const char* const* names, double* out) {
  bool sound = true;
  for (int32_t i = 0; i < count; ++i) sound = real_word(deck.cards, words, first + i, names[i], &out[i]) && sound;
  return end_of_words(deck.cards, words, first + count) && sound;
}

void read_case_condition(Deck& deck, const Words& words, int32_t load_case) {
  static const char* const kNames[] = {"tx", "ty", "ux", "uy"};
  int32_t body = 0, range[2] = {0, 0}, local = 0;
  double values[4];
  if (!body_word(deck, words, &body)) return;
  const int32_t offset = element_offset(deck, body - 1);
  bool sound = range_word(deck.cards, words, 2, offset + 1, offset + deck.body[body - 1].elements, range);
  sound = integer_word(deck.cards, words, 3, "local functional node (0: all)", 0, deck.sizes.function_nodes, &local) && sound;
  sound = real_words(deck, words, 4, 4, kNames, values) && sound;
  if (!sound || deck.sink == nullptr) return;
  place_words(deck, words);
  for (int32_t element = range[0]; element <= range[1]; ++element) {
    const c2d_status status = deck.sink->set_values(deck.sink->solver, body, element - offset, local, load_case, values);
    if (!accept(deck, status) || status != C2D_OK) return;
  }
}

void read_case_load(Deck& deck, const Words& words, int32_t load_case) {
  static const char* const kNames[] = {"x", "y", "force fx", "force fy"};
  int32_t body = 0;
  double v[4];
  if (!body_word(deck, words, &body) || !real_words(deck, words, 2, 4, kNames, v)) return;
  if (deck.sink == nullptr) {
    ++deck.sizes.point_loads;
    return;
  }
  place_words(deck, words);
  accept(deck, deck.sink->add_point_load(deck.sink->solver, body, load_case, v[0], v[1], v[2], v[3]));
}

// The current card may already be the next keyword.
void no_cards(Cards& cards, int32_t keyword_line, const char* text) {
  const int32_t line = cards.line;
  cards.line = keyword_line;
  fault(cards, 0, 0, text);
  cards.line = line;
}

} // namespace

void read_cases(Deck& deck, const Words& keyword_card) {
  Cards& cards = deck.cards;
  int32_t cases = 1;
  const bool known = integer_word(cards, keyword_card, 0, "number of load cases", 1, 10000, &cases);
  end_of_words(cards, keyword_card, 1);
  if (known && cases > deck.sizes.load_cases) deck.sizes.load_cases = cases;
  int32_t load_case = 0;
  NumbersSeen seen = NumbersSeen();
  for (Words words; next_data_card(deck, words) && known;) {
    if (word_is(words, 0, "CASE")) {
      if (integer_word(cards, words, 1, "load case", 1, cases, &load_case) && seen.again(load_case))
        word_fault(cards, words, 1, "case ", load_case, " appears twice below *CASES, expected it once");
      end_of_words(cards, words, 2);
    } else if (load_case == 0) {
      word_fault(cards, words, 0, "expected a card `case k` before the first values of a load case");
    } else if (word_is(words, 0, "CONDITION")) {
      read_case_condition(deck, words, load_case);
    } else if (word_is(words, 0, "LOAD")) {
      read_case_load(deck, words, load_case);
    } else {
      word_fault(cards, words, 0, "expected one of: case, condition, load");
    }
    if (cards.ended) return;
  }
}

namespace {

// The factors behind the number of increments, all those that the card has.
void read_factors(Deck& deck, Words& words, int32_t increments, bool sound) {
  bool last = false;
  for (int32_t given = 0, count, first = 1; !last && !deck.cards.ended; given += count, first = 0) {
    double factor[kMaximumWords];
    count = 0;
    for (int32_t i = first; i < words.count; ++i)
      sound = real_word(deck.cards, words, i, "load factor", &factor[count++]) && sound;
    if (deck.sink != nullptr && sound) place_words(deck, words);
    last = !next_words(deck.cards, words);
    if (last && given + count == 0 && !deck.cards.ended)
      word_fault(deck.cards, words, 0, "no load factors, expected one per load case");
    if (deck.sink != nullptr && sound && given + count > 0)
      sound = accept(deck, deck.sink->add_factors(deck.sink->solver, increments, given, factor, count, last));
  }
}

// The card `cycle [limit] [DIGITS n] [FRICTIONLESS or COMPARE]`: the segments below it are a cycle.
struct CycleCard {
  int32_t line, column, column_end; // line 0: there is none
  int32_t before;                   // segments above it
  int32_t limit, digits, start;
};

void read_cycle(Deck& deck, const Words& words, int32_t pieces, CycleCard& out) {
  constexpr int32_t kStates = 30, kMostCycles = 1000000, kMostDigits = 12;
  Cards& cards = deck.cards;
  if (out.line != 0) return void(word_fault(cards, words, 0, "a second cycle below *PATH, expected one"));
  deck.sizes.cycle_states = kStates;
  out = CycleCard{cards.line, words.word[0].column, words.word[0].column_end, pieces, 0, 0, C2D_START_AS_LOADED};
  int32_t at = 1;
  const auto is_start = [&words](int32_t i) { return word_is(words, i, "FRICTIONLESS") || word_is(words, i, "COMPARE"); };
  if (at < words.count && !word_is(words, at, "DIGITS") && !is_start(at))
    integer_word(cards, words, at++, "limit of cycles", 1, kMostCycles, &out.limit);
  if (at < words.count && word_is(words, at, "DIGITS")) {
    integer_word(cards, words, at + 1, "number of digits", 1, kMostDigits, &out.digits);
    at += 2;
  }
  if (at < words.count && is_start(at))
    out.start = word_is(words, at++, "COMPARE") ? C2D_START_COMPARED : C2D_START_WITHOUT_FRICTION;
  end_of_words(cards, words, at);
}

// All segments are known: those of the cycle. Its faults are those of its card.
void end_cycle_card(Deck& deck, const CycleCard& card, int32_t pieces, bool sound) {
  Cards& cards = deck.cards;
  const int32_t line = cards.line;
  cards.line = card.line;
  if (pieces - card.before < 2) {
    fault(cards, card.column, card.column_end, "the cycle has ", pieces - card.before,
          pieces - card.before == 1 ? " card" : " cards", " below it, expected two or more: increments f1 ... fn");
  } else if (deck.sink != nullptr && deck.sink->repeat_paths == nullptr) {
    fault(cards, card.column, card.column_end, "a cycle", kNeedsPart, "c2d_repeat_paths links it");
  } else if (deck.sink != nullptr && sound) {
    place(deck, card.column, card.column_end);
    accept(deck, deck.sink->repeat_paths(deck.sink->solver, pieces - card.before, card.limit, card.digits, card.start));
  }
  cards.line = line;
}

} // namespace

void read_path(Deck& deck, const Words& keyword_card) {
  Cards& cards = deck.cards;
  end_of_words(cards, keyword_card, 0);
  const int32_t line = cards.line;
  const int32_t faults = cards.faults;
  int32_t pieces = 0;
  CycleCard cycle = CycleCard();
  for (Words words; next_data_card(deck, words, FieldList::allowed);) {
    if (!kSmallCode && word_is(words, 0, "CYCLE")) {
      read_cycle(deck, words, pieces, cycle);
      if (cards.ended) break;
      continue;
    }
    int32_t increments = 0;
    const bool sound = integer_word(cards, words, 0, "number of load increments", 1, INT32_MAX, &increments);
    ++pieces;
    if (pieces == 1 && deck.sink != nullptr && !accept(deck, deck.sink->clear_paths(deck.sink->solver))) return;
    read_factors(deck, words, increments, sound);
    if (cards.ended) break;
  }
  if (pieces == 0) no_cards(cards, line, "*PATH without cards, expected at least one: increments f1 ... fn");
  if (!kSmallCode && cycle.line != 0) end_cycle_card(deck, cycle, pieces, cards.faults == faults);
  if (pieces > deck.sizes.paths) deck.sizes.paths = pieces;
}

namespace {

// The field after field i of a card that may go on: on this line, or the first of the next.
int32_t next_field(Cards& cards, Words& words, int32_t i) {
  return i + 1 < words.count || !next_words(cards, words) ? i + 1 : 0;
}

// The coefficients behind the zone. False: the deck is not read on.
bool read_coefficients(Deck& deck, Words& words, int32_t zone) {
  Cards& cards = deck.cards;
  int32_t at = next_field(cards, words, 0);
  for (int32_t i = 1; i <= deck.sizes.coefficients && !cards.ended; ++i) {
    double mu = HUGE_VAL;
    if (!word_is(words, at, "INF") && !real_word(cards, words, at, "coefficient of friction", &mu)) return true;
    if (mu < 0.0) word_fault(cards, words, at, "the coefficient of friction is negative, expected 0 or more, or INF");
    if (mu >= 0.0 && deck.sink != nullptr) {
      place_words(deck, words);
      if (!accept(deck, deck.sink->set_zone_friction(deck.sink->solver, zone, i, mu))) return false;
    }
    at = next_field(cards, words, at);
  }
  if (cards.ended) return true;
  if (at == deck.sizes.coefficients + 1)
    end_of_words(cards, words, at);
  else if (at < words.count) // of a card on several lines
    word_fault(cards, words, at, "the card goes on, expected its end after ", deck.sizes.coefficients,
               " coefficients of friction");
  return true;
}

} // namespace

void read_friction(Deck& deck, const Words& keyword_card) {
  Cards& cards = deck.cards;
  end_of_words(cards, keyword_card, 0);
  const int32_t line = cards.line;
  bool any = false;
  NumbersSeen seen = NumbersSeen();
  for (Words words; next_data_card(deck, words, FieldList::allowed);) {
    int32_t zone = 0;
    any = true;
    bool sound = integer_word(cards, words, 0, "contact zone", 1, deck.sizes.zones, &zone);
    if (sound && seen.again(zone)) {
      word_fault(cards, words, 0, "zone ", zone, " appears twice below *FRICTION, expected it once");
      sound = false;
    }
    if (sound && !read_coefficients(deck, words, zone)) return;
    while (!cards.ended && next_words(cards, words)) {
    } // what a card with a fault still has
    if (cards.ended) break;
  }
  if (!any) no_cards(cards, line, "*FRICTION without cards, expected at least one: zone mu ...");
}

} // namespace c2d
