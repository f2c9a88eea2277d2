// Records of any length on blocks of fixed length. A record may cross blocks: the store sees whole blocks only, and the data
// need no padding. The status is sticky, so a sequence of calls is checked once at its end.
#include "elimination/stream.hpp"

#include <string.h>

namespace c2d {

Stream open_stream(Tapes& tapes, int32_t tape, uint64_t first_block, uint64_t blocks, uint64_t block_bytes, char* buffer) {
  return Stream{&tapes, tape, first_block, blocks, block_bytes, buffer, 0, 0, C2D_OK};
}

void append(Stream& s, const void* data, uint64_t bytes) {
  const char* from = static_cast<const char*>(data);
  // The buffer is used for writing now, so a block that was read into it is gone.
  s.loaded = 0;
  while (bytes > 0 && s.status == C2D_OK) {
    if (s.end / s.block_bytes >= s.blocks) {
      s.status = C2D_ERR_MEMORY;
      break;
    }
    const uint64_t at = s.end % s.block_bytes, room = s.block_bytes - at, now = bytes < room ? bytes : room;
    memcpy(s.buffer + kBlockHeaderBytes + at, from, static_cast<size_t>(now));
    s.end += now;
    from += now;
    bytes -= now;
    if (now < room) break;
    s.status = write_block(*s.tapes, s.tape, s.first_block + s.end / s.block_bytes - 1, s.buffer, s.block_bytes);
  }
}

c2d_status finish_block(Stream& s) {
  const uint64_t at = s.end % s.block_bytes;
  if (s.status != C2D_OK || at == 0) return s.status;
  // Zeros behind the data: no bytes of an earlier block reach the tape.
  memset(s.buffer + kBlockHeaderBytes + at, 0, static_cast<size_t>(s.block_bytes - at));
  const uint64_t block = s.first_block + s.end / s.block_bytes;
  s.end += s.block_bytes - at;
  return s.status = write_block(*s.tapes, s.tape, block, s.buffer, s.block_bytes);
}

c2d_status read_at(Stream& s, uint64_t at, void* data, uint64_t bytes) {
  char* to = static_cast<char*>(data);
  while (bytes > 0 && s.status == C2D_OK) {
    const uint64_t block = at / s.block_bytes, place = at % s.block_bytes, room = s.block_bytes - place;
    const uint64_t now = bytes < room ? bytes : room;
    // Consecutive reads mostly hit the block that is in the buffer already.
    if (s.loaded != block + 1) {
      s.loaded = 0;
      s.status = read_block(*s.tapes, s.tape, s.first_block + block, s.buffer, s.block_bytes);
      if (s.status != C2D_OK) break;
      s.loaded = block + 1;
    }
    memcpy(to, s.buffer + kBlockHeaderBytes + place, static_cast<size_t>(now));
    to += now;
    at += now;
    bytes -= now;
  }
  return s.status;
}

} // namespace c2d
