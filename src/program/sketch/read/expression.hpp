// Arithmetic in a sketch: + - * / ^, brackets, functions, `pi`, `deg` (of an angle: 30*deg), parameters by name, and variables:
// one, by which a value has its first two derivatives, so that a curve may be given by formulas, or x and y of a place.
#pragma once

#include "program/sketch/read/words.hpp"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace sketch {

// A value and its first two derivatives.
struct Jet {
  double v = 0, d = 0, dd = 0;
};

using Parameters = std::map<std::string, double>;

class Expression {
public:
  using Variables = std::array<std::string, 2>; // their names, empty for none; they go before parameters
  // Throws a Fault at the place of what cannot be read, in `word` or within it.
  Expression(const Word& word, const Parameters& parameters, const Variables& variables = {});
  Jet at(double first) const { return result({first, 1, 0}, {}); }
  double at(double first, double second) const { return result({first}, {second}).v; }
  double value() const { return at(0).v; }
  bool varies() const;

private:
  friend class Parser;
  Jet result(const Jet& first, const Jet& second) const;
  struct Step {
    enum Kind { kConstant, kVariable, kFunction } kind;
    double value; // of a constant
    int index;    // of a function, of a variable
  };
  std::vector<Step> steps_; // in the order in which a stack takes them
};

} // namespace sketch
