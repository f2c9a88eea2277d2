#ifndef _FILE_OFFSET_BITS
#define _FILE_OFFSET_BITS 64
#endif
#include "transfers.hpp"
#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>

namespace {

// The most that is handed to the system at once: some systems refuse more than 2^31 - 1 bytes.
constexpr uint64_t kTransferBytes = uint64_t(1) << 30;

c2d_posix_store* self(void* context) { return static_cast<c2d_posix_store*>(context); }

bool is_open(const c2d_posix_store* s, int32_t tape) { return tape >= 0 && tape < C2D_TAPES && s->file[tape] >= 0; }

struct FileName {
  char text[16];
};
FileName file_name(int32_t tape) {
  FileName name = {"tape0.c2d"};
  name.text[4] = static_cast<char>('0' + tape);
  return name;
}

int open_at(int folder, const char* name, int flags) {
  int file;
  do {
    file = openat(folder, name, flags | O_RDWR | O_CLOEXEC, 0666);
  } while (file < 0 && errno == EINTR);
  return file;
}

int32_t sync_file(int file) {
  int result;
  do {
    result = fsync(file);
  } while (result != 0 && errno == EINTR);
  return result == 0 ? 0 : errno;
}

// Close once, whatever happens: after EINTR the descriptor may belong to someone else already.
int32_t close_file(int32_t* file) {
  if (*file < 0) return 0;
  const int32_t code = close(*file) == 0 || errno == EINTR ? 0 : errno;
  *file = -1;
  return code;
}

// An existing file keeps its contents. A new one must be found again after a crash, hence the folder's fsync.
int32_t open_tape(void* context, int32_t tape, uint64_t blocks, uint64_t block_bytes) {
  c2d_posix_store* s = self(context);
  if (tape < 0 || tape >= C2D_TAPES) return C2D_POSIX_STORE_TAPE;
  if (blocks != 0 && block_bytes > static_cast<uint64_t>(INT64_MAX) / blocks) return C2D_POSIX_STORE_RANGE;
  const int32_t closed = close_file(&s->file[tape]);
  if (closed != 0) return closed;
  const FileName name = file_name(tape);
  int file = open_at(s->folder, name.text, 0);
  if (file < 0 && errno == ENOENT) {
    file = open_at(s->folder, name.text, O_CREAT);
    const int32_t code = file < 0 ? 0 : sync_file(s->folder);
    // Some file systems cannot sync folders; theirs need no help.
    if (code != 0 && code != EINVAL) {
      close(file);
      return code;
    }
  }
  if (file < 0) return errno;
  s->file[tape] = file;
  s->blocks[tape] = blocks;
  s->block_bytes[tape] = block_bytes;
  return 0;
}

int32_t check(const c2d_posix_store* s, int32_t tape, uint64_t block, uint64_t bytes) {
  if (!is_open(s, tape)) return C2D_POSIX_STORE_TAPE;
  const bool fits = block < s->blocks[tape] && bytes <= s->block_bytes[tape];
  return fits ? 0 : C2D_POSIX_STORE_RANGE;
}

// Is offset + bytes a file offset on this system?
bool is_offset(uint64_t end) {
  const off_t place = static_cast<off_t>(end);
  return place >= 0 && static_cast<uint64_t>(place) == end;
}

size_t part(uint64_t bytes) { return static_cast<size_t>(bytes < kTransferBytes ? bytes : kTransferBytes); }

int32_t read_block(void* context, int32_t tape, uint64_t block, void* data, uint64_t bytes) {
  c2d_posix_store* s = self(context);
  const int32_t code = check(s, tape, block, bytes);
  if (code != 0) return code;
  const uint64_t start = block * s->block_bytes[tape];
  if (!is_offset(start + bytes)) return C2D_POSIX_STORE_RANGE;
  char* to = static_cast<char*>(data);
  for (uint64_t done = 0; done < bytes;) {
    const ssize_t got = pread(s->file[tape], to + done, part(bytes - done), static_cast<off_t>(start + done));
    if (got == 0) return C2D_POSIX_STORE_END;
    if (got < 0 && errno != EINTR) return errno;
    if (got > 0) done += static_cast<uint64_t>(got);
  }
  return 0;
}

int32_t write_block(void* context, int32_t tape, uint64_t block, const void* data, uint64_t bytes) {
  c2d_posix_store* s = self(context);
  const int32_t code = check(s, tape, block, bytes);
  if (code != 0) return code;
  const uint64_t start = block * s->block_bytes[tape];
  if (!is_offset(start + bytes)) return C2D_POSIX_STORE_RANGE;
  const char* from = static_cast<const char*>(data);
  for (uint64_t done = 0; done < bytes;) {
    const ssize_t put = pwrite(s->file[tape], from + done, part(bytes - done), static_cast<off_t>(start + done));
    if (put == 0) return C2D_POSIX_STORE_STUCK;
    if (put < 0 && errno != EINTR) return errno;
    if (put > 0) done += static_cast<uint64_t>(put);
  }
  return 0;
}

int32_t sync_tape(void* context, int32_t tape) {
  if (!is_open(self(context), tape)) return C2D_POSIX_STORE_TAPE;
  return sync_file(self(context)->file[tape]);
}

int32_t close_tape(void* context, int32_t tape) {
  c2d_posix_store* s = self(context);
  if (!is_open(s, tape)) return C2D_POSIX_STORE_TAPE;
  bool others = false;
  for (int32_t other = 0; other < C2D_TAPES; ++other) others |= other != tape && is_open(s, other);
  if (!others) stop_posix_transfers(s);
  return close_file(&s->file[tape]);
}

int32_t read_in_turn(void* context, int32_t tape, uint64_t block, void* data, uint64_t bytes) {
  settle_posix_transfers(self(context), tape, block);
  return read_block(context, tape, block, data, bytes);
}
int32_t write_in_turn(void* context, int32_t tape, uint64_t block, const void* data, uint64_t bytes) {
  settle_posix_transfers(self(context), tape, block);
  return write_block(context, tape, block, data, bytes);
}

int32_t start_read(void* context, int32_t tape, uint64_t block, void* data, uint64_t bytes, int32_t* ticket) {
  return start_posix_transfer(self(context), {tape, false, block, bytes, data}, ticket);
}
int32_t start_write(void* context, int32_t tape, uint64_t block, const void* data, uint64_t bytes, int32_t* ticket) {
  return start_posix_transfer(self(context), {tape, true, block, bytes, const_cast<void*>(data)}, ticket);
}
int32_t wait(void* context, int32_t ticket) { return wait_posix_transfer(self(context), ticket); }

// 0: locked; C2D_POSIX_STORE_LOCKED: by someone else; or errno.
int32_t lock_file(int file) {
  int result;
  do {
    result = flock(file, LOCK_EX | LOCK_NB);
  } while (result != 0 && errno == EINTR);
  if (result == 0) return 0;
  return errno == EWOULDBLOCK || errno == EACCES ? C2D_POSIX_STORE_LOCKED : errno;
}

// A lock's file may be deleted by its holder between our opening and locking it: such a lock keeps nobody
// out. Then the next one is tried; each turn means that another store has come and gone.
int32_t lock_folder(c2d_posix_store* s) {
  for (int32_t turn = 0; turn < 10; ++turn) {
    s->lock = open_at(s->folder, "lock", O_CREAT);
    if (s->lock < 0) return errno;
    const int32_t code = lock_file(s->lock);
    if (code != 0) return code;
    struct stat info;
    if (fstat(s->lock, &info) != 0) return errno;
    if (info.st_nlink > 0) return 0;
    close_file(&s->lock);
  }
  return C2D_POSIX_STORE_LOCKED;
}

} // namespace

