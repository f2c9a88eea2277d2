// The boundary of a body as a chain of faces: order of elements, angles between them, boundary conditions.
#pragma once

#include "post/corner_exponent.hpp"
#include "post/point.hpp"
#include "post/summary.hpp"

#include <contact2d.h>

#include <cstdint>
#include <vector>

namespace app {

// An end of a range of elements; up: at its highest number.
struct StretchEnd {
  int32_t element = 0;
  bool up = true;
};

class BodyFaces {
public:
  c2d_status read(c2d_solver* solver, const Summary& summary, int32_t body);

  int32_t elements() const { return static_cast<int32_t>(zone_.size()); }
  // Elements count from 1; 0: the curve ends there, on a line of symmetry by images.
  int32_t next(int32_t element, bool up) const;
  Point at(int32_t element, bool end) const;
  Point direction(int32_t element, bool end) const; // of length 1, along rising numbers
  double length(int32_t element) const;
  // Angle through the material between the end of an element and the next one: 2 pi at the tip of a slit.
  double angle_after(int32_t element) const;
  bool is_on_line(int32_t element) const { return on_line_[index(element)]; } // replaced by images: no boundary
  // The same at the end of a curve, where its image begins; up: at its last element. 0: it does not end on a line.
  double angle_at_image(int32_t element, bool up) const;
  // A real corner, of more than 15 degrees: none between chords of an arc, nor inside an arc or a spline.
  bool is_corner_after(int32_t element) const;
  // The same where the image begins.
  bool is_corner_at_image(int32_t element, bool up) const;
  // Boundary condition of an element; false: contact, or a condition that a Face cannot represent.
  bool face(int32_t element, Face& out) const;

  int32_t zone(int32_t element) const { return zone_[index(element)]; } // 0: of none
  void enter_zone(const c2d_side& side, int32_t zone);
  // End of the range of a side; `first`: whether a range of one element runs up.
  void find_ends(const c2d_side& side, bool first, StretchEnd out[2]) const;
  Point at(const StretchEnd& end) const { return at(end.element, end.up); }
  // The same for the joint at this end: angle, is it a corner, the element beyond (0: none).
  int32_t before(const StretchEnd& end) const { return end.up ? end.element : next(end.element, false); }
  int32_t beyond(const StretchEnd& end) const { return next(end.element, end.up); }

private:
  static size_t index(int32_t element) { return static_cast<size_t>(element) - 1; }
  Point node(int32_t element, int32_t k) const;
  double turn_after(int32_t element) const;
  double turn_at_image(int32_t element, bool up) const; // 0: the curve does not end on a line
  double turn_beyond(int32_t element, bool up) const;   // at that end of an element, whatever follows
  bool is_of_chords(double turn, double before, double after) const;
  bool lies_on(int32_t element, int axis) const; // a line of symmetry: x = ... is axis 0
  bool is_at_line(const Point& p, int axis) const;
  c2d_status read_regions(c2d_solver* solver, const Summary& summary, int32_t body);
  c2d_status read_conditions(c2d_solver* solver, const Summary& summary, int32_t body);
  c2d_status read_curves(c2d_solver* solver, const Summary& summary, int32_t body);

  int32_t per_element_ = 2; // geometry nodes
  struct Region {
    int32_t first, last;
    bool open;
  };
  std::vector<Region> regions_;
  std::vector<size_t> region_; // of each element
  std::vector<double> x_, y_;  // geometry nodes
  std::vector<bool> on_line_;  // of each element
  int32_t symmetry_ = 0;
  double symmetry_at_[2] = {0, 0};
  std::vector<int32_t> zone_;      // of each element
  std::vector<int32_t> curve_;     // of each element: an arc or a spline, from 1
  std::vector<int32_t> condition_; // of each element: bits 1, 2: displacement ux, uy known at all of its ends
};

} // namespace app
