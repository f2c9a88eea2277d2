// c2d_add_curve: given surfaces between boundary points.
#include <string.h>

#include "contact/slip_path.hpp"
#include "interface/model/zone_calls.hpp"
#include "memory/parts.hpp"
#include "model/slip_gap.hpp"
#include "model/validate/validate.hpp"

const c2d::CurvePart c2d::kCurvePart = {true, validate_curves, find_slip_gaps, aim_gaps, slip_gap};

using namespace c2d;

extern "C" c2d_status c2d_add_curve(c2d_solver* s, const c2d_curve* curve) {
  c2d_status status = enter_building(s);
  c2d_curve ours;
  if (status == C2D_OK) status = take(s, "c2d_curve", curve, ours);
  if (status != C2D_OK) return status;
  ModelHeader& head = s->model;
  if (ours.kind < C2D_CURVE_LINE || ours.kind > C2D_CURVE_SPLINE)
    return refuse(s, C2D_ERR_ARGUMENT, "kind of a curve: expected C2D_CURVE_LINE, _ARC or _SPLINE");
  status = check_ranges(s, {{"c2d_curve.body", ours.body, 1, s->sizes.bodies}});
  if (status != C2D_OK) return status;
  const Model m = model_of(s);
  const int b = ours.body - 1;
  const int32_t elements = m.body[b].elements;
  const int32_t ends[2] = {ours.first_element, ours.last_element};
  for (const int32_t element : ends)
    if (!in_range(element, 1, elements)) return refuse_number(s, C2D_ERR_ARGUMENT, "element of a curve", element, 1, elements);
  if (ours.first_element > ours.last_element ||
      region_of_element(m, b, ours.first_element - 1) != region_of_element(m, b, ours.last_element - 1))
    return refuse(s, C2D_ERR_ARGUMENT, "elements of a curve: expected a range of one region, going up");
  const bool arc = ours.kind == C2D_CURVE_ARC;
  if (arc && !(is_usable(ours.centre[0]) && is_usable(ours.centre[1]) && is_usable(ours.radius) && ours.radius > 0))
    return refuse(s, C2D_ERR_ARGUMENT, "arc of a curve: expected a usable centre and a radius above zero");
  if (head.curves >= s->sizes.curves) return refuse_limit(s, "curves", s->sizes.curves, head.curves + 1);
  Curve& out = m.curve[head.curves++];
  out = Curve{ours.kind, b, ours.first_element - 1, ours.last_element - 1, head.line, 0, {0.0, 0.0}, 0.0};
  for (int c = 0; arc && c < 2; ++c) out.centre[c] = ours.centre[c];
  if (arc) out.radius = ours.radius;
  return built(s);
}

extern "C" c2d_status c2d_get_curve(c2d_solver* s, int32_t i, c2d_curve* out) {
  c2d_status status = enter(s, kComplete);
  if (status == C2D_OK) status = check_ranges(s, {{"i", i, 1, s->model.curves}});
  if (status != C2D_OK) return status;
  const Curve& curve = model_of(s).curve[i - 1];
  c2d_curve ours;
  memset(&ours, 0, sizeof ours);
  ours.kind = curve.kind;
  ours.body = curve.body + 1;
  ours.first_element = curve.first + 1;
  ours.last_element = curve.last + 1;
  ours.line = curve.line;
  for (int c = 0; c < 2; ++c) ours.centre[c] = curve.centre[c];
  ours.radius = curve.radius;
  return give(s, "c2d_curve", ours, out);
}
