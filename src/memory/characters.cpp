// Short texts: search, length, comparison, and the check of names. Own loops, because the core needs only memory moves and
// mathematics from its host.
#include "memory/characters.hpp"

namespace c2d {

int32_t place_of(char wanted, const char* text, int32_t size) {
  int32_t i = 0;
  while (i < size && text[i] != wanted) ++i;
  return i;
}

int32_t text_length(const char* text) { return place_of('\0', text, INT32_MAX); }

bool one_of(char character, const char* set) {
  const int32_t size = text_length(set);
  return place_of(character, set, size) < size;
}

const char kNameTooLong[] = "is too long, expected at most 31 bytes";
static_assert(kLongestName == 31, "as it says");

namespace {

// Bytes of the UTF-8 character that begins there; 0: a control character, or no UTF-8.
int32_t bytes_of_character(const char* text) {
  const uint8_t first = static_cast<uint8_t>(text[0]);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  const int32_t bytes = first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
  // The first two bytes exclude encodings that could be shorter, surrogates, and code points beyond the last one.
  const int32_t both = first << 8 | static_cast<uint8_t>(text[1]);
  const bool fits = (both >= 0xc2a0 && both < 0xe000) || (both >= 0xe0a0 && both < 0xeda0) ||
                    (both >= 0xee80 && both < 0xf000) || (both >= 0xf090 && both < 0xf490);
  if (!fits) return 0;
  for (int32_t i = 1; i < bytes; ++i)
    if ((text[i] & 0xc0) != 0x80) return 0;
  const bool none = both == 0xefbf && static_cast<uint8_t>(text[2]) >= 0xbe; // code points that are never characters
  return none ? 0 : bytes;
}

} // namespace

const char* fault_of_name(const char* name) {
  if (place_of('\0', name, kLongestName + 1) > kLongestName) return kNameTooLong;
  for (int32_t bytes = 0; name[0] != '\0'; name += bytes) {
    bytes = bytes_of_character(name);
    if (bytes == 0) return "contains a control character or no UTF-8, expected text";
  }
  return nullptr;
}

bool same_text(const char* a, const char* b) {
  int32_t i = 0;
  while (a[i] == b[i] && a[i] != '\0') ++i;
  return a[i] == b[i];
}

bool same_bytes(const void* a, const void* b, size_t size) {
  const unsigned char* x = static_cast<const unsigned char*>(a);
  const unsigned char* y = static_cast<const unsigned char*>(b);
  size_t i = 0;
  while (i < size && x[i] == y[i]) ++i;
  return i == size;
}

} // namespace c2d
