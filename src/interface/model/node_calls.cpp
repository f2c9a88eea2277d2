// Boundary points: from arrays, along lines and arcs.

#include "interface/model/refuse.hpp"
#include "memory/math.hpp"
#include "model/polar.hpp"
#include "model/validate/validate.hpp"

namespace c2d {

namespace {

c2d_status check_points(c2d_solver* s, int32_t body, int32_t first, int64_t count) {
  const Body& b = body_numbered(s, body);
  if (!b.is_set) return refuse(s, C2D_ERR_ARGUMENT, "give the body before its boundary points");
  if (!in_range(first, 1, b.geometry_nodes))
    return refuse_number(s, C2D_ERR_ARGUMENT, "boundary point number", first, 1, b.geometry_nodes);
  if (count > b.geometry_nodes - first + 1)
    return refuse_number(s, C2D_ERR_ARGUMENT, "last boundary point number",
                         first - 1 < INT32_MAX - count ? first + count - 1 : INT32_MAX, 1, b.geometry_nodes);
  return C2D_OK;
}

c2d_status check_coordinate(c2d_solver* s, double value) {
  if (is_usable(value)) return C2D_OK;
  return refuse_value(s, "a coordinate", value, "a finite number");
}

void set_point(c2d_solver* s, int32_t body, int32_t number, double x, double y) {
  const Model m = model_of(s);
  double* to = m.xy[body - 1] + 2 * static_cast<int64_t>(number - 1);
  to[0] = x;
  to[1] = y;
  m.node_line[body - 1][number - 1] = s->model.line;
}

// Checks of generated points before any is set. The sum of all magnitudes bounds every intermediate value.
c2d_status check_generated(c2d_solver* s, int32_t body, int32_t first, int32_t last, const double* numbers, int32_t count) {
  c2d_status status = check_points(s, body, first, 1);
  if (status == C2D_OK && last <= first)
    status = refuse_number(s, C2D_ERR_ARGUMENT, "last boundary point number", last, static_cast<int64_t>(first) + 1,
                           body_numbered(s, body).geometry_nodes);
  if (status == C2D_OK) status = check_points(s, body, first, static_cast<int64_t>(last) - first + 1);
  double reach = 0.0;
  for (int32_t i = 0; i < count && status == C2D_OK; ++i) {
    status = check_coordinate(s, numbers[i]);
    if (status == C2D_OK) reach += fabs(numbers[i]);
  }
  return status == C2D_OK ? check_coordinate(s, reach) : status;
}

} // namespace
} // namespace c2d

using namespace c2d;

extern "C" c2d_status c2d_set_nodes(c2d_solver* s, int32_t body, int32_t first, int32_t count, const double* xy,
                                    int64_t stride) {
  c2d_status status = enter_building(s);
  if (status == C2D_OK) status = check_body_number(s, body);
  if (status != C2D_OK) return status;
  const Body& b = body_numbered(s, body);
  if (!b.is_set) return refuse(s, C2D_ERR_ARGUMENT, "give the body before its boundary points");
  if (count < 0) return refuse_number(s, C2D_ERR_ARGUMENT, "count", count, 0, b.geometry_nodes);
  if (count == 0) return built(s);
  status = check_points(s, body, first, count);
  if (status == C2D_OK) status = check_array(s, "xy", xy, "stride", stride, 2, count);
  for (int32_t i = 0; i < count && status == C2D_OK; ++i) {
    status = check_coordinate(s, xy[i * stride]);
    if (status == C2D_OK) status = check_coordinate(s, xy[i * stride + 1]);
  }
  if (status != C2D_OK) return status;
  for (int32_t i = 0; i < count; ++i) set_point(s, body, first + i, xy[i * stride], xy[i * stride + 1]);
  return built(s);
}

extern "C" c2d_status c2d_set_line_nodes(c2d_solver* s, int32_t body, int32_t first, int32_t last, const double origin[2],
                                         const double from[2], const double to[2]) {
  c2d_status status = enter_building(s);
  if (status == C2D_OK) status = check_body_number(s, body);
  if (status != C2D_OK) return status;
  status = check_pointers(s, {{"from", from}, {"to", to}});
  if (status != C2D_OK) return status;
  const double x0 = origin ? origin[0] : 0.0, y0 = origin ? origin[1] : 0.0;
  const double numbers[6] = {x0, y0, from[0], from[1], to[0], to[1]};
  status = check_generated(s, body, first, last, numbers, 6);
  if (status != C2D_OK) return status;
  for (int32_t i = 0; i <= last - first; ++i) {
    double point[2];
    point_on_line(from, to, i, last - first, point);
    set_point(s, body, first + i, point[0] + x0, point[1] + y0);
  }
  return built(s);
}

extern "C" c2d_status c2d_set_arc_nodes(c2d_solver* s, int32_t body, int32_t first, int32_t last, const double centre[2],
                                        double radius, double from_degrees, double to_degrees) {
  c2d_status status = enter_building(s);
  if (status == C2D_OK) status = check_body_number(s, body);
  if (status != C2D_OK) return status;
  status = check_pointers(s, {{"centre", centre}});
  if (status != C2D_OK) return status;
  const double numbers[5] = {centre[0], centre[1], radius, from_degrees, to_degrees};
  status = check_generated(s, body, first, last, numbers, 5);
  if (status == C2D_OK && radius < 0.0) status = refuse_value(s, "radius", radius, "at least 0");
  if (status != C2D_OK) return status;
  for (int32_t i = 0; i <= last - first; ++i) {
    double point[2];
    point_on_arc(radius, from_degrees, to_degrees, i, last - first, point);
    set_point(s, body, first + i, point[0] + centre[0], point[1] + centre[1]);
  }
  return built(s);
}
