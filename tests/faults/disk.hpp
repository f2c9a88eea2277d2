// A disk that loses power: what was written and renamed, what of it was made safe, and what a crash might leave.
//
// POSIX promises nothing of what was not synced: names that were set in a folder since its last sync, and bytes of a file since
// its last, are each there or not, in any order; only a rename is there as a whole or not at all.
#pragma once

#include "child.hpp"
#include "tree.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace faults {

enum class Loss {
  kNothing,     // all is there
  kAllUnsynced, // only what was synced is there
  kData,        // names are, unsynced bytes are not
  kZeros,       // names and lengths are, unsynced bytes are zeros
  kHalf,        // names are, and the first half of what was written since
  kEarlyNames,  // of the names of each folder only the last change is there; bytes are
  kLateNames,   // the last change is not; bytes are
  kNewestEmpty, // only the last change of the names is there, no unsynced bytes
  kRandom,      // any subset: by a number
};

class Disk {
public:
  explicit Disk(const Tree& tree);
  // What the program did. False: nothing that changes the disk or what is safe on it.
  bool apply(const Record& record);
  Tree after_crash(Loss loss, uint32_t seed) const;
  bool is_wrong() const { return wrong_; } // an operation that cannot be (of a file that is not there)

private:
  static constexpr int kNone = -1;
  struct Bytes { // a change of a file's bytes
    bool sets_length;
    uint64_t offset;
    std::string data;
  };
  struct Node {
    char kind = 'f';
    std::string safe; // of a file, a link
    std::vector<Bytes> changes;
    std::map<std::string, int> names; // of a folder, as they are safe
  };
  struct Name {
    int folder;
    std::string name;
    int node; // kNone: no more
  };
  using Rename = std::vector<Name>; // together or not at all

  int node_at(const std::string& path) const;
  int folder_of(const std::string& path, std::string& name) const;
  int add(const std::string& path, char kind);
  void remove(const std::string& path);
  void sync(int node);
  void name(const Rename& change);
  static std::string bytes_of(const Node& node, Loss loss, uint32_t& dice);
  void put(Tree& tree, const std::vector<std::map<std::string, int>>& names, int folder, const std::string& path, Loss loss,
           uint32_t& dice) const;

  std::vector<Node> nodes_;                       // 0: the folder of all
  std::vector<std::map<std::string, int>> names_; // of every node, as they are now
  std::vector<Rename> changes_;                   // of names, not safe, in their order
  std::map<int, int> open_;                       // descriptor: node
  bool wrong_ = false;
};

} // namespace faults
