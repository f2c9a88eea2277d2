#include "post/corner_fit.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

const double kBelow = 2.6; // exponents up to here may be terms of a fit
const size_t kEach = 6;    // samples for each term after the third: with fewer, terms would fit the errors of the results
using Column = std::vector<double>;

double product(const Column& a, const Column& b) {
  double sum = 0;
  for (size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// Least-squares factors of the columns for `rest`: modified Gram-Schmidt, applied twice.
std::vector<double> least_squares(const std::vector<Column>& columns, Column& rest) {
  const size_t n = columns.size();
  std::vector<Column> q = columns;
  std::vector<double> r(n * n), factor(n);
  for (size_t k = 0; k < n; ++k) {
    const double size = std::sqrt(product(q[k], q[k]));
    for (int round = 0; round < 2; ++round)
      for (size_t j = 0; j < k; ++j) {
        const double part = product(q[j], q[k]);
        r[j * n + k] += part;
        for (size_t i = 0; i < rest.size(); ++i) q[k][i] -= part * q[j][i];
      }
    const double left = std::sqrt(product(q[k], q[k]));
    r[k * n + k] = left;
    const double scale = left > 1e-12 * size ? 1 / left : 0; // 0: dependent on the columns before it
    for (double& v : q[k]) v *= scale;
    factor[k] = product(q[k], rest);
    for (size_t i = 0; i < rest.size(); ++i) rest[i] -= factor[k] * q[k][i];
  }
  for (size_t k = n; k-- > 0;) {
    for (size_t j = k + 1; j < n; ++j) factor[k] -= r[k * n + j] * factor[j];
    factor[k] = r[k * n + k] > 0 ? factor[k] / r[k * n + k] : 0;
  }
  return factor;
}

// ---- a notch

// Displacement of the face theta = alpha of the half wedge in a mode, for a unit intensity: 2G u = d^lambda (along, across).
struct Mode {
  Complex lambda, along, across;
};
Mode mode_of(Complex lambda, double alpha, double kappa, bool even) {
  const Complex p = lambda + 1.0, m = lambda - 1.0;
  const Complex cp = std::cos(p * alpha), sp = std::sin(p * alpha), cm = std::cos(m * alpha), sm = std::sin(m * alpha);
  // F = a cos(p theta) + b cos(m theta), odd: of sines, without shear at alpha or, where that leaves a and b free, without
  // normal stress; odd: the other way round.
  const bool by_shear = (even ? std::abs(m * sm) + std::abs(p * sp) : std::abs(m * cm) + std::abs(p * cp)) > 1e-6;
  const bool by_normal = (even ? std::abs(cm) + std::abs(cp) : std::abs(sm) + std::abs(sp)) > 1e-6;
  const bool shear = even ? by_shear : !by_normal;
  const Complex a = shear ? m * (even ? sm : cm) : (even ? cm : sm), b = shear ? -p * (even ? sp : cp) : (even ? -cp : -sp);
  Complex unit = std::sqrt(2 * kPi) * (even ? lambda * p * (a + b) : -lambda * (a * p + b * m));
  if (lambda.real() > 1 || lambda.real() < 0)
    unit = std::abs(a) + std::abs(b); // another term, which may have no stress on the bisector
  Mode mode{lambda, 0, 0};
  mode.along = (-p * a * (even ? cp : sp) + (kappa - lambda) * b * (even ? cm : sm)) / unit;
  mode.across = even ? (p * a * sp + (kappa + lambda) * b * sm) / unit : (-p * a * cp - (kappa + lambda) * b * cm) / unit;
  return mode;
}

} // namespace

namespace {

// K of the first term, and of as many others as there are samples for.
double fit_terms(const std::vector<PressureSample>& samples, double largest, const std::vector<Complex>& terms,
                 double& misfit) {
  const double first = terms.front().real() - 1;
  Column rest;
  for (const PressureSample& s : samples) rest.push_back(s.p * std::pow(s.d / largest, -first));
  const double all = product(rest, rest);
  std::vector<Column> columns;
  for (size_t k = 0; k < terms.size(); ++k) {
    const Complex lambda = terms[k];
    const size_t more = columns.size() + (lambda.imag() != 0 ? 2 : 1);
    if (k > 0 && (3 * more > samples.size() || (k >= 3 && kEach * (k + 1) > samples.size()))) break;
    Column real, imaginary;
    for (const PressureSample& s : samples) {
      const Complex power = std::pow(Complex(s.d / largest), lambda - 1.0 - first);
      real.push_back(power.real());
      imaginary.push_back(power.imag());
    }
    columns.push_back(real);
    if (lambda.imag() != 0) columns.push_back(imaginary);
  }
  const std::vector<double> factor = least_squares(columns, rest);
  misfit = all > 0 ? std::sqrt(product(rest, rest) / all) : 0;
  return (terms.front().imag() != 0 ? std::hypot(factor[0], factor[1]) : factor[0]) * std::pow(largest, -first);
}

} // namespace

CornerFit fit_pressure(const std::vector<PressureSample>& samples, const std::vector<Complex>& exponents) {
  double largest = 0;
  for (const PressureSample& s : samples) largest = std::max(largest, s.d);
  std::vector<Complex> terms = exponents;
  terms.insert(terms.begin() + 1, -std::conj(exponents.front())); // effect of the error of the elements at the corner
  CornerFit out;
  double unused = 0;
  out.K = fit_terms(samples, largest, terms, out.misfit);
  out.K_error = std::fabs(out.K - fit_terms(samples, largest, exponents, unused));
  return out;
}

std::vector<Complex> notch_exponents(const Sector& sector, bool even, double below) {
  CornerShape half;
  half.sectors = {sector};
  half.sectors[0].angle /= 2;
  half.faces = {{even ? FaceKind::kSmooth : FaceKind::kGuided, 0}, {FaceKind::kFree, 0}};
  return corner_exponents(half, below);
}

namespace {

// Rows: along and across of every sample, relative to the first mode's power of d.
class NotchSystem {
public:
  NotchSystem(const std::vector<NotchSample>& samples, const Notch& notch) : samples_(samples), alpha_(notch.sector.angle / 2) {
    for (const NotchSample& s : samples) largest_ = std::max(largest_, s.d);
    for (const NotchSample& s : samples) {
      const double theta = notch.bisector + (s.first ? -alpha_ : alpha_), c = std::cos(theta), d = std::sin(theta);
      for (const double u : {c * s.ux + d * s.uy, c * s.uy - d * s.ux}) values_.push_back(u);
    }
  }
  double largest() const { return largest_; }
  void weigh(double power) { power_ = power; }
  // One or two columns of a mode; on the first face the along part of an odd mode and the across part of an even one turn.
  void add(const Mode& mode, bool even) {
    Column real, imaginary;
    for (const NotchSample& s : samples_) {
      const Complex power = std::pow(Complex(s.d / largest_), mode.lambda - power_);
      const double along = s.first && !even ? -1 : 1, across = s.first && even ? -1 : 1;
      for (const Complex v : {along * power * mode.along, across * power * mode.across}) {
        real.push_back(v.real());
        imaginary.push_back(v.imag());
      }
    }
    columns_.push_back(real);
    if (mode.lambda.imag() != 0) columns_.push_back(imaginary);
  }
  // Motions of the whole: two translations and a rotation.
  void add_motions() {
    Column x, y, turn;
    for (const NotchSample& s : samples_) {
      const double w = std::pow(s.d / largest_, -power_), theta = s.first ? -alpha_ : alpha_;
      x.insert(x.end(), {w * std::cos(theta), -w * std::sin(theta)});
      y.insert(y.end(), {w * std::sin(theta), w * std::cos(theta)});
      turn.insert(turn.end(), {0.0, w * s.d / largest_});
    }
    columns_.insert(columns_.end(), {x, y, turn});
  }
  size_t size() const { return columns_.size(); }
  std::vector<double> solve(double& misfit) const {
    Column rest = values_;
    for (size_t i = 0; i < rest.size(); ++i) rest[i] *= std::pow(samples_[i / 2].d / largest_, -power_);
    Column deformation = rest; // without rigid-body motion, for the size of the rest
    least_squares({columns_[0], columns_[1], columns_[2]}, deformation);
    const std::vector<double> out = least_squares(columns_, rest);
    const double all = product(deformation, deformation);
    misfit = all > 0 ? std::sqrt(product(rest, rest) / all) : 0;
    return out;
  }

private:
  const std::vector<NotchSample>& samples_;
  double alpha_, largest_ = 0, power_ = 0;
  Column values_;
  std::vector<Column> columns_;
};

} // namespace

namespace {

// K and K2 to out, with or without the terms due to the error of the elements at the tip.
double fit_modes(const std::vector<NotchSample>& samples, const Notch& notch, const std::vector<Complex> (&list)[2], bool with,
                 double (&out)[2]) {
  const Sector& sector = notch.sector;
  NotchSystem system(samples, notch);
  system.weigh(list[0].front().real());
  system.add_motions();
  size_t place[2] = {0, 0};
  for (size_t k = 0; k < 2; ++k) // the first of each kind before the second ones
    for (int i = 0; i < 2; ++i) {
      if (k >= list[i].size() || (system.size() + 2) * 3 > 2 * samples.size()) continue;
      if (k == 0) place[i] = system.size();
      system.add(mode_of(list[i][k], sector.angle / 2, sector.kappa, i == 0), i == 0);
      if (with && k == 0 && list[i][0].real() < 1)
        system.add(mode_of(-list[i][0], sector.angle / 2, sector.kappa, i == 0), i == 0);
    }
  double misfit = 0;
  const std::vector<double> factor = system.solve(misfit);
  for (int i = 0; i < 2; ++i) {
    const bool singular = !list[i].empty() && list[i].front().real() < 1 - 1e-6 && place[i] > 0;
    out[i] = singular ? factor[place[i]] * 2 * sector.shear_modulus * std::pow(system.largest(), -list[i].front().real()) : 0;
  }
  return misfit;
}

} // namespace

CornerFit fit_notch(const std::vector<NotchSample>& samples, const Notch& notch) {
  const std::vector<Complex> list[2] = {notch_exponents(notch.sector, true, kBelow),
                                        notch_exponents(notch.sector, false, kBelow)};
  double with[2], without[2];
  CornerFit out;
  out.misfit = fit_modes(samples, notch, list, true, with);
  fit_modes(samples, notch, list, false, without);
  out.K = with[0], out.K2 = with[1];
  out.K_error = std::fabs(with[0] - without[0]), out.K2_error = std::fabs(with[1] - without[1]);
  return out;
}

} // namespace app
