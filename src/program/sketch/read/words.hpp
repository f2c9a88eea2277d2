// The words of a sketch with their places. A line is a statement; `!` begins a comment. Blanks, tabs, commas and `=` separate
// words outside brackets and quotes. A semicolon is a separate word. The text after `title` is one word.
#pragma once

#include "report/text.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace sketch {

struct Place { // columns from 1, both inclusive; line 0: nowhere
  int line = 0, column = 0, end = 0;
};

// An error in a sketch. It ends the statement being read; a sketch may have several.
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

inline std::string show(double value) { return app::shortest(value); }
using app::rounded;                             // for computed values
std::string in_quotes(const std::string& text); // 'text'
// Text allowed on cards of a deck: printable ASCII; in names, one line of UTF-8.
bool is_ascii(const std::string& text);
bool is_one_line(const std::string& text);

} // namespace sketch
