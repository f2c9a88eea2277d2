// Saves the state of the path during a run, with the record of its steps, and finds the record of a restored state.
#pragma once

#include "program/files/path_record.hpp"

#include <contact2d.h>

#include <string>

namespace app {

class PathKeeper {
public:
  // Saves into the folder of a store, for the job with this id (id_of), every `seconds`; 0: at every opportunity. At most 1/60
  // of the time is spent on saving, unless `seconds` is 0.
  void begin(const std::string& store_folder, const std::string& job, double seconds);
  // Starts the interval; `expected`: estimated seconds of the first save.
  void start(double expected);
  bool is_active() const { return !folder_.empty(); }
  bool is_due() const;
  // Saves at a step of c2d_run: the record first, then the solver. After a crash at any moment one of the last two states is
  // complete with its record. False with an error text on failure.
  bool keep(c2d_solver* solver, int32_t coefficient, int32_t step, const std::string& record, std::string& error);
  // The record of a step. False with the reason if there is no complete one.
  bool find(int32_t coefficient, int32_t step, std::string& record, std::string& why);

private:
  std::string path_of(int slot) const { return folder_ + (slot == 0 ? "/path0" : "/path1"); }
  std::string heading(int32_t coefficient, int32_t step) const;

  std::string folder_, job_;
  double seconds_ = 0, next_ = 0;
  int slot_ = 0; // that of the older record
};

} // namespace app
