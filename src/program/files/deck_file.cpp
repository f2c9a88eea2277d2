#include "program/files/deck_file.hpp"

#include "program/words/voice.hpp"

#include "program/files/system_file.hpp"
#include "program/interrupt.hpp"
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

// For c2d_read_line.
int32_t put_card(std::string_view card, char* text, int32_t size) {
  const size_t fits = std::min(card.size(), static_cast<size_t>(size) - 1);
  std::memcpy(text, card.data(), fits);
  text[fits] = '\0';
  return static_cast<int32_t>(std::min<size_t>(card.size(), INT32_MAX));
}

// Of a body: its sizes, a region, constants, origin, a node, numbers of conditions, of loads and of contacts.
constexpr size_t kLeastCards = 8;

// All of an open file; false if it cannot be read. A signal that does not end the program does not end the reading.
bool append_file(int file, std::string& text) {
  constexpr size_t kPart = 65536;
  for (size_t used = text.size();;) {
    text.resize(used + kPart);
    const ssize_t got = ::read(file, &text[used], kPart);
    if (got < 0 && errno == EINTR && !interrupted()) continue;
    const size_t more = got > 0 ? static_cast<size_t>(got) : 0;
    text.resize(used + more);
    if (got <= 0) return got == 0;
    if (std::memchr(&text[used], 0, more) != nullptr) return true; // no text
    used += more;
  }
}

} // namespace

void DeckFile::find_cards() {
  starts_.clear();
  cards_ = 0;
  for (size_t at = 0; at < text_.size(); at = behind_line(at), ++cards_)
    if (cards_ % kTogether == 0) starts_.push_back(at);
  seen_ = 0;
}

size_t DeckFile::behind_line(size_t at) const {
  const size_t end = text_.find('\n', at);
  return end == std::string::npos ? text_.size() : end + 1;
}

size_t DeckFile::start_of(size_t line) const {
  if (line != seen_ + 1 || seen_ == 0) {
    seen_ = (line - 1) / kTogether * kTogether + 1;
    seen_at_ = starts_[(line - 1) / kTogether];
  }
  for (; seen_ < line; ++seen_) seen_at_ = behind_line(seen_at_);
  return seen_at_;
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
  const int file = name == "-" ? 0 : open_file(name, O_RDONLY);
  const bool read_all = file >= 0 && append_file(file, text_);
  const int code = errno;
  if (file > 0) ::close(file);
  if (!read_all) {
    set_fault(fault, C2D_ERR_READ, std::string("cannot be read: ") + system_text(code));
    return false;
  }
  return is_text(fault);
}

bool DeckFile::read_named(const std::string& name, c2d_error& fault) {
  quoted_ = false;
  if (name == "-") return read(name, fault);
  name_ = name;
  const std::string why = app::read_named(name, text_);
  if (!why.empty()) set_fault(fault, C2D_ERR_READ, why);
  return why.empty() && is_text(fault);
}

bool DeckFile::is_text(c2d_error& fault) {
  find_cards();
  const size_t zero = text_.find('\0');
  if (zero == std::string::npos) return true;
  const size_t line = static_cast<size_t>(std::count(text_.begin(), text_.begin() + static_cast<ptrdiff_t>(zero), '\n'));
  const size_t begin = line == 0 ? 0 : text_.rfind('\n', zero) + 1;
  set_fault(fault, C2D_ERR_INPUT, "zero byte: this is not a text file");
  fault.line = static_cast<int32_t>(line) + 1;
  fault.column = fault.column_end = static_cast<int32_t>(zero - begin) + 1;
  return false;
}

std::string_view DeckFile::card(size_t line) const {
  if (line < 1 || line > cards_) return {};
  const size_t begin = start_of(line);
  size_t end = behind_line(begin);
  if (text_[end - 1] == '\n') --end;
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
  if (card->kind == C2D_CARD_INTEGER && !walk.headings.empty()) walk.beyond = true;
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
  if (deck.next_ > deck.cards_) return -1;
  return put_card(deck.card(deck.next_++), text, size);
}

std::vector<c2d_body_limits> room_for_bodies(const DeckFile& deck) {
  Walk walk = {&deck, 1, {}, false};
  c2d_limits limits = C2D_INIT(c2d_limits);
  c2d_scan_deck(walk_line, &walk, &limits, nullptr); // without a list it ends at the number of bodies
  const size_t count = limits.bodies > 0 ? static_cast<size_t>(limits.bodies) : 1;
  return std::vector<c2d_body_limits>(std::min(count, most_bodies(deck)));
}

size_t most_bodies(const DeckFile& deck) { return std::min<size_t>(deck.cards() / kLeastCards + 1, INT32_MAX); }

c2d_error fault_in(int32_t line, int32_t column, int32_t column_end, const std::string& text) {
  c2d_error out = C2D_INIT(c2d_error);
  set_fault(out, C2D_ERR_INPUT, text);
  out.line = line, out.column = column, out.column_end = column_end;
  return out;
}

std::string quote(const DeckFile& deck, const c2d_error& entry, const char* word) {
  std::string out = "contact2d: " + shown(deck.name()) + ":";
  const bool has_line = entry.line > 0 && !deck.is_made();
  if (has_line) {
    append_integer(out, entry.line);
    out += ':';
    append_integer(out, entry.column > 0 ? entry.column : 1);
    out += ':';
  }
  out += ' ';
  out += coloured(entry.severity == C2D_WARNING ? Colour::kWarning : Colour::kError, std::string(word) + ":");
  out += ' ';
  out += shown(entry.text);
  out += '\n';
  if (!has_line || !deck.is_quoted() || static_cast<size_t>(entry.line) > deck.cards()) return out;

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
  const size_t blank = std::min(caret.find('^'), caret.size());
  return out += '\n' + caret.substr(0, blank) + coloured(Colour::kPlace, caret.substr(blank)) + '\n';
}

} // namespace app
