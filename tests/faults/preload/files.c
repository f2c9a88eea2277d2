// The functions of the system that touch files, in place of those of the C library.
#define _GNU_SOURCE
#include "inside.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

void* __libc_malloc(size_t);

#define NEXT(name) ((__typeof__(&name))next_symbol(#name)) // what would be called without us

enum {
  CAN_INTERRUPT = 1u << FAULT_INTERRUPTED,
  CAN_FILL = 1u << FAULT_FULL,
  ON_READ = 1u << FAULT_SHORT | 1u << FAULT_INTERRUPTED | 1u << FAULT_FLIPPED,
  ON_WRITE = 1u << FAULT_SHORT | 1u << FAULT_INTERRUPTED | 1u << FAULT_FULL | 1u << FAULT_TORN | 1u << FAULT_HALF |
             1u << FAULT_FLIPPED | 1u << FAULT_LOST | 1u << FAULT_LATE
};

// What the fault makes of an operation that either is done or fails; 0: it is done.
static int error_of(int kind) {
  switch (kind) {
  case FAULT_FAIL: return EIO;
  case FAULT_INTERRUPTED: return EINTR;
  case FAULT_FULL: return ENOSPC;
  default: return 0;
  }
}

// An operation on a name (or two) that returns 0 or -1.
#define ON_NAME(op, applies, folder, name, folder2, name2, call)                                                               \
  char room[MOST_PATH], room2[MOST_PATH];                                                                                      \
  struct operation o;                                                                                                          \
  const char* second = name2;                                                                                                  \
  begin_operation(&o, op, -1, absolute_path(folder, name, room), second ? absolute_path(folder2, second, room2) : NULL,        \
                  applies);                                                                                                    \
  int error = error_of(o.kind);                                                                                                \
  const long result = error ? -1 : (long)(call);                                                                               \
  if (result < 0 && !error) error = errno;                                                                                     \
  end_operation(&o, result < 0 ? error : 0);                                                                                   \
  return (int)result

// The same on an open file.
#define ON_FILE(op, applies, file, length, call)                                                                               \
  struct operation o;                                                                                                          \
  begin_operation(&o, op, file, path_of(file), NULL, applies);                                                                 \
  o.record.offset = (uint64_t)(length);                                                                                        \
  int error = error_of(o.kind);                                                                                                \
  const long result = error ? -1 : (long)(call);                                                                               \
  if (result < 0 && !error) error = errno;                                                                                     \
  end_operation(&o, result < 0 ? error : 0);                                                                                   \
  return (int)result

// ---------------------------------------------------------------- open and close
static bool exists(const char* path) { return syscall(SYS_faccessat, AT_FDCWD, path, F_OK) == 0; }

static int open_file(int folder, const char* name, int flags, mode_t mode) {
  char room[MOST_PATH];
  struct operation o;
  if (told_free_memory() && strcmp(name, "/proc/meminfo") == 0) return errno = ENOENT, -1;
  const char* path = absolute_path(folder, name, room);
  const bool creates = path && (flags & O_CREAT) != 0 && !exists(path);
  begin_operation(&o, OP_OPEN, -1, path, NULL, CAN_INTERRUPT | (creates ? (unsigned)CAN_FILL : 0u));
  int error = error_of(o.kind);
  const long file = error ? -1 : syscall(SYS_openat, folder, name, flags, mode);
  if (file < 0 && !error) error = errno;
  if (file >= 0 && path) keep_path((int)file, path);
  o.record.file = (int)file;
  o.record.flags = (creates ? OPENED_CREATES : 0) | ((flags & O_TRUNC) != 0 ? OPENED_TRUNCATES : 0);
  end_operation(&o, file < 0 ? error : 0);
  return (int)file;
}

static mode_t mode_of(int flags, va_list list) { return (flags & O_CREAT) != 0 ? va_arg(list, mode_t) : 0; }

#define OPEN(name)                                                                                                             \
  int name(const char* path, int flags, ...) {                                                                                 \
    va_list list;                                                                                                              \
    va_start(list, flags);                                                                                                     \
    const mode_t mode = mode_of(flags, list);                                                                                  \
    va_end(list);                                                                                                              \
    return open_file(AT_FDCWD, path, flags, mode);                                                                             \
  }
#define OPENAT(name)                                                                                                           \
  int name(int folder, const char* path, int flags, ...) {                                                                     \
    va_list list;                                                                                                              \
    va_start(list, flags);                                                                                                     \
    const mode_t mode = mode_of(flags, list);                                                                                  \
    va_end(list);                                                                                                              \
    return open_file(folder, path, flags, mode);                                                                               \
  }
OPEN(open)
OPEN(open64)
OPENAT(openat)
OPENAT(openat64)

