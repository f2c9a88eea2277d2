/* Between the files of the preloaded library. */
#ifndef C2D_FAULTS_INSIDE_H
#define C2D_FAULTS_INSIDE_H

#include "control.h"

#include <stdbool.h>
#include <stddef.h>

enum { MOST_FILES = 512, MOST_PATH = 1024 };

/* An operation from its beginning, when it is counted and the lock is taken, to its end, when it is logged. */
struct operation {
  struct fault_record record;
  const char *path, *path2;
  const void* data;
  int kind;     /* the fault that strikes it */
  bool counted; /* no: nothing of ours, let it pass */
};

/* `applies`: bits (1 << kind) of the faults that such an operation can suffer. */
void begin_operation(struct operation* o, int op, int file, const char* path, const char* path2, unsigned applies);
void end_operation(struct operation* o, int error);

/* The place of a file by its descriptor (null: not ours) and of a name, absolute, in `room`. */
const char* path_of(int file);
void keep_path(int file, const char* path);
const char* absolute_path(int folder, const char* name, char room[MOST_PATH]);

void* next_symbol(const char* name);
void log_record(struct fault_record record);
void count_allocations(void);
void log_places(void); /* where memory was asked for */
uint64_t allocations(void);
uint64_t told_free_memory(void);
bool threads_may_start(void);
const char* setting(const char* name);
uint64_t number_setting(const char* name);

#endif
