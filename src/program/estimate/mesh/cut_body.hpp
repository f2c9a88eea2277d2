// One body of a deck with bisected elements: new numbers of its elements and nodes. All numbers are from 0.
#pragma once

#include "post/point.hpp"

#include <contact2d.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace estimate {

using app::distance, app::length, app::Point;

// Throws on a failed call of the interface: calls fail only if the solver has no model.
void need(c2d_status status);

struct CutRegion {
  int32_t first, last; // elements
  bool open;
  int32_t elements() const { return last - first + 1; }
};

struct CutBody {
  int32_t element_nodes = 0, function_nodes = 0; // of an element
  double youngs_modulus = 0, poisson_ratio = 0;
  std::vector<CutRegion> regions; // open ones first
  std::vector<Point> points;      // boundary points
  std::vector<Point> surface;     // over the middle of every element, METHOD 8.1
  std::vector<int32_t> children;  // per element, its first new element; one more entry at the end
  std::vector<bool> in_contact;   // by element
  std::vector<int32_t> curve;     // by element: index of its curve in the model, -1: none

  int32_t elements() const { return static_cast<int32_t>(in_contact.size()); }
  int32_t child_count(int32_t element) const { return children[at(element) + 1] - children[at(element)]; }
  // First boundary point of an element; `nodes`: its boundary points in the numbering of a closed region.
  int32_t first_point(int32_t region, int32_t element) const;
  std::vector<Point> points_of(int32_t region, int32_t element) const;
  int32_t region_of(int32_t element) const;
  static size_t at(int32_t i) { return static_cast<size_t>(i); }
};

CutBody cut_body(c2d_solver* solver, int32_t body, int32_t function_nodes);

// The new boundary points, region by region, in the order of the cards. Each has a flag: it existed before, or lies on a given
// curve or a circle, and is not interpolated from adjacent points.
struct CutPoints {
  std::vector<Point> points;
  std::vector<bool> sure;
};
CutPoints cut_points(const CutBody& body, const std::vector<c2d_curve>& curves);
// Coincident elements of a matching zone remain coincident, and separate ones do not overlap, unless a load case closes
// overlaps.
void match_points(const c2d_zone& zone, const std::vector<CutBody>& bodies, bool overlaps, std::vector<CutPoints>& points);

// A range of elements or functional nodes of a zone, from first to last, upwards or downwards.
struct Range {
  int32_t first, last;
};
// Does a range of this number of elements run upwards? 0 elements: by its numbers.
bool goes_up(const CutBody& body, const Range& elements, int32_t count);
Range cut_elements(const CutBody& body, const Range& elements, bool up);
// Functional nodes of a matching zone, at the same offset from the ends of its elements as before.
Range cut_nodes(const CutBody& body, const Range& elements, const Range& nodes, bool up);
// Number of new elements of the range.
int32_t count_cut(const CutBody& body, const Range& elements, bool up);
// The elements of a range, in its order.
std::vector<int32_t> elements_of(const CutBody& body, const Range& elements, bool up);
// Does side 1 or 2 of a matching zone run upwards? A single element has the direction of its nodes; with constant functions it
// has one node, and no direction.
bool goes_up(const CutBody& body, const c2d_zone& zone, int side);

// Codes and values of an element's end in every load case.
struct EndCondition {
  std::array<int32_t, 4> codes; // tx ty ux uy; 0: known
  std::vector<std::array<double, 4>> values;
};
// Conditions of all ends of the new elements, in order.
std::vector<EndCondition> cut_conditions(c2d_solver* solver, int32_t body, const CutBody& cut, int32_t load_cases);

} // namespace estimate
