// The load path.
#include "deck/deck.hpp"

namespace c2d {
namespace {

bool read_load_header(Deck& deck) {
  Cards& cards = deck.cards;
  if (!next_card(cards, "the number of load cards")) return false;
  const bool paths_known = count(cards, 1, "number of load cards", 1, &deck.sizes.paths);
  const bool limit_known = integer_from(cards, 6, "limit of iterations", 1, &deck.problem.iteration_limit);
  end_of_fields(cards, 11);
  if (!paths_known || cards.ended) return false;
  if (deck.sink == nullptr || !limit_known) return true;
  place(deck, 1, 10);
  return accept(deck, deck.sink->set_problem(deck.sink->solver, &deck.problem));
}

bool read_load(Deck& deck) {
  Cards& cards = deck.cards;
  if (!next_card(cards, "a load card")) return false;
  int32_t increments = 0;
  double load = 0;
  const bool increments_known = integer_from(cards, 1, "number of load increments", 1, &increments);
  unused_column(cards, 6);
  const bool load_known = real(cards, 7, "load factor", &load);
  end_of_fields(cards, 17);
  if (deck.sink == nullptr || !increments_known || !load_known) return !cards.ended;
  place(deck, 1, 16);
  return accept(deck, deck.sink->add_load_card(deck.sink->solver, increments, load));
}

} // namespace

bool read_loads(Deck& deck) {
  if (!read_load_header(deck)) return false;
  for (int32_t i = 0; i < deck.sizes.paths; ++i)
    if (!read_load(deck)) return false;
  return true;
}

} // namespace c2d
