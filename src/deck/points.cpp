// *POINTS: points for interior results, in global coordinates. Below it, cards
//   point body x y
//   line body x1 y1 x2 y2 n            n points from one end to the other
//   grid body x1 y1 x2 y2 nx ny        nx by ny points between opposite corners
#include "deck/keywords.hpp"

namespace c2d {
namespace {

// Largest number of points of one card: it and its double fit in 32 bits.
constexpr int32_t kMostPoints = INT32_MAX / 2;

// The numbers of the card after its word; false after any fault.
bool read_numbers(Deck& deck, const Words& words, c2d_points& points) {
  static const char* const kNames[] = {"x", "y", "x at the other end", "y at the other end"};
  Cards& cards = deck.cards;
  const int32_t ends = points.kind == C2D_POINTS_ONE ? 1 : 2, counts = points.kind;
  const int32_t old_faults = cards.faults;
  integer_word(cards, words, 1, "body number", 1, deck.sizes.bodies, &points.body);
  for (int32_t i = 0; i < 2 * ends; ++i) real_word(cards, words, 2 + i, kNames[i], i < 2 ? &points.from[i] : &points.to[i - 2]);
  for (int32_t i = 0; i < counts; ++i)
    integer_word(cards, words, 2 + 2 * ends + i,
                 points.kind == C2D_POINTS_LINE ? "number of points"
                 : i == 0                       ? "number of points in x"
                                                : "number of points in y",
                 1, kMostPoints, &points.count[i]);
  if (cards.faults == old_faults && points.count[0] > kMostPoints / points.count[1])
    word_fault(cards, words, 7, "the grid has more than ", kMostPoints, " points");
  return end_of_words(cards, words, 2 + 2 * ends + counts) && cards.faults == old_faults;
}

} // namespace

void read_points(Deck& deck, const Words& keyword_card) {
  static const char* const kWords[] = {"POINT", "LINE", "GRID"};
  Cards& cards = deck.cards;
  end_of_words(cards, keyword_card, 0);
  int32_t sets = 0;
  for (Words words; next_data_card(deck, words);) {
    c2d_points points = c2d_points();
    points.struct_size = static_cast<uint32_t>(sizeof points);
    points.count[0] = points.count[1] = 1;
    ++sets;
    while (points.kind < 3 && !word_is(words, 0, kWords[points.kind])) ++points.kind;
    if (points.kind == 3) {
      word_fault(cards, words, 0, "expected one of: point, line, grid");
      continue;
    }
    if (!read_numbers(deck, words, points) || deck.sink == nullptr) continue;
    place_words(deck, words);
    if (!accept(deck, deck.sink->add_points(deck.sink->solver, &points))) return;
  }
  if (sets == 0) fault(cards, 0, 0, "*POINTS without cards, expected at least one: point, line or grid");
  deck.sizes.point_sets += sets;
}

} // namespace c2d
