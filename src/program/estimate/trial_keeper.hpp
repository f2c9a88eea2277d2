// Stores solved meshes beside the job of a run, so that a resumed run need not solve them again.
#pragma once

#include "program/estimate/trial.hpp"

#include <string>

namespace estimate {

class TrialKeeper {
public:
  // Stores into the folder of a store, for the job with this id (app::id_of); only meshes that took at least `seconds`.
  void begin(const std::string& store_folder, const std::string& job, double seconds);
  // Reads the solution of the next mesh, with this deck. False: it must be solved; `out` is empty.
  bool recall(const std::string& deck, Trial& out);
  // Stores the solution of the mesh requested last. False on failure, see error().
  bool keep(const std::string& deck, Trial& trial);
  const std::string& error() const { return error_; }

private:
  std::string path() const { return folder_ + "/mesh" + std::to_string(number_); }
  std::string folder_, job_, error_;
  double seconds_ = 0;
  int number_ = 0; // from 1
};

} // namespace estimate
