#pragma once
// Energy along the path (METHOD 15). Every sum over a boundary is nodal: the integral of an end's shape function times traction
// times displacement, the measure in which the contact conditions hold node by node (a pair that is open carries no
// force, a closed one does not move along the normal), so that the contact exchanges energy by friction alone.
//   work of load case k      integral of lambda_k dU_k + R_k dlambda_k
//     U_k  its tractions, point and body forces times the displacements they move through; body forces by Betti with
//          the particular solution: int b.u = int (t.u_p - t_p.u) over the boundary + int b'.u_p, b' all body and
//          point forces
//     R_k  reactions times its prescribed displacements, pressures times the overlaps that it closes
//   dissipated               sum over pairs of W_i |q_i| |dw_t|, W_i = integral of the pair's shape functions along side 0
//   elastic                  half of all tractions times displacements
// U_k and R_k are linear in tau, w' = (u1 - u0) and lambda, which are linear between two events: the trapezoidal rule
// is exact. Their coefficients are found once, by adjoint passes over the tape, each for several of them.
// A point load's displacement is infinite where it acts: its own field counts at the distance of the body's size, in
// work and elastic energy alike.
#include "contact/basis.hpp"
#include "solver/session.hpp"

namespace c2d {

// Array kEnergy: per case work, U and R at the start of a step, U and R of the moment; then the functionals.
struct EnergyBook {
  int32_t m, cases;
  double* work;    // [cases] so far
  double *u0, *r0; // [cases] scratch
  double *u, *r;   // [cases] scratch
  // Functionals: U and R of case 0, of case 1, ...
  double* of_loads; // [cases] each: what multiplies lambda
  Real* of_contact; // [2 m] each: what multiplies tau, w'
};
EnergyBook energy_book(c2d_solver* solver);
double* work_by_case(c2d_solver* solver); // [cases] so far
// [zones] dissipated by slip in each zone so far, without what release() sets free; behind it [zones] of the good state, and
// then the judge's own numbers.
inline double* rubbed(c2d_solver* solver) { return array_of<double>(solver, kJudge); }

// All of this is optional (memory/parts.hpp): it is linked with the calls that tell energies, and kept where
// c2d_solver::keeps_energy says so; and with it the balance of forces and the motion of a body that contact cannot hold.
// On demand: solutions x side by side, `count` numbers for each unknown of a body outside the contact, for tractions of 1 at
// these contact unknowns of the model on these sides. What they bring to the functionals is added.
struct DemandedColumns {
  int32_t count;
  const int32_t *dof, *side;
  const Real* x;
};
void add_demanded(Session& session, int b, const DemandedColumns& columns);
// Then, of a column of A: what the motions that go with it bring, by which nothing moves in the slots that hold them.
void hold_demanded(Session& session, const Form& form, int32_t dof, const Real* column);
// Functionals, after the reduction; uses the path area. Errors: the block store's.
c2d_status build_energy(c2d_solver* solver);
// Nothing has been done yet. Part of begin_path.
void begin_energy(c2d_solver* solver);
// The path goes on to `target`; where a load case begins, ends or turns by that, energies are noted as they stand.
void note_turn(Session& session, const double* target);
// `part` of the follower's direction is about to be gone, from its present y along its dy.
void add_segment(Session& session, double part);
// The same for a step whose inside is not known (deck stepping): before, and after it.
void before_jump(Session& session);
void after_jump(Session& session);
// The same for a state that jumps at one load, as friction without bound lets go: what the loads do on the way and what elastic
// energy is set free is dissipated.
void release(Session& session);
// Elastic energy and the balance of the state reached.
void close_balance(Session& session);

} // namespace c2d
