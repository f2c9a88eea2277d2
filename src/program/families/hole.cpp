// Kirsch: a plate with a circular hole in tension.
#include "program/families/family.hpp"
#include "program/families/shapes.hpp"

#include <cmath>

namespace families {
namespace {

// Stresses of the infinite plate under sxx = S far away: sxx, syy, sxy.
std::array<double, 3> kirsch(Point at, double radius, double S) {
  const double r = std::hypot(at.x, at.y), t = std::atan2(at.y, at.x), q = radius * radius / (r * r);
  const double rr = S / 2 * (1 - q) + S / 2 * (1 - 4 * q + 3 * q * q) * std::cos(2 * t);
  const double tt = S / 2 * (1 + q) - S / 2 * (1 + 3 * q * q) * std::cos(2 * t);
  const double rt = -S / 2 * (1 + 2 * q - 3 * q * q) * std::sin(2 * t);
  const double c = std::cos(t), s = std::sin(t);
  return {{rr * c * c + tt * s * s - 2 * rt * s * c, rr * s * s + tt * c * c + 2 * rt * s * c,
           (rr - tt) * s * c + rt * (c * c - s * s)}};
}

ProblemModel build_hole(const Values& v) {
  const double R = v.number("R"), size = v.number("L") * R, S = v.number("S"), ratio = v.number("ratio");
  if (size < 1.5 * R) return unfit("L is below 1.5");
  const bool exact = v.word("outer") == "exact";
  const int n = v.count("n");
  ProblemModel m;
  m.heading = {"A plate with a hole of radius R in tension S along x; a quarter of it is modelled.",
               "The plate is the square |x|, |y| <= L R. At its outer sides act " +
                   std::string(exact ? "the tractions that the infinite" : "the tractions S of an endless"),
               exact ? "plate has there, so that the square behaves as the infinite plate does."
                     : "plate without a hole: it behaves as the infinite plate up to (1/L)^2.",
               "R = " + show(R) + ", S = " + show(S) + ": hoop stress 3 S at (0, R), -S at (R, 0)",
               "Reference: G. Kirsch, 1898"};
  m.title = "HOLE IN A PLATE";
  m.function_nodes = v.count("order") + 1;
  m.images = v.word("symmetry") == "images";
  m.plane = v.word("plane") == "stress" ? 1 : 0;
  const auto stress = [=](Point at) { return exact ? kirsch(at, R, S) : std::array<double, 3>{{S, 0, 0}}; };
  const Condition right = traction_field([=](Point at) { return std::array<double, 2>{{stress(at)[0], stress(at)[2]}}; });
  const Condition top = traction_field([=](Point at) { return std::array<double, 2>{{stress(at)[2], stress(at)[1]}}; });
  const double size_at_hole = std::acos(-1.0) / 2 * R / n, coarse = size / n;
  Outline plate({R, 0});
  plate.axis_y({size, 0}, graded(size - R, size_at_hole, 0, ratio, coarse));
  plate.line({size, size}, equal(size, n), right);
  plate.line({0, size}, equal(size, n), top);
  plate.axis_x({0, R}, graded(size - R, 0, size_at_hole, ratio, coarse));
  plate.arc({0, 0}, R, 90, 0, equal(1, n));
  m.bodies = {{v.number("E"), v.number("nu"), {0, 0}, {plate}, "the plate"}};
  return m;
}

} // namespace

Family hole_family() {
  return {"hole",
          "a plate with a circular hole in tension: Kirsch",
          {{"R", Kind::kPositive, "1", "radius of the hole"},
           {"S", Kind::kNumber, "1", "tension along x far away"},
           {"E", Kind::kPositive, "1", "Young's modulus"},
           {"nu", Kind::kPoisson, "0.3", "Poisson's ratio"},
           {"plane", Kind::kChoice, "strain", "strain|stress: plane strain or stress"},
           {"L", Kind::kPositive, "5", "half side of the plate, over R"},
           {"outer", Kind::kChoice, "exact", "exact|uniform: tractions there of the infinite plate, or S alone"},
           {"n", Kind::kCount, "12", "elements over the quarter circle"},
           {"ratio", Kind::kAboveOne, "1.3", "growth of the elements away from the hole"},
           {"order", Kind::kOrder, "2", "of the functions: 1 linear, 2 quadratic, 3 cubic"},
           {"symmetry", Kind::kChoice, "images", "images|line: how lines of symmetry are treated, by images or elements"}},
          build_hole};
}

} // namespace families
