/* contact2d: the memory of a solver as a constant, for hosts with static arrays. Others ask c2d_memory_need of contact2d.h.

   C2D_MEMORY_BYTES(function_nodes, points1, points2, elements1, elements2, regions1, regions2, zones, pairs,
                    contact_elements, point_loads, coefficients, paths, load_cases)

   is a constant expression of C and C++ (and of #if), for static arrays: never less than the `minimum` of
   c2d_memory_need for limits of these numbers, and at most 5 % + 1 KiB more. The arguments stand in the order of
   c2d_limits; body 2 has zeros if there is only one body.

     static unsigned char memory[C2D_MEMORY_BYTES(2, 40, 40, 40, 40, 1, 1, 1, 12, 11, 0, 2, 1, 1)];

   C2D_LIMITS_BYTES(..., load_cases, panel_columns, free_pairs, point_sets, curves) is the same for limits in which these
   are not 0. With panel_columns it has room for blocks that are as wide as the panels.

   C2D_LOWER_BLOCKS and the like below give the sizes of the tapes for such a workspace.

   All are computed from the lists below, with one line per array of the workspace. The library lays out its memory by the
   same lists. */
#ifndef CONTACT2D_MEMORY_H
#define CONTACT2D_MEMORY_H

#include <stdint.h>

#define C2D_MEMORY_BYTES(function_nodes, points1, points2, elements1, elements2, regions1, regions2, zones, pairs,     \
                         contact_elements, point_loads, coefficients, paths, load_cases)                               \
  C2D_LIMITS_BYTES(function_nodes, points1, points2, elements1, elements2, regions1, regions2, zones, pairs,           \
                   contact_elements, point_loads, coefficients, paths, load_cases, 0, 0, 0, 0)
#define C2D_LIMITS_BYTES(function_nodes, points1, points2, elements1, elements2, regions1, regions2, zones, pairs,     \
                         contact_elements, point_loads, coefficients, paths, load_cases, panel_columns, free_pairs,    \
                         point_sets, curves)                                                                           \
  C2D_BODIES_BYTES(((points2) > 0 ? 2 : 1),                                                                            \
                   C2D_BODY_BYTES(function_nodes, points1, elements1, regions1, load_cases) +                          \
                       ((points2) > 0 ? C2D_BODY_BYTES(function_nodes, points2, elements2, regions2, load_cases) : 0), \
                   C2D_RESULT_BYTES(function_nodes, points1, elements1, regions1) +                                    \
                       C2D_RESULT_BYTES(function_nodes, points2, elements2, regions2),                                 \
                   C2D_LARGER_(C2D_NODES_(function_nodes, points1, elements1, regions1),                               \
                               C2D_NODES_(function_nodes, points2, elements2, regions2)),                              \
                   zones, pairs, contact_elements, point_loads, coefficients, paths, load_cases, panel_columns,        \
                   free_pairs, point_sets, curves)

/* For any number of bodies: how many, sums of the two following over them, the largest number of functional nodes of a
   body, and the rest of c2d_limits. A platen is a body of no points, elements and regions. */
#define C2D_BODIES_BYTES(bodies, bodies_bytes, results_bytes, nodes, zones, pairs, contact_elements, point_loads,      \
                         coefficients, paths, load_cases, panel_columns, free_pairs, point_sets, curves)               \
  (63 /* to the first multiple of 64 */ +                                                                              \
   C2D_ROUND_(C2D_SOLVER_BYTES C2D_BODY_LISTS_(C2D_ADD_, bodies) + (bodies_bytes) C2D_MODEL_ARRAYS_(                   \
       C2D_ADD_, zones, pairs, point_loads, coefficients, paths, C2D_CASES_(load_cases), point_sets, curves)) +        \
   0 * UINT64_C(1) * (contact_elements) /* kept within their zones */ +                                                \
   C2D_PHASE_BYTES_(nodes, C2D_ROWS_(nodes) + 2 * (free_pairs), results_bytes, UINT64_C(2) * (pairs),                  \
                    C2D_MOTIONS_(bodies, pairs), C2D_CASES_(load_cases), C2D_SLIP_(curves),                            \
                    C2D_WIDTH_(panel_columns)))
