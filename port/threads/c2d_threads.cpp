#include "c2d_threads.h"

#include <errno.h>
#include <fenv.h>
#include <pthread.h>
#include <signal.h>
#include <string.h>

namespace {

// A ticket encodes the call of parallel_for, its number of tasks and the next task in one number: whoever takes a task
// atomically knows that its call is still active and its fields are valid.
constexpr uint64_t kTaskBits = 20, kMostTasks = (uint64_t(1) << kTaskBits) - 1;
uint64_t ticket_of(uint64_t call, uint64_t tasks) { return call << (2 * kTaskBits) | tasks << kTaskBits; }
uint64_t tasks_of(uint64_t ticket) { return ticket >> kTaskBits & kMostTasks; }
uint64_t next_of(uint64_t ticket) { return ticket & kMostTasks; }
bool has_task(uint64_t ticket) { return next_of(ticket) < tasks_of(ticket); }

// Polls before a waiting thread sleeps: some hundred microseconds, with a pause of some tens of cycles. Waking it takes thirty
// microseconds, and between two steps of an elimination of some hundred unknowns one thread works alone for as long.
constexpr int32_t kQuestions = 5000;

struct Pool {
  int32_t threads;
  uint64_t call, ticket; // ticket: atomic
  int32_t left;          // tasks of this call that have not ended; atomic
  int32_t first;         // the number of the call's first task
  void (*task)(void*, int32_t);
  void* argument;
  fenv_t environment;
  int32_t sleeping, waits, ended; // atomic: number of sleeping threads; the caller waits; the threads must end
  pthread_mutex_t mutex;
  pthread_cond_t work, done;
  c2d_port inner;
  pthread_t thread[C2D_THREADS_MOST];
};
static_assert(sizeof(Pool) <= sizeof(c2d_threads) && alignof(Pool) <= alignof(c2d_threads), "the pool has room");

Pool& pool_of(void* pool) { return *static_cast<Pool*>(pool); }

template <class T> T look(const T& x) { return __atomic_load_n(&x, __ATOMIC_SEQ_CST); }
template <class T> void put(T& x, T value) { __atomic_store_n(&x, value, __ATOMIC_SEQ_CST); }

void pause() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#endif
}

// Runs one task of the current call, if one is left. Other threads use the floating-point environment of the caller.
bool take_task(Pool& pool, bool caller) {
  uint64_t ticket = look(pool.ticket);
  while (has_task(ticket)) {
    if (!__atomic_compare_exchange_n(&pool.ticket, &ticket, ticket + 1, false, __ATOMIC_SEQ_CST, __ATOMIC_SEQ_CST)) continue;
    if (!caller) fesetenv(&pool.environment);
    pool.task(pool.argument, pool.first + static_cast<int32_t>(next_of(ticket)));
    if (__atomic_sub_fetch(&pool.left, 1, __ATOMIC_SEQ_CST) == 0 && look(pool.waits) != 0) {
      pthread_mutex_lock(&pool.mutex);
      pthread_cond_signal(&pool.done);
      pthread_mutex_unlock(&pool.mutex);
    }
    return true;
  }
  return false;
}

void sleep_until_work(Pool& pool) {
  pthread_mutex_lock(&pool.mutex);
  __atomic_add_fetch(&pool.sleeping, 1, __ATOMIC_SEQ_CST);
  while (!has_task(look(pool.ticket)) && look(pool.ended) == 0) pthread_cond_wait(&pool.work, &pool.mutex);
  __atomic_sub_fetch(&pool.sleeping, 1, __ATOMIC_SEQ_CST);
  pthread_mutex_unlock(&pool.mutex);
}

void* work(void* argument) {
  Pool& pool = pool_of(argument);
  int32_t asked = 0;
  while (look(pool.ended) == 0) {
    if (take_task(pool, false)) {
      asked = 0;
    } else if (++asked < kQuestions) {
      pause();
    } else {
      sleep_until_work(pool);
      asked = 0;
    }
  }
  return nullptr;
}

void wait_for_tasks(Pool& pool) {
  for (int32_t asked = 0; look(pool.left) != 0 && asked < kQuestions; ++asked) pause();
  if (look(pool.left) == 0) return;
  pthread_mutex_lock(&pool.mutex);
  put(pool.waits, 1);
  while (look(pool.left) != 0) pthread_cond_wait(&pool.done, &pool.mutex);
  put(pool.waits, 0);
  pthread_mutex_unlock(&pool.mutex);
}

void wake(Pool& pool) {
  pthread_mutex_lock(&pool.mutex);
  pthread_cond_broadcast(&pool.work);
  pthread_mutex_unlock(&pool.mutex);
}

