// The rows of a sweep that are done, kept in a file as they come, so that a sweep that is cut off can go on.
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

  // `path` belongs to the sweep whose inputs have the checksum `inputs`. With `resume` the rows that are whole in it are taken
  // up, if there is such a file; else there must be none. 0, or the exit status with an error text. The file is locked: another
  // sweep that wants it gets kExitBusy.
  int open(const std::string& path, uint64_t inputs, bool resume, std::string& error);
  // One line, in one write; what a kill leaves of it is not taken for a row.
  bool add(size_t row, const std::string& text, std::string& error);
  const std::map<size_t, std::string>& rows() const { return rows_; } // by number
  void remove();                                                      // the table is there

private:
  int take_rows(const std::string& heading, std::string& error);
  std::string path_;
  int file_ = -1;
  std::map<size_t, std::string> rows_;
};

} // namespace app