/* Bytes of one body, and of its results while the load path is followed. */
#define C2D_BODY_BYTES(function_nodes, points, elements, regions, load_cases)                                          \
  (0 C2D_BODY_ARRAYS_(C2D_ADD_, points, C2D_ENDS_(function_nodes, elements),                                           \
                      C2D_NODES_(function_nodes, points, elements, regions), regions, C2D_CASES_(load_cases)))
#define C2D_RESULT_BYTES(function_nodes, points, elements, regions)                                                    \
  (0 C2D_RESULT_ARRAYS_(C2D_ADD_, C2D_NODES_(function_nodes, points, elements, regions),                               \
                        C2D_ENDS_(function_nodes, elements)))

/* Bytes beyond those for limits with cycle_states (contact2d_cycle.h). */
#define C2D_CYCLE_BYTES(pairs, states) C2D_ROUND_(0 C2D_CYCLE_ARRAYS_(C2D_ADD_, pairs, states))

/* ---------------------------------------------------------------- tapes --------------------------------------------

   Blocks of each tape and bytes of each block, never less than c2d_tape_need returns, for limits with panel_columns from 1
   to 31 and a workspace of C2D_LIMITS_BYTES or more. (Panels of a width that the library chooses are known to c2d_tape_need
   alone.) Of LOWER and UPPER: blocks are added up over the bodies, the largest block counts. */
#define C2D_LOWER_BLOCKS(function_nodes, points, elements, regions, pairs, load_cases, panel_columns, keep_factors)    \
  C2D_LOWER_BLOCKS_(C2D_ROWS_(C2D_NODES_(function_nodes, points, elements, regions)),                                  \
                    C2D_TRAILING_(pairs, load_cases), C2D_WIDTH_(panel_columns), keep_factors)
#define C2D_LOWER_BLOCK_BYTES(function_nodes, points, elements, regions, free_pairs, panel_columns)                    \
  C2D_BLOCK_((C2D_ROWS_(C2D_NODES_(function_nodes, points, elements, regions)) + 2 * (free_pairs)) *                   \
             C2D_WIDTH_(panel_columns))
#define C2D_UPPER_BLOCKS(function_nodes, points, elements, regions, pairs, load_cases, panel_columns)                  \
  C2D_UPPER_BLOCKS_(C2D_ROWS_(C2D_NODES_(function_nodes, points, elements, regions)),                                  \
                    C2D_TRAILING_(pairs, load_cases), C2D_WIDTH_(panel_columns))
#define C2D_UPPER_BLOCK_BYTES(function_nodes, points, elements, regions, panel_columns)                                \
  C2D_BLOCK_(C2D_ROWS_(C2D_NODES_(function_nodes, points, elements, regions)) * C2D_WIDTH_(panel_columns))
#define C2D_CONTACT_BLOCKS(bodies, pairs, load_cases)                                                                  \
  ((pairs) > 0 ? UINT64_C(16) * (pairs) + (3 * UINT64_C(1) * (bodies) + 3) * C2D_CASES_(load_cases) +                  \
                     9 * UINT64_C(1) * (bodies) + 6 * C2D_MOTIONS_(bodies, pairs) +                                    \
                     (C2D_DELAYED_(2 * (pairs)) > 0 ? 1 : 0)                                                           \
               : 0)
#define C2D_CONTACT_BLOCK_BYTES(pairs) C2D_CONTACT_BLOCK_(UINT64_C(2) * (pairs))
/* `workspace` is the C2D_LIMITS_BYTES of these limits, which is more than a saved state. */
#define C2D_CONTROL_BLOCKS(workspace) (3 + 2 * (((workspace) + UINT64_C(511)) / 512))
#define C2D_CONTROL_BLOCK_BYTES (64 + 512)

#define C2D_TRAILING_(pairs, load_cases) (UINT64_C(4) * (pairs) + C2D_CASES_(load_cases))
#define C2D_CHUNKS_(columns, width) (((columns) + (width)-1) / (width))
#define C2D_LOWER_BLOCKS_(columns, trailing, width, keep_factors)                                                      \
  ((columns) == 0 ? 0                                                                                                  \
                  : (keep_factors) ? C2D_CHUNKS_(columns, width) + 1                                                   \
                                   : C2D_SMALLER_(C2D_CHUNKS_(columns, width),                                         \
                                                  C2D_CHUNKS_((columns) + (trailing), width) - 1))
