// Sets of points for interior results: stored with the model, expanded on request.
#include <string.h>

#include "interface/model/refuse.hpp"
#include "model/validate/validate.hpp"

namespace c2d {

namespace {

// Number of points of a set, 0 if its data are invalid, with the reason in `what`.
int32_t points_of(const c2d_points& p, const char** what) {
  *what = "kind of points: expected C2D_POINTS_ONE, _LINE or _GRID";
  if (p.kind < C2D_POINTS_ONE || p.kind > C2D_POINTS_GRID) return 0;
  *what = "a coordinate of the points is not a usable number";
  for (int c = 0; c < 2; ++c)
    if (!is_usable(p.from[c]) || (p.kind != C2D_POINTS_ONE && !is_usable(p.to[c]))) return 0;
  int64_t total = 1;
  for (int c = 0; c < p.kind; ++c) {
    *what = "number of points: expected 1 or more, and in all fewer than 2^31";
    if (p.count[c] < 1) return 0;
    total *= p.count[c];
  }
  return total > INT32_MAX ? 0 : static_cast<int32_t>(total);
}

// Both ends are exact.
double place_between(double from, double to, int32_t i, int32_t count) {
  if (i == 0) return from;
  if (i == count - 1) return to;
  const double part = static_cast<double>(i) / (count - 1);
  return (1.0 - part) * from + part * to;
}

} // namespace
} // namespace c2d

using namespace c2d;

extern "C" c2d_status c2d_add_points(c2d_solver* s, const c2d_points* points) {
  c2d_status status = enter_building(s);
  c2d_points ours;
  if (status == C2D_OK) status = take(s, "c2d_points", points, ours);
  if (status != C2D_OK) return status;
  status = check_ranges(s, {{"c2d_points.body", ours.body, 1, s->sizes.bodies}});
  if (status != C2D_OK) return status;
  const char* what = "";
  if (points_of(ours, &what) == 0) return refuse(s, C2D_ERR_ARGUMENT, what);
  if (s->model.point_sets >= s->sizes.point_sets)
    return refuse_limit(s, "point_sets", s->sizes.point_sets, s->model.point_sets + 1);
  PointSet& set = array_of<PointSet>(s, kPointSets)[s->model.point_sets++];
  set = PointSet{ours.kind, ours.body, {1, 1}, s->model.line, 0, {ours.from[0], ours.from[1]}, {ours.from[0], ours.from[1]}};
  for (int c = 0; c < 2; ++c) {
    if (c < ours.kind) set.count[c] = ours.count[c];
    if (ours.kind != C2D_POINTS_ONE) set.to[c] = ours.to[c];
  }
  return built(s);
}

extern "C" c2d_status c2d_get_points(c2d_solver* s, int32_t i, c2d_points* out) {
  c2d_status status = enter(s, kComplete);
  if (status == C2D_OK) status = check_ranges(s, {{"i", i, 1, s->model.point_sets}});
  if (status != C2D_OK) return status;
  const PointSet& set = array_of<PointSet>(s, kPointSets)[i - 1];
  c2d_points ours;
  memset(&ours, 0, sizeof ours);
  ours.kind = set.kind;
  ours.body = set.body;
  ours.line = set.line;
  for (int c = 0; c < 2; ++c) {
    ours.count[c] = set.count[c];
    ours.from[c] = set.from[c];
    ours.to[c] = set.to[c];
  }
  return give(s, "c2d_points", ours, out);
}

extern "C" c2d_status c2d_expand_points(const c2d_points* points, int32_t first, int32_t count, double* xy, int64_t stride,
                                        int32_t* total) {
  c2d_points p;
  const char* what = "";
  if (!is_begun(points)) return C2D_ERR_ARGUMENT;
  copy_in(points, &p, sizeof p);
  const int32_t items = points_of(p, &what);
  if (items == 0) return C2D_ERR_ARGUMENT;
  if (count < 0 || first < 1 || first - 1 > items || count > items - (first - 1)) return C2D_ERR_ARGUMENT;
  if (count > 0 && (!xy || stride < 2 || stride > longest_stride(count))) return C2D_ERR_ARGUMENT;
  if (total) *total = items;
  for (int32_t k = 0; k < count; ++k) {
    const int32_t at = first - 1 + k;
    double* out = xy + k * stride;
    for (int c = 0; c < 2; ++c) {
      if (p.kind == C2D_POINTS_ONE) out[c] = p.from[c];
      if (p.kind == C2D_POINTS_LINE) out[c] = place_between(p.from[c], p.to[c], at, p.count[0]);
      if (p.kind == C2D_POINTS_GRID)
        out[c] = place_between(p.from[c], p.to[c], c == 0 ? at % p.count[0] : at / p.count[0], p.count[c]);
    }
  }
  return C2D_OK;
}
