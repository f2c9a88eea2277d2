// Saves the state of the path as a run goes along, with all that its steps have left, and finds what goes with a state that
// was brought back.
#pragma once

#include "program/path_record.hpp"

#include <contact2d.h>

#include <string>

namespace app {

class PathKeeper {
public:
  // Into the folder of a store, for the job of that name (id_of), every `seconds`; 0: whenever it can be. What else is at work
  // counts: 1/60 of the time at most goes into saving, unless `seconds` is 0.
  void begin(const std::string& store_folder, const std::string& job, double seconds);
  // From now on; saving will take about so long, which nobody knows before the first time.
  void start(double expected);
  bool is_active() const { return !folder_.empty(); }
  bool is_due() const;
  // At a step that c2d_run shows: the record first, then the solver; whatever happens in between one of the last two states
  // is there with its record. False with an error text on failure.
  bool keep(c2d_solver* solver, int32_t coefficient, int32_t step, const std::string& record, std::string& error);
  // The record that goes with a step. False with the reason if there is none that is whole.
  bool find(int32_t coefficient, int32_t step, std::string& record, std::string& why);

private:
  std::string path_of(int slot) const { return folder_ + (slot == 0 ? "/path0" : "/path1"); }
  std::string heading(int32_t coefficient, int32_t step) const;

  std::string folder_, job_;
  double seconds_ = 0, next_ = 0;
  int slot_ = 0; // that of the older record
};

} // namespace app
