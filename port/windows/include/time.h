// The calls of threads are among MinGW's own.
#pragma once
#pragma GCC system_header // for include_next
#ifndef _POSIX_THREAD_SAFE_FUNCTIONS
#define _POSIX_THREAD_SAFE_FUNCTIONS 200112L
#endif
#include_next <time.h>
