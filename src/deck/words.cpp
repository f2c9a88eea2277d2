#include "deck/words.hpp"

namespace c2d {
namespace {

bool is_gap(char c) { return c == ' ' || c == '\t'; }

bool add_word(Words& words, int32_t first, int32_t behind) {
  if (words.count == kMaximumWords) return false;
  Word& word = words.word[words.count++];
  word.column = static_cast<int16_t>(first + 1);
  word.column_end = static_cast<int16_t>(behind);
  return true;
}

} // namespace

int32_t before_comment(const char* text, int32_t length) {
  int32_t i = 0;
  while (i < length && text[i] != '!') ++i;
  return i;
}

void split_words(const char* text, int32_t length, Words& words, int32_t from) {
  words.text = text;
  words.count = 0;
  words.end = from + 1;
  words.is_part = false;
  length = before_comment(text, length);
  // A field has been read since the last comma: the next comma belongs to it.
  bool ended = from > 0 && text[from - 1] != ',';
  for (int32_t i = from; i < length;) {
    if (is_gap(text[i])) {
      ++i;
      continue;
    }
    const int32_t first = i;
    while (i < length && text[i] != ',' && !is_gap(text[i])) ++i;
    const bool is_comma = i == first;
    if (is_comma) ++i;
    if (!(is_comma && ended) && !add_word(words, first, is_comma ? first : i)) {
      words.is_part = true;
      return;
    }
    words.end = i + 1;
    ended = !is_comma;
  }
  if (words.count > 0 && word_is(words, words.count - 1, "&")) {
    words.is_part = true;
    words.end = words.word[--words.count].column;
  }
}

char capital(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

bool word_is(const Words& words, int32_t i, const char* word) {
  if (i >= words.count) return false;
  for (int32_t at = words.word[i].column - 1; at < words.word[i].column_end; ++at, ++word)
    if (*word == '\0' || capital(words.text[at]) != *word) return false;
  return *word == '\0';
}

void copy_word(const Words& words, int32_t i, char* text, int32_t size) {
  int32_t used = 0;
  if (i < words.count)
    for (int32_t at = words.word[i].column - 1; at < words.word[i].column_end && used < size - 1; ++at)
      text[used++] = words.text[at];
  text[used] = '\0';
}

} // namespace c2d
