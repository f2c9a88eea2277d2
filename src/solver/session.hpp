#pragma once
// A load path in progress: the tableau, the follower and their arrays, put together at every entry and put away after.
#include "bie/transfer.hpp"
#include "contact/path.hpp"
#include "contact/start.hpp"
#include "solver/model_hash.hpp"

namespace c2d {

struct Session {
  c2d_solver* solver;
  Model model;
  PathArea area;
  ContactTape tape;
  Tableau tableau;
  Follower follower;
  FreeBody free_body;
  bool may_stop; // loads move: a cancel leaves them where they are. What finds statuses at one load is not cut off
  // Of c2d_run: its callback, and what shows it a change of status, if it wants every one.
  c2d_step_fn step;
  void* step_context;
  c2d_step now;
  c2d_status (*show_change)(Session& session);
};

// The path area of a prepared model, with room for F or without; its bytes.
uint64_t open_path_area(c2d_solver* solver, const Model& model, bool flexibility, PathArea& out);
// Views into the workspace; nothing is computed. close_session keeps what must last.
void open_session(c2d_solver* solver, Session& session);
void close_session(Session& session);
// tau of a pair times a factor, in global components.
void pair_force(const Session& session, int32_t pair, double factor, double out[2]);
// How the body that the contact has to hold can move, with the coefficients of friction that the pairs have now.
void note_free_body(Session& session);
// F of all bodies, if the memory has room for it. Errors: the block store's.
c2d_status load_flexibility(Session& session);
// Where F of a body begins then; null: it is read from the tape.
const Real* flexibility_of(const Session& session, int b);

} // namespace c2d
