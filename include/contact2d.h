/* contact2d: plane elastic contact with Coulomb friction by the boundary integral equation method, in memory supplied by the
   caller. Plain C99, valid C++. The library never prints, allocates, throws or exits. The order of calls:

   c2d_scan_deck, or numbers of your own   sizes              sections 2, 4; as constants: contact2d_memory.h
   c2d_create                              the solver         2; its port: 3
   c2d_read_deck, or                       the model          4; cards one by one: contact2d_cards.h
   c2d_set_problem ... c2d_complete          by calls         5
   c2d_prepare                             the equations      6; other loads: c2d_change_loads
   c2d_run, or                             the load path      7
   c2d_begin, c2d_advance ...                step by step     7; c2d_save, c2d_restore; cycles: contact2d_cycle.h
   c2d_get, c2d_interior ...               results            8; words and numbers: 1
   c2d_close                                                  9: states and legal calls, error details

   The header follows this order; include/README.md has two complete programs, one that reads a deck and one by calls. METHOD
   (7.2) is an equation of src/METHOD.md, METHOD 7 a section; (NBP) is a variable name of the 1987 program.

   Conventions. Any consistent units; forces are per unit thickness. The material lies on the left of a boundary: outer
   boundaries run counter-clockwise, holes clockwise. Rotations are in radians, counter-clockwise. Bodies, elements, nodes,
   pairs, zones, load cases and items of lists are numbered from 1. A contact zone has two sides, each on a body. A pair joins
   two points of the sides; in its frame n points from side 1 to side 2, and t is n turned by -90 degrees. The tractions tn and
   tt of a pair act on side 2, per unit undeformed length of side 1 (in a free zone: of side 2); tn >= 0 is pressure.

   Arguments stand in one order: the solver; which body, element, local node, zone, item i; the load case; values in; values
   out. A list with one number per load case or zone is (pointer, count). A range of entries is first, count, and the array it
   goes to or comes from (pointer, stride): entry k at [k * stride], in doubles. A pointer may be null only where stated.

   Failures. Every function returns a status. A call that does not return C2D_OK has changed nothing, outputs included. The
   exceptions: the list of c2d_scan_deck; c2d_create and c2d_attach set *out to null; a failed c2d_read_deck or c2d_complete
   leaves an empty model; a cancelled c2d_advance or c2d_run stays at the last load reached; STORE_...: `broken` (section 9).
   c2d_port.log receives each fault once, c2d_last_error keeps the first. Any call may return C2D_ERR_ARGUMENT, _STATE or _BUSY;
   `Errors:` lists the others, STORE_... for any C2D_ERR_STORE_. A load path that cannot continue is an outcome, not a failure.

   Threads. Solvers share nothing: there is no variable outside of a solver's memory. Calls on one solver come from one thread
   at a time, except c2d_cancel. The library is not reentrant: inside a callback only the calls of section 3 are legal. */
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

   Public structs begin with struct_size. c2d_limits sizes = C2D_INIT(c2d_limits); sets it, and all other members to zero,
   their default. New members are only appended; the library accesses the smaller of struct_size and its own size, and refuses a
   size that C2D_INIT cannot have set. Return codes (c2d_status), outcomes of a path (c2d_outcome), warnings (C2D_WARN_...) and
   the fields of c2d_get are in contact2d_codes.h. */

typedef struct c2d_solver c2d_solver; /* lives inside the caller's memory */
enum { C2D_OPEN = 0, C2D_STICK = 1, C2D_SLIP = 2, C2D_TIED = 3 }; /* status of a pair   */
enum { C2D_PLANE_STRAIN = 0, C2D_PLANE_STRESS = 1, C2D_AXISYMMETRIC = 2 };
enum { C2D_NOTE = 0, C2D_WARNING = 1, C2D_FAULT = 2 }; /* c2d_error.severity */
/* A fault, a warning or a note. Members that do not apply are 0. */
typedef struct c2d_error {
  uint32_t struct_size;
  int32_t status, severity;     /* a c2d_status; for warnings and notes a C2D_WARN_ number; C2D_NOTE ...   */
  int32_t host_code;            /* what the caller's function returned                              */
  int32_t line;                 /* of the deck, or the last one set by c2d_set_line                 */
  int32_t column, column_end;   /* first and last column of the field                               */
  int32_t body, zone, pair, element, node, tape;
  int64_t block;
  uint64_t bytes_needed;        /* with C2D_ERR_MEMORY: workspace bytes that are sufficient         */
  double load;                  /* load factor at which it happened                                 */
  char text[320];               /* one line, ASCII except names: what was found and expected         */
} c2d_error;

/* ---------------------------------------------------------------- 2 sizes and memory ---------------------------

   Query the sizes, provide at least `minimum` bytes (static, heap, COMMON; any alignment), create the solver in them. */
