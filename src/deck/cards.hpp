#pragma once
// Cards one after another, their fields, and the faults found in them.
#include "contact2d_cards.h"
#include "deck/words.hpp"
#include "memory/text.hpp"

namespace c2d {

constexpr int32_t kCardColumns = 80;
constexpr int32_t kMaximumFaults = 100; // after that many the reading ends

// Which cards with a C in column 1 are comments among those of the free form.
enum class CComment : int32_t {
  none,      // in a deck of the free form
  any,       // behind the load cards of a fixed one, which may end in remarks
  with_blank // below a keyword in it: the C stands alone
};

// Only the first 80 columns of a line are the card; what stands further right is ignored, as a card reader
// would. The buffer is wider so that carriage returns and stray bytes just behind the card are still seen.
struct Cards {
  c2d_read_line read;
  void* context;
  c2d_report report; // every fault goes here; may be null
  void* report_context;
  c2d_status status;  // why the reading ended early; C2D_OK after faults alone
  int32_t line;       // of the card at hand, from 1
  int32_t faults;     // so far
  int32_t body, zone; // what is being read, for c2d_error; 0: neither
  bool ended;         // nothing more can be read
  bool refused;       // the card at hand as a whole, for a tab or a missing field: no faults in its fields
  bool holds_nodes;   // node cards: a C in column 1 may be meant as a coordinate letter
  bool vital;         // without the field at hand the rest of the deck cannot be read
  bool counting;      // nor without the cards at hand, which say how many of which will follow: a fault ends the reading ...
  bool miscounted;    // ... as it has
  bool free_form;     // the card at hand has fields between blanks or commas
  bool is_heading;    // and yet is taken as it stands
  bool in_extensions; // the load cards are done
  CComment c_comment; // for cards of the free form
  bool held;          // it has been read ahead: next_free_card gives it once more
  int32_t length;     // columns of the line, blanks behind it included
  int32_t taken;      // fields of `words` read so far
  c2d_error entry;    // being put together
  Text text_of_entry;
  c2d_card_fn card; // is told every field; may be null
  void* card_context;
  char text[168];            // the card, blank-padded
  Words words;               // of a card of the free form
  Word place[kMaximumWords]; // the columns of the fixed form that each of the words taken stands for
};

void start_cards(Cards& cards, c2d_read_line read, void* context, c2d_report report, void* report_context);

// The next card as it stands, comments included (heading cards). False: the deck has ended or must not be read on, and this has
// been reported; `what` names the card that is missing, as in "the card with the number of bodies".
bool next_heading(Cards& cards, const char* what);
// The next card that is not a comment; of the free form it is split into cards.words.
bool next_card(Cards& cards, const char* what);
// The next card of the free form, split; lines without a field are passed over. The deck may end here: then
// false without a fault.
bool next_free_card(Cards& cards, Words& words);
// The card at hand is to be read once more.
void hold_card(Cards& cards);

// Report a tab and refuse the card at hand, unless it is of the free form; next_card does this itself.
void refuse_tabs(Cards& cards);

// Fields of the card at hand, named by their columns in the fixed form, and asked for in the order in which
// they stand on the card: of the free form, each takes the next word. False: a fault was reported (or the
// card had been refused), *value is unchanged. `name` is the quantity in words, as in "number of elements".
bool integer(Cards& cards, int32_t column, int32_t width, const char* name, int32_t least, int32_t most, int32_t* value);
// Of five columns (format I5): any number; one of at least `least`.
bool any_integer(Cards& cards, int32_t column, const char* name, int32_t* value);
bool integer_from(Cards& cards, int32_t column, const char* name, int32_t least, int32_t* value);
// An I5 number that says how many cards follow: without it the reading ends.
bool count(Cards& cards, int32_t column, const char* name, int32_t least, int32_t* value);
// An F10.0 field of at most 1e100 in size, so that sums and differences of card values cannot overflow.
bool real(Cards& cards, int32_t column, const char* name, double* value);
// How many words of a free-form card have not been taken.
int32_t words_left(const Cards& cards);
// The next word stands for the field in these columns; its number, from 0. There may be no such word.
int32_t take_word(Cards& cards, int32_t column, int32_t width);
// An integer field looked at without a fault: false if it holds none.
bool peek_integer(Cards& cards, int32_t column, int32_t width, int32_t* value);
// The same one is not there, in a word: the card ends too early, which is told once.
bool is_there(Cards& cards, const Words& words, int32_t i, const char* name);
// Tell cards.card of a field of `length` characters.
void tell_field(Cards& cards, int32_t kind, int32_t column, int32_t width, const char* text, int32_t length, double value);

// Columns that no field uses, between two fields: text there is a number out of its columns.
void unused_column(Cards& cards, int32_t column);
// No number may stand in columns `column` to 72; a remark in words may.
void end_of_fields(Cards& cards, int32_t column);

// Field i (from 0) of a free-form card, as above.
bool integer_word(Cards& cards, const Words& words, int32_t i, const char* name, int32_t least, int32_t most, int32_t* value);
bool real_word(Cards& cards, const Words& words, int32_t i, const char* name, double* value);
// A text of at most size - 1 characters, as it stands on the card.
bool text_word(Cards& cards, const Words& words, int32_t i, const char* name, char* value, int32_t size);
// The card has no more fields than `count`.
bool end_of_words(Cards& cards, const Words& words, int32_t count);

// Report a fault in columns column ... column_end (0: the card as a whole): begin, put() its text together, end.
Text& begin_fault(Cards& cards, int32_t column, int32_t column_end);
void end_fault(Cards& cards);
template <class... Parts> C2D_IN_PLACE inline void fault(Cards& cards, int32_t column, int32_t column_end, Parts... parts) {
  put_all(begin_fault(cards, column, column_end), parts...);
  end_fault(cards);
}

// The same in the field, or the fields, that stand in these columns in the fixed form.
Word columns_of(const Cards& cards, int32_t column, int32_t column_end);
Text& begin_field_fault(Cards& cards, int32_t column, int32_t column_end);
template <class... Parts>
C2D_IN_PLACE inline void field_fault(Cards& cards, int32_t column, int32_t column_end, Parts... parts) {
  put_all(begin_field_fault(cards, column, column_end), parts...);
  end_fault(cards);
}
// The same in field i of a free-form card; without such a field, where it would stand.
Text& begin_word_fault(Cards& cards, const Words& words, int32_t i);
template <class... Parts> C2D_IN_PLACE inline void word_fault(Cards& cards, const Words& words, int32_t i, Parts... parts) {
  put_all(begin_word_fault(cards, words, i), parts...);
  end_fault(cards);
}

} // namespace c2d
