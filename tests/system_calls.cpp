#ifndef _FILE_OFFSET_BITS
#define _FILE_OFFSET_BITS 64
#endif
#include "system_calls.hpp"

#include <atomic>
#include <mutex>
#include <utility>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dirent.h>
#include <pthread.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/types.h>
#include <unistd.h>

namespace {
std::mutex mutex;
test::SystemJudge judge;
std::atomic<bool> judged{false};
int64_t count = 0;
thread_local bool judging = false; // calls that the judge itself makes are done

int fate_of(const char* name, uint64_t bytes = 0) {
  if (!judged || judging) return test::kDone;
  const std::lock_guard<std::mutex> one(mutex);
  if (!judge) return test::kDone;
  judging = true;
  const int fate = judge({name, ++count, bytes});
  judging = false;
  return fate;
}
} // namespace

namespace test {

SystemCalls::SystemCalls(SystemJudge with) {
  const std::lock_guard<std::mutex> one(mutex);
  judge = std::move(with), count = 0, judged = true;
}
SystemCalls::~SystemCalls() {
  const std::lock_guard<std::mutex> one(mutex);
  judge = nullptr, judged = false;
}

} // namespace test

#if defined(__linux__) && defined(__GLIBC__)

bool test::can_judge_calls() { return true; }

// name, what it returns, that of a failure, its parameters, and what is handed on. (The Makefile reads the names here.)
#define WRAPPED(name, result, failed, parameters, arguments)                                                                   \
  extern "C" result __real_##name parameters;                                                                                  \
  extern "C" result __wrap_##name parameters;                                                                                  \
  extern "C" result __wrap_##name parameters {                                                                                 \
    const int fate = fate_of(#name);                                                                                           \
    if (fate == test::kDone) return __real_##name arguments;                                                                   \
    errno = fate;                                                                                                              \
    return failed;                                                                                                             \
  }
// Those that open files have their rights behind the flags.
WRAPPED(open64, int, -1, (const char* a, int b, mode_t c), (a, b, c))
WRAPPED(openat64, int, -1, (int a, const char* b, int c, mode_t d), (a, b, c, d))
WRAPPED(mkdir, int, -1, (const char* a, mode_t b), (a, b))
WRAPPED(mkdirat, int, -1, (int a, const char* b, mode_t c), (a, b, c))
WRAPPED(fstat64, int, -1, (int a, struct stat* b), (a, b))
WRAPPED(fsync, int, -1, (int a), (a))
WRAPPED(flock, int, -1, (int a, int b), (a, b))
WRAPPED(fallocate64, int, -1, (int a, int b, off_t c, off_t d), (a, b, c, d))
WRAPPED(ftruncate64, int, -1, (int a, off_t b), (a, b))
WRAPPED(unlinkat, int, -1, (int a, const char* b, int c), (a, b, c))
WRAPPED(rmdir, int, -1, (const char* a), (a))
WRAPPED(fdopendir, DIR*, nullptr, (int a), (a))
WRAPPED(malloc, void*, nullptr, (size_t a), (a))
WRAPPED(fopen64, FILE*, nullptr, (const char* a, const char* b), (a, b))
WRAPPED(fseeko64, int, -1, (FILE * a, off_t b, int c), (a, b, c))
WRAPPED(fflush, int, EOF, (FILE * a), (a))
WRAPPED(fread, size_t, 0, (void* a, size_t b, size_t c, FILE* d), (a, b, c, d))
WRAPPED(fwrite, size_t, 0, (const void* a, size_t b, size_t c, FILE* d), (a, b, c, d))
WRAPPED(remove, int, -1, (const char* a), (a))
// The program's, whose files are small.
WRAPPED(open, int, -1, (const char* a, int b, mode_t c), (a, b, c))
WRAPPED(fstat, int, -1, (int a, struct stat* b), (a, b))
WRAPPED(ftruncate, int, -1, (int a, off_t b), (a, b))
WRAPPED(access, int, -1, (const char* a, int b), (a, b))
WRAPPED(realpath, char*, nullptr, (const char* a, char* b), (a, b))
WRAPPED(rename, int, -1, (const char* a, const char* b), (a, b))
WRAPPED(unlink, int, -1, (const char* a), (a))
WRAPPED(opendir, DIR*, nullptr, (const char* a), (a))
WRAPPED(calloc, void*, nullptr, (size_t a, size_t b), (a, b))