#define C2D_UPPER_BLOCKS_(columns, trailing, width)                                                                    \
  ((columns) == 0 ? 0 : C2D_CHUNKS_((columns) + (trailing), width) + ((width) > 1 ? 1 : 0))

/* ---------------------------------------------------------------- what lies in the workspace -------------------

   ARRAY(type, name, count, each): `count` times `each` of a type, from a multiple of 8 bytes on; the lists below that are used
   one after another begin at multiples of 64, and what must stand at such a place comes first in them. Names in parentheses are
   those of the FORTRAN program of 1987 (src/FROM-1987.md). `ends` are element ends, `cases` load cases, m contact unknowns.

   Lists of the bodies: */
#define C2D_BODY_LISTS_(ARRAY, bodies)                                                                                 \
  ARRAY(BodyLimits, BodyLimits, bodies, 1)            /* of c2d_limits                                            */  \
  ARRAY(Body, Bodies, bodies, 1)                      /* (NBODY)                                                  */  \
  ARRAY(Plan, Plans, bodies, 1)                       /* how each is eliminated                                   */  \
  ARRAY(BodyResults, BodyResults, bodies, 1)          /* forces of the state                                      */
/* Of each body: */
#define C2D_BODY_ARRAYS_(ARRAY, points, ends, nodes, regions, cases)                                                   \
  ARRAY(double, Xy, points, 2)                        /* boundary points (BNODE)                                   */  \
  ARRAY(int32_t, NodeLine, points, 1)                 /* line of the caller's input                                */  \
  ARRAY(double, EndTraction, ends, 2 * (cases))       /* prescribed tractions (BCOND 1, 2)                         */  \
  ARRAY(double, NodeDisp, nodes, 2 * (cases))         /* prescribed displacements (BCOND 3, 4)                     */  \
  ARRAY(uint8_t, EndCode, ends, 1)                    /* what is known (ICODE 3 ... 6)                             */  \
  ARRAY(int32_t, EndLine, ends, 1)                    /* line of the caller's input                                */  \
  ARRAY(int32_t, NodeColumn, (nodes) + 1, 1)          /* first column of a node among the outer unknowns           */  \
  ARRAY(Region, Regions, regions, 1)                  /* closed and open curves (REGN)                             */  \
  ARRAY(BodyForce, BodyForces, cases, 1)              /* per area                                                  */  \
  ARRAY(RigidMotion, RigidMotions, cases, 1)          /* of a rigid body                                           */  \
  ARRAY(double, LoadWork, cases, 4)                   /* of its loads on its free motions; sum of magnitudes       */
/* Of the model: */
#define C2D_MODEL_ARRAYS_(ARRAY, zones, pairs, point_loads, coefficients, paths, cases, point_sets, curves)            \
  ARRAY(Zone, Zones, zones, 1)                        /* (MCF, MCEL)                                               */  \
  ARRAY(Pair, Pairs, pairs, 1)                        /* (MPAIR, UNTAVG)                                           */  \
  ARRAY(PointLoad, PointLoads, point_loads, 1)        /* (PTLOAD)                                                  */  \
  ARRAY(double, Friction, coefficients, 1 + (zones))  /* (FMU), then those of zones; negative: the former          */  \
  ARRAY(Path, Paths, paths, 1)                        /* (PATH)                                                    */  \
  ARRAY(double, PairTable, pairs, 16)                 /* results, C2D_PAIR_FIELDS columns (UNION)                  */  \
  ARRAY(double, Loads, cases, 4)                      /* load factors: reached, target, direction, at stick        */  \
  ARRAY(double, PathLoads, paths, cases)              /* factors at the end of each piece of the path              */  \
  ARRAY(void, Energy, cases, 8 * (2 * (cases) + 5) + 8 * C2D_REAL_BYTES * (pairs)) /* solver/energy/energy.hpp */      \
  ARRAY(double, MotionOfLoads, zones, 4 * (cases))    /* results/approach.cpp                                      */  \
  ARRAY(PointSet, PointSets, point_sets, 1)           /* points for interior results                               */  \
  ARRAY(void, Judge, 2, 20 * (cases) + 5 * C2D_REAL_BYTES * (pairs) + 8 * (zones)) /* solver/judge.hpp              */  \
  ARRAY(SlipGap, SlipGaps, (curves) > 0 ? (pairs) : 0, 1) /* what slip adds to gaps, model/slip_gap.hpp             */ \
  ARRAY(Curve, Curves, curves, 1)                     /* given surfaces between boundary points                    */
