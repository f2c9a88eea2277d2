// Integrals of the torsion kernels over the elements of a body. Phases for one source and one element:
//   1. The source is a node of the element: the panels beside it, where the kernels are logarithmic, by the tanh-sinh rule.
//   2. The rest is bisected until every panel is at least half its length away from the source; a Gauss rule for each.
//   3. The factor of phi at the source itself is minus the sum of all others: a rigid rotation needs no tractions.
#include "post/torsion/twist_body.hpp"

#include "post/torsion/twist_kernels.hpp"

#include <cmath>

namespace app {
namespace {

constexpr double kRingPi = 3.14159265358979323846;

// Gauss rules with an even number of points on -1 ... 1.
struct GaussRule {
  std::vector<double> at, weight;
  explicit GaussRule(int n) {
    for (int i = 0; i < n; ++i) {
      double x = std::cos(kRingPi * (i + 0.75) / (n + 0.5)), slope = 1;
      for (int step = 0; step < 100; ++step) {
        double p = 1, before = 0;
        for (int k = 1; k <= n; ++k) {
          const double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
          before = p, p = next;
        }
        slope = n * (x * p - before) / (x * x - 1);
        const double move = p / slope;
        x -= move;
        if (std::fabs(move) < 1e-16) break;
      }
      at.push_back(x), weight.push_back(2 / ((1 - x * x) * slope * slope));
    }
  }
};

// The tanh-sinh rule on 0 ... 1: exact to round-off for functions with a logarithm at 0.
struct EndRule {
  std::vector<double> at, weight;
  EndRule() {
    constexpr double kStep = 1.0 / 8;
    for (int k = -26; k <= 26; ++k) {
      const double t = kStep * k, q = std::exp(-kRingPi * std::sinh(t)), x = 1 / (1 + q);
      at.push_back(x), weight.push_back(kStep * kRingPi * std::cosh(t) * x * x * q);
    }
  }
};

const GaussRule& gauss(bool is_near) {
  static const GaussRule near(16), far(8);
  return is_near ? near : far;
}
const EndRule& end_rule() {
  static const EndRule rule;
  return rule;
}

constexpr double kNearPanel = 0.5, kFarPanel = 2; // least distance of a panel in its lengths, for each Gauss rule
constexpr double kOfRadius = 0.7;                 // longest panel beside a source: its reflection in the axis is singular too
constexpr double kTaylor = 1e-4;                  // nearer to the source, in elements, by tangent and curvature
constexpr int kMostPanels = 60;
constexpr double kOnPlane = 1e-12; // a node so near to the plane of symmetry lies on it; bodies have a size of about 1

// Factors of one source and one element.
struct Factors {
  double phi[kTwistNodes] = {}, tau[kTwistNodes] = {};
};

class ElementIntegral {
public:
  ElementIntegral(const TwistBody& body, const TwistElement& element, Point source, int own, Factors& out)
      : body_(body), e_(element), p_(source), own_(own), out_(out) {
    if (own >= 0) eta_ = -1 + 2.0 * own / static_cast<double>(body.order), here_ = e_.at(eta_);
  }
  void add();

private:
  void add_at(double eta, double from_source, double weight);
  void panels(double from, double to, int depth);
  void beside(double to);
  Point away(double eta, double from_source, const TwistCurve::Local& at) const;