// (only for reading: what the program writes it writes without stdio)
static FILE* open_stream(const char* path, const char* mode) {
  if (mode[0] != 'r' || strchr(mode, '+')) return NEXT(fopen64)(path, mode);
  const int file = open_file(AT_FDCWD, path, O_RDONLY | O_CLOEXEC, 0);
  return file < 0 ? NULL : fdopen(file, mode);
}
FILE* fopen(const char* path, const char* mode) { return open_stream(path, mode); }
FILE* fopen64(const char* path, const char* mode) { return open_stream(path, mode); }

static void put_late(int file);
int close(int file) {
  struct operation o;
  put_late(file);
  begin_operation(&o, OP_CLOSE, file, path_of(file), NULL, CAN_INTERRUPT);
  const int done = (int)syscall(SYS_close, file), own = errno, error = error_of(o.kind);
  end_operation(&o, error ? error : done < 0 ? own : 0);
  if (file > 2) keep_path(file, "");
  return error ? -1 : done;
}

// ---------------------------------------------------------------- transfers
static void flip(void* data, size_t bytes) {
  if (bytes > 0) ((unsigned char*)data)[bytes / 2] ^= 0x10;
}

static ssize_t read_at(int file, void* data, size_t bytes, off64_t offset) {
  struct operation o;
  begin_operation(&o, OP_READ, file, path_of(file), NULL, ON_READ);
  int error = error_of(o.kind);
  const size_t wanted = o.kind == FAULT_SHORT && bytes > 1 ? bytes / 2 : bytes;
  ssize_t got = -1;
  if (!error && offset < 0) got = syscall(SYS_read, file, data, wanted);
  if (!error && offset >= 0) got = NEXT(pread64)(file, data, wanted, offset);
  if (got < 0 && !error) error = errno;
  if (got > 0 && o.kind == FAULT_FLIPPED) flip(data, (size_t)got);
  o.record.bytes = got > 0 ? (uint64_t)got : 0;
  end_operation(&o, got < 0 ? error : 0);
  return got;
}
ssize_t read(int file, void* data, size_t bytes) { return read_at(file, data, bytes, -1); }
ssize_t pread(int file, void* data, size_t bytes, off_t offset) { return read_at(file, data, bytes, offset); }
ssize_t pread64(int file, void* data, size_t bytes, off64_t offset) { return read_at(file, data, bytes, offset); }

static ssize_t put_at(int file, const void* data, size_t bytes, off64_t offset) {
  if (offset < 0) return syscall(SYS_write, file, data, bytes);
  return NEXT(pwrite64)(file, data, bytes, offset);
}

static ssize_t put_flipped(int file, const void* data, size_t bytes, off64_t offset) {
  static char copy[1 << 22];
  if (bytes > sizeof copy) abort();
  memcpy(copy, data, bytes);
  flip(copy, bytes);
  return put_at(file, copy, bytes, offset);
}

// Writes that wait for the next sync of their file, or for its end.
static struct late {
  int file;
  size_t bytes;
  off64_t offset;
  void* data;
} late[512];
static int late_ones;

static void put_late(int file) {
  for (int i = 0; i < late_ones; ++i) {
    if (late[i].file != file) continue;
    (void)!NEXT(pwrite64)(file, late[i].data, late[i].bytes, late[i].offset);
    late[i].file = -1;
  }
}

static ssize_t keep_for_later(int file, const void* data, size_t bytes, off64_t offset) {
  if (late_ones == sizeof late / sizeof late[0]) put_late(file), late_ones = 0;
  struct late* l = &late[late_ones++];
  l->file = file, l->bytes = bytes;
  l->offset = offset >= 0 ? offset : lseek64(file, 0, SEEK_CUR);
  l->data = __libc_malloc(bytes > 0 ? bytes : 1);
  memcpy(l->data, data, bytes);
  if (offset < 0) lseek64(file, (off64_t)bytes, SEEK_CUR);
  return (ssize_t)bytes;
}

static ssize_t write_struck(int kind, int file, const void* data, size_t bytes, off64_t offset) {
  const size_t half = bytes > 1 ? bytes / 2 : kind == FAULT_SHORT ? bytes : 0; /* (of none, none) */
  switch (kind) {
  case FAULT_SHORT: return put_at(file, data, half, offset);
  case FAULT_FLIPPED: return put_flipped(file, data, bytes, offset);
  case FAULT_LATE: return keep_for_later(file, data, bytes, offset);
  case FAULT_LOST:
  case FAULT_HALF:
    if (kind == FAULT_HALF && put_at(file, data, half, offset) < 0) return -1;
    if (offset < 0) lseek64(file, (off64_t)(kind == FAULT_HALF ? bytes - half : bytes), SEEK_CUR);
    return (ssize_t)bytes;
  case FAULT_TORN:
    (void)!put_at(file, data, half, offset);
    kill(getpid(), SIGKILL);
    return -1;
  default: return put_at(file, data, bytes, offset);
  }
}

