#pragma once
// Bodies as outlines: closed rows of sides, each a line or an arc with elements, a condition and perhaps a contact.
#include "../problem.hpp"

#include <vector>

namespace random_decks {

struct Point {
  double x, y;
};

// From a to b; an arc bulges to the right of the way by `bulge` times the chord. Two sides made of one curve, run one way
// and the other, have the same points to the last bit.
struct Curve {
  Point a, b;
  double bulge = 0;
  bool by_angle = false;    // the parameter is the angle of the arc, else the way along its chord
  Point at(double s) const; // s from 0 to 1
};

// Of one component in a load case: displacement if `fixed`, else traction.
struct Condition {
  bool fixed[2] = {false, false};
  double value[2][2] = {{0, 0}, {0, 0}}; // [load case][component]
};

struct Side {
  Curve curve;
  bool backwards = false;
  std::vector<double> breaks; // of the curve's parameter, from 0 to 1: ends of elements
  Condition condition;
  int zone = 0;
  int32_t elements() const { return static_cast<int32_t>(breaks.size()) - 1; }
  Point first() const { return backwards ? curve.b : curve.a; }
  Point last() const { return backwards ? curve.a : curve.b; }
  Point at(int32_t element, double s) const; // s from 0 to 1 along the element, in the side's own direction
};

struct Pin { // one component of displacement held at the first corner of a side
  int32_t region, side, component;
};

struct Outlines {
  std::vector<std::vector<Side>> regions; // the outer one counter-clockwise, holes clockwise
  std::vector<Pin> pins;
};

std::vector<double> equal_breaks(int32_t elements);
Side line(Point from, Point to, int32_t elements);
Side arc(Point from, Point to, int32_t elements, double bulge);
// The same side seen from the other body.
Side opposite(const Side& side);

// What the model needs of it: points, regions, conditions of both load cases.
problem::Body make_body(const Outlines& outlines, int32_t element_nodes, int32_t function_nodes, bool two_cases);

// Elements of zone k, in the direction of the outline: consecutive sides of one region.
struct Run {
  int32_t first_element, elements; // from 1
};
Run run_of(const Outlines& outlines, int zone);

} // namespace random_decks
