// Replacements for features that a page lacks: threads, the transfer thread of the store, signals.
#include "../posix/transfers.hpp"

#include <c2d_threads.h>

#include <cerrno>
#include <cstddef>

// Tasks run one after another; results do not depend on the number of threads.
int32_t c2d_threads_start(c2d_threads*, int32_t threads) { return threads < 1 || threads > C2D_THREADS_MOST ? EINVAL : 0; }
void c2d_threads_port(c2d_threads*, c2d_port*) {}
void c2d_threads_run(c2d_threads*, int32_t n, c2d_threads_task task, void* argument) {
  for (int32_t i = 0; i < n; ++i) task(argument, i);
}
void c2d_threads_stop(c2d_threads*) {}

// Transfers are executed immediately.
namespace {
int32_t results[4];
int32_t next = 0;
} // namespace
int32_t start_posix_transfer(c2d_posix_store* store, const PosixTransfer& transfer, int32_t* ticket) {
  *ticket = next;
  next = (next + 1) % 4;
  results[*ticket] = do_posix_transfer(store, transfer);
  return 0;
}
int32_t wait_posix_transfer(c2d_posix_store*, int32_t ticket) { return results[ticket]; }
void settle_posix_transfers(c2d_posix_store*, int32_t, uint64_t) {}
void stop_posix_transfers(c2d_posix_store*) {}

// No lock is needed, and memory has no pages to advise about.
extern "C" int flock(int, int) { return 0; }
extern "C" int madvise(void*, size_t, int) { return 0; }
// The one thread ends with the program, and its memory with it.
extern "C" int __cxa_thread_atexit(void (*)(void*), void*, void*) { return 0; }
