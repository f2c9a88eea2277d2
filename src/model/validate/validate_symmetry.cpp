// Entry to the optional part for lines of symmetry (model/validate/validate_lines.cpp). Programs without images do not link it;
// then open regions have no line on which they could end and are refused here.
#include "memory/parts.hpp"
#include "model/symmetry.hpp"
#include "model/validate/validate_finding.hpp"

namespace c2d {

C2D_USES(SymmetryPart);

namespace {

bool check_open_regions_allowed(const Model& m, Reporter& reporter) {
  bool allowed = true;
  for (int b = 0; b < m.head->bodies; ++b) {
    if (body_of(m, b).open_regions == 0) continue;
    allowed = false;
    report(reporter, in_body(b), "body ", body_named(m, b), " has ", body_of(m, b).geometry_nodes, " boundary points, ",
           body_of(m, b).open_regions,
           " more than closed curves have: open regions end on a line of symmetry, but none is defined");
  }
  return allowed;
}

// The axis x = 0 is a line in force, which prevents motions across it. What the equations of rings lack is refused.
void validate_axis(const Model& m, Reporter& reporter) {
  if ((m.head->symmetry_asked & 1) != 0)
    report(reporter, Where(), "a line of symmetry x = value in a model of bodies of revolution, expected y = value only");
  if (m.head->images != 0)
    report(reporter, Where(),
           "symmetry by images of elements in a model of bodies of revolution, expected no elements on the "
           "axis and C2D_SYMMETRY_DECK");
  m.head->symmetry |= 1;
  m.head->line_at[0] = 0.0;
}

} // namespace

bool validate_symmetry(const Model& m, Reporter& reporter) {
  const int32_t before = reporter.faults;
  m.head->symmetry = m.head->symmetry_asked;
  if (is_axisymmetric(m)) validate_axis(m, reporter);
  if (reporter.faults != before) return false;
  for (int b = 0; b < m.head->bodies; ++b) m.body[b].lines = 0;
  return m.head->symmetry == 0 && m.head->images == 0 ? check_open_regions_allowed(m, reporter)
                                                      : kSymmetryPart.validate_lines(m, reporter);
}

int32_t lines_of_element(const Model& m, int b, int32_t element) { return kSymmetryPart.lines_along(m, b, element); }
int32_t lines_of_node(const Model& m, int b, int32_t node) { return kSymmetryPart.lines_at_corner(m, b, node); }
bool do_lines_hold(const Model& m, int b, int32_t node, int component) {
  return kSymmetryPart.is_held_by_lines(m, b, node, component);
}
void fold_point(const ModelHeader& head, double p[2]) { kSymmetryPart.fold_across(head, p); }

} // namespace c2d
