#include "deck/deck.hpp"

#include <string.h>

namespace c2d {
namespace {

constexpr int32_t kSequenceColumn = 72; // columns after it contain sequence numbers

// Whether open regions are legal is known only at the end of the deck, after *SYMMETRY, except in bodies of revolution.
void check_open_regions(Deck& deck) {
  Cards& cards = deck.cards;
  const int32_t line = cards.line;
  const bool allowed = deck.symmetry != 0 || deck.problem.plane == C2D_AXISYMMETRIC;
  for (int b = 0; b < deck.sizes.bodies && !allowed; ++b) {
    if (open_regions(deck, b) == 0 || cards.status != C2D_OK) continue;
    cards.body = b + 1;
    cards.line = body_line(deck, b);
    const int32_t points = deck.body[b].points;
    fault(cards, 0, 0, "number of boundary points is ", points, ", expected ", points - open_regions(deck, b), ": ",
          deck.body[b].elements, " elements of ", element_nodes(deck, b),
          " nodes; more only with *SYMMETRY, one for each open region"); // columns unknown: the card is no longer in memory
  }
  cards.line = line;
  cards.body = 0;
}

bool read_sections(Deck& deck) {
  if (!read_heading(deck) || !read_control(deck) || !read_materials(deck)) return false;
  for (int b = 0; b < deck.sizes.bodies; ++b)
    if (!read_nodes(deck, b)) return false;
  for (int b = 0; b < deck.sizes.bodies; ++b)
    if (!read_conditions(deck, b) || !read_point_loads(deck, b)) return false;
  deck.cards.body = 0;
  if (!read_zones(deck) || !read_loads(deck)) return false;
  read_extensions(deck);
  check_open_regions(deck);
  return true;
}

} // namespace

c2d_status read_deck_cards(const DeckSink* sink, c2d_read_line read, void* context, c2d_report report, void* report_context,
                           c2d_limits* sizes, c2d_card_fn card, void* card_context) {
  Deck deck;
  memset(&deck, 0, sizeof deck);
  deck.body = sizes->body;
  deck.room = sizes->body != nullptr ? sizes->bodies : 0;
  start_cards(deck.cards, read, context, report, report_context);
  deck.cards.card = card;
  deck.cards.card_context = card_context;
  deck.sink = sink;
  deck.sizes.load_cases = 1;
  read_sections(deck);
  if (deck.cards.status == C2D_ERR_LIMIT) sizes->bodies = deck.sizes.bodies;
  if (deck.cards.status != C2D_OK) return deck.cards.status;
  if (deck.cards.faults > 0) return C2D_ERR_INPUT;
  *sizes = deck.sizes;
  sizes->struct_size = static_cast<uint32_t>(sizeof *sizes);
  sizes->body = deck.body;
  for (int b = 0; b < sizes->bodies; ++b) sizes->body[b].reserved = 0;
  return C2D_OK;
}

void place(Deck& deck, int32_t column, int32_t column_end) {
  const Word at = columns_of(deck.cards, column, column_end);
  if (deck.sink != nullptr) accept(deck, deck.sink->set_line(deck.sink->solver, deck.cards.line, at.column, at.column_end));
}

void place_words(Deck& deck, const Words& words) {
  const int32_t first = words.count > 0 ? words.word[0].column : 1;
  const int32_t last = words.count > 0 ? words.word[words.count - 1].column_end : words.end;
  accept(deck, deck.sink->set_line(deck.sink->solver, deck.cards.line, first, last));
}

bool accept(Deck& deck, c2d_status status) {
  if (status == C2D_OK) return !deck.cards.ended;
  ++deck.cards.faults;
  if (deck.sink->refused != nullptr) deck.sink->refused(deck.sink->context);
  if (status != C2D_ERR_ARGUMENT && status != C2D_ERR_INPUT) {
    if (deck.cards.status == C2D_OK) deck.cards.status = status;
    deck.cards.ended = true;
  }
  if (deck.cards.faults > kMaximumFaults) deck.cards.ended = true;
  return !deck.cards.ended;
}

int32_t numbers_on(const Cards& cards) {
  if (cards.free_form) return cards.words.count;
  int32_t numbers = 0;
  for (int32_t i = 0; i < kSequenceColumn; ++i) {
    const char c = cards.text[i];
    const bool begins = i == 0 || cards.text[i - 1] == ' ';
    if (begins && ((c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+')) ++numbers;
  }
  return numbers;
}

bool read_count(Deck& deck, const char* name, int32_t* value) {
  deck.counted = name;
  deck.counted_line = deck.cards.line;
  deck.counted_body = deck.cards.body;
  if (!count(deck.cards, 1, name, 0, value)) return false;
  deck.counted_cards = *value;
  end_of_fields(deck.cards, 6);
  return true;
}

bool fits_count(Deck& deck, bool fits, int32_t read_so_far) {
  Cards& cards = deck.cards;
  if (fits || cards.refused || deck.counted == nullptr) return true;
  const int32_t line = cards.line, body = cards.body;
  cards.line = deck.counted_line;
  cards.body = deck.counted_body;
  const bool fixed = !cards.free_form; // the card is no longer in memory, nor the columns of its fields
  const int32_t column = deck.counted_line == deck.zones_line ? 6 : 1;
  fault(cards, fixed ? column : 0, fixed ? column + 4 : 0, deck.counted, " is ", deck.counted_cards, ", but line ", line,
        read_so_far < deck.counted_cards ? " contains another kind of card after "
                                         : " contains one more, or a wrong card, after ",
        read_so_far, " of them; the rest cannot be read without it");
  cards.line = line;
  cards.body = body;
  cards.ended = true;
  return false;
}

namespace {
constexpr int32_t kElementNodesBase = 8; // above any number of nodes of an element
}

void keep_body_card(Deck& deck, int b, int32_t element_nodes) {
  const int32_t last = INT32_MAX / kElementNodesBase - 1, line = deck.cards.line;
  deck.body[b].reserved = (line < last ? line : last) * kElementNodesBase + element_nodes;
}

int32_t body_line(const Deck& deck, int b) { return deck.body[b].reserved / kElementNodesBase; }

int32_t element_nodes(const Deck& deck, int b) { return deck.body[b].reserved % kElementNodesBase; }

int32_t open_regions(const Deck& deck, int b) {
  return deck.body[b].points - deck.body[b].elements * (element_nodes(deck, b) - 1);
}

int32_t element_offset(const Deck& deck, int b) {
  int32_t before = 0;
  for (int i = 0; i < b && deck.elements_continue; ++i) before += deck.body[i].elements;
  return before;
}

int32_t point_offset(const Deck& deck, int b) {
  int32_t before = 0;
  for (int i = 0; i < b && deck.nodes_continue; ++i) before += deck.body[i].points;
  return before;
}

int32_t function_node_offset(const Deck& deck, int b) {
  int32_t before = 0;
  for (int i = 0; i < b && deck.nodes_continue; ++i) before += function_node_count(deck, i);
  return before;
}

int32_t function_node_count(const Deck& deck, int b) {
  const int32_t per_element = deck.sizes.function_nodes > 1 ? deck.sizes.function_nodes - 1 : 1;
  return deck.body[b].elements * per_element + (deck.sizes.function_nodes > 1 ? open_regions(deck, b) : 0);
}

} // namespace c2d
