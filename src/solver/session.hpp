#pragma once
// A load path in progress: the tableau, the follower and their arrays, put together at every entry and put away after.
#include "bie/transfer.hpp"
#include "contact/path.hpp"
#include "contact/start.hpp"
#include "solver/phases.hpp"
#include "solver/solver.hpp"

namespace c2d {

struct Session {
  c2d_solver* solver;
  Model model;
  PathArea area;
  ContactTape tape;
  Tableau tableau;
  Follower follower;
  FreeBody free_body;
  // c2d_run's callback, if it wants every change
  c2d_step_fn step;
  void* step_context;
  c2d_step now;
};

// Views into the workspace; nothing is computed. close_session keeps what must last.
void open_session(c2d_solver* solver, Session& session);
void close_session(Session& session);

// F of the inverted body, if the memory has room for it. Errors: the block store's.
c2d_status load_flexibility(Session& session);
// Zero load for coefficients that the pairs already hold. Errors: the block store's.
c2d_status begin_path(Session& session);
// Follow to target[cases]; sets solver->outcome and load.
c2d_status advance_path(Session& session, const double* target);
// Displacements of both bodies at the pairs, and the result table. Errors: the block store's.
c2d_status fill_table(Session& session);
// Zone, normals and positions, which do not change.
void fill_positions(const Model& model, double* table);
// Traction that free zones hand over to body 1 at an end of an element; zero elsewhere and on body 2 (solver/back.cpp).
void transferred_traction(const Session& session, int b, int32_t element, int l, double out[2]);
// Tells c2d_run's callback that a status changed. Optional (memory/optional.hpp): part of c2d_run.
c2d_status show_change(Session& session);
// Work of the loads along `direction` on a rigid motion of the free body; *size: sum of its magnitudes.
double load_work(const Session& session, const double* direction, const double motion[3], double* size);
constexpr double kNoPressure = 1e-9; // of the largest on the path; so with forces
// How the free body starts to move when the contact cannot hold it: solver->outcome_motion (solver/motion.cpp). Returns
// the outcome; where nothing is pressed the motion decides whether that is sliding or free motion.
c2d_outcome find_outcome_motion(Session& session, c2d_outcome outcome);
// Results of the whole boundary in the caller's units (solver/back.cpp): read and written here alone.
void get_displacement(const Session& session, int b, int32_t node, double u[2]);
void get_traction(const Session& session, int b, int32_t end, double t[2]);
void keep_displacement(const Session& session, int b, int32_t node, const double u[2]);
void keep_traction(const Session& session, int b, int32_t end, const double t[2]);
// Everything outside the contact, force balance (METHOD 16). Errors: the block store's.
c2d_status back_substitute_all(Session& session);
// Forces on both bodies; the contact's equals what is applied, on the body that the contact has to hold. Optional, with
// the calls that tell it (solver/energy.hpp).
void balance_forces(Session& session);

PhaseSizes model_sizes(const Model& model);
// Everything that decides the numbers on the tapes (solver/prepare.cpp).
uint64_t hash_model(const Model& model, const c2d_options& options);
void warn_condition(c2d_solver* solver);
bool is_store_error(c2d_status status);
// Add what is new of row[0 .. n) to an orthonormal basis of `rank` rows; 1 if there was something new.
int extend_basis(double basis[3][3], int rank, int n, double row[3]);

// Warnings about the contact as it stands (solver/warnings.cpp). At the end of a path a contact of few elements means a coarse
// mesh and not a beginning.
enum class Moment { between, end, peak }; // of a path; at its peak the loads are largest
void warn_contact(Session& session, Moment moment);
// Strains that are not small, after back substitution.
void warn_strains(Session& session);
// Where a pair is open, what it slipped so far is no matter for the next time that it touches. With settled statuses.
void note_open_pairs(Session& session);
// Smallest pressure inside the contact elements over the largest nodal one, as it stands; 0 if none is negative.
double tension_ratio(const Session& session);

} // namespace c2d
