#include "program/deck_file.hpp"

#include "report/text.hpp"

#include <contact2d_cards.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace app {
namespace {

void set_fault(c2d_error& fault, c2d_status status, const std::string& text) {
  fault.status = status;
  fault.severity = C2D_FAULT;
  std::snprintf(fault.text, sizeof fault.text, "%s", text.c_str());
}

// As c2d_read_line wants it.
int32_t put_card(std::string_view card, char* text, int32_t size) {
  const size_t room = size > 0 ? static_cast<size_t>(size) - 1 : 0;
  const size_t fits = card.size() < room ? card.size() : room;
  std::memcpy(text, card.data(), fits);
  if (size > 0) text[fits] = '\0';
  return card.size() > INT32_MAX ? INT32_MAX : static_cast<int32_t>(card.size());
}

} // namespace

void DeckFile::find_cards() {
  starts_.clear();
  for (size_t at = 0; at < text_.size();) {
    starts_.push_back(at);
    const size_t end = text_.find('\n', at);
    at = end == std::string::npos ? text_.size() : end + 1;
  }
}

void DeckFile::replace(const std::string& text) {
  text_ = text;
  find_cards();
}

void DeckFile::replace_by_deck(const std::string& text) {
  replace(text);
  made_ = true;
}

bool DeckFile::read(const std::string& name, c2d_error& fault) {
  name_ = name == "-" ? "standard input" : name;
  const int file = name == "-" ? 0 : ::open(name.c_str(), O_RDONLY | O_CLOEXEC);
  ssize_t got = file < 0 ? -1 : 1;
  char chunk[65536];
  while (got > 0) {
    got = ::read(file, chunk, sizeof chunk);
    if (got > 0) text_.append(chunk, static_cast<size_t>(got));
    if (got > 0 && std::memchr(chunk, 0, static_cast<size_t>(got)) != nullptr) break; // no text: judged below
  }
  const int code = errno;
  if (file > 0) ::close(file);
  if (got < 0) {
    set_fault(fault, C2D_ERR_READ, std::string("cannot be read: ") + std::strerror(code));
    return false;
  }
  find_cards();
  const size_t zero = text_.find('\0');
  if (zero == std::string::npos) return true;
  size_t line = 1;
  while (line < starts_.size() && starts_[line] <= zero) ++line;
  set_fault(fault, C2D_ERR_INPUT, "a byte that is zero: this is not a text file");
  fault.line = static_cast<int32_t>(line);
  fault.column = fault.column_end = static_cast<int32_t>(zero - starts_[line - 1]) + 1;
  return false;
}

std::string_view DeckFile::card(size_t line) const {
  if (line < 1 || line > starts_.size()) return {};
  const size_t begin = starts_[line - 1];
  size_t end = line < starts_.size() ? starts_[line] : text_.size();
  if (end > begin && text_[end - 1] == '\n') --end;
  if (end > begin && text_[end - 1] == '\r') --end;
  return std::string_view(text_).substr(begin, end - begin);
}

namespace {

struct Walk {
  const DeckFile* deck;
  size_t next;
  std::vector<std::string> headings;
  bool beyond; // the heading cards are over
};

int32_t walk_line(void* context, char* text, int32_t size) {
  Walk& walk = *static_cast<Walk*>(context);
  return walk.beyond || walk.next > walk.deck->cards() ? -1 : put_card(walk.deck->card(walk.next++), text, size);
}

void keep_heading(void* context, const c2d_card* card) {
  Walk& walk = *static_cast<Walk*>(context);
  if (card->kind == C2D_CARD_HEADING) walk.headings.emplace_back(card->text, static_cast<size_t>(card->length));
  const bool is_field = card->kind == C2D_CARD_INTEGER || card->kind == C2D_CARD_REAL;
  if (is_field && !walk.headings.empty()) walk.beyond = true;
}

} // namespace

std::vector<std::string> DeckFile::heading() const {
  Walk walk = {this, 1, {}, false};
  c2d_walk_deck(walk_line, &walk, nullptr, 0, keep_heading, &walk, nullptr, nullptr);
  if (!walk.headings.empty()) walk.headings.pop_back();
  return walk.headings;
}

int32_t DeckFile::read_line(void* context, char* text, int32_t size) {
  DeckFile& deck = *static_cast<DeckFile*>(context);
  if (deck.next_ > deck.starts_.size()) return -1;
  return put_card(deck.card(deck.next_++), text, size);
}

std::vector<c2d_body_limits> room_for_bodies(const DeckFile& deck) {
  return std::vector<c2d_body_limits>(std::min<size_t>(deck.cards(), INT32_MAX));
}

std::string quote(const DeckFile& deck, const c2d_error& entry, const char* word) {
  std::string out = "contact2d: " + deck.name() + ":";
  const bool has_line = entry.line > 0 && !deck.is_made();
  if (has_line) {
    append_integer(out, entry.line);
    out += ':';
    append_integer(out, entry.column > 0 ? entry.column : 1);
    out += ':';
  }
  out += ' ';
  out += word;
  out += ": ";
  out += entry.text;
  out += '\n';
  if (!has_line || static_cast<size_t>(entry.line) > deck.cards()) return out;

  const std::string_view card = deck.card(static_cast<size_t>(entry.line)).substr(0, 200);
  std::string caret;
  const size_t first = entry.column > 0 ? static_cast<size_t>(entry.column) - 1 : 0;
  for (size_t i = 0; i < card.size(); ++i) {
    const unsigned char c = static_cast<unsigned char>(card[i]);
    out += c == '\t' || (c >= 0x20 && c < 0x7f) ? card[i] : '?';
    if (i < first) caret += c == '\t' ? '\t' : ' ';
  }
  if (first > card.size() && first < 200) caret.append(first - card.size(), ' ');
  caret += '^';
  for (int32_t i = entry.column; i < entry.column_end && caret.size() < 200; ++i) caret += '~';
  return out += '\n' + caret + '\n';
}

} // namespace app
