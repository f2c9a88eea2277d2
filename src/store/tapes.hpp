#pragma once
// Numbered blocks on the tapes of the caller's block store. Every block is labelled when it is written and checked when it is
// read, so that a torn, short, swapped, damaged or stale block is reported as such and never used.
#include "contact2d.h"
#include "store/block.hpp"

namespace c2d {

// The state of all tapes. Trivially copyable; `port` is its only pointer (a solver that was moved sets it
// anew). A zeroed struct with `port` set is a good start: all tapes closed.
struct Tapes {
  const c2d_port* port;
  int32_t* busy; // set to 1 while the port is at work; may be null
  uint64_t run_id;
  uint64_t count; // of runs and of changes to their tapes, as on the store; 0: not begun
  uint32_t generation[C2D_TAPES];
  uint8_t is_open[C2D_TAPES];
  uint64_t blocks[C2D_TAPES], block_bytes[C2D_TAPES];       // as opened, headers included
  uint64_t writes[C2D_TAPES], reads[C2D_TAPES];             // transfers that succeeded
  uint64_t bytes_written[C2D_TAPES], bytes_read[C2D_TAPES]; // by them, headers included
  c2d_error error;                                          // of the last call that failed
};

// All functions return C2D_OK or fill tapes.error (status, tape, block, host_code, text) and return its status.
// C2D_ERR_INTERNAL: a tape that is not open (or open already), a block beyond its end, too many bytes.

// Open a tape for blocks 0 ... blocks-1 of at most data_bytes bytes of data each. Errors: STORE_OPEN, OVERFLOW.
c2d_status open_tape(Tapes& tapes, int32_t tape, uint64_t blocks, uint64_t data_bytes);

// Write data_bytes bytes from buffer[64 .. 64 + data_bytes); buffer[0 .. 64) is room for the
// header. The data are unchanged afterwards. Errors: STORE_WRITE.
c2d_status write_block(Tapes& tapes, int32_t tape, uint64_t block, void* buffer, uint64_t data_bytes);

// Read the block of data_bytes bytes into buffer[64 .. 64 + data_bytes), buffer as in write_block; after a failure the contents
// are meaningless. Errors: STORE_READ, _FORMAT, _VERSION, _SHORT, _CHECKSUM, _SWAPPED, _STALE.
c2d_status read_block(Tapes& tapes, int32_t tape, uint64_t block, void* buffer, uint64_t data_bytes);

// A transfer that may proceed while other work is done. Zeroed: none. Its buffer belongs to the port until the transfer is
// finished or abandoned. The caller does one of the two before the buffer or the tapes are used otherwise, does not read the
// data in between, and has at most kMostTransfers in progress at once.
struct BlockTransfer {
  enum Kind : int32_t { none, read, write };
  BlockLabel label;
  void* buffer;
  Kind kind;
  int32_t code;   // returned by the port
  int32_t ticket; // of the port, if the transfer is still in progress
  bool waiting;
};
constexpr int32_t kMostTransfers = 4;

// Begin to read or write a block of data_bytes bytes, buffer as in write_block. Without `ahead`, or without the port's
// start_read, start_write and wait, the transfer happens now. An immediate failure is returned at once; data read are checked
// by finish_transfer. `transfer` must not be in progress. Small code never reads ahead.
c2d_status start_transfer(Tapes& tapes, BlockTransfer& transfer, BlockTransfer::Kind kind, int32_t tape, uint64_t block,
                          void* buffer, uint64_t data_bytes, bool ahead);
// Waits for the transfer, checks what was read, counts it. The buffer then contains the data. Errors as write_block and
// read_block.
c2d_status finish_transfer(Tapes& tapes, BlockTransfer& transfer);
// Waits for the transfer if necessary and ignores its result; tapes.error stays.
void abandon_transfer(Tapes& tapes, BlockTransfer& transfer);

c2d_status sync_tape(Tapes& tapes, int32_t tape); // Errors: STORE_SYNC.
c2d_status close_tape(Tapes& tapes,
                      int32_t tape); // Errors: STORE_CLOSE; the tape counts as closed all the same.
// Close every open tape, also after a failure; the first failure is returned.
c2d_status close_all(Tapes& tapes);

// Start a run: count it on block 0 of tape CONTROL (opened for one block of kControlBytes if it is not open
// yet) and set run_id from the model's hash and that count, so that blocks an earlier run left are recognised
// as stale. A store without a sound count there (a new one) starts at 1. buffer: kBlockHeaderBytes +
// kControlBytes bytes. Errors: STORE_OPEN, STORE_WRITE, STORE_SYNC; a failing read counts as "nothing there".
constexpr uint64_t kControlBytes = 8;
c2d_status begin_run(Tapes& tapes, uint64_t model_hash, void* buffer);
// The present run is about to change blocks in place: states saved so far no longer belong to its tapes. Increases the count
// and keeps the run id. Tape CONTROL is open; buffer and errors as begin_run.
c2d_status recount_run(Tapes& tapes, void* buffer);
// The count on tape CONTROL, which is open. Errors: as read_block.
c2d_status read_count(Tapes& tapes, uint64_t* count, void* buffer);
// Writes tapes.count to the store unless it is there already. Errors: STORE_WRITE, STORE_SYNC.
c2d_status keep_count(Tapes& tapes, void* buffer);

// Blocks of tape CONTROL that belong to the store and not to a run: run id 0, generation 0. As write_block, read_block.
c2d_status write_record(Tapes& tapes, uint64_t block, void* buffer, uint64_t data_bytes);
c2d_status read_record(Tapes& tapes, uint64_t block, void* buffer, uint64_t data_bytes);

// Opens again, through the port, all tapes that count as open: it may be another port in another process. Errors: STORE_OPEN.
c2d_status reopen_tapes(Tapes& tapes);

} // namespace c2d
