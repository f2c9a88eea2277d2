#pragma once
// From the reduced equations of both bodies to the contact system and its tableau (METHOD 10):
//   B w' - M tau = sum_k lambda_k h_k,  w' = w - (gap, 0),  B = S_u of the body that may float,
//   M = S_t + S_u F, and the tableau with every pair sticking, tau = T w' + sum_k lambda_k b_k.
// The load case that closes overlaps has B (overlap, 0) taken off its h: at its factor 1 the gap is less by all of it.
// Equilibrium is implicit: body 2 carries +tau, body 1 -tau.
#include "contact/contact_tape.hpp"
#include "linalg/lu.hpp"
#include "model/model.hpp"

namespace c2d {

struct Reduction {
  ContactTape tape;
  Model model;
  int32_t inverted; // 0 or 1: the supported body, whose S_u is inverted
  Real* first;      // m * m
  Real* second;     // m * m
  Real* strip;      // m * kStripColumns
  int32_t* pivots;  // m
  void* watch_context;
  c2d_status (*tick)(void* context); // called between steps; anything but C2D_OK stops
  Engine engine;                     // of the dense kernels
};
constexpr int32_t kStripColumns = 4;

// ---- optional, for a rigid body 1 (memory/parts.hpp, rigid_reduction.cpp) ----
// Its motion at a pair: along n and t, in the length unit, at factor 1 of a load case.
void rigid_motion_at_pair(const Model& m, const Pair& pair, int32_t load_case, double v[2]);
// v of the inverted body where that is the rigid one: its motion at the pairs.
c2d_status move_rigidly(const Reduction& r);

// Reads the six matrices of the bodies, writes the other six. C2D_ERR_SINGULAR if a pivot is unusable.
c2d_status reduce(const Reduction& r);
// After a reduction, when the columns s of the bodies have been replaced: everything that depends on them anew.
c2d_status reduce_loads(const Reduction& r);

} // namespace c2d
