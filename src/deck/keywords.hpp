#pragma once
// Extension cards, after the last load card; each part begins with a keyword card `*NAME fields`. They
// are always free-form, in a deck of either form.
#include "deck/deck.hpp"

namespace c2d {

// Reads the fields of the keyword card (after the name, from 0) and, with next_data_card, the cards
// below it. Report faults with integer_word, real_word, word_fault ... and continue; pass valid data to
// deck.sink unless that is null (then only count into deck.sizes and check). Cards of the keyword that the
// handler does not read are a fault. `keyword_card` is invalid once the next card has been read.
using KeywordHandler = void (*)(Deck& deck, const Words& keyword_card);

// The next card below the current keyword; false at the next keyword and at the end of the deck.
bool next_data_card(Deck& deck, Words& words, FieldList list = FieldList::none);

// Counts a zone of this kind with so many elements: its sizes, as far as the deck determines which elements face each other.
void count_zone(Deck& deck, int32_t elements, int32_t kind); // free_zones.cpp

// One handler per keyword; the table is in keywords.cpp, the handlers in files named after their keywords.
void read_units(Deck& deck, const Words& keyword_card);     // units.cpp
void read_cases(Deck& deck, const Words& keyword_card);     // history.cpp
void read_path(Deck& deck, const Words& keyword_card);      //
void read_friction(Deck& deck, const Words& keyword_card);  //
void read_free_zone(Deck& deck, const Words& keyword_card); // free_zones.cpp
void read_rigid_load(Deck& deck, const Words& keyword_card);
void read_platen(Deck& deck, const Words& keyword_card); // platen.cpp
void read_tie(Deck& deck, const Words& keyword_card);
void read_name(Deck& deck, const Words& keyword_card);         // names.cpp
void read_curve(Deck& deck, const Words& keyword_card);        // curves.cpp
void read_symmetry(Deck& deck, const Words& keyword_card);     // symmetry.cpp
void read_rigid(Deck& deck, const Words& keyword_card);        // rigid.cpp
void read_interference(Deck& deck, const Words& keyword_card); // interference.cpp
void read_body_force(Deck& deck, const Words& keyword_card);   // body_force.cpp
void read_points(Deck& deck, const Words& keyword_card);       // points.cpp

} // namespace c2d
