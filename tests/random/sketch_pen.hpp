#pragma once
// What the scenes of random sketches are written with: lengths in the units of the sketch, materials, cases, wants.
#include "../dice.hpp"
#include "sketches.hpp"

#include <string>

namespace random_sketches {

using random_decks::Dice;

class Pen {
public:
  Pen(uint64_t seed, Drawn& out);
  Dice dice;
  Drawn& out;
  double stress = 1;    // the lesser of two moduli is about this
  double friction = 0;  // of this scene
  double compliance[2]; // (1 - nu^2)/E of the bodies in order of their drawing
  void line(const std::string& text) { out.text += text + "\n"; }
  void tell(const std::string& words) { out.scene += (out.scene.empty() ? "" : ", ") + words; }
  std::string xy(double x, double y) const { return length(x) + " " + length(y); }
  std::string length(double value) const;                // in the sketch's unit
  std::string force(double stress_times_length) const;   // per thickness
  std::string moment(double stress_times_length2) const; // likewise
  static std::string number(double value);
  std::string mu() const { return friction > 0 ? " mu " + number(friction) : ""; }
  std::string material(size_t body, bool may_be_rigid = false); // " E 1 nu 0.3", or " rigid"
  bool rigid[2] = {false, false};
  double modulus() const { return 1 / (compliance[0] + compliance[1]); }
  double shorter_ = 1; // length unit
};

} // namespace random_sketches
