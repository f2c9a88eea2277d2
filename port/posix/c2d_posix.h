/* A block store in files for POSIX systems: transfers at given offsets, continued after interruptions, fsync, and a lock
   against a second solver in this or another process. In the given folder the store creates a folder of its own,
   contact2d.store, with the files `lock`, which contains its mark, and tape0.c2d ... tape3.c2d. It opens, writes and removes
   nothing else, follows no links, and refuses a folder of that name without the mark (a truncated lock file, missing or zero at
   its end, alone in the folder, is completed). Disk space for a tape is reserved when it is opened, if the file system supports
   it; for a tape that will be written in part only, as much as c2d_posix_store_expect states. A thread of the store reads
   blocks ahead and writes them behind, from the first such transfer until the last tape is closed; it blocks all signals.
   (Before glibc 2.34 programs link with -pthread.)

     c2d_posix_store store;
     c2d_port port = C2D_INIT(c2d_port);
     int32_t code = c2d_posix_store_init(&store, "/var/tmp/run7");
     if (code == C2D_POSIX_STORE_LOCKED) return 3;
     c2d_posix_store_port(&store, &port);

   and after c2d_close c2d_posix_store_remove(&store) if it went well, and c2d_posix_store_done(&store) in any case. */
#ifndef C2D_POSIX_H
#define C2D_POSIX_H

#include "contact2d.h"

#ifdef __cplusplus
extern "C" {
#endif

#define C2D_POSIX_STORE_FOLDER "contact2d.store"

/* Return values of the functions of the store, seen in c2d_error.host_code: positive: errno, negative: one of these. */
enum {
  C2D_POSIX_STORE_TAPE = -1,   /* no such tape, or it is not open                                        */
  C2D_POSIX_STORE_RANGE = -2,  /* a block beyond the end of the tape, too many bytes, an offset too large */
  C2D_POSIX_STORE_END = -3,    /* read: the file ends within the block                                   */
  C2D_POSIX_STORE_LOCKED = -4, /* init: the folder is in use by another store                            */
  C2D_POSIX_STORE_STUCK = -5,  /* write: the system accepts no more bytes, without a reason              */
  C2D_POSIX_STORE_TICKET = -6, /* start: four transfers are active; wait: there is no such transfer       */
  C2D_POSIX_STORE_FOREIGN = -7 /* init, open: a foreign object of this name, or a link, or not a file      */
};

/* Members are private. File descriptors, -1: none. */
typedef struct c2d_posix_store {
  int32_t parent, folder, lock;
  int32_t file[C2D_TAPES];
  uint64_t blocks[C2D_TAPES], block_bytes[C2D_TAPES];
  void* helper; /* the thread and its queue; null: none */
  uint64_t expected[C2D_TAPES];
} c2d_posix_store;

/* Create the folder unless it exists (its parent must exist), and in it the folder of the store; lock it until _done or the end
   of the process. Returns 0, C2D_POSIX_STORE_LOCKED, _FOREIGN or errno; after a failure nothing is locked or open. */
int32_t c2d_posix_store_init(c2d_posix_store* store, const char* folder);
/* Set context, open, read, write, sync, close, start_read, start_write and wait of *out; other members are unchanged. */
void c2d_posix_store_port(c2d_posix_store* store, c2d_port* out);
/* Reserve at most so many bytes when this tape is opened next (default: all of it; the bounds of compressed elimination are ten
   times its actual size and more). Does nothing if there is no such tape. */
void c2d_posix_store_expect(c2d_posix_store* store, int32_t tape, uint64_t bytes);
/* Close and delete the tapes; the folder stays locked. Returns 0 or the first errno; a missing file is no failure. */
int32_t c2d_posix_store_remove(c2d_posix_store* store);
/* Close all files and unlock the folder. Returns 0 or the first errno. The lock file stays. */
int32_t c2d_posix_store_done(c2d_posix_store* store);
/* The same after _remove, and delete the lock file and the folder of the store. `folder`, the name given to _init, is removed
   if it is empty then; null: it stays. */
int32_t c2d_posix_store_discard(c2d_posix_store* store, const char* folder);

#ifdef __cplusplus
}
#endif
#endif
