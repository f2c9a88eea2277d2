// A blade's root in the slot of a disc, pulled outwards: two inclined contacts, of which one is modelled.
#include "program/families/family.hpp"
#include "program/families/shapes.hpp"

#include <algorithm>
#include <cmath>

namespace families {
namespace {

// Half of the joint; the flanks' normal is at an angle from the y axis.
struct Joint {
  double shank, root;     // half widths of the blade, above and below the flanks
  double foot, clearance; // height of the root below the flanks; of the slot around it
  double slope;           // of the flanks
  double height, size;    // of the shank; of the disc
  double ratio;
  std::vector<double> zone; // nodes of the contact, distances from its lower end
  double height_of(double x) const { return foot + (root - x) * slope; }
  Point lower() const { return {root, foot}; }
  Point upper() const { return {shank + clearance, height_of(shank + clearance)}; } // of the contact
};

// Sides: 0 bottom, 1 side, 2 zone, 3 flank outside it, 4 shank, 5 top, 6 axis.
Outline blade(const Joint& j, double pull) {
  const double fine = first_size(j.zone), coarse = j.shank / 2, corner = j.height_of(j.shank), top = corner + j.height;
  const double beyond = (j.clearance / j.zone.back()) * (j.root - j.shank); // of the flank, about
  Outline out({0, 0});
  out.line({j.root, 0}, graded(j.root, 0, 0, j.ratio, coarse));
  out.line(j.lower(), graded(j.foot, 0, fine, j.ratio, coarse));
  out.line(j.upper(), j.zone);
  out.line({j.shank, corner}, graded(beyond, fine, fine, j.ratio, coarse));
  out.line({j.shank, top}, graded(j.height, fine, 0, j.ratio, coarse));
  out.line({0, top}, graded(j.shank, 0, 0, j.ratio, coarse), traction(0, pull / (2 * j.shank)));
  out.axis_x({0, 0}, graded(top, 0, 0, j.ratio, coarse));
  return out;
}

// Sides: 0 foot, 1 right, 2 top, 3 neck, 4 zone, 5 flank below it, 6 side, 7 bottom of the slot, 8 axis.
Outline disc(const Joint& j) {
  const double fine = first_size(j.zone), coarse = j.shank / 2, c = j.clearance, far = j.size / 6;
  const Point upper = j.upper(), lower = j.lower(), corner{lower.x + c, j.height_of(lower.x + c)};
  const double top = upper.y + 2 * c;
  Outline out({0, -j.size});
  out.line({j.size, -j.size}, graded(j.size, 0, 0, j.ratio, far), clamped());
  out.line({j.size, top}, graded(j.size + top, 0, 0, j.ratio, far));
  out.line({upper.x, top}, graded(j.size - upper.x, 0, c / 2, j.ratio, far));
  out.line(upper, graded(2 * c, 0, fine, j.ratio, c / 2));
  out.line(lower, reversed(j.zone));
  out.line(corner, graded(std::hypot(c, c * j.slope), fine, 0, j.ratio, c / 2));
  out.line({corner.x, -c}, graded(corner.y + c, c / 4, c / 4, j.ratio, coarse));
  out.line({0, -c}, graded(corner.x, c / 4, 0, j.ratio, coarse));
  out.axis_x({0, -j.size}, graded(j.size - c, coarse, 0, j.ratio, far));
  return out;
}

ProblemModel build(const Values& v) {
  const double angle = v.number("angle"), pull = v.number("F"), mu = v.number("mu"), ratio = v.number("ratio");
  if (angle < 10 || angle > 80) return unfit("angle is to be from 10 to 80 degrees");
  const double radian = angle * std::acos(-1.0) / 180;
  Joint j{v.number("s"), v.number("b"), 0, v.number("gap"), std::tan(radian), 0, 0, ratio, {}};
  if (j.shank + 2 * j.clearance >= j.root) return unfit("b is not above s + 2 gap: no flank is left");
  j.foot = j.clearance * j.slope + j.root / 2;
  j.height = 3 * j.shank;
  j.size = v.number("L") * j.root;
  if (v.number("L") < 2) return unfit("L is below 2");
  const double length = (j.root - j.shank - j.clearance) / std::cos(radian);
  const int n = v.count("n");
  j.zone = graded(length, length / n / 8, length / n / 8, ratio, length / n);
  const double normal = pull / (2 * std::cos(radian)), slides = pull / (2 * (std::cos(radian) + mu * std::sin(radian)));

  ProblemModel m;
  m.heading = {"A blade's root (body 2) in the slot of a disc (body 1), pulled by F; the half x >= 0 is modelled.",
               "The flanks' normal is " + show(angle) + " degrees from the load F = " + show(pull) + ".",
               "Smooth, each flank carries F / (2 cos) = " + show(normal) + " along its normal; with friction that slips, " +
                   show(slides) + ",",
               "F / (2 (cos + mu sin)). In any case the flanks' forces make up F.", "Reference: balance of forces"};
  m.title = "DOVETAIL";
  m.function_nodes = v.count("order") + 1;
  m.images = true;
  m.friction = {mu};
  m.bodies = {{v.number("E1"), v.number("nu1"), {0, 0}, {disc(j)}, "the disc"},
              {v.number("E2"), v.number("nu2"), {0, 0}, {blade(j, pull)}, "the blade"}};
  m.zones = {contact(4, 2)};
  return m;
}

} // namespace

Family dovetail_family() {
  return {"dovetail",
          "a blade's root in the slot of a disc, pulled outwards: two inclined contacts",
          {{"angle", Kind::kPositive, "45", "of the flanks' normal from the load, degrees"},
           {"F", Kind::kPositive, "0.1", "load on the blade"},
           {"mu", Kind::kFriction, "0", "coefficient of friction"},
           {"s", Kind::kPositive, "1", "half width of the blade above the flanks"},
           {"b", Kind::kPositive, "2", "half width of its root"},
           {"gap", Kind::kPositive, "0.2", "between root and slot, outside the flanks"},
           {"E1", Kind::kPositive, "1000", "Young's modulus of the disc"},
           {"nu1", Kind::kPoisson, "0.3", "its Poisson's ratio"},
           {"E2", Kind::kPositive, "1000", "Young's modulus of the blade"},
           {"nu2", Kind::kPoisson, "0.3", "its Poisson's ratio"},
           {"n", Kind::kCount, "20", "elements over a flank, were they equal; they are smaller at its ends"},
           {"L", Kind::kPositive, "5", "half width and depth of the disc, over b"},
           {"ratio", Kind::kPositive, "1.4", "growth of the elements"},
           {"order", Kind::kOrder, "1", "of the functions: 1 linear, 2 quadratic, 3 cubic"}},
          build};
}

} // namespace families
