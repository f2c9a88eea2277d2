// *NAME BODY number text, *NAME ZONE number text: name of a body or a zone. The name is the rest of the card after the
// number, in any script.
#include "deck/keywords.hpp"

#include "memory/characters.hpp"

namespace c2d {
namespace {

bool is_blank_or_tab(char c) { return c == ' ' || c == '\t'; }

// The text from the first word of the name to the comment; false if it is invalid, which was reported.
bool read_text(Cards& cards, const Words& words, char (&name)[kLongestName + 1]) {
  constexpr int32_t kFirst = 2;
  if (!is_there(cards, words, kFirst, "a name")) return false;
  const int32_t first = words.word[kFirst].column - 1;
  int32_t end = before_comment(words.text, cards.length);
  while (is_blank_or_tab(words.text[end - 1])) --end;
  const char* fault = nullptr;
  if (end - first > kLongestName) {
    fault = kNameTooLong;
  } else {
    int32_t used = 0;
    for (int32_t at = first; at < end; ++at) name[used++] = words.text[at] == '\t' ? ' ' : words.text[at];
    name[used] = '\0';
    fault = fault_of_name(name);
  }
  if (fault == nullptr) return true;
  put_all(begin_fault(cards, first + 1, end), "the name ", fault);
  end_fault(cards);
  return false;
}

} // namespace

void read_name(Deck& deck, const Words& keyword_card) {
  Cards& cards = deck.cards;
  int32_t i = 0;
  const bool zone = word_is(keyword_card, 0, "ZONE");
  if (!zone && !word_is(keyword_card, 0, "BODY"))
    return void(word_fault(cards, keyword_card, 0, "expected BODY or ZONE, its number and its name"));
  if (zone && deck.sizes.zones == 0)
    return void(word_fault(cards, keyword_card, 1, "no contact zone is defined yet, expected *NAME ZONE after the zones"));
  char name[kLongestName + 1];
  const bool known = zone ? integer_word(cards, keyword_card, 1, "contact zone", 1, deck.sizes.zones, &i)
                          : integer_word(cards, keyword_card, 1, "body number", 1, deck.sizes.bodies + deck.sizes.platens, &i);
  if (!known || !read_text(cards, keyword_card, name)) return;
  if (i <= NumbersSeen::kNoted / 2 && deck.names.again(2 * i - (zone ? 0 : 1)))
    return void(word_fault(cards, keyword_card, 1, zone ? "zone " : "body ", i, " has two names, expected one"));
  if (deck.sink == nullptr) return;
  place_words(deck, keyword_card);
  accept(deck, deck.sink->set_name(deck.sink->solver, zone ? C2D_NAME_ZONE : C2D_NAME_BODY, i, name));
}

} // namespace c2d
