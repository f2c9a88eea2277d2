// Settings, counting and the log.
#define _GNU_SOURCE
#include "inside.h"

#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <unistd.h>

static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
static char paths[MOST_FILES][MOST_PATH];
static uint64_t operations, struck, fault_at;
static int fault, log_file = -1;
static bool ever, keeps_data;
static const char *root, *where;

const char* setting(const char* name) {
  const char* value = getenv(name);
  return value && value[0] ? value : NULL;
}
uint64_t number_setting(const char* name) {
  const char* value = setting(name);
  return value ? strtoull(value, NULL, 10) : 0;
}

void* next_symbol(const char* name) {
  void* found = dlsym(RTLD_NEXT, name);
  if (!found) abort();
  return found;
}

bool threads_may_start(void) { return number_setting(C2D_FAULT_THREADS) != 0; }
uint64_t told_free_memory(void) { return number_setting(C2D_FAULT_FREE); }

__attribute__((constructor)) static void begin(void) {
  root = setting(C2D_FAULT_ROOT);
  where = setting(C2D_FAULT_WHERE);
  fault = (int)number_setting(C2D_FAULT_KIND);
  fault_at = number_setting(C2D_FAULT_AT);
  ever = number_setting(C2D_FAULT_EVER) != 0;
  keeps_data = number_setting(C2D_FAULT_DATA) != 0;
  strcpy(paths[0], "standard input");
  strcpy(paths[1], "standard output");
  const char* log = setting(C2D_FAULT_LOG);
  if (!log) return;
  const long file = syscall(SYS_openat, AT_FDCWD, log, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  log_file = fcntl((int)file, F_DUPFD_CLOEXEC, MOST_FILES);
  syscall(SYS_close, (int)file);
}

static void put(const void* data, size_t bytes) {
  for (const char* at = data; bytes > 0;) {
    const long done = syscall(SYS_write, log_file, at, bytes);
    if (done <= 0) abort();
    at += done;
    bytes -= (size_t)done;
  }
}

static void put_record(const struct operation* o) {
  if (log_file < 0) return;
  put(&o->record, sizeof o->record);
  if (o->record.path_bytes) put(o->path, o->record.path_bytes);
  if (o->record.path2_bytes) put(o->path2, o->record.path2_bytes);
  if (o->record.data_bytes) put(o->data, o->record.data_bytes);
}

void log_record(struct fault_record record) {
  const struct operation o = {.record = record};
  put_record(&o);
}

__attribute__((destructor)) static void end(void) {
  log_places();
  log_record((struct fault_record){.op = OP_END, .number = operations, .offset = allocations()});
}

static bool is_ours(const char* path) {
  if (!path) return false;
  if (path == paths[0] || path == paths[1]) return true;
  const size_t length = root ? strlen(root) : 0;
  return length > 0 && strncmp(path, root, length) == 0 && (path[length] == '/' || path[length] == '\0');
}

static int judge(const struct operation* o, unsigned applies) {
  if (fault == FAULT_MEMORY || (applies >> fault & 1) == 0 || operations < fault_at || (!ever && operations > fault_at))
    return 0;
  if (where && !strstr(o->path, where) && !(o->path2 && strstr(o->path2, where))) return 0;
  ++struck;
  return fault == FAULT_INTERRUPTED && struck % 2 == 0 ? 0 : fault;
}

void begin_operation(struct operation* o, int op, int file, const char* path, const char* path2, unsigned applies) {
  memset(o, 0, sizeof *o);
  o->counted = is_ours(path) || is_ours(path2);
  if (!o->counted) return;
  pthread_mutex_lock(&mutex);
  o->path = path;
  o->path2 = path2;
  o->record.number = ++operations;
  o->record.op = op;
  o->record.file = file;
  o->record.path_bytes = (uint32_t)strlen(path);
  o->record.path2_bytes = path2 ? (uint32_t)strlen(path2) : 0;
  o->kind = judge(o, applies | 1u << FAULT_KILLED | 1u << FAULT_STOPPED | 1u << FAULT_FAIL);
  o->record.struck = o->kind;
  if (o->kind == FAULT_STOPPED) raise(SIGTERM);
  if (o->kind != FAULT_KILLED) return;
  put_record(o);
  kill(getpid(), SIGKILL);
}

void end_operation(struct operation* o, int error) {
  if (!o->counted) return;
  o->record.error = error;
  if (o->data && keeps_data) o->record.data_bytes = (uint32_t)o->record.bytes;
  put_record(o);
  pthread_mutex_unlock(&mutex);
  if (error) errno = error;
}

const char* path_of(int file) { return file >= 0 && file < MOST_FILES && paths[file][0] ? paths[file] : NULL; }

void keep_path(int file, const char* path) {
  if (file >= 0 && file < MOST_FILES) strncpy(paths[file], path, MOST_PATH - 1);
}

const char* absolute_path(int folder, const char* name, char room[MOST_PATH]) {
  char here[MOST_PATH];
  const char* base = name[0] == '/' ? "" : folder == AT_FDCWD ? getcwd(here, sizeof here) : path_of(folder);
  if (!base || strlen(base) + strlen(name) + 2 > MOST_PATH) return NULL;
  strcpy(room, base);
  if (name[0] != '/') strcat(room, "/");
  return strcat(room, name);
}
