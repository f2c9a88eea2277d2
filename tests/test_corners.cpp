// Sharp corners: exponents against closed forms and counts of zeros, intensities against closed forms, a reciprocal integral
// and finer meshes, and which corners are found.
#include "report/corner_exponent.hpp"
#include "report/corner_fit.hpp"
#include "report/corners.hpp"
#include "solved_bodies.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>

using namespace many;
using app::CornerKind;
using app::CornerShape;
using app::CornerState;
using app::FaceKind;

namespace {

const double kPi = std::acos(-1.0);
using Complex = std::complex<double>;

// ---- models

struct Found {
  std::vector<app::Corner> corners;
  std::vector<CornerState> states, in_step; // of the final state, and from the step's table
  double K(CornerKind kind, double x, double y) const {
    for (const CornerState& s : states)
      if (s.kind == kind && std::hypot(s.at[0] - x, s.at[1] - y) < 1e-9) return s.K;
    return NAN;
  }
  const CornerState* state(double x, double y) const {
    for (const CornerState& s : states)
      if (std::hypot(s.at[0] - x, s.at[1] - y) < 1e-9) return &s;
    return nullptr;
  }
};

Found found_in(Machine& machine) {
  Found out;
  app::Summary summary;
  REQUIRE(machine.status == C2D_OK);
  REQUIRE(app::get_summary(machine.solver, summary) == C2D_OK);
  REQUIRE(app::find_corners(machine.solver, summary, out.corners) == C2D_OK);
  const Result r = machine.run();
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  REQUIRE(app::corner_states(machine.solver, summary, out.corners, out.states) == C2D_OK);
  for (const app::Corner& c : out.corners)
    if (c.zone != 0) out.in_step.push_back(app::corner_state(c, r.last().rows.front().data(), C2D_PAIR_FIELDS));
  return out;
}
Found found_in(const Model& model) {
  Machine machine(model);
  return found_in(machine);
}

// A square plate, 0 < x < 2, |y| < 2, with a notch from the left of 90 degrees with its tip at (1, 0), pulled along y, and
// sheared as far as `shear` says; n elements on each face of the notch.
Model notched(int32_t n, double growth, double shear, int32_t order) {
  Model m;
  m.function_nodes = order;
  const int32_t k = 10;
  Body plate = polygon({{0, -2, k}, {2, -2, k}, {2, 2, k}, {0, 2, k / 2}, {0, 1, n, 1 / growth}, {1, 0, n, growth}, {0, -1, k / 2}});
  m.add(plate);
  m.set(1, 1, end_of("0110", -shear));
  m.set(1, 2, end_of(kPulled, 0, shear));
  m.set(1, 3, end_of(kPulled, shear, 1));
  m.set(1, 4, end_of(kPulled, 0, -shear));
  m.set(1, 7, end_of(kPulled, 0, -shear));
  const Range foot = m.side(1, 1);
  m.body(1).ends[static_cast<size_t>((foot.last - 1) * order)] = end_of("1100");
  return m;
}

// ---- a reciprocal integral: K from the field on a circle far from the tip

struct Field {
  Complex displacement, normal_traction; // x + i y; on a circle about the tip, outward
};
// Fields of a wedge |theta| < alpha with free faces: potentials phi = a z^q, psi = b z^q with real a, b or i times it.
class WedgeField {
public:
  WedgeField(double q, double alpha, bool even, double G, double nu) : q_(q), G_(G), kappa_(3 - 4 * nu) {
    // Resultant of the traction on a face: phi + z conj(phi') + conj(psi), zero on both.
    const Complex e = std::exp(Complex(0, alpha)), i = even ? 1.0 : Complex(0, 1);
    const Complex one = i * std::pow(e, q) + e * std::conj(i * q * std::pow(e, q - 1)), two = std::conj(i * std::pow(e, q));
    a_ = i, b_ = -(one / two).real() * i;
  }
  Field at(Complex z) const {
    const Complex phi = a_ * std::pow(z, q_), dphi = a_ * q_ * std::pow(z, q_ - 1), ddphi = a_ * q_ * (q_ - 1) * std::pow(z, q_ - 2);
    const Complex psi = b_ * std::pow(z, q_), dpsi = b_ * q_ * std::pow(z, q_ - 1);
    const double sum = 4 * dphi.real(); // sxx + syy
    const Complex difference = 2.0 * (std::conj(z) * ddphi + dpsi); // syy - sxx + 2i sxy
    const double syy = (sum + difference.real()) / 2, sxx = sum - syy, sxy = difference.imag() / 2;
    const Complex n = z / std::abs(z);
    return {(kappa_ * phi - z * std::conj(dphi) - std::conj(psi)) / (2 * G_),
            Complex(sxx * n.real() + sxy * n.imag(), sxy * n.real() + syy * n.imag())};
  }
  // Stress on the bisector at distance 1: s_tt of even, s_rt of odd fields.
  Complex on_bisector() const {
    const Complex difference = 2.0 * (a_ * q_ * (q_ - 1) + b_ * q_);
    return (4 * (a_ * q_).real() + difference.real()) / 2 + Complex(0, difference.imag() / 2);
  }

private:
  double q_, G_, kappa_;
  Complex a_, b_;
};
double dot(Complex a, Complex b) { return a.real() * b.real() + a.imag() * b.imag(); }

// Gauss' rule on many pieces; all fields are smooth there.
template <class F> double over_arc(double alpha, double r, F f) {
  const int pieces = 200;
  double sum = 0;
  for (int i = 0; i < pieces; ++i)
    for (const double g : {-std::sqrt(0.6), 0.0, std::sqrt(0.6)})
      sum += (g == 0.0 ? 8.0 : 5.0) / 18 * 2 * alpha / pieces * r * f(-alpha + 2 * alpha * (i + 0.5 + g / 2) / pieces);
  return sum;
}

// Betti with the field of the power -lambda on a circle of radius r; `bisector`: its direction.
double reciprocal_intensity(c2d_solver* solver, Complex tip, double bisector, double alpha, double lambda, bool even, double r,
                            double G, double nu) {
  const WedgeField own(lambda, alpha, even, G, nu), dual(-lambda, alpha, even, G, nu);
  const auto mixed = [](const Field& a, const Field& b) {
    return dot(a.normal_traction, b.displacement) - dot(b.normal_traction, a.displacement);
  };
  const double unit = over_arc(alpha, 1, [&](double t) { return mixed(own.at(std::polar(1.0, t)), dual.at(std::polar(1.0, t))); });
  const double seen = over_arc(alpha * (1 - 1e-9), r, [&](double t) {
    const Complex turn = std::polar(1.0, bisector), z = std::polar(r, t), p = tip + z * turn;
    const double xy[2] = {p.real(), p.imag()};
    double v[C2D_POINT_FIELDS];
    REQUIRE(c2d_interior(solver, 1, 1, xy, 2, v, C2D_POINT_FIELDS) == C2D_OK);
    REQUIRE(v[C2D_POINT_FLAG] != C2D_POINT_OUTSIDE);
    const Complex n = turn * z / r;
    const Complex t0(v[C2D_POINT_SXX] * n.real() + v[C2D_POINT_SXY] * n.imag(),
                     v[C2D_POINT_SXY] * n.real() + v[C2D_POINT_SYY] * n.imag());
    return mixed({Complex(v[C2D_POINT_UX], v[C2D_POINT_UY]) / turn, t0 / turn}, dual.at(z));
  });
  const Complex stress = own.on_bisector();
  return seen / unit * (even ? stress.real() : stress.imag()) * std::sqrt(2 * kPi);
}

} // namespace

TEST_CASE("corners: a notch under tension and shear has the intensities of a reciprocal integral") {
  const double lambda[2] = {0.5444837367824622, 0.9085291898460987}, alpha = 3 * kPi / 4;
  for (const int32_t order : {2, 3}) {
    for (const int32_t n : {15, 30}) {
      Machine machine(notched(n, 1.4, 0.5, order));
      const Found f = found_in(machine);
      const CornerState* s = f.state(1, 0);
      REQUIRE(s != nullptr);
      MESSAGE("order " << order << " n " << n << " K " << s->K << " K2 " << s->K2 << " misfit " << s->misfit << s->why);
      for (const double r : {0.3, 0.6})
        for (int i = 0; i < 2; ++i)
          MESSAGE("r " << r << ": " << reciprocal_intensity(machine.solver, 1, 0, alpha, lambda[i], i == 0, r, 1000 / 2.6, 0.3));
    }
  }
}