/* Of c2d_cycle (solver/cycle.hpp): */
#define C2D_CYCLE_ARRAYS_(ARRAY, pairs, states)                                                                        \
  ARRAY(void, Cycles, (states) > 0 ? (pairs) + 2 : 0, 128 + 48 * (states)) /* of pairs, and of all together        */

/* The following share the same memory, one after another: while a body is assembled and eliminated, ... */
#define C2D_ELIMINATION_ARRAYS_(ARRAY, nodes, m, work_bytes)                                                           \
  ARRAY(void, work, work_bytes, 1)                    /* of eliminate(): C2D_WORK_ARRAYS_, multiples of 64         */  \
  ARRAY(void, scratch, C2D_ASSEMBLY_BYTES, 1)         /* AssemblyScratch of bie/panel.hpp                          */  \
  ARRAY(void, buffer, C2D_CONTACT_BLOCK_(m), 1)       /* of the contact tape                                       */  \
  ARRAY(double, diagonal, nodes, 4)                   /* blocks of H                                               */  \
  ARRAY(double, point, nodes, 2)                      /* collocation points in the length unit                     */  \
  ARRAY(int32_t, twin, nodes, 1)                      /* see bie/columns.hpp                                       */
#define C2D_WORK_ARRAYS_(ARRAY, leading, width, block_bytes, columns)                                                  \
  ARRAY(Real, panel, width, leading)                                                                                   \
  ARRAY(void, block, block_bytes, 1)                  /* buffers for blocks, with their headers                    */  \
  ARRAY(Real, norms, width, 1)                                                                                         \
  ARRAY(int32_t, pivots, columns, 1)                  /* row exchanges                                             */
/* ... while the bodies are reduced to the contact (`motions`: those that only contact prevents), ... */
#define C2D_REDUCTION_ARRAYS_(ARRAY, m, columns, motions)                                                              \
  ARRAY(void, buffer, C2D_ROUND_(C2D_CONTACT_BLOCK_(m)), 1) /* of the contact tape                                */  \
  ARRAY(Real, first, (columns) + (motions), (columns) + (motions))                                                     \
  ARRAY(Real, second, (columns) + (motions), columns)                                                                  \
  ARRAY(Real, strip, (m) + (motions), 4)              /* columns of a third matrix                                 */  \
  ARRAY(int32_t, pivots, (m) + (motions), 1)          /* row exchanges                                             */
/* ... while the load path is followed, ... */
#define C2D_PATH_ARRAYS_(ARRAY, m, columns, widest, cases)                                                             \
  ARRAY(void, buffer, C2D_ROUND_(C2D_CONTACT_BLOCK_(widest)), 1) /* of the contact tape                           */  \
  ARRAY(Real, tableau, m, (columns) + 1 + (cases))                                                                     \
  ARRAY(Real, y, m, 1)                                                                                                 \
  ARRAY(Real, dy, m, 1)                                                                                                \
  ARRAY(Real, good, m, 1)                             /* y of the last state found good (solver/judge.hpp)         */  \
  ARRAY(Real, delayed, m, 2 * C2D_DELAYED_(m) + C2D_SMALLER_(C2D_DELAYED_(m), 3)) /* exchanges (contact/tableau.hpp) */\
  ARRAY(Real, mean_motion, m, C2D_MEAN_MOTION_(m))    /* of the bodies (results/approach.cpp)                      */
/* ... followed either by the rate problem of n - 1 unknowns or by results, which are invalid while loads change: displacements
   of the contact on each side; F of the bodies if there is room for it; displacements and true tractions of all bodies, in
   units of the model; and the work arrays of back substitution. */
#define C2D_RATES_ARRAYS_(ARRAY, n)                                                                                    \
  ARRAY(Real, rates, n, (n) + 4)