int32_t do_posix_transfer(c2d_posix_store* store, const PosixTransfer& t) {
  return t.writes ? write_block(store, t.tape, t.block, t.data, t.bytes) : read_block(store, t.tape, t.block, t.data, t.bytes);
}

extern "C" {

int32_t c2d_posix_store_init(c2d_posix_store* store, const char* folder) {
  memset(store, 0, sizeof *store);
  store->folder = store->lock = -1;
  for (int32_t tape = 0; tape < C2D_TAPES; ++tape) store->file[tape] = -1;
  if (!folder || folder[0] == '\0') return ENOENT;
  if (mkdir(folder, 0777) != 0 && errno != EEXIST) return errno;
  store->folder = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (store->folder < 0) return errno;
  const int32_t code = lock_folder(store);
  if (code != 0) {
    close_file(&store->lock);
    close_file(&store->folder);
  }
  return code;
}

void c2d_posix_store_port(c2d_posix_store* store, c2d_port* out) {
  out->context = store;
  out->open = open_tape;
  out->read = read_in_turn;
  out->write = write_in_turn;
  out->sync = sync_tape;
  out->close = close_tape;
  out->start_read = start_read;
  out->start_write = start_write;
  out->wait = wait;
}

int32_t c2d_posix_store_remove(c2d_posix_store* store) {
  int32_t first = 0;
  stop_posix_transfers(store);
  for (int32_t tape = 0; tape < C2D_TAPES; ++tape) {
    const int32_t closed = close_file(&store->file[tape]);
    if (first == 0) first = closed;
    const FileName name = file_name(tape);
    if (unlinkat(store->folder, name.text, 0) != 0 && errno != ENOENT && first == 0) first = errno;
  }
  return first;
}

int32_t c2d_posix_store_done(c2d_posix_store* store) {
  int32_t first = 0;
  stop_posix_transfers(store);
  for (int32_t tape = 0; tape < C2D_TAPES; ++tape) {
    const int32_t code = close_file(&store->file[tape]);
    if (first == 0) first = code;
  }
  const int32_t folder = close_file(&store->folder);
  const int32_t lock = close_file(&store->lock); // lets go of the lock
  if (first == 0) first = folder != 0 ? folder : lock;
  return first;
}

int32_t c2d_posix_store_discard(c2d_posix_store* store, const char* folder) {
  int32_t first = c2d_posix_store_remove(store);
  if (unlinkat(store->folder, "lock", 0) != 0 && errno != ENOENT && first == 0) first = errno;
  const int32_t code = c2d_posix_store_done(store);
  if (first == 0) first = code;
  const bool removed = !folder || rmdir(folder) == 0 || errno == ENOTEMPTY || errno == EEXIST || errno == ENOENT;
  return first == 0 && !removed ? errno : first;
}

} // extern "C"
