#include "memory/math.hpp"
#include "model/geometry.hpp"
#include "model/validate/validate_finding.hpp"

namespace c2d {

void check_body_force(const Model& m, int b, int32_t load_case, Reporter& reporter) {
  const ModelHeader& head = *m.head;
  const BodyForce& f = m.body_force[b][load_case];
  const double weight[2] = {f.bx, f.by}, axis[2] = {f.x0, f.y0};
  for (int c = 0; c < 2; ++c) {
    // A body on the line is its own image: its force must be symmetric. A body off the line has an image with the mirrored
    // force. Bodies of revolution turn about their axis, wherever the point is on it.
    if ((m.body[b].lines >> c & 1) == 0) continue;
    const bool is_axis = c == 0 && is_axisymmetric(m), any = c == 1 && is_axisymmetric(m);
    const bool turns = f.rho_omega2 != 0.0 && !any && fabs(axis[c] - head.line_at[c]) > kCoincident * head.length_unit;
    if (weight[c] == 0.0 && !turns) continue;
    report(reporter, in_body(b), "the body force of body ", body_named(m, b), " in load case ", load_case + 1,
           turns ? " turns about a point off the " : " acts across the ", is_axis ? "axis " : "line of symmetry ",
           c == 0 ? "x = " : "y = ", head.line_at[c], turns ? ", expected an axis on it" : ", expected one along it");
  }
}

} // namespace c2d
