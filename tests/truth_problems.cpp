// The problems of estimate_truth.hpp: small slopes on large blocks, so that closed forms for half planes hold.
#include "estimate_truth.hpp"

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
parameter tolerance 0.01  L 60
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
contact block.top pad.face mu mu
tolerance tolerance
limit seconds 12
case normal
  fix    block.bottom
  platen pad.top  about 0 L  force 0 {-P}  turn 0
)";

struct Hertz {
  double P, a, p0;
  explicit Hertz(double half_width) : P(kPi * kStar * half_width * half_width / (4 * kR)), a(half_width), p0(2 * P / (kPi * a)) {}
};

// On the pad.
std::vector<std::array<double, 2>> both(double x) { return {{{x, x * x / (2 * kR)}}, {{-x, x * x / (2 * kR)}}}; }

} // namespace

Problem hertz(double shift) {
  const Hertz h(std::sqrt(1 + shift));
  Problem out;
  out.name = "Hertz " + brief(shift);
  out.text = set("E", kE) + set("nu", kNu) + set("mu", 0) + set("R", kR) + set("P", h.P) + kBlock + kPad;
  out.known = {{"peak pressure", h.p0}, {"mean pressure", h.P / (2 * h.a)}, {"contact edge", 0, both(h.a)},
               {"force y", h.P}, {"edge pressure", h.p0 * std::sqrt(2 / h.a)}};
  out.tractions = [h](double x) { return std::array<double, 2>{{0, -h.p0 * root(1 - x * x / h.a / h.a)}}; };
  out.half_width = h.a;
  return out;
}

Problem cattaneo(double share, bool back, double shift) {
  const Hertz h(std::sqrt(1 + shift));
  Problem out;
  out.name = "Cattaneo " + brief(share) + (back ? " back " : " ") + brief(shift);
  out.text = set("E", kE) + set("nu", kNu) + set("mu", kMu) + set("R", kR) + set("P", h.P) + set("share", share) + kBlock + kPad +
             "case shear\n  platen pad.top about 0 L force {share*mu*P} 0\nwant pressure edges forces approach dissipation\n"
             "history normal 1; shear 1" + (back ? ", -1, 1\n" : "\n");
  const double c = h.a * std::sqrt(1 - share), k = 1 - share;
  const double cycle = 4 * kMu * kMu * h.P * h.P / (kPi * kStar) * (k * std::log(k) + 1 - k - (1 - k) * (1 - k) / 2);
  out.known = {{"peak pressure", h.p0}, {"mean pressure", h.P / (2 * h.a)}, {"contact edge", 0, both(h.a)},
               {"stick border", 0, both(c)}, {"force y", h.P}, {"edge pressure", h.p0 * std::sqrt(2 / h.a)},
               {"dissipated", (back ? 1.25 : 0.25) * cycle}};
  out.tractions = [h, c](double x) {
    const double q = kMu * h.p0 * (root(1 - x * x / h.a / h.a) - c / h.a * root(1 - x * x / c / c));
    return std::array<double, 2>{{q, -h.p0 * root(1 - x * x / h.a / h.a)}};
  };
  out.half_width = h.a;
  return out;
}

std::vector<Problem> problems() {
  return {hertz(0), hertz(0.13), hertz(0.29), cattaneo(0.1, false, 0), cattaneo(0.6, false, 0), cattaneo(0.6, true, 0), cattaneo(0.9, false, 0.13)};
}

} // namespace truth
