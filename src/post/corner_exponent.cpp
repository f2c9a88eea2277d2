#include "post/corner_exponent.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace app {
namespace {

// Stress and displacement on a ray for each of the four functions of a sector, without their powers of r: s_tt/lambda,
// s_rt/lambda, 2G u_r, 2G u_t. Airy functions r^(lambda+1) F(theta) have F = cos, sin of (lambda+1) theta, and F = cos, sin
// of (lambda-1) theta less and plus the former, which leaves translations at lambda = 0.
enum { kNormal = 0, kShear = 1, kAlong = 2, kAcross = 3 };
using Ray = std::array<std::array<Complex, 4>, 4>; // [quantity][function]

Ray on_ray(Complex lambda, double theta, double kappa) {
  const Complex p = lambda + 1.0, m = lambda - 1.0;
  const Complex cp = std::cos(p * theta), sp = std::sin(p * theta), cm = std::cos(m * theta), sm = std::sin(m * theta);
  Ray r;
  const Complex along = kappa - lambda, across = kappa + lambda;
  r[kNormal] = {p * cp, p * sp, p * (cm - cp), p * (sm + sp)};
  r[kShear] = {p * sp, -p * cp, m * sm - p * sp, -m * cm - p * cp};
  r[kAlong] = {-p * cp, -p * sp, along * cm + p * cp, along * sm - p * sp};
  r[kAcross] = {p * sp, -p * cp, across * sm - p * sp, -across * cm - p * cp};
  return r;
}

// Determinant of an n by n matrix by elimination with row pivots; destroys it.
Complex determinant(std::vector<Complex>& a, size_t n) {
  Complex product = 1;
  for (size_t k = 0; k < n; ++k) {
    size_t pivot = k;
    for (size_t i = k + 1; i < n; ++i)
      if (std::norm(a[i * n + k]) > std::norm(a[pivot * n + k])) pivot = i;
    if (a[pivot * n + k] == 0.0) return 0;
    if (pivot != k) {
      product = -product;
      std::swap_ranges(a.begin() + static_cast<long>(k * n), a.begin() + static_cast<long>((k + 1) * n),
                       a.begin() + static_cast<long>(pivot * n));
    }
    product *= a[k * n + k];
    for (size_t i = k + 1; i < n; ++i) {
      const Complex factor = a[i * n + k] / a[k * n + k];
      for (size_t j = k + 1; j < n; ++j) a[i * n + j] -= factor * a[k * n + j];
    }
  }
  return product;
}

// The conditions of all faces, row by row.
class Conditions {
public:
  Conditions(const CornerShape& shape, Complex lambda) : shape_(shape), lambda_(lambda), n_(4 * shape.sectors.size()) {
    a_.reserve(n_ * n_);
    softest_ = std::numeric_limits<double>::infinity();
    for (const Sector& s : shape.sectors) softest_ = std::min(softest_, s.shear_modulus);
    outer(0, 0.0, shape.faces.front());
    for (size_t k = 1; k < shape.sectors.size(); ++k) joint(k - 1, shape.faces[k]);
    outer(n_ / 4 - 1, shape.sectors.back().angle, shape.faces.back());
  }
  Complex value() { return determinant(a_, n_); }

private:
  // A row of `factor` times quantity a, and `other` times quantity b, of the sector's ray.
  void add(size_t sector, const Ray& ray, int a, double factor, int b = 0, double other = 0) {
    Complex* row = &a_[a_.size() - n_ + 4 * sector];
    for (size_t k = 0; k < 4; ++k) row[k] += factor * ray[static_cast<size_t>(a)][k] + other * ray[static_cast<size_t>(b)][k];
  }
  void new_row() { a_.resize(a_.size() + n_); }
  double flexibility(size_t sector) const { return softest_ / shape_.sectors[sector].shear_modulus; }
  void outer(size_t sector, double theta, const Face& face) {
    const Ray ray = on_ray(lambda_, theta, shape_.sectors[sector].kappa);
    const bool free = face.kind == FaceKind::kFree, guided = face.kind == FaceKind::kGuided;
    new_row();
    add(sector, ray, free || guided ? kNormal : kAcross, 1);
    new_row();
    if (face.kind == FaceKind::kBonded || guided)
      add(sector, ray, kAlong, 1);
    else
      add(sector, ray, kShear, 1, kNormal, face.kind == FaceKind::kRubbing ? -face.friction : 0);
  }
  // Between a sector, at its end, and the next one, at its beginning.
  void joint(size_t k, const Face& face) {
    const Ray before = on_ray(lambda_, shape_.sectors[k].angle, shape_.sectors[k].kappa);
    const Ray after = on_ray(lambda_, 0.0, shape_.sectors[k + 1].kappa);
    const auto equal = [&](int what, double first, double second) {
      new_row();
      add(k, before, what, first);
      add(k + 1, after, what, -second);
    };
    equal(kNormal, 1, 1);
    equal(kAcross, flexibility(k), flexibility(k + 1));
    equal(kShear, 1, 1);
    if (face.kind == FaceKind::kBonded) {
      equal(kAlong, flexibility(k), flexibility(k + 1));
      return;
    }
    new_row();
    add(k, before, kShear, 1, kNormal, face.kind == FaceKind::kRubbing ? -face.friction : 0);
  }