typedef struct c2d_body_limits {
  int32_t points;             /* boundary points (NBP), ends of open regions included               */
  int32_t elements, regions, reserved; /* elements (NEL); closed and open curves (NREN)             */
} c2d_body_limits;
typedef struct c2d_limits {
  uint32_t struct_size;
  int32_t bodies;             /* how many (NBODY)                                                   */
  c2d_body_limits* body;      /* [bodies], the caller's array; the library does not keep the pointer */
  int32_t function_nodes;     /* functional nodes per element: 1 constant ... 4 cubic (NFNODE)      */
  int32_t zones, pairs;       /* contact zones (MCP); pairs in all of them, of C2D_ZONE_SELF twice  */
  int32_t contact_elements;   /* pairs of elements in all zones; elements of side 2 in free zones   */
  int32_t point_loads;        /* of all bodies together                                             */
  int32_t coefficients;       /* of friction, solved one after another (NMU)                        */
  int32_t paths;              /* load cards (NPATH)                                                 */
  int32_t load_cases;         /* 0 means 1                                                          */
  int32_t panel_columns;      /* columns eliminated at a time; 0: as many as fit in memory          */
  int32_t free_pairs;         /* how many of the pairs are in zones of kind C2D_ZONE_FREE           */
  int32_t point_sets, curves, platens; /* cards under *POINTS, *CURVE, *PLATEN: bodies beyond `bodies`, and a zone each */
  int32_t touching, cycle_states, reserved; /* see C2D_COLUMNS_ in contact2d_memory.h; contact2d_cycle.h */
} c2d_limits;
/* Bytes of workspace: `minimum` solves any model within the limits in the smallest blocks (stacked slender bodies: c2d_prepare
   reports), `in_core` stores the whole matrix of a body; threads use more. Outputs, why may be null. Errors: OVERFLOW. */
c2d_status c2d_memory_need(const c2d_limits* limits, uint64_t* minimum, uint64_t* in_core, c2d_error* why);

/* ---------------------------------------------------------------- 3 the port -----------------------------------

   The services that the library needs from its host. Initialise the struct with C2D_INIT and set the members you provide. Ports
   for memory, stdio and POSIX files are in port/; port/README.md states what fails if a duty is violated. All functions return
   0 for success; any other value is your error code and is returned in c2d_error.host_code. They must return: no exception,
   longjmp or exit may leave them. Inside them c2d_cancel, c2d_memory_need, c2d_get_state are legal for the calling solver, all
   other calls return C2D_ERR_BUSY; a step callback (section 7) may also call c2d_get_zone_state and _body_state and, except
   for a CHANGE, c2d_get, _interior and _save. */
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
  void* context;              /* passed to every function below                                     */
  /* Block store, all five or none (c2d_prepare, c2d_save and c2d_restore need it). Tapes are numbered 0 ... C2D_TAPES-1, blocks
     from 0; a block is written as a whole, with at most block_bytes bytes, and read back with the same number of bytes.
     open  provides space for `blocks` blocks; data of an earlier run may stay (it is recognised and refused).
     read  must fill exactly `bytes` bytes or fail: a short read reported as success is detected by the checksum.
     write may be cached until sync; sync must not return before the data would survive a crash.
     close must report a failure: the data may then be lost.                                        */
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

/* Create a solver in memory[0 .. bytes), in state empty; *out points into it. `port` is copied, its context must stay valid;
   null: no store, the model can only be checked. `why` may be null. Errors: OVERFLOW, MEMORY with why->bytes_needed. */
c2d_status c2d_create(c2d_solver** out, void* memory, size_t bytes, const c2d_limits* limits, const c2d_port* port,
                      c2d_error* why);
/* Continue with a solver whose memory was moved, reloaded or passed to another process of the same build: memory[0 .. bytes)
   is a copy, made between calls, of all the memory given to c2d_create, at any alignment, possibly longer. It continues with
   identical results; every earlier c2d_solver* is invalid. `port` reopens the tapes that were open; their contents must be
   unchanged. On failure the image can still be attached. Its data are trusted: contact2d_image.h attaches by checksum.
   Errors: ARGUMENT: the memory has no solver; MISMATCH: one of another version, size of pointers or scalar, or prepared by a
   program linked without energies; MEMORY with why->bytes_needed; BUSY: copied inside a callback; STORE_OPEN. */
c2d_status c2d_attach(c2d_solver** out, void* memory, size_t bytes, const c2d_port* port, c2d_error* why);
/* Close the store (Errors: STORE_CLOSE). The memory belongs to the caller again, whatever the call returns. */
c2d_status c2d_close(c2d_solver* solver);

/* ---------------------------------------------------------------- 4 a model from a deck ------------------------

   A deck is the 1987 program's card deck (src/deck/DECK.md). read_line puts the next card, without its line end, into text[0
   .. size), ended by a zero byte, and returns its length (a longer line: what fits, and its full length); -1 at the end of the
   deck; any other negative number is the caller's error (C2D_ERR_READ, host_code). */
typedef int32_t (*c2d_read_line)(void* context, char* text, int32_t size);
typedef void (*c2d_report)(void* context, const c2d_error* entry);
/* Sizes of a deck, without a workspace: fills *out and out->body, an array for out->bodies bodies. c2d_read_deck may still
   refuse a deck that passes. c2d_scan_deck puts the first fault into *why, c2d_check_deck passes every fault to `report`;
   either may be null. Errors: INPUT, READ: out->body is undefined; LIMIT: only out->bodies is set, to the number of bodies. */
