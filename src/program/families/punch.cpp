// Spence and Turner: a flat rigid punch with friction, loaded and unloaded.
#include "program/families/family.hpp"
#include "program/families/shapes.hpp"

#include <cmath>

namespace families {
namespace {

ProblemModel build_punch(const Values& v) {
  const double a = v.number("a"), E = v.number("E"), load = v.number("P"), unload = v.number("unload");
  const double size = v.number("L") * a, edge = v.number("edge") * a, ratio = 1 / v.number("grading");
  const int n = v.count("n");
  if (size < 3 * a) return unfit("L is below 3");
  if (!(ratio > 1 && ratio <= 4)) return unfit("grading is to be from 0.25 to below 1");
  // Equal elements in the middle, and from there ever smaller ones towards the edge.
  const std::vector<double> zone = reversed(graded(a, edge, 0, ratio, a / n));

  ProblemModel m;
  m.heading = {"A flat rigid punch (body 2) on a half plane (body 1), with friction.",
               "Half of it is modelled; the half plane is a block of half width L a.",
               "a = " + show(a) + ", P = " + show(load) + ", mu = " + show(v.number("mu")) + ", nu = " + show(v.number("nu")),
               unload < 1 ? "Loaded to P, then unloaded to " + show(unload) + " P" : "Loaded to P",
               "Reference: D. A. Spence, 1975 (loading); J. R. Turner, 1979 (unloading)"};
  m.title = "RIGID PUNCH WITH FRICTION";
  m.function_nodes = v.count("order") + 1;
  m.images = v.word("symmetry") == "images";
  m.friction = {v.number("mu")};
  const double outside = v.number("ratio");
  Outline block({0, -size});
  block.line({size, -size}, equal(size, 4), roller_y());
  block.line({size, 0}, equal(size, 4));
  block.line({a, 0}, graded(size - a, 0, edge, outside, size / 4));
  block.line({0, 0}, reversed(zone));
  block.axis_x({0, -size}, graded(size, first_size(zone), 0, outside, size / 4));
  Outline punch({0, 0});
  punch.line({a, 0}, zone);
  punch.line({a, a}, graded(a, edge, 0, outside, a / 2));
  punch.line({0, a}, equal(a, 2), traction(0, -load / (2 * a)));
  punch.axis_x({0, 0}, graded(a, 0, first_size(zone), outside, a / 2));
  // The origin at the edge: the cards tell small distances from there with all their digits.
  m.bodies = {{E, v.number("nu"), {a, 0}, {block}, "the half plane"},
              {E * v.number("rigid"), v.number("nu"), {a, 0}, {punch}, "the punch"}};
  m.zones = {contact(3, 0)};
  m.loads = {{1, 1.0}};
  if (unload < 1) m.loads.push_back({v.count("steps"), unload});
  return m;
}

} // namespace

Family punch_family() {
  return {"punch",
          "a flat rigid punch with friction on a half plane: Spence (loading) and Turner (unloading)",
          {{"mu", Kind::kFriction, "0.265", "coefficient of friction"},
           {"unload", Kind::kFraction, "1", "part of the load that is left after unloading; 1: none is taken off"},
           {"steps", Kind::kCount, "1", "increments of the unloading"},
           {"a", Kind::kPositive, "1", "half width of the punch"},
           {"P", Kind::kPositive, "1", "load per unit thickness"},
           {"E", Kind::kPositive, "1000", "Young's modulus of the half plane"},
           {"nu", Kind::kPoisson, "0.330767", "its Poisson's ratio"},
           {"rigid", Kind::kPositive, "1e5", "stiffness of the punch over that of the half plane"},
           {"n", Kind::kCount, "40", "elements over a, were they equal"},
           {"edge", Kind::kPositive, "1e-6", "element at the edge, over a"},
           {"grading", Kind::kFraction, "0.75", "size of an element over that of the one before, towards the edge"},
           {"L", Kind::kPositive, "1000", "half width and depth of the block, over a"},
           {"ratio", Kind::kAboveOne, "1.4", "growth of the elements outside"},
           {"order", Kind::kOrder, "2", "of the functions: 1 linear, 2 quadratic, 3 cubic"},
           {"symmetry", Kind::kChoice, "images", "images|line: how lines of symmetry are treated, by images or elements"}},
          build_punch};
}

} // namespace families
