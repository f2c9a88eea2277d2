// Initial overlaps closed as a load case: stacked blocks and press fits against closed forms.
#include "deck_recorder.hpp"
#include "problem.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace problem;

namespace {

constexpr double kPi = 3.14159265358979323846;

Result solved(const Problem& p, const Setup& setup = Setup()) {
  Result r = solve(p, setup);
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  return r;
}

// Two blocks between rigid smooth plates and walls, too high together by `overlap`: uniaxial strain.
Problem stack(double overlap) {
  Problem p;
  p.bodies.resize(2);
  p.bodies[1].youngs_modulus = 400;
  p.bodies[1].poisson_ratio = 0.2;
  add_polygon(p.bodies[0], {{0, 0, 4}, {2, 0, 2}, {2, 1, 6}, {0, 1, 2}});
  add_polygon(p.bodies[1], {{0, 1 - overlap, 6}, {2, 1 - overlap, 3}, {2, 3 - overlap, 4}, {0, 3 - overlap, 3}});
  for (int body : {1, 2})
    set_ends(p, body, [&](double, double y, double nx, double ny, End& end) {
      const int c = std::fabs(nx) > 0.5 ? 0 : 1;
      if (c == 1 && (body == 1) != (ny < 0)) return; // the contact
      (void)y;
      end.codes[c] = 1, end.codes[2 + c] = 0;
    });
  problem::Zone zone = problem::Zone();
  zone.pairs = 7, zone.elements = 6;
  zone.first_element[0] = 7, zone.last_element[0] = 12, zone.first_node[0] = 7, zone.last_node[0] = 13;
  zone.first_element[1] = 6, zone.last_element[1] = 1, zone.first_node[1] = 7, zone.last_node[1] = 1;
  p.zones = {zone};
  p.interference = 1;
  return p;
}
double constrained_modulus(const Body& b) {
  const double nu = b.poisson_ratio;
  return b.youngs_modulus * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
}

} // namespace

TEST_CASE("interference: stacked blocks carry what closes their overlap") {
  for (bool swapped : {false, true}) {
    CAPTURE(swapped);
    const Problem p = stack(0.01);
    const Result r = solved(swapped ? exchanged(p) : p);
    const double pressure = 0.01 / (1 / constrained_modulus(p.bodies[0]) + 2 / constrained_modulus(p.bodies[1]));
    CHECK(r.outcome == C2D_REACHED);
    const Step& step = r.steps.back();
    for (int i = 0; i < step.pairs(); ++i) {
      CAPTURE(i);
      CHECK(step.at(i, C2D_TN) == doctest::Approx(pressure).epsilon(1e-10));
      CHECK(std::fabs(step.at(i, C2D_GAP)) < 1e-14);
      CHECK(std::fabs(step.at(i, C2D_UN2) - step.at(i, C2D_UN1)) == doctest::Approx(0.01).epsilon(1e-10));
    }
    CHECK(r.summary.max_residual < 1e-12);
    // Pressure times overlap, 2 wide: half of it is stored, as both grow together.
    CHECK(r.summary.work == doctest::Approx(0.5 * pressure * 0.01 * 2).epsilon(1e-9));
    CHECK(r.summary.elastic == doctest::Approx(0.5 * pressure * 0.01 * 2).epsilon(1e-9));
  }
  // Half closed, and opened again, by the caller's own factors.
  Problem p = stack(0.01);
  Setup setup;
  setup.advance_loads = {1, 0.5, 0};
  const Result r = solved(p, setup);
  CHECK(r.steps[1].at(3, C2D_TN) == doctest::Approx(0.5 * r.steps[0].at(3, C2D_TN)).epsilon(1e-10));
  CHECK(std::fabs(r.steps[2].at(3, C2D_TN)) < 1e-10 * r.steps[0].at(3, C2D_TN));
}

TEST_CASE("interference: without it an overlap is refused, and with it other pairs keep their gaps") {
  Problem p = stack(0.01);
  p.interference = 0;
  const Result refused = solve(p);
  CHECK(refused.status == C2D_ERR_INPUT);
  CHECK(refused.messages().find("*INTERFERENCE") != std::string::npos);
  p = stack(-0.01);
  const Result open = solved(p);
  for (int i = 0; i < 7; ++i) CHECK(open.steps.back().at(i, C2D_GAP) == doctest::Approx(0.01).epsilon(1e-9));
}

