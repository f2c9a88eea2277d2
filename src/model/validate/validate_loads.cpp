// Point loads, body forces, rigid bodies and load cases.
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "model/geometry.hpp"
#include "model/symmetry.hpp"
#include "model/validate/validate.hpp"
#include "model/validate/validate_finding.hpp"

namespace c2d {

C2D_USES(BodyForcePart);
C2D_USES(RigidPart);

namespace {

struct Nearest {
  int32_t element;
  double distance;
};

Nearest nearest_element(const Model& m, int b, double x, double y) {
  Nearest nearest = {-1, 0};
  for (int32_t e = 0; e < body_of(m, b).elements; ++e) {
    if (!is_integrated(m, b, e)) continue;
    const double distance = distance_to_element(m, b, e, x, y);
    if (nearest.element < 0 || distance < nearest.distance) nearest = Nearest{e, distance};
  }
  return nearest;
}

// Inside the outer curve (winding number 1) and in no hole (-1). A line of symmetry is no boundary of the complete body: a
// point on it is shifted slightly into the modelled part before the test.
bool inside_body(const Model& m, int b, double x, double y) {
  const ModelHeader& head = *m.head;
  const int32_t on = lines_through(head, x, y);
  if ((on & 1) != 0) x += 1e-7 * head.length_unit * head.line_side[0];
  if ((on & 2) != 0) y += 1e-7 * head.length_unit * head.line_side[1];
  int number = 0;
  for (int32_t r = 0; r < body_of(m, b).regions; ++r) number += winding_number(m, b, r, x, y);
  return number == 1;
}

void say_equivalent(Finding& f, const PointLoad& p, int32_t element, double length) {
  say(f, "; the equivalent uniform traction on element ", element + 1, " is (", p.fx / length, ", ", p.fy / length, ")");
}

// On a line of symmetry a load coincides with its image; components across the line would cancel.
bool acts_across_line(const Model& m, const PointLoad& p) {
  const int32_t on = lines_through(*m.head, p.x, p.y);
  return ((on & 1) != 0 && p.fx != 0.0) || ((on & 2) != 0 && p.fy != 0.0);
}

void check_point_load(const Model& m, int32_t i, Reporter& reporter) {
  const PointLoad& p = m.point_load[i];
  if (acts_across_line(m, p)) {
    Finding f(Where{p.line, p.body + 1, 0, 0, 0, 0});
    f.entry.column = p.line > 0 ? p.column : 0;
    say(f, "point load ", i + 1, " at (", p.x, ", ", p.y,
        ") on a symmetry line acts across it, expected a force along "
        "the line");
    return report(reporter, f);
  }
  const Nearest near = nearest_element(m, p.body, p.x, p.y);
  if (near.element < 0) return;
  const double length = element_length(m, p.body, near.element);
  const bool on_boundary = near.distance <= 1e-6 * length;
  const bool inside = inside_body(m, p.body, p.x, p.y);
  if (inside && near.distance >= length) return;
  Finding f(on_boundary || !inside ? 0 : int32_t{C2D_WARN_POINT_LOAD}, Where{p.line, p.body + 1, 0, 0, near.element + 1, 0});
  f.entry.column = p.line > 0 ? p.column : 0;
  say(f, "point load ", i + 1, " at (", p.x, ", ", p.y, ") ");
  if (on_boundary) {
    say(f, "lies on the boundary of body ", body_named(m, p.body), ", expected a point inside");
    say_equivalent(f, p, near.element, length);
  } else if (!inside) {
    say(f, "lies outside body ", body_named(m, p.body), ", at a distance of ", near.distance, " from element ",
        near.element + 1, ", expected a point inside");
  } else {
    say(f, "is ", near.distance, " away from element ", near.element + 1, ", less than its length ", length,
        ": part of the force is lost");
    say_equivalent(f, p, near.element, length);
  }
  report(reporter, f);
}

// Loads of a rigid body act on its free motions only.
bool loads_rigid(const Model& m, int b, const RigidMotion& motion) {
  for (int i = 0; i < 3; ++i)
    if ((m.body[b].free_rigidly & 1 << i) != 0 && motion.load[i] != 0) return true;
  return motion.ux != 0 || motion.uy != 0 || motion.rotation != 0;
}

// Does the load case load anything? New kinds of loads must be added here.
bool case_prescribes(const Model& m, int32_t k) {
  for (int32_t i = 0; i < m.head->point_loads; ++i)
    if (m.point_load[i].load_case == k && (m.point_load[i].fx != 0 || m.point_load[i].fy != 0)) return true;
  if (k + 1 == m.head->interference) return true;
  for (int b = 0; b < m.head->bodies; ++b) {
    if (is_rigid(m, b) && loads_rigid(m, b, m.rigid_motion[b][k])) return true;
    const BodyForce& f = m.body_force[b][k];
    if (f.bx != 0 || f.by != 0 || f.rho_omega2 != 0) return true;
    const int64_t nodes = 2 * static_cast<int64_t>(body_of(m, b).nodes);
    const int64_t ends = 2 * static_cast<int64_t>(body_of(m, b).elements) * m.head->function_nodes;
    for (int64_t i = 0; i < ends; ++i)
      if (m.end_traction[b][k * ends + i] != 0) return true;
    for (int64_t i = 0; i < nodes; ++i)
      if (m.node_disp[b][k * nodes + i] != 0) return true;
  }
  return false;
}

void check_cases(const Model& m, Reporter& reporter) {
  for (int32_t k = 0; k < m.head->load_cases && m.head->load_cases > 1; ++k) {
    if (case_prescribes(m, k)) continue;
    report(reporter, Where(), "load case ", k + 1,
           " loads nothing, expected a traction, a displacement, a point load or a body force that is not zero");
  }
}

} // namespace

bool validate_loads(const Model& m, Reporter& reporter) {
  const int32_t before = reporter.faults;
  for (int32_t i = 0; i < m.head->point_loads; ++i) check_point_load(m, i, reporter);
  for (int32_t k = 0; k < m.head->load_cases && has_body_forces(m); ++k)
    for (int b = 0; b < m.head->bodies; ++b) kBodyForcePart.check_body_force(m, b, k, reporter);
  for (int b = 0; b < m.head->bodies; ++b)
    if (is_rigid(m, b)) kRigidPart.check_rigid(m, b, reporter);
  check_cases(m, reporter);
  return reporter.faults == before;
}

} // namespace c2d
