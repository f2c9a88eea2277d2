#include "program/families/mesh.hpp"

#include <algorithm>
#include <cmath>

namespace families {

Condition free_side() { return Condition(); }

Condition roller_x(double ux) {
  Condition c;
  c.codes = {{1, 0, 0, 1}};
  if (ux != 0) c.values = [ux](Point) { return std::array<double, 4>{{0, 0, ux, 0}}; };
  return c;
}

Condition roller_y(double uy) {
  Condition c;
  c.codes = {{0, 1, 1, 0}};
  if (uy != 0) c.values = [uy](Point) { return std::array<double, 4>{{0, 0, 0, uy}}; };
  return c;
}

Condition clamped(double ux, double uy) {
  return displacement_field([ux, uy](Point) { return std::array<double, 2>{{ux, uy}}; });
}

Condition traction(double tx, double ty) {
  return traction_field([tx, ty](Point) { return std::array<double, 2>{{tx, ty}}; });
}

Condition traction_field(std::function<std::array<double, 2>(Point)> field) {
  Condition c;
  c.values = [field](Point p) { return std::array<double, 4>{{field(p)[0], field(p)[1], 0, 0}}; };
  return c;
}

Condition displacement_field(std::function<std::array<double, 2>(Point)> field) {
  Condition c;
  c.codes = {{1, 1, 0, 0}};
  c.values = [field](Point p) { return std::array<double, 4>{{0, 0, field(p)[0], field(p)[1]}}; };
  return c;
}

namespace {

// Number of elements up to a place, for elements of size h0 + g s, g > 0: the integral of ds / h.
double count_rising(double h0, double g, double s) { return std::log1p(g * s / h0) / g; }
double place_rising(double h0, double g, double count) { return h0 * std::expm1(g * count) / g; }

} // namespace

std::vector<double> graded(double length, double first, double last, double ratio, double largest) {
  largest = std::min(largest, length);
  const double h0 = first > 0 ? std::min(first, largest) : largest;
  const double h1 = last > 0 ? std::min(last, largest) : largest;
  const double g = std::log(ratio);
  double rise = (largest - h0) / g, fall = (largest - h1) / g;
  if (rise + fall > length) { // the sizes meet below the largest
    rise = std::clamp((h1 - h0 + g * length) / (2 * g), 0.0, length);
    fall = length - rise;
  }
  const double flat = length - rise - fall;
  const double n1 = count_rising(h0, g, rise), n2 = n1 + flat / largest, n3 = n2 + count_rising(h1, g, fall);
  const int n = std::max(1, static_cast<int>(std::ceil(n3 - 1e-9)));
  std::vector<double> s(static_cast<size_t>(n) + 1, 0.0);
  for (int i = 1; i < n; ++i) {
    const double count = n3 * i / n;
    double& at = s[static_cast<size_t>(i)];
    if (count <= n1)
      at = place_rising(h0, g, count);
    else if (count <= n2)
      at = rise + (count - n1) * largest;
    else
      at = length - place_rising(h1, g, n3 - count);
  }
  s.back() = length;
  return s;
}

std::vector<double> equal(double length, int n) {
  std::vector<double> s;
  for (int i = 0; i <= n; ++i) s.push_back(length * i / n);
  return s;
}

std::vector<double> reversed(const std::vector<double>& s) {
  std::vector<double> out;
  for (auto at = s.rbegin(); at != s.rend(); ++at) out.push_back(s.back() - *at);
  return out;
}

Outline& Outline::add_side(int elements, const Condition& condition) {
  const int first = sides_.empty() ? 0 : sides_.back().first + sides_.back().elements;
  sides_.push_back({first, elements, condition, 0});
  return *this;
}

Outline& Outline::line(Point end, const std::vector<double>& s, const Condition& condition) {
  const Point from = nodes_.back().at;
  for (size_t i = 1; i < s.size(); ++i) {
    const double f = s[i] / s.back();
    Point at{from.x + (end.x - from.x) * f, from.y + (end.y - from.y) * f};
    if (i + 1 == s.size()) at = end;
    nodes_.push_back({at, false, 0, 0, {}, {}});
  }
  return add_side(static_cast<int>(s.size()) - 1, condition);
}

Outline& Outline::axis_x(Point end, const std::vector<double>& s) {
  line(end, s, roller_x());
  sides_.back().axis = 'X';
  return *this;
}

Outline& Outline::axis_y(Point end, const std::vector<double>& s) {
  line(end, s, roller_y());
  sides_.back().axis = 'Y';
  return *this;
}

Outline& Outline::hold_x(double ux) {
  nodes_.back().held[0] = true;
  nodes_.back().moved[0] = ux;
  return *this;
}

Outline& Outline::hold_y(double uy) {
  nodes_.back().held[1] = true;
  nodes_.back().moved[1] = uy;
  return *this;
}

namespace {

// On the axes exactly.
Point on_circle(Point centre, double radius, double angle) {
  const double turns = angle / 90.0;
  if (turns == std::floor(turns)) {
    const int quarter = ((static_cast<int>(turns) % 4) + 4) % 4;
    static const int kCosine[4] = {1, 0, -1, 0}, kSine[4] = {0, 1, 0, -1};
    return {centre.x + radius * kCosine[quarter], centre.y + radius * kSine[quarter]};
  }
  const double t = angle * (std::acos(-1.0) / 180.0);
  return {centre.x + radius * std::cos(t), centre.y + radius * std::sin(t)};
}

} // namespace

Outline& Outline::arc(Point centre, double radius, double from, double to, const std::vector<double>& s,
                      const Condition& condition) {
  for (size_t i = 0; i < s.size(); ++i) {
    const double angle = from + (to - from) * (s[i] / s.back());
    const Point at = on_circle(centre, radius, angle);
    if (i == 0)
      nodes_.back().polar = true, nodes_.back().radius = radius, nodes_.back().angle = angle;
    else
      nodes_.push_back({at, true, radius, angle, {}, {}});
  }
  return add_side(static_cast<int>(s.size()) - 1, condition);
}

} // namespace families
