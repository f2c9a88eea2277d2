// The n-th allocation fails. Those before main are not counted: nobody could tell of them.
#define _GNU_SOURCE
#include "inside.h"

#include <errno.h>
#include <stdatomic.h>
#include <stdlib.h>

// (names that the C library gives its own functions, for whoever takes their place)
void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void* __libc_memalign(size_t, size_t);

static atomic_ullong count;
static uint64_t first, last;
static bool counts;

uint64_t allocations(void) { return atomic_load(&count); }

void count_allocations(void) {
  counts = true;
  if (number_setting(C2D_FAULT_KIND) != FAULT_MEMORY) return;
  first = number_setting(C2D_FAULT_AT);
  last = number_setting(C2D_FAULT_EVER) ? UINT64_MAX : first;
}

static bool fails(void) {
  if (!counts) return false;
  const uint64_t number = atomic_fetch_add(&count, 1) + 1;
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
