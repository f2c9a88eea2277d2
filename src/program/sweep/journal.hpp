// The solved rows of a sweep, stored in a file one by one, so that an interrupted sweep can be resumed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace app {

class Journal {
public:
  Journal() = default;
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  // Opens `path` for the sweep whose inputs have the checksum `inputs`. With `resume` its complete rows are read, if the file
  // exists; otherwise it must not exist. Returns 0, or the exit status with an error text. The file is locked: another sweep
  // gets kExitBusy.
  int open(const std::string& path, uint64_t inputs, bool resume, std::string& error);
  // Writes one line in one call; an incomplete line is ignored later.
  bool add(size_t row, const std::string& text, std::string& error);
  const std::map<size_t, std::string>& rows() const { return rows_; } // by number
  void remove();                                                      // after the results are written

private:
  int take_rows(const std::string& heading, std::string& error);
  std::string path_;
  int file_ = -1;
  std::map<size_t, std::string> rows_;
};

} // namespace app
