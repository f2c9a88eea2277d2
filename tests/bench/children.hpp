// Processes that the benchmarks start: contenders that answer on pipes, and whole runs.
#pragma once

#include <string>
#include <sys/types.h>
#include <vector>

namespace bench {

// A process with its standard input and output on pipes, until it ends or is destroyed.
class Child {
public:
  // `environment`: NAME=VALUE, or NAME= to take one away.
  Child(const std::vector<std::string>& words, const std::vector<std::string>& environment);
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  bool alive() const { return alive_; }
  // Sends a line and returns the answer's line; empty when the process is no more.
  std::string ask(const std::string& line);

private:
  std::string read_line();
  pid_t pid_ = -1;
  int to_ = -1, from_ = -1;
  bool alive_ = false;
};

// Somebody who solves systems: rivals/serve.hpp says how they are asked.
struct Answer {
  double wall = 0, processor = 0, peak = 0, residual = 0;
  bool ok = false;
};
Answer ask(Child& child, const std::string& what, const std::string& matrix, int n);

bool is_program(const std::string& file);

} // namespace bench
