#include "c2d_memory.h"
#include <string.h>

// (Memory checkers report reads of bytes that were never written.)
#if defined(__has_feature)
#if __has_feature(memory_sanitizer)
#define C2D_MEMORY_IS_WATCHED 1
#endif
#endif

namespace {

constexpr uint64_t kMark = 64; // bytes at the front of a block that are cleared when a tape is new

c2d_memory_store* self(void* context) { return static_cast<c2d_memory_store*>(context); }

bool is_tape(int32_t tape) { return tape >= 0 && tape < C2D_TAPES; }

// Saturating, so that an absurd size is simply larger than the region.
uint64_t product(uint64_t a, uint64_t b) { return a != 0 && b > UINT64_MAX / a ? UINT64_MAX : a * b; }
uint64_t sum(uint64_t a, uint64_t b) { return b > UINT64_MAX - a ? UINT64_MAX : a + b; }

// Finds room for `bytes` bytes: the part of the tape, extended if it is the last one, or a new
// part.
bool carve(c2d_memory_store* s, int32_t tape, uint64_t bytes) {
  if (bytes <= s->room[tape]) return true;
  const bool last = s->offset[tape] + s->room[tape] == s->used;
  const uint64_t start = last ? s->offset[tape] : s->used;
  if (bytes > s->bytes - start) return false;
  s->offset[tape] = start;
  s->room[tape] = bytes;
  s->used = start + bytes;
  return true;
}

// Systems allocate memory page by page on the first write, so memory that is zero already is only read.
void clear(unsigned char* at, uint64_t bytes) {
#if !defined(C2D_MEMORY_IS_WATCHED)
  uint64_t i = 0;
  while (i < bytes && at[i] == 0) ++i;
  if (i == bytes) return;
#endif
  memset(at, 0, static_cast<size_t>(bytes));
}

int32_t open_tape(void* context, int32_t tape, uint64_t blocks, uint64_t block_bytes) {
  c2d_memory_store* s = self(context);
  if (!is_tape(tape)) return C2D_MEMORY_STORE_TAPE;
  s->wanted[tape] = product(blocks, block_bytes);
  // The same shape again: the contents stay, as on a file.
  const bool same = s->blocks[tape] == blocks && s->block_bytes[tape] == block_bytes;
  if (!same) {
    if (!carve(s, tape, s->wanted[tape])) return C2D_MEMORY_STORE_FULL;
    s->blocks[tape] = blocks;
    s->block_bytes[tape] = block_bytes;
    // The contents belonged to other blocks. Without their headers they cannot be taken for valid ones.
    const uint64_t head = block_bytes < kMark ? block_bytes : kMark;
    unsigned char* start = s->region + s->offset[tape];
    for (uint64_t i = 0; i < blocks; ++i) clear(start + i * block_bytes, head);
  }
  s->is_open[tape] = 1;
  return 0;
}

// Address of a transfer, or null and *code.
unsigned char* place(c2d_memory_store* s, int32_t tape, uint64_t block, uint64_t bytes, int32_t* code) {
  *code = !is_tape(tape) || !s->is_open[tape] ? C2D_MEMORY_STORE_TAPE : 0;
  if (*code != 0) return nullptr;
  if (block >= s->blocks[tape] || bytes > s->block_bytes[tape]) *code = C2D_MEMORY_STORE_RANGE;
  return *code != 0 ? nullptr : s->region + s->offset[tape] + block * s->block_bytes[tape];
}

int32_t read_block(void* context, int32_t tape, uint64_t block, void* data, uint64_t bytes) {
  int32_t code = 0;
  const unsigned char* from = place(self(context), tape, block, bytes, &code);
  if (from && bytes > 0) memcpy(data, from, static_cast<size_t>(bytes));
  return code;
}

int32_t write_block(void* context, int32_t tape, uint64_t block, const void* data, uint64_t bytes) {
  int32_t code = 0;
  unsigned char* to = place(self(context), tape, block, bytes, &code);
  if (to && bytes > 0) memcpy(to, data, static_cast<size_t>(bytes));
  return code;
}

int32_t sync_tape(void* context, int32_t tape) {
  return is_tape(tape) && self(context)->is_open[tape] ? 0 : C2D_MEMORY_STORE_TAPE;
}

int32_t close_tape(void* context, int32_t tape) {
  const int32_t code = sync_tape(context, tape);
  if (code == 0) self(context)->is_open[tape] = 0;
  return code;
}

} // namespace

extern "C" {

void c2d_memory_store_init(c2d_memory_store* store, void* region, uint64_t bytes) {
  memset(store, 0, sizeof *store);
  store->region = static_cast<unsigned char*>(region);
  store->bytes = region ? bytes : 0;
}

uint64_t c2d_memory_store_need(const c2d_memory_store* store) {
  uint64_t need = 0;
  for (int32_t tape = 0; tape < C2D_TAPES; ++tape) need = sum(need, store->wanted[tape]);
  return need;
}

void c2d_memory_store_port(c2d_memory_store* store, c2d_port* out) {
  out->context = store;
  out->open = open_tape;
  out->read = read_block;
  out->write = write_block;
  out->sync = sync_tape;
  out->close = close_tape;
}

} // extern "C"
