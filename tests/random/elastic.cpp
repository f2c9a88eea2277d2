#include "elastic.hpp"

#include <algorithm>
#include <cmath>

namespace random_decks {

namespace {

using namespace problem;

constexpr double kPi = 3.14159265358979323846;
constexpr int kGauss = 10;
constexpr double kPlace[kGauss / 2] = {0.1488743389816312, 0.4333953941292472, 0.6794095682990244, 0.8650633666889845,
                                       0.9739065285171717};
constexpr double kWeight[kGauss / 2] = {0.2955242247147529, 0.2692667193099964, 0.2190863625159820, 0.1494513491505806,
                                        0.0666713443086881};

size_t index(int64_t i) { return static_cast<size_t>(i); }

double place_of(int32_t n, int32_t k) { return n == 1 ? 0 : -1 + 2.0 * k / (n - 1); }

void shapes(int32_t n, double eta, double* value, double* slope) {
  for (int32_t k = 0; k < n; ++k) {
    value[k] = 1, slope[k] = 0;
    for (int32_t j = 0; j < n; ++j) {
      if (j == k) continue;
      const double step = place_of(n, k) - place_of(n, j);
      slope[k] = slope[k] * (eta - place_of(n, j)) / step + value[k] / step;
      value[k] *= (eta - place_of(n, j)) / step;
    }
  }
}

struct Element {
  int32_t nodes;
  double x[4], y[4];
  void at(double eta, double& px, double& py, double& dx, double& dy) const {
    double value[4], slope[4];
    shapes(nodes, eta, value, slope);
    px = py = dx = dy = 0;
    for (int32_t k = 0; k < nodes; ++k)
      px += value[k] * x[k], py += value[k] * y[k], dx += slope[k] * x[k], dy += slope[k] * y[k];
  }
};

const Range& region_of(const Body& body, int32_t element) {
  for (const Range& r : body.regions)
    if (element >= r.first && element <= r.last) return r;
  return body.regions.back();
}

Element element_of(const Body& body, int32_t element) {
  Element e = {body.element_nodes, {0, 0, 0, 0}, {0, 0, 0, 0}};
  const Range& r = region_of(body, element);
  for (int32_t k = 0; k < e.nodes; ++k) {
    int32_t node = (element - 1) * (e.nodes - 1) + k;
    if (k == e.nodes - 1 && element == r.last) node = (r.first - 1) * (e.nodes - 1);
    e.x[k] = body.xy[index(2 * node)], e.y[k] = body.xy[index(2 * node + 1)];
  }
  return e;
}

class Assembly {
public:
  Assembly(const Problem& p, int32_t number) : p_(p), body_(p.bodies[index(number - 1)]), number_(number) {
    nu_ = body_.poisson_ratio;
    shear_ = body_.youngs_modulus / (2 * (1 + nu_));
    if (p.plane == C2D_PLANE_STRESS) nu_ = nu_ / (1 + nu_);
  }
  Equations build();

private:
  void add_point(int32_t node, double x, double y);
  void add_piece(const Element& e, double from, double to, double x, double y, double near, int depth);
  void add_gauss(const Element& e, double from, double to, double x, double y);
  void add_balance();

