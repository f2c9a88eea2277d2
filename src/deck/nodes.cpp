// Boundary points: origin, node cards, generation along lines and arcs.
#include "deck/deck.hpp"
#include "memory/math.hpp"
#include "model/polar.hpp"

namespace c2d {
namespace {

// A node card; x, y are local Cartesian coordinates.
struct NodeCard {
  int32_t node; // within the body
  bool sound;   // the coordinates are known
  bool polar;
  double radius, angle; // of a polar card
  double x, y;
};

bool read_origin(Deck& deck, double origin[2]) {
  Cards& cards = deck.cards;
  if (!next_card(cards, "the origin of a body")) return false;
  real(cards, 1, "x of the origin", &origin[0]);
  real(cards, 11, "y of the origin", &origin[1]);
  end_of_fields(cards, 21);
  return !cards.ended;
}

// The coordinate letter of the card, blank if absent. In the free form it is a separate field that begins
// with a letter, before the others.
char read_letter(Cards& cards) {
  char letter = cards.text[0];
  if (cards.free_form) {
    const char first = capital(cards.text[cards.words.word[0].column - 1]);
    if (first < 'A' || first > 'Z') return ' ';
    take_word(cards, 1, 1);
    letter = word_is(cards.words, 0, "P") ? 'P' : '?';
  }
  if (letter == 'P') tell_field(cards, C2D_CARD_LETTER, 1, 1, "P", 1, 0);
  return letter;
}

void refuse_letter(Cards& cards, char letter) {
  if (letter == 'C') return; // reported already as a possible comment
  char shown[12] = {letter, '\0'};
  if (cards.free_form) copy_word(cards.words, 0, shown, sizeof shown);
  const Word at = columns_of(cards, 1, 1);
  const bool is_one = at.column == at.column_end;
  Text& text = begin_fault(cards, at.column, at.column_end);
  put_all(text, is_one ? "column " : "columns ", int32_t{at.column});
  if (!is_one) {
    put_character(text, '-');
    put(text, int32_t{at.column_end});
  }
  put_all(text, is_one ? " contains '" : " contain '", shown, "', expected a coordinate letter, which is blank or P");
  end_fault(cards);
}

void read_coordinates(Cards& cards, char letter, NodeCard& card) {
  card.sound = !cards.refused && (letter == ' ' || letter == 'P');
  if (!cards.refused && !card.sound) refuse_letter(cards, letter);
  card.polar = letter == 'P';
  unused_column(cards, 6);
  double first = 0, second = 0;
  const bool first_known = real(cards, 7, card.polar ? "radius" : "x of a node", &first);
  const bool second_known = real(cards, 17, card.polar ? "angle in degrees" : "y of a node", &second);
  end_of_fields(cards, 27);
  card.sound = card.sound && first_known && second_known;
  card.x = first;
  card.y = second;
  if (!card.polar) return;
  if (first_known && first < 0) {
    field_fault(cards, 7, 16, "radius is ", first, ", expected at least 0");
    card.sound = false;
  }
  card.radius = first;
  card.angle = second;
  double cosine, sine;
  cosine_and_sine(second, &cosine, &sine);
  card.x = first * cosine;
  card.y = first * sine;
}

bool set_node(Deck& deck, int b, int32_t node, double x, double y) {
  if (deck.sink == nullptr) return true;
  const double* origin = deck.sink->origin[b];
  const double xy[2] = {x + origin[0], y + origin[1]};
  return accept(deck, deck.sink->set_nodes(deck.sink->solver, b + 1, node, 1, xy, 2));
}

bool is_same_radius(double a, double b) { return fabs(a - b) <= 1e-6 * (a > b ? a : b); }

// The nodes between two cards, equally spaced along a line or, if the second card is polar, along an arc.
bool generate(Deck& deck, int b, const NodeCard& from, const NodeCard& to) {
  if (!from.sound || !to.sound || to.node - from.node < 2) return true;
  if (to.polar && !from.polar) {
    field_fault(deck.cards, 1, 1, "nodes before number ", to.node, " lie on an arc, expected a P card before this one too");
    return !deck.cards.ended;
  }
  if (to.polar && !is_same_radius(from.radius, to.radius)) {
    field_fault(deck.cards, 7, 16, "radius is ", to.radius, ", expected ", from.radius,
                ": the nodes before this one lie on an arc from the card before");
    return !deck.cards.ended;
  }
  const int32_t steps = to.node - from.node;
  for (int32_t i = 1; i < steps; ++i) {
    const double start[2] = {from.x, from.y}, end[2] = {to.x, to.y};
    double point[2];
    if (to.polar)
      point_on_arc(to.radius, from.angle, to.angle, i, steps, point);
    else
      point_on_line(start, end, i, steps, point);
    if (!set_node(deck, b, from.node + i, point[0], point[1])) return false;
  }
  return true;
}

// Converts the node number of the card to that within the body. False: it is wrong, which has been
// reported unless this is probably not a node card.
bool read_number(Deck& deck, int b, bool is_first, bool doubtful, int32_t previous, int32_t* node) {
  Cards& cards = deck.cards;
  int32_t number = 0;
  if (doubtful && !peek_integer(cards, 2, 4, &number)) return false;
  if (!integer(cards, 2, 4, "node number", INT32_MIN, INT32_MAX, &number)) return false;
  // The first card of body 2 decides whether node numbers continue from body to body.
  if (b == 1 && is_first) deck.nodes_continue = number > deck.body[0].points;
  const int32_t offset = point_offset(deck, b);
  const int32_t nodes = deck.body[b].points;
  *node = number > 0 ? number - offset : number;
  if (is_first && *node == 1) return true;
  if (!is_first && *node > previous && *node <= nodes) return true;
  if (doubtful) return false;
  const int32_t least = previous + 1 + offset;
  if (is_first)
    field_fault(cards, 2, 5, "first node number is ", number, ", expected ", least);
  else if (previous + 1 == nodes)
    field_fault(cards, 2, 5, "node number is ", number, ", expected ", least);
  else
    field_fault(cards, 2, 5, "node number is ", number, ", expected ", least, " to ", nodes + offset);
  return false;
}

bool next_node_card(Cards& cards) {
  cards.is_node_section = true;
  const bool found = next_card(cards, "a node card");
  cards.is_node_section = false;
  return found;
}

} // namespace

// A card with a wrong number is skipped; after two in succession the reader is probably not reading
// node cards at all, and the reading ends.
bool read_nodes(Deck& deck, int b) {
  Cards& cards = deck.cards;
  cards.body = b + 1;
  double origin[2] = {0, 0};
  if (!read_origin(deck, origin)) return false;
  for (int c = 0; c < 2 && deck.sink != nullptr; ++c) deck.sink->origin[b][c] = origin[c];
  const int32_t nodes = deck.body[b].points;
  NodeCard previous = NodeCard();
  bool doubtful = false;
  for (bool is_first = true; previous.node < nodes; is_first = false) {
    if (!next_node_card(cards)) return false;
    NodeCard card = NodeCard();
    const char letter = read_letter(cards);
    const bool number_sound = read_number(deck, b, is_first, doubtful, previous.node, &card.node);
    if (!number_sound && doubtful) return false;
    read_coordinates(cards, letter, card);
    doubtful = !number_sound;
    if (cards.ended) return false;
    if (number_sound) {
      place(deck, 7, 26);
      if (!generate(deck, b, previous, card)) return false;
      if (card.sound && !set_node(deck, b, card.node, card.x, card.y)) return false;
      previous = card;
    } else {
      // A first node that is not number 1 still continues the numbering.
      if (is_first && card.node > 0 && card.node <= nodes) previous.node = card.node;
      previous.sound = false;
    }
  }
  return true;
}

} // namespace c2d
