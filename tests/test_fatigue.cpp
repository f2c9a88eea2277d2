// Fatigue parameters of a stress cycle: against closed forms, a fine grid of planes, brute force, and in the Cattaneo contact.
#include "dice.hpp"
#include "post/fatigue/ball.hpp"
#include "post/fatigue/criteria.hpp"
#include "post/fatigue/depths.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace app;
using random_decks::Dice;

namespace {

const double kPi = std::acos(-1.0);
constexpr FatigueCriterion kAll[] = {FatigueCriterion::kSwt, FatigueCriterion::kFatemiSocie, FatigueCriterion::kFindley,
                                     FatigueCriterion::kCrossland, FatigueCriterion::kDangVan};
const FatigueMaterial kSteel{200e3, 0.3, 1 / 400.0, 0.3, 0.3, 0.25};

bool near(double a, double b, double relative) { return std::fabs(a - b) <= relative * std::max(std::fabs(a), std::fabs(b)); }

double of(FatigueCriterion criterion, const StressCycle& cycle, const FatigueMaterial& m = kSteel) {
  return fatigue_value(criterion, cycle, m).value;
}

StressState turned(const StressState& s, double angle) {
  const double c = std::cos(angle), n = std::sin(angle);
  return {c * c * s.xx + n * n * s.yy - 2 * c * n * s.xy, n * n * s.xx + c * c * s.yy + 2 * c * n * s.xy,
          c * n * (s.xx - s.yy) + (c * c - n * n) * s.xy, s.zz};
}

StressState some_state(Dice& dice) {
  return {dice.between(-300, 300), dice.between(-300, 300), dice.between(-200, 200), dice.between(-100, 100)};
}

StressCycle some_cycle(Dice& dice, int states) {
  StressCycle out;
  const int kind = dice.whole(0, 2);
  StressState at = some_state(dice);
  for (int i = 0; i < states; ++i) {
    const double t = 2 * kPi * i / states;
    if (kind == 0) at = some_state(dice);                              // anywhere
    if (kind == 1) at = at + 0.2 * some_state(dice);                   // a path
    if (kind == 2) at = {300 * std::cos(t), 0, 200 * std::sin(t), 50}; // a smooth curve
    out.push_back(at);
  }
  return out;
}

// On the plane with this normal, by the tensors.
double on_plane(FatigueCriterion criterion, const StressCycle& cycle, const FatigueMaterial& m, double angle) {
  double most = -HUGE_VAL, low = HUGE_VAL, high = -HUGE_VAL;
  for (const StressState& s : cycle) {
    const StressState t = turned(s, -angle);
    const double strain = (t.xx - m.poisson_ratio * (t.yy + t.zz)) / m.youngs_modulus;
    const double shear = 2 * (1 + m.poisson_ratio) / m.youngs_modulus * t.xy;
    const double v = criterion == FatigueCriterion::kSwt ? strain : criterion == FatigueCriterion::kFatemiSocie ? shear : t.xy;
    most = std::max(most, t.xx), low = std::min(low, v), high = std::max(high, v);
  }
  const double amplitude = (high - low) / 2, open = std::max(0.0, most);
  if (criterion == FatigueCriterion::kSwt) return open * amplitude;
  if (criterion == FatigueCriterion::kFatemiSocie) return amplitude * (1 + m.fatemi_socie * open);
  return amplitude + m.findley * most;
}

double apart(const SpacePoint& a, const SpacePoint& b) {
  return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

// Half plane y < 0 below a contact |x| < a with pressure p sqrt(1 - (x/a)^2) and traction q sqrt(1 - (x/a)^2) in x: McEwen
// 1949; Johnson, Contact Mechanics, 4.49.
StressState below_ellipse(double x, double depth, double a, double p, double q) {
  const double e = a * a - x * x + depth * depth, root = std::hypot(e, 2 * x * depth);
  const double m = std::sqrt(std::max(0.0, (root + e) / 2)), n = std::copysign(std::sqrt(std::max(0.0, (root - e) / 2)), x);
  const double mm = m * m + n * n, zn = (depth * depth + n * n) / mm, zm = (depth * depth - m * m) / mm;
  const double along = -(m * (1 + zn) - 2 * depth) / a, down = -m * (1 - zn) / a, shear = n * zm / a; // of p = 1
  const double along_q = (n * (2 - zm) - 2 * x) / a;                                                  // of q = 1
  StressState s{p * along + q * along_q, p * down + q * shear, -(p * shear + q * along), 0};
  s.zz = 0.3 * (s.xx + s.yy);
  return s;
}

// The example of a fretting contact: P constant, Q between +- half of mu P.
constexpr double kE = 200e3, kNu = 0.3, kRadius = 6, kForce = 120, kMu = 0.6;
double half_width() { return std::sqrt(4 * kForce * kRadius * 2 * (1 - kNu * kNu) / (kPi * kE)); }

// `part`: Q from -1 to 1 of its largest value, on the way down or up.
StressState in_contact(double x, double depth, double part, bool down) {
  const double a = half_width(), p = 2 * kForce / (kPi * a), q = kMu * p;
  const auto stuck = [&](double share) { return a * std::sqrt(1 - share); }; // share of mu P
  const double inner = stuck(0.5), back = stuck(0.5 * (1 - part) / 2), sign = down ? 1 : -1;
  const double back_up = stuck(0.5 * (1 + part) / 2), now = down ? back : back_up;
  StressState s = below_ellipse(x, depth, a, p, sign * q);
  s = s + below_ellipse(x, depth, inner, 0, -sign * q * inner / a);
  s = s + below_ellipse(x, depth, a, 0, -2 * sign * q);
  s = s + below_ellipse(x, depth, now, 0, 2 * sign * q * now / a);
  return s;
}

StressCycle cattaneo(double x, double depth, int steps) {
  StressCycle out;
  for (int i = 0; i < 2 * steps; ++i) {
    const bool down = i < steps;
    const double part = (down ? 1 : -1) * (1 - 2.0 * (i % steps) / steps);
    out.push_back(in_contact(x, depth, part, down));
  }
  return out;
}

} // namespace

TEST_CASE("fatigue: a bar in tension and compression has closed forms") {
  for (const double s : {1.0, 250.0, 7e8}) {
    const StressCycle cycle = {{0, s, 0, 0}, {0, -s, 0, 0}, {0, 0.3 * s, 0, 0}};
    const FatigueMaterial m{200e3, 0.3, 1 / s, 0.3, 0.4, 0.25};
    CHECK(near(of(FatigueCriterion::kSwt, cycle, m), s * s / m.youngs_modulus, 1e-10));
    CHECK(std::fabs(std::fabs(fatigue_value(FatigueCriterion::kSwt, cycle, m).angle) - 90) < 1e-5);
    CHECK(near(of(FatigueCriterion::kCrossland, cycle, m), s / std::sqrt(3.0) + 0.4 * s / 3, 1e-10));
    CHECK(std::isnan(fatigue_value(FatigueCriterion::kCrossland, cycle, m).angle));
    CHECK(near(of(FatigueCriterion::kDangVan, cycle, m), s / 2 + 0.25 * s / 3, 1e-10));
    // shear s/2 sin 2t with k s (1 + cos 2t)/2: the largest is s/2 (sqrt(1 + k^2) + k)
    CHECK(near(of(FatigueCriterion::kFindley, cycle, m), s / 2 * (std::sqrt(1.09) + 0.3), 1e-10));
    // s (1 + nu)/E sin p (1 + (1 + cos p)/2): its slope vanishes where 2 cos^2 p + 3 cos p = 1
    const double c = (std::sqrt(17.0) - 3) / 4, f = std::sqrt(1 - c * c) * (1 + (1 + c) / 2);
    CHECK(near(of(FatigueCriterion::kFatemiSocie, cycle, m), 1.3 * s / m.youngs_modulus * f, 1e-10));
  }
}

TEST_CASE("fatigue: pulsating tension, pure compression, no load") {
  const StressCycle pulsating = {{0, 0, 0, 0}, {100, 0, 0, 0}}, pressed = {{0, 0, 0, 0}, {-100, 0, 0, 0}};
  CHECK(near(of(FatigueCriterion::kSwt, pulsating), 100 * 50 / 200e3, 1e-12));
  CHECK(near(of(FatigueCriterion::kCrossland, pulsating), 50 / std::sqrt(3.0) + 0.3 * 100 / 3, 1e-12));
  CHECK(of(FatigueCriterion::kSwt, pressed) == 0);
  CHECK(near(of(FatigueCriterion::kFatemiSocie, pressed), 100 * 1.3 / 200e3 / 2, 1e-12));
  CHECK(near(of(FatigueCriterion::kCrossland, pressed), 50 / std::sqrt(3.0), 1e-12));
  for (const FatigueCriterion c : kAll) CHECK(of(c, {{0, 0, 0, 0}, {0, 0, 0, 0}}) == 0);
  for (const FatigueCriterion c : kAll) CHECK(of(c, {}) == 0);
  CHECK(std::isinf(fatigue_bound(FatigueCriterion::kDangVan, pulsating, kSteel)));
}

TEST_CASE("fatigue: a fine grid of planes finds nothing larger, and nearly the same") {
  Dice dice(11);
  for (int round = 0; round < 60; ++round) {
    CAPTURE(round);
    const StressCycle cycle = some_cycle(dice, dice.whole(1, 40));
    for (const FatigueCriterion c : {FatigueCriterion::kSwt, FatigueCriterion::kFatemiSocie, FatigueCriterion::kFindley}) {
      const FatigueValue found = fatigue_value(c, cycle, kSteel);
      CHECK(found.angle > -90), CHECK(found.angle <= 90);
      CHECK(fatigue_bound(c, cycle, kSteel) >= found.value * (1 - 1e-13));
      double most = -HUGE_VAL;
      constexpr int kPlanes = 500;
      for (int i = 0; i < kPlanes; ++i) most = std::max(most, on_plane(c, cycle, kSteel, kPi * i / kPlanes));
      CHECK(most <= found.value + 1e-11 * std::fabs(found.value));
      CHECK(found.value - most <= 2e-3 * std::fabs(found.value) + 1e-6);
      const double there = on_plane(c, cycle, kSteel, found.angle * kPi / 180);
      CHECK(std::fabs(there - found.value) <= 1e-11 * std::fabs(found.value) + 1e-15);
      for (const double step : {1e-4, 1e-6}) // no plane beside it is better
        for (const double side : {-step, step})
          CHECK(on_plane(c, cycle, kSteel, found.angle * kPi / 180 + side) <= found.value * (1 + 1e-12) + 1e-15);
    }
  }
}

TEST_CASE("fatigue: turning, mirroring, units and the order of the states change nothing") {
  Dice dice(5);
  for (int round = 0; round < 20; ++round) {
    CAPTURE(round);
    const StressCycle cycle = some_cycle(dice, 12);
    const double angle = dice.between(-3, 3);
    StressCycle by_angle, mirrored, backward(cycle.rbegin(), cycle.rend()), scaled, often;
    for (const StressState& s : cycle) {
      by_angle.push_back(turned(s, angle)), mirrored.push_back({s.xx, s.yy, -s.xy, s.zz}), scaled.push_back(1e6 * s);
      for (const double part : {0.0, 0.25, 0.5, 1.0}) // states on the straight way there
        often.push_back(often.empty() ? s : (1 - part) * often.back() + part * s);
    }
    FatigueMaterial pascal = kSteel;
    pascal.youngs_modulus *= 1e6, pascal.fatemi_socie /= 1e6;
    for (const FatigueCriterion c : kAll) {
      const FatigueValue first = fatigue_value(c, cycle, kSteel), second = fatigue_value(c, by_angle, kSteel);
      const double size = std::fabs(first.value) + 1e-12;
      CHECK(std::fabs(second.value - first.value) < 1e-9 * size);
      CHECK(std::fabs(of(c, mirrored) - first.value) < 1e-9 * size);
      CHECK(std::fabs(of(c, backward) - first.value) < 1e-12 * size);
      CHECK(std::fabs(of(c, often) - first.value) < 1e-12 * size);
      const double unit = c == FatigueCriterion::kFatemiSocie ? 1 : 1e6;
      CHECK(std::fabs(fatigue_value(c, scaled, pascal).value - unit * first.value) < 1e-9 * unit * size);
    }
  }
}

TEST_CASE("fatigue: the smallest ball, by brute force over all sets of points") {
  Dice dice(3);
  for (int round = 0; round < 60; ++round) {
    CAPTURE(round);
    std::vector<SpacePoint> points;
    const int dimensions = round % 4; // all in one place, on a line, in a plane, in space
    for (int i = dice.whole(1, 14); i > 0; --i) {
      SpacePoint p{};
      for (int k = 0; k < dimensions; ++k) p[static_cast<size_t>(k)] = dice.between(-1, 1);
      points.push_back(p);
    }
    if (round % 5 == 0) points.push_back(points.front());
    const Ball ball = smallest_ball(points);
    for (const SpacePoint& p : points) CHECK(apart(p, ball.centre) <= ball.radius + 1e-11);
    // The smallest radius that encloses all: subgradient steps towards the farthest point.
    SpacePoint c = points.front();
    double radius = HUGE_VAL;
    for (int i = 1; i < 4000; ++i) {
      const SpacePoint* far = &points.front();
      for (const SpacePoint& p : points)
        if (apart(p, c) > apart(*far, c)) far = &p;
      radius = std::min(radius, apart(*far, c));
      for (size_t k = 0; k < 3; ++k) c[k] += ((*far)[k] - c[k]) / (i + 1);
    }
    CHECK(ball.radius <= radius + 1e-11);
    CHECK(radius - ball.radius < 1e-2);
  }
  std::vector<SpacePoint> sphere; // many points of equal distance
  for (int i = 0; i < 300; ++i) {
    const double z = 2 * (i + 0.5) / 300 - 1, t = 2.4 * i;
    sphere.push_back({5 + 2 * std::sqrt(1 - z * z) * std::cos(t), 2 * std::sqrt(1 - z * z) * std::sin(t), 2 * z});
  }
  CHECK(near(smallest_ball(sphere).radius, 2, 1e-3));
}

TEST_CASE("fatigue: a circular path of the deviator, and a torsion out of phase") {
  StressCycle circle; // tension and shear a quarter of a cycle apart, shear s/sqrt(3): a circle of radius s/sqrt(3)
  for (int i = 0; i < 72; ++i) {
    const double t = 2 * kPi * i / 72;
    circle.push_back({300 * std::cos(t), 0, 300 / std::sqrt(3.0) * std::sin(t), 0});
  }
  const FatigueMaterial m{200e3, 0.3, 0, 0, 0.3, 0};
  CHECK(near(of(FatigueCriterion::kCrossland, circle, m), 300 / std::sqrt(3.0) + 0.3 * 100, 1e-12));
  CHECK(near(of(FatigueCriterion::kDangVan, circle, m), 300 / std::sqrt(3.0), 1e-12)); // at the largest shear
}

TEST_CASE("fatigue: under the edge of the Cattaneo contact") {
  const double a = half_width();
  CHECK(near(a, 0.091336, 1e-5));
  const StressCycle edge = {{709.718, 0, 0, 0.3 * 709.718}, {-709.718, 0, 0, -0.3 * 709.718}};
  CHECK(near(of(FatigueCriterion::kSwt, edge), 2.29183, 1e-5));
  const FatigueMaterial m{kE, kNu, 1 / 400.0, 0.3, 0.3, 0};
  CHECK(near(of(FatigueCriterion::kCrossland, edge, {kE, kNu, 0, 0, 0, 0}), 364.199, 1e-5));
  CHECK(near(of(FatigueCriterion::kCrossland, edge, m), 364.199 + 0.3 * 307.544, 1e-5));
  CHECK(near(in_contact(-a, 1e-12, 1, true).xx, 709.718, 1e-3));
  const double depths[] = {0.002, 0.005, 0.010, 0.025};
  const double swt[] = {0.90039, 0.42298, 0.10279, 0}, fs[] = {5.4146e-3, 3.8217e-3, 2.5482e-3, 1.3662e-3},
               findley[] = {330.11, 257.87, 188.00, 92.54}, crossland[] = {311.70, 242.30, 175.60, 80.82};
  for (size_t i = 0; i < 4; ++i) {
    CAPTURE(depths[i]);
    const StressCycle cycle = cattaneo(-a, depths[i], 40);
    CHECK(std::fabs(of(FatigueCriterion::kSwt, cycle, m) - swt[i]) < 1e-4 * swt[i] + 1e-6);
    CHECK(near(of(FatigueCriterion::kFatemiSocie, cycle, m), fs[i], 1e-4));
    CHECK(near(of(FatigueCriterion::kFindley, cycle, m), findley[i], 1e-4));
    CHECK(near(of(FatigueCriterion::kCrossland, cycle, m), crossland[i], 1e-4));
  }
}

TEST_CASE("fatigue: means over a depth, and cracks at an edge") {
  const auto sum = [](const std::vector<DepthWeight>& all, auto stress) {
    double out = 0;
    for (const DepthWeight& d : all) out += d.weight * stress(d.depth);
    return out;
  };
  for (const double length : {1.0, 0.02}) {
    const std::vector<DepthWeight> mean = mean_over_depth(length), crack = edge_crack(length);
    CHECK(near(sum(mean, [](double) { return 1.0; }), 1, 1e-13));
    CHECK(near(sum(mean, [&](double x) { return std::sqrt(x / length); }), 2.0 / 3, 1e-13));
    CHECK(near(sum(mean, [&](double x) { return std::exp(-x / length); }), 1 - std::exp(-1.0), 1e-13));
    // Unit stress (x/a)^n; the third and fourth from the integral equation of dislocations along the crack
    const double exact[] = {1.12152, 0.68282, 0.52545, 0.44095};
    for (int n = 0; n < 4; ++n)
      CHECK(near(sum(crack, [&](double x) { return std::pow(x / length, n); }) / std::sqrt(kPi * length), exact[n], 1e-3));
  }
}
