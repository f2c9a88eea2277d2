// Cattaneo and Mindlin: a cylinder pressed on a half plane and then moved sideways, to and fro.
#include "program/families/family.hpp"
#include "program/families/shapes.hpp"

#include <algorithm>
#include <cmath>

namespace families {
namespace {

// Half a cylinder that goes on upwards as a block of its width: its flanks guide it. Sides: 0 left arc, 1
// zone, 2 right arc, 3 right flank, 4 top, 5 left flank.
Outline guided_cylinder(const std::vector<double>& zone, double radius, double ratio, double pressure) {
  Outline out = whole_cylinder_arcs(zone, radius, ratio);
  out.line({radius, 2 * radius}, equal(radius, 4), roller_x());
  out.line({-radius, 2 * radius}, equal(2 * radius, 8), traction(0, -pressure));
  out.line({-radius, radius}, equal(radius, 4), roller_x());
  return out;
}

std::string move_flank(const Outline& body, size_t side, double ux) {
  const Outline::Side& s = body.sides()[side];
  return "condition 2 " + std::to_string(s.first + 1) + "-" + std::to_string(s.first + s.elements) + " 0  0.0 0.0 " + show(ux) +
         " 0.0";
}

// Elements of about a/n in the middle; near the edge so small that six lie in the zone that slips at Q, half the contact
// less the half width sqrt(1 - Q) that sticks; the edge is in the middle of one. In between, and outside, they grow.
std::vector<ZoneRun> zone_runs(double a, int n, double Q) {
  constexpr double kGrowth = 1.4;
  const double coarse = a / (n - 0.5), slip = a * (1 - std::sqrt(1 - Q)), fine = std::min(coarse, slip / 6);
  const double outside = (n + 3) / 4 * coarse;
  if (1.2 * slip + 2 * coarse > a) { // slip nearly everywhere: equal elements
    const int count = std::max(n, static_cast<int>(std::ceil(a / fine + 0.5)));
    return {{a / (count - 0.5), count + (count + 3) / 4 + 1}};
  }
  if (fine == coarse) return {{coarse, n + (n + 3) / 4 + 1}};
  std::vector<ZoneRun> inwards;
  const int edge = static_cast<int>(std::ceil(1.2 * slip / fine));
  double rest = a + 0.5 * fine - (edge + 1) * fine;
  for (double size = fine * kGrowth; size < coarse && rest > size + coarse; size *= kGrowth) {
    inwards.push_back({size, 1});
    rest -= size;
  }
  const int equal = std::max(1, static_cast<int>(std::round(rest / coarse)));
  std::vector<ZoneRun> out{{rest / equal, equal}};
  out.insert(out.end(), inwards.rbegin(), inwards.rend());
  out.push_back({fine, edge + 4});
  double beyond = 3.5 * fine;
  for (double size = fine * kGrowth; beyond < outside; size = std::min(coarse, size * kGrowth)) {
    out.push_back({size, 1});
    beyond += size;
  }
  return out;
}

ProblemModel build_mindlin(const Values& v) {
  const double radius = v.number("R"), a = v.number("a"), size = v.number("L") * a, ratio = v.number("ratio");
  const double E = v.number("E"), nu = v.number("nu"), mu = v.number("mu"), Q = v.number("Q");
  if (a > 0.1 * radius) return unfit("a is above R/10: the formulas are for small contacts");
  if (size < 3 * a) return unfit("L is below 3");
  if (!std::isfinite(mu) || mu <= 0) return unfit("mu is to be above 0 and finite");
  if (Q <= 0) return unfit("Q is to be above 0: without friction nothing slips");
  if (Q >= 1) return unfit("Q is to be below 1, where all of the contact slides");
  const int n = v.count("n"), steps = v.count("steps");
  const double pi = std::acos(-1.0), compliance = 2 * (1 - nu * nu) / E;
  const double load = pi * a * a / (4 * radius * compliance);
  const std::vector<double> zone = cylinder_zone(radius, zone_runs(a, n, Q));

  // How far the flanks move for Q mu P: logarithmic in the sizes, as half planes are; the constant is what
  // the shear of block and cylinder and the slip were found to add.
  const double log_size = std::log(4 * radius / a) + std::log(2 * size / a) + 12;
  const double stuck = compliance / pi * log_size * Q * mu * load;
  const double move = v.number("move") > 0 ? v.number("move") : stuck;

  ProblemModel m;
  m.heading = {"A cylinder (body 2) pressed on a half plane (body 1) of the same material by P, then moved",
               "sideways to and fro at constant P (load case 2 moves its flanks).",
               "R = " + show(radius) + ", half width a = " + show(a) + ", P = " + show(load) + ", mu P = " + show(mu * load) +
                   "; Q is the sum of the friction",
               "Stick |x| < c, c/a = sqrt(1 - Q / (mu P)); after the turn 1 - Q / (mu P) gives way to",
               "1 - (Qmax - Q) / (2 mu P). Flanks move by " + show(move) +
                   (v.number("move") > 0 ? "." : ", which makes Q about " + show(Q) + " mu P."),
               "Reference: C. Cattaneo, 1938; R. D. Mindlin and H. Deresiewicz, 1953"};
  m.title = "CYLINDER MOVED SIDEWAYS TO AND FRO";
  m.function_nodes = v.count("order") + 1;
  m.friction = {mu};
  const Outline cylinder = guided_cylinder(zone, radius, ratio, load / (2 * radius));
  m.bodies = {{E, nu, {0, 0}, {whole_block({zone, size, ratio})}, "the half plane"},
              {E, nu, {0, radius}, {cylinder}, "the cylinder"}};
  m.zones = {contact(3, 1)};
  m.keywords = {"*CASES 2", "case 2", move_flank(cylinder, 3, move), move_flank(cylinder, 5, move), "*PATH"};
  const auto piece = [&](int increments, double factor) {
    m.keywords.push_back(std::to_string(increments) + " 1.0 " + show(factor));
  };
  piece(1, 0);
  piece(steps, 1);
  for (int i = 0; i < v.count("cycles"); ++i) piece(2 * steps, -1), piece(2 * steps, 1);
  return m;
}

} // namespace

Family mindlin_family() {
  return {"mindlin",
          "a cylinder pressed on a half plane and moved sideways to and fro: Cattaneo, Mindlin",
          {{"mu", Kind::kFriction, "0.3", "coefficient of friction"},
           {"Q", Kind::kFraction, "0.6", "largest tangential load over mu P, about"},
           {"move", Kind::kNumber, "0", "how far the flanks move; 0: so that it makes Q"},
           {"cycles", Kind::kCount, "1", "how often to and fro"},
           {"steps", Kind::kCount, "4", "increments from no tangential load to the largest"},
           {"R", Kind::kPositive, "200", "radius of the cylinder"},
           {"a", Kind::kPositive, "1", "half width of the contact; gives P"},
           {"E", Kind::kPositive, "1000", "Young's modulus of both"},
           {"nu", Kind::kPoisson, "0.3", "Poisson's ratio of both"},
           {"n", Kind::kCount, "20", "elements over a, were they equal; six at least in what slips at Q"},
           {"L", Kind::kPositive, "200", "half width and depth of the block, over a"},
           {"ratio", Kind::kAboveOne, "1.3", "growth of the elements away from the contact"},
           {"order", Kind::kOrder, "1", "of the functions: 1 linear, 2 quadratic, 3 cubic"}},
          build_mindlin};
}

} // namespace families
