// What a file is, with the numbers that tell one file from another, which the C library's stat has not.
#pragma once
#pragma GCC system_header // for include_next
#include <stdint.h>
#include_next <sys/stat.h>

#undef stat
#undef fstat
#define stat windows_stat
struct windows_stat {
  uint64_t st_dev, st_ino;
  unsigned st_mode;
  uint32_t st_nlink; // 0: removed, and open still
  int64_t st_size, st_blocks;
};
int windows_stat(const char* name, struct windows_stat* about);
int fstat(int file, struct windows_stat* about);
int fchmod(int file, unsigned mode);
int mkdir(const char* name, int mode);
int mkdirat(int folder, const char* name, int mode);
