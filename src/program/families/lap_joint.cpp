// A lap joint: two plates clamped between washers, with a stud; pulled until they slip and the stud bears.
#include "program/families/family.hpp"
#include "program/families/shapes.hpp"

#include <algorithm>
#include <cmath>

namespace families {
namespace {

struct Joint {
  double thickness, lap, length, washer; // half lengths of the lap and of the washers
  double stud, hole, chamfer, reach;     // half widths of stud and slots; how far the stud stands in either plate
  int n;                                 // elements over the thickness
};

// A point of the lower plate, or, turned by half a turn, of the upper one.
Point place(bool upper, double x, double y) { return upper ? Point{-x, -y} : Point{x, y}; }

// Sides: 0 outside, 1 under the washer, 2 outside, 3 end in the lap, 4 facing, 5 chamfer, 6 wall zone, 7 wall, 8 bottom of the
// slot, 9 below the stud, 10 bottom, 11 wall, 12 wall zone, 13 chamfer, 14 facing, 15 outside, 16 far end.
Outline plate(const Joint& j, bool upper, double zone, double depth) {
  const double t = j.thickness, h = t / j.n, k = j.chamfer, w = j.hole, fine = h / 4;
  const auto straight = [&](double length) { return equal(length, std::max(2, static_cast<int>(std::ceil(length / h)))); };
  const auto at = [&](double x, double y) { return place(upper, x, y); };
  const std::vector<double> under = graded(2 * j.washer, fine, fine, 1.5, h),
                            facing = graded(j.lap - w - k, fine, fine, 1.5, h);
  const std::vector<double> wall = graded(zone - k, fine / 2, fine / 2, 1.5, h / 2);
  Outline out(at(-j.length, -t));
  out.line(at(-j.washer, -t), graded(j.length - j.washer, 0, fine, 1.5, 2 * h));
  out.line(at(j.washer, -t), under);
  out.line(at(j.lap, -t), graded(j.lap - j.washer, fine, 0, 1.5, h));
  out.line(at(j.lap, 0), straight(t));
  out.line(at(w + k, 0), facing);
  out.line(at(w, -k), equal(k, 2));
  out.line(at(w, -zone), wall);
  out.line(at(w, -depth), equal(1, 2));
  out.line(at(j.stud, -depth), equal(1, 1));
  out.line(at(-j.stud, -depth), graded(2 * j.stud, fine / 2, fine / 2, 1.5, h / 2));
  out.line(at(-w, -depth), equal(1, 1));
  out.line(at(-w, -zone), equal(1, 2));
  out.line(at(-w, -k), wall);
  out.line(at(-w - k, 0), equal(k, 2));
  out.line(at(-j.lap, 0), facing);
  out.line(at(-j.length, 0), graded(j.length - j.lap, fine, 0, 1.5, 2 * h));
  out.line(at(-j.length, -t), straight(t), roller_x());
  return out;
}

// Sides: 0 foot, 1 right, 2 lower zone, 3 middle, 4 upper zone, 5 top, 6 upper zone, 7 middle, 8 lower zone, 9 left.
Outline stud_of(const Joint& j, double zone) {
  const double r = j.stud, k = j.chamfer, h = j.thickness / j.n, fine = h / 8;
  const std::vector<double> lower = graded(zone - k, fine, fine, 1.5, h / 2),
                            upper = graded(j.reach - k, fine, fine, 1.5, h / 2);
  Outline out({-r, -j.reach});
  out.line({r, -j.reach}, graded(2 * r, fine, fine, 1.5, h / 2));
  out.line({r, -zone}, equal(1, 2));
  out.line({r, -k}, lower);
  out.line({r, k}, equal(1, 4));
  out.line({r, j.reach}, upper);
  out.line({-r, j.reach}, equal(2 * r, std::max(2, static_cast<int>(4 * r / h))));
  out.line({-r, k}, upper);
  out.line({-r, -k}, equal(1, 4));
  out.line({-r, -zone}, lower);
  out.line({-r, -j.reach}, equal(1, 2));
  return out;
}

// Sides: 0 on the plate, 1, 2, 3 outside.
Outline washer(const Joint& j, bool upper) {
  const double t = j.thickness, h = t / j.n, far = 1.5 * t;
  Outline out(place(upper, j.washer, -t));
  out.line(place(upper, -j.washer, -t), graded(2 * j.washer, h / 4, h / 4, 1.5, h));
  out.line(place(upper, -j.washer, -far), equal(1, 2));
  out.line(place(upper, j.washer, -far), equal(1, 4));
  out.line(place(upper, j.washer, -t), equal(1, 2));
  return out;
}

std::vector<std::string> heading_of(const Values& v) {
  const double clamp = v.number("N"), mu = v.number("mu");
  return {"Two plates (bodies 1 and 2) clamped by N = " + show(clamp) + " between smooth rigid washers (4 and 5), with a stud",
          "(3) that is bonded into the lower plate. Load case 2 pulls the upper plate's end by " + show(v.number("pull")) + ".",
          "The plates slip at mu N = " + show(mu * clamp) + "; when the gap " + show(v.number("gap")) +
              " beside the stud has closed, the stud bears",
          "what goes beyond. The pull is friction and bearing, friction mu N once all of the contact slips.",
          "Reference: balance of forces, Coulomb's law"};
}

// Load case 2 pulls at the elements of a side of the upper plate.
std::vector<std::string> keywords_of(const Values& v, const Outline::Side& end) {
  return {"*CASES 2",
          "case 2",
          "condition 2 " + std::to_string(end.first + 1) + "-" + std::to_string(end.first + end.elements) + " 0  0.0 0.0 " +
              show(v.number("pull")) + " 0.0",
          "*PATH",
          "1 1.0 0.0",
          std::to_string(v.count("steps")) + " 1.0 1.0"};
}

ProblemModel build(const Values& v) {
  const double t = v.number("t"), clamp = v.number("N"), mu = v.number("mu"), gap = v.number("gap"), E = v.number("E");
  if (!std::isfinite(mu)) return unfit("mu is to be finite");
  const double stud = v.number("d") / 2, nu = v.number("nu");
  Joint j{t, v.number("lap") / 2, v.number("L"), 0, stud, stud + gap, t / 10, t / 2, v.count("n")};
  j.washer = std::min(j.lap / 2, j.hole + t);
  if (gap > stud / 2) return unfit("gap is above d / 4");
  if (j.washer >= j.lap || j.hole + j.chamfer > j.lap / 2) return unfit("lap is below 4 d");
  if (j.length <= j.lap) return unfit("L is not above half the lap");
  const double lower = 0.8 * j.reach, upper = j.reach; // where the zones of the walls end
  const Outline top = plate(j, true, upper, 1.2 * j.reach);

  ProblemModel m;
  m.heading = heading_of(v);
  m.title = "LAP JOINT";
  m.function_nodes = v.count("order") + 1;
  m.friction = {mu};
  const RigidModel held{RigidModel::kHeld}, pressed{RigidModel::kLoaded, {0, t}, "Y", {{0, -clamp, 0}}};
  const RigidModel loose{v.word("stud") == "rigid" ? RigidModel::kLoaded : RigidModel::kElastic, {0, 0}, "", {}};
  m.bodies = {{E, nu, {0, 0}, {plate(j, false, lower, j.reach)}, "the lower plate"},
              {E, nu, {0, 0}, {top}, "the upper plate"},
              {E, nu, {0, 0}, {stud_of(j, lower)}, "the stud", loose},
              {E, nu, {0, 0}, {washer(j, true)}, "the upper washer", pressed},
              {E, nu, {0, 0}, {washer(j, false)}, "the lower washer", held}};
  const std::vector<double> smooth = {0.0};
  const auto zone = [&](ZoneSide a, ZoneSide b) { return ContactZone{a, b, false, false, smooth}; };
  m.zones = {{{0, 4}, {1, 14}},     {{0, 14}, {1, 4}},    zone({1, 6}, {2, 6}), zone({1, 12}, {2, 4}), zone({0, 6}, {2, 2}),
             zone({0, 12}, {2, 8}), zone({1, 1}, {3, 0}), zone({0, 1}, {4, 0}), tie({0, 9}, {2, 0})};
  m.keywords = keywords_of(v, top.sides()[16]);
  return m;
}

} // namespace

Family lap_joint_family() {
  return {"lap_joint",
          "two plates clamped between washers, with a stud, pulled: friction, slip and bearing",
          {{"N", Kind::kPositive, "1", "force that clamps the plates"},
           {"mu", Kind::kFriction, "0.3", "coefficient of friction between the plates"},
           {"pull", Kind::kPositive, "0.03", "how far the upper plate's end is pulled"},
           {"steps", Kind::kCount, "12", "increments of the pull"},
           {"gap", Kind::kPositive, "0.01", "between stud and slots, on each side"},
           {"stud", Kind::kChoice, "elastic", "elastic|rigid: the stud"},
           {"t", Kind::kPositive, "1", "thickness of each plate"},
           {"d", Kind::kPositive, "1", "width of the stud"},
           {"lap", Kind::kPositive, "6", "length of the lap"},
           {"L", Kind::kPositive, "8", "of each plate, from the stud's middle to its end"},
           {"E", Kind::kPositive, "1000", "Young's modulus of plates and stud"},
           {"nu", Kind::kPoisson, "0.3", "their Poisson's ratio"},
           {"n", Kind::kCount, "5", "elements over the thickness; they are smaller at edges of contacts"},
           {"order", Kind::kOrder, "1", "of the functions: 1 linear, 2 quadratic, 3 cubic"}},
          build};
}

} // namespace families
