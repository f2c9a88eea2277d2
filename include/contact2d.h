/* contact2d: plane elastic contact with Coulomb friction by the boundary integral equation method, in memory that the caller
   hands over. Plain C99, valid C++. Nothing is printed, allocated, thrown or ended. The order of calls:

   c2d_scan_deck, or numbers of your own   sizes              sections 2, 4; as constants: contact2d_memory.h
   c2d_create                              the solver         2; the port that it is given: 3
   c2d_read_deck, or                       the model          4; cards one by one: contact2d_cards.h
   c2d_set_problem ... c2d_complete          by calls         5
   c2d_prepare                             the equations      6; other loads: c2d_change_loads
   c2d_run, or                             the load path      7
   c2d_begin, c2d_advance ...                step by step     7; c2d_save, c2d_restore
   c2d_get, c2d_interior ...               results            8; words and numbers: 1
   c2d_close                                                  9: what is legal in which state, and why a call failed

   The header reads in this order; include/README.md has two whole programs, one that reads a deck and one by calls. METHOD
   (7.2) is an equation of src/METHOD.md, METHOD 7 a section; (NBP) is what the program of 1987 called a number.

   Conventions. Any consistent units; forces are per unit thickness. The material lies on the left of a boundary: outer
   boundaries run counter-clockwise, holes clockwise. Rotations are in radians, counter-clockwise. Bodies, elements, nodes,
   pairs, zones, load cases and items of lists are numbered from 1. A zone has two sides, each on a
   body. In the frame of a pair n points from side 1 to side 2, and t is n turned by -90 degrees. The tractions tn and tt of a
   pair act on side 2, per unit undeformed length of side 1 (in a free zone: of side 2); tn >= 0 is pressure.

   Arguments stand in one order: the solver; which body, element, local node, zone, item i; the load case; values in; values
   out. A list with one number per load case or zone is (pointer, count). A range of entries is first, count, and the array it
   goes to or comes from (pointer, stride): entry k at [k * stride], in doubles. A pointer may be null only where that is said.

   Failures. Every function returns a status. A call that does not return C2D_OK has changed nothing, outputs included. The
   exceptions: the list of c2d_scan_deck; c2d_create and c2d_attach set *out to null; a failed c2d_read_deck or c2d_complete
   leaves an empty model; a cancelled c2d_advance or c2d_run stays at the last load reached; STORE_...: `broken` (section 9).
   c2d_port.log hears each fault once, c2d_last_error keeps the first. Any call may return C2D_ERR_ARGUMENT, _STATE or _BUSY;
   `Errors:` names the others, STORE_... for any C2D_ERR_STORE_. That the load can go no further is no failure but an outcome.

   Threads. Solvers share nothing: there is no variable outside of a solver's memory. Calls on one solver come from one thread
   at a time, except c2d_cancel. The library is not re-entered: inside a callback only what section 3 lists is legal. */
#ifndef CONTACT2D_H
#define CONTACT2D_H

#include "contact2d_codes.h"

#include <stddef.h>
#include <stdint.h>

#define C2D_VERSION_MAJOR 0
#define C2D_VERSION_MINOR 2
#define C2D_VERSION_PATCH 0

