// Blocks on the tapes of the caller's block store: transfers, their checks, and the count of runs.
//
// A transfer has two halves. start_labelled() seals or clears the buffer and calls the port, which may finish later.
// finish_transfer() waits, inspects what was read and compares its label with the one requested. Only a block that passes both
// is used. The port's own status is not sufficient: a store may report success and return old or foreign bytes. Runs: block 0
// of tape CONTROL counts them. The run id is a hash of the model and of that count, so a block of an earlier run is recognised
// as stale although it is sound.
#include "store/tapes.hpp"
#include "memory/config.hpp"
#include "memory/sizes.hpp"
#include "memory/text.hpp"
#include <string.h>

namespace c2d {
namespace {

const char* tape_name(int32_t tape) {
  switch (tape) {
  case C2D_TAPE_CONTROL: return "run control";
  case C2D_TAPE_LOWER: return "lower factors, for elimination";
  case C2D_TAPE_UPPER: return "upper factors, for back substitution";
  case C2D_TAPE_CONTACT: return "contact system";
  default: return "no such tape";
  }
}

// Starts tapes.error; the caller appends to the text.
Text begin_error(Tapes& tapes, c2d_status status, int32_t tape, uint64_t block) {
  c2d_error& error = tapes.error;
  memset(&error, 0, sizeof error);
  error.struct_size = sizeof error;
  error.status = status;
  error.severity = C2D_FAULT;
  error.tape = tape;
  error.block = static_cast<int64_t>(block);
  Text text = text_in(error.text);
  put_all(text, "block store: tape ", tape, " (", tape_name(tape), ")");
  return text;
}

Text begin_block_error(Tapes& tapes, c2d_status status, int32_t tape, uint64_t block) {
  Text text = begin_error(tapes, status, tape, block);
  put_all(text, ", block ", block, ": ");
  return text;
}

// "<what> is <found>, expected <expected>"
void put_difference(Text& text, const char* what, uint64_t found, uint64_t expected) {
  put_all(text, what, " is ", found, ", expected ", expected);
}

c2d_status broken_promise(Tapes& tapes, int32_t tape, uint64_t block, const char* what) {
  Text text = begin_block_error(tapes, C2D_ERR_INTERNAL, tape, block);
  put(text, what);
  return C2D_ERR_INTERNAL;
}

c2d_status host_error(Tapes& tapes, c2d_status status, int32_t tape, const char* what, int32_t code) {
  Text text = begin_error(tapes, status, tape, 0);
  tapes.error.host_code = code;
  put_all(text, ": ", what, " failed with code ", code);
  return status;
}

c2d_status host_block_error(Tapes& tapes, c2d_status status, int32_t tape, uint64_t block, const char* what, uint64_t bytes,
                            int32_t code) {
  Text text = begin_block_error(tapes, status, tape, block);
  tapes.error.host_code = code;
  put_all(text, what, " of ", bytes, " bytes failed with code ", code);
  return status;
}

// Marks a call to the port as in progress: no call of the solver is allowed from inside it.
class AtWork {
public:
  explicit AtWork(const Tapes& tapes) : busy_(tapes.busy) {
    if (busy_) *busy_ = 1;
  }
  ~AtWork() {
    if (busy_) *busy_ = 0;
  }
  AtWork(const AtWork&) = delete;
  AtWork& operator=(const AtWork&) = delete;

private:
  int32_t* busy_;
};

bool is_tape(int32_t tape) { return tape >= 0 && tape < C2D_TAPES; }

// Is this transfer allowed? A violation is an error of this library, and must not reach the port.
c2d_status check_transfer(Tapes& tapes, int32_t tape, uint64_t block, uint64_t data_bytes) {
  if (!is_tape(tape) || !tapes.is_open[tape]) return broken_promise(tapes, tape, block, "the tape is not open");
  if (block >= tapes.blocks[tape]) return broken_promise(tapes, tape, block, "beyond the end of the tape");
  if (data_bytes > tapes.block_bytes[tape] - kBlockHeaderBytes) {
    return broken_promise(tapes, tape, block, "longer than the tape was opened for");
  }
  return C2D_OK;
}

c2d_status damaged(Tapes& tapes, int32_t tape, uint64_t block, const BlockReport& report) {
  const c2d_status status = report.fault == BlockFault::format    ? C2D_ERR_STORE_FORMAT
                            : report.fault == BlockFault::version ? C2D_ERR_STORE_VERSION
                            : report.fault == BlockFault::torn    ? C2D_ERR_STORE_SHORT
                                                                  : C2D_ERR_STORE_CHECKSUM;
  Text text = begin_block_error(tapes, status, tape, block);
  if (report.fault == BlockFault::format) {
    put(text, "no block of this library was found: never written, or overwritten");
  } else if (report.fault == BlockFault::torn) {
    put(text, "torn: its end is not the one written with its header");
  } else {
    if (report.fault == BlockFault::checksum) put(text, "damaged: ");
    put_difference(text, report.what, report.found, report.expected);
  }
  return status;
}

// The block is sound. Is it the requested one?
c2d_status compare(Tapes& tapes, const BlockLabel& found, const BlockLabel& expected) {
  const int32_t tape = expected.tape;
  const uint64_t block = expected.block;
  if (found.tape != tape || found.block != block) {
    Text text = begin_block_error(tapes, C2D_ERR_STORE_SWAPPED, tape, block);
    put_all(text, "block ", found.block, " of tape ", found.tape, " was found in its place");
    return C2D_ERR_STORE_SWAPPED;
  }
  if (found.run_id != expected.run_id || found.generation != expected.generation) {
    Text text = begin_block_error(tapes, C2D_ERR_STORE_STALE, tape, block);
    put(text, "stale: ");
    if (found.run_id != expected.run_id)
      put_difference(text, "run", found.run_id, expected.run_id);
    else
      put_difference(text, "generation", found.generation, expected.generation);
    return C2D_ERR_STORE_STALE;
  }
  if (found.length != expected.length) {
    Text text = begin_block_error(tapes, C2D_ERR_STORE_SHORT, tape, block);
    put_difference(text, "length in bytes", found.length, expected.length);
    return C2D_ERR_STORE_SHORT;
  }
  return C2D_OK;
}

// Clears both ends of the buffer: otherwise a port that fills less than it reports could pass with an old header or an old end
// mark that happens to be in the buffer.
void clear_ends(unsigned char* buffer, uint64_t data_bytes) {
  memset(buffer, 0, kBlockHeaderBytes);
  const size_t tail = static_cast<size_t>(data_bytes < 8 ? data_bytes : 8);
  memset(buffer + kBlockHeaderBytes + data_bytes - tail, 0, tail);
}

c2d_status start_labelled(Tapes& tapes, BlockTransfer& transfer, BlockTransfer::Kind kind, const BlockLabel& label,
                          void* buffer, bool ahead) {
  const c2d_status status = check_transfer(tapes, label.tape, label.block, label.length);
  if (status != C2D_OK) return status;
  const c2d_port& port = *tapes.port;
  ahead = !kSmallCode && ahead && port.start_read && port.start_write && port.wait;
  const uint64_t bytes = kBlockHeaderBytes + label.length;
  const bool writes = kind == BlockTransfer::write;
  transfer = {label, buffer, kind, 0, 0, false};
  if (writes)
    seal_block(label, buffer);
  else
    clear_ends(static_cast<unsigned char*>(buffer), label.length);
  const AtWork at_work(tapes);
  if (ahead) {
    transfer.code = writes ? port.start_write(port.context, label.tape, label.block, buffer, bytes, &transfer.ticket)
                           : port.start_read(port.context, label.tape, label.block, buffer, bytes, &transfer.ticket);
    transfer.waiting = transfer.code == 0;
  } else {
    transfer.code = writes ? port.write(port.context, label.tape, label.block, buffer, bytes)
                           : port.read(port.context, label.tape, label.block, buffer, bytes);
  }
  return C2D_OK; // finish_transfer evaluates the code
}

// Label of a block of the present run. A tape out of range is refused by check_transfer.
BlockLabel current_label(const Tapes& tapes, int32_t tape, uint64_t block, uint64_t data_bytes) {
  const uint32_t generation = is_tape(tape) ? tapes.generation[tape] : 0;
  return {tapes.run_id, block, data_bytes, tape, generation};
}

} // namespace

c2d_status open_tape(Tapes& tapes, int32_t tape, uint64_t blocks, uint64_t data_bytes) {
  if (!is_tape(tape) || tapes.is_open[tape]) return broken_promise(tapes, tape, 0, "the tape is open already");
  const c2d_port* port = tapes.port;
  if (!port || !port->open || !port->read || !port->write || !port->sync || !port->close) {
    return host_error(tapes, C2D_ERR_STORE_OPEN, tape, "opening it without a complete block store", 0);
  }
  // Buffers must be addressable, and the tape's length must be a valid file offset on any system.
  const uint64_t most = static_cast<uint64_t>(PTRDIFF_MAX);
  uint64_t length = 0;
  if (data_bytes > most - kBlockHeaderBytes || !add_bytes(length, blocks, data_bytes + kBlockHeaderBytes) ||
      length > static_cast<uint64_t>(INT64_MAX)) {
    Text text = begin_error(tapes, C2D_ERR_OVERFLOW, tape, 0);
    put(text, ": its length does not fit into 63 bits");
    return C2D_ERR_OVERFLOW;
  }
  const uint64_t block_bytes = data_bytes + kBlockHeaderBytes;
  const int32_t code = (AtWork(tapes), port->open(port->context, tape, blocks, block_bytes));
  if (code != 0) return host_error(tapes, C2D_ERR_STORE_OPEN, tape, "opening", code);
  tapes.is_open[tape] = 1;
  tapes.blocks[tape] = blocks;
  tapes.block_bytes[tape] = block_bytes;
  return C2D_OK;
}

c2d_status start_transfer(Tapes& tapes, BlockTransfer& transfer, BlockTransfer::Kind kind, int32_t tape, uint64_t block,
                          void* buffer, uint64_t data_bytes, bool ahead) {
  const c2d_status status = start_labelled(tapes, transfer, kind, current_label(tapes, tape, block, data_bytes), buffer, ahead);
  return status == C2D_OK && transfer.code != 0 ? finish_transfer(tapes, transfer) : status;
}

void abandon_transfer(Tapes& tapes, BlockTransfer& transfer) {
  transfer.kind = BlockTransfer::none;
  if (kSmallCode || !transfer.waiting) return;
  transfer.waiting = false;
  const AtWork at_work(tapes);
  transfer.code = tapes.port->wait(tapes.port->context, transfer.ticket);
}

c2d_status finish_transfer(Tapes& tapes, BlockTransfer& transfer) {
  const bool writes = transfer.kind == BlockTransfer::write;
  if (transfer.kind == BlockTransfer::none) return C2D_OK;
  abandon_transfer(tapes, transfer);
  const int32_t tape = transfer.label.tape;
  const uint64_t block = transfer.label.block, bytes = kBlockHeaderBytes + transfer.label.length;
  // The caller's data are unchanged after writing, whether it succeeded or not.
  if (writes) unseal_block(transfer.buffer, transfer.label.length);
  if (transfer.code != 0) {
    return host_block_error(tapes, writes ? C2D_ERR_STORE_WRITE : C2D_ERR_STORE_READ, tape, block,
                            writes ? "writing" : "reading", bytes, transfer.code);
  }
  if (!writes) {
    BlockLabel found = {};
    const BlockReport report = inspect_block(transfer.buffer, transfer.label.length, &found);
    if (report.fault != BlockFault::none) return damaged(tapes, tape, block, report);
    const c2d_status verdict = compare(tapes, found, transfer.label);
    if (verdict != C2D_OK) return verdict;
    unseal_block(transfer.buffer, transfer.label.length);
  }
  (writes ? tapes.writes : tapes.reads)[tape] += 1;
  (writes ? tapes.bytes_written : tapes.bytes_read)[tape] += bytes;
  return C2D_OK;
}

namespace {

c2d_status transfer_now(Tapes& tapes, BlockTransfer::Kind kind, const BlockLabel& label, void* buffer) {
  BlockTransfer transfer;
  const c2d_status status = start_labelled(tapes, transfer, kind, label, buffer, false);
  return status == C2D_OK ? finish_transfer(tapes, transfer) : status;
}

} // namespace

c2d_status write_block(Tapes& tapes, int32_t tape, uint64_t block, void* buffer, uint64_t data_bytes) {
  return transfer_now(tapes, BlockTransfer::write, current_label(tapes, tape, block, data_bytes), buffer);
}

c2d_status read_block(Tapes& tapes, int32_t tape, uint64_t block, void* buffer, uint64_t data_bytes) {
  return transfer_now(tapes, BlockTransfer::read, current_label(tapes, tape, block, data_bytes), buffer);
}

c2d_status sync_tape(Tapes& tapes, int32_t tape) {
  if (!is_tape(tape) || !tapes.is_open[tape]) return broken_promise(tapes, tape, 0, "the tape is not open");
  const int32_t code = (AtWork(tapes), tapes.port->sync(tapes.port->context, tape));
  return code == 0 ? c2d_status{C2D_OK} : host_error(tapes, C2D_ERR_STORE_SYNC, tape, "making it safe", code);
}

c2d_status close_tape(Tapes& tapes, int32_t tape) {
  if (!is_tape(tape) || !tapes.is_open[tape]) return broken_promise(tapes, tape, 0, "the tape is not open");
  tapes.is_open[tape] = 0;
  const int32_t code = (AtWork(tapes), tapes.port->close(tapes.port->context, tape));
  return code == 0 ? c2d_status{C2D_OK} : host_error(tapes, C2D_ERR_STORE_CLOSE, tape, "closing", code);
}

c2d_status close_all(Tapes& tapes) {
  // All tapes are closed, also after a failure; the first failure is reported.
  int32_t failed_tape = -1, failed_code = 0;
  for (int32_t tape = 0; tape < C2D_TAPES; ++tape) {
    if (!tapes.is_open[tape] || close_tape(tapes, tape) == C2D_OK || failed_tape >= 0) continue;
    failed_tape = tape;
    failed_code = tapes.error.host_code;
  }
  if (failed_tape < 0) return C2D_OK;
  return host_error(tapes, C2D_ERR_STORE_CLOSE, failed_tape, "closing", failed_code);
}

namespace {

// The count belongs to the store and not to a run: its label never changes.
BlockLabel record_label(uint64_t block, uint64_t data_bytes) { return {0, block, data_bytes, C2D_TAPE_CONTROL, 0}; }

c2d_status write_count(Tapes& tapes, void* buffer) {
  unsigned char* data = static_cast<unsigned char*>(buffer) + kBlockHeaderBytes;
  for (size_t i = 0; i < kControlBytes; ++i) data[i] = static_cast<unsigned char>(tapes.count >> (8 * i));
  const c2d_status status = write_record(tapes, 0, buffer, kControlBytes);
  return status == C2D_OK ? sync_tape(tapes, C2D_TAPE_CONTROL) : status;
}

} // namespace

c2d_status write_record(Tapes& tapes, uint64_t block, void* buffer, uint64_t data_bytes) {
  return transfer_now(tapes, BlockTransfer::write, record_label(block, data_bytes), buffer);
}

c2d_status read_record(Tapes& tapes, uint64_t block, void* buffer, uint64_t data_bytes) {
  return transfer_now(tapes, BlockTransfer::read, record_label(block, data_bytes), buffer);
}

c2d_status read_count(Tapes& tapes, uint64_t* count, void* buffer) {
  const unsigned char* data = static_cast<unsigned char*>(buffer) + kBlockHeaderBytes;
  const uint64_t reads = tapes.reads[C2D_TAPE_CONTROL], bytes = tapes.bytes_read[C2D_TAPE_CONTROL];
  const c2d_status found = read_record(tapes, 0, buffer, kControlBytes);
  // Not counted as a transfer: whether the block exists depends on what happened before this run.
  tapes.reads[C2D_TAPE_CONTROL] = reads;
  tapes.bytes_read[C2D_TAPE_CONTROL] = bytes;
  *count = 0;
  for (size_t i = 0; i < kControlBytes && found == C2D_OK; ++i) *count |= static_cast<uint64_t>(data[i]) << (8 * i);
  return found;
}

c2d_status keep_count(Tapes& tapes, void* buffer) {
  uint64_t there = 0;
  const c2d_status found = read_count(tapes, &there, buffer);
  return found == C2D_OK && there == tapes.count ? c2d_status{C2D_OK} : write_count(tapes, buffer);
}

c2d_status recount_run(Tapes& tapes, void* buffer) {
  uint64_t count = 0;
  const c2d_status found = read_count(tapes, &count, buffer);
  if (found == C2D_ERR_STORE_CHECKSUM || found == C2D_ERR_STORE_SHORT) {
    // The count is lost: continue from a number that an earlier run is very unlikely to have had.
    count = checksum(0, buffer, kBlockHeaderBytes + kControlBytes);
  } else if (found == C2D_ERR_INTERNAL) {
    return found;
  }
  memset(&tapes.error, 0, sizeof tapes.error); // an empty store is no error
  // A store in memory may have lost the count when the tape changed its shape: the larger number is safe.
  tapes.count = (count > tapes.count ? count : tapes.count) + 1;
  return write_count(tapes, buffer);
}

c2d_status begin_run(Tapes& tapes, uint64_t model_hash, void* buffer) {
  c2d_status status = C2D_OK;
  if (!tapes.is_open[C2D_TAPE_CONTROL]) status = open_tape(tapes, C2D_TAPE_CONTROL, 1, kControlBytes);
  if (status == C2D_OK) status = recount_run(tapes, buffer);
  if (status != C2D_OK) return status;
  tapes.run_id = mix(mix(model_hash) ^ tapes.count);
  if (tapes.run_id == 0) tapes.run_id = 1; // 0 is the label of the count itself
  return C2D_OK;
}

c2d_status reopen_tapes(Tapes& tapes) {
  const c2d_port* port = tapes.port;
  for (int32_t tape = 0; tape < C2D_TAPES; ++tape) {
    if (!tapes.is_open[tape]) continue;
    if (!port || !port->open || !port->read || !port->write || !port->sync || !port->close)
      return host_error(tapes, C2D_ERR_STORE_OPEN, tape, "opening it without a complete block store", 0);
    const int32_t code = (AtWork(tapes), port->open(port->context, tape, tapes.blocks[tape], tapes.block_bytes[tape]));
    if (code != 0) return host_error(tapes, C2D_ERR_STORE_OPEN, tape, "opening", code);
  }
  return C2D_OK;
}

} // namespace c2d
