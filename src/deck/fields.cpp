// Fields of cards: numbers in the columns of the format, and their faults.
#include "deck/cards.hpp"

#include "deck/number.hpp"
#include "memory/characters.hpp"
#include "memory/hostile.hpp"

namespace c2d {
namespace {

constexpr double kLargest = 1e100;

// The text of a field without outer blanks, in quotes. It is not blank: a blank field is a valid 0.
void put_field(Text& text, const char* field, int32_t width) {
  while (field[width - 1] == ' ') --width;
  while (field[0] == ' ') {
    ++field;
    --width;
  }
  put_character(text, '\'');
  put(text, field, static_cast<size_t>(width));
  put_character(text, '\'');
}

void malformed_field(Cards& cards, int32_t column, int32_t width, const char* expected, const char* name) {
  const int32_t column_end = column + width - 1;
  Text& text = begin_fault(cards, column, column_end);
  put_all(text, width == 1 ? "column " : "columns ", column);
  if (width > 1) {
    put_character(text, '-');
    put(text, column_end);
  }
  put(text, width == 1 ? " contains " : " contain ");
  put_field(text, cards.text + column - 1, width);
  put_all(text, ", expected ", expected, ": ", name);
  end_fault(cards);
}

// An integer in these columns, with blanks around it; width 0: an empty field.
bool integer_at(Cards& cards, int32_t column, int32_t width, const char* name, int32_t least, int32_t most, int32_t* value) {
  int32_t found;
  const FieldFault why = integer_field(cards.text + column - 1, width, &found);
  if (why != FieldFault::none) {
    malformed_field(cards, column, width, expectation(why, true), name);
    return false;
  }
  if (found >= least && found <= most) {
    *value = found;
    return true;
  }
  const int32_t column_end = width > 0 ? column + width - 1 : column;
  if (most == INT32_MAX)
    fault(cards, column, column_end, name, " is ", found, ", expected at least ", least);
  else if (least == most)
    fault(cards, column, column_end, name, " is ", found, ", expected ", least);
  else
    fault(cards, column, column_end, name, " is ", found, ", expected ", least, " to ", most);
  return false;
}

bool real_at(Cards& cards, int32_t column, int32_t width, const char* name, double* value) {
  double found;
  FieldFault why = real_field(cards.text + column - 1, width, &found);
  if (why == FieldFault::none && !(found <= kLargest && found >= -kLargest)) why = FieldFault::too_large;
  if (why != FieldFault::none) {
    malformed_field(cards, column, width, expectation(why, false), name);
    return false;
  }
  *value = found;
  return true;
}

int32_t width_of(const Word& word) { return word.column_end - word.column + 1; }

// Position on the current card of the field with these columns in the fixed form.
bool find_field(Cards& cards, int32_t column, int32_t width, const char* name, Word& at) {
  at = {static_cast<int16_t>(column), static_cast<int16_t>(column + width - 1)};
  if (!cards.free_form) return true;
  const int32_t i = take_word(cards, column, width);
  if (!is_there(cards, cards.words, i, name)) return false;
  at = cards.words.word[i];
  return true;
}

} // namespace

void tell_field(Cards& cards, int32_t kind, int32_t column, int32_t width, const char* text, int32_t length, double value) {
  if (cards.card == nullptr) return;
  c2d_card item = c2d_card();
  item.struct_size = static_cast<uint32_t>(sizeof item);
  item.kind = kind;
  item.line = cards.line;
  item.column = column;
  item.width = width;
  item.value = value;
  while (length > 0 && (text[length - 1] == ' ' || text[length - 1] == '\t')) --length;
  while (kind != C2D_CARD_HEADING && kind != C2D_CARD_EXTENSION && length > 0 && text[0] == ' ') {
    ++text;
    --length;
  }
  item.text = text;
  item.length = length > 0 ? length : 0;
  cards.card(cards.card_context, &item);
}

bool is_there(Cards& cards, const Words& words, int32_t i, const char* name) {
  if (i < words.count) return true;
  if (cards.refused) return false;
  word_fault(cards, words, i, "the card ends here, expected ", name);
  cards.refused = true;
  return false;
}

int32_t words_left(const Cards& cards) { return cards.words.count - cards.taken; }

int32_t take_word(Cards& cards, int32_t column, int32_t width) {
  if (C2D_NEVER(cards.taken >= kMaximumWords)) return kMaximumWords; // no card has that many fields
  Word& place = cards.place[cards.taken];
  place.column = static_cast<int16_t>(column);
  place.column_end = static_cast<int16_t>(column + width - 1);
  return cards.taken++;
}

Word columns_of(const Cards& cards, int32_t column, int32_t column_end) {
  Word found = {static_cast<int16_t>(column), static_cast<int16_t>(column_end)};
  if (!cards.free_form) return found;
  found.column = found.column_end = 0;
  for (int32_t i = 0; i < cards.taken && i < cards.words.count; ++i) {
    const Word& place = cards.place[i];
    const Word& word = cards.words.word[i];
    if (place.column > column_end || place.column_end < column) continue;
    const bool is_same = place.column == column && place.column_end == column_end;
    if (found.column == 0 || is_same) found.column = word.column;
    found.column_end = word.column_end < word.column ? word.column : word.column_end;
  }
  return found;
}

bool peek_integer(Cards& cards, int32_t column, int32_t width, int32_t* value) {
  if (!cards.free_form) return integer_field(cards.text + column - 1, width, value) == FieldFault::none;
  if (words_left(cards) <= 0) return false;
  const Word& word = cards.words.word[cards.taken];
  return integer_field(cards.text + word.column - 1, width_of(word), value) == FieldFault::none;
}

bool integer(Cards& cards, int32_t column, int32_t width, const char* name, int32_t least, int32_t most, int32_t* value) {
  if (cards.refused) return false;
  Word at;
  if (!find_field(cards, column, width, name, at) || !integer_at(cards, at.column, width_of(at), name, least, most, value))
    return false;
  tell_field(cards, C2D_CARD_INTEGER, column, width, cards.text + at.column - 1, width_of(at), *value);
  return true;
}

bool any_integer(Cards& cards, int32_t column, const char* name, int32_t* value) {
  return integer(cards, column, 5, name, INT32_MIN, INT32_MAX, value);
}

bool integer_from(Cards& cards, int32_t column, const char* name, int32_t least, int32_t* value) {
  return integer(cards, column, 5, name, least, INT32_MAX, value);
}

bool count(Cards& cards, int32_t column, const char* name, int32_t least, int32_t* value) {
  cards.vital = true;
  const bool found = integer_from(cards, column, name, least, value);
  cards.vital = false;
  if (!found) cards.ended = true;
  return found;
}

bool real(Cards& cards, int32_t column, const char* name, double* value) {
  constexpr int32_t kWidth = 10;
  if (cards.refused) return false;
  Word at;
  if (!find_field(cards, column, kWidth, name, at) || !real_at(cards, at.column, width_of(at), name, value)) return false;
  tell_field(cards, C2D_CARD_REAL, column, kWidth, cards.text + at.column - 1, width_of(at), *value);
  return true;
}

void unused_column(Cards& cards, int32_t column) {
  if (cards.refused || cards.free_form || cards.text[column - 1] == ' ') return;
  malformed_field(cards, column, 1, "a blank", "this column is outside all fields");
}

void end_of_fields(Cards& cards, int32_t column) {
  constexpr int32_t kLastColumn = 72; // columns after it contain sequence numbers
  if (cards.refused) return;
  if (cards.free_form) {
    end_of_words(cards, cards.words, cards.taken);
    return;
  }
  if (column <= kLastColumn)
    tell_field(cards, C2D_CARD_REMARK, column, 0, cards.text + column - 1, kLastColumn - column + 1, 0);
  int32_t first = column;
  while (first <= kLastColumn && cards.text[first - 1] == ' ') ++first;
  if (first > kLastColumn || !one_of(cards.text[first - 1], "+-.0123456789")) return;
  int32_t last = first;
  while (last < kLastColumn && cards.text[last] != ' ') ++last;
  malformed_field(cards, first, last - first + 1, "blanks", "these columns are outside all fields");
}

bool integer_word(Cards& cards, const Words& words, int32_t i, const char* name, int32_t least, int32_t most, int32_t* value) {
  if (!is_there(cards, words, i, name)) return false;
  return integer_at(cards, words.word[i].column, width_of(words.word[i]), name, least, most, value);
}

bool real_word(Cards& cards, const Words& words, int32_t i, const char* name, double* value) {
  if (!is_there(cards, words, i, name)) return false;
  return real_at(cards, words.word[i].column, width_of(words.word[i]), name, value);
}

bool text_word(Cards& cards, const Words& words, int32_t i, const char* name, char* value, int32_t size) {
  if (!is_there(cards, words, i, name)) return false;
  const int32_t width = width_of(words.word[i]);
  if (width >= size) {
    word_fault(cards, words, i, name, " has ", width, " characters, expected at most ", size - 1);
    return false;
  }
  copy_word(words, i, value, size);
  return true;
}

bool end_of_words(Cards& cards, const Words& words, int32_t count) {
  if (words.count <= count) return true;
  Text& text = begin_word_fault(cards, words, count);
  const int32_t column_end = words.word[words.count - 1].column_end;
  if (column_end > cards.entry.column_end) cards.entry.column_end = column_end;
  put_all(text, "the card has ", words.count, words.count == 1 ? " field, expected " : " fields, expected ", count);
  end_fault(cards);
  return false;
}

Text& begin_field_fault(Cards& cards, int32_t column, int32_t column_end) {
  const Word found = columns_of(cards, column, column_end);
  return begin_fault(cards, found.column, found.column_end);
}

Text& begin_word_fault(Cards& cards, const Words& words, int32_t i) {
  const bool is_there = i < words.count;
  const int32_t column = is_there ? words.word[i].column : words.end;
  const int32_t column_end = is_there ? words.word[i].column_end : column;
  return begin_fault(cards, column, column_end > column ? column_end : column);
}

} // namespace c2d
