// A smooth disc in a hole of its size, in a plate under tension or compression.
#include "program/families/family.hpp"
#include "program/families/shapes.hpp"

#include <cmath>

namespace families {
namespace {

ProblemModel build_disc_in_hole(const Values& v) {
  const double R = v.number("R"), size = v.number("L") * R, ratio = v.number("ratio");
  const double Sx = v.number("Sx"), Sy = v.number("Sy");
  if (size < 2 * R) return unfit("L is below 2");
  if (Sx == 0 && Sy == 0) return unfit("Sx and Sy are both 0");
  const int n = v.count("n");
  const double h = std::acos(-1.0) / 2 * R / n;

  ProblemModel m;
  m.heading = {"A smooth disc (body 2) in a hole of its own radius in a plate (body 1) under Sx, Sy.",
               "A quarter is modelled; the plate is the square |x|, |y| <= L R with uniform tractions.",
               "R = " + show(R) + ", Sx = " + show(Sx) + ", Sy = " + show(Sy) + ", E of disc over plate " +
                   show(v.number("E2") / v.number("E1")),
               "The angle of contact does not depend on the load: 19.625 degrees from the pole for Sx alone",
               "and equal materials, where the pressure at the pole is 0.60908 Sx.",
               "Reference: singular integral equation; K. L. Johnson, Contact Mechanics, section 5.3"};
  m.title = "SMOOTH DISC IN A HOLE, " + show(n) + " ELEMENTS OVER THE QUARTER";
  m.function_nodes = v.count("order") + 1;
  m.images = v.word("symmetry") == "images";
  const double coarse = size / 6;
  Outline plate({size, 0});
  plate.line({size, size}, equal(size, 6), traction(Sx, 0));
  plate.line({0, size}, equal(size, 6), traction(0, Sy));
  plate.axis_x({0, R}, graded(size - R, 0, h, ratio, coarse));
  plate.arc({0, 0}, R, 90, 0, equal(1, n));
  plate.axis_y({size, 0}, graded(size - R, h, 0, ratio, coarse));
  Outline disc({0, 0});
  disc.axis_y({R, 0}, graded(R, 0, h, ratio, R / 6));
  disc.arc({0, 0}, R, 0, 90, equal(1, n));
  disc.axis_x({0, 0}, graded(R, h, 0, ratio, R / 6));
  m.bodies = {{v.number("E1"), v.number("nu1"), {0, 0}, {plate}, "the plate"},
              {v.number("E2"), v.number("nu2"), {0, 0}, {disc}, "the disc"}};
  m.zones = {contact(3, 1)};
  return m;
}

} // namespace

Family disc_in_hole_family() {
  return {"disc_in_hole",
          "a smooth disc in a hole of its size in a plate",
          {{"Sx", Kind::kNumber, "1", "stress along x far away"},
           {"Sy", Kind::kNumber, "0", "stress along y far away"},
           {"R", Kind::kPositive, "1", "radius"},
           {"E1", Kind::kPositive, "1000", "Young's modulus of the plate"},
           {"nu1", Kind::kPoisson, "0.3", "its Poisson's ratio"},
           {"E2", Kind::kPositive, "1000", "Young's modulus of the disc"},
           {"nu2", Kind::kPoisson, "0.3", "its Poisson's ratio"},
           {"n", Kind::kCount, "60", "elements over the quarter circle"},
           {"L", Kind::kPositive, "400", "half side of the plate, over R"},
           {"ratio", Kind::kAboveOne, "1.3", "growth of the elements away from the hole"},
           {"order", Kind::kOrder, "1", "of the functions: 1 linear, 2 quadratic, 3 cubic"},
           {"symmetry", Kind::kChoice, "images", "images|line: how lines of symmetry are treated, by images or elements"}},
          build_disc_in_hole};
}

} // namespace families