  const CornerShape& shape_;
  Complex lambda_;
  size_t n_;
  double softest_;
  std::vector<Complex> a_;
};

// ---- the search for zeros

const double kLowest = 0.002, kHighest = 1; // real part from, imaginary part to
const double kAtOne = 1e-6;                 // nearer to 1 is 1
const double kDouble = 1e-5;                // two zeros nearer to each other than this are one double zero

class Search {
public:
  Search(const CornerShape& shape, double below) : shape_(shape), below_(below) {
    const auto turns = [](const Face& f) { return f.kind == FaceKind::kFree || f.kind == FaceKind::kGuided; };
    if (turns(shape.faces.front()) && turns(shape.faces.back())) outside_.push_back(1);
  }
  std::vector<Complex> run() {
    scan_plane();
    scan_axis();
    merge_double();
    std::sort(found_.begin(), found_.end(), [](const Complex& a, const Complex& b) {
      return a.real() != b.real() ? a.real() < b.real() : a.imag() < b.imag();
    });
    return found_;
  }

private:
  Complex value(Complex z) const { return corner_determinant(shape_, z); }
  double on_axis(double x) const { return value(x).real(); }
  // Deflated by the zeros found so far.
  Complex deflated(Complex z) const {
    Complex product = 1;
    for (const std::vector<Complex>* list : {&found_, &outside_})
      for (const Complex& known : *list) product *= known.imag() == 0 ? z - known : (z - known) * (z - std::conj(known));
    return value(z) / product;
  }
  bool muller(Complex start, double step, bool deflate, Complex& out) const;
  void take(Complex z, std::vector<Complex>& list);
  void follow(Complex start, double step);
  void scan_plane();
  void scan_axis();
  void merge_double();
  bool is_known(double x) const {
    return std::any_of(found_.begin(), found_.end(), [&](const Complex& z) { return std::abs(z - x) < 2 * kDouble; });
  }

