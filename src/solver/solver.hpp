#pragma once
// The solver's header in the workspace, and what all phases use of it.
#include "contact/path.hpp"
#include "contact2d.h"
#include "elimination/eliminate.hpp"
#include "memory/config.hpp"
#include "model/model.hpp"
#include "store/tapes.hpp"

// Stands at the first multiple of kAlignment in the caller's memory. Holds offsets, no addresses, but for the port, which
// c2d_attach gives anew: a workspace may be moved.
struct c2d_solver {
  uint64_t magic;
  uint32_t maker;                 // solver_maker() of the library that made it
  uint32_t slack;                 // bytes from the start of the caller's memory to this struct
  uint64_t bytes;                 // of workspace from this address on, whatever the alignment
  int32_t state;                  // C2D_STATE_...
  int32_t busy;                   // inside one of the caller's functions
  int32_t cancelled;              // by c2d_cancel; set_cancelled and is_cancelled alone touch it
  int16_t has_fault;              // `error` holds the first fault of the call that is running
  c2d::Instructions instructions; // of this processor: asking it takes as long as a small step of the path
  c2d::Sizes sizes;
  c2d::Layout layout;
  c2d_port port;
  c2d::Tapes tapes;
  c2d_error error;
  uint64_t saves; // number of the last c2d_save of this run
  // From here to the end of the arrays: what c2d_save keeps (solver/save.cpp).
  c2d::ModelHeader model;
  c2d_options options;
  // written by c2d_prepare
  int32_t blocked;          // nothing holds some motion: c2d_advance says so at once
  int8_t keeps_flexibility; // the phase area has room for F
  int8_t sliding;           // the contact system is that without friction (contact/frictionless.hpp)
  int8_t open;              // it is that with every pair open (contact/reduction/open_form.hpp)
  int8_t keeps_energy;      // this program has calls that tell energies (solver/energy/energy.hpp)
  int32_t warnings;
  int32_t factors;       // the tapes hold a factorisation of this model that new right-hand sides can go through
  int32_t loads_changed; // since they were last validated
  int32_t mean_motions;  // 1: those of the bodies are known as functionals (results/approach.cpp)
  int32_t rank_needed;   // by compressed elimination, where memory was too small; 0: not known
  double smallest_pivot, largest_pivot, pivot_growth, condition;
  double compression_residual, compression_error; // largest of the states that were looked at (solver/demand/compressed.cpp)
  uint64_t peak_bytes;
  double seconds[C2D_PHASES];
  // written by c2d_begin, c2d_advance
  int32_t floating; // nothing touches yet
  int32_t outcome, outcome_body, last_pair;
  int32_t may_rest, resting, delayed, awake; // of the tableau
  int32_t made;                              // columns on demand that are on the tape
  int32_t guided, good_guided;               // pair of the tableau, now and in the last good state
  int32_t back_substituted; // results outside the contact are those of the load reached: 1, or 1 + number of the
                            // body whose far cells (solver/demand/far_cells.hpp) lie in the work of back substitution
  int32_t table_is_current;
  int32_t coefficient;
  int32_t warned;           // bits: which warnings were given since c2d_begin
  int64_t judged_exchanges; // exchanges when the state was last judged
  int64_t built_exchanges;  // exchanges when the tableau was built; written by solver/judge.cpp, as what follows
  int32_t unsound;          // there is no tableau for the state kept: the path cannot go on
  int32_t careful;          // a new tableau after every change
  int32_t breach, good_floating;
  double breach_size, fresh_drift, peak_force, peak_terms[2], good_dissipated, good_least_dissipation;
  int64_t exchanges, rebuilds;
  uint64_t heading; // which load cases grow, which fall
  int64_t turns;    // of the path: a load case began, ended or turned
  c2d::PathStats stats;
  double stiffness, gap_scale, pressure_scale, max_residual, peak_pressure, mu;
  double dissipated, elastic, work, energy_size, energy_defect, least_dissipation; // solver/energy/energy.hpp
  double turn[3][3];                                                               // at its last turns, the last one first:
                                                                                   // work, elastic, dissipated
  double outcome_motion[3];                                                        // of outcome_body, as Body::free_motion
  double force_applied, force_contact, force_error, tension_ratio;
  int32_t idle, goes_on; // of the follower
  int32_t run_step;      // within c2d_run's callback, and where c2d_restore brings that back: the step it shows; within that of
                         // c2d_cycle: less the cycles followed; else 0
  c2d_outcome run_outcome; // of the coefficients before: the first that is not C2D_REACHED
};

