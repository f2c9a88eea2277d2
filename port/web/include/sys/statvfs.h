/* Room on a disk, which a page has not: nothing is told, and the program goes on as where the system tells nothing. */
#pragma once
struct statvfs {
  unsigned long f_blocks, f_frsize, f_bavail;
};
static inline int fstatvfs(int file, struct statvfs* out) {
  (void)file, (void)out;
  return -1;
}
