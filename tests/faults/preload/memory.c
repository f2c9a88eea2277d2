// The n-th allocation fails. Those before main are not counted: nobody could tell of them. A run that logs data also logs the
// places that ask for memory: the calls that lead there (hash of their return addresses), the first and the last allocation at
// each.
#define _GNU_SOURCE
#include "inside.h"

#include <errno.h>
#include <execinfo.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>

// (names that the C library gives its own functions, for whoever takes their place)
void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void* __libc_memalign(size_t, size_t);

static atomic_ullong count;
static uint64_t first, last;
static bool counts, finds_places;

enum { MOST_PLACES = 1 << 16, MOST_CALLS = 64 };
static struct { uint64_t hash, first, last; } places[MOST_PLACES]; // hash 0: free
static pthread_mutex_t places_mutex = PTHREAD_MUTEX_INITIALIZER;
static _Thread_local bool within; // backtrace asks for memory itself, which is not the program's

uint64_t allocations(void) { return atomic_load(&count); }

static void add_place(uint64_t number) {
  void* calls[MOST_CALLS];
  within = true;
  const int depth = backtrace(calls, MOST_CALLS);
  uint64_t hash = 14695981039346656037u; // FNV-1a, by addresses
  for (int i = 0; i < depth; ++i) hash = (hash ^ (uint64_t)(uintptr_t)calls[i]) * 1099511628211u;
  hash |= 1;
  pthread_mutex_lock(&places_mutex);
  size_t at = (size_t)(hash >> 32) % MOST_PLACES;
  for (size_t tries = 0; places[at].hash != 0 && places[at].hash != hash; at = (at + 1) % MOST_PLACES)
    if (++tries == MOST_PLACES) abort();
  if (places[at].hash == 0) places[at].first = number;
  places[at].hash = hash;
  places[at].last = number;
  pthread_mutex_unlock(&places_mutex);
  within = false;
}

void log_places(void) {
  for (size_t i = 0; finds_places && i < MOST_PLACES; ++i)
    if (places[i].hash != 0)
      log_record((struct fault_record){.op = OP_MEMORY, .number = places[i].first, .offset = places[i].last});
}

void count_allocations(void) {
  counts = true;
  finds_places = number_setting(C2D_FAULT_DATA) != 0;
  if (number_setting(C2D_FAULT_KIND) != FAULT_MEMORY) return;
  first = number_setting(C2D_FAULT_AT);
  last = number_setting(C2D_FAULT_EVER) ? UINT64_MAX : first;
}

static bool fails(void) {
  if (!counts || within) return false;
  const uint64_t number = atomic_fetch_add(&count, 1) + 1;
  if (finds_places) add_place(number);
  const bool result = first != 0 && number >= first && number <= last;
  if (result) errno = ENOMEM;
  return result;
}

void* malloc(size_t bytes) { return fails() ? NULL : __libc_malloc(bytes); }
void* calloc(size_t n, size_t bytes) { return fails() ? NULL : __libc_calloc(n, bytes); }
void* realloc(void* old, size_t bytes) { return fails() ? NULL : __libc_realloc(old, bytes); }
void* memalign(size_t alignment, size_t bytes) { return fails() ? NULL : __libc_memalign(alignment, bytes); }
void* aligned_alloc(size_t alignment, size_t bytes) { return memalign(alignment, bytes); }
int posix_memalign(void** out, size_t alignment, size_t bytes) {
  void* made = memalign(alignment, bytes);
  if (made) *out = made;
  return made ? 0 : ENOMEM;
}
