/* A block store in a region of memory that the caller hands over. No heap, no system calls: usable anywhere.

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

/* What the store's functions return, seen in c2d_error.host_code. */
enum {
  C2D_MEMORY_STORE_FULL = 1, /* open: the region is too small; c2d_memory_store_need tells what would do  */
  C2D_MEMORY_STORE_TAPE = 2, /* no such tape, or it is not open                                           */
  C2D_MEMORY_STORE_RANGE = 3 /* a block beyond the end of the tape, or too many bytes                     */
};

/* Members are the store's own; do not touch. Offsets are from the start of the region. */
typedef struct c2d_memory_store {
  unsigned char* region;
  uint64_t bytes, used;
  uint64_t offset[C2D_TAPES], room[C2D_TAPES];        /* the piece carved for a tape            */
  uint64_t blocks[C2D_TAPES], block_bytes[C2D_TAPES]; /* as opened last                         */
  uint64_t wanted[C2D_TAPES];                         /* bytes asked for by the last open       */
  int32_t is_open[C2D_TAPES];
} c2d_memory_store;

/* Empty the store and give it region[0 .. bytes); any alignment. */
void c2d_memory_store_init(c2d_memory_store* store, void* region, uint64_t bytes);
/* Bytes that a region must have for all tapes opened so far, the one that failed for want of room included. A tape
   opened again with another size may need more than this if the region was not emptied by _init. UINT64_MAX if the
   count does not fit. */
uint64_t c2d_memory_store_need(const c2d_memory_store* store);
/* Set context, open, read, write, sync and close of *out; the rest of it is left alone. */
void c2d_memory_store_port(c2d_memory_store* store, c2d_port* out);

#ifdef __cplusplus
}
#endif
#endif
