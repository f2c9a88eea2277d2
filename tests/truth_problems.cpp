// The problems of estimate_truth.hpp: small slopes on large blocks, so that closed forms for half planes hold.
#include "estimate_truth.hpp"

#include <algorithm>
#include <cmath>

#include <cstdio>

namespace truth {
namespace {

const double kPi = std::acos(-1.0);
constexpr double kE = 200e3, kNu = 0.3, kMu = 0.6, kR = 500; // the contact's half width is about 1
constexpr double kStar = kE / (2 * (1 - kNu * kNu));         // of two bodies of one material

std::string number(double v) {
  char out[32];
  std::snprintf(out, sizeof out, "%.17g", v);
  return out;
}
std::string brief(double v) {
  char out[32];
  std::snprintf(out, sizeof out, "%g", v);
  return out;
}
std::string set(const char* name, double value) { return std::string("parameter ") + name + " " + number(value) + "\n"; }

double root(double x) { return x > 0 ? std::sqrt(x) : 0; }

const char* const kBlock = R"(
parameter tolerance 0.01  L 240
body block E E nu nu
  from {-L} {-L}
  line bottom to L {-L}
  line right  to L 0
  line top    to {-L} 0
  line left   close
)";
const char* const kPad = R"(
body pad E E nu nu
  from {-L} {L^2/(2*R)}
  curve face t {-L} L x t y {t^2/(2*R)}
  line right to L L
  line top   to {-L} L
  line left  close
)";
const char* const kPressed = R"(
contact block.top pad.face mu mu
tolerance tolerance
limit elements 1500
case normal
  fix    block.bottom
  platen pad.top  about 0 L  force 0 {-P}  turn 0
)";

// Behind it the history may go on.
const char* const kPushed = R"(
case shear
  platen pad.top about 0 L force {share*mu*P} 0
want pressure edges forces approach dissipation
history normal 1; shear 1)";

struct Hertz {
  double P, a, p0;
  explicit Hertz(double half_width)
      : P(kPi * kStar * half_width * half_width / (4 * kR)), a(half_width), p0(2 * P / (kPi * a)) {}
};

// What tangential tractions q on |x| < a do to a half plane y < 0 at (x, -depth): xx, yy, xy, by Flamant's solution.
std::array<double, 3> pushed(const test::Callable<double(double)>& q, double a, double x, double depth) {
  std::array<double, 3> out{};
  constexpr int kSteps = 20000;
  for (int i = 0; i < kSteps; ++i) {
    const double t = kPi * ((i + 0.5) / kSteps - 0.5), s = a * std::sin(t), d = x - s, r2 = d * d + depth * depth;
    const double w = -2 / kPi * q(s) * a * std::cos(t) * kPi / kSteps / (r2 * r2);
    out[0] += w * d * d * d, out[1] += w * d * depth * depth, out[2] -= w * d * d * depth;
  }
  return out;
}

// On the pad.
std::vector<std::array<double, 2>> both(double x) { return {{{x, x * x / (2 * kR)}}, {{-x, x * x / (2 * kR)}}}; }

} // namespace

Problem hertz(double shift) {
  const Hertz h(std::sqrt(1 + shift));
  Problem out;
  out.name = "Hertz " + brief(shift);
  out.text = set("E", kE) + set("nu", kNu) + set("mu", 0) + set("R", kR) + set("P", h.P) + kBlock + kPad + kPressed +
             "want pressure edges forces approach  pressure at block.top 0.4 0 -0.8 0 1 %\n";
  out.known = {{"peak pressure", h.p0},
               {"mean pressure", h.P / (2 * h.a)},
               {"contact edge", 0, both(h.a)},
               {"force y", h.P},
               {"edge pressure", h.p0 * std::sqrt(2 / h.a)},
               {"pressure on top", h.p0 * root(1 - 0.16 / h.a / h.a)},
               {"pressure on top", h.p0 * root(1 - 0.64 / h.a / h.a)}};
  out.tractions = [h](double x) { return std::array<double, 2>{{0, -h.p0 * root(1 - x * x / h.a / h.a)}}; };
  out.half_width = h.a;
  return out;
}

Problem cattaneo(double share, bool back, double shift) {
  const Hertz h(std::sqrt(1 + shift));
  Problem out;
  out.name = "Cattaneo " + brief(share) + (back ? " back " : " ") + brief(shift);
  out.text = set("E", kE) + set("nu", kNu) + set("mu", kMu) + set("R", kR) + set("P", h.P) + set("share", share) + kBlock +
             kPad + kPressed + kPushed + (back ? ", -1, 1\n" : "\n");
  if (back) out.text += "want cycle range stress block -1 -0.1  cycle range hoop block.top 1 %\n";
  const double c = h.a * std::sqrt(1 - share), k = 1 - share;
  const double cycle = 4 * kMu * kMu * h.P * h.P / (kPi * kStar) * (k * std::log(k) + 1 - k - (1 - k) * (1 - k) / 2);
  out.known = {{"peak pressure", h.p0},
               {"mean pressure", h.P / (2 * h.a)},
               {"contact edge", 0, both(h.a)},
               {"stick border", 0, both(c)},
               {"force y", h.P},
               {"edge pressure", h.p0 * std::sqrt(2 / h.a)},
               {"dissipated", (back ? 1.25 : 0.25) * cycle}};
  out.tractions = [h, c](double x) {
    const double q = kMu * h.p0 * (root(1 - x * x / h.a / h.a) - c / h.a * root(1 - x * x / c / c));
    return std::array<double, 2>{{q, -h.p0 * root(1 - x * x / h.a / h.a)}};
  };
  out.half_width = h.a;
  if (!back) return out;
  const auto friction = [tractions = out.tractions](double x) { return tractions(x)[0]; };
  const std::array<double, 3> range = pushed(friction, h.a, -1, 0.1); // half of it: the tractions turn round
  out.known.push_back({"dissipated in the last cycle", cycle});
  out.known.push_back({"cycle range of stress xx", 2 * std::fabs(range[0])});
  out.known.push_back({"cycle range of stress yy", 2 * std::fabs(range[1])});
  out.known.push_back({"cycle range of stress xy", 2 * std::fabs(range[2])});
  out.known.push_back({"cycle range of stress along top", 4 * kMu * h.p0 * std::sqrt(share)});
  return out;
}

