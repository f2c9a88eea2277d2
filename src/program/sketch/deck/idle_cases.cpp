#include "program/sketch/deck/idle_cases.hpp"

#include <algorithm>

namespace sketch {

bool acts(const Sketch& sketch, size_t load_case) {
  const auto any = [load_case](const auto& statements, const auto& loads) {
    return std::any_of(statements.begin(), statements.end(),
                       [&](const auto& s) { return s.load_case == static_cast<int>(load_case) && loads(s); });
  };
  const auto is_given = [](const std::optional<double>& value) { return value.value_or(0) != 0; }; // NaN for a formula: given
  return any(sketch.conditions, [&](const Condition& c) { return is_given(c.value[0]) || is_given(c.value[1]); }) ||
         any(sketch.point_loads, [](const PointLoad& p) { return p.force.x != 0 || p.force.y != 0; }) ||
         any(sketch.body_forces, [](const BodyForce& f) { return f.weight.x != 0 || f.weight.y != 0 || f.rho_omega2 != 0; }) ||
         any(sketch.drives, [&](const Drive& d) {
           return std::any_of(d.motion.begin(), d.motion.end(), is_given) ||
                  std::any_of(d.load.begin(), d.load.end(), is_given);
         });
}

Sketch without_idle_cases(Sketch sketch) {
  std::vector<int> number; // new number of each case; -1: removed
  std::vector<LoadCase> left;
  for (size_t c = 0; c < sketch.cases.size(); ++c) {
    number.push_back(acts(sketch, c) ? static_cast<int>(left.size()) : -1);
    if (number.back() >= 0) left.push_back(sketch.cases[c]);
  }
  if (left.empty()) left.push_back(sketch.cases[0]), number[0] = 0;
  if (left.size() == sketch.cases.size()) return sketch;
  const auto renumber = [&](auto& statements) {
    for (auto& s : statements) s.load_case = std::max(0, number[static_cast<size_t>(s.load_case)]);
  };
  const auto erase_idle = [&](auto& statements) {
    statements.erase(std::remove_if(statements.begin(), statements.end(),
                                    [&](const auto& s) { return number[static_cast<size_t>(s.load_case)] < 0; }),
                     statements.end());
    renumber(statements);
  };
  erase_idle(sketch.point_loads);
  erase_idle(sketch.body_forces);
  renumber(sketch.conditions);
  renumber(sketch.drives);
  for (size_t i = 0; i < sketch.drives.size(); ++i) // merge statements with the same target and case
    for (size_t k = sketch.drives.size(); k-- > i + 1;) {
      Drive &one = sketch.drives[i], &other = sketch.drives[k];
      if (!same_target(one, other) || one.load_case != other.load_case) continue;
      for (size_t c = 0; c < 3; ++c) {
        if (other.motion[c]) one.motion[c] = one.motion[c].value_or(0) + *other.motion[c];
        if (other.load[c]) one.load[c] = one.load[c].value_or(0) + *other.load[c];
      }
      sketch.drives.erase(sketch.drives.begin() + static_cast<std::ptrdiff_t>(k));
    }
  sketch.cases = std::move(left);
  return sketch;
}

} // namespace sketch