namespace c2d {

constexpr int32_t kInStepCallback = 2; // of c2d_solver::busy: results may be looked at
constexpr uint64_t kSolverMagic = 0x6332645f73303031u;
// Tells apart libraries that would not understand each other's workspaces and saved states: version, size of the struct,
// stored scalar.
constexpr uint32_t solver_maker() {
  return ((C2D_VERSION_MAJOR * 100u + C2D_VERSION_MINOR) * 100u + C2D_VERSION_PATCH) * 65536u +
         static_cast<uint32_t>(sizeof(c2d_solver) / 8 * 16 + sizeof(Real));
}

// ---- errors and the caller's functions (solver/faults.cpp) -----------------------------------------------------------
c2d_error blank_error();
// Tell a fault, warning or note: through c2d_port.log, and keep the first fault of a call for c2d_last_error. In state
// broken the fault that broke the solver is kept instead.
void report_fault(c2d_solver* solver, const c2d_error& entry);
// Tell a fault of this call, at the place that c2d_set_line gave, and return its status.
c2d_status fail(c2d_solver* solver, c2d_status status, const char* text);
// The same with what stands in `entry` already, and without a place.
c2d_status fail_with(c2d_solver* solver, c2d_error& entry, c2d_status status, const char* text);
c2d_status fail_store(c2d_solver* solver, c2d_status status); // takes over tapes.error; the state becomes broken
bool is_store_error(c2d_status status);
const char* status_text(int32_t status); // words for any number (solver/messages.cpp)
const char* outcome_text(int32_t outcome);
bool asked_to_stop(c2d_solver* solver);
// c2d_solver::cancelled is set from other threads and by signals, and cleared by the call that tells it, by no other. A load
// and a store of a word are whole on every processor; nothing more is needed, and the smallest have no more.
inline void set_cancelled(c2d_solver* s, int32_t cancelled) { __atomic_store_n(&s->cancelled, cancelled, __ATOMIC_RELEASE); }
inline bool is_cancelled(const c2d_solver* s) { return __atomic_load_n(&s->cancelled, __ATOMIC_ACQUIRE) != 0; }
double clock_now(c2d_solver* solver);
// The work of back substitution serves something else, and holds no cells any more.
inline void take_back_work(c2d_solver* s) { s->back_substituted = s->back_substituted != 0 ? 1 : 0; }
void tell_progress(c2d_solver* solver, int32_t phase, int32_t body, int64_t done, int64_t total);

// ---- views (solver/views.cpp) ----------------------------------------------------------------------------------------
template <class T> T* array_of(c2d_solver* solver, int32_t id) {
  return reinterpret_cast<T*>(reinterpret_cast<char*>(solver) + solver->layout.offset[id]);
}
Model model_of(c2d_solver* solver);
Sizes sizes_of(c2d_solver* solver); // with their list of bodies
EliminationPlan& plan_of(c2d_solver* solver, int b);
BodyResults& results_of(c2d_solver* solver, int b);
bool is_coefficient(double value);                                       // of friction: zero or more, infinity included
double coefficient_of_zone(c2d_solver* solver, int32_t zone, int32_t i); // both from 0
double* zone_friction(c2d_solver* solver, int32_t i); // [zones] of the i-th run (from 0); negative: that for all

// Bodies of revolution are always eliminated densely.
inline bool is_compressed(const c2d_solver* s) {
  return !kSmallCode && s->options.elimination == C2D_ELIMINATION_COMPRESSED && s->model.plane != C2D_AXISYMMETRIC;
}

} // namespace c2d
