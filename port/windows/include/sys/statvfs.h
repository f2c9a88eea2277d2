// The room on a disk.
#pragma once
#include <stdint.h>

struct statvfs {
  uint64_t f_blocks, f_frsize, f_bavail;
};
int fstatvfs(int file, struct statvfs* disk);