  const Problem& p_;
  const Body& body_;
  const int32_t number_;
  double nu_, shear_;
  Equations out_;
  double h_[4][2][2], g_[4][2][2]; // of the element and point at hand, per local node
};

// Traction kernel and displacement kernel of Kelvin's solution at one point of the element.
void Assembly::add_gauss(const Element& e, double from, double to, double x, double y) {
  for (int i = 0; i < kGauss; ++i) {
    const double s = (i < kGauss / 2 ? -kPlace[i] : kPlace[i - kGauss / 2]), eta = 0.5 * (from + to) + 0.5 * (to - from) * s;
    double px, py, dx, dy, value[4], slope[4];
    e.at(eta, px, py, dx, dy);
    shapes(p_.function_nodes, eta, value, slope);
    const double ds = std::hypot(dx, dy), w = 0.5 * (to - from) * kWeight[i % (kGauss / 2)] * ds;
    if (px == x && py == y) continue; // within round-off of the point
    const double n[2] = {dy / ds, -dx / ds}, d[2] = {px - x, py - y}, r = std::hypot(d[0], d[1]);
    const double q[2] = {d[0] / r, d[1] / r}, rn = q[0] * n[0] + q[1] * n[1];
    const double a = -1 / (4 * kPi * (1 - nu_) * r), b = 1 / (8 * kPi * shear_ * (1 - nu_));
    for (int32_t l = 0; l < p_.function_nodes; ++l)
      for (int k = 0; k < 2; ++k)
        for (int j = 0; j < 2; ++j) {
          const double same = j == k ? 1 : 0;
          h_[l][k][j] +=
              w * value[l] * a * (rn * ((1 - 2 * nu_) * same + 2 * q[k] * q[j]) - (1 - 2 * nu_) * (q[k] * n[j] - q[j] * n[k]));
          g_[l][k][j] += w * value[l] * b * (q[k] * q[j] - (3 - 4 * nu_) * std::log(r) * same);
        }
  }
}

// Halves a piece until it is short against its distance from the point. `near`: local coordinate of the point on this
// element, or beyond 1 if it is not on it.
void Assembly::add_piece(const Element& e, double from, double to, double x, double y, double near, int depth) {
  double px, py, dx, dy, length = 0, distance = HUGE_VAL;
  for (int i = 0; i <= 4; ++i) {
    e.at(from + (to - from) * i / 4, px, py, dx, dy);
    distance = std::min(distance, std::hypot(px - x, py - y));
    length = std::max(length, std::hypot(dx, dy) * (to - from));
  }
  const bool holds = near >= from && near <= to;
  if (depth == 0 && holds) return; // what is left out is below round-off
  if (!holds && distance > 0.9 * length) {
    add_gauss(e, from, to, x, y);
    return;
  }
  if (depth == 0) {
    add_gauss(e, from, to, x, y);
    return;
  }
  const double middle = holds && near > from && near < to ? near : 0.5 * (from + to);
  add_piece(e, from, middle, x, y, near, depth - 1);
  add_piece(e, middle, to, x, y, near, depth - 1);
}

void Assembly::add_point(int32_t node, double x, double y) {
  const int32_t f = p_.function_nodes;
  std::vector<double>* row[2] = {&out_.rows[index(2 * node)], &out_.rows[index(2 * node + 1)]};
  for (int32_t e = 1; e <= p_.elements(number_); ++e) {
    for (int32_t l = 0; l < 4; ++l)
      for (int k = 0; k < 2; ++k)
        for (int j = 0; j < 2; ++j) h_[l][k][j] = g_[l][k][j] = 0;
    double near = 3;
    for (int32_t l = 0; l < f; ++l)
      if (node_of_end(p_, body_, e, l) == node) near = place_of(f, l);
    add_piece(element_of(body_, e), -1, 1, x, y, near, 40);
    for (int32_t l = 0; l < f; ++l) {
      const int32_t other = node_of_end(p_, body_, e, l), end = (e - 1) * f + l;
      for (int k = 0; k < 2; ++k)
        for (int j = 0; j < 2; ++j) {
          if (other != node) (*row[k])[out_.u(other, j)] += h_[l][k][j];
          if (other != node) (*row[k])[out_.u(node, j)] -= h_[l][k][j]; // translations give no traction
          (*row[k])[out_.t(end, j)] -= g_[l][k][j];
        }
    }
  }
  (*row[0])[out_.motion(0)] = (*row[1])[out_.motion(1)] = -1;
  (*row[0])[out_.motion(2)] = y;
  (*row[1])[out_.motion(2)] = -x;
}

void Assembly::add_balance() {
  const int32_t f = p_.function_nodes;
  std::vector<double>* sums = &out_.rows[index(2 * out_.nodes)];
  for (int32_t e = 1; e <= p_.elements(number_); ++e)
    for (int part = 0; part < 4; ++part)
      for (int i = 0; i < kGauss; ++i) {
        const double s = i < kGauss / 2 ? -kPlace[i] : kPlace[i - kGauss / 2], eta = (s + 2 * part + 1) / 4 - 1;
        double px, py, dx, dy, value[4], slope[4];
        element_of(body_, e).at(eta, px, py, dx, dy);
        shapes(f, eta, value, slope);
        const double w = kWeight[i % (kGauss / 2)] * std::hypot(dx, dy) / 4;
        for (int32_t l = 0; l < f; ++l) {
          const int32_t end = (e - 1) * f + l;
          sums[0][out_.t(end, 0)] += w * value[l];
          sums[1][out_.t(end, 1)] += w * value[l];
          sums[2][out_.t(end, 0)] -= w * value[l] * py;
          sums[2][out_.t(end, 1)] += w * value[l] * px;
        }
      }
}

Equations Assembly::build() {
  const int32_t f = p_.function_nodes;
  out_.ends = p_.elements(number_) * f;
  for (int32_t e = 1; e <= p_.elements(number_); ++e)
    for (int32_t l = 0; l < f; ++l) out_.nodes = std::max(out_.nodes, node_of_end(p_, body_, e, l) + 1);
  out_.rows.assign(index(2 * out_.nodes + 3), std::vector<double>(out_.columns(), 0));
  std::vector<bool> done(index(out_.nodes), false);
  for (int32_t e = 1; e <= p_.elements(number_); ++e)
    for (int32_t l = 0; l < f; ++l) {
      const int32_t node = node_of_end(p_, body_, e, l);
      if (done[index(node)]) continue;
      done[index(node)] = true;
      double x, y, dx, dy;
      element_of(body_, e).at(place_of(f, l), x, y, dx, dy);
      add_point(node, x, y);
    }
  add_balance();
  return out_;
}

} // namespace

int32_t node_of_end(const Problem& p, const Body& body, int32_t element, int32_t local) {
  if (p.function_nodes == 1) return element - 1;
  const int32_t per = p.function_nodes - 1;
  const Range& r = region_of(body, element);
  const int32_t next = element == r.last ? r.first : element + 1;
  return local == per ? (next - 1) * per : (element - 1) * per + local;
}

Equations equations_of(const Problem& p, int32_t body) { return Assembly(p, body).build(); }

bool solve_dense(Matrix a, Matrix& b, double least, double* smallest) {
  const size_t n = a.size();
  std::vector<size_t> column(n);
  for (size_t j = 0; j < n; ++j) column[j] = j;
  double largest = 0, lowest = HUGE_VAL;
  for (size_t k = 0; k < n; ++k) {
    size_t row = k, col = k;
    for (size_t i = k; i < n; ++i)
      for (size_t j = k; j < n; ++j)
        if (std::fabs(a[i][j]) > std::fabs(a[row][col])) row = i, col = j;
    std::swap(a[k], a[row]);
    std::swap(b[k], b[row]);
    for (std::vector<double>& line : a) std::swap(line[k], line[col]);
    std::swap(column[k], column[col]);
    largest = std::max(largest, std::fabs(a[k][k]));
    lowest = std::min(lowest, std::fabs(a[k][k]));
    if (smallest) *smallest = largest > 0 ? lowest / largest : 0;
    if (!(std::fabs(a[k][k]) > least * largest)) return false;
    for (size_t i = k + 1; i < n; ++i) {
      const double factor = a[i][k] / a[k][k];
      if (factor == 0) continue;
      for (size_t j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
      for (size_t j = 0; j < b[i].size(); ++j) b[i][j] -= factor * b[k][j];
    }
  }
  Matrix x(n);
  for (size_t k = n; k-- > 0;) {
    for (size_t j = k + 1; j < n; ++j)
      for (size_t r = 0; r < b[k].size(); ++r) b[k][r] -= a[k][j] * b[j][r];
    for (double& value : b[k]) value /= a[k][k];
  }
  for (size_t k = 0; k < n; ++k) x[column[k]] = b[k];
  b = x;
  return true;
}

} // namespace random_decks
