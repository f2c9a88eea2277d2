#pragma once
// The load path from one target to the next, judged where it arrives.
#include "solver/session.hpp"

namespace c2d {

// What the follower of this session tells and asks.
PathWatch path_watch(Session& session);
// Zero load for coefficients that the pairs already hold. Errors: the block store's.
c2d_status begin_path(Session& session);
// Follow to target[cases]; sets solver->outcome and load. Errors: the watch's, the block store's.
c2d_status advance_path(Session& session, const double* target);
// Where a pair is open, what it slipped so far is no matter for the next time that it touches. With settled statuses.
void note_open_pairs(Session& session);
// Work of the loads along `direction` on a rigid motion of body b; *size: sum of its magnitudes.
double load_work(const Session& session, int b, const double* direction, const double motion[3], double* size);
// Of a floating body, to Model::load_work: of each load case that work, and the sum of the magnitudes of what it prescribes.
void find_load_work(const Session& session, int b);
constexpr double kNoPressure = 1e-9; // of the largest on the path; so with forces

} // namespace c2d
