#pragma once
// Tasks that may run at the same time, by the caller's parallel_for. The number of threads never changes a bit of a result:
// tasks own the numbers that they write, and each number is computed as one thread alone would.
#include "contact2d.h"

namespace c2d {

struct Workers {
  const c2d_port* port;
  int32_t count; // tasks that run at once, at least 1
};
constexpr Workers kAlone = {nullptr, 1};

inline Workers workers_of(const c2d_port* port) {
  return port->parallel_for && port->threads > 1 ? Workers{port, port->threads} : kAlone;
}

// task(argument, 0) ... task(argument, n - 1); all have run when it returns. Tasks never call the port.
inline void run_tasks(const Workers& workers, int32_t n, void (*task)(void* argument, int32_t i), void* argument) {
  if (workers.count > 1 && n > 1) return workers.port->parallel_for(workers.port->context, n, task, argument);
  for (int32_t i = 0; i < n; ++i) task(argument, i);
}

} // namespace c2d