c2d_status c2d_scan_deck(c2d_read_line read, void* context, c2d_limits* out, c2d_error* why);
c2d_status c2d_check_deck(c2d_read_line read, void* context, c2d_limits* out, c2d_report report, void* report_context);
/* Read a whole deck and complete the model; c2d_port.log receives all faults. Errors: INPUT, READ, LIMIT. */
c2d_status c2d_read_deck(c2d_solver* solver, c2d_read_line read, void* context);

/* ---------------------------------------------------------------- 5 a model by calls ---------------------------

   The order: problem, bodies, regions, nodes, conditions, loads, zones, friction, paths, c2d_complete. All may return LIMIT. */
enum { C2D_ANALYSIS_CHECK = -1, C2D_ANALYSIS_STRESS = 0, C2D_ANALYSIS_CONTACT = 1, C2D_ANALYSIS_FULL = 2,
       C2D_ANALYSIS_ITERATIONS = 3 };
typedef struct c2d_problem {
  uint32_t struct_size;
  int32_t plane;              /* C2D_PLANE_STRAIN, C2D_PLANE_STRESS or C2D_AXISYMMETRIC (IPTYPE)    */
  int32_t analysis;           /* C2D_ANALYSIS_... (IOUT; anything above 3 counts as 3)              */
  int32_t iteration_limit;    /* per increment of deck stepping (ITMAX); 0 means 50                 */
  char title[80];             /* ended by a zero byte                                               */
} c2d_problem;
c2d_status c2d_set_problem(c2d_solver* solver, const c2d_problem* problem); /* C2D_AXISYMMETRIC: METHOD 21 */

typedef struct c2d_body {
  uint32_t struct_size;
  int32_t element_nodes;      /* geometry nodes per element: 2 linear, 3 quadratic, 4 cubic (NBN)   */
  int32_t elements, regions;  /* NEL, NREN                                                          */
  double youngs_modulus;      /* E > 0, force per area                                              */
  double poisson_ratio;       /* -1 < nu <= 0.5 (plane stress: -0.5 < nu <= 0.5)                    */
  int32_t open_regions, reserved; /* the first ones are open: see c2d_set_symmetry                  */
} c2d_body;
/* A second call may change the moduli, not the numbers of elements or regions. */
c2d_status c2d_set_body(c2d_solver* solver, int32_t body, const c2d_body* data);
/* Elements first ... last form a closed curve, or an open one; regions follow one another without a gap. */
c2d_status c2d_add_region(c2d_solver* solver, int32_t body, int32_t first_element, int32_t last_element);
/* Boundary points first ... first+count-1: x and y of the k-th at xy[k * stride], xy[k * stride + 1], in global coordinates.
   Element e of a region has its first geometry node at (e-1)*(element_nodes-1)+1, plus the open regions before it. */
c2d_status c2d_set_nodes(c2d_solver* solver, int32_t body, int32_t first, int32_t count, const double* xy, int64_t stride);
/* Boundary points first ... last, both ends included, at equal distances along a straight line, or along an arc between two
   angles (degrees, counter-clockwise from the x axis; downwards if the second is smaller), as between two node cards of a
   deck, with identical bits. `from` and `to` are relative to `origin` (null: (0, 0)). last > first, radius >= 0. */
c2d_status c2d_set_line_nodes(c2d_solver* solver, int32_t body, int32_t first, int32_t last, const double origin[2],
                              const double from[2], const double to[2]);
c2d_status c2d_set_arc_nodes(c2d_solver* solver, int32_t body, int32_t first, int32_t last, const double centre[2],
                             double radius, double from_degrees, double to_degrees);
/* Condition at local functional node `local` of an element: codes[4] and values[4] in the order tx ty ux uy, global
   components; code 0: known, with this value; 1: unknown. Ends without a condition are free of traction. The contact determines
   the traction at the ends of its pairs: a prescribed one is refused. All values scale with the factor of the load case. */
c2d_status c2d_set_condition(c2d_solver* solver, int32_t body, int32_t element, int32_t local, int32_t load_case,
                             const int32_t codes[4], const double values[4]);
/* Prescribed values of an end in a load case: values[4] as above; the codes stay. local 0: all ends of the element. Refused are
   a non-zero value of an unknown or a contact quantity, and a displacement that differs from that of the other end at the same
   node (while building 0 leaves it unchanged). In state model every known quantity takes its value, zero included;
   displacements of contact nodes and those fixed by symmetry are then refused as well. */
c2d_status c2d_set_values(c2d_solver* solver, int32_t body, int32_t element, int32_t local, int32_t load_case,
                          const double values[4]);
/* Force (fx, fy) at (x, y) inside the body; axisymmetric: of the circle. On a line of symmetry: along it, the part's share. */
c2d_status c2d_add_point_load(c2d_solver* solver, int32_t body, int32_t load_case, double x, double y, double fx, double fy);
/* Body force per area, of bodies of revolution per volume: `force` (weight) plus rho_omega2 (x - axis[0], y - axis[1]), density
   times angular velocity squared; axis may be null where rho_omega2 is 0. One per body and load case, a second call replaces
   the first. Across a line of symmetry, or the axis x = 0, acts no weight, and `axis` must lie on the line. METHOD 6. */
c2d_status c2d_set_body_force(c2d_solver* solver, int32_t body, int32_t load_case, const double force[2], double rho_omega2,
                              const double axis[2]);
