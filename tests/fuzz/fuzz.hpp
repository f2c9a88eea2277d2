#pragma once
// What the targets share. Each is a function of bytes that must not crash, hang or take much memory, and that demands more by
// require(); libFuzzer calls it (fuzz.mk), and so do the tests with seeds and what was found (tests/test_fuzz.cpp).
#include <contact2d.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace fuzz {

inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "required: %s\n", what);
  std::abort();
}

inline std::string text_of(const uint8_t* data, size_t size) {
  return size == 0 ? std::string() : std::string(reinterpret_cast<const char*>(data), size);
}

// A deck in memory, a card per line.
struct Lines {
  explicit Lines(std::string_view deck) : text(deck) {}
  std::string_view text;
  size_t at = 0;
  static int32_t read(void* context, char* out, int32_t size) {
    Lines& lines = *static_cast<Lines*>(context);
    if (lines.at >= lines.text.size()) return -1;
    const size_t end = lines.text.find('\n', lines.at);
    const std::string_view line = lines.text.substr(lines.at, end == std::string_view::npos ? end : end - lines.at);
    lines.at = end == std::string_view::npos ? lines.text.size() : end + 1;
    const size_t fits = line.size() < static_cast<size_t>(size) ? line.size() : static_cast<size_t>(size) - 1;
    std::memcpy(out, line.data(), fits);
    out[fits] = '\0';
    return static_cast<int32_t>(line.size());
  }
};

// A message is one line with a place in the deck.
inline void require_message(const c2d_error& entry, size_t lines) {
  const size_t length = strnlen(entry.text, sizeof entry.text);
  require(length > 0 && length < sizeof entry.text, "a message that ends");
  for (size_t i = 0; i < length; ++i) {
    const unsigned char c = static_cast<unsigned char>(entry.text[i]);
    require(c >= 0x20 && c != 0x7f, "a message without control characters");
  }
  require(entry.line >= 0 && static_cast<size_t>(entry.line) <= lines + 1, "a line of the deck");
  require(entry.column >= 0 && (entry.column_end == 0 || entry.column_end >= entry.column), "columns in order");
}

inline size_t count_lines(std::string_view text) {
  size_t lines = text.empty() || text.back() == '\n' ? 0 : 1;
  for (const char c : text) lines += c == '\n';
  return lines;
}

} // namespace fuzz
