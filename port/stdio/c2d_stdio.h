/* A block store in files tape0.c2d ... tape3.c2d of a folder, through the C library's stdio alone: for any hosted C.
   What sync promises is as strong as fflush: the data survive the end of the program, not a power cut (the posix
   store does better). Nothing keeps a second program out of the folder. The folder must exist.

     c2d_stdio_store store;
     c2d_port port = C2D_INIT(c2d_port);
     if (c2d_stdio_store_init(&store, "/var/tmp/run7") != 0) return 3;
     c2d_stdio_store_port(&store, &port);
*/
#ifndef C2D_STDIO_H
#define C2D_STDIO_H

#include "contact2d.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What the store's functions return, seen in c2d_error.host_code: a positive number is the C library's errno, a
   negative one is one of these. */
enum {
  C2D_STDIO_STORE_TAPE = -1,   /* no such tape, or it is not open                                        */
  C2D_STDIO_STORE_RANGE = -2,  /* a block beyond the end of the tape, too many bytes, an offset too large */
  C2D_STDIO_STORE_END = -3,    /* read: the file ends before the block does                              */
  C2D_STDIO_STORE_FAILED = -4, /* the C library failed without saying why                                */
  C2D_STDIO_STORE_NAME = -5    /* the folder's name is missing or too long                               */
};

/* Members are the store's own; do not touch. */
typedef struct c2d_stdio_store {
  char folder[1000];
  void* file[C2D_TAPES];
  uint64_t blocks[C2D_TAPES], block_bytes[C2D_TAPES];
} c2d_stdio_store;

/* Remember the folder (copied; at most 999 bytes). Returns 0 or C2D_STDIO_STORE_NAME. Touches no file. */
int32_t c2d_stdio_store_init(c2d_stdio_store* store, const char* folder);
/* Set context, open, read, write, sync and close of *out; the rest of it is left alone. */
void c2d_stdio_store_port(c2d_stdio_store* store, c2d_port* out);
/* Delete the tapes' files; close them first. Returns 0 or the first failure; a file that is not there is none. */
int32_t c2d_stdio_store_remove(c2d_stdio_store* store);

#ifdef __cplusplus
}
#endif
#endif
