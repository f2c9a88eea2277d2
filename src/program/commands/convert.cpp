#include "program/commands/commands.hpp"

#include "program/exit_code.hpp"
#include "program/files/deck_file.hpp"
#include "program/messages.hpp"
#include "program/sketch/read/read.hpp"
#include "program/words/real_in_columns.hpp"
#include "report/text.hpp"

#include <contact2d_cards.h>

#include <algorithm>
#include <cstring>

namespace app {
namespace {

// The items reported by c2d_walk_deck.
struct Item {
  int32_t kind, line, column, width;
  std::string text;
  double value;
};

void keep(void* context, const c2d_card* card) {
  std::vector<Item>& items = *static_cast<std::vector<Item>*>(context);
  items.push_back({card->kind, card->line, card->column, card->width,
                   std::string(card->text, static_cast<size_t>(card->length)), card->value});
}

// A comment may contain any byte. Control characters of terminals become question marks; other alphabets are kept.
std::string without_controls(std::string text) {
  for (size_t i = 0; i < text.size(); i += std::max<size_t>(character_at(text, i), 1)) {
    const unsigned char c = static_cast<unsigned char>(text[i]);
    const bool is_control = (c < 0x20 && c != '\t') || (c >= 0x7f && c < 0xa0);
    if (is_control && character_at(text, i) == 0) text[i] = '?';
  }
  return text;
}

bool is_field(const Item& item) {
  return item.kind == C2D_CARD_INTEGER || item.kind == C2D_CARD_REAL || item.kind == C2D_CARD_LETTER;
}

bool is_flag(const Item& item) { return item.kind == C2D_CARD_INTEGER && item.column == 1 && item.width == 1; }

bool is_code(const Item& item) { return item.kind == C2D_CARD_INTEGER && item.column > 1 && item.width == 1; }

// The deck in its new form, put together line by line.
class Writer {
public:
  Writer(bool to_free, std::string& out) : free_(to_free), out_(out) {
    if (free_) out_ += "*FREE\n";
  }
  // False: the item cannot be written, and `error` says why.
  bool add(const Item& item, std::string& error);
  void finish() { next_card(); }

private:
  // Ends the current card; comments read since its start follow it.
  void next_card() {
    if (column_ > 0) put_line(card_ + (remark_.empty() ? "" : " ! " + remark_));
    for (const std::string& comment : comments_) put_line(comment);
    comments_.clear();
    card_.clear();
    remark_.clear();
    column_ = 0;
  }
  void put_line(std::string line) {
    line.erase(line.find_last_not_of(" \t") + 1);
    out_ += without_controls(line) + '\n';
  }
  std::string comment(const Item& item) const;
  bool add_field(const Item& item, std::string& error);
  void add_free_field(const Item& item);
  bool add_fixed_field(const Item& item, std::string& error);

