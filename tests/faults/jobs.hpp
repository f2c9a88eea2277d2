// What the program is made to do while faults strike.
#pragma once

#include "child.hpp"
#include "tree.hpp"

#include <string>
#include <vector>

namespace faults {

struct Job {
  std::string name;
  Tree start; // the folder before
  Command command;
  std::string store; // the folder that --store names; empty: none
  bool keeps = false, resumes = false;
  bool has_strangers = false; // what is in the store's folder before is not the program's
  bool has_earlier = false;   // another run's is there
  // How it goes when nothing strikes.
  Tree finish;
  Ended ended;
};

// All jobs, each gone through once. A job that fails of itself is told in `error`.
std::vector<Job> make_jobs(const Place& place, std::string& error);

} // namespace faults