// A call with no more tasks than a ticket can count.
void run(Pool& pool, int32_t first, int32_t n, void (*task)(void*, int32_t), void* argument) {
  pool.first = first;
  pool.task = task;
  pool.argument = argument;
  put(pool.left, n);
  put(pool.ticket, ticket_of(++pool.call, static_cast<uint64_t>(n)));
  if (look(pool.sleeping) != 0) wake(pool);
  while (take_task(pool, true)) {
  }
  wait_for_tasks(pool);
}

// ---- a port wrapped by the pool ---------------------------------------------------------------------------------------

c2d_port& inner(void* context) { return pool_of(context).inner; }
int32_t open(void* c, int32_t tape, uint64_t blocks, uint64_t bytes) {
  return inner(c).open(inner(c).context, tape, blocks, bytes);
}
int32_t read(void* c, int32_t tape, uint64_t block, void* data, uint64_t bytes) {
  return inner(c).read(inner(c).context, tape, block, data, bytes);
}
int32_t write(void* c, int32_t tape, uint64_t block, const void* data, uint64_t bytes) {
  return inner(c).write(inner(c).context, tape, block, data, bytes);
}
int32_t sync(void* c, int32_t tape) { return inner(c).sync(inner(c).context, tape); }
int32_t close(void* c, int32_t tape) { return inner(c).close(inner(c).context, tape); }
int32_t start_read(void* c, int32_t tape, uint64_t block, void* data, uint64_t bytes, int32_t* ticket) {
  return inner(c).start_read(inner(c).context, tape, block, data, bytes, ticket);
}
int32_t start_write(void* c, int32_t tape, uint64_t block, const void* data, uint64_t bytes, int32_t* ticket) {
  return inner(c).start_write(inner(c).context, tape, block, data, bytes, ticket);
}
int32_t wait(void* c, int32_t ticket) { return inner(c).wait(inner(c).context, ticket); }
void parallel_for(void* c, int32_t n, void (*task)(void*, int32_t), void* argument) {
  c2d_threads_run(static_cast<c2d_threads*>(c), n, task, argument);
}
void progress(void* c, const c2d_progress* now) { inner(c).progress(inner(c).context, now); }
int32_t cancel(void* c) { return inner(c).cancel(inner(c).context); }
void log(void* c, const c2d_error* entry) { inner(c).log(inner(c).context, entry); }
double clock(void* c) { return inner(c).clock(inner(c).context); }

template <class F> void forward(F& function, F by) {
  if (function) function = by;
}

} // namespace

extern "C" int32_t c2d_threads_start(c2d_threads* room, int32_t threads) {
  if (threads < 1 || threads > C2D_THREADS_MOST) return EINVAL;
  memset(room, 0, sizeof *room);
  Pool& pool = pool_of(room);
  pool.threads = 1;
  pthread_mutex_init(&pool.mutex, nullptr);
  pthread_cond_init(&pool.work, nullptr);
  pthread_cond_init(&pool.done, nullptr);
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  int code = 0;
  for (; pool.threads < threads && code == 0; pool.threads += code == 0)
    code = pthread_create(&pool.thread[pool.threads], nullptr, work, room);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  if (code != 0) c2d_threads_stop(room);
  return code;
}

extern "C" void c2d_threads_port(c2d_threads* room, c2d_port* out) {
  Pool& pool = pool_of(room);
  pool.inner = *out;
  out->context = room;
  forward(out->open, open);
  forward(out->read, read);
  forward(out->write, write);
  forward(out->sync, sync);
  forward(out->close, close);
  forward(out->start_read, start_read);
  forward(out->start_write, start_write);
  forward(out->wait, wait);
  forward(out->progress, progress);
  forward(out->cancel, cancel);
  forward(out->log, log);
  forward(out->clock, clock);
  out->parallel_for = parallel_for;
  out->threads = pool.threads;
}

extern "C" void c2d_threads_run(c2d_threads* room, int32_t n, c2d_threads_task task, void* argument) {
  Pool& pool = pool_of(room);
  fegetenv(&pool.environment);
  const int32_t most = static_cast<int32_t>(kMostTasks);
  for (int32_t first = 0; first < n; first += most) run(pool, first, n - first < most ? n - first : most, task, argument);
}

extern "C" void c2d_threads_stop(c2d_threads* room) {
  Pool& pool = pool_of(room);
  put(pool.ended, 1);
  wake(pool);
  for (int32_t i = 1; i < pool.threads; ++i) pthread_join(pool.thread[i], nullptr);
  pool.threads = 1;
  pthread_cond_destroy(&pool.done);
  pthread_cond_destroy(&pool.work);
  pthread_mutex_destroy(&pool.mutex);
}
