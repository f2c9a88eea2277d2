#pragma once
// Operations on short texts, so that the core needs only memory moves and mathematics of the C library.
#include <stddef.h>
#include <stdint.h>

namespace c2d {

// Place of the first `wanted` in text[0 .. size), size if there is none; nothing behind that place is read.
int32_t place_of(char wanted, const char* text, int32_t size);
// Characters before the zero byte.
int32_t text_length(const char* text);
// Is it one of the characters of `set`? A zero byte is none.
bool one_of(char character, const char* set);
// A name is one line of UTF-8, of at most so many bytes.
constexpr int32_t kLongestName = 31;
extern const char kNameTooLong[];
// The fault of a name, "is too long ..."; null: none.
const char* fault_of_name(const char* name);
bool same_text(const char* a, const char* b);
// A loop, because clang turns a memcmp whose sign is not used into bcmp, which a host need not have.
bool same_bytes(const void* a, const void* b, size_t size);

} // namespace c2d
