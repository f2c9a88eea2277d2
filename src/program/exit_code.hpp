// Exit statuses of the program; part of its contract.
#pragma once

#include <contact2d.h>

namespace app {

enum ExitCode {
  kExitSolved = 0,
  kExitNoSolution = 1,
  kExitInput = 2,
  kExitFiles = 3,
  kExitMemory = 4,
  kExitInaccurate = 5, // results are written, a wanted tolerance is not met
  kExitUsage = 64,
  kExitBusy = 75, // another process is at the store, or at the sweep
  kExitCancelled = 130,
  kExitStopped = 143 // by SIGTERM, and resume goes on
};

// The exit status that a failed call of the library leads to.
inline int exit_code(c2d_status status) {
  switch (status) {
  case C2D_OK: return kExitSolved;
  case C2D_ERR_MEMORY:
  case C2D_ERR_OVERFLOW: return kExitMemory;
  case C2D_ERR_CANCELLED: return kExitCancelled;
  case C2D_ERR_SINGULAR: return kExitNoSolution;
  case C2D_ERR_INPUT:
  case C2D_ERR_LIMIT:
  case C2D_ERR_READ: return kExitInput;
  default: return kExitFiles;
  }
}

// Are there results, all that were asked for?
inline bool has_results(int exit) { return exit == kExitSolved || exit == kExitInaccurate; }

} // namespace app
