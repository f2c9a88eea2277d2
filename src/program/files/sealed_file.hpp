// Files of the program's own that are read back: whole, or refused.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace app {

// A file begins with a line for its kind and ends with the length and a checksum of the rest. It is renamed after it is on
// disk, and the new name is on disk at return. False with an error text on failure; a previous file of the name is then
// unchanged.
bool write_sealed(const std::string& path, const std::string& kind, const std::string& text, std::string& error);

enum class Sealed { kWhole, kAbsent, kFailed };
// kFailed with an error text: it cannot be read, is of another kind or is damaged.
Sealed read_sealed(const std::string& path, const std::string& kind, std::string& text, std::string& error);

// Of the first `count` bytes, 64 bits; another byte means another sum.
uint64_t checksum_of(const std::string& text, size_t count);

// A missing file is no failure.
bool remove_file(const std::string& path, std::string& error);
// Removes it and remains of an interrupted write; a missing file is no failure.
bool remove_sealed(const std::string& path, std::string& error);

// 16 digits that identify a text.
std::string sum_of(const std::string& text);

} // namespace app
