// Counts of the entities of a file: read, left out, repaired.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace drawing {

class Account {
public:
  void read(std::string_view kind, int count = 1) { read_[std::string(kind)] += count; }
  void leave_out(std::string_view kind, const std::string& why, int line) { add(left_out_, kind, why, line); }
  void repair(std::string_view kind, const std::string& how, int line) { add(repaired_, kind, how, line); }
  std::vector<std::string> notes() const;

private:
  struct Entry {
    std::string kind, why;
    int count, line; // of the first one
  };
  static void add(std::vector<Entry>& entries, std::string_view kind, const std::string& why, int line);
  static void append(std::vector<std::string>& out, const char* what, const std::vector<Entry>& entries);

  std::map<std::string, int> read_;
  std::vector<Entry> left_out_, repaired_;
};

} // namespace drawing
