// 64-bit offsets if the C library supports them.
#ifndef _FILE_OFFSET_BITS
#define _FILE_OFFSET_BITS 64
#endif
#include "c2d_stdio.h"
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#if !defined(_WIN32) && (defined(__unix__) || defined(__APPLE__))
#include <sys/types.h>
#define C2D_HAS_FSEEKO 1
#endif

namespace {

constexpr size_t kNameBytes = sizeof(c2d_stdio_store::folder) + 16;

c2d_stdio_store* self(void* context) { return static_cast<c2d_stdio_store*>(context); }

bool is_tape(int32_t tape) { return tape >= 0 && tape < C2D_TAPES; }

FILE* file_of(const c2d_stdio_store* s, int32_t tape) { return is_tape(tape) ? static_cast<FILE*>(s->file[tape]) : nullptr; }

// errno of the last failed call; the C standard does not guarantee that it is set.
int32_t failure() { return errno > 0 ? static_cast<int32_t>(errno) : C2D_STDIO_STORE_FAILED; }

void file_name(const c2d_stdio_store* s, int32_t tape, char name[kNameBytes]) {
  const size_t length = strlen(s->folder);
  memcpy(name, s->folder, length);
  memcpy(name + length, "/tape0.c2d", 11);
  name[length + 5] = static_cast<char>('0' + tape);
}

int32_t seek(FILE* file, uint64_t offset) {
  errno = 0;
#if defined(_WIN32)
  if (offset > static_cast<uint64_t>(INT64_MAX)) return C2D_STDIO_STORE_RANGE;
  return _fseeki64(file, static_cast<int64_t>(offset), SEEK_SET) == 0 ? 0 : failure();
#elif defined(C2D_HAS_FSEEKO)
  const off_t place = static_cast<off_t>(offset);
  if (place < 0 || static_cast<uint64_t>(place) != offset) return C2D_STDIO_STORE_RANGE;
  return fseeko(file, place, SEEK_SET) == 0 ? 0 : failure();
#else
  if (offset > static_cast<uint64_t>(LONG_MAX)) return C2D_STDIO_STORE_RANGE;
  return fseek(file, static_cast<long>(offset), SEEK_SET) == 0 ? 0 : failure();
#endif
}

// A tape that was left open is closed first; an existing file keeps its contents.
int32_t open_tape(void* context, int32_t tape, uint64_t blocks, uint64_t block_bytes) {
  c2d_stdio_store* s = self(context);
  if (!is_tape(tape)) return C2D_STDIO_STORE_TAPE;
  if (blocks != 0 && block_bytes > static_cast<uint64_t>(INT64_MAX) / blocks) return C2D_STDIO_STORE_RANGE;
  if (s->file[tape]) {
    errno = 0;
    const int closed = fclose(file_of(s, tape));
    s->file[tape] = nullptr;
    if (closed != 0) return failure();
  }
  char name[kNameBytes];
  file_name(s, tape, name);
  errno = 0;
  FILE* file = fopen(name, "r+b");
  // Create only missing files: "w+b" would empty one that could not be opened for another reason.
  if (!file && errno == ENOENT) file = fopen(name, "w+b");
  if (!file) return failure();
  s->file[tape] = file;
  s->blocks[tape] = blocks;
  s->block_bytes[tape] = block_bytes;
  return 0;
}

// Seek to the offset of a transfer.
int32_t go_to(c2d_stdio_store* s, int32_t tape, uint64_t block, uint64_t bytes) {
  FILE* file = file_of(s, tape);
  if (!file) return C2D_STDIO_STORE_TAPE;
  if (block >= s->blocks[tape] || bytes > s->block_bytes[tape]) return C2D_STDIO_STORE_RANGE;
  return seek(file, block * s->block_bytes[tape]);
}

int32_t read_block(void* context, int32_t tape, uint64_t block, void* data, uint64_t bytes) {
  const int32_t code = go_to(self(context), tape, block, bytes);
  if (code != 0) return code;
  FILE* file = file_of(self(context), tape);
  errno = 0;
  if (fread(data, 1, static_cast<size_t>(bytes), file) == bytes) return 0;
  const int32_t result = feof(file) ? C2D_STDIO_STORE_END : failure();
  clearerr(file);
  return result;
}

int32_t write_block(void* context, int32_t tape, uint64_t block, const void* data, uint64_t bytes) {
  const int32_t code = go_to(self(context), tape, block, bytes);
  if (code != 0) return code;
  FILE* file = file_of(self(context), tape);
  errno = 0;
  if (fwrite(data, 1, static_cast<size_t>(bytes), file) == bytes) return 0;
  const int32_t result = failure();
  clearerr(file);
  return result;
}

int32_t sync_tape(void* context, int32_t tape) {
  FILE* file = file_of(self(context), tape);
  if (!file) return C2D_STDIO_STORE_TAPE;
  errno = 0;
  return fflush(file) == 0 ? 0 : failure();
}

int32_t close_tape(void* context, int32_t tape) {
  FILE* file = file_of(self(context), tape);
  if (!file) return C2D_STDIO_STORE_TAPE;
  self(context)->file[tape] = nullptr;
  errno = 0;
  return fclose(file) == 0 ? 0 : failure();
}

} // namespace

extern "C" {

int32_t c2d_stdio_store_init(c2d_stdio_store* store, const char* folder) {
  memset(store, 0, sizeof *store);
  if (!folder || folder[0] == '\0') return C2D_STDIO_STORE_NAME;
  const size_t length = strlen(folder);
  if (length >= sizeof store->folder) return C2D_STDIO_STORE_NAME;
  memcpy(store->folder, folder, length + 1);
  return 0;
}

void c2d_stdio_store_port(c2d_stdio_store* store, c2d_port* out) {
  out->context = store;
  out->open = open_tape;
  out->read = read_block;
  out->write = write_block;
  out->sync = sync_tape;
  out->close = close_tape;
}

int32_t c2d_stdio_store_remove(c2d_stdio_store* store) {
  int32_t first = 0;
  for (int32_t tape = 0; tape < C2D_TAPES; ++tape) {
    char name[kNameBytes];
    file_name(store, tape, name);
    errno = 0;
    if (remove(name) != 0 && errno != ENOENT && first == 0) first = failure();
  }
  return first;
}

} // extern "C"
