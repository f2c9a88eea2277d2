/* A block store in files for POSIX systems: transfers at given offsets that go on after interruptions, fsync, and a lock that
   keeps a second solver, in this or another process, out. In the folder that it is given the store makes one of its own,
   contact2d.store, with the files `lock`, which bears its mark, and tape0.c2d ... tape3.c2d; it opens, writes and removes
   nothing else, follows no links, and takes no folder of that name without the mark (a lock that was cut off, its rest
   missing or zeros, beside nothing else, gets it). Room for a tape is reserved when it is opened, where the file system can;
   of a tape most of which will not be written, what c2d_posix_store_expect says. Blocks are read ahead and written behind by
   a thread of the store's, from the first such transfer on until the last tape is closed; it blocks all signals. (Before
   glibc 2.34 programs then link with -pthread.)

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

/* What the store's functions return, seen in c2d_error.host_code: a positive number is errno, a negative one is one
   of these. */
enum {
  C2D_POSIX_STORE_TAPE = -1,   /* no such tape, or it is not open                                        */
  C2D_POSIX_STORE_RANGE = -2,  /* a block beyond the end of the tape, too many bytes, an offset too large */
  C2D_POSIX_STORE_END = -3,    /* read: the file ends before the block does                              */
  C2D_POSIX_STORE_LOCKED = -4, /* init: the folder is in use by another store                            */
  C2D_POSIX_STORE_STUCK = -5,  /* write: the system takes no more bytes without saying why               */
  C2D_POSIX_STORE_TICKET = -6, /* start: four transfers are under way; wait: no such transfer is          */
  C2D_POSIX_STORE_FOREIGN = -7 /* init, open: what has our name is not ours, or a link, or no file         */
};

/* Members are the store's own; do not touch. They are file descriptors, -1: none. */
typedef struct c2d_posix_store {
  int32_t parent, folder, lock;
  int32_t file[C2D_TAPES];
  uint64_t blocks[C2D_TAPES], block_bytes[C2D_TAPES];
  void* helper; /* the thread and its queue; null: none */
  uint64_t expected[C2D_TAPES];
} c2d_posix_store;

/* Make the folder unless it is there (its parent must be), and in it the store's own; lock it until _done or the end of the
   process. Returns 0, C2D_POSIX_STORE_LOCKED, _FOREIGN or errno; after a failure nothing is held. */
int32_t c2d_posix_store_init(c2d_posix_store* store, const char* folder);
/* Set context, open, read, write, sync, close, start_read, start_write and wait of *out; the rest of it is left alone. */
void c2d_posix_store_port(c2d_posix_store* store, c2d_port* out);
/* Of this tape, when it is opened next, no more than so many bytes are reserved (all of it unless this is called: bounds of
   compressed elimination are ten times what it writes, and more). No such tape: nothing is done. */
void c2d_posix_store_expect(c2d_posix_store* store, int32_t tape, uint64_t bytes);
/* Close and delete the tapes; the folder stays locked. Returns 0 or the first errno; a file that is not there is
   no failure. */
int32_t c2d_posix_store_remove(c2d_posix_store* store);
/* Close what is open and let go of the folder. Returns 0 or the first errno. The lock's file stays. */
int32_t c2d_posix_store_done(c2d_posix_store* store);
/* The same after _remove, and the lock's file and the store's own folder go too. `folder`, the name given to _init, is removed
   if nothing else is in it; null: it stays. */
int32_t c2d_posix_store_discard(c2d_posix_store* store, const char* folder);

#ifdef __cplusplus
}
#endif
#endif
