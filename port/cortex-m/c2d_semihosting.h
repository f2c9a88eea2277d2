/* For Cortex-M under a debugger or an emulator: a block store in files tape0.c2d ... tape3.c2d of a folder of the host,
   and the cards of a deck in one. No heap, no system calls: only the breakpoints of Arm's semihosting.

     static c2d_semihosting_store store;
     c2d_port port = C2D_INIT(c2d_port);
     if (c2d_semihosting_store_init(&store, "tapes") != 0) ...
     c2d_semihosting_store_port(&store, &port);                                                               */
#ifndef C2D_SEMIHOSTING_H
#define C2D_SEMIHOSTING_H

#include "contact2d.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What the functions return, seen in c2d_error.host_code. */
enum {
  C2D_SEMIHOSTING_TAPE = -2,  /* no such tape, or it is not open                                    */
  C2D_SEMIHOSTING_RANGE = -3, /* a block beyond the end of the tape, too many bytes, a file of 4 GiB */
  C2D_SEMIHOSTING_HOST = -4,  /* the host refused, or moved fewer bytes                             */
  C2D_SEMIHOSTING_NAME = -5   /* the folder's name is missing or too long                           */
};

/* Members are the store's own; do not touch. */
typedef struct c2d_semihosting_store {
  char folder[64];
  int32_t file[C2D_TAPES]; /* handles plus 1; 0: not open */
  uint32_t blocks[C2D_TAPES], block_bytes[C2D_TAPES];
} c2d_semihosting_store;

/* Remember the folder, which must exist (copied; at most 63 bytes). Returns 0 or C2D_SEMIHOSTING_NAME. */
int32_t c2d_semihosting_store_init(c2d_semihosting_store* store, const char* folder);
/* Set context, open, read, write, sync and close of *out; the rest of it is left alone. What sync promises is what the
   host's files promise after a write. */
void c2d_semihosting_store_port(c2d_semihosting_store* store, c2d_port* out);

/* The cards of a deck: c2d_semihosting_next_card is a c2d_read_line, its context is the deck. */
typedef struct c2d_semihosting_deck {
  int32_t file;
  uint32_t left;        /* bytes of the file that are not in the buffer yet      */
  uint32_t first, last; /* what of the buffer is still to be given               */
  char buffer[128];
} c2d_semihosting_deck;

int32_t c2d_semihosting_open_deck(c2d_semihosting_deck* deck, const char* name); /* 0, or C2D_SEMIHOSTING_HOST */
int32_t c2d_semihosting_rewind_deck(c2d_semihosting_deck* deck);                 /* the same                   */
int32_t c2d_semihosting_close_deck(c2d_semihosting_deck* deck);                  /* the same                   */
int32_t c2d_semihosting_next_card(void* deck, char* text, int32_t size);

#ifdef __cplusplus
}
#endif
#endif
