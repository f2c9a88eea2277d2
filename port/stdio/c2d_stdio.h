/* A block store in files tape0.c2d ... tape3.c2d of a folder, using only stdio of the C library: for any hosted C.
   sync is as strong as fflush: the data survive the end of the program, not a power failure (unlike the posix
   store). The folder is not locked against other programs. It must exist.

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

/* Return values of the functions of the store, seen in c2d_error.host_code: positive: errno of the C library, negative: one
   of these. */
enum {
  C2D_STDIO_STORE_TAPE = -1,   /* no such tape, or it is not open                                        */
  C2D_STDIO_STORE_RANGE = -2,  /* a block beyond the end of the tape, too many bytes, an offset too large */
  C2D_STDIO_STORE_END = -3,    /* read: the file ends within the block                                   */
  C2D_STDIO_STORE_FAILED = -4, /* the C library failed without a reason                                  */
  C2D_STDIO_STORE_NAME = -5    /* the name of the folder is missing or too long                          */
};

/* Members are private. */
typedef struct c2d_stdio_store {
  char folder[1000];
  void* file[C2D_TAPES];
  uint64_t blocks[C2D_TAPES], block_bytes[C2D_TAPES];
} c2d_stdio_store;

/* Set the folder (copied; at most 999 bytes). Returns 0 or C2D_STDIO_STORE_NAME. Accesses no file. */
int32_t c2d_stdio_store_init(c2d_stdio_store* store, const char* folder);
/* Set context, open, read, write, sync and close of *out; other members are unchanged. */
void c2d_stdio_store_port(c2d_stdio_store* store, c2d_port* out);
/* Delete the files of the tapes; close them first. Returns 0 or the first failure; a missing file is no failure. */
int32_t c2d_stdio_store_remove(c2d_stdio_store* store);

#ifdef __cplusplus
}
#endif
#endif
