// Boundary conditions at the ends of bisected elements: old ends keep them, new ends get the interpolated values of the
// element.
#include "program/estimate/mesh/cut_body.hpp"

#include <algorithm>

namespace estimate {
namespace {

enum class Kind { kTraction, kDisplacement, kBoth, kNone }; // prescribed quantity in a direction

Kind kind_of(const EndCondition& end, size_t direction) {
  const bool traction = end.codes[direction] == 0, displacement = end.codes[direction + 2] == 0;
  return traction ? (displacement ? Kind::kBoth : Kind::kTraction) : displacement ? Kind::kDisplacement : Kind::kNone;
}

// The prescribed quantity in one direction between two ends of an element with linear functions. A displacement at an end may
// come from the adjacent element: it belongs to this element only if both ends have it and the traction is unknown.
Kind kind_between(Kind a, Kind b, bool in_contact) {
  const auto either = [&](Kind kind) { return a == kind || b == kind; };
  if (either(Kind::kTraction)) return Kind::kTraction;
  if (either(Kind::kNone)) return Kind::kNone;
  if (in_contact) return Kind::kTraction;
  return either(Kind::kDisplacement) ? Kind::kDisplacement : Kind::kTraction;
}

// Value at node i of the bisected element: the interpolation polynomial if all nodal values are known, else the mean of the
// adjacent known values.
double value_between(const std::vector<EndCondition>& ends, size_t load_case, size_t quantity, int32_t i) {
  const int32_t order = static_cast<int32_t>(ends.size()) - 1;
  const auto known = [&](int32_t l) { return ends[CutBody::at(l)].codes[quantity] == 0; };
  const auto value = [&](int32_t l) { return ends[CutBody::at(l)].values[load_case][quantity]; };
  bool all = true;
  for (int32_t l = 0; l <= order; ++l) all = all && known(l);
  if (!all) {
    const int32_t before = i / 2, behind = before + 1;
    if (known(before) && known(behind)) return 0.5 * (value(before) + value(behind));
    return known(before) ? value(before) : known(behind) ? value(behind) : 0;
  }
  double sum = 0;
  for (int32_t l = 0; l <= order; ++l) {
    double shape = 1;
    for (int32_t k = 0; k <= order; ++k)
      if (k != l) shape *= (0.5 * i - k) / (l - k);
    sum += shape * value(l);
  }
  return sum;
}

EndCondition end_between(const std::vector<EndCondition>& ends, int32_t i, bool in_contact) {
  const int32_t order = static_cast<int32_t>(ends.size()) - 1, before = i / 2, behind = before + 1;
  EndCondition out = ends[0];
  for (size_t direction = 0; direction < 2; ++direction) {
    Kind kind;
    if (order == 1)
      kind = kind_between(kind_of(ends[0], direction), kind_of(ends[1], direction), in_contact);
    else // an interior node has only conditions of this element
      kind = kind_of(ends[CutBody::at(before > 0 ? before : behind)], direction);
    out.codes[direction] = kind == Kind::kTraction ? 0 : 1;
    out.codes[direction + 2] = kind == Kind::kDisplacement ? 0 : 1;
    for (size_t c = 0; c < out.values.size(); ++c)
      for (const size_t quantity : {direction, direction + 2})
        out.values[c][quantity] = out.codes[quantity] == 0 ? value_between(ends, c, quantity, i) : 0;
  }
  return out;
}

std::vector<EndCondition> ends_of(c2d_solver* solver, int32_t body, int32_t element, int32_t function_nodes, int32_t cases) {
  std::vector<EndCondition> out(static_cast<size_t>(function_nodes));
  for (int32_t l = 0; l < function_nodes; ++l)
    for (int32_t c = 0; c < cases; ++c) {
      std::array<double, 4> values;
      EndCondition& end = out[CutBody::at(l)];
      need(c2d_get_condition(solver, body, element + 1, l + 1, c + 1, end.codes.data(), values.data()));
      end.values.push_back(values);
    }
  return out;
}

} // namespace

std::vector<EndCondition> cut_conditions(c2d_solver* solver, int32_t body, const CutBody& cut, int32_t load_cases) {
  std::vector<EndCondition> out;
  const int32_t order = cut.function_nodes - 1;
  for (int32_t e = 0; e < cut.elements(); ++e) {
    const std::vector<EndCondition> ends = ends_of(solver, body, e, cut.function_nodes, load_cases);
    const int32_t children = cut.child_count(e);
    for (int32_t child = 0; child < children; ++child)
      for (int32_t l = 0; l < cut.function_nodes; ++l) {
        const int32_t i = children == 1 ? 2 * l : child * order + l;
        const bool was_there = i % 2 == 0;
        out.push_back(was_there ? ends[CutBody::at(i / 2)] : end_between(ends, i, cut.in_contact[CutBody::at(e)]));
      }
  }
  return out;
}

} // namespace estimate
