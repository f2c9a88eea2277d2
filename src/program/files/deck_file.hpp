// A deck in memory: read once, handed to the library card by card, quoted when something is wrong with a
// card.
#pragma once

#include "report/inputs.hpp"

#include <contact2d.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace app {

class DeckFile {
public:
  // Reads the whole file ("-": standard input). On failure `fault` has the reason and the place; a zero byte is a
  // failure.
  bool read(const std::string& name, c2d_error& fault);
  // The same of a file that an option names: "-", or a regular one that is not too large. Messages do not quote its lines.
  bool read_named(const std::string& name, c2d_error& fault);

  const std::string& name() const { return name_; }
  void call(const std::string& name) { name_ = name; }
  void replace(const std::string& text);
  // By the deck of the sketch that this was: its cards are not the user's, and messages do not quote them.
  void replace_by_deck(const std::string& text);
  bool is_made() const { return made_; }
  bool is_quoted() const { return quoted_; }
  const std::string& text() const { return text_; }
  size_t cards() const { return cards_; }
  // Card `line` (from 1) without its line end; empty if there is no such card.
  std::string_view card(size_t line) const;
  // The cards of the problem statement without the last, which is the title.
  std::vector<std::string> heading() const;

  void rewind() { next_ = 1; }
  // The library's read_line; `context` is the DeckFile.
  static int32_t read_line(void* context, char* text, int32_t size);

  Inputs inputs; // set by take_sketch()

private:
  bool is_text(c2d_error& fault); // finds the cards
  void find_cards();
  size_t behind_line(size_t at) const; // where the line ends that begins there, its end included
  size_t start_of(size_t line) const;
  static constexpr size_t kTogether = 64;
  std::string name_, text_;
  std::vector<size_t> starts_; // where card 1 begins, and every kTogether-th behind it
  size_t cards_ = 0;
  mutable size_t seen_ = 0, seen_at_ = 0; // the card that was looked at last, from 1; 0: none. They are mostly read in turn
  size_t next_ = 1;
  bool made_ = false, quoted_ = true;
};

// A list for all bodies of a deck: not too short for any that is whole.
std::vector<c2d_body_limits> room_for_bodies(const DeckFile& deck);
// More bodies than this the deck has no cards for.
size_t most_bodies(const DeckFile& deck);

// `contact2d: DECK:LINE:COLUMN: error: text`, with the card and a caret under the field if a line is known
// and the deck is the user's, and no file that is only named in it or by an option.
// `word` is error or warning.
std::string quote(const DeckFile& deck, const c2d_error& entry, const char* word);
// A fault of the program's own in a file, from column to column_end of a line.
c2d_error fault_in(int32_t line, int32_t column, int32_t column_end, const std::string& text);

} // namespace app
