/* A block store in a memory region supplied by the caller. No heap, no system calls: usable anywhere.

     static unsigned char region[1 << 20];
     c2d_memory_store store;
     c2d_port port = C2D_INIT(c2d_port);
     c2d_memory_store_init(&store, region, sizeof region);
     c2d_memory_store_port(&store, &port);

   Contents last as long as the region and the struct. One solver per store. Nothing here is thread-safe; the
   library calls from one thread. */
#ifndef C2D_MEMORY_H
#define C2D_MEMORY_H

#include "contact2d.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Return values of the functions of the store, seen in c2d_error.host_code. */
enum {
  C2D_MEMORY_STORE_FULL = 1, /* open: the region is too small; see c2d_memory_store_need                  */
  C2D_MEMORY_STORE_TAPE = 2, /* no such tape, or it is not open                                           */
  C2D_MEMORY_STORE_RANGE = 3 /* a block beyond the end of the tape, or too many bytes                     */
};

/* Members are private. Offsets are from the start of the region. */
typedef struct c2d_memory_store {
  unsigned char* region;
  uint64_t bytes, used;
  uint64_t offset[C2D_TAPES], room[C2D_TAPES];        /* the part used by a tape               */
  uint64_t blocks[C2D_TAPES], block_bytes[C2D_TAPES]; /* as opened last                         */
  uint64_t wanted[C2D_TAPES];                         /* bytes asked for by the last open       */
  int32_t is_open[C2D_TAPES];
} c2d_memory_store;

/* Empty the store and give it region[0 .. bytes); any alignment. */
void c2d_memory_store_init(c2d_memory_store* store, void* region, uint64_t bytes);
/* Bytes that a region needs for all tapes opened so far, including one that failed for lack of room. A tape reopened with
   another size may need more than this unless _init emptied the region. UINT64_MAX if the number does not fit. */
uint64_t c2d_memory_store_need(const c2d_memory_store* store);
/* Set context, open, read, write, sync and close of *out; other members are unchanged. */
void c2d_memory_store_port(c2d_memory_store* store, c2d_port* out);

#ifdef __cplusplus
}
#endif
#endif
