/* What the driver tells the preloaded library, by the environment, and what that writes into its log. The library counts every
   operation on files below C2D_FAULT_ROOT, standard input and standard output, from 1, and every allocation after main began.
   Transfers of the store's helper thread are done at once, so that the n-th operation is the same in every run. */
#ifndef C2D_FAULTS_CONTROL_H
#define C2D_FAULTS_CONTROL_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define C2D_FAULT_ROOT "C2D_FAULT_ROOT"       /* folder whose files count                                                  */
#define C2D_FAULT_KIND "C2D_FAULT_KIND"       /* number of a fault_kind                                                    */
#define C2D_FAULT_AT "C2D_FAULT_AT"           /* the operation (of FAULT_MEMORY: allocation) that it strikes               */
#define C2D_FAULT_EVER "C2D_FAULT_EVER"       /* 1: and all that follow                                                    */
#define C2D_FAULT_WHERE "C2D_FAULT_WHERE"     /* only operations on paths that contain this                                */
#define C2D_FAULT_LOG "C2D_FAULT_LOG"         /* file of the log                                                           */
#define C2D_FAULT_DATA "C2D_FAULT_DATA"       /* 1: what is written goes into the log, and the places that ask for memory  */
#define C2D_FAULT_THREADS "C2D_FAULT_THREADS" /* 1: threads may be started                                                 */
#define C2D_FAULT_FREE "C2D_FAULT_FREE"       /* bytes of memory that are free, the program is told                        */

enum fault_kind {
  FAULT_NONE = 0,
  FAULT_FAIL,        /* EIO; what is closed is closed all the same         */
  FAULT_SHORT,       /* half of the bytes are transferred                  */
  FAULT_INTERRUPTED, /* EINTR; for ever: every other time                  */
  FAULT_FULL,        /* ENOSPC where something grows                       */
  FAULT_TORN,        /* half is written, then the process is killed        */
  FAULT_KILLED,      /* killed before the operation                        */
  FAULT_STOPPED,     /* SIGTERM before the operation, which is done        */
  FAULT_HALF,        /* half is written, all is said to be                 */
  FAULT_FLIPPED,     /* one bit of what is read or written is another one  */
  FAULT_LOST,        /* nothing is written: what was there stays, stale    */
  FAULT_MEMORY,      /* no memory                                          */
  FAULT_LATE,        /* what is written is there after the next sync only  */
  FAULT_KINDS
};

enum fault_op {
  OP_OPEN = 0,
  OP_READ,
  OP_WRITE,
  OP_SYNC,
  OP_CLOSE,
  OP_RENAME,
  OP_UNLINK,
  OP_MKDIR,
  OP_RMDIR,
  OP_LOCK,
  OP_TRUNCATE,
  OP_RESERVE, /* room for later writes */
  OP_LINK,
  OP_MODE,
  OP_LOOK,   /* stat, access, names of folders and links */
  OP_MEMORY, /* a place that asks for memory: `number` and `offset` are the first and the last allocation there */
  OP_END,    /* of the process: `offset` tells the number of allocations */
  OP_KINDS
};

enum { OPENED_CREATES = 1, OPENED_TRUNCATES = 2 }; /* flags of OP_OPEN */

/* A record, followed by both paths (absolute, not ended by zeros) and the data. */
struct fault_record {
  uint64_t number, offset, bytes; /* offset and bytes: of a transfer; OP_TRUNCATE, OP_RESERVE: the length in `offset` */
  int32_t op, struck, file, flags, error;
  uint32_t path_bytes, path2_bytes, data_bytes;
};

#ifdef __cplusplus
}
#endif
#endif
