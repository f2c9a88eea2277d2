#pragma once
// The hostile build (memory/hostile.hpp) uses every freedom that a port has. While the solver transfers blocks it gets,
// instead of the caller's port, one that does what was begun when it is waited for, spoils what is to be read until
// then, and traps where the solver does not keep its side of the rules. Tasks run from the last to the first.
#include "store/tapes.hpp"

namespace c2d {

#ifdef C2D_HOSTILE

// A transfer that was begun and has not been waited for.
struct LateTransfer {
  bool under_way, writes, happened;
  int32_t tape;
  int32_t code; // the caller's answer, once it has happened
  uint64_t block, bytes;
  uint64_t start; // counts
  uint64_t sum;   // of the buffer: until it has been waited for nobody else may touch it
  void* data;
};

// From its construction to its end these tapes are worked on through `port`, whose context is this object.
class HostilePort {
public:
  explicit HostilePort(Tapes& tapes);
  ~HostilePort();
  HostilePort(const HostilePort&) = delete;
  HostilePort& operator=(const HostilePort&) = delete;

  c2d_port caller, port;
  LateTransfer late[kMostTransfers];
  uint64_t starts;

private:
  Tapes& tapes_;
  const c2d_port* before_;
};

// Columns of a panel where the caller leaves that to the library. (No other object file depends on the number.)
int32_t hostile_width();
// A caller without threads has three, which take the tasks in the wrong order.
void make_tasks_hostile(c2d_port& port);

#else

struct HostilePort {
  explicit HostilePort(const Tapes&) {}
};
inline int32_t hostile_width() { return 0; }
inline void make_tasks_hostile(c2d_port&) {}

#endif

} // namespace c2d
