// Point loads, friction and load path.

#include "interface/model/refuse.hpp"
#include "memory/math.hpp"
#include "model/validate/validate.hpp"

#include <string.h>

namespace c2d {

namespace {

// Common part of both calls; `status`: result of their checks.
// Of path segment i, by load case.
double* factors_of(c2d_solver* s, int32_t i) {
  return array_of<double>(s, kPathLoads) + static_cast<int64_t>(i) * s->sizes.load_cases;
}

c2d_status check_factors(c2d_solver* s, const double* load, int32_t count) {
  for (int32_t k = 0; k < count; ++k)
    if (!is_usable(load[k])) return refuse_value(s, "load factor", load[k], "a finite number");
  return C2D_OK;
}

c2d_status refuse_cases(c2d_solver* s, int32_t cases) {
  return refuse_number(s, C2D_ERR_ARGUMENT, "number of load factors (one per load case, that of an interference too)", cases,
                       s->sizes.load_cases, s->sizes.load_cases);
}

c2d_status append_path(c2d_solver* s, c2d_status status, int32_t increments, const double* load, int32_t given) {
  if (status != C2D_OK) return status;
  if (increments < 1) return refuse_number(s, C2D_ERR_ARGUMENT, "number of increments", increments, 1, INT32_MAX);
  status = check_factors(s, load, given);
  if (status != C2D_OK) return status;
  if (s->model.paths >= s->sizes.paths) return refuse_limit(s, "paths", s->sizes.paths, s->model.paths + 1);
  double* factors = factors_of(s, s->model.paths);
  for (int32_t k = 0; k < s->sizes.load_cases; ++k) factors[k] = k < given ? load[k] : 0.0;
  array_of<Path>(s, kPaths)[s->model.paths++] = Path{increments, 0, load[0]};
  return built(s);
}

} // namespace

c2d_status add_factors(c2d_solver* s, int32_t increments, int32_t given, const double* load, int32_t count, bool last) {
  const int32_t cases = s->sizes.load_cases, total = given + count;
  c2d_status status = enter_building(s);
  if (status == C2D_OK && last && total != cases) status = refuse_cases(s, total);
  if (status != C2D_OK || given == 0) return append_path(s, status, increments, load, count);
  status = check_factors(s, load, count);
  const int32_t fits = total <= cases ? count : cases - given; // what is beyond is counted, and refused with the last part
  if (status == C2D_OK && fits > 0)
    memcpy(factors_of(s, s->model.paths - 1) + given, load, static_cast<size_t>(fits) * sizeof *load);
  return status;
}

c2d_status add_load_card(c2d_solver* s, int32_t increments, double load) {
  return append_path(s, enter_building(s), increments, &load, 1);
}

} // namespace c2d

using namespace c2d;

extern "C" c2d_status c2d_add_point_load(c2d_solver* s, int32_t body, int32_t load_case, double x, double y, double fx,
                                         double fy) {
  c2d_status status = enter_building(s);
  if (status == C2D_OK) status = check_body_number(s, body);
  if (status == C2D_OK) status = check_load_case(s, load_case);
  if (status == C2D_OK) status = check_numbers(s, {{"x", x}, {"y", y}, {"fx", fx}, {"fy", fy}});
  if (status != C2D_OK) return status;
  if (s->model.point_loads >= s->sizes.point_loads)
    return refuse_limit(s, "point_loads", s->sizes.point_loads, s->model.point_loads + 1);
  array_of<PointLoad>(s, kPointLoads)[s->model.point_loads++] =
      PointLoad{body - 1, load_case - 1, s->model.line, s->model.column, x, y, fx, fy};
  return built(s);
}

extern "C" c2d_status c2d_set_interference(c2d_solver* s, int32_t load_case) {
  c2d_status status = enter_building(s);
  if (status == C2D_OK) status = check_load_case(s, load_case);
  if (status != C2D_OK) return status;
  s->model.interference = load_case;
  return built(s);
}

extern "C" c2d_status c2d_add_friction(c2d_solver* s, double coefficient) {
  const c2d_status status = enter_building(s);
  if (status != C2D_OK) return status;
  if (!is_coefficient(coefficient)) return refuse_value(s, "coefficient of friction", coefficient, "zero or more");
  if (s->model.coefficients >= s->sizes.coefficients)
    return refuse_limit(s, "coefficients", s->sizes.coefficients, s->model.coefficients + 1);
  const int32_t i = s->model.coefficients++;
  array_of<double>(s, kFriction)[i] = coefficient;
  double* zones = zone_friction(s, i);
  for (int64_t z = 0; z < s->sizes.zones; ++z) zones[z] = -1.0;
  return built(s);
}

extern "C" c2d_status c2d_set_zone_friction(c2d_solver* s, int32_t zone, int32_t i, double coefficient) {
  const c2d_status status = enter_building(s);
  if (status != C2D_OK) return status;
  if (!is_coefficient(coefficient)) return refuse_value(s, "coefficient of friction", coefficient, "zero or more");
  if (!in_range(zone, 1, s->model.zones)) return refuse_number(s, C2D_ERR_ARGUMENT, "contact zone", zone, 1, s->model.zones);
  if (!in_range(i, 1, s->model.coefficients))
    return refuse_number(s, C2D_ERR_ARGUMENT, "number of the coefficient of friction", i, 1, s->model.coefficients);
  zone_friction(s, i - 1)[zone - 1] = coefficient;
  return built(s);
}

extern "C" c2d_status c2d_add_path(c2d_solver* s, int32_t increments, const double* load, int32_t cases) {
  c2d_status status = enter_building(s);
  if (status == C2D_OK && cases != s->sizes.load_cases) return refuse_cases(s, cases);
  if (status == C2D_OK) status = check_pointers(s, {{"load", load}});
  return append_path(s, status, increments, load, cases);
}

extern "C" c2d_status c2d_clear_paths(c2d_solver* s) {
  const c2d_status status = enter_building(s);
  if (status != C2D_OK) return status;
  s->model.paths = 0;
  return built(s);
}