/* Make the body rigid: it has no equations and moduli, its mesh defines frames and lengths. In a load case it moves by
   motion[0], motion[1] and rotates by the small angle motion[2] about axis[0], axis[1]; load_case 0 only makes it rigid, and
   both arrays may be null. Conditions are ignored; c2d_complete refuses tractions and forces on it, and a zone of two rigid
   bodies. Results: its motion, contact tractions, no stresses; `applied` is the load or reaction on it. */
c2d_status c2d_set_rigid(c2d_solver* solver, int32_t body, int32_t load_case, const double motion[3], const double axis[2]);
/* Motions i = 0 to 2 of a rigid body (ux, uy, rotation of `point`) with is_free[i] != 0 are free: equilibrium with the contact
   and load[0 .. 3) determines them. The load is fx, fy and the moment about `point`; only components of free motions count.
   load_case 0 sets is_free and point (and makes the body rigid), other cases set the load; the other arguments are ignored. */
c2d_status c2d_set_rigid_load(c2d_solver* solver, int32_t body, int32_t load_case, const int32_t is_free[3],
                              const double load[3], const double point[2]);
/* A platen: elements first ... last (across the end of a closed region with their number `elements`, else 0) move as one rigid
   body without a mesh: body c2d_limits.bodies + 1, + 2, ..., "platen 1", ...; its tie is the next zone, the platen its side 1.
   is_free and point as above; the two calls above move and load it. Its ends have no conditions, no contact. METHOD 10.8. */
c2d_status c2d_add_platen(c2d_solver* solver, int32_t body, int32_t first_element, int32_t last_element, int32_t elements,
                          const int32_t is_free[3], const double point[2]);
/* Interference of a press fit: pairs that overlap before any load are legal and begin in contact; the factor of this load case
   removes their overlap, completely at factor 1. c2d_run raises it from 0 to 1 before the first step of the path and keeps it
   there; with c2d_advance the caller sets it. A second call replaces the first. */
c2d_status c2d_set_interference(c2d_solver* solver, int32_t load_case);
/* Contact between two ranges of elements, side 1 and side 2, of two bodies, which may share several zones, or of one body in
   self-contact (C2D_ZONE_SELF: the sides share no element). Element numbers may decrease along a range; a range across
   the end of its region needs its number of `elements` (0: from first and last).
   C2D_ZONE_MATCHING: elements face each other, first with first, last with last, and the functional nodes first_node ...
   last_node, `pairs` of them, form pairs in the same order.
   C2D_ZONE_FREE: independent meshes; either side may run up or down, pairs and nodes are ignored. Every functional node of side
   2 forms a pair with the point of side 1 whose normal passes through it (C2D_X, C2D_Y; C2D_PAIR_NODE1 is 0), but not an end
   node that a support holds or that a matching zone, else a tie, else an earlier zone has; elements of side 2 that face side 1
   only in part are excluded. Nodes of side 1 keep their conditions (both unknown: the contact's); tractions prescribed there
   add to the contact's. The force is transferred exactly, its moment as far as paired points coincide (METHOD 9). c2d_limits:
   `pairs` and `free_pairs` count all nodes of elements of side 2. c2d_complete refuses sides that do not face each other. */
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
/* Bond zone i (from 1): it carries unlimited tension and shear and never changes its status. Its surfaces must coincide within
   a tenth of an element; their distance is not a gap. Pairs of such zones are numbered after all others. */
c2d_status c2d_tie_zone(c2d_solver* solver, int32_t zone);
/* The true surface over elements of a body: gaps, normals and facing points are those of the surface, not of the elements
   (METHOD 8). By default it is a smooth curve that keeps the corners and kinks that the boundary points show. A line is
   straight, an arc is circular, a spline is smooth at every point whatever the angles. c2d_complete refuses elements in two
   curves, and points farther from a line or an arc than a thousandth of their element. */
enum { C2D_CURVE_LINE = 0, C2D_CURVE_ARC = 1, C2D_CURVE_SPLINE = 2 };
typedef struct c2d_curve {
  uint32_t struct_size;
  int32_t kind, body;         /* C2D_CURVE_...; the body it belongs to                              */
  int32_t first_element, last_element; /* of one region, going up                                   */
  int32_t line;               /* of the deck or of c2d_set_line; set by c2d_get_curve, else unused  */
  double centre[2], radius;   /* of an arc                                                          */
} c2d_curve;
c2d_status c2d_add_curve(c2d_solver* solver, const c2d_curve* curve);
/* A coefficient for c2d_run, zero or more, infinity: full adhesion; c2d_set_zone_friction: of one zone, in the i-th run. */
c2d_status c2d_add_friction(c2d_solver* solver, double mu);
c2d_status c2d_set_zone_friction(c2d_solver* solver, int32_t zone, int32_t i, double mu);
/* Symmetry by images (METHOD 5): the model is mirrored across the line x = value (axis 0) or y = value (axis 1), at most one of
   each. Model one half (one quarter) without elements on the lines: a curve that crosses a line is an open region that ends on
   the lines; the image of a body that meets no line is another body. Open regions come first in a body
   (c2d_body.open_regions), and have one boundary point and, except with constant elements, one functional node more. The
   displacement across a line is 0; other conditions are as usual. Forces and moments are those of the modelled part. */
