#pragma once
// Free rigid motions of a body that contact holds no longer (solver/energy/motion.cpp).
#include "solver/session.hpp"

namespace c2d {

// How the body solver->outcome_body starts to move when the contact cannot hold it: solver->outcome_motion. Optional, with the
// calls that tell it (memory/parts.hpp: energies).
void find_outcome_motion(Session& session, c2d_outcome outcome);

// What moves, and how many ways it may.
struct Motions {
  const Body& body;
  int b, count;
};

// Normal and tangential motion at a pair, by free motion.
void motion_rows(const Session& session, const Motions& motions, const Pair& pair, double normal[3], double tangential[3]);
double length_of(const double v[3], int n);
// Is there pressure; and may this pair have some, once there is?
bool is_pressed(const Session& session);
bool may_press(const Session& session, int32_t pair);
// Takes from v[0 .. n) its part along an orthonormal basis.
void remove_prevented(const double basis[3][3], int rank, int n, double v[3]);

// solver->outcome_motion, from numbers per free motion: those of `choice` if `found`, else the motion that pressed pairs
// allow (none: zero).
void keep_motion(Session& session, const Motions& motions, c2d_outcome outcome, bool found, double choice[3]);

} // namespace c2d
