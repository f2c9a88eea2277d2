/* Free space of a disk, which a page has not: none is reported, as on systems without that information. */
#pragma once
struct statvfs {
  unsigned long f_blocks, f_frsize, f_bavail;
};
static inline int fstatvfs(int file, struct statvfs* out) {
  (void)file, (void)out;
  return -1;
}
