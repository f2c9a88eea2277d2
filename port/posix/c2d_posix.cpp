#ifndef _FILE_OFFSET_BITS
#define _FILE_OFFSET_BITS 64
#endif
#include "transfers.hpp"
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/types.h>
#include <unistd.h>

namespace {

// Largest single transfer: some systems refuse more than 2^31 - 1 bytes.
constexpr uint64_t kTransferBytes = uint64_t(1) << 30;

c2d_posix_store* self(void* context) { return static_cast<c2d_posix_store*>(context); }

bool is_open(const c2d_posix_store* s, int32_t tape) { return tape >= 0 && tape < C2D_TAPES && s->file[tape] >= 0; }

constexpr char kOwnFolder[] = C2D_POSIX_STORE_FOLDER, kLock[] = "lock";
constexpr char kMark[] = "contact2d block store\n"; // contents of the lock file
constexpr uint64_t kMarkBytes = sizeof kMark - 1;

struct FileName {
  char text[16];
};
FileName file_name(int32_t tape) {
  FileName name = {"tape0.c2d"};
  name.text[4] = static_cast<char>('0' + tape);
  return name;
}

// Never through a link, which could lead to a foreign file.
int open_at(int folder, const char* name, int flags) {
  int file;
  do {
    file = openat(folder, name, flags | O_NOFOLLOW | O_CLOEXEC, 0666);
  } while (file < 0 && errno == EINTR);
  return file;
}

// A regular file with this one name? 0, C2D_POSIX_STORE_FOREIGN or errno.
int32_t check_own(int file) {
  struct stat about;
  if (fstat(file, &about) != 0) return errno;
  return S_ISREG(about.st_mode) && about.st_nlink <= 1 ? 0 : C2D_POSIX_STORE_FOREIGN;
}

// Of a failed open_at.
int32_t open_code(int code) { return code == ELOOP || code == EISDIR || code == ENOTDIR ? C2D_POSIX_STORE_FOREIGN : code; }

int32_t sync_file(int file) {
  int result;
  do {
    result = fsync(file);
  } while (result != 0 && errno == EINTR);
  return result == 0 ? 0 : errno;
}

// A new name must survive a crash. File systems that cannot sync folders do not need it.
int32_t sync_folder(int folder) {
  const int32_t code = sync_file(folder);
  return code == EINVAL || code == ENOTSUP ? 0 : code;
}

// Reserves space for the whole tape, so that a full disk is detected before the work. The length of the file stays what has
// been written. File systems that do not report free space are assumed to have enough; if the space is insufficient none is
// kept.
int32_t reserve(int file, uint64_t bytes) {
#ifdef FALLOC_FL_KEEP_SIZE
  constexpr uint64_t kUnit = 512; // of st_blocks
  struct stat about;
  struct statvfs disk;
  if (fstat(file, &about) != 0) return errno;
  const uint64_t has = static_cast<uint64_t>(about.st_blocks) * kUnit;
  if (has >= bytes) return 0; // not even its time changes
  if (fstatvfs(file, &disk) == 0 && disk.f_blocks > 0 && bytes - has > uint64_t(disk.f_bavail) * disk.f_frsize) return ENOSPC;
  int result;
  do {
    result = fallocate(file, FALLOC_FL_KEEP_SIZE, 0, static_cast<off_t>(bytes));
  } while (result != 0 && errno == EINTR);
  const int32_t code = result == 0 ? 0 : errno;
  if (code != ENOSPC && code != EDQUOT && code != EFBIG) return 0;
  while (ftruncate(file, about.st_size) != 0 && errno == EINTR) { // release the reserved part
  }
  return code;
#else
  static_cast<void>(file), static_cast<void>(bytes);
  return 0;
#endif
}

// Close only once: after EINTR the descriptor may already belong to another thread.
int32_t close_file(int32_t* file) {
  if (*file < 0) return 0;
  const int32_t code = close(*file) == 0 || errno == EINTR ? 0 : errno;
  *file = -1;
  return code;
}

// The largest file offset of this system.
constexpr uint64_t kMostBytes = sizeof(off_t) == 8 ? static_cast<uint64_t>(INT64_MAX) : static_cast<uint64_t>(INT32_MAX);

// An existing file keeps its contents.
int32_t open_tape(void* context, int32_t tape, uint64_t blocks, uint64_t block_bytes) {
  c2d_posix_store* s = self(context);
  if (tape < 0 || tape >= C2D_TAPES) return C2D_POSIX_STORE_TAPE;
  if (blocks != 0 && block_bytes > kMostBytes / blocks) return C2D_POSIX_STORE_RANGE;
  int32_t code = close_file(&s->file[tape]);
  if (code != 0) return code;
  const FileName name = file_name(tape);
  int32_t file = open_at(s->folder, name.text, O_RDWR);
  const bool is_new = file < 0 && errno == ENOENT;
  if (is_new) file = open_at(s->folder, name.text, O_RDWR | O_CREAT | O_EXCL);
  if (file < 0) return open_code(errno);
  code = is_new ? sync_folder(s->folder) : check_own(file);
  const uint64_t bytes = blocks * block_bytes;
  if (code == 0) code = reserve(file, bytes < s->expected[tape] ? bytes : s->expected[tape]);
  if (code != 0) {
    close_file(&file);
    return code;
  }
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

size_t part(uint64_t bytes) { return static_cast<size_t>(bytes < kTransferBytes ? bytes : kTransferBytes); }

int32_t read_block(void* context, int32_t tape, uint64_t block, void* data, uint64_t bytes) {
  c2d_posix_store* s = self(context);
  const int32_t code = check(s, tape, block, bytes);
  if (code != 0) return code;
  const uint64_t start = block * s->block_bytes[tape];
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

// 0: locked; C2D_POSIX_STORE_LOCKED: locked by another store; or errno.
int32_t lock_file(int file) {
  int result;
  do {
    result = flock(file, LOCK_EX | LOCK_NB);
  } while (result != 0 && errno == EINTR);
  if (result == 0) return 0;
  return errno == EWOULDBLOCK || errno == EACCES ? C2D_POSIX_STORE_LOCKED : errno;
}

// 0: empty, or only the lock; C2D_POSIX_STORE_FOREIGN or errno.
int32_t check_lone(int folder) {
  const int copy = open_at(folder, ".", O_RDONLY | O_DIRECTORY); // fdopendir takes it over
  DIR* list = copy < 0 ? nullptr : fdopendir(copy);
  if (!list) {
    const int32_t code = errno;
    if (copy >= 0) close(copy);
    return code;
  }
  bool lone = true;
  while (const dirent* entry = readdir(list))
    lone = lone && (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0 || strcmp(entry->d_name, kLock) == 0);
  closedir(list);
  return lone ? 0 : C2D_POSIX_STORE_FOREIGN;
}

// What the lock file begins with, up to one byte more than the mark has. 0 or errno.
int32_t read_mark(c2d_posix_store* s, char found[kMarkBytes + 1], uint64_t* bytes) {
  *bytes = 0;
  for (ssize_t got = 1; got != 0 && *bytes <= kMarkBytes;) { // up to the end of the file
    got = pread(s->lock, found + *bytes, static_cast<size_t>(kMarkBytes + 1 - *bytes), static_cast<off_t>(*bytes));
    if (got < 0 && errno != EINTR) return errno;
    if (got > 0) *bytes += static_cast<uint64_t>(got);
  }
  return 0;
}

// The lock file is new: write the mark, then sync the names. It is read again: without the whole mark, files beside it would
// seem to be another's.
int32_t write_mark(c2d_posix_store* s) {
  for (uint64_t done = 0; done < kMarkBytes;) {
    const ssize_t put = pwrite(s->lock, kMark + done, static_cast<size_t>(kMarkBytes - done), static_cast<off_t>(done));
    if (put == 0) return C2D_POSIX_STORE_STUCK;
    if (put < 0 && errno != EINTR) return errno;
    if (put > 0) done += static_cast<uint64_t>(put);
  }
  const int32_t codes[] = {sync_file(s->lock), sync_folder(s->folder), sync_folder(s->parent)};
  for (const int32_t code : codes)
    if (code != 0) return code;
  char found[kMarkBytes + 1];
  uint64_t bytes = 0;
  const int32_t code = read_mark(s, found, &bytes);
  if (code != 0) return code;
  return bytes == kMarkBytes && memcmp(found, kMark, kMarkBytes) == 0 ? 0 : C2D_POSIX_STORE_STUCK;
}

// Under the lock: is the mark in its file? A store that was interrupted before the mark was on disk leaves its beginning,
// followed by zeros, and no other file: it was never used.
int32_t check_mark(c2d_posix_store* s) {
  char found[kMarkBytes + 1];
  uint64_t bytes = 0;
  int32_t code = read_mark(s, found, &bytes);
  if (code != 0) return code;
  if (bytes > kMarkBytes) return C2D_POSIX_STORE_FOREIGN;
  uint64_t same = 0, zeros = 0;
  while (same < bytes && found[same] == kMark[same]) ++same;
  while (same + zeros < bytes && found[same + zeros] == '\0') ++zeros;
  if (same == kMarkBytes) return 0;
  if (same + zeros < bytes) return C2D_POSIX_STORE_FOREIGN;
  code = check_lone(s->folder);
  return code == 0 ? write_mark(s) : code;
}

// The folder of the store in `parent`, and its lock file, which a folder that is not empty must have. ENOENT: its owner has
// just removed it.
int32_t open_own(c2d_posix_store* s) {
  if (mkdirat(s->parent, kOwnFolder, 0777) != 0 && errno != EEXIST) return errno;
  s->folder = open_at(s->parent, kOwnFolder, O_RDONLY | O_DIRECTORY);
  if (s->folder < 0) return open_code(errno);
  s->lock = open_at(s->folder, kLock, O_RDWR);
  if (s->lock >= 0) return check_own(s->lock);
  if (errno != ENOENT) return open_code(errno);
  const int32_t code = check_lone(s->folder);
  if (code != 0) return code;
  s->lock = open_at(s->folder, kLock, O_RDWR | O_CREAT);
  return s->lock < 0 ? open_code(errno) : check_own(s->lock);
}

// The owner may delete the lock file between our opening and locking it: such a lock protects nothing. Then
// try again; every retry means that another store was created and removed.
int32_t lock_own(c2d_posix_store* s) {
  for (int32_t turn = 0; turn < 10; ++turn) {
    int32_t code = open_own(s);
    if (code == 0) code = lock_file(s->lock);
    struct stat info;
    if (code == 0 && fstat(s->lock, &info) != 0) code = errno;
    if (code == 0 && info.st_nlink > 0) return check_mark(s);
    if (code != 0 && code != ENOENT) return code;
    close_file(&s->lock);
    close_file(&s->folder);
  }
  return C2D_POSIX_STORE_LOCKED;
}

// The folder that the caller names, and ours in it.
int32_t open_folders(c2d_posix_store* s, const char* folder) {
  const bool made = mkdir(folder, 0777) == 0;
  if (!made && errno != EEXIST) return errno;
  do {
    s->parent = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  } while (s->parent < 0 && errno == EINTR);
  if (s->parent < 0) return errno;
  int32_t above = made ? open_at(s->parent, "..", O_RDONLY | O_DIRECTORY) : -1;
  const int32_t code = above < 0 ? 0 : sync_folder(above); // one that may not be read cannot be helped
  close_file(&above);
  return code == 0 ? lock_own(s) : code;
}

} // namespace

int32_t do_posix_transfer(c2d_posix_store* store, const PosixTransfer& t) {
  return t.writes ? write_block(store, t.tape, t.block, t.data, t.bytes) : read_block(store, t.tape, t.block, t.data, t.bytes);
}

extern "C" {

int32_t c2d_posix_store_init(c2d_posix_store* store, const char* folder) {
  memset(store, 0, sizeof *store);
  store->parent = store->folder = store->lock = -1;
  for (int32_t tape = 0; tape < C2D_TAPES; ++tape) store->file[tape] = -1, store->expected[tape] = UINT64_MAX;
  if (!folder || folder[0] == '\0') return ENOENT;
  const int32_t code = open_folders(store, folder);
  if (code != 0) c2d_posix_store_done(store);
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

void c2d_posix_store_expect(c2d_posix_store* store, int32_t tape, uint64_t bytes) {
  if (tape >= 0 && tape < C2D_TAPES) store->expected[tape] = bytes;
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
  int32_t* const rest[] = {&store->folder, &store->parent, &store->lock}; // closing the last one unlocks
  for (int32_t* file : rest) {
    const int32_t code = close_file(file);
    if (first == 0) first = code;
  }
  return first;
}

int32_t c2d_posix_store_discard(c2d_posix_store* store, const char* folder) {
  int32_t first = c2d_posix_store_remove(store);
  const auto note = [&first](int result) { // foreign files stay
    if (result != 0 && errno != ENOENT && errno != ENOTEMPTY && errno != EEXIST && first == 0) first = errno;
  };
  // Remove the mark last, also after a crash: without it the remaining files could not be identified.
  if (first == 0) first = sync_folder(store->folder);
  if (first == 0) {
    note(unlinkat(store->folder, kLock, 0));
    note(unlinkat(store->parent, kOwnFolder, AT_REMOVEDIR));
  }
  const bool emptied = first == 0; // whatever closing says
  const int32_t code = c2d_posix_store_done(store);
  if (first == 0) first = code;
  if (folder && emptied) note(rmdir(folder));
  return first;
}

} // extern "C"
