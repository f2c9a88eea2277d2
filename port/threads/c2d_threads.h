/* Threads for c2d_port.parallel_for: a pool of POSIX threads in memory of the caller. After the rest of the port is set,

     c2d_threads pool;
     c2d_port port = C2D_INIT(c2d_port);
     if (c2d_threads_start(&pool, 4) == 0) c2d_threads_port(&pool, &port);

   and after c2d_close c2d_threads_stop(&pool). The results of the library do not depend on the number of threads, bit
   for bit. glibc before 2.34 and other older C libraries need -lpthread. */
#ifndef C2D_THREADS_H
#define C2D_THREADS_H

#include "contact2d.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { C2D_THREADS_MOST = 64 };

/* Members are private. The pool must not be moved while threads run. */
typedef struct c2d_threads {
  uint64_t room[192];
} c2d_threads;

typedef void (*c2d_threads_task)(void* argument, int32_t i);

/* Start a pool of `threads` threads, 1 ... C2D_THREADS_MOST, including the one that calls the library. The pool blocks all
   signals. Returns 0, or errno and no thread runs (EINVAL: number out of range). */
int32_t c2d_threads_start(c2d_threads* pool, int32_t threads);
/* Add the pool to a port whose other members are set: the context of the port becomes the pool, and its other functions are
   called through it with their former context. Alternatively set threads yourself, and parallel_for to a function that calls
   c2d_threads_run. */
void c2d_threads_port(c2d_threads* pool, c2d_port* out);
/* Run task(argument, 0) ... task(argument, n - 1), with the caller's rounding mode and traps; all have run when it returns.
   Call it from one thread at a time, and not from within a task. Threads wait for the next call, and the caller for the last
   task, first by polling for some ten microseconds, then by sleeping. */
void c2d_threads_run(c2d_threads* pool, int32_t n, c2d_threads_task task, void* argument);
/* End the threads. The pool may be started again. */
void c2d_threads_stop(c2d_threads* pool);

#ifdef __cplusplus
}
#endif
#endif
