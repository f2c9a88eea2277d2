#include "post/body_faces.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

const double kCorner = 15 * kPi / 180; // smallest turn of a corner
const double kChord = 50 * kPi / 180;  // chords of an arc turn by less than this,
const double kAlike = 3;               // and successive ones by similar angles: within this factor

// Angle from one direction to another, positive to the left; -pi at the tip of a slit.
double turn(const Point& a, const Point& b) {
  const double angle = std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
  return angle > kPi - 1e-6 ? -kPi : angle;
}

} // namespace

c2d_status BodyFaces::read(c2d_solver* solver, const Summary& s, int32_t body) {
  const c2d_body_result& own = s.body[body - 1];
  per_element_ = own.element_nodes;
  zone_.assign(static_cast<size_t>(own.elements), 0);
  if (own.elements == 0) return C2D_OK;
  x_.resize(static_cast<size_t>(own.points));
  y_.resize(static_cast<size_t>(own.points));
  c2d_status status = c2d_get(solver, C2D_NODE_X, body, 1, own.points, x_.data(), 1);
  if (status == C2D_OK) status = c2d_get(solver, C2D_NODE_Y, body, 1, own.points, y_.data(), 1);
  if (status == C2D_OK) status = read_regions(solver, s, body);
  symmetry_ = s.symmetry;
  for (int axis = 0; axis < 2; ++axis) symmetry_at_[axis] = s.symmetry_at[axis];
  for (int32_t e = 1; e <= elements() && status == C2D_OK; ++e) on_line_.push_back(lies_on(e, 0) || lies_on(e, 1));
  if (status == C2D_OK) status = read_conditions(solver, s, body);
  return status == C2D_OK ? read_curves(solver, s, body) : status;
}

c2d_status BodyFaces::read_regions(c2d_solver* solver, const Summary& s, int32_t body) {
  region_.assign(zone_.size(), 0);
  for (int32_t r = 1; r <= s.body[body - 1].regions; ++r) {
    Region region{0, 0, r <= s.body[body - 1].open_regions};
    const c2d_status status = c2d_get_region(solver, body, r, &region.first, &region.last);
    if (status != C2D_OK) return status;
    for (int32_t e = region.first; e <= region.last; ++e) region_[index(e)] = regions_.size();
    regions_.push_back(region);
  }
  return C2D_OK;
}

c2d_status BodyFaces::read_conditions(c2d_solver* solver, const Summary& s, int32_t body) {
  condition_.assign(zone_.size(), 3);
  for (int32_t e = 1; e <= elements(); ++e)
    for (int32_t local = 1; local <= s.function_nodes; ++local) {
      int32_t codes[4];
      double values[4];
      const c2d_status status = c2d_get_condition(solver, body, e, local, 1, codes, values);
      if (status != C2D_OK) return status;
      for (int k = 0; k < 2; ++k)
        if (codes[2 + k] != 0) condition_[index(e)] &= ~(1 << k);
    }
  return C2D_OK;
}

c2d_status BodyFaces::read_curves(c2d_solver* solver, const Summary& s, int32_t body) {
  curve_.assign(zone_.size(), 0);
  for (int32_t i = 1; i <= s.curves; ++i) {
    c2d_curve curve = C2D_INIT(c2d_curve);
    if (const c2d_status status = c2d_get_curve(solver, i, &curve); status != C2D_OK) return status;
    if (curve.body != body || curve.kind == C2D_CURVE_LINE) continue;
    for (int32_t e = curve.first_element; e <= curve.last_element; ++e) curve_[index(e)] = i;
  }
  return C2D_OK;
}

int32_t BodyFaces::next(int32_t element, bool up) const {
  const Region& r = regions_[region_[index(element)]];
  const bool last = element == (up ? r.last : r.first);
  const int32_t next = !last ? element + (up ? 1 : -1) : r.open ? 0 : up ? r.first : r.last;
  return next == 0 || on_line_[index(next)] ? 0 : next;
}

Point BodyFaces::node(int32_t element, int32_t k) const {
  const size_t r = region_[index(element)];
  const bool wraps = !regions_[r].open && element == regions_[r].last && k == per_element_ - 1;
  int32_t open = 0; // regions before it that are open have one node more
  for (size_t i = 0; i < r; ++i) open += regions_[i].open ? 1 : 0;
  const int32_t first = (wraps ? regions_[r].first : element) - 1;
  const size_t i = static_cast<size_t>(first * (per_element_ - 1) + (wraps ? 0 : k) + open);
  return {x_[i], y_[i]};
}
Point BodyFaces::at(int32_t element, bool end) const { return node(element, end ? per_element_ - 1 : 0); }
double BodyFaces::length(int32_t element) const { return distance(at(element, false), at(element, true)); }

