// Lines of symmetry: given, or detected among the elements; and whether the model fits them (METHOD 5).
//
// Phases: find lines whose elements carry the conditions of symmetry, if none is given; move points within 1e-9 of a line onto
// it, so that later tests are exact; check that everything lies on one side; record the lines that each body meets; check
// elements, nodes and open regions on the lines.
#include "memory/math.hpp"
#include "model/geometry.hpp"
#include "model/symmetry.hpp"
#include "model/unknowns.hpp"
#include "model/validate/validate_finding.hpp"

namespace c2d {

namespace {

constexpr double kOnLine = 1e-9; // of the unit of length: points closer than this lie on the line
constexpr const char* kAxis[2] = {"x", "y"};

// x = 0 is the axis of bodies of revolution, which their equations contain; every other line is one of symmetry.
bool is_axis(const Model& m, int axis) { return axis == 0 && is_axisymmetric(m); }
const char* kind_of_line(const Model& m, int axis) { return is_axis(m, axis) ? "axis " : "line of symmetry "; }

bool is_near(const Model& m, double coordinate, double line) {
  return fabs(coordinate - line) <= kOnLine * m.head->length_unit;
}

bool lies_on(const Model& m, int b, int32_t element, int axis, double line) {
  for (int k = 0; k < body_of(m, b).element_nodes; ++k)
    if (!is_near(m, m.xy[b][2 * geometry_node(m, b, element, k) + axis], line)) return false;
  return true;
}

// ---- elements on a line
// -------------------------------------------------------------------------------------------

bool is_prescribed_zero(const double* values, int64_t place, int64_t places, int c, int32_t cases) {
  for (int64_t k = 0; k < cases; ++k)
    if (values[(k * places + place) * 2 + c] != 0.0) return false;
  return true;
}

// Why an element on the line does not have the conditions of symmetry, or null if it has: zero displacement across the line
// (component `axis`) and zero traction along it, at every end.
const char* fault_of_axis_element(const Model& m, int b, int32_t element, int axis) {
  const int32_t f = m.head->function_nodes, cases = m.head->load_cases;
  const Body& body = body_of(m, b);
  ZonePlace at;
  if (find_contact_element(m, b, element, &at)) return "is in a contact zone";
  if (is_zero_length(m, b, element)) return nullptr;
  for (int l = 0; l < f; ++l) {
    const int32_t end = element * f + l, node = functional_node(m, b, element, l);
    if (!displacement_known(m, b, node, axis) || !is_prescribed_zero(m.node_disp[b], node, body.nodes, axis, cases))
      return axis == 0 ? "has a ux that is not prescribed as 0" : "has a uy that is not prescribed as 0";
    const int64_t ends = static_cast<int64_t>(body.elements) * f;
    if (!traction_known(m, b, end, 1 - axis) || !is_prescribed_zero(m.end_traction[b], end, ends, 1 - axis, cases))
      return axis == 0 ? "has a ty that is not prescribed as 0" : "has a tx that is not prescribed as 0";
  }
  return nullptr;
}

// Elements on a line: how many have the conditions of symmetry, and the first that does not.
struct LineElements {
  bool on_every_body;
  int32_t fitting;
  int body;
  int32_t element; // -1: all fit
  const char* why;
};
LineElements elements_on_line(const Model& m, int axis, double line) {
  LineElements found = {true, 0, 0, -1, nullptr};
  for (int b = 0; b < m.head->bodies; ++b) {
    bool any = is_platen(m, b);
    for (int32_t e = 0; e < body_of(m, b).elements; ++e) {
      if (!lies_on(m, b, e, axis, line)) continue;
      any = true;
      const char* why = fault_of_axis_element(m, b, e, axis);
      if (why == nullptr)
        ++found.fitting;
      else if (found.element < 0)
        found.body = b, found.element = e, found.why = why;
    }
    found.on_every_body = found.on_every_body && any;
  }
  return found;
}

void report_axis_element(const Model& m, const LineElements& found, int axis, double line, Reporter& reporter) {
  report(reporter, at_element(m, found.body, found.element), "element ", found.element + 1, " of body ",
         body_named(m, found.body), " on the line ", kAxis[axis], " = ", line, " ", found.why,
         ": expected zero displacement across a line of symmetry and zero traction along it");
}

// Detects lines that bound the model and have elements of every body, all with the conditions of symmetry; of two parallel ones
// the lower. If none qualifies, the message names the element that fails on the line with the most matching elements.
bool find_lines(const Model& m, Reporter& reporter) {
  LineElements nearest = {false, 0, 0, -1, nullptr};
  int nearest_axis = 0;
  double nearest_line = 0;
  for (int axis = 0; axis < 2; ++axis) {
    for (int upper = 0; upper < 2 && (m.head->symmetry >> axis & 1) == 0; ++upper) {
      double line = m.xy[0][axis];
      for (int b = 0; b < m.head->bodies; ++b) {
        const Box box = box_of_body(m, b);
        const double low = axis == 0 ? box.x_min : box.y_min, high = axis == 0 ? box.x_max : box.y_max;
        line = upper != 0 ? fmax(line, high) : fmin(line, low);
      }
      const LineElements found = elements_on_line(m, axis, line);
      if (found.on_every_body && found.element < 0 && found.fitting > 0) {
        m.head->symmetry |= 1 << axis;
        m.head->line_at[axis] = line;
      } else if (found.on_every_body && found.element >= 0 && found.fitting >= nearest.fitting) {
        nearest = found;
        nearest_axis = axis;
        nearest_line = line;
      }
    }
  }
  if (m.head->symmetry != 0) return true;
  if (nearest.element >= 0) {
    report_axis_element(m, nearest, nearest_axis, nearest_line, reporter);
    return false;
  }
  report(reporter, Where(),
         "no line of symmetry: expected elements of every body on one line x = value or y = value, with zero "
         "displacement across and zero traction along it");
  return false;
}

// ---- points
// -------------------------------------------------------------------------------------------------------

// The side of the line on which the model lies: that of the farthest point. Points beyond are reported by check_side.
double side_of_model(const Model& m, int axis) {
  if (is_axis(m, axis)) return 1; // r >= 0
  double low = 0, high = 0;
  for (int b = 0; b < m.head->bodies; ++b) {
    const Box box = box_of_body(m, b);
    low = fmin(low, (axis == 0 ? box.x_min : box.y_min) - m.head->line_at[axis]);
    high = fmax(high, (axis == 0 ? box.x_max : box.y_max) - m.head->line_at[axis]);
  }
  return high >= -low ? 1 : -1;
}

void move_onto(const Model& m, int axis) {
  const double line = m.head->line_at[axis];
  for (int b = 0; b < m.head->bodies; ++b)
    for (int32_t i = 0; i < body_of(m, b).geometry_nodes; ++i)
      if (is_near(m, m.xy[b][2 * i + axis], line)) m.xy[b][2 * i + axis] = line;
  for (int32_t i = 0; i < m.head->point_loads; ++i) {
    double& at = axis == 0 ? m.point_load[i].x : m.point_load[i].y;
    if (is_near(m, at, line)) at = line;
  }
}

void check_side(const Model& m, int b, int axis, Reporter& reporter) {
  const double side = m.head->line_side[axis], line = m.head->line_at[axis];
  for (int32_t e = 0; e < body_of(m, b).elements; ++e) {
    if (is_axis_element(m, b, e)) continue;
    Chords c;
    chords_of(m, b, e, c);
    for (int i = 0; i <= c.count; ++i) {
      if (side * ((axis == 0 ? c.x[i] : c.y[i]) - line) >= -kOnLine * m.head->length_unit) continue;
      return report(reporter, at_element(m, b, e), "element ", e + 1, " of body ", body_named(m, b), " lies beyond the ",
                    kind_of_line(m, axis), kAxis[axis], " = ", line,
                    is_axis(m, axis) ? ", expected a half section at x >= 0" : ", expected everything on one side of it");
    }
  }
}

// ---- curves
// -------------------------------------------------------------------------------------------------------

int32_t lines_at_point(const Model& m, int b, int32_t point) {
  return lines_through(*m.head, m.xy[b][2 * point], m.xy[b][2 * point + 1]);
}

void report_point(const Model& m, int b, int32_t point, const char* found, Reporter& reporter) {
  report(reporter, at_point(m, b, point), "boundary point ", point + 1, " of body ", body_named(m, b), " at (",
         m.xy[b][2 * point], ", ", m.xy[b][2 * point + 1], ") ", found);
}

// Only ends of open regions and points next to axis elements may lie on a line, and no point at the crossing of both lines.
void check_element(const Model& m, int b, int32_t element, Reporter& reporter) {
  const int last = body_of(m, b).element_nodes - 1;
  for (int k = 0; k <= last; ++k) {
    const int32_t point = geometry_node(m, b, element, k), lines = lines_at_point(m, b, point);
    if (lines == 0) continue;
    const int32_t after = k == last ? element_after(m, b, element) : -1;
    if (lines == 3)
      report_point(m, b, point, "lies at the crossing of the lines of symmetry, where no boundary can be", reporter);
    else if ((k > 0 && k < last) || (after >= 0 && !is_axis_element(m, b, after)))
      report_point(m, b, point,
                   is_axis(m, (lines & 1) != 0 ? 0 : 1)
                       ? "touches the axis x = 0, expected that only at the ends of an open region"
                       : "touches a line of symmetry, expected that only at the ends of an open region",
                   reporter);
  }
}

void check_open_region(const Model& m, int b, const Region& r, Reporter& reporter) {
  const int32_t ends[2] = {geometry_node(m, b, r.first, 0), geometry_node(m, b, r.last, body_of(m, b).element_nodes - 1)};
  for (int32_t point : ends)
    if (lines_at_point(m, b, point) == 0)
      report_point(m, b, point,
                   is_axisymmetric(m) ? "ends an open region, expected it on the axis x = 0 or a line of symmetry"
                                      : "ends an open region, expected it on a line of symmetry",
                   reporter);
}

// A platen has no mesh of its own: it meets the lines that its elements meet.
int32_t lines_of_platen(const Model& m, int b) {
  const Zone& z = tie_of_platen(m, b);
  int32_t lines = 0;
  for (int32_t k = 0; k < z.elements; ++k)
    for (int i = 0; i < body_of(m, z.body[1]).element_nodes; ++i)
      lines |= lines_at_point(m, z.body[1], geometry_node(m, z.body[1], zone_element(m, z, 1, k), i));
  return lines;
}

// A body without a point on a line lies on one side of it, and its image is a separate body. A line that no body meets would
// have no effect and is reported. The axis prevents motions across it of rings too.
void find_lines_met(const Model& m, Reporter& reporter) {
  const int32_t axis_of_all = is_axisymmetric(m) ? 1 : 0;
  int32_t met = axis_of_all;
  for (int b = 0; b < m.head->bodies; ++b) {
    int32_t lines = axis_of_all;
    for (int32_t i = 0; i < body_of(m, b).geometry_nodes; ++i) lines |= lines_at_point(m, b, i);
    if (is_platen(m, b)) lines = axis_of_all | lines_of_platen(m, b);
    m.body[b].lines = static_cast<int8_t>(lines);
    met |= lines;
  }
  for (int axis = 0; axis < 2; ++axis)
    if ((m.head->symmetry & ~met & 1 << axis) != 0)
      report(reporter, Where(), "the line of symmetry ", kAxis[axis], " = ", m.head->line_at[axis],
             " meets no body, expected an open region that ends on it");
}

void check_axis_elements(const Model& m, int b, Reporter& reporter) {
  for (int32_t e = 0; e < body_of(m, b).elements; ++e) {
    const int32_t lines = lines_along(m, b, e);
    if (lines == 0) continue;
    const int axis = (lines & 1) != 0 ? 0 : 1;
    const char* why = m.head->images ? fault_of_axis_element(m, b, e, axis) : "is one too many";
    if (why == nullptr) continue;
    if (m.head->images) {
      report_axis_element(m, LineElements{true, 0, b, e, why}, axis, m.head->line_at[axis], reporter);
      continue;
    }
    return report(reporter, at_element(m, b, e), "element ", e + 1, " of body ", body_named(m, b), " lies on the ",
                  kind_of_line(m, axis), kAxis[axis], " = ", m.head->line_at[axis],
                  ", expected no elements there: leave them out", is_axisymmetric(m) ? "" : ", or choose symmetry by images");
  }
}

void check_held_nodes(const Model& m, int b, Reporter& reporter) {
  const Body& body = body_of(m, b);
  for (int32_t node = 0; node < body.nodes; ++node)
    for (int c = 0; c < 2; ++c) {
      if ((lines_at_node(m, b, node) >> c & 1) == 0 ||
          is_prescribed_zero(m.node_disp[b], node, body.nodes, c, m.head->load_cases))
        continue;
      report(reporter, at_node(m, b, node), "node ", node + 1, " of body ", body_named(m, b), " lies on the ",
             kind_of_line(m, c), kAxis[c], " = ", m.head->line_at[c], " and has a prescribed u", kAxis[c], " that is not 0");
    }
}

} // namespace

bool validate_lines(const Model& m, Reporter& reporter) {
  const int32_t before = reporter.faults;
  if (m.head->symmetry == 0 && !find_lines(m, reporter)) return false;
  for (int axis = 0; axis < 2; ++axis) {
    if ((m.head->symmetry >> axis & 1) == 0) continue;
    move_onto(m, axis);
    m.head->line_side[axis] = side_of_model(m, axis);
  }
  find_lines_met(m, reporter);
  for (int axis = 0; axis < 2; ++axis)
    for (int b = 0; b < m.head->bodies && (m.head->symmetry >> axis & 1) != 0; ++b) check_side(m, b, axis, reporter);
  if (reporter.faults != before) return false;
  for (int b = 0; b < m.head->bodies; ++b) {
    check_axis_elements(m, b, reporter);
    check_held_nodes(m, b, reporter);
    for (int32_t r = 0; r < body_of(m, b).open_regions; ++r) check_open_region(m, b, m.region[b][r], reporter);
    for (int32_t e = 0; e < body_of(m, b).elements; ++e)
      if (!is_axis_element(m, b, e)) check_element(m, b, e, reporter);
  }
  return reporter.faults == before;
}

// ---- queries of other files ----

int32_t lines_along(const Model& m, int b, int32_t element) {
  int32_t lines = m.body[b].lines;
  for (int k = 0; k < body_of(m, b).element_nodes && lines != 0; ++k) {
    const double* p = m.xy[b] + 2 * geometry_node(m, b, element, k);
    lines &= lines_through(*m.head, p[0], p[1]);
  }
  return lines;
}

int32_t lines_at_corner(const Model& m, int b, int32_t node) {
  const int32_t corner = corner_point(m, b, node);
  if (corner < 0) return 0; // inside an element: not on a line, or on an axis element
  return lines_through(*m.head, m.xy[b][2 * corner], m.xy[b][2 * corner + 1]);
}

bool is_held_by_lines(const Model& m, int b, int32_t node, int component) {
  if ((lines_at_corner(m, b, node) >> component & 1) != 0) return true;
  int32_t ends[2];
  return twin_node(m, b, node) < 0 && ends_at_node(m, b, node, ends) == 0;
}

void fold_across(const ModelHeader& head, double p[2]) {
  for (int c = 0; c < 2; ++c) {
    if ((head.symmetry >> c & 1) == 0) continue;
    if (head.line_side[c] * (p[c] - head.line_at[c]) < 0.0) p[c] = 2.0 * head.line_at[c] - p[c];
  }
}

} // namespace c2d
