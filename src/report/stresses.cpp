#include "report/stresses.hpp"

#include "report/cycle.hpp"
#include "report/text.hpp"

#include <cmath>

namespace app {
namespace {

struct Stress {
  double xx, yy, xy, zz, hoop;
  Stress operator-(const Stress& b) const { return {xx - b.xx, yy - b.yy, xy - b.xy, zz - b.zz, hoop - b.hoop}; }
  // The in-plane principal stresses, the larger first.
  double principal(int which) const {
    const double radius = std::hypot(0.5 * (xx - yy), xy);
    return 0.5 * (xx + yy) + (which == 1 ? radius : -radius);
  }
  double von_mises() const {
    const double a = xx - yy, b = yy - zz, c = zz - xx;
    return std::sqrt(0.5 * (a * a + b * b + c * c) + 3.0 * xy * xy);
  }
};
Stress stress_at(const std::vector<double>& numbers, size_t place) {
  const double* n = numbers.data() + place * kStressNumbers;
  return {n[0], n[1], n[2], n[3], n[4]};
}
bool is_left_out(const StressPlace& place, const Stress& stress) { return place.of_grid && std::isnan(stress.xx); }

void add_number(std::string& out, int32_t number) {
  out += ',';
  append_integer(out, number);
}
// No number where there is none along the boundary, nan outside the body.
void add_number(std::string& out, double number) {
  out += ',';
  if (std::isnan(number))
    out += "nan";
  else
    append_number(out, number);
}
void add_hoop(std::string& out, double number) {
  if (std::isnan(number))
    out += ',';
  else
    add_number(out, number);
}

void add_place(std::string& out, const StressPlace& place) {
  for (const int32_t number : {place.body, place.element, place.point}) add_number(out, number);
  for (const double number : {place.x, place.y}) add_number(out, number);
}

// Numbers over a stretch of steps.
struct GridExtent {
  double least = HUGE_VAL, most = -HUGE_VAL;
  void include(double number) {
    least = std::fmin(least, number); // of NaN and a number, the number
    most = std::fmax(most, number);
  }
};

void append_range(std::string& out, const std::vector<Stress>& states) {
  GridExtent hoop, first, mises, between;
  for (size_t i = 0; i < states.size(); ++i) {
    hoop.include(states[i].hoop);
    first.include(states[i].principal(1));
    mises.include(states[i].von_mises());
    between.include(0.0);
    for (size_t k = 0; k < i; ++k) between.include((states[i] - states[k]).von_mises());
  }
  const bool outside = std::isnan(states.front().xx), along = !std::isnan(states.front().hoop);
  add_hoop(out, along ? hoop.least : NAN);
  add_hoop(out, along ? hoop.most : NAN);
  for (const double number : {first.least, first.most, mises.most, between.most}) add_number(out, outside ? NAN : number);
  out += '\n';
}

} // namespace

c2d_status add_end_places(c2d_solver* solver, const Summary& summary, std::vector<StressPlace>& out) {
  const int32_t fields[] = {C2D_END_X, C2D_END_Y};
  std::vector<std::vector<double>> values;
  for (int32_t body = 1; body <= summary.bodies; ++body) {
    if (const c2d_status status = get_ends(solver, summary, body, fields, 2, values); status != C2D_OK) return status;
    for (size_t i = 0; i < values[0].size(); ++i)
      out.push_back({body, static_cast<int32_t>(i) / summary.function_nodes + 1, 0, values[0][i], values[1][i], false});
  }
  return C2D_OK;
}

c2d_status add_end_stresses(c2d_solver* solver, const Summary& summary, std::vector<double>& out) {
  const int32_t fields[kStressNumbers] = {C2D_END_SXX, C2D_END_SYY, C2D_END_SXY, C2D_END_SZZ, C2D_END_HOOP};
  std::vector<std::vector<double>> values;
  for (int32_t body = 1; body <= summary.bodies; ++body) {
    const c2d_status status = get_ends(solver, summary, body, fields, kStressNumbers, values);
    if (status != C2D_OK) return status;
    for (size_t i = 0; i < values[0].size(); ++i)
      for (const std::vector<double>& field : values) out.push_back(field[i]);
  }
  return C2D_OK;
}

void add_point_stresses(const double* row, std::vector<double>& out) {
  const bool outside = static_cast<int>(row[C2D_POINT_FLAG]) == C2D_POINT_OUTSIDE;
  for (const int c : {C2D_POINT_SXX, C2D_POINT_SYY, C2D_POINT_SXY, C2D_POINT_SZZ}) out.push_back(outside ? NAN : row[c]);
  out.push_back(NAN);
}

void append_stresses_header(std::string& out, int32_t load_cases) {
  out += "mu,step,load,body,element,point,x,y,sxx,syy,sxy,szz,hoop,s1,s2,von_mises";
  for (int32_t k = 2; k <= load_cases; ++k) out += ",load" + std::to_string(k);
  out += '\n';
}

void append_stresses_rows(std::string& out, const c2d_step& step, const std::vector<StressPlace>& places,
                          const std::vector<double>& numbers) {
  std::string head, tail;
  append_number(head, step.mu);
  add_number(head, step.step);
  add_number(head, step.load);
  for (int32_t k = 1; k < step.cases; ++k) add_number(tail, step.loads[k]);
  for (size_t i = 0; i < places.size(); ++i) {
    const Stress s = stress_at(numbers, i);
    if (is_left_out(places[i], s)) continue;
    out += head;
    add_place(out, places[i]);
    for (const double number : {s.xx, s.yy, s.xy, s.zz}) add_number(out, number);
    add_hoop(out, s.hoop);
    for (const double number : {s.principal(1), s.principal(2), s.von_mises()}) add_number(out, number);
    out += tail + '\n';
  }
}

void append_ranges(std::string& out, const RunRecord& record, const std::vector<StressPlace>& places) {
  out += "mu,first,last,body,element,point,x,y,hoop_least,hoop_most,s1_least,s1_most,von_mises_most,von_mises_range\n";
  for (const CoefficientRecord& c : record.coefficients) {
    const Cycle cycle = find_cycle(c);
    const size_t begin = cycle.first, end = cycle.any() ? cycle.last + 1 : c.steps.size();
    std::vector<size_t> with;
    for (size_t i = begin; i < end; ++i)
      if (c.steps[i].stresses.size() == places.size() * kStressNumbers) with.push_back(i);
    for (size_t p = 0; p < places.size() && !with.empty(); ++p) {
      std::vector<Stress> states;
      for (const size_t i : with) states.push_back(stress_at(c.steps[i].stresses, p));
      if (is_left_out(places[p], states.front())) continue;
      append_number(out, c.mu);
      for (const size_t i : {with.front(), with.back()}) add_number(out, c.steps[i].step);
      add_place(out, places[p]);
      append_range(out, states);
    }
  }
}

} // namespace app