  const TwistBody& body_;
  const TwistElement& e_;
  Point p_;
  int own_; // local node at the source; -1: none
  double eta_ = 0;
  TwistCurve::Local here_;
  Factors& out_;
};

// From the source to a place of its element. Differences of coordinates would lose digits.
Point ElementIntegral::away(double eta, double from_source, const TwistCurve::Local& at) const {
  if (own_ < 0) return at.at - p_;
  const double s = from_source * e_.half();
  if (!e_.curve->is_straight() && std::fabs(eta - eta_) > kTaylor) return at.at - p_;
  return s * here_.along + (s * s * here_.bend / 2) * turned_left(here_.along);
}

void ElementIntegral::add_at(double eta, double from_source, double weight) {
  const TwistCurve::Local at = e_.at(eta);
  const Point d = away(eta, from_source, at);
  const double n[2] = {at.along.y, -at.along.x};
  const double ds = weight * e_.half(), r = p_.x + d.x;
  double shape[kTwistNodes];
  twist_shapes(body_.order, eta, shape);
  const TwistKernels k = twist_kernels(p_.x, d.x, d.y, n);
  double of_tau = k.u;
  if (e_.facing != nullptr) {
    const TwistElement& f = *e_.facing;
    const double other = f.at(-eta).at.x;
    of_tau *= other * other * f.half() / (r * r * e_.half());
  }
  for (size_t i = 0; i <= body_.order; ++i) {
    if (static_cast<int>(i) != own_) out_.phi[i] += ds * k.t * shape[i];
    if (static_cast<int>(i) != own_ || p_.x > 0) out_.tau[i] += ds * of_tau * shape[i];
  }
}

// A panel of local coordinates without the source at its ends.
void ElementIntegral::panels(double from, double to, int depth) {
  const TwistCurve::Local a = e_.at(from), b = e_.at(to), middle = e_.at((from + to) / 2);
  const double size = (to - from) * e_.half();
  const double near = std::min({distance(a.at, p_), distance(b.at, p_), distance(middle.at, p_)});
  const double least = std::max(0.0, near - size / 4); // the nearest of these points is at most a quarter panel farther
  if (least < kNearPanel * size && depth < kMostPanels) {
    panels(from, (from + to) / 2, depth + 1);
    panels((from + to) / 2, to, depth + 1);
    return;
  }
  const GaussRule& rule = gauss(least < kFarPanel * size || !e_.curve->is_straight());
  for (size_t k = 0; k < rule.at.size(); ++k) {
    const double eta = (from + to) / 2 + (to - from) / 2 * rule.at[k];
    add_at(eta, eta - eta_, (to - from) / 2 * rule.weight[k]);
  }
}

// From the source to an end of the element.
void ElementIntegral::beside(double to) {
  const double whole = std::fabs(to - eta_), sign = to > eta_ ? 1 : -1;
  if (whole < 1e-14) return;
  const double limit = p_.x > 0 ? kOfRadius * p_.x / e_.half() : whole;
  const double first = std::min({whole, limit, 1.0});
  const EndRule& rule = end_rule();
  for (size_t k = 0; k < rule.at.size(); ++k)
    add_at(eta_ + sign * first * rule.at[k], sign * first * rule.at[k], first * rule.weight[k]);
  if (first < whole) sign > 0 ? panels(eta_ + first, to, 0) : panels(to, eta_ - first, 0);
}

void ElementIntegral::add() {
  if (own_ < 0) return panels(-1, 1, 0);
  beside(-1), beside(1);
}

} // namespace

void twist_shapes(size_t order, double eta, double out[kTwistNodes]) {
  const double n = static_cast<double>(order), x = (eta + 1) * n / 2;
  for (size_t i = 0; i <= order; ++i) {
    out[i] = 1;
    for (size_t k = 0; k <= order; ++k)
      if (k != i) out[i] *= (x - static_cast<double>(k)) / (static_cast<double>(i) - static_cast<double>(k));
  }
}

void twist_slopes(size_t order, double eta, double out[kTwistNodes]) {
  const double n = static_cast<double>(order), x = (eta + 1) * n / 2;
  for (size_t i = 0; i <= order; ++i) {
    out[i] = 0;
    for (size_t j = 0; j <= order; ++j) {
      if (j == i) continue;
      double product = 1 / (static_cast<double>(i) - static_cast<double>(j));
      for (size_t k = 0; k <= order; ++k)
        if (k != i && k != j) product *= (x - static_cast<double>(k)) / (static_cast<double>(i) - static_cast<double>(k));
      out[i] += product;
    }
    out[i] *= n / 2;
  }
}

TwistEquations twist_equations(const TwistBody& body, bool integrals) {
  const size_t local = body.order + 1;
  const size_t rows = integrals ? body.nodes : 0;
  TwistEquations out{TwistMatrix(rows, body.nodes), TwistMatrix(rows, body.elements.size() * local),
                     std::vector<double>(body.elements.size() * local, 0.0), std::vector<Point>(body.nodes)};
  for (size_t e = 0; e < body.elements.size(); ++e) {
    const TwistElement& element = body.elements[e];
    for (size_t i = 0; i < local; ++i)
      out.at[element.node[i]] = element.at(-1 + 2.0 * static_cast<double>(i) / static_cast<double>(body.order)).at;
    const TwistElement& area = element.facing != nullptr ? *element.facing : element;
    const GaussRule& rule = gauss(true);
    for (size_t k = 0; k < rule.at.size(); ++k) {
      double shape[kTwistNodes];
      twist_shapes(body.order, rule.at[k], shape);
      const double r = area.at(element.facing != nullptr ? -rule.at[k] : rule.at[k]).at.x;
      for (size_t i = 0; i < local; ++i)
        out.torque[e * local + i] += 2 * kRingPi * r * r * rule.weight[k] * area.half() * shape[i];
    }
  }
  for (size_t p = 0; p < rows; ++p) {
    double* phi = out.phi.row(p);
    double* tau = out.tau.row(p);
    double sum = 0;
    for (size_t e = 0; e < body.elements.size(); ++e) {
      const TwistElement& element = body.elements[e];
      Factors f;
      int own = -1;
      for (size_t i = 0; i < local; ++i)
        if (element.node[i] == p) own = static_cast<int>(i);
      ElementIntegral(body, element, out.at[p], own, f).add();
      if (body.mirror) {
        const Point image{out.at[p].x, 2 * *body.mirror - out.at[p].y};
        const bool on_plane = std::fabs(image.y - out.at[p].y) < kOnPlane;
        if (on_plane) {
          for (double& v : f.phi) v *= 2;
          for (double& v : f.tau) v *= 2;
        } else {
          ElementIntegral(body, element, image, -1, f).add();
        }
      }
      for (size_t i = 0; i < local; ++i) {
        if (element.node[i] != p) phi[element.node[i]] += f.phi[i];
        if (element.node[i] != p) sum += f.phi[i];
        tau[e * local + i] += f.tau[i];
      }
    }
    phi[p] = -sum;
  }
  return out;
}

} // namespace app
