#pragma once
// Elements of a body in the units of its equations, and the length per which a traction on them is measured (METHOD 9.1).
#include "bie/integrals/integrals.hpp"
#include "model/model.hpp"

namespace c2d {

constexpr double kTurn = 6.28318530717958647692; // 2 pi

// On a contact element of side 1 tau is per length of side 0, any other traction on its own length. `section`: as in the plane,
// of bodies of revolution too.
enum class Measure { own_length, contact, section };
// An element of a body with its length unit applied, for tractions in this measure.
void make_integrator(const Model& model, int b, int32_t element, Quadrature quadrature, Measure measure, Integrator& out);

// Resultants of the shape functions at the ends of an element: force per unit of traction and first moments about the
// origin, in the length unit.
struct EndResultant {
  double w, wx, wy;
};
void end_resultants(const Model& model, int b, int32_t element, Measure measure, EndResultant out[kElementNodes]);
// Forces in the balances are in units of 2G and the unit of length per turn: resultants times this.
inline double balance_scale(const Model& m) { return is_axisymmetric(m) ? 1.0 / (kTurn * m.head->length_unit) : 1.0; }
// Ends of a body's elements at which tau of a pair acts; resultants of tau there, in its own measure.
struct ContactEnd {
  int32_t element = 0;
  int l = -1; // local node
  PairSide at = {-1, 0};
  EndResultant of_element[kElementNodes];
  const EndResultant& weight() const { return of_element[l]; }
};
// The next one, from the first on; false after the last one.
bool next_contact_end(const Model& model, int b, ContactEnd& end);
// Ratio J1/J2 at local node l of a contact element of side 1: true traction = tau * ratio; 1 elsewhere.
double traction_ratio(const Model& model, int b, int32_t element, int l);

} // namespace c2d
