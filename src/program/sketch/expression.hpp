// Arithmetic in a sketch: + - * / ^, brackets, functions, `pi`, `deg` (of an angle: 30*deg), parameters by name, and at most
// one variable. A value comes with its first two derivatives by the variable, so that a curve may be given by formulas.
#pragma once

#include "program/sketch/words.hpp"

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
  // Throws a Fault at the place of what cannot be read, in `word` or within it. `variable`: its name, empty for none.
  Expression(const Word& word, const Parameters& parameters, const std::string& variable = "");
  Jet at(double variable) const;
  double value() const { return at(0).v; }

private:
  friend class Parser;
  struct Step {
    enum Kind { kConstant, kVariable, kFunction } kind;
    double value; // of a constant
    int index;    // of a function
  };
  std::vector<Step> steps_; // in the order in which a stack takes them
};

} // namespace sketch
