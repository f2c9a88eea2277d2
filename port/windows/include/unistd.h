// What MinGW's header lacks, by port/windows/system.cpp. close, unlink, rmdir, rename, access and isatty are declared there as
// everywhere; ours take the place of the C library's when the program is linked.
#pragma once
#pragma GCC system_header // for include_next
#include <sys/types.h>
#include_next <unistd.h>

// (of size_t, and so not the C library's)
ssize_t read(int file, void* data, size_t bytes);
ssize_t write(int file, const void* data, size_t bytes);
ssize_t pread(int file, void* data, size_t bytes, off_t at);
ssize_t pwrite(int file, const void* data, size_t bytes, off_t at);
int fsync(int file);
int unlinkat(int folder, const char* name, int flags);

// (of stdlib.h elsewhere, whose place is taken by the C++ library's)
char* realpath(const char* name, char* none);
char* mkdtemp(char* pattern);

#define _SC_PAGESIZE 30
#define _SC_AVPHYS_PAGES 86
long sysconf(int what);
