// A rectangle between rough rigid plates.
#include "program/families/family.hpp"
#include "program/families/shapes.hpp"

#include <cmath>

namespace families {
namespace {

ProblemModel build_rough_plates(const Values& v) {
  const double h = v.number("h"), height = v.number("height") * h, E = v.number("E");
  const int n = v.count("n");
  const double ratio = v.number("ratio"), smallest = v.number("edge") * h;
  // Equal elements in the middle, graded ones towards the corner, where the pressure is singular.
  const std::vector<double> zone = reversed(graded(h, smallest, 0, ratio, h / n));

  ProblemModel m;
  m.heading = {"A rectangle between rigid rough plates (body 1), pressed by delta each.",
               "A quarter is modelled: x = 0 and the middle plane y = height are lines of symmetry.",
               "Half width h = " + show(h) + ", half height " + show(height) + ", nu = " + show(v.number("nu")),
               "The middle |x| < c sticks, the rest slips outward; c/h depends on mu and nu alone.",
               "Reference: spectral finite elements, c from the vanishing singularity"};
  m.title = "RECTANGLE BETWEEN ROUGH PLATES, " + show(n) + " ELEMENTS";
  m.function_nodes = v.count("order") + 1;
  m.images = v.word("symmetry") == "images";
  m.friction = {v.number("mu")};
  const std::vector<double> top = equal(h, 8);
  Outline block({0, 0});
  block.line({h, 0}, zone);
  block.line({h, height}, graded(height, last_size(zone), 0, ratio, h / 8));
  block.line({0, height}, reversed(top), roller_y(-v.number("delta")));
  block.axis_x({0, 0}, graded(height, 0, first_size(zone), ratio, h / 8));
  Outline plate({0, -h});
  plate.line({2 * h, -h}, equal(2 * h, 6), roller_y());
  plate.line({2 * h, 0}, equal(h, 3));
  plate.line({h, 0}, graded(h, 0, last_size(zone), ratio, h / 3));
  plate.line({0, 0}, reversed(zone));
  plate.axis_x({0, -h}, graded(h, first_size(zone), 0, ratio, h / 3));
  m.bodies = {{E * v.number("rigid"), v.number("nu"), {h, 0}, {plate}, "the plate"},
              {E, v.number("nu"), {h, 0}, {block}, "the rectangle"}};
  m.zones = {contact(3, 0)};
  return m;
}

} // namespace

Family rough_plates_family() {
  return {"rough_plates",
          "a rectangle pressed between rough rigid plates",
          {{"mu", Kind::kFriction, "0.2", "coefficient of friction"},
           {"h", Kind::kPositive, "1", "half width"},
           {"height", Kind::kPositive, "1", "half height, over h"},
           {"E", Kind::kPositive, "1000", "Young's modulus"},
           {"nu", Kind::kPoisson, "0.3", "Poisson's ratio"},
           {"delta", Kind::kPositive, "0.01", "how much the middle plane comes down"},
           {"rigid", Kind::kPositive, "1e5", "stiffness of the plate over that of the rectangle"},
           {"n", Kind::kCount, "40", "elements over h, were they equal"},
           {"edge", Kind::kPositive, "1e-4", "element at the corner, over h"},
           {"ratio", Kind::kAboveOne, "1.3", "growth of the elements away from the corner"},
           {"order", Kind::kOrder, "2", "of the functions: 1 linear, 2 quadratic, 3 cubic"},
           {"symmetry", Kind::kChoice, "images", "images|line: how lines of symmetry are treated, by images or elements"}},
          build_rough_plates};
}

} // namespace families
