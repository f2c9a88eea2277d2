// Tolerances of parameters: how wanted numbers change with them, and how far they may be off.
#pragma once

#include "post/stated.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace app {

struct ToleranceOf { // a parameter
  std::string name;
  double value = 0, size = 0; // the value may be off by `size`
  std::string why;            // why no number has a derivative by it; empty: some may have
};

// Of a number by a parameter.
struct Influence {
  double derivative = NAN; // NaN: not usable
  std::string why;         // the reason
};

struct Toleranced {
  Stated number;
  std::vector<Influence> by; // one per parameter
};

struct ToleranceTable {
  std::vector<ToleranceOf> parameters;
  std::vector<Toleranced> numbers;
  std::string why; // why there are no numbers; empty: there are
  bool any() const { return !parameters.empty(); }
  std::string name_of(const Toleranced& t) const {
    return t.number.item > 0 ? t.number.name() + " " + std::to_string(t.number.item) : t.number.name();
  }
  bool is_of_several_zones() const {
    int32_t zone = 0;
    for (const Toleranced& t : numbers) {
      if (t.number.zone > 0 && zone > 0 && t.number.zone != zone) return true;
      if (t.number.zone > 0) zone = t.number.zone;
    }
    return false;
  }
  // |derivative| times tolerance; NaN: no usable derivative.
  double share(const Toleranced& t, size_t parameter) const {
    return std::fabs(t.by[parameter].derivative) * parameters[parameter].size;
  }
  // The sum of the shares, and the root of the sum of their squares; NaN if one is missing.
  double worst_case(const Toleranced& t) const {
    double sum = 0;
    for (size_t p = 0; p < parameters.size(); ++p) sum += share(t, p);
    return sum;
  }
  double root_of_squares(const Toleranced& t) const {
    double sum = 0;
    for (size_t p = 0; p < parameters.size(); ++p) sum += share(t, p) * share(t, p);
    return std::sqrt(sum);
  }
};

} // namespace app
