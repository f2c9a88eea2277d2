// Boundary conditions: exactly one unknown per functional node and global component (model/unknowns.cpp).
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "model/geometry.hpp"
#include "model/symmetry.hpp"
#include "model/unknowns.hpp"
#include "model/validate/validate.hpp"
#include "model/validate/validate_finding.hpp"

namespace c2d {

C2D_USES(RigidPart);

namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr const char* kAxis[2] = {"x", "y"};

// "displacement free, traction at end 2 of element 3 prescribed, at end 1 of element 4 unknown"
void say_conditions(Finding& f, const Model& m, int b, int32_t node, int component) {
  const int32_t per_element = m.head->function_nodes;
  say(f, "displacement ", displacement_known(m, b, node, component) ? "prescribed" : "free");
  int32_t ends[2];
  const int count = ends_at_node(m, b, node, ends);
  for (int i = 0; i < count; ++i) {
    const int32_t element = ends[i] / per_element, local = ends[i] % per_element;
    const bool contact = pair_of_end(m, b, element, local).pair >= 0;
    const bool known = traction_known(m, b, ends[i], component);
    const bool given = (m.end_code[b][ends[i]] & kGiven) != 0;
    say(f, i == 0 ? ", traction at end " : ", at end ", local + 1, " of element ", element + 1, " ",
        contact  ? "of the contact"
        : !given ? "zero (no card)"
        : known  ? "prescribed"
                 : "unknown");
  }
}

void report_count(const Model& m, int b, int32_t node, int component, UnknownKind kind, Reporter& reporter) {
  Finding f(at_node(m, b, node));
  const int32_t pair = pair_of_node(m, b, node).pair;
  if (pair >= 0) f.entry.pair = pair + 1;
  say(f, "node ", node + 1, " of body ", body_named(m, b), " has ");
  say(f, kind == UnknownKind::none ? "no unknown in " : "more than one unknown in ", kAxis[component]);
  if (pair >= 0 && is_contact_component(m.pair[pair], component)) say(f, " besides those of contact pair ", pair + 1);
  say(f, ": ");
  say_conditions(f, m, b, node, component);
  say(f, "; expected exactly one unknown");
  report(reporter, f);
}

// Tractions prescribed at ends of contact pairs; one message names the first and their number.
void check_contact_ends(const Model& m, int b, Reporter& reporter) {
  const int32_t f = m.head->function_nodes, ends = body_of(m, b).elements * f;
  int32_t count = 0, first = 0;
  for (int32_t end = 0; end < ends; ++end) {
    if (pair_of_end(m, b, end / f, end % f).pair < 0) continue;
    bool loaded = false;
    for (int32_t k = 0; k < m.head->load_cases; ++k)
      for (int c = 0; c < 2; ++c) loaded = loaded || m.end_traction[b][2 * (static_cast<int64_t>(k) * ends + end) + c] != 0.0;
    if (loaded && count++ == 0) first = end;
  }
  if (count == 0) return;
  const int32_t element = first / f, local = first % f;
  Finding finding(at_node(m, b, functional_node(m, b, element, local)));
  ZonePlace place = {0, 0, 0};
  find_contact_element(m, b, element, &place);
  finding.entry.element = element + 1;
  finding.entry.zone = place.zone + 1;
  if (m.end_line[b][first] > 0) finding.entry.line = m.end_line[b][first];
  say(finding, "a traction is prescribed at end ", local + 1, " of element ", element + 1, " of body ", body_named(m, b),
      ", which belongs to contact zone ", zone_named(m, place.zone));
  if (count > 1) say(finding, ", the first of ", count, " such ends");
  say(finding, "; expected 0 where a contact pair determines the traction");
  report(reporter, finding);
}

// Corners of a body at which one traction is shared by both sides: number, and the sharpest one.
struct Corners {
  int32_t count, node, component;
  double angle;
};

void look_at_corner(const Model& m, int b, int32_t node, int component, const Unknown& unknown, Corners& corners) {
  const int32_t per_element = m.head->function_nodes;
  double n[2][2];
  int32_t element[2];
  for (int i = 0; i < 2; ++i) {
    element[i] = unknown.end[i] / per_element;
    outward_normal(m, b, element[i], node_eta(per_element, unknown.end[i] % per_element), n[i]);
  }
  const double angle = angle_between(n[0], n[1]) / kDegree;
  if (angle <= 1 || is_joint_of_arc(m, b, element[0], element[1])) return; // a joint of chords of an arc is no corner
  if (corners.count++ > 0 && angle <= corners.angle) return;
  corners.node = node;
  corners.component = component;
  corners.angle = angle;
}

void warn_corners(const Model& m, int b, const Corners& corners, Reporter& reporter) {
  if (corners.count == 0) return;
  Finding f(C2D_WARN_CORNER, at_node(m, b, corners.node));
  say(f, "node ", corners.node + 1, " of body ", body_named(m, b), " is a corner of ", corners.angle,
      " degrees whose displacement in ", kAxis[corners.component],
      " is prescribed: one unknown traction is used on both sides of the corner");
  if (corners.count > 1) say(f, "; the sharpest of ", corners.count, " such corners");
  report(reporter, f);
}

void check_double_node(const Model& m, int b, int32_t node, int component, Reporter& reporter) {
  const int32_t twin = twin_node(m, b, node);
  if (twin < 0 || is_second_twin(m, b, node)) return;
  if (!displacement_known(m, b, node, component) || !displacement_known(m, b, twin, component)) return;
  report(reporter, at_node(m, b, node), "both nodes ", node + 1, " and ", twin + 1, " of a double node of body ",
         body_named(m, b), " have a prescribed displacement in ", kAxis[component],
         ": two unknown tractions but one equation; expected it at one of the two nodes at most");
}

// Can any boundary point move along its normal, that is, can the body change its volume?
bool can_move_outward(const Model& m, int b) {
  const int32_t f = m.head->function_nodes;
  for (int32_t element = 0; element < body_of(m, b).elements; ++element) {
    if (!is_integrated(m, b, element)) continue;
    for (int l = 0; l < f; ++l) {
      double n[2];
      outward_normal(m, b, element, node_eta(f, l), n);
      const int32_t node = functional_node(m, b, element, l);
      for (int c = 0; c < 2; ++c)
        if (fabs(n[c]) > 1e-6 && !displacement_known(m, b, node, c) && !is_held_by_symmetry(m, b, node, c)) return true;
    }
  }
  return false;
}

// An incompressible body with prescribed normal displacement all round: a uniform pressure does no work on it, so the equations
// do not determine the pressure.
void check_pressure(const Model& m, int b, Reporter& reporter) {
  if (strain_poisson_ratio(m, b) < 0.5 - 1e-12 || can_move_outward(m, b)) return;
  report(reporter, at_element(m, b, 0), "body ", body_named(m, b),
         " is incompressible (plane strain, Poisson's ratio 0.5) and its displacement along the normal is ",
         "prescribed everywhere: nothing determines its pressure; expected a ratio below 0.5, or a free part of the boundary");
}

} // namespace