  const CornerShape& shape_;
  double below_;
  std::vector<Complex> found_;
  std::vector<Complex> outside_; // zeros that are not wanted; the first is 1 if the body can rotate
};

// Muller iteration: the nearer zero of the parabola through the last three points.
bool Search::muller(Complex start, double step, bool deflate, Complex& out) const {
  const auto f = [&](Complex z) { return deflate ? deflated(z) : value(z); };
  Complex x0 = start - step, x1 = start + Complex(0, 0.37 * step), x2 = start;
  Complex f0 = f(x0), f1 = f(x1), f2 = f(x2);
  for (int i = 0; i < 60; ++i) {
    const Complex d1 = (f1 - f0) / (x1 - x0), d2 = (f2 - f1) / (x2 - x1), second = (d2 - d1) / (x2 - x0);
    const Complex slope = d2 + second * (x2 - x1), root = std::sqrt(slope * slope - 4.0 * f2 * second);
    const Complex below = std::abs(slope + root) > std::abs(slope - root) ? slope + root : slope - root;
    if (below == 0.0 || f2 == 0.0) {
      out = x2;
      return f2 == 0.0;
    }
    const Complex move = -2.0 * f2 / below;
    if (!std::isfinite(std::abs(move)) || std::abs(move) > 1) return false;
    x0 = x1, f0 = f1, x1 = x2, f1 = f2, x2 += move;
    if (std::abs(move) < 1e-14) {
      out = x2;
      return true;
    }
    f2 = f(x2);
  }
  out = x2;
  return std::abs(x2 - x1) < 1e-9;
}

// A zero of the deflated function, polished on the function itself.
void Search::take(Complex z, std::vector<Complex>& list) {
  Complex polished;
  if (muller(z, 1e-5, false, polished) && std::abs(polished - z) < 1e-7) z = polished;
  z = Complex(z.real(), std::fabs(z.imag()));
  if (z.imag() < 1e-9) z = z.real();
  list.push_back(z);
}

// All zeros about a point where the modulus is least.
void Search::follow(Complex start, double step) {
  Complex z;
  for (int i = 0; i < 4 && muller(start, step / 4, true, z); ++i) {
    const bool inside = z.real() > kLowest && z.real() < below_ && std::fabs(z.imag()) < kHighest;
    take(z, inside && std::abs(z - 1.0) > kAtOne ? found_ : outside_);
  }
}

// The modulus of an analytic function is least at a zero only.
void Search::scan_plane() {
  const double step = 0.04;
  const size_t across = static_cast<size_t>(std::ceil((below_ - kLowest) / step)) + 3;
  const size_t up = static_cast<size_t>(kHighest / step) + 2;
  std::vector<double> size(across * up);
  const auto point = [&](size_t i, size_t j) {
    return Complex(kLowest + (static_cast<double>(i) - 1) * step + 1e-5, static_cast<double>(j) * step);
  };
  for (size_t i = 0; i < across; ++i) // nothing is found yet
    for (size_t j = 0; j < up; ++j) size[i * up + j] = std::abs(deflated(point(i, j)));
  for (size_t i = 1; i + 1 < across; ++i)
    for (size_t j = 0; j + 1 < up; ++j) {
      const double here = size[i * up + j];
      bool least = true;
      for (size_t k = i - 1; k <= i + 1; ++k) // the lower half plane mirrors the upper one
        for (const size_t l : {j > 0 ? j - 1 : 1, j, j + 1}) least = least && here <= size[k * up + l];
      if (least) follow(point(i, j), step);
    }
}

// A change of sign on the real axis that has no zero yet.
void Search::scan_axis() {
  const double step = 0.002;
  for (double a = kLowest; a < below_; a += step) {
    double low = a, high = std::min(a + step, below_);
    if (!outside_.empty() && low < 1 && high > 1 - 2 * kAtOne) high = 1 - 2 * kAtOne;
    double at_low = on_axis(low);
    if (at_low * on_axis(high) >= 0) continue;
    while (high - low > 4e-16 * high) {
      const double middle = low + (high - low) / 2, now = on_axis(middle);
      if (now * at_low > 0)
        low = middle, at_low = now;
      else
        high = middle;
    }
    const double root = low + (high - low) / 2;
    if (!is_known(root)) found_.push_back(root);
  }
}

// The two halves of a double zero have errors of the root of round-off, their mean has not.
void Search::merge_double() {
  for (size_t i = 0; i < found_.size(); ++i)
    for (size_t j = i + 1; j < found_.size(); ++j) {
      if (std::abs(found_[i] - found_[j]) > kDouble) continue;
      const Complex mean = 0.5 * (found_[i] + found_[j]);
      found_[i] = found_[j] = std::fabs(mean.imag()) < kDouble ? mean.real() : mean;
    }
}

} // namespace

Sector sector_of(double angle, double youngs_modulus, double nu, bool plane_strain) {
  return {angle, youngs_modulus / (2 * (1 + nu)), plane_strain ? 3 - 4 * nu : (3 - nu) / (1 + nu)};
}

Complex corner_determinant(const CornerShape& shape, Complex lambda) { return Conditions(shape, lambda).value(); }

std::vector<Complex> corner_exponents(const CornerShape& shape, double below) {
  const bool complete = !shape.sectors.empty() && shape.faces.size() == shape.sectors.size() + 1;
  return complete ? Search(shape, below).run() : std::vector<Complex>();
}

double exponent(const CornerShape& shape) {
  const std::vector<Complex> all = corner_exponents(shape, 1);
  return all.empty() ? 1 : all.front().real();
}

} // namespace app
