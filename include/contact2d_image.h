/* contact2d: workspaces that leave their process, with a checksum. c2d_attach of contact2d.h trusts its memory. If an image is
   stored or sent, store its sum with it, and attach by the sum:

     static int store(FILE* file, const c2d_solver* solver, const void* memory, size_t bytes) {
       uint64_t sum;
       if (c2d_image_sum(solver, &sum) != C2D_OK || fwrite(&sum, sizeof sum, 1, file) != 1) return 0;
       return fwrite(memory, 1, bytes, file) == bytes;
     }

     static c2d_solver* load(FILE* file, void* memory, size_t bytes, const c2d_port* port) {
       uint64_t sum;
       c2d_solver* solver = NULL;
       if (fread(&sum, sizeof sum, 1, file) != 1 || fread(memory, 1, bytes, file) != bytes) return NULL;
       return c2d_attach_image(&solver, memory, bytes, port, sum, NULL) == C2D_OK ? solver : NULL;
     }

   The sum detects accidental changes: any change within one aligned word of 8 bytes, and all others except one in 2^64. An
   attacker can compute a valid sum for a modified image: do not attach images from untrusted sources (src/SECURITY.md). */
#ifndef CONTACT2D_IMAGE_H
#define CONTACT2D_IMAGE_H

#include "contact2d.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The checksum of the memory of a solver, between any two calls, in any state. It reads all of the memory and changes nothing; the
   next call on the solver invalidates the sum. */
c2d_status c2d_image_sum(const c2d_solver* solver, uint64_t* sum);
/* c2d_attach for an image whose c2d_image_sum was `sum` when it was copied. Errors: those of c2d_attach; STORE_CHECKSUM: the sum
   differs now. On failure the image is unchanged. */
c2d_status c2d_attach_image(c2d_solver** out, void* memory, size_t bytes, const c2d_port* port, uint64_t sum, c2d_error* why);

#ifdef __cplusplus
}
#endif
#endif
