#pragma once
// Far field of a group of elements, METHOD (16.10): with w = P - c from the centre c of a circle that contains them, METHOD
// (16.2) and METHOD (16.3) summed over the group depend on two functions of w,
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
  double radius; // 0: the group is empty
  Complex force;
  Complex f[kFarTerms], x[kFarTerms]; // of the powers from 1 on
};

// Adds an element inside the circle, with `rest` subtracted from its displacements.
void add_to_far_field(const FieldElement& element, Complex rest, FarField& out);
// Adds a group whose circle is inside this one. Material: kappa = 3 - 4 nu.
void add_to_far_field(const FarField& part, double kappa, FarField& out);
// Adds the group's field at (x, y), which is at least kFarDistance times the radius from its centre. k = 1/(4 pi (1 - nu)).
void add_far_field(const FarField& group, double k, double kappa, double x, double y, PointField& sum);

// Its displacement alone.
Complex far_displacement(const FarField& group, double k, double kappa, double x, double y);

// Consecutive elements of which only the two ends matter: `u` is uniform on them, there are no tractions, and the point is not
// between them and the straight line through the ends.
struct Chain {
  Complex from, to;
};
void add_uniform_chain(const Chain& chain, Complex u, double k, double kappa, double x, double y, PointField& sum);

} // namespace c2d
