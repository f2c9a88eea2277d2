// Transfers of a c2d_posix_store that go on beside the caller: at most four, in the order in which they were asked for,
// done by one thread. The thread begins with the first transfer and ends with stop_transfers.
#pragma once
#include "c2d_posix.h"

struct PosixTransfer {
  int32_t tape;
  bool writes;
  uint64_t block, bytes;
  void* data;
};

// Do it, here and now. Returns 0, errno or C2D_POSIX_STORE_...
int32_t do_posix_transfer(c2d_posix_store* store, const PosixTransfer& transfer);

// Ask for it. Without a thread to be had it is done now. Returns 0, or what went wrong: then there is nothing to wait for.
int32_t start_posix_transfer(c2d_posix_store* store, const PosixTransfer& transfer, int32_t* ticket);
// Wait for it; returns what became of it.
int32_t wait_posix_transfer(c2d_posix_store* store, int32_t ticket);
// What was asked for of this block is done; tickets are still to be waited for.
void settle_posix_transfers(c2d_posix_store* store, int32_t tape, uint64_t block);
// All transfers asked for are done, and the thread has ended.
void stop_posix_transfers(c2d_posix_store* store);