#ifdef __cplusplus
extern "C++" {
template <class T> inline T c2d_initial() {
  T value = T();
  value.struct_size = static_cast<uint32_t>(sizeof(T));
  return value;
}
}
#define C2D_INIT(type) c2d_initial<type>()
extern "C" {
#else
#define C2D_INIT(type) { .struct_size = (uint32_t)sizeof(type) }
#endif

/* ---------------------------------------------------------------- 1 numbers and words --------------------------

   Public structs begin with struct_size. c2d_limits sizes = C2D_INIT(c2d_limits); sets it, and all else to zero, which means
   the default. Members are only ever appended; the library touches the smaller of struct_size and its own size, and refuses a
   size that C2D_INIT cannot have set. What a call returns (c2d_status), how a path ended (c2d_outcome), the numbers of
   warnings (C2D_WARN_...) and of the fields of c2d_get stand in contact2d_codes.h. */

typedef struct c2d_solver c2d_solver; /* lives inside the caller's memory */
enum { C2D_OPEN = 0, C2D_STICK = 1, C2D_SLIP = 2, C2D_TIED = 3 }; /* status of a pair   */
enum { C2D_PLANE_STRAIN = 0, C2D_PLANE_STRESS = 1 };
enum { C2D_NOTE = 0, C2D_WARNING = 1, C2D_FAULT = 2 }; /* c2d_error.severity */
/* Everything known about a fault, a warning or a note. Numbers that do not apply are 0. */
typedef struct c2d_error {
  uint32_t struct_size;
  int32_t status, severity;     /* a c2d_status; for warnings and notes a C2D_WARN_ number; C2D_NOTE ...   */
  int32_t host_code;            /* what the caller's function returned                              */
  int32_t line;                 /* of the deck, or what c2d_set_line said last                      */
  int32_t column, column_end;   /* first and last column of the field                               */
  int32_t body, zone, pair, element, node, tape;
  int64_t block;
  uint64_t bytes_needed;        /* with C2D_ERR_MEMORY: workspace bytes that would do               */
  double load;                  /* load factor at which it happened                                 */
  char text[320];               /* one line, ASCII but for names: what was found and expected        */
} c2d_error;

/* ---------------------------------------------------------------- 2 sizes and memory ---------------------------

   Ask for sizes, make memory of at least `minimum` bytes (static, heap, COMMON; any alignment), create the solver in it. */
typedef struct c2d_body_limits {
  int32_t points;             /* boundary points (NBP), ends of open regions included               */
  int32_t elements, regions, reserved; /* elements (NEL); closed and open curves (NREN)             */
} c2d_body_limits;
typedef struct c2d_limits {
  uint32_t struct_size;
  int32_t bodies;             /* how many (NBODY)                                                   */
  c2d_body_limits* body;      /* [bodies], an array of the caller's; no call keeps it               */
  int32_t function_nodes;     /* functional nodes per element: 1 constant ... 4 cubic (NFNODE)      */
  int32_t zones, pairs;       /* contact zones (MCP); pairs in all of them, of C2D_ZONE_SELF twice  */
  int32_t contact_elements;   /* pairs of elements in all zones; elements of side 2 in free zones   */
  int32_t point_loads;        /* of all bodies together                                             */
  int32_t coefficients;       /* of friction, to be run one after another (NMU)                     */
  int32_t paths;              /* load cards (NPATH)                                                 */
  int32_t load_cases;         /* 0 means 1                                                          */
  int32_t panel_columns;      /* columns eliminated at a time; 0: as many as the memory allows      */
  int32_t free_pairs;         /* those of the pairs that belong to zones of kind C2D_ZONE_FREE      */
  int32_t point_sets, curves; /* of c2d_add_points (cards under *POINTS), c2d_add_curve (*CURVE)    */
  int32_t platens, touching;  /* of c2d_add_platen (*PLATEN): bodies beyond `bodies`, and a zone each; see C2D_COLUMNS_ */
} c2d_limits;
/* Bytes of workspace: `minimum` solves any model within the limits in the smallest blocks (slender bodies upon each other:
   c2d_prepare reports), `in_core` holds a body's whole matrix; threads use more. Outputs, why may be null. Errors: OVERFLOW. */
c2d_status c2d_memory_need(const c2d_limits* limits, uint64_t* minimum, uint64_t* in_core, c2d_error* why);

/* ---------------------------------------------------------------- 3 the port -----------------------------------

   What the library asks of its surroundings. Zero a struct with C2D_INIT, set what you have. Ready ports for memory, stdio and
   POSIX files are in port/, and port/README.md says what breaks if a duty is cheated. All functions return 0 for success;
   anything else is an error code of yours that comes back in c2d_error.host_code. They must return: no exception, longjmp or
   exit may leave them. Inside them c2d_cancel, c2d_memory_need, c2d_get_state are legal for the solver that calls, all else is
   C2D_ERR_BUSY; in a step callback (section 7) c2d_get_zone_state, _body_state, but for a CHANGE c2d_get, _interior, _save. */
typedef struct c2d_progress {
  uint32_t struct_size;
  int32_t phase, body;        /* C2D_PHASE_...; the body while assembling and eliminating           */
  int64_t done, total;        /* of the phase: columns, pairs, or 0                                 */
  double load, target;        /* while following the load                                           */
} c2d_progress;
enum { C2D_PHASE_READ = 0, C2D_PHASE_ASSEMBLE = 1, C2D_PHASE_ELIMINATE = 2, C2D_PHASE_REDUCE = 3, C2D_PHASE_CONTACT = 4,
       C2D_PHASE_BACK = 5, C2D_PHASE_WRITE = 6, C2D_PHASES = 7 };
enum { C2D_TAPE_CONTROL = 0, C2D_TAPE_LOWER = 1, C2D_TAPE_UPPER = 2, C2D_TAPE_CONTACT = 3, C2D_TAPES = 4 };

typedef struct c2d_port {
  uint32_t struct_size;
  void* context;              /* handed to every function below                                     */
  /* Block store, all five or none (c2d_prepare, c2d_save and c2d_restore need it). Tapes are numbered 0 ... C2D_TAPES-1, blocks
     from 0; a block is written as a whole, with at most block_bytes bytes, and read back with the same number of bytes.
     open  makes room for `blocks` blocks; what an earlier run left may stay (it is recognised and refused).
     read  must fill exactly `bytes` bytes or fail: a short read passed off as success is found by the checksum.
     write may be kept in a cache until sync; sync must not return before the data would survive a crash.
     If close fails the data may be lost: say so.                                                   */
  int32_t (*open)(void* context, int32_t tape, uint64_t blocks, uint64_t block_bytes);
  int32_t (*read)(void* context, int32_t tape, uint64_t block, void* data, uint64_t bytes);
  int32_t (*write)(void* context, int32_t tape, uint64_t block, const void* data, uint64_t bytes);
  int32_t (*sync)(void* context, int32_t tape);
  int32_t (*close)(void* context, int32_t tape);
  /* Optional, all three or none: overlap of transfers with arithmetic. The buffer is the port's until wait(ticket) returns; at
     most 4 transfers are outstanding, and each is waited for before the library's call returns; reads see writes begun
     earlier; read and write may be called in between. All calls come from the thread that called the library. A start that
     fails has no ticket.                                                                           */
  int32_t (*start_read)(void* context, int32_t tape, uint64_t block, void* data, uint64_t bytes, int32_t* ticket);
  int32_t (*start_write)(void* context, int32_t tape, uint64_t block, const void* data, uint64_t bytes, int32_t* ticket);
  int32_t (*wait)(void* context, int32_t ticket);
  /* Optional: run task(argument, 0) ... task(argument, n-1), in any order, on any threads; all have run when it returns. Tasks
     never call the port.                                                                           */
  void (*parallel_for)(void* context, int32_t n, void (*task)(void* argument, int32_t i), void* argument);
  void (*progress)(void* context, const c2d_progress* now); /* at least once per column and event   */
  int32_t (*cancel)(void* context);                         /* non-zero: stop with C2D_ERR_CANCELLED */
  void (*log)(void* context, const c2d_error* entry);       /* every fault, warning and note        */
  double (*clock)(void* context);                           /* seconds from any origin, monotonic   */
  int32_t threads;            /* tasks that parallel_for runs at once; 0 and 1: it is not called    */
} c2d_port;

/* Make a solver in memory[0 .. bytes), in state empty; *out points into it. `port` is copied, its context must live on; null:
   no store, the model can only be checked. `why` may be null. Errors: OVERFLOW, MEMORY with why->bytes_needed. */
c2d_status c2d_create(c2d_solver** out, void* memory, size_t bytes, const c2d_limits* limits, const c2d_port* port,
                      c2d_error* why);
/* Take up a solver whose memory was moved, reloaded or handed to another process of the same build: memory[0 .. bytes) is a
   copy of the whole that c2d_create was given, taken between calls, on any alignment, perhaps longer. It goes on where it was,
   with the same bits; every c2d_solver* from before is void. `port` opens the tapes that were open once more; they must hold
   what they held. On failure the image can still be attached. Its numbers are trusted: contact2d_image.h attaches by checksum.
   Errors: ARGUMENT: no solver stands there; MISMATCH: one of another version, size of pointers or scalar, or prepared by a
   program linked without energies; MEMORY with why->bytes_needed; BUSY: copied inside a callback; STORE_OPEN. */
c2d_status c2d_attach(c2d_solver** out, void* memory, size_t bytes, const c2d_port* port, c2d_error* why);
/* Close the store (Errors: STORE_CLOSE). The memory is the caller's again, whatever is returned. */
c2d_status c2d_close(c2d_solver* solver);

/* ---------------------------------------------------------------- 4 a model from a deck ------------------------

   A deck is the 1987 program's card deck (src/deck/DECK.md). read_line puts the next card, without its line end, into text[0
   .. size), ended by a zero byte, and returns its length (a longer line: what fits, and its full length); -1 at the end of the
   deck; any other negative number is an error of the caller's (C2D_ERR_READ, host_code). */
typedef int32_t (*c2d_read_line)(void* context, char* text, int32_t size);
typedef void (*c2d_report)(void* context, const c2d_error* entry);
/* Sizes of a deck, without a workspace: out->body, with room for out->bodies bodies, and *out are filled. c2d_read_deck may
   still refuse a deck that passes. c2d_scan_deck puts the first fault into *why, c2d_check_deck tells every fault to `report`;
   either may be null. Errors: INPUT, READ: the list holds anything; LIMIT: out->bodies alone tells how many there are. */
c2d_status c2d_scan_deck(c2d_read_line read, void* context, c2d_limits* out, c2d_error* why);
c2d_status c2d_check_deck(c2d_read_line read, void* context, c2d_limits* out, c2d_report report, void* report_context);
/* Read a whole deck and complete the model; all faults go to c2d_port.log. Errors: INPUT, READ, LIMIT. */
c2d_status c2d_read_deck(c2d_solver* solver, c2d_read_line read, void* context);

/* ---------------------------------------------------------------- 5 a model by calls ---------------------------

   The order: problem, bodies, regions, nodes, conditions, loads, zones, friction, paths, c2d_complete. All may return LIMIT. */
enum { C2D_ANALYSIS_CHECK = -1, C2D_ANALYSIS_STRESS = 0, C2D_ANALYSIS_CONTACT = 1, C2D_ANALYSIS_FULL = 2,
       C2D_ANALYSIS_ITERATIONS = 3 };
typedef struct c2d_problem {
  uint32_t struct_size;
  int32_t plane;              /* C2D_PLANE_STRAIN or C2D_PLANE_STRESS (IPTYPE)                      */
  int32_t analysis;           /* C2D_ANALYSIS_... (IOUT; anything above 3 counts as 3)              */
  int32_t iteration_limit;    /* per increment of the deck's own stepping (ITMAX); 0 means 50       */
  char title[80];             /* ended by a zero byte                                               */
} c2d_problem;
c2d_status c2d_set_problem(c2d_solver* solver, const c2d_problem* problem); /* of what kind the problem is */

typedef struct c2d_body {
  uint32_t struct_size;
  int32_t element_nodes;      /* geometry nodes per element: 2 linear, 3 quadratic, 4 cubic (NBN)   */
  int32_t elements, regions;  /* NEL, NREN                                                          */
  double youngs_modulus;      /* E > 0, force per area                                              */
  double poisson_ratio;       /* -1 < nu <= 0.5 (plane stress: -0.5 < nu <= 0.5)                    */
  int32_t open_regions, reserved; /* the first ones are open: see c2d_set_symmetry                  */
} c2d_body;
/* May be given again with other moduli, not with other numbers of elements or regions. */
c2d_status c2d_set_body(c2d_solver* solver, int32_t body, const c2d_body* data);
/* Elements first ... last form a closed curve, or an open one; regions follow one another without a gap. */
c2d_status c2d_add_region(c2d_solver* solver, int32_t body, int32_t first_element, int32_t last_element);
/* Boundary points first ... first+count-1: x and y of the k-th at xy[k * stride], xy[k * stride + 1], in global coordinates.
   Element e of a region has its first geometry node at (e-1)*(element_nodes-1)+1, plus the open regions before it. */
c2d_status c2d_set_nodes(c2d_solver* solver, int32_t body, int32_t first, int32_t count, const double* xy, int64_t stride);
/* Boundary points first ... last, both ends included, at equal distances along a straight line, or along an arc between two
   angles (degrees, counter-clockwise from the x axis; downwards if the second is smaller), as between two node cards of a
   deck: the same bits. `from` and `to` count from `origin` (null: (0, 0)). last > first, radius >= 0. */
c2d_status c2d_set_line_nodes(c2d_solver* solver, int32_t body, int32_t first, int32_t last, const double origin[2],
                              const double from[2], const double to[2]);
c2d_status c2d_set_arc_nodes(c2d_solver* solver, int32_t body, int32_t first, int32_t last, const double centre[2],
                             double radius, double from_degrees, double to_degrees);
/* Condition at local functional node `local` of an element: codes[4] and values[4] in the order tx ty ux uy, global
   components; code 0: known, with this value; 1: unknown. Ends without a condition are free of traction; ends of contact
   elements at listed pairs belong to the contact: a traction there is refused. All values scale with the load case's factor. */
c2d_status c2d_set_condition(c2d_solver* solver, int32_t body, int32_t element, int32_t local, int32_t load_case,
                             const int32_t codes[4], const double values[4]);
/* What an end carries in a load case: values[4] as above; the codes stay. local 0: all ends of the element. Refused: a value
   other than zero of something unknown or of the contact, and, as a displacement belongs to its node, one that contradicts the
   other end's (while building 0 leaves that as it is). In state model every known quantity takes its value, zero too;
   displacements of contact nodes and those that symmetry holds are then refused as well. */
c2d_status c2d_set_values(c2d_solver* solver, int32_t body, int32_t element, int32_t local, int32_t load_case,
                          const double values[4]);
/* Force (fx, fy) at the point (x, y) inside the body. On a line of symmetry: along it, what falls to the modelled part. */
c2d_status c2d_add_point_load(c2d_solver* solver, int32_t body, int32_t load_case, double x, double y, double fx, double fy);
/* A force per area of the body: `force`, a weight, and rho_omega2 (x - axis[0], y - axis[1]), density times angular velocity
   squared, outward from the axis of a rotation; axis may be null where rho_omega2 is 0. One per body and load case; given
   again it replaces the one before. No weight across a line of symmetry that the body meets, nor an axis off it. METHOD 6. */
c2d_status c2d_set_body_force(c2d_solver* solver, int32_t body, int32_t load_case, const double force[2], double rho_omega2,
                              const double axis[2]);
/* The body is rigid, without equations and moduli; its mesh gives frames and lengths. In a load case it moves by motion[0],
   motion[1] and turns by the small angle motion[2] about axis[0], axis[1]; load_case 0: it is only made rigid, and both
   arrays may be null. Conditions are passed over; c2d_complete refuses tractions and forces on it, and a zone of two rigid
   bodies. Results: its motion, the contact's tractions, no stresses; what holds or loads it is its `applied`. */
c2d_status c2d_set_rigid(c2d_solver* solver, int32_t body, int32_t load_case, const double motion[3], const double axis[2]);
/* Of a rigid body motions i = 0 to 2 (ux, uy, rotation of `point`) with is_free[i] != 0 are not given: they follow from the
   contact and, in a load case, from load[0 .. 3): fx, fy and the moment about `point`, of which those of free motions count.
   With load_case 0 is_free and point are set (and the body is rigid), else the load; the others are not looked at. */
c2d_status c2d_set_rigid_load(c2d_solver* solver, int32_t body, int32_t load_case, const int32_t is_free[3],
                              const double load[3], const double point[2]);
/* A platen: elements first ... last (round a closed region's end if `elements` says how many; 0: by their numbers) move as one
   rigid body without a mesh: body c2d_limits.bodies + 1, + 2, ..., "platen 1", ...; its tie is the next zone, itself side 1.
   is_free and point as above; those two calls move and load it. Its ends have no conditions and no contact. METHOD 10.8. */
c2d_status c2d_add_platen(c2d_solver* solver, int32_t body, int32_t first_element, int32_t last_element, int32_t elements,
                          const int32_t is_free[3], const double point[2]);
/* Initial overlaps of a press fit: pairs that overlap before any load are legal, and touch at first; the factor of this load
   case closes their overlaps, which are gone at factor 1. c2d_run brings it from 0 to 1 before the first step of the path, and
   keeps it there; with c2d_advance it is the caller's. Given again it replaces the one before. */
c2d_status c2d_set_interference(c2d_solver* solver, int32_t load_case);
/* Contact between two ranges of elements, side 1 and side 2, of two bodies, which may share several zones, or of one that meets
   itself (C2D_ZONE_SELF: the sides are apart). A range may run down, and round the end of its region if `elements` says how
   many there are (0: by their numbers).
   C2D_ZONE_MATCHING: elements face each other, first with first, last with last, and the functional nodes first_node ...
   last_node, `pairs` of them, form pairs in the same order.
   C2D_ZONE_FREE: the sides are meshed independently; either may run up or down, and pairs and nodes are not looked at. Every
   functional node of side 2 makes a pair with the point of side 1 whose normal passes through it (C2D_X, C2D_Y; C2D_PAIR_NODE1
   is 0); elements of side 2 that do not face side 1 from end to end are left out. Nodes of side 1 keep their conditions
   (both unknown: left to the contact); tractions given there add to those of the contact. Force passes over exactly, its moment
   so far as matching points coincide (METHOD 9). c2d_limits: `pairs`, `free_pairs` count all functional nodes of elements of
   side 2. c2d_complete refuses sides that do not face each other. */
enum { C2D_ZONE_MATCHING = 0, C2D_ZONE_FREE = 1, C2D_ZONE_TIED = 2, C2D_ZONE_SELF = 4 };
typedef struct c2d_side {
  int32_t body, first_element, last_element, elements;
  int32_t first_node, last_node; /* functional nodes of the body                                    */
} c2d_side;
typedef struct c2d_zone {
  uint32_t struct_size;
  int32_t kind, pairs;        /* C2D_ZONE_MATCHING or _FREE, and _TIED, _SELF added; how many pairs */
  c2d_side side1, side2;
} c2d_zone;
c2d_status c2d_add_zone(c2d_solver* solver, const c2d_zone* zone);
/* Zone i (from 1) is bonded: it carries tension and friction without bound, and never changes its status. Its surfaces must
   coincide within a tenth of an element; what they are off is no gap. Pairs of such zones are numbered behind all others. */
c2d_status c2d_tie_zone(c2d_solver* solver, int32_t zone);
/* What the surface is over elements of a body: gaps, normals and the points that face each other are those of surfaces, not of
   elements (METHOD 8). Where nothing is told it is a smooth curve that respects corners and kinks as far as the boundary
   points show them. A line is straight between its points; an arc is one of the circle; a spline is smooth whatever the
   angles. c2d_complete refuses elements in two curves, and points off a line or an arc by a thousandth of their element. */
enum { C2D_CURVE_LINE = 0, C2D_CURVE_ARC = 1, C2D_CURVE_SPLINE = 2 };
typedef struct c2d_curve {
  uint32_t struct_size;
  int32_t kind, body;         /* C2D_CURVE_...; the body it belongs to                              */
  int32_t first_element, last_element; /* of one region, going up                                   */
  int32_t line;               /* of the deck or of c2d_set_line; an answer of c2d_get_curve, else unused */
  double centre[2], radius;   /* of an arc                                                          */
} c2d_curve;
c2d_status c2d_add_curve(c2d_solver* solver, const c2d_curve* curve);
/* A coefficient for c2d_run, zero or more, infinity is full adhesion; c2d_set_zone_friction: of one zone, in the i-th run. */
c2d_status c2d_add_friction(c2d_solver* solver, double mu);
c2d_status c2d_set_zone_friction(c2d_solver* solver, int32_t zone, int32_t i, double mu);
/* Symmetry by images (METHOD 5): everything is mirrored across the line x = value (axis 0) or y = value (axis 1), one of each
   at most. Only what lies on one side (in one quarter) is given, without elements on the lines: a curve that crosses a line is
   an open region that ends on the lines; of a body that meets no line the image is another body. Open regions come first in a
   body (c2d_body.open_regions), and have one boundary point and, except with constant elements, one functional node more. The
   displacement across a line is 0; conditions there say the rest. Forces and moments are those of the modelled part. */
c2d_status c2d_set_symmetry(c2d_solver* solver, int32_t axis, double value);
/* A straight piece of the load path, in `increments` equal steps from where the last piece ended (zero at first) to load[0 ..
   cases), a factor for every load case. c2d_clear_paths forgets the pieces given so far. */
c2d_status c2d_add_path(c2d_solver* solver, int32_t increments, const double* load, int32_t cases);
c2d_status c2d_clear_paths(c2d_solver* solver);
/* Where interior results are wanted: a list that the model only keeps, for whoever asks c2d_interior for them after the
   solution (c2d_get_points, c2d_expand_points in section 8). The points need not lie inside. */
enum { C2D_POINTS_ONE = 0, C2D_POINTS_LINE = 1, C2D_POINTS_GRID = 2 };
typedef struct c2d_points {
  uint32_t struct_size;
  int32_t kind, body;         /* C2D_POINTS_...; the body they lie in                               */
  int32_t count[2];           /* line: count[0] points from one end to the other; grid: count[0] in x and count[1] in y, row by
                                 row, x first; else unused. At least 1 each, together fewer than 2^31 */
  int32_t line;               /* of the deck or of c2d_set_line; an answer of c2d_get_points, else unused */
  double from[2], to[2];      /* the point; the line's ends; opposite corners of the grid           */
} c2d_points;
c2d_status c2d_add_points(c2d_solver* solver, const c2d_points* points);
/* Names of the units of length and force for titles of axes, each at most 15 characters; null: empty. Nothing is converted. */
c2d_status c2d_set_units(c2d_solver* solver, const char* length, const char* force);
/* What body or zone i is called, beside its number in messages and outputs: at most 31 bytes of UTF-8, no control characters;
   null or "": nothing. The name comes back filled up with zero bytes. */
enum { C2D_NAME_BODY = 0, C2D_NAME_ZONE = 1 };
c2d_status c2d_set_name(c2d_solver* solver, int32_t kind, int32_t i, const char* name);
c2d_status c2d_get_name(c2d_solver* solver, int32_t kind, int32_t i, char out[32]);
/* Faults found from now on are said to come from this line of the caller's input; 0: none. */
c2d_status c2d_set_line(c2d_solver* solver, int32_t line, int32_t column, int32_t column_end);
/* Validate everything; every fault goes to c2d_port.log. Errors: INPUT. */
c2d_status c2d_complete(c2d_solver* solver);

enum { C2D_QUADRATURE_ACCURATE = 0, C2D_QUADRATURE_THESIS = 1 };
enum { C2D_STEPPING_EVENTS = 0, C2D_STEPPING_DECK = 1 };
/* Elements on a line of symmetry: kept, or replaced by images. The line bounds every body; each of its elements has zero
   displacement across and zero traction along the line. Results there are 0. Lines are found if none is given. */
enum { C2D_SYMMETRY_DECK = 0, C2D_SYMMETRY_IMAGES = 1 };
/* Compressed (METHOD 7.6): cost like the number of nodes; to 1e-9 as dense, else C2D_WARN_COMPRESSED. 128 MiB at most beyond
   twice the least workspace. Bodies on side 1 of free zones, or of over 2 regions + 2 holes: dense. By size: C2D_COMPRESSES. */
enum { C2D_ELIMINATION_DENSE = 0, C2D_ELIMINATION_COMPRESSED = 1, C2D_ELIMINATION_BY_SIZE = 2 };
typedef struct c2d_options {
  uint32_t struct_size;
  int32_t quadrature, stepping; /* C2D_QUADRATURE_..., C2D_STEPPING_...                             */
  int32_t every_change;       /* 1: c2d_run's callback also sees changes of status, but none beyond the limits of accuracy */
  int32_t symmetry;           /* C2D_SYMMETRY_...; before c2d_complete or c2d_read_deck             */
  int32_t keep_factors;       /* 1: all of L is kept, so that new loads cost little: tape LOWER as large as UPPER */
  int32_t elimination;        /* C2D_ELIMINATION_...; then that is passed over                      */
} c2d_options;
/* Any time before c2d_prepare; another `symmetry` for a complete model: STATE. */
c2d_status c2d_set_options(c2d_solver* solver, const c2d_options* options);
/* Blocks that the store is asked for when a tape (0 ... C2D_TAPES-1) is opened, and bytes of each, if c2d_create is given
   these limits and workspace_bytes: at most, for any model within the limits; saved states are provided for. `options`,
   outputs and `why` may be null. Errors: OVERFLOW, MEMORY with why->bytes_needed. */
c2d_status c2d_tape_need(const c2d_limits* limits, const c2d_options* options, uint64_t workspace_bytes, int32_t tape,
                         uint64_t* blocks, uint64_t* block_bytes, c2d_error* why);

/* ---------------------------------------------------------------- 6 prepare ------------------------------------

   Assemble (METHOD 2), eliminate what lies outside the contact (METHOD 7), reduce to the contact unknowns (METHOD 10): once
   per model. State afterwards: prepared; after a failure or a cancel: model. Errors: STORE_..., SINGULAR, CANCELLED, MEMORY;
   INPUT: changed loads; LIMIT: `touching`. That contact cannot hold a body is no error: c2d_advance tells it. */
c2d_status c2d_prepare(c2d_solver* solver);
/* Other loads for the same bodies. c2d_change_loads ends the path and goes back to state model, where c2d_set_values,
   c2d_set_body_force, c2d_set_rigid and c2d_set_rigid_load (load_case > 0) and c2d_replace_point_load (place and force of point
   load i, in the order given; body and load case stay) give load cases other values. c2d_prepare validates them and, if the
   options said keep_factors, sends only the new right-hand sides through the factors that are there: a small part of the work,
   and to round-off the results of a solver prepared from the beginning. Without keep_factors, and after other options, a
   failure or a cancel, c2d_prepare does everything. Codes, geometry and contact do not change. A load case needed only later is
   counted in c2d_limits.load_cases from the beginning; its values do not matter until then. States saved before are stale. */
c2d_status c2d_change_loads(c2d_solver* solver);
c2d_status c2d_replace_point_load(c2d_solver* solver, int32_t i, double x, double y, double fx, double fy);

/* ---------------------------------------------------------------- 7 follow the load ----------------------------

   Begin: zero load, no history, coefficients of friction mu[0 .. zones) (one serves all if zones = 1), each >= 0, infinity:
   full adhesion. The first > 0 after a preparation with none repeats its end. State: running. Errors: STORE_..., MEMORY. */
c2d_status c2d_begin(c2d_solver* solver, const double* mu, int32_t zones);
/* Go in a straight line from the load factors reached to load[0 .. cases). If *outcome is not C2D_REACHED the solver stays,
   valid, at the last load it could reach; after a cancel or MEMORY (`touching`), too. Errors: STORE_..., CANCELLED, MEMORY. */
c2d_status c2d_advance(c2d_solver* solver, const double* load, int32_t cases, c2d_outcome* outcome);
/* How far the load factors can go along direction[0 .. cases) until a pair changes its status: *step times the direction;
   infinity if no pair ever does; 0 if the path cannot go on that way at all. The load stays where it is; a pair on the border
   of its status (zero pressure or about to slip) may get the status that goes with the direction. Errors: STORE_..., MEMORY. */
c2d_status c2d_next_event(c2d_solver* solver, const double* direction, int32_t cases, double* step);

/* Keep the state of the path on tape 0, or, in state prepared, that there is a factorisation. A crash at any moment leaves
   this state or the one saved before; the tapes are made safe (sync) first. c2d_summary does not count what that transfers. In
   c2d_run's callback, unless it shows a CHANGE, it keeps how far the run is: after c2d_restore c2d_run goes on there, if no
   other call has moved the load. Errors: STORE_... (c2d_restore brings back what was saved before). */
c2d_status c2d_save(c2d_solver* solver);
/* Go back to the newest state that is whole: nothing is eliminated again, and what follows gives the same bits. In another
   process: c2d_create with the same limits, the same model and options (state model), the same store, then c2d_restore for
   c2d_prepare; state prepared serves any path. Errors, after which the solver is as before: MISMATCH: saved for another model,
   path, limits or stepping, or by another library or kind of machine (c2d_last_error tells); STORE_STALE: c2d_prepare has begun
   anew since; STORE_FORMAT or _READ: nothing was saved there; STORE_...: nothing whole is there; MEMORY with bytes_needed:
   saved in a larger workspace. Broken only if the store fails while the state is taken over, or a number cannot be meant. */
c2d_status c2d_restore(c2d_solver* solver);
/* What a step callback sees. `table` has a row per pair and the columns C2D_X ... C2D_PAIR_ZONE of section 8: column c of pair
   p at table[(p-1) * stride + c]. All pointers are valid during the call only. */
enum { C2D_STEP_RECORDED = 0, C2D_STEP_CHANGE = 1, C2D_STEP_STOPPED = 2 };
typedef struct c2d_step {
  uint32_t struct_size;
  int32_t kind;               /* RECORDED: end of an increment; CHANGE: a status changed; STOPPED: the path ended early */
  int32_t coefficient;        /* which of the deck's coefficients                                   */
  int32_t step;               /* increments of all load cards, counted through from 1               */
  int32_t pairs, changes;     /* changes of status since the last recorded step                     */
  int32_t iterations;         /* of the deck's stepping in this increment, else 0                   */
  c2d_outcome outcome;
  int64_t stride;             /* doubles from one row to the next                                   */
  double mu, load;            /* coefficient (of zone 1); factor of load case 1                     */
  const double* table;
  int32_t cases, reserved;
  const double* loads;        /* [cases] factors reached                                            */
  const double* work_by_case; /* [cases] work done by each load case since zero load: its tractions, point loads and prescribed
                                 displacements, integrated along the path                           */
  double work;                /* their sum                                                          */
  double dissipated;          /* by friction: sum over pairs of W tt dslip, W the length that belongs to the pair: the integral
                                 of its shape functions along the side that tractions are counted on */
  double elastic;             /* energy stored in all bodies                                        */
  double energy_defect;       /* (work - elastic - dissipated) over the largest of the three on the path so far: the error of
                                 the mesh, largest at corners, as those of a meshed line of symmetry */
} c2d_step;
typedef int32_t (*c2d_step_fn)(void* context, const c2d_step* step); /* non-zero: stop, C2D_ERR_CALLBACK */
/* The model's own load cards for each of its coefficients of friction. A path that stops is no error of this call: the
   callback (may be null) and c2d_get_summary tell; the next coefficient is then run. State afterwards: running, at the last
   load reached, also after CALLBACK, CANCELLED. Errors: ARGUMENT: no path; CALLBACK, CANCELLED, MEMORY, STORE_.... */
c2d_status c2d_run(c2d_solver* solver, c2d_step_fn step, void* context);
/* From any callback, another thread or a signal handler: the solver stops at the next chance, and the call at work returns
   C2D_ERR_CANCELLED. Without one, or if it ends before that, the next call that lists CANCELLED does: no cancel is lost. */
c2d_status c2d_cancel(c2d_solver* solver);

/* ---------------------------------------------------------------- 8 results ------------------------------------

   At the load reached, in state running. All but what only tells the model may return STORE_... (the first call at a load that
   needs back substitution does it). Entries first ... first+count-1 of a field (contact2d_codes.h) to out[0], out[stride], ...;
   positions also in states model and prepared. */
c2d_status c2d_get(c2d_solver* solver, int32_t field, int32_t body, int32_t first, int32_t count, double* out, int64_t stride);

/* Columns of an interior point. szz = nu (sxx + syy) in plane strain, 0 in plane stress, and enters von Mises' stress;
   principal stresses are those of the plane, the larger first; max_shear is half their difference. So in C2D_END_.... */
enum {
  C2D_POINT_UX = 0, C2D_POINT_UY = 1, C2D_POINT_SXX = 2, C2D_POINT_SYY = 3, C2D_POINT_SXY = 4, C2D_POINT_SZZ = 5,
  C2D_POINT_VON_MISES = 6, C2D_POINT_MAX_SHEAR = 7, C2D_POINT_PRINCIPAL1 = 8, C2D_POINT_PRINCIPAL2 = 9,
  C2D_POINT_FLAG = 10, C2D_POINT_FIELDS = 11 /* the flag is one of the words below                  */
};
enum {
  C2D_POINT_INSIDE = 0,       /* METHOD 16.3, error below 1e-8 down to 1e-6 of an element length from the boundary */
  C2D_POINT_NEAR_NODE = 1,    /* within a tenth (constant functions: half) of the shorter element from an element's end, where
                                 tractions jump by the error of the mesh: the stress of smoothed tractions (METHOD 16.3), exact
                                 where the state is uniform; displacement as inside                 */
  C2D_POINT_BOUNDARY = 2,     /* within 1e-9 of an element length: displacement and tensor of the boundary point */
  C2D_POINT_OUTSIDE = 3       /* of the body asked for, or of all: every other column is 0          */
};
/* Displacements and stresses at `count` points (xy[i * xy_stride], xy[i * xy_stride + 1]); column c of point i goes to out[i *
   out_stride + c]. xy_stride >= 2, out_stride >= C2D_POINT_FIELDS; xy and out must not overlap. body 0: whichever the point
   lies in, the first if in several. A point load's own field is left out at its very point. Before anything touches, and where
   no motion is held, displacements and stresses are 0. With lines of symmetry points may lie anywhere in the whole model. Many
   points in one call cost less than one by one. Errors: STORE_..., CANCELLED: `out` is then of no use. */
c2d_status c2d_interior(c2d_solver* solver, int32_t body, int32_t count, const double* xy, int64_t xy_stride, double* out,
                        int64_t out_stride);
/* What the mesh leaves open between nodes: C2D_OFF_... (contact2d_codes.h) of elements. Errors: as c2d_interior. */
c2d_status c2d_indicators(c2d_solver* solver, int32_t body, int32_t first, int32_t count, double* out, int64_t stride);

typedef struct c2d_summary {
  uint32_t struct_size;
  int32_t state;
  c2d_outcome outcome;            /* of the last path followed                                      */
  int32_t outcome_body, outcome_pair; /* which body can move, which pair was last                   */
  int32_t bodies, function_nodes, pairs, zones, steps, coefficients; /* steps: increments of all load cards */
  int32_t contact_unknowns, analysis, plane, stepping, quadrature, iteration_limit, paths, panel_columns, warnings;
  int64_t events, exchanges, tableau_rebuilds;
  uint64_t minimum_bytes, in_core_bytes;
  uint64_t workspace_bytes, peak_bytes; /* from its first multiple of 64: all there is; used by model and phases */
  uint64_t tape_blocks[4], tape_bytes_written[4], tape_bytes_read[4], tape_writes[4], tape_reads[4];
  double seconds[7];              /* per C2D_PHASE_; zero without a clock                           */
  double load, mu;                /* factor reached, coefficient in force                           */
  double max_residual;            /* largest relative residual of the contact equations seen        */
  double elimination_residual;    /* pivot growth in the elimination                                */
  double condition;               /* estimate: times the last digit, how much of displacements is round-off */
  double force_applied, force_contact, force_error; /* magnitudes along what the body is free to follow */
  double free_motion[3];          /* with C2D_FREE_MOTION, _GROSS_SLIDING, _TIPPING: how outcome_body starts to move: (ux, uy,
                                     rotation) about the origin, times any number                   */
  double tension_ratio;           /* smallest pressure inside an element over the largest nodal one */
  char title[80], unit_length[16], unit_force[16]; /* units: as c2d_set_units said, else empty      */
  int32_t load_cases, run_coefficient; /* run_coefficient, run_step: the step behind which c2d_run goes on; 0: none */
  double work, dissipated, elastic, energy_defect; /* as in c2d_step                                */
  double least_dissipation;       /* most negative contribution of a pair and event: round-off      */
  int32_t symmetry;               /* lines of symmetry by images: 1: x = symmetry_at[0], 2: y = symmetry_at[1], 3: both */
  int32_t breach;                 /* with C2D_BEYOND_LIMITS: C2D_BREACH_...                         */
  double symmetry_at[2], breach_size; /* of what the breach is measured against                         */
  int32_t point_loads, point_sets, curves, run_step; /* the first three: how many the model holds    */
  int32_t compressed_bodies, reserved; /* how many bodies are eliminated compressed                 */
  double compression_residual, compression_error; /* of 32 nodes' equations, over their largest term, where bodies' results were
                                     asked for; what a step of refinement would change by it, of displacements or tractions */
} c2d_summary;
c2d_status c2d_get_summary(c2d_solver* solver, c2d_summary* out); /* zeros for what is not known yet */

/* One body of the model: its sizes as they were given, and the forces on it, (fx, fy, moment about the origin). */
typedef struct c2d_body_result {
  uint32_t struct_size;
  int32_t element_nodes, elements, regions, open_regions; /* as in c2d_body                         */
  int32_t points, nodes;          /* boundary points, functional nodes                              */
  int32_t unknowns;               /* equations, 2 nodes + 3; 0: a rigid body                        */
  double youngs_modulus, poisson_ratio;
  double applied[3];              /* of all loads and reactions outside the contact                 */
  double contact[3];              /* of the contact tractions                                       */
} c2d_body_result;
c2d_status c2d_get_body_result(c2d_solver* solver, int32_t body, c2d_body_result* out); /* zeros for what is not known yet */

/* The contact of a zone as it stands. Forces are on side 2, moments about the origin; approach and shift: OUTPUT.md. */
typedef struct c2d_zone_state {
  uint32_t struct_size;
  int32_t open, stick, slip;      /* pairs; tied ones stick                                         */
  int32_t near_change, reserved;  /* within 1 % of another status: of the largest pressure or gap, or of friction's bound */
  double force[2], moment;
  double approach, shift;         /* motions of the bodies along and across its mean normal; need back substitution    */
  double largest_pressure, largest_friction, length; /* length: of the touching pairs               */
  double dissipated;              /* by friction since zero load, without what a jump sets free (the step's sum has it) */
} c2d_zone_state;
c2d_status c2d_get_zone_state(c2d_solver* solver, int32_t zone, c2d_zone_state* out); /* also inside a step callback */

/* A body as it stands: force and moment about the origin of all its contact; of a rigid one how it moved, (ux, uy) of its point
   (c2d_set_rigid_load, else the origin) and a rotation, and what acts on it where it is free, moment about the origin. */
typedef struct c2d_body_state {
  uint32_t struct_size;
  int32_t is_rigid;
  double contact[3], motion[3], point[2], load[3];
} c2d_body_state;
c2d_status c2d_get_body_state(c2d_solver* solver, int32_t body, c2d_body_state* out); /* also inside a step callback */

/* Item i of the model's lists, as it was given, in states model, prepared and running. Out of range: ARGUMENT. */
/* The coefficient that holds in a zone in the i-th run; zone 0: the one for all zones that have none of their own. */
c2d_status c2d_get_friction(c2d_solver* solver, int32_t zone, int32_t i, double* mu);
c2d_status c2d_get_path(c2d_solver* solver, int32_t i, int32_t* increments, double* load, int32_t cases);
/* Of a free zone: the elements that are in contact at all, and 0 for the nodes of side 1. */
c2d_status c2d_get_zone(c2d_solver* solver, int32_t i, c2d_zone* out);
c2d_status c2d_get_region(c2d_solver* solver, int32_t body, int32_t i, int32_t* first_element, int32_t* last_element);
c2d_status c2d_get_condition(c2d_solver* solver, int32_t body, int32_t element, int32_t local, int32_t load_case,
                             int32_t codes[4], double values[4]);
/* The point loads of all bodies and cases are one list. */
c2d_status c2d_get_point_load(c2d_solver* solver, int32_t i, int32_t* body, int32_t* load_case, double xy[2], double force[2]);
c2d_status c2d_get_points(c2d_solver* solver, int32_t i, c2d_points* out);
c2d_status c2d_get_curve(c2d_solver* solver, int32_t i, c2d_curve* out);
/* Points first ... first+count-1 of a set: x and y of the k-th to xy[k * stride], xy[k * stride + 1], ready for c2d_interior.
   *total (may be null): how many the set has. Needs no solver; `body` is not looked at. */
c2d_status c2d_expand_points(const c2d_points* points, int32_t first, int32_t count, double* xy, int64_t stride,
                             int32_t* total);
/* Zeros if there is none. is_rigid: 1 if the body is rigid. The load case that closes initial overlaps, or 0. */
c2d_status c2d_get_body_force(c2d_solver* solver, int32_t body, int32_t load_case, double force[2], double* rho_omega2,
                              double axis[2]);
c2d_status c2d_get_rigid(c2d_solver* solver, int32_t body, int32_t load_case, int32_t* is_rigid, double motion[3],
                         double axis[2]);
c2d_status c2d_get_interference(c2d_solver* solver, int32_t* load_case);

/* ---------------------------------------------------------------- 9 errors and state ---------------------------

   State        legal calls (those without a solver, get_state, get_summary, get_body_result, last_error, cancel, close: always)
   empty        read_deck                                               -> model
                all of section 5 but complete                           -> building (set_line, set_options: empty)
   building     all of section 5                                        -> model by complete; empty if that fails
   model        set_options, set_values, replace_point_load, set_body_force, set_rigid, set_rigid_load, set_units
                prepare                                                 -> prepared
                restore                                                 -> prepared or running, as saved
   prepared     begin, run                                              -> running
                save, restore, set_units; change_loads                  -> model
   running      begin, advance, next_event, run, get, get_zone_state, get_body_state, interior, indicators, save, restore,
                set_units; change_loads                                 -> model
   broken       after an error of the store: restore, or c2d_create in the same memory
   In model, prepared and running also positions by get, and the lists: get_friction, _path, _zone, _region, _condition,
   _point_load, _body_force, _rigid, _interference, _points, _curve. Where set_units is legal, so are set_name and get_name. */
enum { C2D_STATE_EMPTY = 0, C2D_STATE_BUILDING = 1, C2D_STATE_MODEL = 2, C2D_STATE_PREPARED = 3, C2D_STATE_RUNNING = 4,
       C2D_STATE_BROKEN = 5 };
int32_t c2d_get_state(const c2d_solver* solver); /* -1: not a solver */
/* Why the last call failed; in state broken: what broke the solver, whatever was refused since. */
c2d_status c2d_last_error(c2d_solver* solver, c2d_error* out);
/* A c2d_status or a number of a warning in words, an outcome in words: any integer; never null. */
const char* c2d_message(int32_t status);
const char* c2d_outcome_message(int32_t outcome);
const char* c2d_version(void); /* "0.2.0" */
/* These do nothing. In a library compiled with C2D_PARTS_BY_CALL a program has a part of it only if it names the function:
   bodies with holes; zones of kind C2D_ZONE_FREE; warnings of a preparation or a contact state (C2D_WARN_ZONE_END ... _SURFACE,
   except those that c2d_complete tells), which c2d_run and c2d_get_summary bring, too; what few states need, which c2d_run
   brings, too: the search for statuses where changes of the pairs that offend lead nowhere, the proof that there are none, how
   many solutions there are, and a body that nothing presses any more (without it a path ends there with C2D_UNDECIDED); and
   compressed elimination, of which small code has none. */
void c2d_link_holes(void);
void c2d_link_free_zones(void);
void c2d_link_warnings(void);
void c2d_link_search(void);
void c2d_link_compressed(void);

#ifdef __cplusplus
}
#endif
#endif
