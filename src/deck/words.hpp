#pragma once
// Fields of a free-form card, separated by blanks or commas; `!` begins a comment.
#include "memory/config.hpp"

#include <stdint.h>

namespace c2d {

constexpr int32_t kFreeColumns = kSmallCode ? 160 : 4096; // of a line in the free form; a comment may extend beyond
constexpr int32_t kMaximumWords = 32;                     // that are split at a time

// Columns of a field, from 1. An empty field (a comma that follows no field) has
// column_end < column; as a number it is 0, like a blank field of the fixed form.
struct Word {
  int16_t column, column_end;
};

// Refers to the text of the card, so it is valid until the next card is read.
struct Words {
  const char* text; // of the card, column 1 first
  int32_t count;
  int32_t end;  // the column after the last field
  bool is_part; // more fields follow, on this line or, where it ends in `&`, on the next
  Word word[kMaximumWords];
};

// The first kMaximumWords fields of text[from .. length). Blanks and tabs separate fields, and so does a comma with or
// without blanks around it: `1 2`, `1,2` and `1 , 2` are the same, `1,,2` has an empty field, and a comma after the last
// field is ignored.
void split_words(const char* text, int32_t length, Words& words, int32_t from = 0);

// Columns of text[0 .. length) before the comment: length if there is none.
int32_t before_comment(const char* text, int32_t length);

// Is field i (from 0) this word? `word` is in capitals; the field may be in small letters.
bool word_is(const Words& words, int32_t i, const char* word);
// Copies field i, truncated if it does not fit, ended by a zero byte; empty if there is no such field.
void copy_word(const Words& words, int32_t i, char* text, int32_t size);

// ASCII letters only.
char capital(char c);

} // namespace c2d
