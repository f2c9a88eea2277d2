// One run of the program under the preloaded library.
#pragma once

#include "preload/control.h"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace faults {

struct Command {
  std::vector<std::string> words; // after the program's name
  std::string input;              // file for standard input, below the folder
  uint64_t free_memory = 0;       // told to the program; 0: the truth
  bool threads = false;
};

struct Strike {
  int kind = FAULT_NONE;
  uint64_t at = 0;
  bool ever = false;
  std::string where; // only paths that contain this
};

struct Record {
  int op = 0, struck = 0, file = 0, flags = 0, error = 0;
  uint64_t number = 0, offset = 0, bytes = 0;
  std::string path, path2, data; // paths below the folder, without a slash at the end
};

struct Ended {
  int status = -1; // exit status, 128 + signal
  std::string out, err;
  std::vector<Record> journal;
  uint64_t operations = 0, allocations = 0;
  std::set<uint64_t> places;    // of a run with its data: the first and the last allocation at each place that asks for memory
  const Record* struck() const; // the first operation that was, or null
};

// What a place needs: the program, the preloaded library, and a folder of its own, of which `w` is where the program runs.
struct Place {
  std::string program, library, base;
  std::string work() const { return base + "/w"; }
};

Ended run(const Place& place, const Command& command, const Strike& strike = {}, bool with_data = false);

} // namespace faults
