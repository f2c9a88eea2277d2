#pragma once
// One elastic body by boundary elements, written down once more and as plainly as can be: every integral by cutting the
// element towards the point until Gauss's rule is exact, the whole matrix in memory. Shares nothing with the library but
// the equations: displacements and tractions at functional nodes, three balance rows and three motions as multipliers.
#include "../problem.hpp"

#include <vector>

namespace random_decks {

using Matrix = std::vector<std::vector<double>>;

// Rows of H u - G t - (rho + omega e_z x r) = 0 at every node, then the sums of forces and moment of t. Columns: u of the
// nodes (x, y), t of the element ends (x, y), rho_x, rho_y, omega. Bodies without holes.
struct Equations {
  int32_t nodes = 0, ends = 0;
  Matrix rows;
  size_t u(int32_t node, int c) const { return static_cast<size_t>(2 * node + c); }
  size_t t(int32_t end, int c) const { return static_cast<size_t>(2 * (nodes + end) + c); }
  size_t motion(int k) const { return static_cast<size_t>(2 * (nodes + ends) + k); }
  size_t columns() const { return motion(3); }
};
Equations equations_of(const problem::Problem& problem, int32_t body);

// Node (from 0) of an element's end in a body of closed regions.
int32_t node_of_end(const problem::Problem& problem, const problem::Body& body, int32_t element, int32_t local);

// Gauss elimination with complete pivoting of the square system a x = b (many right-hand sides, changed); false: singular
// to `least` of the largest pivot.
bool solve_dense(Matrix a, Matrix& b, double least, double* smallest = nullptr);

} // namespace random_decks
