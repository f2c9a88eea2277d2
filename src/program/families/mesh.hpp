// Boundary curves of the problem families: straight sides and arcs divided into graded elements, each side
// with its boundary condition.
#pragma once

#include <array>
#include <functional>
#include <vector>

namespace families {

struct Point {
  double x, y;
};

// What is known on a side, in global directions, in the order of the condition cards: tx ty ux uy.
struct Condition {
  std::array<int, 4> codes{{0, 0, 1, 1}};             // 0 known, 1 unknown; this: free of displacement conditions
  std::function<std::array<double, 4>(Point)> values; // of what is known, at a point of the side; none: zeros
  bool is_free() const { return codes == std::array<int, 4>{{0, 0, 1, 1}} && !values; }
};

Condition free_side();
Condition roller_x(double ux = 0); // ux given, no tangential traction
Condition roller_y(double uy = 0);
Condition clamped(double ux = 0, double uy = 0);
Condition traction(double tx, double ty);
Condition traction_field(std::function<std::array<double, 2>(Point)> field); // tx, ty at a point
Condition displacement_field(std::function<std::array<double, 2>(Point)> field);

// Distances 0 = s_0 < s_1 < ... < s_n = length of the nodes of a graded line. The elements have the sizes
// `first` at s = 0 and `last` at s = length (0: nothing asked for there) and grow from there by `ratio` per
// element, up to `largest`; all of them are scaled a little so that a whole number fits.
std::vector<double> graded(double length, double first, double last, double ratio, double largest);

// Distances of `n` equal elements.
std::vector<double> equal(double length, int n);

// The distances seen from the other end.
std::vector<double> reversed(const std::vector<double>& s);

// A closed boundary curve, run through with the material on the left. Sides are added in order; the last one
// ends where the first began.
class Outline {
public:
  struct Node {
    Point at;
    bool polar;
    double radius, angle;          // about the origin given for an arc
    bool held[2] = {false, false}; // ux, uy of this point alone are given
    double moved[2] = {0, 0};      // what they are
  };
  struct Side {
    int first, elements; // from 0
    Condition condition;
    char axis; // 'X', 'Y': on a line of symmetry x or y = const; else 0
  };

  explicit Outline(Point start) : nodes_{{start, false, 0, 0, {}, {}}} {}
  // A straight side to `end` with nodes at the fractions s / s.back().
  Outline& line(Point end, const std::vector<double>& s, const Condition& condition = free_side());
  // The same on a line of symmetry, x or y constant: smooth rollers, or nothing by images.
  Outline& axis_x(Point end, const std::vector<double>& s);
  Outline& axis_y(Point end, const std::vector<double>& s);
  // An arc about `centre` from angle `from` to `to` (degrees; rising: counter-clockwise).
  Outline& arc(Point centre, double radius, double from, double to, const std::vector<double>& s,
               const Condition& condition = free_side());

  // How the point reached so far moves in x, in y: against a motion that nothing else holds.
  Outline& hold_x(double ux = 0);
  Outline& hold_y(double uy = 0);

  int elements() const { return static_cast<int>(nodes_.size()) - 1; }
  const std::vector<Node>& nodes() const { return nodes_; } // the last is the first again
  const std::vector<Side>& sides() const { return sides_; }

private:
  Outline& add_side(int elements, const Condition& condition);
  std::vector<Node> nodes_;
  std::vector<Side> sides_;
};

} // namespace families