static ssize_t write_at(int file, const void* data, size_t bytes, off64_t offset) {
  if (file == 2) return syscall(SYS_write, file, data, bytes);
  struct operation o;
  begin_operation(&o, OP_WRITE, file, path_of(file), NULL, ON_WRITE);
  int error = error_of(o.kind);
  const off64_t place = offset >= 0 ? offset : lseek64(file, 0, SEEK_CUR);
  const ssize_t put = error ? -1 : write_struck(o.kind, file, data, bytes, offset);
  if (put < 0 && !error) error = errno;
  o.record.offset = place < 0 ? 0 : (uint64_t)place;
  o.record.bytes = put > 0 ? (uint64_t)put : 0;
  o.data = data;
  end_operation(&o, put < 0 ? error : 0);
  return put;
}
ssize_t write(int file, const void* data, size_t bytes) { return write_at(file, data, bytes, -1); }
ssize_t pwrite(int file, const void* data, size_t bytes, off_t offset) { return write_at(file, data, bytes, offset); }
ssize_t pwrite64(int file, const void* data, size_t bytes, off64_t offset) { return write_at(file, data, bytes, offset); }

// One part after the other.
ssize_t writev(int file, const struct iovec* part, int parts) {
  ssize_t sum = 0;
  for (int i = 0; i < parts; ++i) {
    const ssize_t put = part[i].iov_len > 0 ? write(file, part[i].iov_base, part[i].iov_len) : 0;
    if (put < 0) return sum > 0 ? sum : put;
    sum += put;
    if ((size_t)put < part[i].iov_len) break;
  }
  return sum;
}

// ---------------------------------------------------------------- made safe, made room for
// Nothing is lost while the machine runs: it need not be done.
int fsync(int file) { ON_FILE(OP_SYNC, (unsigned)CAN_INTERRUPT | CAN_FILL, file, 0, (put_late(file), 0)); }
int fdatasync(int file) { return fsync(file); }

int flock(int file, int how) { ON_FILE(OP_LOCK, CAN_INTERRUPT, file, 0, syscall(SYS_flock, file, how)); }

int ftruncate(int file, off_t length) { ON_FILE(OP_TRUNCATE, CAN_INTERRUPT, file, length, NEXT(ftruncate64)(file, length)); }
int ftruncate64(int file, off64_t length) {
  ON_FILE(OP_TRUNCATE, CAN_INTERRUPT, file, length, NEXT(ftruncate64)(file, length));
}

static int reserve(int file, off64_t offset, off64_t bytes) {
  struct operation o;
  begin_operation(&o, OP_RESERVE, file, path_of(file), NULL, (unsigned)CAN_INTERRUPT | CAN_FILL);
  o.record.offset = (uint64_t)(offset + bytes);
  int error = error_of(o.kind);
  if (!error) error = NEXT(posix_fallocate64)(file, offset, bytes);
  end_operation(&o, error);
  return error;
}
int fallocate(int file, int mode, off_t offset, off_t bytes) {
  ON_FILE(OP_RESERVE, (unsigned)CAN_INTERRUPT | CAN_FILL, file, (mode & FALLOC_FL_KEEP_SIZE) != 0 ? 0 : offset + bytes,
          syscall(SYS_fallocate, file, mode, offset, bytes));
}
int fallocate64(int file, int mode, off64_t offset, off64_t bytes) { return fallocate(file, mode, offset, bytes); }
int posix_fallocate(int file, off_t offset, off_t bytes) { return reserve(file, offset, bytes); }
int posix_fallocate64(int file, off64_t offset, off64_t bytes) { return reserve(file, offset, bytes); }

int fchmod(int file, mode_t mode) { ON_FILE(OP_MODE, 0, file, 0, syscall(SYS_fchmod, file, mode)); }

