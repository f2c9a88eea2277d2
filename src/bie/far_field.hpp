#pragma once
// What a group of elements does far away, METHOD (16.10): with w = P - c from the middle c of a circle that holds them, METHOD
// (16.2) and METHOD (16.3) summed over the group are two functions of w,
//   u / k = -(kappa/2) F + T/2 + conj(X) + w conj(F')/2         trace / k = -2 Re F'         deviator / k = w* F'' + 2 X'
//   F = T ln w + sum f_j (R/w)^j        X = -(kappa/2) T* ln w + sum x_j (R/w)^j
// where T is the group's force and R the circle's radius. Units and signs as in bie/integrals/interior.hpp. Outside of
// kFarDistance times the radius the series are as good as the integrals.
#include "bie/integrals/interior.hpp"

namespace c2d {

constexpr int kFarTerms = 30;
constexpr double kFarDistance = 3.0; // 3^-30 times the 30^2 of the second derivative is 4e-12

struct FarField {
  Complex middle;
  double radius; // 0: there is nothing in the group
  Complex force;
  Complex f[kFarTerms], x[kFarTerms]; // of the powers from 1 on
};

// Adds an element that lies in the circle, with `rest` taken off its displacements.
void add_to_far_field(const FieldElement& element, Complex rest, FarField& out);
// Adds a group whose circle lies in this one's. Material: kappa = 3 - 4 nu.
void add_to_far_field(const FarField& part, double kappa, FarField& out);
// Adds the group's share at (x, y), no nearer to its middle than kFarDistance times the radius. k = 1/(4 pi (1 - nu)).
void add_far_field(const FarField& group, double k, double kappa, double x, double y, PointField& sum);

// Its displacements alone.
Complex far_displacement(const FarField& group, double k, double kappa, double x, double y);

// Elements that follow each other, of which nothing but the two ends matters: `u` everywhere on them, no tractions, at a point
// that is not between them and the straight line through the ends.
struct Chain {
  Complex from, to;
};
void add_uniform_chain(const Chain& chain, Complex u, double k, double kappa, double x, double y, PointField& sum);

} // namespace c2d