c2d_status c2d_set_symmetry(c2d_solver* solver, int32_t axis, double value);
/* A straight segment of the load path, in `increments` equal steps from the end of the last segment (first: zero) to load[0 ..
   cases), a factor for every load case. c2d_clear_paths removes all segments. */
c2d_status c2d_add_path(c2d_solver* solver, int32_t increments, const double* load, int32_t cases);
c2d_status c2d_clear_paths(c2d_solver* solver);
/* Points for interior results. The model only stores the list, for use with c2d_interior after the solution
   (c2d_get_points, c2d_expand_points in section 8). The points need not lie inside. */
enum { C2D_POINTS_ONE = 0, C2D_POINTS_LINE = 1, C2D_POINTS_GRID = 2 };
typedef struct c2d_points {
  uint32_t struct_size;
  int32_t kind, body;         /* C2D_POINTS_...; the body they lie in                               */
  int32_t count[2];           /* line: count[0] points from one end to the other; grid: count[0] in x and count[1] in y, row by
                                 row, x first; else unused. At least 1 each, together fewer than 2^31 */
  int32_t line;               /* of the deck or of c2d_set_line; set by c2d_get_points, else unused */
  double from[2], to[2];      /* the point; the line's ends; opposite corners of the grid           */
} c2d_points;
c2d_status c2d_add_points(c2d_solver* solver, const c2d_points* points);
/* Names of the units of length and force for axis titles, each at most 15 characters; null: empty. Nothing is converted. */
c2d_status c2d_set_units(c2d_solver* solver, const char* length, const char* force);
/* Name of body or zone i, shown with its number in messages and outputs: at most 31 bytes of UTF-8, no control characters;
   null or "": no name. c2d_get_name pads the name with zero bytes. */
enum { C2D_NAME_BODY = 0, C2D_NAME_ZONE = 1 };
c2d_status c2d_set_name(c2d_solver* solver, int32_t kind, int32_t i, const char* name);
c2d_status c2d_get_name(c2d_solver* solver, int32_t kind, int32_t i, char out[32]);
/* Position in the caller's input that later faults report; 0: none. */
c2d_status c2d_set_line(c2d_solver* solver, int32_t line, int32_t column, int32_t column_end);
/* Validate the model; c2d_port.log receives every fault. Errors: INPUT. */
c2d_status c2d_complete(c2d_solver* solver);

enum { C2D_QUADRATURE_ACCURATE = 0, C2D_QUADRATURE_THESIS = 1 };
enum { C2D_STEPPING_EVENTS = 0, C2D_STEPPING_DECK = 1 };
/* Elements on a line of symmetry: kept, or replaced by images. The line bounds every body; each of its elements has zero
   displacement across and zero traction along the line. Results there are 0. Lines are found if none is given. */
enum { C2D_SYMMETRY_DECK = 0, C2D_SYMMETRY_IMAGES = 1 };
/* Compressed (METHOD 7.6): cost proportional to the nodes; equal to dense within 1e-9, else C2D_WARN_COMPRESSED; at most 128
   MiB beyond twice the least workspace. Side 1 of free zones and over 2 regions + 2 holes: dense. By size: C2D_COMPRESSES. */
enum { C2D_ELIMINATION_DENSE = 0, C2D_ELIMINATION_COMPRESSED = 1, C2D_ELIMINATION_BY_SIZE = 2 };
typedef struct c2d_options {
  uint32_t struct_size;
  int32_t quadrature, stepping; /* C2D_QUADRATURE_..., C2D_STEPPING_...                             */
  int32_t every_change;       /* 1: c2d_run also calls its callback at changes of status, within the limits of accuracy */
  int32_t symmetry;           /* C2D_SYMMETRY_...; before c2d_complete or c2d_read_deck             */
  int32_t keep_factors;       /* 1: keep all of L, so that new loads cost little: tape LOWER is as large as UPPER */
  int32_t elimination;        /* C2D_ELIMINATION_...; only DENSE uses keep_factors                  */
} c2d_options;
/* Any time before c2d_prepare; another `symmetry` for a complete model: STATE. */
c2d_status c2d_set_options(c2d_solver* solver, const c2d_options* options);
/* Number of blocks, and bytes of each, for which the store must provide space when a tape (0 ... C2D_TAPES-1) is opened by a
   solver of these limits and workspace_bytes: upper bounds for any model within the limits, saved states included. `options`,
   outputs and `why` may be null. Errors: OVERFLOW, MEMORY with why->bytes_needed. */
c2d_status c2d_tape_need(const c2d_limits* limits, const c2d_options* options, uint64_t workspace_bytes, int32_t tape,
                         uint64_t* blocks, uint64_t* block_bytes, c2d_error* why);

/* ---------------------------------------------------------------- 6 prepare ------------------------------------

   Assemble (METHOD 2), eliminate the unknowns outside the contact (METHOD 7), reduce to the contact unknowns (METHOD 10), once
   per model. State afterwards: prepared; after a failure or a cancel: model. A body that contact cannot support is no error
   here: c2d_advance reports it. Errors: STORE_..., SINGULAR, CANCELLED, MEMORY; INPUT: changed loads; LIMIT: `touching`. */
