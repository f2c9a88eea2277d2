// Files of the program's own that are read back: whole, or refused.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace app {

// A file begins with a line that says what it is, and ends with the length and a checksum of all before. It gets its name when
// it is safe, and the name is safe when this returns. False with an error text on failure; then what had the name before has
// it.
bool write_sealed(const std::string& path, const std::string& kind, const std::string& text, std::string& error);

enum class Sealed { kWhole, kAbsent, kFailed };
// kFailed with an error text: it cannot be read, is of another kind or is damaged.
Sealed read_sealed(const std::string& path, const std::string& kind, std::string& text, std::string& error);

// Of the first `count` bytes, 64 bits; another byte means another sum.
uint64_t checksum_of(const std::string& text, size_t count);

// None there is no failure.
bool remove_file(const std::string& path, std::string& error);
// Removes it, and what a write that was cut off has left; none there is no failure.
bool remove_sealed(const std::string& path, std::string& error);

// 16 digits that hardly two texts have in common.
std::string sum_of(const std::string& text);

} // namespace app
