#pragma once
// Body forces through particular solutions: u_p with stress sigma_p is in equilibrium with the body force of a load case. So u
// - u_p satisfies the equations without it, METHOD (6.1), and no integral over the area is needed.
//   weight     force per area (bx, by):        sigma_p,xx = sigma_p,yy = -(bx x + by y), sigma_p,xy = 0
//   rotation   rho omega^2 (x - x0, y - y0):   u_p = k r^2 (x - x0, y - y0), k = -rho omega^2 (1-2 nu) / (16 G (1-nu))
// with nu of the equivalent plane strain problem. For the weight x, y are measured from the body's centre, or from the lines
// of symmetry, so that u_p is as symmetric as the body force. Bodies of revolution: METHOD 21.6.
#include "model/model.hpp"

namespace c2d {

inline const BodyForce& body_force(const Model& m, int b, int32_t load_case) { return m.body_force[b][load_case]; }
inline bool is_loaded(const BodyForce& f) { return f.bx != 0.0 || f.by != 0.0 || f.rho_omega2 != 0.0; }
// Does any load case apply one to this body?
inline bool has_body_force(const Model& m, int b) { return m.body[b].has_force != 0; }

// In the caller's units, at factor 1.
struct Particular {
  double u[2];
  double stress[3]; // xx, yy, xy
};
// At the point (x, y) of the caller's coordinates; zero without a body force.
Particular particular_solution(const Model& m, int b, int32_t load_case, double x, double y);
// Tractions t_p of an element at its local functional node l.
void particular_traction(const Model& m, int b, int32_t load_case, int32_t element, int l, double t[2]);

// Force and moment about (x, y) of the body force at factor 1 on the modelled part of the body, of bodies of revolution the
// force along the axis. Exact: the integrals over the area are integrals of polynomials along the boundary.
void body_force_resultant(const Model& m, int b, int32_t load_case, double x, double y, double out[3]);

// Integral over the body of the body force of one load case times u_p of another, both at factor 1.
double body_force_work(const Model& m, int b, int32_t load_case, int32_t particular_case);

} // namespace c2d
