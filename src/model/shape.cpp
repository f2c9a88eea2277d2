// Lagrange shape functions on equally spaced nodes, thesis (4.11): constant, linear, quadratic and cubic.
//
// N_l(eta_k) = 1 for l = k, else 0, and sum_l N_l = 1 (Brebbia, Telles and Wrobel, Boundary Element Techniques, 1984). The
// coefficients of powers of eta serve the closed-form integrals, which need moments of eta^k.
#include "model/shape.hpp"

namespace c2d {
namespace {

constexpr double kConstant[1][1] = {{1.0}};
constexpr double kLinear[2][2] = {{0.5, -0.5}, {0.5, 0.5}};
constexpr double kQuadratic[3][3] = {{0.0, -0.5, 0.5}, {1.0, 0.0, -1.0}, {0.0, 0.5, 0.5}};
constexpr double kCubic[4][4] = {{-1.0 / 16, 1.0 / 16, 9.0 / 16, -9.0 / 16},
                                 {9.0 / 16, -27.0 / 16, -9.0 / 16, 27.0 / 16},
                                 {9.0 / 16, 27.0 / 16, -9.0 / 16, -27.0 / 16},
                                 {-1.0 / 16, -1.0 / 16, 9.0 / 16, 9.0 / 16}};
static_assert(kElementNodes == 4, "another order needs values, derivatives, coefficients and a node_eta here");

} // namespace

// Product forms instead of Horner's rule with the coefficients: they vanish exactly (or to round-off) at the other nodes, so
// that a nodal value is reproduced without a share of its neighbours.
void shape(int nodes, double eta, double* N) {
  const double left = 1.0 - eta, right = 1.0 + eta;
  switch (nodes) {
  case 1: N[0] = 1.0; break;
  case 2:
    N[0] = 0.5 * left;
    N[1] = 0.5 * right;
    break;
  case 3:
    N[0] = -0.5 * eta * left;
    N[1] = left * right;
    N[2] = 0.5 * eta * right;
    break;
  default: {
    const double ends = left * right, minus = 1.0 - 3.0 * eta, plus = 1.0 + 3.0 * eta;
    N[0] = -minus * plus * left / 16.0;
    N[1] = 9.0 * ends * minus / 16.0;
    N[2] = 9.0 * ends * plus / 16.0;
    N[3] = -minus * plus * right / 16.0;
  }
  }
}

void shape_derivative(int nodes, double eta, double* dN) {
  switch (nodes) {
  case 1: dN[0] = 0.0; break;
  case 2:
    dN[0] = -0.5;
    dN[1] = 0.5;
    break;
  case 3:
    dN[0] = eta - 0.5;
    dN[1] = -2.0 * eta;
    dN[2] = eta + 0.5;
    break;
  default:
    for (int l = 0; l < 4; ++l) dN[l] = kCubic[l][1] + eta * (2.0 * kCubic[l][2] + 3.0 * eta * kCubic[l][3]);
  }
}

const double* shape_coefficients(int nodes, int l) {
  switch (nodes) {
  case 1: return kConstant[l];
  case 2: return kLinear[l];
  case 3: return kQuadratic[l];
  default: return kCubic[l];
  }
}

double node_eta(int nodes, int l) { return nodes == 1 ? 0.0 : (2.0 * l - (nodes - 1)) / (nodes - 1); }

} // namespace c2d
