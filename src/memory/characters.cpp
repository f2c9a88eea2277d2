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
  return character != '\0' && place_of(character, set, size) < size;
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