Point BodyFaces::direction(int32_t element, bool end) const {
  static const double kSlopes[3][4] = {{-1, 1}, {-3, 4, -1}, {-11, 18, -9, 2}}; // at the begin, times a length
  const double* slope = kSlopes[per_element_ - 2];
  Point d;
  for (int32_t k = 0; k < per_element_; ++k) {
    const Point p = node(element, end ? per_element_ - 1 - k : k);
    d.x += (end ? -1 : 1) * slope[k] * p.x;
    d.y += (end ? -1 : 1) * slope[k] * p.y;
  }
  const double size = std::hypot(d.x, d.y);
  return {d.x / size, d.y / size};
}

bool BodyFaces::lies_on(int32_t element, int axis) const {
  bool all = (symmetry_ >> axis & 1) != 0;
  for (int32_t k = 0; k < per_element_; ++k) all = all && is_at_line(node(element, k), axis);
  return all;
}
bool BodyFaces::is_at_line(const Point& p, int axis) const {
  const double at = symmetry_at_[axis], x = axis == 0 ? p.x : p.y;
  return (symmetry_ >> axis & 1) != 0 && std::fabs(x - at) <= 1e-12 * (std::fabs(p.x) + std::fabs(p.y));
}

double BodyFaces::angle_at_image(int32_t element, bool up) const {
  const Point end = at(element, up), own = direction(element, up);
  for (int axis = 0; axis < 2; ++axis) {
    if (!is_at_line(end, axis)) continue;
    const Point image = axis == 0 ? Point{own.x, -own.y} : Point{-own.x, own.y}; // reflected, and in the opposite direction
    return kPi - (up ? turn(own, image) : turn(image, own));
  }
  return 0;
}

double BodyFaces::turn_after(int32_t element) const {
  return turn(direction(element, true), direction(next(element, true), false));
}
double BodyFaces::angle_after(int32_t element) const { return kPi - turn_after(element); }

double BodyFaces::turn_at_image(int32_t element, bool up) const {
  const double angle = angle_at_image(element, up);
  return angle != 0 ? kPi - angle : 0;
}
double BodyFaces::turn_beyond(int32_t element, bool up) const {
  const int32_t other = next(element, up);
  return other != 0 ? turn_after(up ? element : other) : turn_at_image(element, up);
}

// Chords of an arc turn by similar angles as their neighbours.
bool BodyFaces::is_of_chords(double turn, double before, double after) const {
  const auto is_like = [&](double other) { return other * turn > 0 && other / turn < kAlike && turn / other < kAlike; };
  return per_element_ == 2 && std::fabs(turn) <= kChord && (is_like(before) || is_like(after));
}

bool BodyFaces::is_corner_after(int32_t element) const {
  const int32_t behind = next(element, true);
  const double turn = turn_after(element);
  if (std::fabs(turn) < kCorner) return false;
  if (curve_[index(element)] != 0 && curve_[index(element)] == curve_[index(behind)]) return false;
  return !is_of_chords(turn, turn_beyond(element, false), turn_beyond(behind, true));
}
bool BodyFaces::is_corner_at_image(int32_t element, bool up) const {
  const double turn = turn_at_image(element, up), beside = turn_beyond(element, !up);
  return std::fabs(turn) >= kCorner && !is_of_chords(turn, beside, beside);
}

bool BodyFaces::face(int32_t element, Face& out) const {
  out = Face();
  if (zone_[index(element)] != 0) return false;
  const int32_t known = condition_[index(element)];
  if (known == 0) return true;
  const Point d = direction(element, false);
  const double across = known == 1 ? d.x : d.y, along = known == 1 ? d.y : d.x; // in the supported direction
  const double kStraight = 1e-6;
  if (known == 3)
    out.kind = FaceKind::kBonded;
  else if (std::fabs(across) < kStraight)
    out.kind = FaceKind::kSmooth;
  else if (std::fabs(along) < kStraight)
    out.kind = FaceKind::kGuided;
  else
    return false;
  return true;
}

void BodyFaces::find_ends(const c2d_side& side, bool first, StretchEnd out[2]) const {
  const int32_t count = side.elements;
  int32_t last = side.first_element;
  for (int32_t k = 1; k < count && last != 0; ++k) last = next(last, true);
  const bool up = count == 1 ? first : last == side.last_element;
  out[0] = {side.first_element, !up};
  out[1] = {side.last_element, up};
}

void BodyFaces::enter_zone(const c2d_side& side, int32_t zone) {
  StretchEnd ends[2];
  find_ends(side, true, ends);
  int32_t e = side.first_element;
  for (size_t k = 0; k < zone_.size() && e != 0; ++k) {
    zone_[index(e)] = zone;
    if (e == side.last_element) break;
    e = next(e, ends[1].up);
  }
}

} // namespace app
