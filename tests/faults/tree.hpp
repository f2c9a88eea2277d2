// All that is in a folder: taken, put back, compared.
#pragma once

#include <map>
#include <string>

namespace faults {

struct Entry {
  char kind = 'f'; // f: file, d: folder, l: link
  std::string bytes;
  bool operator==(const Entry& other) const { return kind == other.kind && bytes == other.bytes; }
  bool operator!=(const Entry& other) const { return !(*this == other); }
};
using Tree = std::map<std::string, Entry>; // by the path below the folder

Tree take_tree(const std::string& folder);
// The folder, made anew, with just that in it.
void put_tree(const std::string& folder, const Tree& tree);
// Folders in which it stands are there, too.
void add_file(Tree& tree, const std::string& path, const std::string& bytes);

const Entry* find(const Tree& tree, const std::string& path);
bool is_below(const std::string& path, const std::string& folder); // or is the folder
// A file that an output is written into before it gets its name.
bool is_aside(const std::string& path);
// Of all names and contents; names that have the number of a process in them count without it.
size_t hash_of(const Tree& tree);

} // namespace faults