c2d_status c2d_prepare(c2d_solver* solver);
/* Change the loads of the same bodies. c2d_change_loads ends the path and returns to state model, where c2d_set_values,
   c2d_set_body_force, c2d_set_rigid and c2d_set_rigid_load (load_case > 0) and c2d_replace_point_load (place and force of point
   load i, in the order given; body and load case stay) change the values of load cases. c2d_prepare validates them and, with
   the option keep_factors, solves only the new right-hand sides with the stored factors: a small part of the work, and the
   same results to round-off. Without keep_factors, and after other options, a failure or a cancel, c2d_prepare repeats all
   work. Codes, geometry and contact do not change. A load case needed only later is counted in c2d_limits.load_cases from the
   beginning; its values do not matter until then. States saved before are stale. */
c2d_status c2d_change_loads(c2d_solver* solver);
c2d_status c2d_replace_point_load(c2d_solver* solver, int32_t i, double x, double y, double fx, double fy);

/* ---------------------------------------------------------------- 7 follow the load ----------------------------

   Begin: zero load, no history, coefficients of friction mu[0 .. zones) (zones = 1: one for all), each >= 0, infinity:
   full adhesion. The first > 0 after a preparation with none repeats its end. State: running. Errors: STORE_..., MEMORY. */
c2d_status c2d_begin(c2d_solver* solver, const double* mu, int32_t zones);
/* Follow a straight line from the load factors reached to load[0 .. cases). If *outcome is not C2D_REACHED the solver remains
   valid at the last load reached; also after a cancel or MEMORY (`touching`). Errors: STORE_..., CANCELLED, MEMORY. */
c2d_status c2d_advance(c2d_solver* solver, const double* load, int32_t cases, c2d_outcome* outcome);
/* Distance along direction[0 .. cases) at which the next pair changes its status: *step times the direction; infinity if no
   pair does; 0 if the path cannot continue in this direction. The load does not change; a pair at the limit of its status
   (zero pressure or incipient slip) may take the status that belongs to the direction. Errors: STORE_..., MEMORY. */
c2d_status c2d_next_event(c2d_solver* solver, const double* direction, int32_t cases, double* step);

/* Save the state of the path on tape 0 or, in state prepared, the fact that a factorisation exists. A crash at any moment
   leaves this state or the one saved before; the tapes are synchronised first. c2d_summary does not count these transfers. In
   the callback of c2d_run, except at a CHANGE, it also saves the position in the run: after c2d_restore c2d_run continues
   there, if no other call has changed the load. Errors: STORE_... (c2d_restore returns to the state saved before). */
c2d_status c2d_save(c2d_solver* solver);
/* Return to the newest complete saved state: nothing is eliminated again, and later results have identical bits. In another
   process: c2d_create with the same limits, the same model and options (state model), the same store, then c2d_restore in
   place of c2d_prepare; a saved state prepared serves any path. Errors, after which the solver is unchanged: MISMATCH: saved
   for another model, path, limits or stepping, or by another library or kind of machine (see c2d_last_error); STORE_STALE: a
   later c2d_prepare has begun; STORE_FORMAT or _READ: nothing was saved; STORE_...: no complete state; MEMORY with
   bytes_needed: saved in a larger workspace. State broken only if the store fails or data are invalid while they are loaded. */
c2d_status c2d_restore(c2d_solver* solver);
/* The argument of a step callback. `table` has a row per pair and the columns C2D_X ... C2D_PAIR_ZONE of section 8: column c of
   pair p at table[(p-1) * stride + c]. All pointers are valid during the call only. */
enum { C2D_STEP_RECORDED = 0, C2D_STEP_CHANGE = 1, C2D_STEP_STOPPED = 2, C2D_STEP_CYCLE = 3 }; /* contact2d_cycle.h */
typedef struct c2d_step {
  uint32_t struct_size;
  int32_t kind;               /* RECORDED: end of an increment; CHANGE: a status changed; STOPPED: the path ended early */
  int32_t coefficient;        /* which of the deck's coefficients                                   */
  int32_t step;               /* counts the increments of all load cards from 1                     */
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
  double dissipated;          /* by friction: sum over pairs of W tt dslip, W the tributary length of the pair: the integral of
                                 its shape functions along the side to whose length tractions refer */
  double elastic;             /* energy stored in all bodies                                        */
  double energy_defect;       /* (work - elastic - dissipated) over the largest of the three on the path so far: the
                                 discretisation error, largest at corners, also of a meshed line of symmetry */
} c2d_step;
typedef int32_t (*c2d_step_fn)(void* context, const c2d_step* step); /* non-zero: stop, C2D_ERR_CALLBACK */
/* Follow the load path of the model for each of its coefficients of friction. A path that ends early is no error of this call:
   the callback (may be null) and c2d_get_summary report it, and the next coefficient is run. State afterwards: running, at the
   last load reached, also after CALLBACK, CANCELLED. Errors: ARGUMENT: no path; CALLBACK, CANCELLED, MEMORY, STORE_.... */
c2d_status c2d_run(c2d_solver* solver, c2d_step_fn step, void* context);
/* From any callback, another thread or a signal handler: the solver stops as soon as possible and the active call returns
   C2D_ERR_CANCELLED. If no call is active, or it ends first, the next call that lists CANCELLED does: no cancel is lost. */
c2d_status c2d_cancel(c2d_solver* solver);

