#include "deck/cards.hpp"

#include "deck/number.hpp"
#include "memory/characters.hpp"
#include "memory/hostile.hpp"

#include <string.h>

namespace c2d {
namespace {

constexpr char kDosEnd = 0x1a; // ends text files of old systems

// Bytes of the line as read, without its line end; -1 at the end of the deck and after a failure.
int32_t fetch(Cards& cards) {
  const int32_t size = static_cast<int32_t>(sizeof cards.text);
  const int32_t length = cards.read(cards.context, cards.text, size);
  if (length < -1) {
    put(begin_fault(cards, 0, 0), "the next card could not be read");
    cards.entry.status = C2D_ERR_READ;
    cards.entry.host_code = length;
    end_fault(cards);
    cards.status = C2D_ERR_READ;
  }
  if (length < 0) return -1;
  int32_t used = length < size ? length : size - 1;
  while (used > 0 && (cards.text[used - 1] == '\r' || cards.text[used - 1] == '\n')) --used;
  if (used == 1 && cards.text[0] == kDosEnd) return -1;
  if (!C2D_NEVER(cards.line == INT32_MAX)) ++cards.line; // no test reads that many lines
  return used;
}

// Comments of the free form may use any script. When the first card is read the form is not yet known.
bool may_hold_remark(const Cards& cards, int32_t used) {
  if (!cards.is_heading) return cards.free_form;
  if (cards.line != 1) return false;
  int32_t first = 0;
  while (first < used && cards.text[first] == ' ') ++first;
  return first < used && cards.text[first] == '*';
}

// Names may use any script; their keyword checks them.
bool may_hold_name(const Cards& cards, int32_t used) {
  Words words;
  if (!cards.in_extensions) return false;
  split_words(cards.text, used, words);
  return word_is(words, 0, "*NAME");
}

// A card has printable ASCII and tabs only. The first fault ends the reading: a binary file would give thousands.
bool is_text(Cards& cards, int32_t used) {
  if (may_hold_remark(cards, used)) used = before_comment(cards.text, used);
  for (int32_t i = 0; i < used; ++i) {
    const unsigned char byte = static_cast<unsigned char>(cards.text[i]);
    if ((byte >= 0x20 && byte < 0x7f) || byte == '\t') continue;
    if (byte >= 0x80 && may_hold_name(cards, used)) continue;
    const bool mark = cards.line == 1 && i == 0 && byte == 0xef;
    fault(cards, i + 1, i + 1, "column ", i + 1, " contains the byte ", static_cast<int32_t>(byte),
          mark ? ", a byte order mark; expected plain ASCII text" : ", expected plain ASCII text");
    return false;
  }
  return true;
}

// The next line, padded with blanks. False: no more.
bool next_line(Cards& cards) {
  if (cards.ended) return false;
  const int32_t used = fetch(cards);
  cards.ended = used < 0 || !is_text(cards, used);
  if (cards.ended) return false;
  if (used < kPadded) memset(cards.text + used, ' ', static_cast<size_t>(kPadded - used));
  cards.refused = false;
  cards.length = used;
  return true;
}

// A C in column 1 begins a comment, unless columns 2-5 contain an integer: then the card looks like a node card.
bool is_comment(Cards& cards) {
  if (cards.text[0] != 'C') return false;
  int32_t number;
  if (is_blank(cards.text + 1, 4) || integer_field(cards.text + 1, 4, &number) != FieldFault::none) return true;
  fault(cards, 1, 1, "column 1 contains 'C' before the number ", number,
        ", expected a coordinate letter, which is blank or P (or a comment without a number in columns 2-5)");
  return !cards.is_node_section;
}

bool is_free_comment(const Cards& cards) {
  if (cards.text[0] != 'C' || cards.c_comment == CComment::none) return false;
  return cards.c_comment == CComment::any || cards.text[1] == ' ';
}

void missing_card(Cards& cards, const char* what) {
  if (cards.faults == 0 && cards.line == 0)
    fault(cards, 0, 0, "the deck is empty");
  else
    fault(cards, 0, 0, "the deck ends here, expected ", what);
}

} // namespace

void start_cards(Cards& cards, c2d_read_line read, void* context, c2d_report report, void* report_context) {
  memset(&cards, 0, sizeof cards);
  cards.read = read;
  cards.context = context;
  cards.report = report;
  cards.report_context = report_context;
}

void refuse_tabs(Cards& cards) {
  const int32_t column = place_of('\t', cards.text, kCardColumns) + 1;
  if (column > kCardColumns) return;
  fault(cards, column, column, "column ", column,
        " contains a tab, expected blanks: fields are in fixed columns, and a tab has no defined width");
  cards.refused = true;
}

bool next_heading(Cards& cards, const char* what) {
  const int32_t faults = cards.faults;
  cards.is_heading = true;
  const bool found = next_line(cards);
  cards.is_heading = false;
  if (!found && cards.faults == faults) missing_card(cards, what);
  return found;
}

namespace {

bool next_fixed_card(Cards& cards) {
  for (;;) {
    if (!next_line(cards)) return false;
    const int32_t old_faults = cards.faults;
    if (!is_comment(cards)) break;
    if (cards.faults == old_faults) tell_field(cards, C2D_CARD_COMMENT, 0, 0, cards.text + 1, cards.length - 1, 0);
  }
  refuse_tabs(cards);
  return !cards.ended;
}

// Comments are passed on before the card on which, or above which, they stand.
void tell_comment(Cards& cards, const Words& words) {
  const bool has_c = is_free_comment(cards);
  if (cards.in_extensions && words.count > 0 && !has_c) return;
  const int32_t first = has_c ? 1 : before_comment(cards.text, cards.length) + 1;
  if (first <= cards.length) tell_field(cards, C2D_CARD_COMMENT, 0, 0, cards.text + first, cards.length - first, 0);
}

} // namespace

bool next_card(Cards& cards, const char* what, FieldList list) {
  const bool was_ended = cards.ended;
  const int32_t old_faults = cards.faults;
  if (cards.free_form ? next_free_card(cards, cards.words, list) : next_fixed_card(cards)) {
    cards.taken = 0;
    if (!cards.free_form || cards.words.count == 0 || cards.text[cards.words.word[0].column - 1] != '*') return true;
    word_fault(cards, cards.words, 0, "found a keyword card, expected ", what);
    cards.ended = true;
    return false;
  }
  if (!was_ended && cards.faults == old_faults) missing_card(cards, what);
  return false;
}

namespace {

// The fields of a line stand within the columns that are read; only a list goes on.
void check_extent(Cards& cards, const Words& words, FieldList list) {
  const int32_t used = words.count > 0 ? words.word[words.count - 1].column_end : 1;
  if (used > kFreeColumns)
    fault(cards, kFreeColumns + 1, used, "the card extends beyond column ", kFreeColumns,
          ", expected all fields within these columns");
  else if (words.is_part && words.count == kMaximumWords && list == FieldList::none)
    fault(cards, 0, 0, "the card has more than ", kMaximumWords, " fields");
  else if (words.is_part && list == FieldList::none)
    fault(cards, words.end, words.end,
          "the card ends in '&', expected that only where a list goes on: load factors below *PATH ",
          "and coefficients of friction");
}

} // namespace

bool next_free_card(Cards& cards, Words& words, FieldList list) {
  cards.free_form = true;
  if (cards.reread) { // its faults have been reported
    cards.reread = false;
    split_words(cards.text, cards.length, words);
    return !cards.ended;
  }
  do {
    if (!next_line(cards)) return false;
    split_words(cards.text, cards.length, words);
    tell_comment(cards, words);
  } while ((words.count == 0 && !words.is_part) || is_free_comment(cards));
  if (cards.in_extensions) tell_field(cards, C2D_CARD_EXTENSION, 0, 0, cards.text, cards.length, 0);
  check_extent(cards, words, list);
  return !cards.ended;
}

bool next_words(Cards& cards, Words& words) {
  while (words.is_part) {
    split_words(cards.text, cards.length, words, words.end - 1);
    if (words.count > 0) {
      check_extent(cards, words, FieldList::allowed);
      return !cards.ended;
    }
    const int32_t faults = cards.faults;
    if (!next_free_card(cards, words, FieldList::allowed)) {
      if (cards.faults == faults) missing_card(cards, "the fields that follow '&'");
      return false;
    }
    if (words.count > 0) return true;
  }
  return false;
}

void reread_card(Cards& cards) { cards.reread = true; }

Text& begin_fault(Cards& cards, int32_t column, int32_t column_end) {
  c2d_error& entry = cards.entry;
  memset(&entry, 0, sizeof entry);
  entry.struct_size = static_cast<uint32_t>(sizeof entry);
  entry.status = C2D_ERR_INPUT;
  entry.severity = C2D_FAULT;
  entry.line = cards.line > 0 ? cards.line : 1;
  entry.column = column;
  entry.column_end = column_end;
  entry.body = cards.body;
  entry.zone = cards.zone;
  return cards.text_of_entry = text_in(entry.text);
}

void end_fault(Cards& cards) {
  if (cards.miscounted) return; // further faults follow from it
  if (cards.vital || cards.counting) put(cards.text_of_entry, "; the rest cannot be read without it");
  if (cards.faults >= kMaximumFaults) {                        // still counted: a deck with faults is not passed on
    if (!C2D_NEVER(cards.faults == INT32_MAX)) ++cards.faults; // nor that many faults
    if (!cards.ended && cards.report != nullptr) {
      cards.text_of_entry = text_in(cards.entry.text);
      put(cards.text_of_entry, "too many faults, the rest of the deck was not read");
      cards.report(cards.report_context, &cards.entry);
    }
    cards.ended = true;
    return;
  }
  ++cards.faults;
  if (cards.report != nullptr) cards.report(cards.report_context, &cards.entry);
  cards.miscounted = cards.counting;
  if (cards.counting) cards.ended = true;
}

} // namespace c2d