Problem rounded_punch(double b, double share) {
  const double f0 = std::asin(b), part = kPi - 2 * f0, P = kStar / kR * (part - std::sin(2 * f0)) / 4;
  const auto pressure = [=](double x) {
    if (std::fabs(x) >= 1) return 0.0;
    const double f = std::asin(x);
    return 2 * P / (kPi * (part - std::sin(2 * f0))) *
           (part * std::cos(f) + std::sin(f) * std::log(std::fabs(std::sin(f + f0) / std::sin(f - f0))) +
            std::sin(f0) * std::log(std::fabs(std::tan((f + f0) / 2) * std::tan((f - f0) / 2))));
  };
  double peak = 0;
  for (int i = 1; i < 100000; ++i) peak = std::max(peak, pressure(i * 1e-5 + 1e-9));
  Problem out;
  out.name = "rounded " + brief(b) + " " + brief(share);
  out.text = set("E", kE) + set("nu", kNu) + set("mu", share > 0 ? kMu : 0) + set("R", kR) + set("P", P) + set("b", b) +
             set("share", share) + kBlock + R"(
parameter h {(L - b)^2/(2*R)}
body pad E E nu nu
  from {-L} h
  curve face t {-L} {-b} x t y {(t + b)^2/(2*R)}
  line  face to b 0
  curve face t b L x t y {(t - b)^2/(2*R)}
  line right to L L
  line top   to {-L} L
  line left  close
)" + kPressed;
  if (share > 0) out.text += kPushed;
  const double y = (1 - b) * (1 - b) / (2 * kR);
  out.known = {{"peak pressure", peak}, {"mean pressure", P / 2}, {"contact edge", 0, {{{1, y}}, {{-1, y}}}}, {"force y", P}};
  if (share == 0) out.tractions = [pressure](double x) { return std::array<double, 2>{{0, -pressure(x)}}; };
  out.half_width = 1;
  return out;
}

// A layer that lifts off: tests/data/reference/p02. The half width of contact over the thickness depends on the stiffnesses
// alone.
Problem receding_layer(double stiffness) {
  const bool equal = stiffness == 1;
  const double a = equal ? 1.3241653718676933 : 1.836300638935971, peak = equal ? 0.7130805511737414 : 0.5394575709930005;
  Problem out;
  out.name = "receding layer " + brief(stiffness);
  out.text = set("stiffness", stiffness) + R"(
parameter tolerance 0.01  L 60  E 1e5  nu 0.3
symmetry x 0
body base E E nu nu
  from 0 {-L}
  line bottom to L {-L}
  line right  to L 0
  line top    to 0 0
body layer E {stiffness*E} nu nu
  from 0 0
  line face to 5 0
  line end  to 5 1
  line top  to 0.02 1
  line load to 0 1
contact base.top layer.face
fix base.bottom
traction layer.load y -25
tolerance tolerance
limit elements 1500
)";
  out.known = {{"peak pressure", peak}, {"mean pressure", 0.5 / a}, {"contact edge", 0, {{{a, 0}}}}};
  out.half_width = a;
  return out;
}

// A disc of the plate's material in a hole that it fits exactly; half angle of contact and peak of
// tests/data/reference/p08, over the stress far away.
Problem disc_in_hole(bool pulled) {
  const double angle = (pulled ? 19.62506010432921 : 56.97288043400285) * kPi / 180;
  Problem out;
  out.name = std::string("disc in hole, ") + (pulled ? "pulled" : "pressed");
  out.text = set("sx", pulled ? 1 : 0) + set("sy", pulled ? 0 : -1) + R"(
parameter tolerance 0.01  L 400  E 1e5  nu 0.3
symmetry x 0
symmetry y 0
body plate E E nu nu
  from L 0
  line right to L L
  line top   to 0 L
  outline
  from 0 1
  arc hole to 1 0 centre 0 0 right
body disc E E nu nu
  from 1 0
  arc face to 0 1 centre 0 0
contact plate.hole disc.face
traction plate.right x sx
traction plate.top y sy
tolerance tolerance
limit elements 1500
)";
  out.known = {{"peak pressure", pulled ? 0.6090826758968362 : 1.2813590670454869},
               {"contact edge", 0, {{{std::sin(angle), std::cos(angle)}}}}};
  out.half_width = angle;
  return out;
}

std::vector<Problem> problems() {
  return {hertz(0),
          hertz(0.13),
          hertz(0.29),
          cattaneo(0.1, false, 0),
          cattaneo(0.6, false, 0),
          cattaneo(0.6, true, 0),
          cattaneo(0.9, false, 0.13),
          rounded_punch(0.2, 0),
          rounded_punch(0.5, 0),
          rounded_punch(0.8, 0),
          rounded_punch(0.9, 0),
          rounded_punch(0.8, 0.6),
          receding_layer(1),
          receding_layer(3),
          disc_in_hole(true),
          disc_in_hole(false)};
}

} // namespace truth
