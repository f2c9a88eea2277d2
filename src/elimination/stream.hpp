#pragma once
// Records of any length on the blocks of a tape: numbers one after another, found again by where they begin. After an error
// nothing more is written or read.
#include "store/tapes.hpp"

namespace c2d {

struct Stream {
  Tapes* tapes;
  int32_t tape;
  uint64_t first_block, blocks; // that it may use
  uint64_t block_bytes;         // of data
  char* buffer;                 // kBlockHeaderBytes + block_bytes
  uint64_t end;                 // bytes written so far
  uint64_t held;                // block in the buffer, plus 1; 0: none
  c2d_status status;            // C2D_ERR_MEMORY: its blocks are full. Else the errors of the tape
};
Stream open_stream(Tapes& tapes, int32_t tape, uint64_t first_block, uint64_t blocks, uint64_t block_bytes, char* buffer);

// Append.
void append(Stream& stream, const void* data, uint64_t bytes);
// What is still in the buffer goes to the tape; more is appended from the next block on. Returns its status.
c2d_status finish_block(Stream& stream);
// Bytes from a place on, of what has been finished. Returns its status.
c2d_status read_at(Stream& stream, uint64_t at, void* data, uint64_t bytes);

} // namespace c2d