bool validate_conditions(const Model& m, bool frames, Reporter& reporter) {
  const int32_t before = reporter.faults;
  for (int b = 0; b < m.head->bodies; ++b) {
    if (is_rigid(m, b)) { // a rigid body has no equations
      if (frames) kRigidPart.check_rigid_zones(m, b, reporter);
      continue;
    }
    check_contact_ends(m, b, reporter);
    Corners corners{0, 0, 0, 0.0};
    for (int32_t node = 0; node < body_of(m, b).nodes; ++node) {
      if (!frames && pair_of_node(m, b, node).pair >= 0) continue;
      Unknown unknowns[2];
      unknowns_at(m, b, node, unknowns);
      for (int component = 0; component < 2; ++component) {
        const Unknown& unknown = unknowns[component];
        if (unknown.kind == UnknownKind::none || unknown.kind == UnknownKind::several)
          report_count(m, b, node, component, unknown.kind, reporter);
        if (unknown.kind == UnknownKind::shared_traction) look_at_corner(m, b, node, component, unknown, corners);
        check_double_node(m, b, node, component, reporter);
      }
    }
    if (frames) warn_corners(m, b, corners, reporter);
    if (frames) check_pressure(m, b, reporter);
  }
  return reporter.faults == before;
}

} // namespace c2d
