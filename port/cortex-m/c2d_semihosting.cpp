#include "c2d_semihosting.h"

#include "semihosting.hpp"

#include <string.h>

namespace {

constexpr uint32_t kNameBytes = sizeof(c2d_semihosting_store::folder) + 16;

c2d_semihosting_store* self(void* context) { return static_cast<c2d_semihosting_store*>(context); }

bool is_open(const c2d_semihosting_store* s, int32_t tape) { return tape >= 0 && tape < C2D_TAPES && s->file[tape] != 0; }

int32_t close_tape(void* context, int32_t tape) {
  c2d_semihosting_store* s = self(context);
  if (!is_open(s, tape)) return C2D_SEMIHOSTING_TAPE;
  const int32_t closed = host::close(s->file[tape] - 1);
  s->file[tape] = 0;
  return closed == 0 ? 0 : C2D_SEMIHOSTING_HOST;
}

// An existing file keeps its contents: the library recognises blocks of another run.
int32_t open_tape(void* context, int32_t tape, uint64_t blocks, uint64_t block_bytes) {
  c2d_semihosting_store* s = self(context);
  if (tape < 0 || tape >= C2D_TAPES) return C2D_SEMIHOSTING_TAPE;
  // (32-bit division: the 64-bit one is long code that nothing else on a board needs.)
  if (blocks > UINT32_MAX || (blocks != 0 && block_bytes > UINT32_MAX / static_cast<uint32_t>(blocks)))
    return C2D_SEMIHOSTING_RANGE;
  if (is_open(s, tape)) {
    const int32_t closed = close_tape(context, tape);
    if (closed != 0) return closed;
  }
  char name[kNameBytes];
  const size_t length = strlen(s->folder);
  memcpy(name, s->folder, length);
  memcpy(name + length, "/tape0.c2d", 11);
  name[length + 5] = static_cast<char>('0' + tape);
  int32_t file = host::open(name, host::Mode::update);
  if (file == -1) file = host::open(name, host::Mode::create);
  if (file == -1) return C2D_SEMIHOSTING_HOST;
  s->file[tape] = file + 1;
  s->blocks[tape] = static_cast<uint32_t>(blocks);
  s->block_bytes[tape] = static_cast<uint32_t>(block_bytes);
  return 0;
}

// Moves the file to the start of a block.
int32_t find_block(const c2d_semihosting_store* s, int32_t tape, uint64_t block, uint64_t bytes) {
  if (!is_open(s, tape)) return C2D_SEMIHOSTING_TAPE;
  if (block >= s->blocks[tape] || bytes > s->block_bytes[tape]) return C2D_SEMIHOSTING_RANGE;
  const uint32_t offset = static_cast<uint32_t>(block) * s->block_bytes[tape];
  return host::seek(s->file[tape] - 1, offset) == 0 ? 0 : C2D_SEMIHOSTING_HOST;
}

int32_t read_block(void* context, int32_t tape, uint64_t block, void* data, uint64_t bytes) {
  const c2d_semihosting_store* s = self(context);
  const int32_t found = find_block(s, tape, block, bytes);
  if (found != 0) return found;
  return host::read(s->file[tape] - 1, data, static_cast<uint32_t>(bytes)) == 0 ? 0 : C2D_SEMIHOSTING_HOST;
}

int32_t write_block(void* context, int32_t tape, uint64_t block, const void* data, uint64_t bytes) {
  const c2d_semihosting_store* s = self(context);
  const int32_t found = find_block(s, tape, block, bytes);
  if (found != 0) return found;
  return host::write(s->file[tape] - 1, data, static_cast<uint32_t>(bytes)) == 0 ? 0 : C2D_SEMIHOSTING_HOST;
}

int32_t sync_tape(void* context, int32_t tape) { return is_open(self(context), tape) ? 0 : C2D_SEMIHOSTING_TAPE; }

// The next byte of the file, -1 at its end, C2D_SEMIHOSTING_HOST.
int32_t next_byte(c2d_semihosting_deck* deck) {
  if (deck->first == deck->last) {
    if (deck->left == 0) return -1;
    const uint32_t bytes = deck->left < sizeof deck->buffer ? deck->left : static_cast<uint32_t>(sizeof deck->buffer);
    if (host::read(deck->file, deck->buffer, bytes) != 0) return C2D_SEMIHOSTING_HOST;
    deck->first = 0;
    deck->last = bytes;
    deck->left -= bytes;
  }
  return static_cast<unsigned char>(deck->buffer[deck->first++]);
}

} // namespace

extern "C" {

int32_t c2d_semihosting_store_init(c2d_semihosting_store* store, const char* folder) {
  memset(store, 0, sizeof *store);
  if (folder == nullptr || folder[0] == '\0' || strlen(folder) >= sizeof store->folder) return C2D_SEMIHOSTING_NAME;
  memcpy(store->folder, folder, strlen(folder));
  return 0;
}

void c2d_semihosting_store_port(c2d_semihosting_store* store, c2d_port* out) {
  out->context = store;
  out->open = open_tape;
  out->read = read_block;
  out->write = write_block;
  out->sync = sync_tape;
  out->close = close_tape;
}

int32_t c2d_semihosting_rewind_deck(c2d_semihosting_deck* deck) {
  const int32_t length = host::length(deck->file);
  deck->first = deck->last = 0;
  deck->left = length < 0 ? 0 : static_cast<uint32_t>(length);
  return length >= 0 && host::seek(deck->file, 0) == 0 ? 0 : C2D_SEMIHOSTING_HOST;
}

int32_t c2d_semihosting_open_deck(c2d_semihosting_deck* deck, const char* name) {
  deck->file = host::open(name, host::Mode::read);
  if (deck->file == -1) return C2D_SEMIHOSTING_HOST;
  return c2d_semihosting_rewind_deck(deck);
}

int32_t c2d_semihosting_close_deck(c2d_semihosting_deck* deck) {
  return host::close(deck->file) == 0 ? 0 : C2D_SEMIHOSTING_HOST;
}

int32_t c2d_semihosting_next_card(void* context, char* text, int32_t size) {
  c2d_semihosting_deck* deck = static_cast<c2d_semihosting_deck*>(context);
  int32_t length = 0, byte = next_byte(deck);
  if (byte < 0) return byte;
  for (; byte >= 0 && byte != '\n'; byte = next_byte(deck)) {
    if (byte == '\r') continue;
    if (length + 1 < size) text[length] = static_cast<char>(byte);
    ++length;
  }
  if (byte < -1) return byte;
  text[length < size ? length : size - 1] = '\0';
  return length;
}

} // extern "C"
