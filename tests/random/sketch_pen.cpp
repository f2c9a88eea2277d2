#include "sketch_pen.hpp"

#include <algorithm>
#include <cstdio>

namespace random_sketches {
namespace {

struct Units {
  const char* words;
  double length, stress; // of what is 10 mm long, and of 1000 N/mm^2
};
constexpr Units kUnits[] = {
    {"mm N", 10, 1000}, {"m N", 0.01, 1e9}, {"um mN", 1e4, 1}, {"in lbf", 0.393700787, 145037.738}, {"a b", 1, 1}};

} // namespace

Pen::Pen(uint64_t seed, Drawn& drawn) : dice(seed), out(drawn), compliance{1, 1} {
  const Units& units = kUnits[dice.whole(0, 4)];
  shorter_ = units.length * dice.power(-0.5, 0.5);
  stress = units.stress * dice.power(-0.5, 2);
  line("title      Random sketch " + std::to_string(static_cast<unsigned long long>(seed)));
  line(std::string("units      ") + units.words);
  if (dice.chance(0.25)) line("plane      stress"), tell("plane stress");
  if (dice.chance(0.1)) line("functions  quadratic"), tell("quadratic");
  friction = dice.chance(0.3) ? 0 : dice.chance(0.2) ? 1 : dice.between(0.05, 0.95);
  char text[40];
  std::snprintf(text, sizeof text, "mu %.2g", friction);
  tell(text);
}

std::string Pen::number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.15g", value);
  return text;
}
std::string Pen::length(double value) const { return number(value * shorter_); }
std::string Pen::force(double value) const { return number(value * shorter_); }
std::string Pen::moment(double value) const { return number(value * shorter_ * shorter_); }

std::string Pen::material(size_t body, bool may_be_rigid) {
  if (may_be_rigid && !rigid[0] && dice.chance(0.15)) {
    rigid[body] = true, compliance[body] = 0;
    tell("rigid body");
    return " rigid";
  }
  const double E = stress * (body == 0 || dice.chance(0.3) ? 1 : dice.power(-2, 2));
  const double choices[] = {0, 0.3, 0.49, dice.between(0, 0.49)};
  const double nu = choices[dice.whole(0, 3)];
  compliance[body] = (1 - nu * nu) / E;
  return " E " + number(E) + " nu " + number(nu);
}

} // namespace random_sketches
