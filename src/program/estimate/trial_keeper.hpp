// Meshes that a loop has solved, kept beside the job of the run so that one that goes on has them.
#pragma once

#include "program/estimate/trial.hpp"

#include <string>

namespace estimate {

class TrialKeeper {
public:
  // Into the folder of a store, for the job of that name (app::id_of); only what took `seconds` to solve.
  void begin(const std::string& store_folder, const std::string& job, double seconds);
  // Of the loop's next mesh, whose deck this is. False: it has to be solved, with an empty `out`.
  bool recall(const std::string& deck, Trial& out);
  // Of the mesh that was asked for last. False if that failed, as error() says.
  bool keep(const std::string& deck, Trial& trial);
  const std::string& error() const { return error_; }

private:
  std::string path() const { return folder_ + "/mesh" + std::to_string(number_); }
  std::string folder_, job_, error_;
  double seconds_ = 0;
  int number_ = 0; // from 1
};

} // namespace estimate
