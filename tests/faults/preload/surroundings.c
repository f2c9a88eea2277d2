// The beginning of main, threads, the clock, and how much memory is free: what would differ from run to run does not.
#define _GNU_SOURCE
#include "inside.h"

#include <errno.h>
#include <pthread.h>
#include <time.h>
#include <unistd.h>

static int (*real_main)(int, char**, char**);

static int counted_main(int argc, char** argv, char** environment) {
  count_allocations();
  return real_main(argc, argv, environment);
}

int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv, void (*init)(void), void (*fini)(void),
                      void (*loader_fini)(void), void* stack) {
  typedef int start(int (*)(int, char**, char**), int, char**, void (*)(void), void (*)(void), void (*)(void), void*);
  real_main = main;
  start* next = (start*)next_symbol("__libc_start_main");
  return next(counted_main, argc, argv, init, fini, loader_fini, stack);
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*work)(void*), void* argument) {
  if (!threads_may_start()) return EAGAIN;
  return ((__typeof__(&pthread_create))next_symbol("pthread_create"))(thread, attributes, work, argument);
}

int clock_gettime(clockid_t clock, struct timespec* out) {
  (void)clock;
  out->tv_sec = 1000;
  out->tv_nsec = 0;
  return 0;
}

long sysconf(int name) {
  long (*next)(int) = (__typeof__(next))next_symbol("sysconf");
  const uint64_t free_memory = told_free_memory();
  return name == _SC_AVPHYS_PAGES && free_memory ? (long)free_memory / next(_SC_PAGESIZE) : next(name);
}
