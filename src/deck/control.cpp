// Heading, problem type, numbers of bodies, elements and regions, elastic constants, friction.
#include "deck/deck.hpp"

#include <string.h>

namespace c2d {
namespace {

constexpr int32_t kTitleColumns = 72; // format 18A4
constexpr int32_t kCoefficientsPerCard = 7;

bool read_problem_type(Deck& deck) {
  Cards& cards = deck.cards;
  if (!next_card(cards, "the type of problem")) return false;
  int32_t plane = 0;
  int32_t output = C2D_ANALYSIS_CONTACT; // default if unreadable: it allows any number of zones
  integer(cards, 1, 5, "problem type (IPTYPE, 0 plane strain, 1 plane stress, 2 axisymmetric)", 0, 2, &plane);
  any_integer(cards, 6, "type of output (IOUT)", &output);
  end_of_fields(cards, 11);
  deck.problem.plane = plane;
  deck.problem.analysis = output;
  if (deck.sink == nullptr) return true;
  place(deck, 1, 10);
  return accept(deck, deck.sink->set_problem(deck.sink->solver, &deck.problem));
}

// A deck cannot change the sizes for which the workspace was created.
bool fits_workspace(Deck& deck) {
  if (deck.sink == nullptr) return true;
  const int32_t bodies = deck.sink->bodies, nodes = deck.sink->function_nodes;
  const int32_t old_faults = deck.cards.faults;
  if (bodies > 0 && bodies != deck.sizes.bodies)
    field_fault(deck.cards, 1, 5, "number of bodies is ", deck.sizes.bodies, ", but the workspace was made for ", bodies);
  if (nodes > 0 && nodes != deck.sizes.function_nodes)
    field_fault(deck.cards, 11, 15, "number of functional nodes per element is ", deck.sizes.function_nodes,
                ", but the workspace was made for ", nodes);
  return deck.cards.faults == old_faults;
}

// The caller owns the list of bodies. If it is too short, only the number of bodies is returned.
bool fits_list(Deck& deck) {
  Cards& cards = deck.cards;
  if (deck.sizes.bodies <= deck.room) return true;
  cards.counting = false; // not a fault of the deck
  put_all(begin_field_fault(cards, 1, 5), "c2d_limits.body has room for ", deck.room, ", the deck has ", deck.sizes.bodies,
          deck.sizes.bodies == 1 ? " body" : " bodies");
  cards.entry.status = C2D_ERR_LIMIT;
  end_fault(cards);
  cards.status = C2D_ERR_LIMIT;
  cards.ended = true;
  return false;
}

bool read_counts(Deck& deck) {
  Cards& cards = deck.cards;
  c2d_limits& sizes = deck.sizes;
  if (!next_card(cards, "the numbers of bodies and contact zones")) return false;
  deck.zones_line = cards.line;
  integer(cards, 1, 5, "number of bodies", 1, INT32_MAX, &sizes.bodies);
  integer_from(cards, 6, "number of contact zones", 0, &sizes.zones);
  integer(cards, 11, 5, "number of functional nodes per element", 1, 4, &sizes.function_nodes);
  end_of_fields(cards, 16);
  if (cards.ended) return false;
  if (sizes.zones > 0 && deck.problem.analysis == C2D_ANALYSIS_STRESS)
    field_fault(cards, 6, 10, "number of contact zones is ", sizes.zones,
                ", expected 0: a stress analysis (IOUT 0) has no contact zones; IOUT 1 or 2 is contact");
  return fits_workspace(deck) && !cards.ended && fits_list(deck);
}

bool set_body(Deck& deck, int b, double youngs_modulus, double poisson_ratio) {
  if (deck.sink == nullptr) return true;
  c2d_body data = c2d_body();
  data.struct_size = static_cast<uint32_t>(sizeof data);
  data.element_nodes = element_nodes(deck, b);
  data.elements = deck.body[b].elements;
  data.regions = deck.body[b].regions;
  data.open_regions = open_regions(deck, b);
  data.youngs_modulus = youngs_modulus;
  data.poisson_ratio = poisson_ratio;
  place(deck, 1, 20);
  return accept(deck, deck.sink->set_body(deck.sink->solver, b + 1, &data));
}

bool read_body(Deck& deck, int b) {
  Cards& cards = deck.cards;
  if (!next_card(cards, "the numbers of regions and elements of a body")) return false;
  c2d_body_limits& body = deck.body[b];
  int32_t nodes = 2; // of an element
  integer_from(cards, 1, "number of regions", 1, &body.regions);
  integer(cards, 6, 5, "number of boundary nodes per element", 2, 4, &nodes);
  integer_from(cards, 11, "number of elements", 1, &body.elements);
  integer_from(cards, 16, "number of boundary points", 1, &body.points);
  end_of_fields(cards, 21);
  if (cards.ended) return false;
  deck.elements += body.elements;
  if (deck.elements > kMostElements)
    field_fault(cards, 11, 15, "number of elements of all bodies is ", deck.elements, ", expected at most ", kMostElements);
  const int64_t expected = int64_t{body.elements} * (nodes - 1), beyond = body.points - expected;
  if (beyond < 0 || beyond > body.regions)
    field_fault(cards, 16, 20, "number of boundary points is ", body.points, ", expected ", expected, ": ", body.elements,
                " elements of ", nodes, " nodes");
  if (body.regions > body.elements)
    field_fault(cards, 1, 5, "number of regions is ", body.regions, ", expected at most ", body.elements,
                ", the number of elements");
  keep_body_card(deck, b, nodes);
  return !cards.ended && set_body(deck, b, 1.0, 0.0);
}

// Does the numbering of elements continue from body to body? The first region card of body 2 decides for all. If it is
// wrong, the guess that causes the fewest later faults is used.
bool continues(const Deck& deck, bool first_known, int32_t first, int32_t last) {
  if (first_known && first == deck.body[0].elements + 1) return true;
  if (first_known && first == 1) return false;
  return last > deck.body[1].elements;
}

// Region `number` of a body begins at element *next (within the body).
bool read_region(Deck& deck, int b, int32_t number, int32_t* next) {
  Cards& cards = deck.cards;
  if (!next_card(cards, "the first and last element of a region")) return false;
  const int32_t elements = deck.body[b].elements;
  int32_t first = 0, last = 0;
  const bool first_known = any_integer(cards, 1, "first element of the region", &first);
  const bool last_known = any_integer(cards, 6, "last element of the region", &last);
  end_of_fields(cards, 11);
  if (b == 1 && number == 1) deck.elements_continue = continues(deck, first_known, first, last);
  const int32_t offset = element_offset(deck, b);
  const int32_t expected = *next + offset;
  const bool is_last = number == deck.body[b].regions;
  const bool first_sound = first_known && first == expected;
  const bool last_sound = last_known && last <= elements + offset && last >= (is_last ? elements + offset : expected);
  if (first_known && !first_sound) field_fault(cards, 1, 5, "first element of the region is ", first, ", expected ", expected);
  if (last_known && !last_sound && is_last)
    field_fault(cards, 6, 10, "last element of the region is ", last, ", expected ", elements + offset);
  else if (last_known && !last_sound)
    field_fault(cards, 6, 10, "last element of the region is ", last, ", expected ", expected, " to ", elements + offset);
  *next = last_sound && last - offset < elements ? last - offset + 1 : elements;
  if (deck.sink == nullptr || !first_sound || !last_sound) return !cards.ended;
  place(deck, 1, 10);
  return accept(deck, deck.sink->add_region(deck.sink->solver, b + 1, first - offset, last - offset));
}

bool read_elastic_constants(Deck& deck, int b) {
  Cards& cards = deck.cards;
  if (!next_card(cards, "the elastic constants of a body")) return false;
  double modulus = 0, ratio = 0;
  bool sound = real(cards, 1, "Young's modulus", &modulus);
  if (sound && !(modulus > 0)) {
    field_fault(cards, 1, 10, "Young's modulus is ", modulus, ", expected more than 0");
    sound = false;
  }
  const bool ratio_known = real(cards, 11, "Poisson's ratio", &ratio);
  if (ratio_known && !(ratio > -1 && ratio <= 0.5))
    field_fault(cards, 11, 20, "Poisson's ratio is ", ratio, ", expected more than -1 and at most 0.5");
  else if (ratio_known && deck.problem.plane == C2D_PLANE_STRESS && !(ratio > -0.5))
    field_fault(cards, 11, 20, "Poisson's ratio is ", ratio, ", expected more than -0.5 in plane stress");
  else if (ratio_known && sound && !set_body(deck, b, modulus, ratio))
    return false;
  end_of_fields(cards, 21);
  return !cards.ended;
}

// In the free form: further fields of the card, or a further card.
bool more_coefficients(Cards& cards) {
  const bool more = next_words(cards, cards.words);
  if (more) cards.taken = 0;
  return more || (!cards.ended && next_card(cards, "a further card with coefficients of friction", FieldList::allowed));
}

// Is coefficient i on a further card? In the fixed form after every seventh, in the free form where the card ends.
bool go_to_coefficient(Cards& cards, int32_t i) {
  if (cards.free_form) return words_left(cards) > 0 || more_coefficients(cards);
  if (i == 0 || i % kCoefficientsPerCard != 0) return true;
  if (!next_card(cards, "a further card with coefficients of friction")) return false;
  int32_t nothing;
  const c2d_card_fn card = cards.card;
  cards.card = nullptr; // no field, only columns that should be blank
  integer(cards, 1, 5, "columns 1-5 of a further card of coefficients", 0, 0, &nothing);
  cards.card = card;
  return true;
}

bool read_friction(Deck& deck) {
  Cards& cards = deck.cards;
  if (!next_card(cards, "the coefficients of friction", FieldList::allowed)) return false;
  if (!count(cards, 1, "number of coefficients of friction", 1, &deck.sizes.coefficients)) return false;
  for (int32_t i = 0; i < deck.sizes.coefficients; ++i) {
    if (!go_to_coefficient(cards, i)) return false;
    if (i % kCoefficientsPerCard == 0) unused_column(cards, 6);
    const int32_t column = 7 + 10 * (i % kCoefficientsPerCard);
    double mu = 0;
    if (!real(cards, column, "coefficient of friction", &mu)) continue;
    if (mu < 0)
      field_fault(cards, column, column + 9, "coefficient of friction is ", mu, ", expected at least 0");
    else if (deck.sink != nullptr) {
      place(deck, column, column + 9);
      if (!accept(deck, deck.sink->add_friction(deck.sink->solver, mu))) return false;
    }
  }
  cards.counting = true; // more cards than counted: then the next cards are misread as well
  end_of_fields(cards, 7 + 10 * kCoefficientsPerCard);
  cards.counting = false;
  return !cards.ended;
}

// The card with the number of heading cards is the first, except *FREE.
bool read_first_card(Cards& cards) {
  static const char* const kName = "the number of heading cards";
  if (!next_heading(cards, kName)) return false;
  split_words(cards.text, cards.length, cards.words);
  if (!word_is(cards.words, 0, "*FREE")) {
    refuse_tabs(cards);
    if (cards.words.count > 0 && cards.text[cards.words.word[0].column - 1] == '*')
      word_fault(cards, cards.words, 0, "a keyword card stands first, expected *FREE or ", kName);
    else
      return true;
    return false;
  }
  end_of_words(cards, cards.words, 1);
  cards.free_form = true;
  tell_field(cards, C2D_CARD_FREE, 0, 0, cards.text, 0, 0);
  const int32_t comment = before_comment(cards.text, cards.length) + 1;
  if (comment <= cards.length) tell_field(cards, C2D_CARD_COMMENT, 0, 0, cards.text + comment, cards.length - comment, 0);
  return next_card(cards, kName);
}

} // namespace

bool read_heading(Deck& deck) {
  Cards& cards = deck.cards;
  int32_t headings = 0;
  if (!read_first_card(cards)) return false;
  if (!count(cards, 1, "number of heading cards", 1, &headings)) return false;
  if (cards.free_form) end_of_fields(cards, 6);
  for (int32_t i = 0; i < headings; ++i) {
    if (!next_heading(cards, "a heading card")) return false;
    tell_field(cards, C2D_CARD_HEADING, 0, 0, cards.text, cards.length, 0);
  }
  int32_t used = kTitleColumns;
  while (used > 0 && (cards.text[used - 1] == ' ' || cards.text[used - 1] == '\t')) --used;
  deck.problem.struct_size = static_cast<uint32_t>(sizeof deck.problem);
  for (int32_t i = 0; i < used; ++i) deck.problem.title[i] = cards.text[i] == '\t' ? ' ' : cards.text[i];
  return true;
}

bool read_control(Deck& deck) {
  deck.cards.counting = true;
  if (!read_problem_type(deck) || !read_counts(deck)) return false;
  const int32_t bodies = deck.sizes.bodies;
  for (int b = 0; b < bodies; ++b) {
    deck.cards.body = b + 1;
    if (!read_body(deck, b)) return false;
  }
  for (int b = 0; b < bodies; ++b) {
    deck.cards.body = b + 1;
    int32_t next = 1;
    for (int32_t i = 1; i <= deck.body[b].regions; ++i)
      if (!read_region(deck, b, i, &next)) return false;
  }
  deck.cards.body = 0;
  deck.cards.counting = false;
  return true;
}

bool read_materials(Deck& deck) {
  for (int b = 0; b < deck.sizes.bodies; ++b) {
    deck.cards.body = b + 1;
    if (!read_elastic_constants(deck, b)) return false;
  }
  deck.cards.body = 0;
  return read_friction(deck);
}

} // namespace c2d
