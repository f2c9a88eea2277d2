#include "transfers.hpp"
#include <atomic>
#include <new>
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdlib.h>

namespace {

constexpr int32_t kSlots = 4;     // more are never asked for at once
constexpr int32_t kDone = -1;     // ticket of what was done at once
constexpr int32_t kPatience = 64; // looks for news, the processor offered in between, before a thread goes to sleep

enum State : int32_t { idle, asked, done }; // asked: in the queue, or being done

struct Slot {
  PosixTransfer transfer;
  int32_t code;
  std::atomic<int32_t> state;
};

// Only the caller adds to the queue. The thread takes from it, and so does a caller that has to wait: on a busy machine
// the thread may not have a processor yet. A thread without work for a while sets a flag and sleeps; whoever adds
// work checks, after publishing it, whether the other sleeps. With sequentially consistent operations at least one
// of them sees the change of the other.
struct Helper {
  c2d_posix_store* store;
  pthread_t thread;
  pthread_mutex_t mutex;
  pthread_cond_t for_thread, for_caller;
  Slot slot[kSlots];
  std::atomic<int32_t> queue[kSlots];
  std::atomic<uint32_t> put, taken; // how many ever
  std::atomic<bool> thread_sleeps, caller_sleeps, stop;
};

Helper* helper_of(c2d_posix_store* store) { return static_cast<Helper*>(store->helper); }

template <class News> void await(Helper* h, pthread_cond_t* bell, std::atomic<bool>* sleeps, News is_there) {
  for (int32_t look = 0; look < kPatience; ++look) {
    if (is_there()) return;
    sched_yield();
  }
  pthread_mutex_lock(&h->mutex);
  sleeps->store(true);
  while (!is_there()) pthread_cond_wait(bell, &h->mutex);
  sleeps->store(false);
  pthread_mutex_unlock(&h->mutex);
}

void wake(Helper* h, pthread_cond_t* bell, const std::atomic<bool>& sleeps) {
  if (!sleeps.load()) return;
  pthread_mutex_lock(&h->mutex);
  pthread_cond_signal(bell);
  pthread_mutex_unlock(&h->mutex);
}

void* work(void* argument) {
  Helper* h = static_cast<Helper*>(argument);
  for (;;) {
    uint32_t mine = 0;
    await(h, &h->for_thread, &h->thread_sleeps, [h, &mine] {
      mine = h->taken.load();
      return h->put.load() != mine || h->stop.load();
    });
    if (h->put.load() == mine) return nullptr; // to stop, and nothing is left
    Slot& slot = h->slot[h->queue[mine % kSlots].load()];
    if (!h->taken.compare_exchange_strong(mine, mine + 1)) continue; // the caller was quicker
    slot.code = do_posix_transfer(h->store, slot.transfer);
    slot.state.store(done);
    wake(h, &h->for_caller, h->caller_sleeps);
  }
}

// Is no transfer of this block active?
bool is_alone(const Helper* h, int32_t i) {
  const PosixTransfer& own = h->slot[i].transfer;
  for (int32_t other = 0; other < kSlots; ++other) {
    const PosixTransfer& t = h->slot[other].transfer;
    if (other != i && h->slot[other].state.load() == asked && t.tape == own.tape && t.block == own.block) return false;
  }
  return true;
}

// The caller executes the first transfer of the queue. False: none is left, only waiting.
bool lend_a_hand(Helper* h) {
  uint32_t mine = h->taken.load();
  if (h->put.load() == mine) return false;
  const int32_t i = h->queue[mine % kSlots].load();
  if (!is_alone(h, i) || !h->taken.compare_exchange_strong(mine, mine + 1)) return false;
  h->slot[i].code = do_posix_transfer(h->store, h->slot[i].transfer);
  h->slot[i].state.store(done);
  return true;
}

// Signals are left to the threads of the caller.
bool start_thread(Helper* h) {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  const bool started = pthread_create(&h->thread, nullptr, work, h) == 0;
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return started;
}

void discard(Helper* h) {
  pthread_cond_destroy(&h->for_caller);
  pthread_cond_destroy(&h->for_thread);
  pthread_mutex_destroy(&h->mutex);
  free(h);
}

Helper* make_helper(c2d_posix_store* store) {
  void* memory = malloc(sizeof(Helper));
  if (!memory) return nullptr;
  Helper* h = new (memory) Helper{};
  h->store = store;
  pthread_mutex_init(&h->mutex, nullptr);
  pthread_cond_init(&h->for_thread, nullptr);
  pthread_cond_init(&h->for_caller, nullptr);
  if (start_thread(h)) return h;
  discard(h);
  return nullptr;
}

} // namespace

int32_t start_posix_transfer(c2d_posix_store* store, const PosixTransfer& transfer, int32_t* ticket) {
  *ticket = kDone;
  if (!store->helper) store->helper = make_helper(store);
  Helper* h = helper_of(store);
  if (!h) return do_posix_transfer(store, transfer);
  for (int32_t i = 0; i < kSlots; ++i) {
    Slot& slot = h->slot[i];
    if (slot.state.load() != idle) continue;
    slot.transfer = transfer;
    slot.state.store(asked);
    const uint32_t place = h->put.load();
    h->queue[place % kSlots].store(i);
    h->put.store(place + 1);
    wake(h, &h->for_thread, h->thread_sleeps);
    *ticket = i;
    return 0;
  }
  return C2D_POSIX_STORE_TICKET;
}

int32_t wait_posix_transfer(c2d_posix_store* store, int32_t ticket) {
  if (ticket == kDone) return 0;
  Helper* h = helper_of(store);
  if (!h || ticket < 0 || ticket >= kSlots || h->slot[ticket].state.load() == idle) return C2D_POSIX_STORE_TICKET;
  Slot& slot = h->slot[ticket];
  while (slot.state.load() != done && lend_a_hand(h)) {
  }
  await(h, &h->for_caller, &h->caller_sleeps, [&slot] { return slot.state.load() == done; });
  slot.state.store(idle);
  return slot.code;
}

void settle_posix_transfers(c2d_posix_store* store, int32_t tape, uint64_t block) {
  Helper* h = helper_of(store);
  for (int32_t i = 0; h && i < kSlots; ++i) {
    Slot& slot = h->slot[i];
    if (slot.state.load() != asked || slot.transfer.tape != tape || slot.transfer.block != block) continue;
    await(h, &h->for_caller, &h->caller_sleeps, [&slot] { return slot.state.load() == done; });
  }
}

void stop_posix_transfers(c2d_posix_store* store) {
  Helper* h = helper_of(store);
  if (!h) return;
  h->stop.store(true);
  wake(h, &h->for_thread, h->thread_sleeps);
  pthread_join(h->thread, nullptr);
  discard(h);
  store->helper = nullptr;
}