#define C2D_SURFACE_ARRAYS_(ARRAY, m)                                                                                  \
  ARRAY(Real, u, m, 1)
#define C2D_COLUMN_ARRAYS_(ARRAY, m)                                                                                   \
  ARRAY(Real, column, m, 1)                                                                                            \
  ARRAY(Real, motion, m, 1)                           /* of bodies supported by contact alone                      */  \
  ARRAY(Real, own, m, 1)                              /* contact unknowns of one body                              */
#define C2D_RESULT_ARRAYS_(ARRAY, nodes, ends)                                                                         \
  ARRAY(Real, displacement, nodes, 2)                                                                                  \
  ARRAY(Real, traction, ends, 2)
#define C2D_BACK_ARRAYS_(ARRAY, m, cases, unknowns, work_bytes)                                                        \
  ARRAY(void, work, work_bytes, 1)                    /* of back_substitute()                                      */  \
  ARRAY(Real, outer, unknowns, 1)                     /* unknowns of one body                                      */  \
  ARRAY(Real, coefficient, 2 * (m) + (cases), 1)      /* of its trailing columns                                   */

/* Bytes of the types, on every target. */
#ifndef C2D_REAL_BYTES
#define C2D_REAL_BYTES 8 /* of a stored matrix's number: 4 for a library compiled with C2D_REAL=float */
#endif
#if UINTPTR_MAX > UINT32_MAX
#define C2D_SOLVER_BYTES 2432 /* of c2d_solver, at most */
#else
#define C2D_SOLVER_BYTES 2360
#endif
#define C2D_ASSEMBLY_BYTES 3776 /* of what the assembly of an element needs, at most */
#define C2D_BYTES_OF_void 1
#define C2D_BYTES_OF_uint8_t 1
#define C2D_BYTES_OF_int32_t 4
#define C2D_BYTES_OF_double 8
#define C2D_BYTES_OF_Real C2D_REAL_BYTES
#define C2D_BYTES_OF_BodyLimits 16
#define C2D_BYTES_OF_Body 304
#define C2D_BYTES_OF_Plan 48
#define C2D_BYTES_OF_BodyResults 72
#define C2D_BYTES_OF_Region 16
#define C2D_BYTES_OF_Zone 120
#define C2D_BYTES_OF_Pair (104 + 14 * C2D_REAL_BYTES)
#define C2D_BYTES_OF_PointLoad 48
#define C2D_BYTES_OF_Path 16
#define C2D_BYTES_OF_BodyForce 40
#define C2D_BYTES_OF_RigidMotion 64
#define C2D_BYTES_OF_PointSet 56
#define C2D_BYTES_OF_Curve 48
#define C2D_BYTES_OF_SlipGap 56

#define C2D_ADD_(type, name, count, each) +(UINT64_C(1) * (count) * (each)*C2D_BYTES_OF_##type + 7) / 8 * 8
#define C2D_ADD_LINES_(type, name, count, each) +C2D_ROUND_(UINT64_C(1) * (count) * (each)*C2D_BYTES_OF_##type)
#define C2D_ROUND_(bytes) (((bytes) + UINT64_C(63)) / 64 * 64)
#define C2D_BLOCK_(numbers) (64 + UINT64_C(1) * C2D_REAL_BYTES * (numbers)) /* with its header */
#define C2D_CONTACT_BLOCK_(m) C2D_BLOCK_((m) > 3 ? (m) : 3) /* m numbers, or those of a body's motions */
#define C2D_LARGER_(a, b) ((a) > (b) ? (a) : (b))
#define C2D_SMALLER_(a, b) ((a) < (b) ? (a) : (b))

/* Columns of T, and as many rows, for the exchanges that a tableau of m rows keeps back. */
#define C2D_DELAYED_(m) ((m) < 160 ? 0 : C2D_SMALLER_((m) / 8, 64))
/* Numbers per contact unknown of the mean motions of the bodies. Of few pairs in single precision, where memory counts,
   displacements are summed instead. */
