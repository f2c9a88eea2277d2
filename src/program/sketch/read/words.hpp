// The text of a sketch as words with their places. A line is a statement; `!` begins a comment; blanks, tabs, commas and `=`
// separate words, outside brackets and quotes; a semicolon is a word of its own. What stands behind `title` is one word.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sketch {

struct Place { // columns from 1, both inclusive; line 0: nowhere
  int line = 0, column = 0, end = 0;
};

// What is wrong with a sketch. Thrown while a statement is read, which is then left; several may be found in one sketch.
struct Fault {
  Place at;
  std::string text;
};

struct Word {
  std::string text;
  Place at;
  bool quoted = false;
  bool is(const char* word) const { return !quoted && text == word; }
};

// Words of a line, numbered `line`. Throws a Fault for a quote or a bracket that is not closed.
std::vector<Word> words_of(std::string_view text, int line);

std::string show(double value);    // as few digits as read as the same double
std::string rounded(double value); // to six digits, for what was computed
// The word that differs from `word` by two letters at most, capitals aside; empty: none does.
std::string nearest(const std::string& word, const std::vector<std::string>& words);
std::string in_quotes(const std::string& text); // 'text'
// What cards of a deck hold: printable ASCII; in names one line of UTF-8.
bool is_ascii(const std::string& text);
bool is_one_line(const std::string& text);

} // namespace sketch
