/* contact2d: workspaces that leave their process, with a checksum. c2d_attach of contact2d.h takes up what it is given: what
   says of itself that it is a solver is believed. Where an image was stored or sent, keep its sum beside it, and attach by it:

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

   The sum finds accidents: any change within one aligned word of 8 bytes, and others but for one in 2^64. Whoever changes an
   image on purpose can make a sum for it: images from strangers must not be attached (src/SECURITY.md). */
#ifndef CONTACT2D_IMAGE_H
#define CONTACT2D_IMAGE_H

#include "contact2d.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The checksum of a solver's memory as it stands, between any two calls, in any state. It reads all of it, and changes nothing;
   the next call on the solver makes it void. */
c2d_status c2d_image_sum(const c2d_solver* solver, uint64_t* sum);
/* c2d_attach of an image of which c2d_image_sum gave `sum` when it was copied. Errors: those of c2d_attach; STORE_CHECKSUM: it
   is another one now. On failure the image is as it was. */
c2d_status c2d_attach_image(c2d_solver** out, void* memory, size_t bytes, const c2d_port* port, uint64_t sum, c2d_error* why);

#ifdef __cplusplus
}
#endif
#endif
