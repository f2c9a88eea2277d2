#pragma once
// Shape functions, thesis (4.11): Lagrange polynomials on equally spaced nodes including the ends.

namespace c2d {

// Local nodes of an element, geometry or functional, at most. Every array over them has this length.
constexpr int kElementNodes = 4;

// Values N[0..nodes-1] at eta in [-1,1]; nodes = 1 (constant), 2, 3 or 4.
void shape(int nodes, double eta, double* N);

// Derivatives dN/deta, same arguments.
void shape_derivative(int nodes, double eta, double* dN);

// Coefficients of N_l = sum_k c[k] eta^k, k = 0..nodes-1, for local node l = 0..nodes-1.
const double* shape_coefficients(int nodes, int l);

// Intrinsic coordinate of local node l = 0..nodes-1; the only node of a constant element is at 0.
double node_eta(int nodes, int l);

} // namespace c2d
