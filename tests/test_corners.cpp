// Sharp corners: intensities against closed forms, a reciprocal integral and finer meshes, and which corners are found.
#include "family_runs.hpp"
#include "post/corners.hpp"
#include "shell.hpp"
#include "solved_bodies.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <complex>

using namespace many;
using namespace solved_bodies;
using app::CornerKind;
using app::CornerState;

namespace {

const double kPi = std::acos(-1.0);
using Complex = std::complex<double>;

// ---- models

struct Found {
  std::vector<app::Corner> corners;
  std::vector<CornerState> states, in_step; // of the final state, and from the step's table
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
  Body plate =
      polygon({{0, -2, k}, {2, -2, k}, {2, 2, k}, {0, 2, k / 2}, {0, 1, n, 1 / growth}, {1, 0, n, growth}, {0, -1, k / 2}});
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
    const Complex phi = a_ * std::pow(z, q_), dphi = a_ * q_ * std::pow(z, q_ - 1),
                  ddphi = a_ * q_ * (q_ - 1) * std::pow(z, q_ - 2);
    const Complex psi = b_ * std::pow(z, q_), dpsi = b_ * q_ * std::pow(z, q_ - 1);
    const double sum = 4 * dphi.real();                             // sxx + syy
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
  const double unit =
      over_arc(alpha, 1, [&](double t) { return mixed(own.at(std::polar(1.0, t)), dual.at(std::polar(1.0, t))); });
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

// ---- contacts and supports

// A block with its upper side pulled down; on its middle stretch |x| < 1 of the upper side it is held and moved by `down`.
enum class Hold { kSupport, kPlaten };
Model pressed(Hold hold, int32_t order) {
  const double L = 200, growth = 1.5;
  Model m;
  m.function_nodes = order;
  const int32_t out = 41, in = 28;
  m.add(polygon({{-L, -L, 8},
                 {L, -L, 8},
                 {L, 0, out, 1 / growth},
                 {1, 0, in, growth},
                 {0, 0, in, 1 / growth},
                 {-1, 0, out, growth},
                 {-L, 0, 8}}));
  m.set(1, 1, end_of(kHeld));
  if (hold == Hold::kSupport) {
    for (const int32_t side : {4, 5}) m.set(1, side, end_of(kHeld, 0, 0, 0, -1));
    return m;
  }
  Platen platen;
  platen.side = {1, m.side(1, 4).first, m.side(1, 5).last};
  for (int32_t& free : platen.is_free) free = 0;
  platen.motion[1] = -1;
  m.platens.push_back(platen);
  return m;
}

// A square of side 2 pressed on a half plane without friction, both of the same material.
Model square_on_half_plane(int32_t n, int32_t order, double mu = 0) {
  const double L = 40, growth = std::pow(1e5, 1.0 / n);
  Model m;
  m.function_nodes = order;
  m.friction = mu;
  const int32_t out = n + n / 4, k = 6;
  m.add(polygon({{-L, -L, k},
                 {L, -L, k},
                 {L, 0, out, 1 / growth},
                 {1, 0, n, growth},
                 {0, 0, n, 1 / growth},
                 {-1, 0, out, growth},
                 {-L, 0, k}}));
  m.add(polygon({{-1, 0, n, growth}, {0, 0, n, 1 / growth}, {1, 0, n, growth}, {1, 2, 12}, {-1, 2, n, 1 / growth}}));
  m.set(1, 1, end_of(kHeld));
  m.set(2, 4, end_of("0110", 0, 0, 0, -0.01));
  const Range top = m.side(2, 4);
  m.body(2).ends[static_cast<size_t>((top.first - 1) * order)] = end_of(kHeld, 0, 0, 0, -0.01);
  Zone zone;
  zone.kind = C2D_ZONE_MATCHING;
  zone.side[0] = {1, m.side(1, 4).first, m.side(1, 5).last};
  zone.side[1] = {2, m.side(2, 2).last, m.side(2, 1).first};
  m.zones.push_back(zone);
  return m;
}

std::vector<app::Corner> places(const Model& m) {
  Machine machine(m);
  app::Summary summary;
  std::vector<app::Corner> corners;
  REQUIRE_MESSAGE(machine.status == C2D_OK, std::string(machine.told.empty() ? "" : machine.told[0].text));
  REQUIRE(app::get_summary(machine.solver, summary) == C2D_OK);
  REQUIRE(app::find_corners(machine.solver, summary, corners) == C2D_OK);
  return corners;
}

} // namespace

TEST_CASE("corners: a notch under tension and shear has the intensities of a reciprocal integral") {
  const double lambda[2] = {0.5444837367824622, 0.9085291898460987}, alpha = 3 * kPi / 4;
  const struct {
    int32_t order, n;
    double K, K2;
  } limits[] = {{2, 30, 1e-2, 1e-3}, {3, 15, 2e-3, 1e-3}, {3, 30, 3e-4, 5e-4}};
  for (const auto& row : limits) {
    Machine machine(notched(row.n, 1.4, 0.5, row.order));
    const Found f = found_in(machine);
    const CornerState* s = f.state(1, 0);
    REQUIRE(s != nullptr);
    CHECK(s->kind == CornerKind::kNotch);
    CHECK(s->K_error < (row.order > 2 ? 2e-2 : 6e-2) * s->K);
    const double K = reciprocal_intensity(machine.solver, 1, 0, alpha, lambda[0], true, 0.5, 1000 / 2.6, 0.3);
    const double K2 = reciprocal_intensity(machine.solver, 1, 0, alpha, lambda[1], false, 0.5, 1000 / 2.6, 0.3);
    CHECK(std::fabs(s->K / K - 1) < row.K);
    CHECK(std::fabs(s->K2 / K2 - 1) < row.K2);
    CHECK(std::fabs(s->K - K) < s->K_error); // an estimate, but a fair one
    CHECK(std::fabs(s->K2 - K2) < s->K2_error);
  }
}

TEST_CASE("corners: a notch on a line of symmetry has the intensity of the whole one") {
  const double growth = 1.4;
  const int32_t n = 25, k = 10;
  const auto plate = [&](bool whole) {
    Model m;
    m.function_nodes = 3;
    if (whole)
      m.add(polygon({{0, -2, k},
                     {2, -2, k},
                     {2, 0, k},
                     {2, 2, k},
                     {0, 2, k / 2},
                     {0, 1, n, 1 / growth},
                     {1, 0, n, growth},
                     {0, -1, k / 2}}));
    else
      m.add(open_polygon({{2, 0, k}, {2, 2, k}, {0, 2, k / 2}, {0, 1, n, 1 / growth}, {1, 0, 0}}));
    if (!whole) m.symmetry = 2;
    m.set(1, whole ? 4 : 2, end_of(kPulled, 0, 1));
    if (whole) m.set(1, 1, end_of(kPulled, 0, -1));
    // What holds the plate along x; the whole one also across its line.
    const Range right = m.side(1, whole ? 3 : 1);
    m.body(1).ends[static_cast<size_t>((right.first - 1) * m.function_nodes)] = end_of(whole ? "1100" : "1001");
    if (whole) m.body(1).ends[static_cast<size_t>((m.side(1, 2).last - 1) * m.function_nodes) + 2] = end_of("1100");
    if (whole) m.body(1).ends[static_cast<size_t>((m.side(1, 2).first - 1) * m.function_nodes) + 1] = end_of("1001");
    return m;
  };
  const Found whole = found_in(plate(true)), half = found_in(plate(false));
  REQUIRE(whole.state(1, 0) != nullptr);
  REQUIRE(half.state(1, 0) != nullptr);
  CHECK(half.state(1, 0)->K2 == doctest::Approx(0));
  CHECK(std::fabs(half.state(1, 0)->K / whole.state(1, 0)->K - 1) < 1e-6);
  Model turned; // reflected: its curve begins where that of the other one ends
  turned.function_nodes = 3, turned.symmetry = 2;
  turned.add(open_polygon({{-1, 0, n, growth}, {0, 1, k / 2}, {0, 2, k}, {-2, 2, k}, {-2, 0, 0}}));
  turned.set(1, 3, end_of(kPulled, 0, 1));
  turned.body(1).ends.back() = end_of("1001");
  const Found other = found_in(turned);
  REQUIRE(other.state(-1, 0) != nullptr);
  CHECK(std::fabs(other.state(-1, 0)->K / whole.state(1, 0)->K - 1) < 1e-6);
  for (const char* codes : {"1100", "1001"}) { // a face that is held, or along a direction that is none of its own: no notch
    Model held = plate(false);
    held.set(1, 4, end_of(codes));
    for (const app::Corner& c : places(held)) CHECK(std::hypot(c.at[0] - 1, c.at[1]) > 0.1);
  }
}

TEST_CASE("corners: where a support along one direction ends beside a free face at 135 degrees") {
  Model m;
  m.add(polygon({{0, 0, 4}, {2, 0, 4}, {3, 1, 4}, {3, 3, 4}, {0, 3, 4}}));
  const struct {
    const char* codes;
    double least; // of the wedge of 270 degrees, of which this one is half: even, and odd
  } supports[] = {{"0110", 0.5444837367824622}, {"1001", 0.9085291898460987}};
  for (const auto& support : supports) {
    m.set(1, 1, end_of(support.codes));
    const std::vector<app::Corner> found = places(m);
    REQUIRE(found.size() == 1); // none at the right angle
    CHECK(found[0].kind == CornerKind::kSupport);
    CHECK(std::hypot(found[0].at[0] - 2, found[0].at[1]) < 1e-12);
    CHECK(found[0].least == doctest::Approx(support.least));
  }
  m.set(1, 1, end_of(kPulled));
  m.set(1, 2, end_of("0110")); // held across neither of its own directions: no exponent is known
  CHECK(places(m).empty());
}

TEST_CASE("corners: a slit of one body whose sides face each other has no corner of a contact") {
  Model m;
  m.add(polygon({{0, 0, 4}, {4, 0, 4}, {4, 1.99, 4}, {2, 2, 4}, {4, 2.01, 4}, {4, 4, 4}, {0, 4, 4}}));
  m.set(1, 1, end_of(kHeld));
  m.join(C2D_ZONE_MATCHING + C2D_ZONE_SELF, 1, 3, 1, 4);
  m.zones.back().without[1] = 1; // the node at the tip is that of both faces
  for (const app::Corner& c : places(m)) CHECK(c.kind == CornerKind::kSupport);
  m.zones.clear();
  size_t notches = 0;
  for (const app::Corner& c : places(m)) notches += c.kind == CornerKind::kNotch;
  CHECK(notches == 1);
}

TEST_CASE("corners: a notch's intensities turn with the model, and scale as stress times length to the power 1 - lambda") {
  const Model m = notched(20, 1.4, 0.5, 3);
  const Found own = found_in(m);
  const CornerState* s = own.state(1, 0);
  REQUIRE(s != nullptr);
  const Found small = found_in(scaled(m, 0.01, 3));
  const CornerState* t = small.state(0.01, 0);
  REQUIRE(t != nullptr);
  CHECK(std::fabs(t->K / (s->K * 3 * std::pow(0.01, 1 - s->exponents[0].real())) - 1) < 1e-7);
  CHECK(std::fabs(t->K2 / (s->K2 * 3 * std::pow(0.01, 1 - s->exponents[1].real())) - 1) < 1e-7);
  const Found turn = found_in(reflected(m));
  const CornerState* r = turn.state(-1, 0);
  REQUIRE(r != nullptr);
  CHECK(std::fabs(r->K / s->K - 1) < 1e-7);
  CHECK(std::fabs(r->K2 / s->K2 + 1) < 1e-7);
}

TEST_CASE("corners: the intensity under a rigid flat punch is that of the closed form") {
  const double a = 1, smooth = 1 / (kPi * std::sqrt(2 * a)), nu = 0.330767, kappa = 3 - 4 * nu;
  const double glued = smooth * 2 * (1 - nu) / std::sqrt(kappa); // amplitude of p = ... cos(eps ln((a+x)/(a-x)))/sqrt(a^2-x^2)
  const struct {
    const char *mu, *order;
    double K, exponent, limit;
  } rows[] = {
      {"mu=0", "order=2", smooth, 0.5, 3e-4}, {"mu=0", "order=3", smooth, 0.5, 1e-4}, {"mu=inf", "order=2", glued, 0.5, 2e-4}};
  for (const auto& row : rows) {
    std::string deck, error;
    REQUIRE(families::make_deck("punch", {row.mu, row.order}, deck, error));
    Machine machine(deck);
    const Found f = found_in(machine);
    REQUIRE(f.states.size() == 1);
    const CornerState& s = f.states[0];
    CHECK(s.kind == CornerKind::kContact);
    CHECK(std::fabs(s.exponents[0].real() - row.exponent) < 1e-5);
    CHECK(std::fabs(s.K / row.K - 1) < row.limit);
    CHECK(s.K_error < 1.5e-2 * row.K);
    REQUIRE(f.in_step.size() == 1);
    CHECK(f.in_step[0].K == s.K);
  }
}

TEST_CASE("corners: pairs that slip under a rigid punch have the exponent of their friction and its direction") {
  const double nu = 0.330767, mu = 0.265, beta = (1 - 2 * nu) / (2 * (1 - nu));
  std::string deck, error;
  REQUIRE(families::make_deck("punch", {families_test::setting("mu", mu)}, deck, error));
  Machine machine(deck);
  const Found f = found_in(machine);
  REQUIRE(f.states.size() == 1);
  CHECK(std::string(f.states[0].joint) ==
        "slip"); // the half plane is drawn inwards, friction on the punch points into the contact
  CHECK(std::fabs(f.states[0].exponents[0].real() - (0.5 + std::atan(mu * beta) / kPi)) < 1e-6);
  CHECK(f.states[0].K_error < 0.01 * f.states[0].K); // with another exponent it does not fit
  CHECK(std::fabs(f.corners[0].least - (0.5 - std::atan(mu * beta) / kPi)) < 1e-6);
}

TEST_CASE("corners: a re-entrant corner that is held on both faces has an exponent, and no intensity") {
  Model m;
  m.add(rectangle(0, 0, 6, 6, {6, 6, 6, 6}));
  add_polygon(m.body(1), {{2, 2, 4}, {2, 4, 4}, {4, 4, 4}, {4, 2, 4}});
  m.body(1).ends.resize(static_cast<size_t>(m.body(1).elements() * m.function_nodes));
  for (int32_t side = 5; side <= 8; ++side) m.set(1, side, end_of(kHeld));
  m.set(1, 3, end_of(kPulled, 0, 1));
  const Found f = found_in(m);
  REQUIRE(f.states.size() == 4);
  for (const CornerState& s : f.states) {
    const double w = 3 * kPi / 2, kappa = 1.8, lambda = s.exponents[0].real(); // kappa sin(lambda w) = +- lambda sin(w)
    CHECK(std::fabs(kappa * std::fabs(std::sin(lambda * w)) - lambda * std::fabs(std::sin(w))) < 1e-9);
    CHECK(std::isnan(s.K));
    CHECK(s.why == "both faces are supported");
  }
}

TEST_CASE("corners: the estimated error of an intensity holds on coarse and on fine meshes") {
  const double exact = 1 / (kPi * std::sqrt(2.0));
  int told = 0;
  for (const char* order : {"order=1", "order=2", "order=3"})
    for (const char* edge : {"edge=1e-1", "edge=1e-2", "edge=1e-3", "edge=1e-5"})
      for (const char* grading : {"grading=0.5", "grading=0.7"}) {
        const std::string mesh = std::string(order) + " " + edge + " " + grading;
        CAPTURE(mesh);
        std::string deck, error;
        REQUIRE(families::make_deck("punch", {"mu=0", order, edge, grading}, deck, error));
        Machine machine(deck);
        const Found f = found_in(machine);
        REQUIRE(f.states.size() == 1);
        const CornerState& s = f.states[0];
        if (std::isfinite(s.K)) {
          ++told;
          CHECK(std::fabs(s.K - exact) < s.K_error);
          CHECK(s.K_error < 0.25 * s.K);
        } else {
          CHECK(!s.why.empty());
        }
      }
  CHECK(told >= 16);
}

TEST_CASE("corners: where a support ends, and a platen, the intensity is that under a glued punch") {
  const double nu = 0.3, kappa = 3 - 4 * nu;
  const Result r = solve(pressed(Hold::kPlaten, 3));
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  const double P = std::fabs(r.states.back().contact[1]), exact = P / (kPi * std::sqrt(2)) * 2 * (1 - nu) / std::sqrt(kappa);
  for (const Hold hold : {Hold::kPlaten, Hold::kSupport}) {
    const Found f = found_in(pressed(hold, 3));
    for (const double x : {-1.0, 1.0}) {
      const CornerState* s = f.state(x, 0);
      REQUIRE(s != nullptr);
      CHECK(s->kind == (hold == Hold::kPlaten ? CornerKind::kTie : CornerKind::kSupport));
      CHECK(std::fabs(s->exponents[0].imag() - std::log(kappa) / (2 * kPi)) < 1e-9);
      CHECK(std::fabs(s->K / exact - 1) < 1e-3);
    }
  }
}

TEST_CASE("corners: a square pressed on a half plane, smooth: refinement and order settle its intensity") {
  std::vector<double> K;
  for (const auto& mesh : std::vector<std::array<int32_t, 2>>{{16, 3}, {24, 3}, {16, 4}, {64, 2}}) {
    const Found f = found_in(square_on_half_plane(mesh[0], mesh[1]));
    for (const double x : {-1.0, 1.0}) {
      const CornerState* s = f.state(x, 0);
      REQUIRE(s != nullptr);
      CHECK(std::fabs(s->exponents[0].real() - 0.774013) < 1e-6);
      K.push_back(s->K);
    }
  }
  REQUIRE(K.size() == 8);
  for (size_t i = 0; i < 8; ++i) CHECK(std::fabs(K[i] / K[2] - 1) < (i < 6 ? 1e-3 : 1e-2));
}

TEST_CASE("corners: only real corners of a body are found") {
  Model plate;
  plate.add(rectangle(0, 0, 4, 4, {4, 4, 4, 4}));
  plate.set(1, 1, end_of("0110"));
  CHECK(places(plate).empty());                // smooth supports end in right angles
  for (const int32_t sides : {4, 6, 16, 40}) { // a round hole, told by chords; a square one, and one with six corners
    Model hole = plate;
    add_curve(hole.body(1), sides,
              [](double s, double& x, double& y) { x = 2 + std::cos(2 * kPi * s), y = 2 - std::sin(2 * kPi * s); });
    hole.body(1).ends.resize(static_cast<size_t>(hole.body(1).elements() * hole.function_nodes));
    const std::vector<app::Corner> found = places(hole);
    CHECK(found.size() == (sides <= 6 ? static_cast<size_t>(sides) : 0));
    for (const app::Corner& c : found) CHECK(c.kind == CornerKind::kNotch);
  }
  plate.set(1, 1, end_of(kHeld));
  const std::vector<app::Corner> held = places(plate);
  REQUIRE(held.size() == 2);
  CHECK(held[0].kind == CornerKind::kSupport);
  CHECK(std::fabs(held[0].least - 0.711172932971) < 1e-9);
}

TEST_CASE("corners: of a quarter of a hole told by chords those alone that turn unlike their neighbours, images among them") {
  // From (0, y) by chords to (x, 0); `turns` from chord to chord, the middle of the first and the last way along (1, -1).
  const auto found = [](const std::vector<double>& turns) {
    double sum = 0;
    for (const double turn : turns) sum += turn;
    std::vector<Corner> at = {{0, 0, 1}};
    double way = sum / 2 - 45;
    for (size_t k = 0; k <= turns.size(); ++k) {
      at.push_back({at[k].x + std::cos(way * kPi / 180), at[k].y + std::sin(way * kPi / 180), 1});
      if (k < turns.size()) way -= turns[k];
    }
    const Corner end = at.back(); // moved so that it is (x, 0)
    for (Corner& corner : at) corner.y -= end.y;
    Model m;
    m.symmetry = 3;
    m.add(open_polygon({{9, 0, 2}, {9, 9, 2}, {0, 9, 0}}));
    const Body hole = open_polygon(at);
    Body& plate = m.body(1);
    plate.regions.push_back({5, 4 + hole.elements()});
    plate.open_regions = 2;
    plate.xy.insert(plate.xy.end(), hole.xy.begin(), hole.xy.end());
    plate.ends.resize(static_cast<size_t>(2 * plate.elements()));
    size_t notches = 0;
    for (const app::Corner& c : places(m)) notches += c.kind == CornerKind::kNotch && std::hypot(c.at[0], c.at[1]) < 8;
    return notches;
  };
  CHECK(found({30, 30}) == 0); // 12 chords round the whole, with ends on the lines
  CHECK(found({45}) == 0);     // 8
  CHECK(found({60}) == 1);     // a corner, if it turns that much; the images turn by 30 degrees
  CHECK(found({22.5, 22.5, 22.5}) == 0);
  CHECK(found({16, 49, 16}) == 1); // the images turn by 9 degrees
  CHECK(found({}) == 2);           // a square on its tip
}

TEST_CASE("corners: states near a corner that tell nothing, and friction that turns") {
  app::Corner c;
  c.kind = CornerKind::kContact, c.zone = 1, c.after = 2, c.element = 0.01, c.size = 10;
  c.shape.sectors = {app::sector_of(kPi, 1000, 0.3, true)};
  c.shape.faces = {{app::FaceKind::kFree, 0}, {app::FaceKind::kBonded, 0}};
  c.joint = 1;
  std::vector<double> table(60 * C2D_PAIR_FIELDS, 0.0);
  const auto state = [&](size_t pairs, int32_t status, double tn, double tt) {
    c.samples.clear();
    for (size_t i = 0; i < pairs; ++i) {
      const double d = 0.01 * static_cast<double>(i + 1);
      c.samples.push_back({static_cast<int32_t>(i), d, true, {0, 1}});
      double* row = &table[i * C2D_PAIR_FIELDS];
      row[C2D_STATUS] = status, row[C2D_X] = d, row[C2D_NY] = 1, row[C2D_TN] = tn / std::sqrt(d),
      row[C2D_TT] = tt / std::sqrt(d);
    }
    return app::corner_state(c, table.data(), C2D_PAIR_FIELDS);
  };
  const CornerState nothing = state(0, C2D_STICK, 1, 0);
  CHECK((nothing.exponents.empty() && std::string(nothing.joint).empty()));
  const CornerState two = state(2, C2D_STICK, 1, 0);
  CHECK((std::string(two.joint) == "stick" && two.why == "too few nodes near it" && std::isnan(two.K)));
  const CornerState smooth = state(60, C2D_SLIP, 1, 0);
  REQUIRE(smooth.exponents.size() == 1);
  CHECK(smooth.exponents[0].real() == doctest::Approx(0.5));
  CHECK(smooth.K == doctest::Approx(1).epsilon(1e-6));
  const CornerState none = state(60, C2D_SLIP, 0, 0.3); // of no pressure there is no friction
  CHECK(none.exponents[0].real() == doctest::Approx(0.5));
  const CornerState rubbing = state(60, C2D_SLIP, 1, 0.3);
  CHECK(std::fabs(rubbing.exponents[0].real() - 0.5) > 0.01);
  CHECK(rubbing.why.empty());
  for (size_t i = 10; i < 60; ++i) table[i * C2D_PAIR_FIELDS + C2D_TT] *= -1; // from there on it is another state
  CHECK(app::corner_state(c, table.data(), C2D_PAIR_FIELDS).why == "too few nodes near it");
  CHECK(std::string(app::name_of(static_cast<CornerKind>(9))).empty());
}

TEST_CASE("corners: those of ties and contacts are found, whichever side they are on") {
  Model cut; // tied to its like: nothing; to a stiffer one: both ends
  cut.add(rectangle(0, 0, 2, 1, {4, 2, 4, 2}));
  cut.add(rectangle(0, 1, 2, 2, {4, 2, 4, 2}));
  cut.join(C2D_ZONE_FREE + C2D_ZONE_TIED, 1, 3, 2, 1);
  CHECK(places(cut).empty());
  cut.body(2).youngs_modulus = 9000;
  const std::vector<app::Corner> ends = places(cut);
  REQUIRE(ends.size() == 2);
  CHECK(ends[0].kind == CornerKind::kTie);
  CHECK(ends[0].least < 0.99);
  Model laid; // a block on a wider one, as side 2 and as side 1
  laid.add(rectangle(0, 0, 2, 1, {4, 2, 4, 2}));
  laid.add(rectangle(0.5, 1, 1.5, 2, {2, 2, 2, 2}));
  laid.join(C2D_ZONE_FREE, 1, 3, 2, 1);
  for (const int side : {0, 1, 2, 3}) {
    laid.body(2) = rectangle(side < 2 ? 0.5 : 0.43, 1, side < 2 ? 1.5 : 1.61, 2, {2, 2, 2, 2}); // over nodes, and between them
    laid.body(2).ends.resize(static_cast<size_t>(8 * laid.function_nodes));
    const std::vector<app::Corner> edges = places(side % 2 == 0 ? laid : with_swapped_sides(laid, 1));
    CAPTURE(side);
    REQUIRE(edges.size() == 2);
    CHECK(edges[0].kind == CornerKind::kContact);
    for (const app::Corner& c : edges) {
      CHECK(std::fabs(c.least - 0.774013) < 1e-6);
      const double left = side < 2 ? 0.5 : 0.43, right = side < 2 ? 1.5 : 1.61;
      CHECK(std::min(std::fabs(c.at[0] - left), std::fabs(c.at[0] - right)) < 1e-9);
    }
  }
}

TEST_CASE("corners: the outputs tell them, and nothing where there are none") {
  const test::Folder folder;
  const std::string program = "'" + paths::program() + "'", json = folder / "out.json";
  const auto listing_of = [&](const std::string& family) {
    const std::string deck = folder / "deck.dat";
    REQUIRE(test::run_shell(program + " make " + family + " > " + deck).status == 0);
    const test::Result r = test::run_shell(program + " run " + deck + " --json " + json + " --listing -");
    REQUIRE_MESSAGE(r.status == 0, r.err);
    return r.out;
  };
  const std::string punch = listing_of("punch mu=0");
  CHECK(test::contains(punch, "Sharp corners, where stress has no bound"));
  CHECK(test::contains(punch, "edge of a contact in zone 1"));
  const std::string text = test::read_file(json);
  CHECK(test::contains(text, "\"corners\": [{\"kind\": \"edge of a contact\", \"zone\": 1"));
  CHECK(test::contains(text, "\"exponents\": [0.5"));
  const std::string coarse = listing_of("cantilever");
  CHECK(test::contains(coarse, "end of a support of body 1 (beam); no K: too few nodes near it"));
  CHECK(!test::contains(listing_of("hertz"), "Sharp corners"));
  CHECK(!test::contains(test::read_file(json), "\"corners\""));
}
