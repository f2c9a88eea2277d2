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
  kExitInaccurate = 5, // results are written, a requested tolerance is not met
  kExitUsage = 64,
  kExitBusy = 75, // another process uses the store or runs the sweep
  kExitCancelled = 130,
  kExitPipe = 141,   // the reader of an output has gone (head, a pager)
  kExitStopped = 143 // by SIGTERM; resume continues the run
};

// The exit status of a failed call of the library.
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

// Are all requested results available?
inline bool has_results(int exit) { return exit == kExitSolved || exit == kExitInaccurate; }

} // namespace app
