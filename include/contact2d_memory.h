/* contact2d: the memory of a solver as a constant, for hosts with static arrays. Others ask c2d_memory_need of contact2d.h.

   C2D_MEMORY_BYTES(function_nodes, points1, points2, elements1, elements2, regions1, regions2, zones, pairs,
                    contact_elements, point_loads, coefficients, paths, load_cases)

   is a constant expression of C and C++ (and of #if), for static arrays: never less than the `minimum` of
   c2d_memory_need for limits of these numbers (panel_columns 0), and at most 5 % + 1 KiB more. The arguments stand
   in the order of c2d_limits; body 2 has zeros if there is only one body.

     static unsigned char memory[C2D_MEMORY_BYTES(2, 40, 40, 40, 40, 1, 1, 1, 12, 11, 0, 2, 1, 1)];

   C2D_FREE_MEMORY_BYTES(..., load_cases, free_pairs) is the same with one argument more, for limits with free zones.

   Limits with point_sets add C2D_POINTS_BYTES(point_sets) to either, those with curves C2D_CURVES_BYTES(curves).

   The macros below are its parts: they repeat, line by line, what the library lays out. */
#ifndef CONTACT2D_MEMORY_H
#define CONTACT2D_MEMORY_H

#include <stdint.h>

#define C2D_MEMORY_BYTES(function_nodes, points1, points2, elements1, elements2, regions1, regions2, zones, pairs,     \
                         contact_elements, point_loads, coefficients, paths, load_cases)                               \
  C2D_FREE_MEMORY_BYTES(function_nodes, points1, points2, elements1, elements2, regions1, regions2, zones, pairs,      \
                        contact_elements, point_loads, coefficients, paths, load_cases, 0)
#define C2D_FREE_MEMORY_BYTES(function_nodes, points1, points2, elements1, elements2, regions1, regions2, zones,       \
                              pairs, contact_elements, point_loads, coefficients, paths, load_cases, free_pairs)       \
  (63 /* to the first multiple of 64 */ + C2D_ROUND_(C2D_SOLVER_BYTES) +                                               \
   C2D_BODY_BYTES_(function_nodes, points1, elements1, regions1, C2D_CASES_(load_cases)) +                             \
   C2D_BODY_BYTES_(function_nodes, points2, elements2, regions2, C2D_CASES_(load_cases)) +                             \
   C2D_LIST_BYTES_(zones, pairs, point_loads, coefficients, paths, C2D_CASES_(load_cases)) +                           \
   0 * UINT64_C(1) * (contact_elements) /* kept within their zones */ +                                                \
   C2D_PHASE_BYTES_(C2D_NODES_(function_nodes, points1, elements1, regions1),                                           \
                    C2D_ENDS_(function_nodes, elements1),                                                              \
                    C2D_NODES_(function_nodes, points2, elements2, regions2),                                          \
                    C2D_ENDS_(function_nodes, elements2),                                                              \
                    UINT64_C(2) * (pairs), UINT64_C(1) * C2D_CASES_(load_cases), UINT64_C(2) * (free_pairs)))

#define C2D_POINTS_BYTES(point_sets) C2D_ARRAY_(point_sets, 56)
#define C2D_CURVES_BYTES(curves) C2D_ARRAY_(curves, 48)

#ifndef C2D_REAL_BYTES
#define C2D_REAL_BYTES 8      /* of a stored matrix's number: 4 for a library compiled with C2D_REAL=float   */
#endif
#define C2D_SOLVER_BYTES 3072 /* of c2d_solver, at most, on any target                                      */
#define C2D_ASSEMBLY_BYTES 3776 /* of what the assembly of an element needs, at most, on any target         */
#define C2D_ROUND_(bytes) (((bytes) + UINT64_C(63)) / 64 * 64)
#define C2D_ARRAY_(count, size) C2D_ROUND_(UINT64_C(1) * (count) * (size))
#define C2D_BLOCK_(numbers) C2D_ROUND_(64 + UINT64_C(1) * C2D_REAL_BYTES * (numbers)) /* with its header           */
#define C2D_LARGER_(a, b) ((a) > (b) ? (a) : (b))
#define C2D_SMALLER_(a, b) ((a) < (b) ? (a) : (b))

#define C2D_CASES_(load_cases) ((load_cases) > 0 ? (load_cases) : 1)
#define C2D_NODES_(function_nodes, points, elements, regions) /* functional nodes, those of open regions' ends too */   \
  (UINT64_C(1) * (elements) * ((function_nodes) > 1 ? (function_nodes)-1 : 1) +                                        \
   ((function_nodes) > 1 && (points) > (elements) ? C2D_SMALLER_((points) - (elements), regions) : 0))
#define C2D_ENDS_(function_nodes, elements) (UINT64_C(1) * (elements) * (function_nodes)) /* element ends      */
#define C2D_ROWS_(nodes) ((nodes) > 0 ? 2 * (nodes) + 3 : 0)                              /* equations         */

/* What one body is made of. */
#define C2D_BODY_BYTES_(function_nodes, points, elements, regions, cases)                                              \
  (C2D_ARRAY_(points, 16) +                                            /* boundary points                 */          \
   C2D_ARRAY_(points, 4) +                                             /* their lines in the deck         */          \
   C2D_ARRAY_(C2D_ENDS_(function_nodes, elements) * (cases), 16) +     /* prescribed tractions            */          \
   C2D_ARRAY_(C2D_NODES_(function_nodes, points, elements, regions) * (cases), 16) + /* prescribed displacements    */ \
   C2D_ARRAY_(C2D_ENDS_(function_nodes, elements), 1) +                /* what is known                   */          \
   C2D_ARRAY_(C2D_ENDS_(function_nodes, elements), 4) +                /* lines of the conditions         */          \
   C2D_ARRAY_(C2D_NODES_(function_nodes, points, elements, regions) + 1, 4) +   /* columns of the unknowns         */   \
   C2D_ARRAY_(regions, 16))