namespace {

// A quarter of a shaft with a bore (a < r < b + delta) in a ring (b < r < c), n elements along each arc.
Problem press_fit(int32_t n, double a, double b, double c, double delta, double mu) {
  Problem p;
  p.function_nodes = 2;
  p.plane = C2D_PLANE_STRESS;
  p.symmetry = 3;
  p.bodies.resize(2);
  const auto arc = [&](Body& body, double radius, bool outer) {
    const int32_t points = 2 * n, first = body.regions.empty() ? 1 : body.regions.back().last + 1;
    for (int32_t i = 0; i <= points; ++i) {
      const double angle = kPi / 2 * (outer ? i : points - i) / points;
      body.xy.push_back(i == (outer ? points : 0) ? 0 : radius * std::cos(angle));
      body.xy.push_back(i == (outer ? 0 : points) ? 0 : radius * std::sin(angle));
    }
    body.regions.push_back({first, first + n - 1});
    ++body.open_regions;
  };
  for (Body& body : p.bodies) body.element_nodes = 3;
  arc(p.bodies[0], b + delta, true);
  arc(p.bodies[0], a, false);
  arc(p.bodies[1], c, true);
  arc(p.bodies[1], b, false);
  p.bodies[1].youngs_modulus = 600;
  p.bodies[1].poisson_ratio = 0.2;
  for (Body& body : p.bodies) body.ends.assign(static_cast<size_t>(2 * 2 * n), End());
  problem::Zone zone = problem::Zone();
  zone.pairs = n + 1, zone.elements = n;
  zone.first_element[0] = 1, zone.last_element[0] = n, zone.first_node[0] = 1, zone.last_node[0] = n + 1;
  zone.first_element[1] = 2 * n, zone.last_element[1] = n + 1;
  zone.first_node[1] = 2 * n + 2, zone.last_node[1] = n + 2;
  p.zones = {zone};
  p.friction = {mu};
  p.interference = 1;
  return p;
}

// Lame: radial interference over what both rings give way per unit of pressure.
double fit_pressure(const Problem& p, double a, double b, double c, double delta) {
  const Body &in = p.bodies[0], &out = p.bodies[1];
  const double inner = ((b * b + a * a) / (b * b - a * a) - in.poisson_ratio) / in.youngs_modulus;
  const double outer = ((c * c + b * b) / (c * c - b * b) + out.poisson_ratio) / out.youngs_modulus;
  return delta / (b * (inner + outer));
}

} // namespace

TEST_CASE("interference: a press fit of two rings against Lame") {
  const double a = 1, b = 2, c = 3.5, delta = 1e-4; // delta / b: what the linear theory of the fit leaves out
  for (double mu : {0.0, 0.3}) {
    double before = 1;
    for (int32_t n : {6, 12, 24}) {
      CAPTURE(mu);
      CAPTURE(n);
      const Problem p = press_fit(n, a, b, c, delta, mu);
      const Result r = solved(p);
      REQUIRE(r.outcome == C2D_REACHED);
      const double pressure = fit_pressure(p, a, b, c, delta);
      double worst = 0;
      for (int i = 0; i <= n; ++i) worst = std::max(worst, std::fabs(r.steps.back().at(i, C2D_TN) / pressure - 1));
      CHECK(worst < before / 3); // second order
      CHECK(r.summary.work == doctest::Approx(0.5 * pressure * delta * b * kPi / 2).epsilon(0.02));
      CHECK(std::fabs(r.summary.energy_defect) < 1e-2);
      before = worst;
    }
    CHECK(before < 1e-3); // 7.8e-4 with 24 linear elements per quarter
  }
}

TEST_CASE("interference: a fit goes on to carry loads") {
  // The ring is pulled apart: pressure falls by what Lame says for a tension at its outside.
  const double a = 1, b = 2, c = 3.5, delta = 1e-4;
  Problem p = press_fit(12, a, b, c, delta, 0);
  const double fit = fit_pressure(p, a, b, c, delta), tension = 0.2 * fit;
  for (int32_t e = 1; e <= 12; ++e)
    for (int l = 1; l <= 2; ++l) {
      const double angle = kPi / 2 * (e - 1 + l - 1) / 12;
      End& end = p.end(2, e, l);
      end.values[0] = tension * std::cos(angle), end.values[1] = tension * std::sin(angle);
    }
  p.paths = {{2, 1.0}};
  p.interference = 2;
  const Result r = solved(p);
  REQUIRE(r.outcome == C2D_REACHED);
  REQUIRE(r.steps.size() == 2);
  // u(b) of the outer ring under tension at c alone, plane stress: 2 T c^2 b / (E (c^2 - b^2)).
  const Body &in = p.bodies[0], &out = p.bodies[1];
  const double inner = ((b * b + a * a) / (b * b - a * a) - in.poisson_ratio) / in.youngs_modulus;
  const double outer = ((c * c + b * b) / (c * c - b * b) + out.poisson_ratio) / out.youngs_modulus;
  const double lost = 2 * tension * c * c / (out.youngs_modulus * (c * c - b * b)) / (inner + outer);
  for (int i = 0; i <= 12; ++i) {
    CHECK(r.steps[0].at(i, C2D_TN) == doctest::Approx(fit - 0.5 * lost).epsilon(3e-3));
    CHECK(r.steps[1].at(i, C2D_TN) == doctest::Approx(fit - lost).epsilon(3e-3));
  }
}

TEST_CASE("interference: the keyword card") {
  const auto with = [](const std::string& card) {
    std::vector<std::string> deck = deck_test::squares();
    deck.push_back(card);
    return deck_test::read(deck_test::joined(deck));
  };
  CHECK(with("*INTERFERENCE 1").status == C2D_OK);
  CHECK(with("*INTERFERENCE 2").sizes.load_cases == 2);
  CHECK(with("*INTERFERENCE").status == C2D_ERR_INPUT);
  CHECK(with("*INTERFERENCE 0").status == C2D_ERR_INPUT);
  CHECK(with("*INTERFERENCE 1 2").status == C2D_ERR_INPUT);
}
