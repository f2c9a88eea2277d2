// A cantilever with a force at its end.
#include "program/families/family.hpp"
#include "program/families/shapes.hpp"

#include <algorithm>
#include <cmath>

namespace families {
namespace {

ProblemModel build_cantilever(const Values& v) {
  const double L = v.number("L"), c = v.number("c"), P = v.number("P");
  const bool stress = v.word("plane") == "stress";
  const double E0 = v.number("E"), nu0 = v.number("nu");
  const double E = stress ? E0 : E0 / (1 - nu0 * nu0), nu = stress ? nu0 : nu0 / (1 - nu0);
  const double G = E / (2 * (1 + nu)), I = 2 * c * c * c / 3;
  const int n = v.count("n");
  // Deflection at the fixed end: none at its middle, where the axis is level.
  const auto exact = [=](Point at) {
    const double x = at.x, y = at.y;
    return std::array<double, 2>{{-P * x * x * y / (2 * E * I) - nu * P * y * y * y / (6 * E * I) +
                                      P * y * y * y / (6 * I * G) + (P * L * L / (2 * E * I) - P * c * c / (2 * I * G)) * y,
                                  nu * P * x * y * y / (2 * E * I) + P * x * x * x / (6 * E * I) - P * L * L * x / (2 * E * I) +
                                      P * L * L * L / (3 * E * I)}};
  };
  ProblemModel m;
  m.heading = {"A cantilever of length L and depth 2 c with a shear force P at its end x = 0.",
               "The force acts as a parabola; at x = L stand the displacements of beam theory's exact solution.",
               "sxx = -P x y / I, sxy = -P (c^2 - y^2) / (2 I), I = 2 c^3 / 3",
               "End displacement P L^3 / (3 E I), with E / (1 - nu^2) in plane strain: " + show(P * L * L * L / (3 * E * I)),
               "Reference: S. P. Timoshenko and J. N. Goodier, Theory of Elasticity, article 21"};
  m.title = "CANTILEVER";
  m.function_nodes = v.count("order") + 1;
  m.plane = stress ? 1 : 0;
  const int along = std::max(1, static_cast<int>(n * L / (2 * c) / 2 + 0.5));
  Outline beam({0, -c});
  beam.line({L, -c}, equal(L, along));
  beam.line({L, c}, equal(2 * c, n), displacement_field(exact));
  beam.line({0, c}, equal(L, along));
  beam.line({0, -c}, equal(2 * c, n), traction_field([=](Point at) {
              return std::array<double, 2>{{0.0, P * (c * c - at.y * at.y) / (2 * I)}};
            }));
  m.bodies = {{E0, nu0, {0, 0}, {beam}, "the beam"}};
  return m;
}

} // namespace

Family cantilever_family() {
  return {"cantilever",
          "a cantilever with a force at its end",
          {{"L", Kind::kPositive, "8", "length"},
           {"c", Kind::kPositive, "1", "half depth"},
           {"P", Kind::kNumber, "1", "force at the end, upwards"},
           {"E", Kind::kPositive, "1000", "Young's modulus"},
           {"nu", Kind::kPoisson, "0.3", "Poisson's ratio"},
           {"plane", Kind::kChoice, "strain", "strain|stress: plane strain or stress"},
           {"n", Kind::kCount, "4", "elements over the depth; along the beam they are twice as long"},
           {"order", Kind::kOrder, "2", "of the functions: 1 linear, 2 quadratic, 3 cubic"}},
          build_cantilever};
}

} // namespace families
