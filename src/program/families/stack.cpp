// Plates upon each other, pressed and sheared below the limit of friction: a uniform field through all of them.
#include "program/families/family.hpp"
#include "program/families/shapes.hpp"

#include <cmath>

namespace families {
namespace {

struct Field { // uniform stress
  double p, q, E, nu;
  // From the foot, which it leaves level: plane strain.
  std::array<double, 2> displacement(Point at) const {
    const double along = nu * (1 + nu) * p / E, shear = 2 * (1 + nu) * q / E, down = (1 - nu * nu) * p / E;
    return {{along * at.x + shear * at.y, -down * at.y}};
  }
};

// Sides: 0 lower, 1 right, 2 upper, 3 left.
Outline plate(double width, double bottom, double height, int along, int up, const Field& f, bool first, bool last) {
  const double top = bottom + height;
  Outline out({0, bottom});
  const Condition foot = displacement_field([f](Point at) { return f.displacement(at); });
  out.line({width, bottom}, equal(width, along), first ? foot : free_side());
  out.line({width, top}, equal(height, up), traction(0, f.q));
  out.line({0, top}, equal(width, along), last ? traction(f.q, -f.p) : free_side());
  out.line({0, bottom}, equal(height, up), traction(0, -f.q));
  return out;
}

ProblemModel build_stack(const Values& v) {
  const Field f{v.number("p"), v.number("q"), v.number("E"), v.number("nu")};
  const double width = v.number("w"), height = v.number("h"), mu = v.number("mu");
  if (std::fabs(f.q) >= mu * f.p) return unfit("q is not below mu p: the plates slide");
  const int plates = v.count("plates"), n = v.count("n");
  if (plates > 50) return unfit("plates is above 50");

  ProblemModel m;
  m.heading = {show(plates) + " plates of unequal meshes upon each other, held by friction alone.",
               "p = " + show(f.p) + " presses and q = " + show(f.q) + " shears the stack, mu p = " + show(mu * f.p),
               "The stress is uniform: syy = -p, sxy = q, sxx = 0, and every pair sticks.", "Reference: the uniform field"};
  m.title = show(plates) + " PLATES";
  m.function_nodes = v.count("order") + 1;
  m.friction = {mu};
  for (int i = 0; i < plates; ++i) {
    const int along = n + 2 * (plates - 1 - i) % 7; // the one below is finer, but not without bounds
    m.bodies.push_back({f.E,
                        f.nu,
                        {0, 0},
                        {plate(width, i * height, height, along, 2 + i % 2, f, i == 0, i + 1 == plates)},
                        "plate " + show(i + 1)});
    if (i > 0) m.zones.push_back({{i - 1, 2}, {i, 0}, true});
  }
  return m;
}

} // namespace

Family stack_family() {
  return {"stack",
          "plates upon each other, pressed and sheared: a uniform field through free zones",
          {{"plates", Kind::kCount, "3", "how many, at most 50"},
           {"p", Kind::kPositive, "1", "pressure on the upper plate"},
           {"q", Kind::kNumber, "0.2", "shear on it; below mu p"},
           {"mu", Kind::kFriction, "0.3", "coefficient of friction; inf: adhesion"},
           {"w", Kind::kPositive, "3", "width of the plates"},
           {"h", Kind::kPositive, "1", "height of each"},
           {"E", Kind::kPositive, "1000", "Young's modulus"},
           {"nu", Kind::kPoisson, "0.3", "Poisson's ratio"},
           {"n", Kind::kCount, "5", "elements over the width of the upper plate; others have up to 6 more"},
           {"order", Kind::kOrder, "1", "of the functions: 1 linear, 2 quadratic, 3 cubic"}},
          build_stack};
}

} // namespace families
