#pragma once
// From the reduced equations of the bodies to the contact system and its tableau (METHOD 10). With t = -tau on side 0 and +tau
// on side 1 of every pair and w' = u_1 - u_0 = w - (gap, 0):
//   bodies that keep their equations   S_u u = S_t t + sum_k lambda_k s_k,
//   the others                         u = F t + sum_k lambda_k v_k + R x,   0 = G^T t + sum_k lambda_k g_k,
//   or, of slender ones that float,    u = z + R x, z a part of x,           0 = S_t t - S_u z + sum_k lambda_k s_k,  R^T z =
//   0,
// the latter put into the former (contact/reduction/reduction_plan.hpp), and into w' of pairs between two of them, make
//   A tau + C x = B w' - sum_k lambda_k h_k,   0 = G^T tau + sum_k lambda_k g_k,
// x the motions of bodies that supports do not hold. Row i is the i-th equation of a body that keeps them, in the place of its
// i-th unknown, or the pair's own. The solution is the tableau with every pair sticking,
//   tau = T w' + sum_k lambda_k b_k,   x = X w' + sum_k lambda_k x_k.
// or, where supports hold enough, with every pair open, contact/reduction/open_form.hpp. Without friction it is that with every
// pair slipping, contact/frictionless.hpp: q and w_t of pairs that may change have changed places in tau and w', and columns of
// what is zero there, in F, A, T and X, are zero on the tape. The load case that closes overlaps has B (overlap, 0) taken off
// its h: at its factor 1 the gap is less by all of it.
#include "contact/contact_tape.hpp"
#include "contact/frictionless.hpp"
#include "linalg/lu.hpp"
#include "model/model.hpp"

namespace c2d {

// By how much round-off grows in the pressures, at most, where slender bodies are reduced (METHOD 10.2), and a body there.
struct RoundOff {
  double growth = 0.0;
  int body = -1; // there is none

  void note(double found, int b) {
    if (found <= growth) return;
    growth = found;
    body = b;
  }
};

struct Reduction {
  ContactTape tape;
  Model model;
  Real* first;          // (m + border)^2, border the motions, never fewer than those of x, and displacements that are unknowns
  Real* second;         // (m + border) * m
  Real* strip;          // strip_length * kStripColumns
  int32_t* pivots;      // m + border
  int64_t strip_length; // of a column of the strip: all contact unknowns of the model or of a body, and border
  void* watch_context;
  c2d_status (*tick)(void* context); // called between steps; anything but C2D_OK stops
  Engine engine;                     // of the dense kernels
  bool sliding = false;              // no pair that may change has friction, nor a body that slides freely
  bool open = true;                  // with every pair open instead, where that may be (contact/reduction/open_form.hpp)
  RoundOff* round_off = nullptr;     // noted there, if it is not null
};
constexpr int32_t kStripColumns = 4;

// Is a contact unknown, of the model or of a body, q of a pair that slides in this form?
inline bool slides(const Reduction& r, int32_t dof) { return !kSmallCode && r.sliding && is_sliding_slot(r.model, dof); }
inline bool slides(const Reduction& r, int b, int32_t own) {
  return !kSmallCode && r.sliding && is_sliding_slot(r.model, b, own);
}

// ---- optional, for rigid bodies (memory/parts.hpp, rigid_reduction.cpp) ----
// Motion of a rigid body at a pair: along n and t, in the length unit, at factor 1 of a load case.
void rigid_motion_at_pair(const Model& m, const Pair& pair, int side, int32_t load_case, double v[2]);
// v, and of the motions that are free R, G and g, of a rigid body.
c2d_status reduce_rigid(const Reduction& r, int b);

// Does the body keep its equations in this form?
inline bool keeps_equations(const Reduction& r, int b) { return keeps_equations(r.model, b) && (kSmallCode || !r.open); }

// Reads the matrices of the bodies, writes the others. Pairs whose normals do not hold the bodies, or hardly, stick, `sliding`
// or not; `open` where the model may have it and no body bends too much. C2D_ERR_SINGULAR if a pivot is unusable.
c2d_status reduce(const Reduction& r);
// On demand: of every load case what it makes of the pairs, from the responses of the bodies. No column of A is there yet.
c2d_status reduce_on_demand(const Reduction& r);
// After a reduction, when the columns s of the bodies have been replaced: everything that depends on them anew.
c2d_status reduce_loads(const Reduction& r);

} // namespace c2d