/* ---------------------------------------------------------------- 8 results ------------------------------------

   At the load reached, in state running. All except queries of the model may return STORE_... (the first call at a load that
   needs back substitution performs it). c2d_get copies entries first ... first+count-1 of a field (contact2d_codes.h) to
   out[0], out[stride], ...; positions also in states model and prepared. */
c2d_status c2d_get(c2d_solver* solver, int32_t field, int32_t body, int32_t first, int32_t count, double* out, int64_t stride);

/* Columns of an interior point. szz = nu (sxx + syy) in plane strain, 0 in plane stress, and enters the von Mises stress;
   principal stresses are in-plane, the larger first; max_shear is half their difference. The same applies to C2D_END_.... */
enum {
  C2D_POINT_UX = 0, C2D_POINT_UY = 1, C2D_POINT_SXX = 2, C2D_POINT_SYY = 3, C2D_POINT_SXY = 4, C2D_POINT_SZZ = 5,
  C2D_POINT_VON_MISES = 6, C2D_POINT_MAX_SHEAR = 7, C2D_POINT_PRINCIPAL1 = 8, C2D_POINT_PRINCIPAL2 = 9,
  C2D_POINT_FLAG = 10, C2D_POINT_FIELDS = 11 /* the flag is one of the values below                 */
};
enum {
  C2D_POINT_INSIDE = 0,       /* METHOD 16.3, error below 1e-8 down to 1e-6 of an element length from the boundary */
  C2D_POINT_NEAR_NODE = 1,    /* within a tenth (constant functions: half) of the shorter element from an element end, where
                                 tractions jump by the discretisation error: stress of smoothed tractions (METHOD 16.3), exact
                                 for a uniform stress; displacement as inside                       */
  C2D_POINT_BOUNDARY = 2,     /* within 1e-9 of an element length: displacement and tensor of the boundary point */
  C2D_POINT_OUTSIDE = 3       /* of the body asked for, or of all: every other column is 0          */
};
/* Displacements and stresses at `count` points (xy[i * xy_stride], xy[i * xy_stride + 1]); column c of point i goes to out[i *
   out_stride + c]. xy_stride >= 2, out_stride >= C2D_POINT_FIELDS; xy and out must not overlap. body 0: the first body that
   contains the point. The singular field of a point load is omitted at its own point. Displacements and stresses are 0 before
   the first contact, and where a rigid-body motion has no support. With lines of symmetry points may lie anywhere in the whole
   model. Many points in one call cost less than one by one. Errors: STORE_..., CANCELLED: `out` is then undefined. */
c2d_status c2d_interior(c2d_solver* solver, int32_t body, int32_t count, const double* xy, int64_t xy_stride, double* out,
                        int64_t out_stride);
/* Discretisation error indicators of elements: C2D_OFF_... (contact2d_codes.h). Errors: as c2d_interior. */
c2d_status c2d_indicators(c2d_solver* solver, int32_t body, int32_t first, int32_t count, double* out, int64_t stride);

typedef struct c2d_summary {
  uint32_t struct_size;
  int32_t state;
  c2d_outcome outcome;            /* of the last path followed                                      */
  int32_t outcome_body, outcome_pair; /* the body that can move, the pair that changed last         */
  int32_t bodies, function_nodes, pairs, zones, steps, coefficients; /* steps: increments of all load cards */
  int32_t contact_unknowns, analysis, plane, stepping, quadrature, iteration_limit, paths, panel_columns, warnings;
  int64_t events, exchanges, tableau_rebuilds;
  uint64_t minimum_bytes, in_core_bytes;
  uint64_t workspace_bytes, peak_bytes; /* from its first multiple of 64: total; used by model and phases */
  uint64_t tape_blocks[4], tape_bytes_written[4], tape_bytes_read[4], tape_writes[4], tape_reads[4];
  double seconds[7];              /* per C2D_PHASE_; zero without a clock                           */
  double load, mu;                /* factor reached, coefficient in force                           */
  double max_residual;            /* largest relative residual of the contact equations seen        */
  double elimination_residual;    /* pivot growth in the elimination                                */
  double condition;               /* estimate; times the machine precision: relative round-off of displacements */
  double force_applied, force_contact, force_error; /* magnitudes along the free motions of the body */
  double free_motion[3];          /* with C2D_FREE_MOTION, _GROSS_SLIDING, _TIPPING: direction in which outcome_body starts to
                                     move: (ux, uy, rotation) about the origin, of any magnitude    */
  double tension_ratio;           /* smallest pressure inside an element over the largest nodal one */
  char title[80], unit_length[16], unit_force[16]; /* units: from c2d_set_units, else empty         */
  int32_t load_cases, run_coefficient; /* run_coefficient, run_step: the step after which c2d_run continues; 0: none */
  double work, dissipated, elastic, energy_defect; /* as in c2d_step                                */
  double least_dissipation;       /* most negative contribution of a pair and event: round-off      */
  int32_t symmetry;               /* lines of symmetry by images: 1: x = symmetry_at[0], 2: y = symmetry_at[1], 3: both */
  int32_t breach;                 /* with C2D_BEYOND_LIMITS: C2D_BREACH_...                         */
  double symmetry_at[2], breach_size; /* breach_size: relative to its reference                        */
  int32_t point_loads, point_sets, curves, run_step; /* the first three: numbers in the model        */
  int32_t compressed_bodies, reserved; /* how many bodies are eliminated compressed                 */
  double compression_residual, compression_error; /* of the equations of 32 nodes, over their largest term, for bodies with
                                     results; relative change of displacements or tractions that a refinement step would make */
} c2d_summary;
c2d_status c2d_get_summary(c2d_solver* solver, c2d_summary* out); /* zeros for what is not known yet */

