#include "program/files/path_keeper.hpp"

#include "program/files/sealed_file.hpp"
#include "program/progress.hpp"

#include <algorithm>

namespace app {
namespace {

const char kPathKind[] = "contact2d path 3";
constexpr double kWork = 60; // least ratio of run time to time for saving

} // namespace

void PathKeeper::begin(const std::string& store_folder, const std::string& job, double seconds) {
  folder_ = store_folder;
  job_ = job;
  seconds_ = seconds;
}

void PathKeeper::start(double expected) { next_ = clock_seconds(nullptr) + std::max(seconds_, kWork * expected); }

bool PathKeeper::is_due() const { return is_active() && (seconds_ == 0 || clock_seconds(nullptr) >= next_); }

std::string PathKeeper::heading(int32_t coefficient, int32_t step) const {
  return job_ + ' ' + std::to_string(coefficient) + ' ' + std::to_string(step) + '\n';
}

bool PathKeeper::keep(c2d_solver* solver, int32_t coefficient, int32_t step, const std::string& record, std::string& error) {
  const double start = clock_seconds(nullptr);
  if (!write_sealed(path_of(slot_), kPathKind, heading(coefficient, step) + record, error)) return false;
  if (const c2d_status status = c2d_save(solver); status != C2D_OK) {
    error = folder_ + ": the state of the path cannot be saved: " + c2d_message(status);
    return false;
  }
  slot_ = 1 - slot_;
  const double end = clock_seconds(nullptr);
  next_ = end + std::max(seconds_, kWork * (end - start));
  return true;
}

bool PathKeeper::find(int32_t coefficient, int32_t step, std::string& record, std::string& why) {
  const std::string wanted = heading(coefficient, step);
  why = "the record of the earlier steps is missing";
  for (int slot = 0; slot < 2; ++slot) {
    std::string error;
    const Sealed found = read_sealed(path_of(slot), kPathKind, record, error);
    if (found == Sealed::kFailed) why = error;
    if (found != Sealed::kWhole || record.compare(0, wanted.size(), wanted) != 0) continue;
    record.erase(0, wanted.size());
    slot_ = 1 - slot;
    why.clear();
    return true;
  }
  return false;
}

} // namespace app
