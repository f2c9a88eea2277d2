#pragma once
// Cards one after another, their fields, and the faults found in them.
#include "contact2d_cards.h"
#include "deck/words.hpp"
#include "memory/text.hpp"

namespace c2d {

constexpr int32_t kCardColumns = 80;
constexpr int32_t kPadded = kCardColumns + 8; // beyond all fields of the fixed form
constexpr int32_t kMaximumFaults = 100;       // after that many the reading ends

// Which cards with a C in column 1 are comments among those of the free form.
enum class CComment : int32_t {
  none,      // in a deck of the free form
  any,       // behind the load cards of a fixed one, which may end in remarks
  with_blank // below a keyword in it: the C stands alone
};

// Only the first 80 columns of a line are the card; what stands further right is ignored, as a card reader
// would. The buffer is wider so that carriage returns and stray bytes just behind the card are still seen, and for the free
// form.
struct Cards {
  c2d_read_line read;
  void* context;
  c2d_report report; // every fault goes here; may be null
  void* report_context;
  c2d_status status;    // why the reading ended early; C2D_OK if only faults were found
  int32_t line;         // of the current card, from 1
  int32_t faults;       // so far
  int32_t body, zone;   // body and zone being read, for c2d_error; 0: neither
  bool ended;           // nothing more can be read
  bool refused;         // the current card is refused as a whole (tab, missing field): no faults of its fields
  bool is_node_section; // node cards: a C in column 1 may be meant as a coordinate letter
  bool vital;           // without the current field the rest of the deck cannot be read
  bool counting;        // the current cards give numbers of following cards: a fault ends the reading ...
  bool miscounted;      // ... and one has ended it
  bool free_form;       // the fields of the current card are separated by blanks or commas
  bool is_heading;      // but it is used as it stands
  bool in_extensions;   // after the load cards
  CComment c_comment;   // for cards of the free form
  bool reread;          // the current card was read ahead: next_free_card returns it again
  int32_t length;       // columns of the line, including trailing blanks
  int32_t taken;        // fields of `words` read so far
  c2d_error entry;      // fault under construction
  Text text_of_entry;
  c2d_card_fn card; // receives every field; may be null
  void* card_context;
  char text[kFreeColumns + 8]; // the card, with blanks up to kPadded
  Words words;                 // of a card of the free form
  Word place[kMaximumWords];   // the columns of the fixed form that each of the words taken stands for
};

void start_cards(Cards& cards, c2d_read_line read, void* context, c2d_report report, void* report_context);

// The next card as it stands, comments included (heading cards). False: the deck has ended or reading must stop, which has
// been reported; `what` names what is missing, as in "the number of bodies".
bool next_heading(Cards& cards, const char* what);
// Has a card of the free form a list of any length, of which next_words gives the fields after the first?
enum class FieldList : int32_t { none, allowed };
// The next card that is not a comment; in the free form it is split into cards.words.
bool next_card(Cards& cards, const char* what, FieldList list = FieldList::none);
// The next free-form card, split; lines without fields are skipped. The deck may end here: then
// false without a fault.
bool next_free_card(Cards& cards, Words& words, FieldList list = FieldList::none);
// The next fields of the same card in the place of those in `words`. False: there are none.
bool next_words(Cards& cards, Words& words);
// Makes the next read return the current card again.
void reread_card(Cards& cards);

// Reports a tab and refuses the current card, unless it is free-form; next_card does this itself.
void refuse_tabs(Cards& cards);

// Fields of the current card, named by their columns in the fixed form, and requested in the order in which
// they stand on the card: in the free form each takes the next word. False: a fault was reported (or the
// card had been refused), *value is unchanged. `name` is the quantity in words, as in "number of elements".
bool integer(Cards& cards, int32_t column, int32_t width, const char* name, int32_t least, int32_t most, int32_t* value);
// Of five columns (format I5): any number; one of at least `least`.
bool any_integer(Cards& cards, int32_t column, const char* name, int32_t* value);
bool integer_from(Cards& cards, int32_t column, const char* name, int32_t least, int32_t* value);
// An I5 number of following cards: without it the reading ends.
bool count(Cards& cards, int32_t column, const char* name, int32_t least, int32_t* value);
// An F10.0 field of at most 1e100 in size, so that sums and differences of card values cannot overflow.
bool real(Cards& cards, int32_t column, const char* name, double* value);
// Number of words of a free-form card that are not read yet.
int32_t words_left(const Cards& cards);
// Assigns the next word to the field with these columns; returns its number, from 0. There may be no such word.
int32_t take_word(Cards& cards, int32_t column, int32_t width);
// Tests a field for an integer without reporting a fault.
bool peek_integer(Cards& cards, int32_t column, int32_t width, int32_t* value);
// Reports that field i is missing because the card ends too early, once per card.
bool is_there(Cards& cards, const Words& words, int32_t i, const char* name);
// Passes a field of `length` characters to cards.card.
void tell_field(Cards& cards, int32_t kind, int32_t column, int32_t width, const char* text, int32_t length, double value);

// Columns between two fields: text there is a number outside its columns.
void unused_column(Cards& cards, int32_t column);
// Columns `column` to 72 may contain a remark in words, but no number.
void end_of_fields(Cards& cards, int32_t column);

// Field i (from 0) of a free-form card, as above.
bool integer_word(Cards& cards, const Words& words, int32_t i, const char* name, int32_t least, int32_t most, int32_t* value);
bool real_word(Cards& cards, const Words& words, int32_t i, const char* name, double* value);
// A text of at most size - 1 characters, as it stands on the card.
bool text_word(Cards& cards, const Words& words, int32_t i, const char* name, char* value, int32_t size);
// The card has no more fields than `count`.
bool end_of_words(Cards& cards, const Words& words, int32_t count);

// Report a fault in columns column ... column_end (0: the whole card): begin, append its text with put(), end.
Text& begin_fault(Cards& cards, int32_t column, int32_t column_end);
void end_fault(Cards& cards);
template <class... Parts> C2D_IN_PLACE inline void fault(Cards& cards, int32_t column, int32_t column_end, Parts... parts) {
  put_all(begin_fault(cards, column, column_end), parts...);
  end_fault(cards);
}

// The same for the field, or fields, with these columns in the fixed form.
Word columns_of(const Cards& cards, int32_t column, int32_t column_end);
Text& begin_field_fault(Cards& cards, int32_t column, int32_t column_end);
template <class... Parts>
C2D_IN_PLACE inline void field_fault(Cards& cards, int32_t column, int32_t column_end, Parts... parts) {
  put_all(begin_field_fault(cards, column, column_end), parts...);
  end_fault(cards);
}
// The same for field i of a free-form card; if absent, at its expected position.
Text& begin_word_fault(Cards& cards, const Words& words, int32_t i);
template <class... Parts> C2D_IN_PLACE inline void word_fault(Cards& cards, const Words& words, int32_t i, Parts... parts) {
  put_all(begin_word_fault(cards, words, i), parts...);
  end_fault(cards);
}

} // namespace c2d