/* What belongs to both. */
#define C2D_LIST_BYTES_(zones, pairs, point_loads, coefficients, paths, cases)                                         \
  (C2D_ARRAY_(zones, 72) + C2D_ARRAY_(pairs, 104 + 14 * C2D_REAL_BYTES) + C2D_ARRAY_(point_loads, 48) +                                      \
   C2D_ARRAY_((coefficients) * (UINT64_C(1) + (zones)), 8) +           /* friction                        */          \
   C2D_ARRAY_(paths, 16) +                                                                                             \
   C2D_ARRAY_(pairs, 128) +                                            /* result table                    */          \
   C2D_ARRAY_(cases, 32) +                                             /* load factors                    */          \
   C2D_ARRAY_(UINT64_C(1) * (paths) * (cases), 8) +                    /* path                            */          \
   C2D_ARRAY_(cases, UINT64_C(8) * (2 * (cases) + 5 + C2D_REAL_BYTES * (pairs))) + /* energy                      */   \
   C2D_ARRAY_(2 * (cases), 40) +                                       /* body forces                     */          \
   C2D_ARRAY_(cases, 40) +                                             /* motions of a rigid body 1       */          \
   C2D_ARRAY_(8, UINT64_C(8) * (cases) + UINT64_C(1) * C2D_REAL_BYTES * (pairs))) /* what states are judged by    */

/* What assembly, reduction and the load path use one after another; m contact unknowns, of
   which `free` make an equation of body 1 each. */
#define C2D_PHASE_BYTES_(nodes1, ends1, nodes2, ends2, m, cases, free)                                                 \
  C2D_LARGER_(C2D_LARGER_(C2D_ELIMINATION_BYTES_(nodes1, C2D_ROWS_(nodes1) + (free), m),                               \
                          C2D_ELIMINATION_BYTES_(nodes2, C2D_ROWS_(nodes2), m)),                                       \
              C2D_LARGER_(C2D_REDUCTION_BYTES_(m), C2D_PATH_BYTES_(nodes1, ends1, nodes2, ends2, m, cases)))
#define C2D_ELIMINATION_BYTES_(nodes, rows, m)                                                                         \
  (C2D_ARRAY_(nodes, 32) + C2D_ARRAY_(nodes, 16) +                     /* diagonal blocks; positions      */          \
   C2D_ARRAY_(nodes, 4) + C2D_BLOCK_(m) +                              /* double nodes; contact tape      */          \
   C2D_ROUND_(C2D_ASSEMBLY_BYTES) +                                    /* one element at a time           */          \
   C2D_COLUMN_BYTES_(rows) + 64 +                                      /* a panel of one column, its norm */          \
   C2D_BLOCK_(rows) +                                                  /* a block of one column           */          \
   C2D_ARRAY_(C2D_ROWS_(nodes), 4))                                    /* row exchanges                   */
#define C2D_COLUMN_BYTES_(rows) /* columns do not start at multiples of 512 numbers */                                 \
  (C2D_ARRAY_(rows, C2D_REAL_BYTES) + (C2D_ARRAY_(rows, C2D_REAL_BYTES) % (512 * C2D_REAL_BYTES) == 0 ? 64 : 0))
#define C2D_REDUCTION_BYTES_(m)                                                                                        \
  (2 * C2D_ARRAY_((m) * (m), C2D_REAL_BYTES) +                         /* two matrices                    */          \
   C2D_ARRAY_((m) * 4, C2D_REAL_BYTES) +                               /* columns of a third              */          \
   C2D_ARRAY_(m, 4) + C2D_BLOCK_(m))                                   /* row exchanges; contact tape     */
#define C2D_PATH_BYTES_(nodes1, ends1, nodes2, ends2, m, cases)                                                        \
  (C2D_ARRAY_((m) * ((m) + 1 + (cases)), C2D_REAL_BYTES) +             /* tableau                         */          \
   3 * C2D_ARRAY_(m, C2D_REAL_BYTES) + C2D_BLOCK_(m) +                 /* forces, rates, kept; the tape   */          \
   C2D_LARGER_(C2D_RATES_BYTES_((m) + 1), C2D_RESULT_BYTES_(nodes1, ends1, nodes2, ends2, m, cases)))
#define C2D_RATES_BYTES_(n) /* the rate problem of n - 1 contact unknowns */                                           \
  C2D_ARRAY_((n) * ((n) + 4), C2D_REAL_BYTES)
#define C2D_RESULT_BYTES_(nodes1, ends1, nodes2, ends2, m, cases)                                                      \
  (3 * C2D_ARRAY_(m, C2D_REAL_BYTES) +                                 /* u1, u2 of the contact, a column */          \
   C2D_ARRAY_(2 * (nodes1), C2D_REAL_BYTES) + C2D_ARRAY_(2 * (nodes2), C2D_REAL_BYTES) + /* displacements */           \
   C2D_ARRAY_(2 * (ends1), C2D_REAL_BYTES) + C2D_ARRAY_(2 * (ends2), C2D_REAL_BYTES) + /* tractions       */           \
   C2D_ARRAY_(C2D_ROWS_(C2D_LARGER_(nodes1, nodes2)), C2D_REAL_BYTES) + /* unknowns of one body            */         \
   C2D_ARRAY_(2 * (m) + (cases), C2D_REAL_BYTES) +                     /* and what multiplies the rest    */          \
   C2D_BLOCK_(C2D_ROWS_(C2D_LARGER_(nodes1, nodes2))))                 /* a block of tape UPPER           */

#endif
