// What is demanded of the program when something fails.
#pragma once

#include "jobs.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace faults {

// Cases and faults of one kind of trouble.
struct Tally {
  uint64_t cases = 0, faults = 0;
  std::map<std::string, uint64_t> kinds;     // cases by what happened: to which operation, once or for ever; how power was lost
  std::map<std::string, uint64_t> how_often; // by what was found
  std::map<std::string, std::string> example;
};

class Judge {
public:
  Judge(const Place& place, Tally& tally) : place_(place), tally_(tally) {}
  // A fault that the program can see: the run, then a second try.
  void strike(const Job& job, const Strike& strike);
  // What a crash of this kind left. `done`: after the exit status 0.
  void crash(const Job& job, const Tree& left, bool done, const std::string& kind, const std::string& what);
  // A crash of this kind that left what was judged before.
  void again(const std::string& kind);

private:
  bool fault(const std::string& text);
  bool is_whole(const Job& job, const Tree& tree, bool killed);
  void failed(const Job& job, const Strike& strike, const Ended& ended, const Tree& tree);
  void second_try(const Job& job, const Tree& tree, bool leftovers);
  void begins_or_goes_on(const Job& job, const Tree& tree, bool leftovers);
  void resumes_or_refuses(const Job& job, const Tree& tree, bool leftovers);
  void runs(const Job& job, const Tree& tree, bool leftovers);
  void ends_well(const Job& job, const Ended& ended, const Tree& tree, bool leftovers, const std::string& what);

  const Place& place_;
  Tally& tally_;
  std::string what_; // the case at hand
  // By job and state of the folder: second tries that went well. Most faults leave one of a few states.
  std::set<std::pair<std::string, size_t>> went_well_;
  bool told_ = false, must_go_on_ = false; // must_go_on_: the run said that resume would
  uint64_t found_ = 0;
};

} // namespace faults