// Some do more, or tell a failure otherwise.
extern "C" {
ssize_t __real_read(int file, void* to, size_t bytes);
ssize_t __wrap_read(int file, void* to, size_t bytes);
ssize_t __real_write(int file, const void* from, size_t bytes);
ssize_t __wrap_write(int file, const void* from, size_t bytes);
ssize_t __real_pread(int file, void* to, size_t bytes, off_t at);
ssize_t __wrap_pread(int file, void* to, size_t bytes, off_t at);
ssize_t __real_pread64(int file, void* to, size_t bytes, off_t at);
ssize_t __wrap_pread64(int file, void* to, size_t bytes, off_t at);
ssize_t __real_pwrite64(int file, const void* from, size_t bytes, off_t at);
ssize_t __wrap_pwrite64(int file, const void* from, size_t bytes, off_t at);
int __real_close(int file);
int __wrap_close(int file);
int __real_fclose(FILE* file);
int __wrap_fclose(FILE* file);
int __real_fstatvfs64(int file, struct statvfs* disk);
int __wrap_fstatvfs64(int file, struct statvfs* disk);
int __real_pthread_create(pthread_t* thread, const pthread_attr_t* how, void* (*work)(void*), void* argument);
int __wrap_pthread_create(pthread_t* thread, const pthread_attr_t* how, void* (*work)(void*), void* argument);
long __real_sysconf(int what);
long __wrap_sysconf(int what);
}

namespace {
template <class Move> ssize_t move(const char* name, size_t bytes, Move real) {
  const int fate = fate_of(name, bytes);
  if (fate == test::kPretended) return static_cast<ssize_t>(bytes);
  if (fate < 0) return real(fate == test::kHalf ? (bytes + 1) / 2 : bytes);
  errno = fate;
  return fate == 0 ? 0 : -1;
}
} // namespace
extern "C" ssize_t __wrap_read(int file, void* to, size_t bytes) {
  return move("read", bytes, [=](size_t now) { return __real_read(file, to, now); });
}
extern "C" ssize_t __wrap_write(int file, const void* from, size_t bytes) {
  return move("write", bytes, [=](size_t now) { return __real_write(file, from, now); });
}
extern "C" ssize_t __wrap_pread(int file, void* to, size_t bytes, off_t at) {
  return move("pread", bytes, [=](size_t now) { return __real_pread(file, to, now, at); });
}
extern "C" ssize_t __wrap_pread64(int file, void* to, size_t bytes, off_t at) {
  return move("pread64", bytes, [=](size_t now) { return __real_pread64(file, to, now, at); });
}
extern "C" ssize_t __wrap_pwrite64(int file, const void* from, size_t bytes, off_t at) {
  return move("pwrite64", bytes, [=](size_t now) { return __real_pwrite64(file, from, now, at); });
}

// A failed one has closed it all the same.
extern "C" int __wrap_close(int file) {
  const int fate = fate_of("close"), closed = __real_close(file);
  if (fate == test::kDone) return closed;
  errno = fate;
  return -1;
}
extern "C" int __wrap_fclose(FILE* file) {
  const int fate = fate_of("fclose"), closed = __real_fclose(file);
  if (fate == test::kDone) return closed;
  errno = fate;
  return EOF;
}

// 0: it is no file system that counts.
extern "C" int __wrap_fstatvfs64(int file, struct statvfs* disk) {
  const int fate = fate_of("fstatvfs64");
  if (fate == test::kDone) return __real_fstatvfs64(file, disk);
  std::memset(disk, 0, sizeof *disk);
  errno = fate;
  return fate == 0 ? 0 : -1;
}

extern "C" long __wrap_sysconf(int what) {
  // The program asks for memory; sanitizers ask for other things when a thread begins.
  const bool is_ours = what == _SC_AVPHYS_PAGES || what == _SC_PAGESIZE;
  const int fate = is_ours ? fate_of("sysconf") : test::kDone;
  if (fate == test::kDone) return __real_sysconf(what);
  errno = fate;
  return -1;
}
extern "C" int __wrap_pthread_create(pthread_t* thread, const pthread_attr_t* how, void* (*work)(void*), void* argument) {
  const int fate = fate_of("pthread_create");
  return fate == test::kDone ? __real_pthread_create(thread, how, work, argument) : fate == 0 ? EAGAIN : fate;
}

#else

bool test::can_judge_calls() { return false; }

#endif