  bool free_;
  std::string& out_;
  std::string card_, remark_;
  int32_t line_ = 0;   // of the last field, in the deck that is read
  int32_t column_ = 0; // of the last field on the card; 0: none yet
  std::vector<std::string> comments_;
  bool headings_done_ = false, in_extensions_ = false;
};

// In the fixed form a C and what looks like a number behind it would be taken for a node card.
std::string Writer::comment(const Item& item) const {
  if (free_ || in_extensions_) return item.text.empty() ? "!" : "! " + item.text;
  std::string text = "C " + item.text;
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7f) c = c == '\t' ? ' ' : '?';
  if (text.find_first_not_of(" +-0123456789.", 1) > 4 && text.find_first_not_of(' ', 1) <= 4) text[1] = '!';
  return text;
}

// Fields of one card have rising columns, so one that does not rise begins a card: the coefficients of
// friction are dealt out anew.
bool Writer::add_field(const Item& item, std::string& error) {
  constexpr int32_t kFirstCoefficient = 7;
  const bool begins = item.column <= column_ || (item.line != line_ && item.column < kFirstCoefficient);
  if (column_ > 0 && begins) next_card();
  line_ = item.line;
  if (column_ == 0 && (headings_done_ || free_)) { // read before the field, so written above its card
    for (const std::string& line : comments_) put_line(line);
    comments_.clear();
  }
  const int32_t last = column_;
  column_ = item.column;
  if (!free_) return add_fixed_field(item, error);
  const bool joins = is_code(item) && item.column == last + 1 && last > 11;
  if (is_flag(item) && item.value == 0) return true;
  if (!card_.empty() && !joins) card_ += ' ';
  add_free_field(item);
  return true;
}

void Writer::add_free_field(const Item& item) {
  if (is_code(item))
    card_ += item.value == 0 ? '0' : '1';
  else
    card_ += item.text.empty() ? "0" : item.text;
}

bool Writer::add_fixed_field(const Item& item, std::string& error) {
  const size_t width = static_cast<size_t>(item.width), first = static_cast<size_t>(item.column - 1);
  std::string text = item.text;
  if (text.size() > width)
    text = item.kind == C2D_CARD_REAL ? real_in_columns(item.value, width) : std::to_string(static_cast<long>(item.value));
  if (text.empty() && !item.text.empty() && item.kind == C2D_CARD_REAL) {
    error = "the number " + item.text + " cannot be written in " + std::to_string(width) +
            " columns of the fixed form without changing its value";
    return false;
  }
  if (text.size() > width) {
    error = "the number " + text + " does not fit in the " + std::to_string(width) + (width == 1 ? " column" : " columns") +
            " of its field in the fixed form";
    return false;
  }
  card_.resize(first, ' ');
  card_ += std::string(width - text.size(), ' ') + text;
  return true;
}

bool Writer::add(const Item& item, std::string& error) {
  if (is_field(item)) return add_field(item, error);
  switch (item.kind) {
  case C2D_CARD_HEADING:
    if (column_ > 0 || free_) { // comments stay behind the headings of a fixed deck, where they are none before
      std::vector<std::string> later;
      if (!free_) later.swap(comments_);
      next_card();
      comments_.swap(later);
    }
    out_ += item.text + '\n';
    headings_done_ = true;
    break;
  case C2D_CARD_COMMENT: comments_.push_back(comment(item)); break;
  case C2D_CARD_REMARK:
    if (free_ && !item.text.empty()) remark_ = item.text;
    break;
  case C2D_CARD_EXTENSION:
    next_card();
    in_extensions_ = true;
    put_line((!free_ && item.text.compare(0, 1, "C") == 0 ? " " : "") + item.text);
    break;
  default: break;
  }
  return true;
}

struct Text {
  const std::string& text;
  size_t at;
};

int32_t next_line(void* context, char* line, int32_t size) {
  Text& deck = *static_cast<Text*>(context);
  if (deck.at >= deck.text.size()) return -1;
  const size_t end = deck.text.find('\n', deck.at);
  const size_t length = end - deck.at, room = static_cast<size_t>(size) - 1;
  const size_t fits = length < room ? length : room;
  std::memcpy(line, deck.text.data() + deck.at, fits);
  line[fits] = '\0';
  deck.at = end + 1;
  return static_cast<int32_t>(length);
}

// Items that make the model: no comments, no flags that only say "not".
std::vector<const Item*> meaning(const std::vector<Item>& items) {
  std::vector<const Item*> list;
  for (const Item& item : items)
    if ((is_field(item) && !(is_flag(item) && item.value == 0)) || item.kind == C2D_CARD_HEADING ||
        item.kind == C2D_CARD_EXTENSION)
      list.push_back(&item);
  return list;
}

bool is_same(const Item& a, const Item& b) {
  if (a.kind != b.kind || a.column != b.column || std::memcmp(&a.value, &b.value, sizeof a.value) != 0) return false;
  if (is_field(a)) return true;
  const size_t first_a = a.text.find_first_not_of(" \t"), first_b = b.text.find_first_not_of(" \t");
  return a.text.substr(first_a == std::string::npos ? a.text.size() : first_a) ==
         b.text.substr(first_b == std::string::npos ? b.text.size() : first_b);
}

// Reads the new deck: does it give the same model?
bool says_the_same(const std::vector<Item>& items, const std::string& text, std::vector<c2d_body_limits>& bodies) {
  std::vector<Item> others;
  Text deck = {text, 0};
  const int32_t room = static_cast<int32_t>(bodies.size());
  if (c2d_walk_deck(next_line, &deck, bodies.data(), room, keep, &others, nullptr, nullptr) != C2D_OK) return false;
  const std::vector<const Item*> a = meaning(items), b = meaning(others);
  if (a.size() != b.size()) return false;
  for (size_t i = 0; i < a.size(); ++i)
    if (!is_same(*a[i], *b[i])) return false;
  return true;
}

c2d_error fault_at(const DeckFile& deck, const Item& item, const std::string& text) {
  const size_t found = deck.card(static_cast<size_t>(item.line)).find(item.text);
  if (found == std::string_view::npos) return fault_in(item.line, 0, 0, text);
  return fault_in(item.line, static_cast<int32_t>(found) + 1, static_cast<int32_t>(found + item.text.size()), text);
}

bool convert_items(const std::vector<Item>& items, bool to_free, std::string& out, size_t& at, std::string& error) {
  Writer writer(to_free, out);
  for (at = 0; at < items.size(); ++at)
    if (!writer.add(items[at], error)) return false;
  writer.finish();
  return true;
}

} // namespace

int convert_deck(const Options& options) {
  DeckFile deck;
  Messages messages(deck);
  c2d_error fault = C2D_INIT(c2d_error);
  if (!deck.read(options.deck, fault)) return messages.fault(fault, kExitInput);
  if (sketch::is_sketch(deck.text(), deck.name())) {
    messages.fail("is a sketch, expected a deck; contact2d mesh makes one of a sketch");
    return kExitInput;
  }
  std::vector<Item> items;
  std::vector<c2d_body_limits> bodies = room_for_bodies(deck);
  const c2d_status status = c2d_walk_deck(DeckFile::read_line, &deck, bodies.data(), static_cast<int32_t>(bodies.size()), keep,
                                          &items, Messages::log_cards, &messages);
  if (status != C2D_OK) return exit_code(status);

  const bool is_free = !items.empty() && items[0].kind == C2D_CARD_FREE;
  const bool to_free = options.convert_to.empty() ? !is_free : options.convert_to == "free";
  std::string error, text;
  size_t at = 0;
  if (!convert_items(items, to_free, text, at, error)) return messages.fault(fault_at(deck, items[at], error), kExitInput);
  if (!says_the_same(items, text, bodies)) {
    messages.fail("the converted deck would not give the same model; nothing was written (please report this)");
    return kExitFiles;
  }
  return write_or_fail(options.output, text, messages);
}

} // namespace app
