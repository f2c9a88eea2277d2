#include "program/sketch/read/words.hpp"

#include <algorithm>
#include <cctype>

namespace sketch {
namespace {

bool is_separator(char c) { return c == ' ' || c == '\t' || c == ',' || c == '=' || c == '\r'; }

int column_of(size_t at) { return static_cast<int>(at) + 1; }

// The end of a quoted word that begins at `at`.
size_t end_of_quote(std::string_view text, size_t at, int line) {
  const size_t end = text.find('"', at + 1);
  if (end == std::string_view::npos)
    throw Fault{{line, column_of(at), column_of(at)}, "the quote is not closed, expected a second '\"'"};
  return end + 1;
}

// The end of a word that begins at `at`; brackets may contain separators.
size_t end_of_word(std::string_view text, size_t at, int line) {
  std::vector<size_t> open;
  size_t i = at;
  for (; i < text.size() && text[i] != '!'; ++i) {
    const char c = text[i];
    if (open.empty() && (is_separator(c) || c == ';' || c == '"')) break;
    if (c == '(' || c == '{') open.push_back(i);
    if (c != ')' && c != '}') continue;
    if (open.empty() || (text[open.back()] == '(') != (c == ')'))
      throw Fault{{line, column_of(i), column_of(i)}, std::string("the bracket '") + c + "' has no matching opening bracket"};
    open.pop_back();
  }
  if (!open.empty())
    throw Fault{{line, column_of(open.back()), column_of(open.back())},
                std::string("the bracket '") + text[open.back()] + "' is not closed"};
  return i;
}

// The rest of a line, unchanged except for blanks around it.
Word text_of(std::string_view text, size_t at, int line) {
  const std::string_view rest = text.substr(0, text.find('!', at));
  const size_t last = rest.find_last_not_of(" \t\r");
  return {std::string(rest.substr(at, last + 1 - at)), {line, column_of(at), column_of(last)}, false};
}

} // namespace

std::vector<Word> words_of(std::string_view text, int line) {
  std::vector<Word> out;
  for (size_t i = 0; i < text.size() && text[i] != '!';) {
    if (is_separator(text[i])) {
      ++i;
      continue;
    }
    const bool quote = text[i] == '"';
    if (!quote && out.size() == 1 && out[0].is("title")) {
      out.push_back(text_of(text, i, line));
      break;
    }
    const size_t end = quote ? end_of_quote(text, i, line) : text[i] == ';' ? i + 1 : end_of_word(text, i, line);
    const std::string_view word = quote ? text.substr(i + 1, end - i - 2) : text.substr(i, end - i);
    out.push_back({std::string(word), {line, column_of(i), column_of(end) - 1}, quote});
    i = end;
  }
  return out;
}

std::string in_quotes(const std::string& text) { return "'" + text + "'"; }

bool is_ascii(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= 0x20 && c < 0x7f; });
}

bool is_one_line(const std::string& text) {
  for (size_t i = 0; i < text.size();) {
    const size_t bytes = app::character_at(text, i);
    if (bytes == 0) return false;
    i += bytes;
  }
  return true;
}

} // namespace sketch
