// Arithmetic in a sketch: + - * / ^, brackets, functions, `pi`, `deg` (30*deg is an angle in radians), parameters by name, and
// variables. A formula of a curve has one variable and gives two derivatives by it; a formula of a place has x and y.
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
  using Variables = std::array<std::string, 2>; // their names, empty for none; they take precedence over parameters
  // Throws a Fault at the place of an error within `word`.
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
  std::vector<Step> steps_; // in the order of evaluation on a stack
};

} // namespace sketch
