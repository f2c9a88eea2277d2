#include "post/body_curve.hpp"

#include <cmath>

namespace app {

double shape_value(int32_t count, int32_t k, double eta) {
  double product = 1.0;
  for (int32_t j = 0; j < count; ++j)
    if (j != k) product *= (eta - node_place(count, j)) / (node_place(count, k) - node_place(count, j));
  return product;
}

double shape_slope(int32_t count, int32_t k, double eta) {
  double sum = 0.0;
  for (int32_t i = 0; i < count; ++i) {
    if (i == k) continue;
    double product = 1.0 / (node_place(count, k) - node_place(count, i));
    for (int32_t j = 0; j < count; ++j)
      if (j != k && j != i) product *= (eta - node_place(count, j)) / (node_place(count, k) - node_place(count, j));
    sum += product;
  }
  return sum;
}

void ElementCurve::point(double eta, double out[2]) const {
  out[0] = out[1] = 0;
  for (int32_t k = 0; k < count; ++k) {
    const double value = shape_value(count, k, eta);
    out[0] += value * x[k], out[1] += value * y[k];
  }
}

void ElementCurve::slope(double eta, double out[2]) const {
  out[0] = out[1] = 0;
  for (int32_t k = 0; k < count; ++k) {
    const double value = shape_slope(count, k, eta);
    out[0] += value * x[k], out[1] += value * y[k];
  }
}

double ElementCurve::length(double from, double to, int32_t nodes, int32_t k, bool revolved) const {
  static const double kPlace[3] = {0.0, 0.5384693101056831, 0.9061798459386640}; // Gauss, five points
  static const double kWeight[3] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  const int panels = count > 2 ? 4 : 1; // accurate to 1e-10 even for a curve that turns by a right angle
  const double half = (to - from) / (2 * panels);
  double sum = 0, t[2];
  for (int i = 0; i < panels; ++i)
    for (int g = -2; g <= 2; ++g) {
      const int n = g < 0 ? -g : g;
      const double eta = from + half * (2 * i + 1 + (g < 0 ? -kPlace[n] : kPlace[n]));
      slope(eta, t);
      double part = kWeight[n] * half * std::hypot(t[0], t[1]) * shape_value(nodes, k, eta);
      if (revolved) {
        point(eta, t);
        part *= kFullTurn * t[0];
      }
      sum += part;
    }
  return sum;
}

void BodyCurve::take_elements(const c2d_body_result& body, const std::vector<double>& x, const std::vector<double>& y) {
  const int32_t order = body.element_nodes - 1;
  int32_t open_before = 0;
  for (const Region& r : regions_) {
    const int32_t begin = (r.first - 1) * order + open_before;
    for (int32_t e = r.first; e <= r.last; ++e) {
      ElementCurve curve;
      curve.count = body.element_nodes;
      for (int32_t k = 0; k <= order; ++k) {
        const bool round = !r.open && e == r.last && k == order;
        const size_t at = static_cast<size_t>(round ? begin : (e - 1) * order + open_before + k);
        if (at < x.size()) curve.x[k] = x[at], curve.y[k] = y[at];
      }
      elements_.push_back(curve);
    }
    if (r.open) ++open_before;
  }
}

c2d_status BodyCurve::read(c2d_solver* solver, const Summary& s, int32_t number) {
  const c2d_body_result& body = s.body[number - 1];
  function_nodes_ = s.function_nodes;
  regions_.clear(), elements_.clear(), node_.clear();
  if (body.elements == 0) return C2D_OK;
  c2d_status status = C2D_OK;
  for (int32_t r = 1; status == C2D_OK && r <= body.regions; ++r) {
    regions_.push_back({0, 0, r <= body.open_regions});
    status = c2d_get_region(solver, number, r, &regions_.back().first, &regions_.back().last);
  }
  std::vector<double> x(static_cast<size_t>(body.points)), y(x.size());
  node_.resize(static_cast<size_t>(body.elements * function_nodes_));
  if (status == C2D_OK) status = c2d_get(solver, C2D_NODE_X, number, 1, body.points, x.data(), 1);
  if (status == C2D_OK) status = c2d_get(solver, C2D_NODE_Y, number, 1, body.points, y.data(), 1);
  if (status == C2D_OK) status = c2d_get(solver, C2D_END_NODE, number, 1, body.elements * function_nodes_, node_.data(), 1);
  if (status != C2D_OK) return status;
  take_elements(body, x, y);
  mark_corners(body.nodes);
  return status;
}

int32_t BodyCurve::node(int32_t e, int32_t local) const {
  return static_cast<int32_t>(node_[static_cast<size_t>((e - 1) * function_nodes_ + local - 1)]);
}

const BodyCurve::Region& BodyCurve::region_of(int32_t e) const {
  for (const Region& r : regions_)
    if (e >= r.first && e <= r.last) return r;
  return regions_.front();
}

int32_t BodyCurve::next(int32_t e, bool up) const {
  const Region& r = region_of(e);
  if (e != (up ? r.last : r.first)) return up ? e + 1 : e - 1;
  if (r.open) return 0;
  return up ? r.first : r.last;
}

bool BodyCurve::is_corner(int32_t e, bool at_end) const {
  const int32_t other = next(e, at_end);
  if (other == 0) return false;
  double a[2], b[2];
  element(e).slope(at_end ? 1 : -1, a);
  element(other).slope(at_end ? -1 : 1, b);
  const double cosine = a[0] * b[0] + a[1] * b[1];
  return cosine < 0.5 * std::sqrt(3.0) * std::hypot(a[0], a[1]) * std::hypot(b[0], b[1]);
}

void BodyCurve::mark_corners(int32_t nodes) {
  corner_.assign(static_cast<size_t>(nodes) + 1, 0);
  for (int32_t e = 1; e <= elements() && function_nodes_ > 1; ++e) // a constant function's node is in the middle
    for (const bool at_end : {false, true}) {
      const size_t i = static_cast<size_t>(node(e, at_end ? function_nodes_ : 1));
      if (i < corner_.size() && is_corner(e, at_end)) corner_[i] = 1;
    }
}

} // namespace app
