#pragma once
// Records of any length on the blocks of a tape: bytes one after another, found again by the place where they begin. After an
// error nothing more is written or read.
#include "store/tapes.hpp"

namespace c2d {

struct Stream {
  Tapes* tapes;
  int32_t tape;
  uint64_t first_block, blocks; // that it may use
  uint64_t block_bytes;         // of data
  char* buffer;                 // kBlockHeaderBytes + block_bytes
  uint64_t end;                 // bytes written so far
  uint64_t loaded;              // block in the buffer, plus 1; 0: none
  c2d_status status;            // C2D_ERR_MEMORY: no block is left. Otherwise the errors of the tape
};
Stream open_stream(Tapes& tapes, int32_t tape, uint64_t first_block, uint64_t blocks, uint64_t block_bytes, char* buffer);

// Append.
void append(Stream& stream, const void* data, uint64_t bytes);
// Writes the rest of the buffer to the tape; the next bytes go to the next block. Returns the status.
c2d_status finish_block(Stream& stream);
// Reads bytes from a place on, of finished blocks. Returns the status.
c2d_status read_at(Stream& stream, uint64_t at, void* data, uint64_t bytes);

} // namespace c2d
