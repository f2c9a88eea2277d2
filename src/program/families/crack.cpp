// A plate with a crack, cut along the crack's line into two halves that are tied ahead of its tips.
#include "program/families/family.hpp"
#include "program/families/shapes.hpp"

#include <algorithm>
#include <cmath>

namespace families {
namespace {

struct Plate {
  double left, right, height;            // of the whole plate's sides; half its height
  double tension, bending, middle, half; // stress: tension + bending (x - middle) / half
  double shear;
  double coarse; // elements away from the crack
  double stress(double x) const { return tension + bending * (x - middle) / half; }
};

// A part of the cut from left to right: distances of the nodes from its left end.
struct Part {
  double from;
  std::vector<double> s;
  bool cracked;
};

// The half below the cut, or above it. Sides: 0 to 2 foot (upper half: 0 top), then right, the cut's parts (from the right in
// the lower half, from the left in the upper one), left. In the upper half left comes before the cut.
Outline half_of(const Plate& p, const std::vector<Part>& cut, bool upper) {
  const double width = p.right - p.left, side = upper ? 1 : -1;
  const auto across = [&](double length) { return equal(length, std::max(1, static_cast<int>(std::ceil(length / p.coarse)))); };
  const Condition far = traction_field([=](Point at) {
    return std::array<double, 2>{{side * p.shear, side * p.stress(at.x)}};
  });
  const std::vector<double>&first = cut.front().s, &last = cut.back().s;
  const std::vector<double> left = graded(p.height, 0, first_size(first), 1.5, p.coarse),
                            right = graded(p.height, 0, last_size(last), 1.5, p.coarse);
  if (upper) {
    Outline out({p.right, p.height});
    out.line({p.left, p.height}, across(width), far);
    out.line({p.left, 0}, left, traction(0, -p.shear));
    for (const Part& part : cut) out.line({part.from + part.s.back(), 0}, part.s);
    out.line({p.right, p.height}, reversed(right), traction(0, p.shear));
    return out;
  }
  Outline out({p.left, -p.height}); // held at two points of its foot
  out.line({p.left + width / 3, -p.height}, across(width / 3), far).hold_x().hold_y();
  out.line({p.right - width / 3, -p.height}, across(width / 3), far).hold_y();
  out.line({p.right, -p.height}, across(width / 3), far);
  out.line({p.right, 0}, right, traction(0, p.shear));
  for (size_t k = cut.size(); k-- > 0;) out.line({cut[k].from, 0}, reversed(cut[k].s));
  out.line({p.left, -p.height}, reversed(left), traction(0, -p.shear));
  return out;
}

// Nodes between two tips at -a and a, small there and about `closes`, where faces that close in part would in an infinite
// plate.
std::vector<double> faces(double a, double tip, double ratio, double closes) {
  const double coarse = a / 5, fine = a / 50;
  if (!(std::fabs(closes) < a - 4 * fine)) return graded(2 * a, tip, tip, ratio, coarse);
  const double at = a + closes - fine / 2; // within an element
  std::vector<double> s = graded(at, tip, fine, ratio, coarse);
  const std::vector<double> rest = graded(2 * a - at, fine, tip, ratio, coarse);
  for (size_t i = 1; i < rest.size(); ++i) s.push_back(at + rest[i]);
  return s;
}

// Stress intensity by the handbook, and how good it says its formulas are; alpha = a / W, root = sqrt(pi a).
std::vector<std::string> centre_formulas(double alpha, double root) {
  const double F = (1 - 0.025 * alpha * alpha + 0.06 * std::pow(alpha, 4)) / std::sqrt(std::cos(std::acos(0.0) * alpha));
  return {"Tension: K1 = " + show(F * root) + " tension (0.1 %).",
          "In an infinite plate bending alone closes the faces from -a to -a/3, and K1 = " +
              show(alpha * std::sqrt(8.0 / 27) * root) + " bending at x = a;",
          "shear: K2 = " + show(root) + " shear."};
}
std::vector<std::string> edge_formulas(double alpha, double root) {
  const double t = std::acos(0.0) * alpha, x = alpha;
  const double tension = std::sqrt(std::tan(t) / t) * (0.752 + 2.02 * x + 0.37 * std::pow(1 - std::sin(t), 3)) / std::cos(t);
  const double bending = 1.122 - 1.4 * x + 7.33 * x * x - 13.08 * x * x * x + 14 * std::pow(x, 4);
  std::vector<std::string> out = {"Tension: K1 = " + show(tension * root) + " tension (0.5 %)."};
  if (alpha <= 0.6) out.push_back("Bending: K1 = " + show(bending * root) + " bending (0.2 %).");
  return out;
}

const char* const kHandbook = "Reference: H. Tada, P. C. Paris, G. R. Irwin, The Stress Analysis of Cracks Handbook";

ProblemModel build_crack(const Values& v) {
  const double a = v.number("a"), W = v.number("W") * a, tip = a / v.count("n"), ratio = v.number("ratio");
  const bool edge = v.word("shape") == "edge";
  if (v.number("W") < 1.2) return unfit("W is below 1.2");
  if (!(ratio >= 1.05 && ratio <= 2)) return unfit("ratio is to be from 1.05 to 2");
  if (v.count("n") < 10) return unfit("n is below 10");
  const double left = edge ? 0 : -W, width = W - left;
  Plate p{left,           W,         v.number("H") * W, v.number("tension"), v.number("bending"),
          (left + W) / 2, width / 2, v.number("shear"), width / 16};
  if (edge) p.bending = -p.bending; // it opens the mouth
  const double slope = p.bending / p.half,
               closes = edge || slope == 0 ? a : -std::copysign(a / 3, slope) - 4 * p.tension / (3 * slope);
  const std::vector<double> ahead = graded(W - a, tip, 0, ratio, p.coarse);
  std::vector<Part> cut;
  if (edge)
    cut = {{0, graded(a, 0, tip, ratio, a / 5), true}, {a, ahead, false}};
  else
    cut = {{-W, reversed(ahead), false}, {-a, faces(a, tip, ratio, closes), true}, {a, ahead, false}};

  ProblemModel m;
  const double alpha = a / W, root = std::sqrt(std::acos(-1.0) * a);
  m.heading = {
      edge ? "A plate of width W with an edge crack of length a, cut along the crack's line: below (body 1) and above (2),"
           : "A plate of width 2 W with a crack from -a to a, cut along its line: below (body 1) and above (2),",
      "tied ahead of the crack; its faces are a zone of contact. a / W = " + show(alpha) + ", H = " + show(p.height) + ".",
      "At y = H and -H: syy = tension + bending " + std::string(edge ? "(1 - 2 x / W)" : "x / W") + ", sxy = shear."};
  for (const std::string& line : edge ? edge_formulas(alpha, root) : centre_formulas(alpha, root)) m.heading.push_back(line);
  m.heading.push_back(kHandbook);
  m.title = edge ? "EDGE CRACK" : "CENTRAL CRACK";
  m.plane = v.word("plane") == "stress" ? 1 : 0;
  m.function_nodes = v.count("order") + 1;
  m.friction = {v.number("mu")};
  m.bodies = {{v.number("E"), v.number("nu"), {0, 0}, {half_of(p, cut, false)}, "the lower half"},
              {v.number("E"), v.number("nu"), {0, 0}, {half_of(p, cut, true)}, "the upper half"}};
  const int parts = static_cast<int>(cut.size());
  for (int k = 0; k < parts; ++k) {
    ContactZone zone{{0, 4 + parts - 1 - k}, {1, 2 + k}};
    zone.tied = !cut[static_cast<size_t>(k)].cracked;
    zone.without_first = !zone.tied;         // on the right, the tip: its node is the tie's
    zone.without_last = !zone.tied && !edge; // on the left
    m.zones.push_back(zone);
  }
  return m;
}

} // namespace

Family crack_family() {
  return {"crack",
          "a plate with a crack under tension, bending and shear: stress intensity, and faces that close",
          {{"shape", Kind::kChoice, "centre", "centre|edge: where the crack is"},
           {"a", Kind::kPositive, "1", "half length of the crack in the middle; length of that at the edge"},
           {"W", Kind::kPositive, "2", "half width (edge: width) of the plate, over a"},
           {"H", Kind::kPositive, "2.5", "half height of the plate, over W"},
           {"tension", Kind::kNumber, "1", "stress across the crack's line"},
           {"bending", Kind::kNumber, "0", "the same by bending, at the side x = W (edge: at the mouth)"},
           {"shear", Kind::kNumber, "0", "shear stress at all sides"},
           {"mu", Kind::kFriction, "0", "coefficient of friction between the faces"},
           {"E", Kind::kPositive, "100000", "Young's modulus"},
           {"nu", Kind::kPoisson, "0.3", "Poisson's ratio"},
           {"plane", Kind::kChoice, "strain", "strain|stress: plane strain or plane stress"},
           {"n", Kind::kCount, "200", "a over the length of the element at a tip"},
           {"ratio", Kind::kAboveOne, "1.3", "growth of the elements away from a tip"},
           {"order", Kind::kOrder, "2", "of the functions: 1 linear, 2 quadratic, 3 cubic"}},
          build_crack};
}

} // namespace families
