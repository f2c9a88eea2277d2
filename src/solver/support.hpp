#pragma once
// Which body the contact has to hold, and whether it can.
#include "contact/start.hpp"
#include "solver/solver.hpp"

namespace c2d {

// Sets solver->inverted, the body whose displacements are eliminated, and ->blocked: the body (from 1) that flies away
// whatever the contact does, 0: none.
void find_support(c2d_solver* solver, const Model& model);
// Which one of the free motions no pair resists, with the coefficients of friction that there are, whatever touches.
void find_slides(const Model& model, FreeBody& body);
// Add what is new of row[0 .. n) to an orthonormal basis of `rank` rows; 1 if there was something new.
int extend_basis(double basis[3][3], int rank, int n, double row[3]);

} // namespace c2d
