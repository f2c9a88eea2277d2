#pragma once
// Destinations of the integrals of an element: columns of the unknowns, or the right-hand sides for prescribed values.
#include "bie/columns.hpp"

namespace c2d {

struct Target { // column -= or += factor * integral; column < 0: nowhere
  int32_t column;
  double factor;
};
// For one component of one local node: at most the two contact columns of its pair, or one outer column. Prescribed values go
// to the right-hand sides.
struct Destination {
  Target target[2];
  bool known;   // times value(case), into the right-hand sides
  bool contact; // a contact traction, see Measure
};

struct Range { // the columns wanted, and the first right-hand side
  int32_t first, last, right;
  bool contains(int32_t column) const { return column >= first && column < last; }
  bool has_right() const { return last > right; }
  // The load cases whose right-hand sides are in it: first_case() ... end_case() - 1.
  int32_t first_case() const { return first > right ? first - right : 0; }
  int32_t end_case() const { return has_right() ? last - right : 0; }
};

struct ElementTargets {
  Destination h[kElementNodes][2], g[kElementNodes][2];
  int32_t node[kElementNodes];
  bool want_h, want_g; // tractions on the element's own length
  bool want_contact;   // contact tractions
  bool shared;         // some component goes to two columns, inside the range or not
};

Destination displacement_destination(const Model& m, int b, int32_t node, int component, const Unknown& unknown);

// Prescribed values in the units of the equations; displacement carries the sign of its move to the right.
double known_displacement(const Model& m, int b, int32_t node, int component, int32_t load_case);
double known_traction(const Model& m, int b, int32_t element, int l, int component, int32_t load_case);

// May the range contain columns of a node's own unknowns? Always true if it extends beyond the columns of nodes.
bool concerns(const Model& m, int b, int32_t node, const Range& range);

// Targets of everything in the range; the rest goes nowhere.
void aim(const Model& m, int b, int32_t element, const Range& range, ElementTargets& out);

} // namespace c2d
