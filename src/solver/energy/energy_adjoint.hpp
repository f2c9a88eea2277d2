#pragma once
// One functional of the energy's books (solver/energy/energy.hpp) while it is put together: coefficients of tau, w' and lambda,
// and of each body's own unknowns, which the adjoint pass turns into those.
#include "solver/energy/energy.hpp"

namespace c2d {

struct Adjoint {
  Session* session;
  int b;             // the body at hand
  Real* tau;         // [m]
  Real* jump;        // [m] of w'
  double* lambda;    // [cases]
  Real* motion;      // of the motions x of all bodies that only the contact holds
  Real* u;           // of the body's contact displacements, Body::contact of them
  Real* outer;       // of its outer unknowns
  Real* coefficient; // of its trailing columns
  Real* side[2];     // [m] each, of the displacements on the sides of the pairs
  bool touched;      // outer is not all zero
  int32_t number;    // of the functional in the books: U of case 0, R of case 0, U of case 1, ...
  // Of each element of the body the first case after case 0 that prescribes values there, and the last one plus 1. Null: not
  // known.
  const Real* cases;
  const Model& model() const { return session->model; }
};

enum class TractionKind { contact, solved, given };
// `unknown`: of the end's node in the direction at hand, from unknowns_at.
TractionKind traction_kind(const Model& m, int b, int32_t element, int l, int component, const Unknown& unknown);

// Case 0 may prescribe a value, and cases from ... end - 1.
struct CaseSpan {
  int32_t from, end;
};
// A component in one unit: that of case k lies k * stride numbers behind that of case 0.
struct Prescribed {
  const double* value;
  int64_t stride;
  double unit;
};
Prescribed prescribed_displacement(const Model& m, int b, int32_t node, int c);
Prescribed prescribed_traction(const Model& m, int b, int32_t element, int l, int c);
// factor[i] times what load cases prescribe, into lambda[i] of each of `count` functionals.
void add_prescribed(const Prescribed& given, const CaseSpan& cases, int32_t count, const double* factor, double* const* lambda);
// Does load case k prescribe tractions, or displacements, of a body, or of an element, that are not zero?
bool prescribes(const Model& m, int b, int32_t k, bool displacements);
bool prescribes(const Model& m, int b, int32_t element, int32_t k, bool displacements);

void add_outer(Adjoint& a, int32_t column, double factor);
// factor times a displacement component, in the length unit.
void add_displacement(Adjoint& a, int32_t node, int c, const Unknown& unknown, double factor);
// factor times a traction component at an end, in 2 G of the body (a contact one in its own measure).
void add_traction(Adjoint& a, int32_t element, int l, int c, TractionKind kind, double factor);

// Tractions of case k times displacements, or reactions times prescribed displacements of case k.
void add_boundary(Adjoint& a, int32_t k, bool reactions);
// What point loads do on a body, for several functionals together: each force times the displacement there, from the boundary
// integrals (the interior form of the equations).
void add_point_loads(Adjoint* a, int32_t count);
// Of a point load's displacement: what the tractions do to it that free zones hand over to the body (optional:
// energy_free_zones.cpp).
void add_transferred_at(Adjoint& a, const double at[2], const double factor[2]);
// Moves what functionals f[i] have of the body's outer unknowns to its trailing columns, w[i], by its transposed factors.
// Errors: the block store's.
c2d_status solve_transposed(Session& session, int b, int32_t count, Real* const* f, Real* const* w,
                            const FunctionalTiles& tiles = {});
// ---- optional, for bodies with body forces (memory/parts.hpp, energy_body_force.cpp) ----
// The body force of case k times the displacements it moves through.
void add_body_force(Adjoint& a, int32_t k);
// Of a point load's displacement: the boundary integrals hold for u - u_p and t - t_p, and this is what the body forces' own
// part of an element takes off.
void take_particular(Adjoint& a, int32_t element, const Blocks& blocks, const double factor[2]);
// And what that part adds at the load itself.
void add_particular_at_load(Adjoint& a, const PointLoad& load, const double factor[2]);

// ---- optional, for rigid bodies (energy_rigid.cpp) ----
// Into a functional of tau: what holds the body against the contact, times its motion in case k.
void add_rigid_motion(const Model& m, int b, int32_t k, Real* tau);

} // namespace c2d
