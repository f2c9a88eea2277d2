// Signals that come from the console: Ctrl-C, Ctrl-Break (SIGTERM), its closing (SIGHUP). They come in a thread of their own.
#pragma once
#pragma GCC system_header // for include_next
#include_next <signal.h>

#ifdef __cplusplus
#define SIGHUP 1
#define SIGPIPE 13
#define SIGXFSZ 25
#define SA_RESETHAND 0x80000000u
#ifndef _POSIX
typedef unsigned long long sigset_t;
#endif
#ifndef SIG_SETMASK
#define SIG_SETMASK 2
#endif

struct sigaction {
  void (*sa_handler)(int);
  int sa_flags;
  sigset_t sa_mask;
};
int sigaction(int number, const struct sigaction* action, struct sigaction* old);
inline int sigemptyset(sigset_t* set) { return *set = 0, 0; }
#undef pthread_sigmask
inline int pthread_sigmask(int, const sigset_t*, sigset_t*) { return 0; }
inline int sigfillset(sigset_t* set) { return *set = ~0ull, 0; }
#endif
