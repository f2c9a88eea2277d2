// The boundary of a body as elements, queried from the library: positions, lengths, order.
#pragma once

#include "post/summary.hpp"

#include <contact2d.h>

#include <array>
#include <cstdint>
#include <vector>

namespace app {

// Lagrange polynomials over `count` equally spaced points of [-1, 1], and their slopes; one point: constant.
double shape_value(int32_t count, int32_t k, double eta);
double shape_slope(int32_t count, int32_t k, double eta);
// The place of functional node k (from 0) of `count`.
inline double node_place(int32_t count, int32_t k) { return count > 1 ? -1.0 + 2.0 * k / (count - 1) : 0.0; }

constexpr double kFullTurn = 6.28318530717958647692; // of a body of revolution

// The curve of one element through its boundary points.
struct ElementCurve {
  int32_t count = 0; // 2, 3 or 4; 0: none
  double x[4] = {0, 0, 0, 0}, y[4] = {0, 0, 0, 0};

  void point(double eta, double out[2]) const;
  void slope(double eta, double out[2]) const; // d(x, y)/d(eta)
  // Integral of the curve's length from `from` to `to`, times shape function k of `nodes`; nodes = 1: the length itself.
  // Revolved: of the area that the curve describes about x = 0.
  double length(double from, double to, int32_t nodes = 1, int32_t k = 0, bool revolved = false) const;
  double length() const { return length(-1, 1); }
};

class BodyCurve {
public:
  // A body without elements, a platen, is left empty.
  c2d_status read(c2d_solver* solver, const Summary& summary, int32_t body);
  int32_t elements() const { return static_cast<int32_t>(elements_.size()); }
  const ElementCurve& element(int32_t e) const { return elements_[static_cast<size_t>(e) - 1]; }
  // Functional node of an element's end, local from 1.
  int32_t node(int32_t e, int32_t local) const;
  // The next element, upwards or downwards; 0 beyond the ends of an open region.
  int32_t next(int32_t e, bool up) const;
  // Number of elements of the region of e; is it closed?
  int32_t region_size(int32_t e) const { return region_of(e).last - region_of(e).first + 1; }
  bool is_closed(int32_t e) const { return !region_of(e).open; }
  // Does the boundary turn by more than 30 degrees where element e begins, or ends?
  bool is_corner(int32_t e, bool at_end) const;
  // Is the functional node at a corner?
  bool is_corner_node(int32_t node) const {
    return node > 0 && static_cast<size_t>(node) < corner_.size() && corner_[static_cast<size_t>(node)] != 0;
  }

private:
  struct Region {
    int32_t first, last;
    bool open;
  };
  const Region& region_of(int32_t e) const;
  void mark_corners(int32_t nodes);
  void take_elements(const c2d_body_result& body, const std::vector<double>& x, const std::vector<double>& y);

  int32_t function_nodes_ = 0;
  std::vector<Region> regions_;
  std::vector<ElementCurve> elements_;
  std::vector<double> node_; // of every element end
  std::vector<char> corner_; // of every functional node, from 1
};

} // namespace app
