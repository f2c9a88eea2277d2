#include "deck/keywords.hpp"

#include "memory/characters.hpp"
#include "memory/hostile.hpp"
#include "memory/parts.hpp"

namespace c2d {
namespace {

struct Keyword {
  const char* name; // capitals, without the star; at most one blank inside
  KeywordHandler read;
  bool repeats; // may appear more than once in a deck
  // The call that links the part of the library that the keyword needs, null: none; is it linked?
  const char* call = nullptr;
  bool (*has_part)(const DeckSink& sink) = nullptr;
};

// New keywords are added here. Keywords may come in any order, so a handler that needs data of another
// must work in either order. Keywords and their source files:
//   *UNITS length force      units.cpp      names of the units, for axis titles
//   *CASES n                 history.cpp    further load cases
//   *PATH                    history.cpp    path segments by their load factors, instead of the load cards
//   *FRICTION                history.cpp    coefficients by zone
//   *SYMMETRY X value        symmetry.cpp   line of symmetry x = value (Y: y = value)
//   *ZONE e1 e1 e2 e2 ...    free_zones.cpp contact between elements of two bodies with independent meshes
//   *TIE zone                tie.cpp        a zone is bonded
//   *PLATEN body e e x y     platen.cpp     elements move as one rigid body, with motions and loads by load case
//   *NAME BODY body text     names.cpp      name of a body (ZONE: of a zone)
//   *CURVE kind body e e     curves.cpp     given surface over elements of a body
//   *RIGID LOAD body x y ... rigid.cpp      free motions of a rigid body, with forces and a moment by load case
//   *RIGID [body]            rigid.cpp      a rigid body, with prescribed motions by load case
//   *INTERFERENCE load_case  interference.cpp   initial overlaps are removed by a load case
//   *BODY FORCE ...          body_force.cpp weight and rotation of a body in a load case
//   *POINTS                  points.cpp     points for interior results
constexpr Keyword kKeywords[] = {
    {"UNITS", read_units, false},
    {"CASES", read_cases, false},
    {"PATH", read_path, false},
    {"FRICTION", read_friction, false},
    {"SYMMETRY", read_symmetry, true, "c2d_set_symmetry", [](const DeckSink& sink) { return sink.set_symmetry != nullptr; }},
    {"BODY FORCE", read_body_force, true, "c2d_set_body_force",
     [](const DeckSink& sink) { return sink.set_body_force != nullptr; }},
    {"INTERFERENCE", read_interference, false},
    {"RIGID LOAD", read_rigid_load, true, "c2d_set_rigid", [](const DeckSink& sink) { return sink.set_rigid != nullptr; }},
    {"RIGID", read_rigid, true, "c2d_set_rigid", [](const DeckSink& sink) { return sink.set_rigid != nullptr; }},
    {"ZONE", read_free_zone, true, "c2d_link_free_zones", [](const DeckSink& sink) { return sink.has_free_zones; }},
    {"PLATEN", read_platen, true, "c2d_set_rigid", [](const DeckSink& sink) { return sink.add_platen != nullptr; }},
    {"TIE", read_tie, true},
    {"NAME", read_name, true},
    {"POINTS", read_points, true},
    {"CURVE", read_curve, true},
};
constexpr int32_t kKeywordCount = static_cast<int32_t>(sizeof kKeywords / sizeof kKeywords[0]);
static_assert(kKeywordCount <= 32, "Deck::keywords_seen has a bit for each");

constexpr int32_t kMaximumName = 24;

bool is_keyword_card(const Words& words) {
  if (words.count == 0) return false; // nothing but `&`
  return words.text[words.word[0].column - 1] == '*';
}

// The first `count` fields, in capitals, without the star, one blank between them.
void join_name(const Words& words, int32_t count, char (&name)[kMaximumName]) {
  int32_t used = 0;
  for (int32_t i = 0; i < count && i < words.count; ++i) {
    if (i > 0 && used < kMaximumName - 1) name[used++] = ' ';
    int32_t at = words.word[i].column - (i == 0 ? 0 : 1);
    for (; at < words.word[i].column_end && used < kMaximumName - 1; ++at) name[used++] = capital(words.text[at]);
  }
  name[used] = '\0';
}

int32_t words_in(const char* name) { return name[place_of(' ', name, text_length(name))] == ' ' ? 2 : 1; }

int32_t least_of(int32_t a, int32_t b) { return a < b ? a : b; }

// Edit distance (Levenshtein) of two names: insertions, deletions and changes of letters.
int32_t edit_distance(const char* a, const char* b) {
  int32_t row[kMaximumName];
  const int32_t length = text_length(b);
  for (int32_t j = 0; j <= length; ++j) row[j] = j;
  for (int32_t i = 0; a[i] != '\0'; ++i) {
    int32_t diagonal = row[0];
    row[0] = i + 1;
    for (int32_t j = 0; j < length; ++j) {
      const int32_t above = row[j + 1];
      row[j + 1] = least_of(least_of(above, row[j]) + 1, diagonal + (a[i] == b[j] ? 0 : 1));
      diagonal = above;
    }
  }
  return row[length];
}

// The known keyword nearest to the first words of the card; null if none is near.
const char* nearest(const Words& words) {
  const char* found = nullptr;
  int32_t least = kMaximumName;
  for (const Keyword& keyword : kKeywords) {
    char name[kMaximumName];
    join_name(words, words_in(keyword.name), name);
    int32_t distance = edit_distance(name, keyword.name);
    join_name(words, 1, name); // two words written as one
    distance = least_of(distance, edit_distance(name, keyword.name));
    if (distance >= least || 2 * distance > text_length(keyword.name)) continue;
    least = distance;
    found = keyword.name;
  }
  return found;
}

void unknown_keyword(Cards& cards, const Words& words) {
  char name[kMaximumName];
  join_name(words, 1, name);
  const char* near = nearest(words);
  Text& text = begin_word_fault(cards, words, 0);
  put_character(text, '*');
  put_all(text, name, " is not a known keyword; ", near != nullptr ? "did you mean *" : "known are *");
  if (near != nullptr) {
    put(text, near);
    put_character(text, '?');
  } else {
    for (int32_t i = 0; i < kKeywordCount; ++i) {
      if (i > 0) put(text, ", *");
      put(text, kKeywords[i].name);
    }
  }
  end_fault(cards);
}

int32_t find_keyword(const Words& words) {
  for (int32_t i = 0; i < kKeywordCount; ++i) {
    char name[kMaximumName];
    join_name(words, words_in(kKeywords[i].name), name);
    if (same_text(name, kKeywords[i].name)) return i;
  }
  return -1;
}

void drop_words(Words& words, int32_t count) {
  words.count -= count;
  for (int32_t i = 0; i < words.count; ++i) words.word[i] = words.word[i + count];
}

// Cards that the handler did not read; reported unless the keyword has faults already.
void leave_cards(Deck& deck, const char* name, bool reported) {
  Words words;
  for (; next_data_card(deck, words); reported = true)
    if (!reported)
      fault(deck.cards, 0, 0, "the card does not belong to *", name,
            " above it, expected a keyword card or the end of the deck");
}

void read_keyword(Deck& deck, Words& words) {
  Cards& cards = deck.cards;
  const int32_t found = find_keyword(words);
  if (found < 0) {
    unknown_keyword(cards, words);
    leave_cards(deck, "", true);
    return;
  }
  const Keyword& keyword = kKeywords[found];
  const uint32_t bit = uint32_t{1} << found;
  if ((deck.keywords_seen & bit) != 0 && !keyword.repeats) {
    word_fault(cards, words, 0, "*", keyword.name, " appears twice in the deck, expected it once");
    leave_cards(deck, keyword.name, true);
    return;
  }
  deck.keywords_seen |= bit;
  if (deck.sink != nullptr && keyword.call != nullptr && !keyword.has_part(*deck.sink)) {
    word_fault(cards, words, 0, "*", keyword.name, kNeedsPart, keyword.call, " links it");
    leave_cards(deck, keyword.name, true);
    return;
  }
  const int32_t old_faults = cards.faults;
  drop_words(words, words_in(keyword.name));
  keyword.read(deck, words);
  leave_cards(deck, keyword.name, cards.faults > old_faults);
}

} // namespace

bool next_data_card(Deck& deck, Words& words, FieldList list) {
  if (!next_free_card(deck.cards, words, list)) return false;
  if (!is_keyword_card(words)) return true;
  reread_card(deck.cards);
  return false;
}

void read_extensions(Deck& deck) {
  Cards& cards = deck.cards;
  if (!cards.free_form) cards.c_comment = CComment::any;
  Words words;
  cards.in_extensions = true;
  cards.body = cards.zone = 0;
  while (next_free_card(cards, words)) {
    if (!is_keyword_card(words)) {
      fault(cards, 0, 0, "a card follows the last load card, expected a keyword card or the end of the deck");
      return;
    }
    if (cards.c_comment == CComment::any) cards.c_comment = CComment::with_blank;
    read_keyword(deck, words);
  }
}

} // namespace c2d
