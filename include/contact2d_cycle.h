/* contact2d: cycles of loads, repeated until they are steady. Needs c2d_limits.cycle_states > 0 (contact2d.h).

     static c2d_status shake(c2d_solver* solver) {
       const double load[4] = {1.0, -0.3, 1.0, 0.3};
       c2d_cycle_request request = C2D_INIT(c2d_cycle_request);
       c2d_cycle_state state = C2D_INIT(c2d_cycle_state);
       c2d_outcome outcome;
       request.corners = 2;
       request.cases = 2;
       request.load = load;
       c2d_status status = c2d_advance(solver, load + 2, 2, &outcome);
       if (status == C2D_OK) status = c2d_cycle(solver, &request, NULL, NULL, &state);
       if (status == C2D_OK) printf("%d cycles, dissipation %g\n", (int)state.cycles, state.dissipated);
       return status;
     }

   Between two changes of status all is linear in the loads, so the state at the end of a cycle is a linear function of the
   state at its beginning, as long as the same pairs change their statuses in the same order. As soon as two cycles in a row do
   so, the fixed point of that function is extrapolated from the states followed so far, checked against gaps, pressures and the
   friction cone, and confirmed by a cycle that is followed: see METHOD 23 (src/METHOD.md). */
#ifndef CONTACT2D_CYCLE_H
#define CONTACT2D_CYCLE_H

#include "contact2d.h"