// ---------------------------------------------------------------- names
int rename(const char* from, const char* to) {
  ON_NAME(OP_RENAME, CAN_FILL, AT_FDCWD, from, AT_FDCWD, to, syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}
int renameat(int folder, const char* from, int folder2, const char* to) {
  ON_NAME(OP_RENAME, CAN_FILL, folder, from, folder2, to, syscall(SYS_renameat2, folder, from, folder2, to, 0));
}
int link(const char* from, const char* to) {
  ON_NAME(OP_LINK, CAN_FILL, AT_FDCWD, from, AT_FDCWD, to, syscall(SYS_linkat, AT_FDCWD, from, AT_FDCWD, to, 0));
}
int linkat(int folder, const char* from, int folder2, const char* to, int flags) {
  ON_NAME(OP_LINK, CAN_FILL, folder, from, folder2, to, syscall(SYS_linkat, folder, from, folder2, to, flags));
}
int unlinkat(int folder, const char* name, int flags) {
  const int op = (flags & AT_REMOVEDIR) != 0 ? OP_RMDIR : OP_UNLINK;
  ON_NAME(op, 0, folder, name, AT_FDCWD, NULL, syscall(SYS_unlinkat, folder, name, flags));
}
int unlink(const char* name) { return unlinkat(AT_FDCWD, name, 0); }
int rmdir(const char* name) { return unlinkat(AT_FDCWD, name, AT_REMOVEDIR); }
int mkdirat(int folder, const char* name, mode_t mode) {
  ON_NAME(OP_MKDIR, CAN_FILL, folder, name, AT_FDCWD, NULL, syscall(SYS_mkdirat, folder, name, mode));
}
int mkdir(const char* name, mode_t mode) { return mkdirat(AT_FDCWD, name, mode); }

// The name that is made is always the same one; a second run finds it taken, and takes another.
char* mkdtemp(char* pattern) {
  char* end = pattern + strlen(pattern) - 6;
  for (int i = 0; i < 1000; ++i) {
    char number[7];
    snprintf(number, sizeof number, "%06d", i);
    memcpy(end, number, 6);
    if (mkdir(pattern, 0700) == 0) return pattern;
    if (errno != EEXIST) return NULL;
  }
  return NULL;
}

// ---------------------------------------------------------------- looks
int stat(const char* name, struct stat* out) { ON_NAME(OP_LOOK, 0, AT_FDCWD, name, AT_FDCWD, NULL, NEXT(stat)(name, out)); }
int stat64(const char* name, struct stat64* out) {
  ON_NAME(OP_LOOK, 0, AT_FDCWD, name, AT_FDCWD, NULL, NEXT(stat64)(name, out));
}
int lstat(const char* name, struct stat* out) { ON_NAME(OP_LOOK, 0, AT_FDCWD, name, AT_FDCWD, NULL, NEXT(lstat)(name, out)); }
int lstat64(const char* name, struct stat64* out) {
  ON_NAME(OP_LOOK, 0, AT_FDCWD, name, AT_FDCWD, NULL, NEXT(lstat64)(name, out));
}
int fstatat(int folder, const char* name, struct stat* out, int flags) {
  ON_NAME(OP_LOOK, 0, folder, name, AT_FDCWD, NULL, NEXT(fstatat)(folder, name, out, flags));
}
int fstatat64(int folder, const char* name, struct stat64* out, int flags) {
  ON_NAME(OP_LOOK, 0, folder, name, AT_FDCWD, NULL, NEXT(fstatat64)(folder, name, out, flags));
}
int fstat(int file, struct stat* out) { ON_FILE(OP_LOOK, 0, file, 0, NEXT(fstat)(file, out)); }
int fstat64(int file, struct stat64* out) { ON_FILE(OP_LOOK, 0, file, 0, NEXT(fstat64)(file, out)); }
int access(const char* name, int how) {
  ON_NAME(OP_LOOK, 0, AT_FDCWD, name, AT_FDCWD, NULL, syscall(SYS_faccessat, AT_FDCWD, name, how));
}
int faccessat(int folder, const char* name, int how, int flags) {
  ON_NAME(OP_LOOK, 0, folder, name, AT_FDCWD, NULL, NEXT(faccessat)(folder, name, how, flags));
}
int statvfs(const char* name, struct statvfs* out) {
  ON_NAME(OP_LOOK, 0, AT_FDCWD, name, AT_FDCWD, NULL, NEXT(statvfs)(name, out));
}
int fstatvfs(int file, struct statvfs* out) { ON_FILE(OP_LOOK, 0, file, 0, NEXT(fstatvfs)(file, out)); }
ssize_t readlink(const char* name, char* out, size_t bytes) {
  ON_NAME(OP_LOOK, 0, AT_FDCWD, name, AT_FDCWD, NULL, syscall(SYS_readlinkat, AT_FDCWD, name, out, bytes));
}

char* realpath(const char* name, char* out) {
  char room[MOST_PATH];
  struct operation o;
  begin_operation(&o, OP_LOOK, -1, absolute_path(AT_FDCWD, name, room), NULL, 0);
  int error = error_of(o.kind);
  char* result = error ? NULL : NEXT(realpath)(name, out);
  if (!result && !error) error = errno;
  end_operation(&o, result ? 0 : error);
  return result;
}

DIR* opendir(const char* name) {
  const int file = open_file(AT_FDCWD, name, O_RDONLY | O_DIRECTORY | O_CLOEXEC, 0);
  return file < 0 ? NULL : fdopendir(file);
}
