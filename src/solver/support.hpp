#pragma once
// Whether the contact can hold the bodies that supports do not.
#include "contact/start.hpp"
#include "solver/solver.hpp"

namespace c2d {

// Sets solver->blocked: the body (from 1) that flies away whatever the contact does, 0: none. Uses the phase area.
void find_support(c2d_solver* solver, const Model& model);
// Which one of the free motions no pair resists, with the coefficients of friction that there are, whatever touches.
void find_slides(const Model& model, FreeBody& body);
// Add what is new of row[0 .. n) to an orthonormal basis of `rank` rows; 1 if there was something new.
int extend_basis(double basis[3][3], int rank, int n, double row[3]);
// How much of a body's motions an orthonormal basis of what is prevented, rows of n numbers, leaves free.
double freedom(const Body& body, const double* basis, int32_t rank, int32_t n);

} // namespace c2d