#ifdef __cplusplus
extern "C" {
#endif

/* c2d_limits.cycle_states: how many directions in which states at the ends of cycles differ can be kept for extrapolation. It
   adds C2D_CYCLE_BYTES(pairs, cycle_states) of contact2d_memory.h to the workspace; 20 to 40 are enough for most models. */
enum {
  C2D_CYCLES_EXACT = 0, /* extrapolate while three cycles and more repeat their changes of status: nearly always to the state
                           that the cycles themselves approach, which may depend on how they began */
  C2D_CYCLES_PLAIN = 1, /* extrapolate nothing                                                */
  C2D_CYCLES_FAST = 2   /* fewer cycles: a steady state that may differ from that one, by up to 5e-3 of the largest pressure in
                           tests, mostly by less than 1e-6 */
};
typedef struct c2d_cycle_request {
  uint32_t struct_size;
  int32_t corners, cases; /* of the cycle, at least 2; load cases, all of the model             */
  int32_t limit;          /* cycles to follow at most; 0 means 50                               */
  int32_t mode, reserved; /* C2D_CYCLES_...                                                     */
  double tolerance;       /* largest change over a steady cycle, of pressures relative to the largest one of the path and of
                             gaps to the largest gap or displacement; 0 means 1e-10             */
  const double* load;     /* [corners * cases] load factors, corner by corner. The path goes straight from one to the next;
                             the last corner is the load at which the cycle begins and ends     */
} c2d_cycle_request;

enum {                            /* c2d_cycle_state.result */
       C2D_CYCLE_NOT_STEADY = 0,  /* the limit of cycles was met, or not yet decided                    */
       C2D_CYCLE_SHAKES_DOWN = 1, /* no pair slips any more                                             */
       C2D_CYCLE_SLIPS = 2,       /* pairs slip forth and back by the same amount                       */
       C2D_CYCLE_RATCHETS = 3,    /* tractions repeat, but the surfaces move on by the same amount in each cycle */
       C2D_CYCLE_STOPPED = 4      /* the load path ended within the cycle: `outcome` is why             */
};
typedef struct c2d_cycle_state {
  uint32_t struct_size;
  int32_t result;                /* C2D_CYCLE_...                                                      */
  c2d_outcome outcome;           /* of the load path                                                   */
  int32_t cycles;                /* followed so far                                                    */
  int32_t extrapolations;        /* how many of them began at an extrapolated state                    */
  int32_t repeated;              /* the last so many had the same sequence of changes of status        */
  int32_t stuck, slipped;        /* pairs that stuck, and pairs that slipped, in the last cycle: the former all the time */
  int32_t range_pair, walk_pair; /* pairs of slip_range and walk; 0: none                           */
  double change;                 /* over the last cycle, as `tolerance`                                */
  double dissipated;             /* in the last cycle, as in c2d_step; 0 in a program without energies */
  double slip_range;             /* largest distance between the ends of a pair's slip in the last cycle */
  double walk; /* relative tangential motion (u2-u1).t of a pair over the last cycle, the one of largest magnitude */
} c2d_cycle_state;
/* After each cycle, in the solver's state at its end; if an extrapolation follows, in the extrapolated state. Legal in it are
   the calls that are legal in a step callback of c2d_run. Non-zero: stop, C2D_ERR_CALLBACK. */
typedef int32_t (*c2d_cycle_fn)(void* context, const c2d_cycle_state* now);
/* Follow cycles from the load reached, which must be the last corner, until the change over a followed cycle is within the
   tolerance, and fill *out. `each` may be null. A state saved in the callback is continued by c2d_restore and the same call,
   with identical bits. With C2D_STEPPING_DECK, free motions at rest and friction without bound nothing is extrapolated.
   Energies since zero load skip what an extrapolation passes over; their balance stays. Legal in state running. Errors:
   STORE_..., CALLBACK, CANCELLED (the solver stays at the last load reached), MEMORY. */
c2d_status c2d_cycle(c2d_solver* solver, const c2d_cycle_request* request, c2d_cycle_fn each, void* context,
                     c2d_cycle_state* out);

/* ---- the cycle of a load path that c2d_run follows ----

   The last `pieces` segments of the load path given so far (at least 2, and one before them) are a cycle: they end at the load
   factors at which they begin. c2d_run repeats them as c2d_cycle does, with C2D_CYCLES_EXACT and the tolerance 10^-digits
   (1 to 12; 0: 10), until they are steady, at most `limit` times (0: 50), and then records their steps over one more cycle,
   whether the limit was met or not: c2d_get_cycle_state gives which. After each cycle the step callback is called with kind
   C2D_STEP_CYCLE, the number of the last step before the cycle and the results at the end of the cycle; c2d_save and
   c2d_restore there as at a recorded step.
   Part of the model: legal with c2d_add_path, with c2d_limits.cycle_states above 0. Errors: ARGUMENT also where the cycle does
   not close. */
enum {
  C2D_START_AS_LOADED = 0,        /* the cycles begin where the path has led                                            */
  C2D_START_WITHOUT_FRICTION = 1, /* up to the cycle bodies slide without friction, where it is bounded; then the pairs that
                                    touch stick. If that ends in another steady cycle, the state depends on how it began */
  C2D_START_COMPARED = 2          /* as loaded; the host compares it with a run of the same path without friction, as the
                                     program contact2d does */
};
c2d_status c2d_repeat_paths(c2d_solver* solver, int32_t pieces, int32_t limit, int32_t digits, int32_t start);
/* Which segments are repeated: the first, from 1 (0: none), how many; limit, digits and start. Legal as the lists of section 8. */
c2d_status c2d_get_repeated(c2d_solver* solver, int32_t* first, int32_t* pieces, int32_t* limit, int32_t* digits,
                            int32_t* start);
/* The cycles followed last, by c2d_cycle or c2d_run, also in its callback. */
c2d_status c2d_get_cycle_state(c2d_solver* solver, c2d_cycle_state* out);

/* Results of pairs first ... first+count-1 over the last whole cycle, until the next c2d_cycle or c2d_run; 0 of tied pairs. */
enum {
  C2D_CYCLE_RANGE = 0,  /* distance between the ends of the slip                              */
  C2D_CYCLE_WALK = 1,   /* motion (u2-u1).t from the beginning to the end                     */
  C2D_CYCLE_STUCK = 2,  /* 1: it stuck all the time                                           */
  C2D_CYCLE_TOUCHED = 3 /* 1: it was closed for some of the time                              */
};
c2d_status c2d_get_cycle(c2d_solver* solver, int32_t field, int32_t first, int32_t count, double* out, int64_t stride);
/* The same of a zone: the mean walk of the pairs that touched, weighted by their tributary lengths; the largest range; counts.
 */
typedef struct c2d_cycle_zone {
  uint32_t struct_size;
  int32_t touched, stuck, slipped;
  double walk, slip_range;
} c2d_cycle_zone;
c2d_status c2d_get_cycle_zone(c2d_solver* solver, int32_t zone, c2d_cycle_zone* out);

#ifdef __cplusplus
}
#endif
#endif
