// Flags and calls that MinGW's header lacks.
#pragma once
#pragma GCC system_header // for include_next
#include <cerrno>
#include_next <fcntl.h>
#include <sys/types.h>

#define O_CLOEXEC _O_NOINHERIT
#define O_NOFOLLOW 0x1000000
#define O_DIRECTORY 0x2000000
#define O_NONBLOCK 0
#define O_NOCTTY 0
#define AT_REMOVEDIR 1
#define FALLOC_FL_KEEP_SIZE 1
#ifndef EDQUOT
#define EDQUOT 10069
#endif

int openat(int folder, const char* name, int flags, int mode = 0);
int fallocate(int file, int mode, off_t from, off_t bytes);