#define C2D_MEAN_MOTION_(m) (C2D_REAL_BYTES == 4 && (m) < 32 ? 0 : 8)
#define C2D_CASES_(load_cases) (UINT64_C(1) * ((load_cases) > 0 ? (load_cases) : 1))
/* A column of the tableau for the gaps that follow slip: as of one load case more. */
#define C2D_SLIP_(curves) (UINT64_C(1) * ((curves) > 0 ? 1 : 0))
#define C2D_WIDTH_(panel_columns) (UINT64_C(1) * ((panel_columns) > 0 ? (panel_columns) : 1))
#define C2D_NODES_(function_nodes, points, elements, regions) /* functional nodes, those of open regions' ends too */  \
  (UINT64_C(1) * (elements) * ((function_nodes) > 1 ? (function_nodes)-1 : 1) +                                        \
   ((function_nodes) > 1 && (points) > (elements) ? C2D_SMALLER_((points) - (elements), regions) : 0))
/* C2D_ELIMINATION_BY_SIZE uses compressed elimination if this is true for the functional nodes of any body and all pairs of the
   limits, unless there are free zones. Then it takes less time. */
#define C2D_COMPRESSED_FROM(pairs) (801 + (pairs) / 2) /* nodes */
#define C2D_COMPRESSES(nodes, pairs) ((nodes) >= C2D_COMPRESSED_FROM(pairs))
#define C2D_ENDS_(function_nodes, elements) (UINT64_C(1) * (elements) * (function_nodes))
#define C2D_ROWS_(nodes) ((nodes) > 0 ? 2 * (nodes) + 3 : 0) /* equations */
/* c2d_limits.touching: largest number of pairs that touch, or nearly, at once; 0: all. With more pairs than there are columns for
   them, columns are made when needed (src/METHOD.md 10.12), with compressed elimination only: the macros above are for 0. */
#define C2D_COLUMNS_(m, touching) ((touching) > 0 ? C2D_SMALLER_(m, C2D_LARGER_(2 * (touching), 160)) : (m))
/* Free motions of all bodies that contact can support: not the common motions of all bodies together. */
#define C2D_MOTIONS_(bodies, pairs) C2D_SMALLER_(3 * UINT64_C(1) * ((bodies)-1), 2 * UINT64_C(1) * (pairs))

#define C2D_PHASE_BYTES_(nodes, rows, results_bytes, m, motions, cases, slip, width)                                   \
  C2D_LARGER_((0 C2D_ELIMINATION_ARRAYS_(C2D_ADD_, nodes, m, C2D_WORK_BYTES_(rows, C2D_ROWS_(nodes), width))),         \
              C2D_LARGER_((0 C2D_REDUCTION_ARRAYS_(C2D_ADD_, m, m, motions)),                                          \
                          C2D_ROUND_(0 C2D_PATH_ARRAYS_(C2D_ADD_, m, m, m, (cases) + (slip))) +                        \
                              C2D_LARGER_((0 C2D_RATES_ARRAYS_(C2D_ADD_, (m) + 1)),                                    \
                                          C2D_ROUND_(2 * (0 C2D_SURFACE_ARRAYS_(C2D_ADD_, m))                          \
                                                         C2D_COLUMN_ARRAYS_(C2D_ADD_, m)) +                            \
                                              C2D_ROUND_(results_bytes) +                                              \
                                              (0 C2D_BACK_ARRAYS_(C2D_ADD_, m, cases, C2D_ROWS_(nodes),                \
                                                                  C2D_ROUND_(C2D_BLOCK_(C2D_ROWS_(nodes) *             \
                                                                                        C2D_SMALLER_(width, 64))))))))
#define C2D_WORK_BYTES_(rows, columns, width)                                                                          \
  (0 C2D_WORK_ARRAYS_(C2D_ADD_LINES_, C2D_LEADING_(rows), width, C2D_BLOCK_((rows) * C2D_SMALLER_(width, 64)), columns))
/* Columns of a panel start at multiples of 64 bytes, but not at a distance of a multiple of 512 numbers. */
#define C2D_LEADING_(rows) (C2D_LINES_(rows) + (C2D_LINES_(rows) % 512 == 0 ? 64 / C2D_REAL_BYTES : 0))
#define C2D_LINES_(rows) (C2D_ROUND_(UINT64_C(1) * (rows)*C2D_REAL_BYTES) / C2D_REAL_BYTES)

#endif