/* One body of the model: its sizes as given, and the forces on it, (fx, fy, moment about the origin). */
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

/* Current contact state of a zone. Forces act on side 2, moments are about the origin; approach and shift: OUTPUT.md. */
typedef struct c2d_zone_state {
  uint32_t struct_size;
  int32_t open, stick, slip;      /* pairs; tied ones stick                                         */
  int32_t near_change, reserved;  /* within 1 % of another status: of the largest pressure or gap, or of the friction limit */
  double force[2], moment;
  double approach, shift;         /* relative motion along and across the mean normal; needs back substitution         */
  double largest_pressure, largest_friction, length; /* length: of the touching pairs               */
  double dissipated;              /* by friction since zero load, without energy released by a jump (c2d_step has it) */
} c2d_zone_state;
c2d_status c2d_get_zone_state(c2d_solver* solver, int32_t zone, c2d_zone_state* out); /* also inside a step callback */

/* Current state of a body: force and moment about the origin of all its contacts; for a rigid one its motion, (ux, uy) of its
   point (c2d_set_rigid_load, else the origin) and the rotation, and the loads on its free motions, moment about the origin. */
typedef struct c2d_body_state {
  uint32_t struct_size;
  int32_t is_rigid;
  double contact[3], motion[3], point[2], load[3];
} c2d_body_state;
c2d_status c2d_get_body_state(c2d_solver* solver, int32_t body, c2d_body_state* out); /* also inside a step callback */

/* Item i of the lists of the model, as given, in states model, prepared and running. Out of range: ARGUMENT. */
/* Coefficient of friction of a zone in the i-th run; zone 0: the one of all zones without one of their own. */
c2d_status c2d_get_friction(c2d_solver* solver, int32_t zone, int32_t i, double* mu);
c2d_status c2d_get_path(c2d_solver* solver, int32_t i, int32_t* increments, double* load, int32_t cases);
/* Of a free zone: the elements that can touch, and 0 for the nodes of side 1. */
c2d_status c2d_get_zone(c2d_solver* solver, int32_t i, c2d_zone* out);
c2d_status c2d_get_region(c2d_solver* solver, int32_t body, int32_t i, int32_t* first_element, int32_t* last_element);
c2d_status c2d_get_condition(c2d_solver* solver, int32_t body, int32_t element, int32_t local, int32_t load_case,
                             int32_t codes[4], double values[4]);
/* The point loads of all bodies and cases form one list. */
c2d_status c2d_get_point_load(c2d_solver* solver, int32_t i, int32_t* body, int32_t* load_case, double xy[2], double force[2]);
c2d_status c2d_get_points(c2d_solver* solver, int32_t i, c2d_points* out);
c2d_status c2d_get_curve(c2d_solver* solver, int32_t i, c2d_curve* out);
/* Points first ... first+count-1 of a set: x and y of the k-th to xy[k * stride], xy[k * stride + 1], ready for c2d_interior.
   *total (may be null): number of points of the set. Needs no solver; `body` is ignored. */
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
   broken       after a store error: restore, or c2d_create in the same memory
   In model, prepared and running also positions by get, and the lists: get_friction, _path, _zone, _region, _condition,
   _point_load, _body_force, _rigid, _interference, _points, _curve. Where set_units is legal, so are set_name and get_name. */
enum { C2D_STATE_EMPTY = 0, C2D_STATE_BUILDING = 1, C2D_STATE_MODEL = 2, C2D_STATE_PREPARED = 3, C2D_STATE_RUNNING = 4,
       C2D_STATE_BROKEN = 5 };
int32_t c2d_get_state(const c2d_solver* solver); /* -1: not a solver */
/* Why the last call failed; in state broken: the fault that broke the solver, also after later refusals. */
c2d_status c2d_last_error(c2d_solver* solver, c2d_error* out);
/* Text of a c2d_status or a warning, and of an outcome, for any integer; never null. */
const char* c2d_message(int32_t status);
const char* c2d_outcome_message(int32_t outcome);
const char* c2d_version(void); /* "0.2.0" */
/* These do nothing at run time. With a library compiled with C2D_PARTS_BY_CALL they link optional parts into the program:
   bodies with holes; zones of kind C2D_ZONE_FREE; warnings of a preparation or a contact state, also linked by c2d_run and
   c2d_get_summary; the search, also linked by c2d_run, where changing the violating pairs fails (without it such a path ends
   with C2D_UNDECIDED); compressed elimination, which small code lacks; and bodies of revolution (C2D_AXISYMMETRIC). */
void c2d_link_holes(void);
void c2d_link_free_zones(void);
void c2d_link_warnings(void);
void c2d_link_search(void);
void c2d_link_compressed(void);
void c2d_link_axisymmetric(void);

#ifdef __cplusplus
}
#endif
#endif
