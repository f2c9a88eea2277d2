#pragma once
// Symmetry by images (METHOD 5): the lines across which bodies, loads and results are mirrored. Only one half of a body that
// meets a line is modelled; its curves end on the line, or the elements on the line (axis elements) are ignored. The image of a
// body that does not meet the line is a separate body and does not enter its equations.
#include "model/model.hpp"
#include "model/validate/validate.hpp"

namespace c2d {

// Lines through a point, bit 1: x = line_at[0], bit 2: y = line_at[1]. Exact: points near a line are moved
// onto it when the model is completed.
inline int32_t lines_through(const ModelHeader& head, double x, double y) {
  return ((head.symmetry & 1) != 0 && x == head.line_at[0] ? 1 : 0) |
         ((head.symmetry & 2) != 0 && y == head.line_at[1] ? 2 : 0);
}
// Lines on which all points of an element lie; on which a node lies.
int32_t lines_of_element(const Model& m, int b, int32_t element);
int32_t lines_of_node(const Model& m, int b, int32_t node);
bool do_lines_hold(const Model& m, int b, int32_t node, int component);
void fold_point(const ModelHeader& head, double p[2]);

inline bool is_axis_element(const Model& m, int b, int32_t element) {
  return m.body[b].lines != 0 && lines_of_element(m, b, element) != 0;
}
inline int32_t lines_at_node(const Model& m, int b, int32_t node) {
  return m.body[b].lines == 0 ? 0 : lines_of_node(m, b, node);
}

// Is this displacement zero by symmetry, or the node one of axis elements alone? Its row is then u = 0.
inline bool is_held_by_symmetry(const Model& m, int b, int32_t node, int component) {
  return m.body[b].lines != 0 && do_lines_hold(m, b, node, component);
}

// Images are numbered 0 (the body itself) ... 3 by the lines they are mirrored across. Does a body that meets `lines` have this
// image?
inline bool is_image(int32_t lines, int image) { return (image & ~lines) == 0; }
// The lines across which the equations of a body are mirrored: the kernels of rings contain the axis.
inline int32_t image_lines(const Model& m, int b) { return is_axisymmetric(m) ? m.body[b].lines & ~1 : m.body[b].lines; }
inline double image_sign(int image, int component) { return (image >> component & 1) != 0 ? -1.0 : 1.0; }
inline double mirrored(const ModelHeader& head, int image, int component, double coordinate) {
  return (image >> component & 1) != 0 ? 2.0 * head.line_at[component] - coordinate : coordinate;
}
// Moves a point into the modelled part by reflection.
inline void fold(const ModelHeader& head, double p[2]) {
  if (head.symmetry != 0) fold_point(head, p);
}

// Sets head->symmetry to the lines requested or detected among the elements (head->images), moves points onto them, and checks
// the model. Needs set_units. Returns false if it reported a fault.
bool validate_symmetry(const Model& m, Reporter& reporter);

// ---- the part of it that comes with c2d_set_symmetry (memory/parts.hpp) ----
// The same for requested lines.
bool validate_lines(const Model& m, Reporter& reporter);
int32_t lines_along(const Model& m, int b, int32_t element);
int32_t lines_at_corner(const Model& m, int b, int32_t node);
bool is_held_by_lines(const Model& m, int b, int32_t node, int component);
void fold_across(const ModelHeader& head, double p[2]);

} // namespace c2d
