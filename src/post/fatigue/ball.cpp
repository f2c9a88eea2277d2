// The smallest enclosing ball, exactly, by its active points (an LP-type problem; Welzl 1991, Gaertner 1999). At most four
// points determine it. Phases:
//   1. Begin with one point. Find the point that lies farthest outside the ball.
//   2. Of the active points and this one, at most five, try all sets of at most four: the smallest ball through the points of a
//      set that encloses all five is the next one. Its radius is larger than before, so no set comes twice.
//   3. End when no point is outside.
#include "post/fatigue/ball.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace app {
namespace {

constexpr double kBallRoundOff = 1e-13;  // relative to the size of all points: nearer is inside
constexpr double kBallDependent = 1e-12; // relative pivot: points on a line or in a plane have no ball through them

double space_distance(const SpacePoint& a, const SpacePoint& b) {
  return std::hypot(std::hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

// Solves the symmetric system of the vectors v from the first point of the set: v_i.v_j x_j = v_i.v_i / 2. False: dependent.
bool solve_centre(const std::vector<SpacePoint>& v, double x[3]) {
  const size_t n = v.size();
  double a[3][4] = {};
  for (size_t i = 0; i < n; ++i) {
    for (size_t j = 0; j < n; ++j)
      for (size_t k = 0; k < 3; ++k) a[i][j] += v[i][k] * v[j][k];
    a[i][3] = a[i][i] / 2;
  }
  for (size_t p = 0; p < n; ++p) {
    double size = 0;
    for (size_t k = 0; k < 3; ++k) size += v[p][k] * v[p][k];
    if (!(a[p][p] > kBallDependent * size)) return false;
    for (size_t i = p + 1; i < n; ++i) {
      const double f = a[i][p] / a[p][p];
      for (size_t j = p; j < n; ++j) a[i][j] -= f * a[p][j];
      a[i][3] -= f * a[p][3];
    }
  }
  for (size_t p = n; p-- > 0;) {
    x[p] = a[p][3];
    for (size_t j = p + 1; j < n; ++j) x[p] -= a[p][j] * x[j];
    x[p] /= a[p][p];
  }
  return true;
}

// The smallest ball through all points of the set; false: there is none.
bool ball_through(const std::vector<SpacePoint>& set, Ball& out) {
  std::vector<SpacePoint> v;
  for (size_t i = 1; i < set.size(); ++i) v.push_back({set[i][0] - set[0][0], set[i][1] - set[0][1], set[i][2] - set[0][2]});
  double x[3] = {};
  if (!solve_centre(v, x)) return false;
  out.centre = set[0];
  for (size_t i = 0; i < v.size(); ++i)
    for (size_t k = 0; k < 3; ++k) out.centre[k] += x[i] * v[i][k];
  out.radius = space_distance(out.centre, set[0]);
  return true;
}

// Of at most five points; leaves in `active` those that determine the ball.
Ball ball_of_few(std::vector<SpacePoint>& active, double size) {
  Ball best{{}, HUGE_VAL};
  std::vector<SpacePoint> chosen;
  for (unsigned set = 1; set < 1U << active.size(); ++set) {
    std::vector<SpacePoint> some;
    for (size_t i = 0; i < active.size(); ++i)
      if ((set >> i & 1U) != 0) some.push_back(active[i]);
    Ball ball;
    if (some.size() > 4 || !ball_through(some, ball) || ball.radius >= best.radius) continue;
    const bool encloses = std::all_of(active.begin(), active.end(), [&](const SpacePoint& p) {
      return space_distance(p, ball.centre) <= ball.radius + kBallRoundOff * size;
    });
    if (encloses) best = ball, chosen = some;
  }
  active = chosen;
  return best;
}

} // namespace

Ball smallest_ball(const std::vector<SpacePoint>& points) {
  if (points.empty()) return {};
  std::vector<SpacePoint> active = {points[0]};
  Ball ball{points[0], 0};
  double size = 0;
  for (const SpacePoint& p : points) size = std::max(size, space_distance(p, points[0]));
  for (size_t round = 0; round <= 4 * points.size(); ++round) { // ends long before: a guard against round-off
    const SpacePoint* farthest = nullptr;
    double most = ball.radius + 4 * kBallRoundOff * size;
    for (const SpacePoint& p : points)
      if (const double d = space_distance(p, ball.centre); d > most) most = d, farthest = &p;
    if (farthest == nullptr) break;
    active.push_back(*farthest);
    const Ball next = ball_of_few(active, size);
    if (active.empty()) break;
    ball = next;
  }
  return ball;
}

} // namespace app
