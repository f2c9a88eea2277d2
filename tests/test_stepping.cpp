// Following the load: independence of steps, unloading and cycles, the deck's own stepping, starts and stops.
#include "problem.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace problem;

namespace {

const char* const kDecks[] = {"sample.dat",      "sample56.dat", "block.dat",   "half_cylinder.dat",
                              "hertz_lin_l.dat", "layer_mu.dat", "layer_t.dat", "rect.dat"};

Result solved(const Problem& p, const Setup& setup = Setup()) {
  Result r = solve(p, setup);
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  CHECK(coulomb_breach(p, r) == "");
  return r;
}

double largest_traction(const Result& r) {
  double size = 0;
  for (const Step& s : r.steps)
    for (int i = 0; i < s.pairs(); ++i) size = std::max({size, std::fabs(s.at(i, C2D_TN)), std::fabs(s.at(i, C2D_TT))});
  return size;
}

std::vector<Path> through(const std::vector<double>& loads, int32_t increments) {
  std::vector<Path> paths;
  for (double load : loads) paths.push_back({increments, load});
  return paths;
}

// Steps that end a load card, coefficient by coefficient.
std::vector<Step> ends_of_cards(const Problem& p, const Result& r) {
  std::vector<Step> out;
  size_t at = 0;
  const std::vector<Step> steps = r.recorded();
  while (at < steps.size())
    for (const Path& path : p.paths) {
      at += static_cast<size_t>(path.increments);
      REQUIRE(at <= steps.size());
      out.push_back(steps[at - 1]);
    }
  return out;
}

// Difference at the ends of the load cards of `a`, which must be turning points of `b` too.
Difference at_cards(const Problem& p, const Result& a, const Problem& q, const Result& b) {
  std::vector<Step> x = ends_of_cards(p, a), y = ends_of_cards(q, b);
  Difference d;
  size_t k = 0;
  for (const Step& step : x) {
    while (k < y.size() && (y[k].load != step.load || y[k].coefficient != step.coefficient)) ++k;
    REQUIRE(k < y.size());
    d.join(compare(step, y[k++]));
  }
  return d;
}

void check_same(const Difference& d, double tolerance) {
  CHECK(d.statuses == 0);
  CHECK(d.traction < tolerance);
  CHECK(d.displacement1 < tolerance);
  CHECK(d.displacement2 < tolerance);
  CHECK(d.gap < tolerance);
  CHECK(d.slip < tolerance);
}

} // namespace

TEST_CASE("stepping: one big load step equals many small ones") {
  for (const std::string deck : kDecks) {
    CAPTURE(deck);
    const Problem p = load(deck);
    const double last = p.paths.back().load;
    const Problem big = with_paths(p, {{1, last}});
    const Result one = solved(big);
    for (int32_t n : {2, 7, 100}) {
      CAPTURE(n);
      const Problem many = with_paths(p, {{n, last}});
      check_same(at_cards(big, one, many, solved(many)), 1e-9);
    }
    check_same(at_cards(big, one, p, solved(p)), 1e-9);
    const Problem odd = with_paths(p, {{1, 0.0137 * last}, {3, 0.41 * last}, {1, 0.9999 * last}, {1, last}});
    check_same(at_cards(big, one, odd, solved(odd)), 1e-9);
  }
}

TEST_CASE("stepping: the same for unloading and cycles") {
  for (const std::string deck : kDecks) {
    const Problem p = load(deck);
    const double f = p.paths.back().load;
    for (const std::vector<double>& loads :
         {std::vector<double>{f, 0.3 * f, f, 0.5 * f}, std::vector<double>{f, 0.1 * f, 0.7 * f, 0.2 * f, 1.2 * f, 0.05 * f}}) {
      CAPTURE(deck);
      const Problem big = with_paths(p, through(loads, 1)), fine = with_paths(p, through(loads, 23));
      check_same(at_cards(big, solved(big), fine, solved(fine)), 1e-9);
    }
  }
}

TEST_CASE("stepping: many sweeps do not drift") {
  // Twelve loadings and unloadings, some thousand changes of status, in single steps and in small ones.
  const Problem p = load("sample56.dat");
  std::vector<double> loads;
  for (int i = 0; i < 12; ++i) loads.insert(loads.end(), {1.0, 0.25});
  const Problem cycles = with_paths(p, through(loads, 1)), fine = with_paths(p, through(loads, 3));
  const Result r = solved(cycles);
  CHECK(r.summary.exchanges > 1000);
  CHECK(r.summary.max_residual < 1e-12);
  CHECK(r.summary.force_error < 1e-12);
  check_same(at_cards(cycles, r, fine, solved(fine)), 1e-9);
}

TEST_CASE("stepping: unloading to nothing leaves nothing") {
  for (const std::string deck :
       {"sample.dat", "sample56.dat", "half_cylinder.dat", "hertz_lin_l.dat", "layer_mu.dat", "layer_t.dat", "block.dat"}) {
    CAPTURE(deck);
    Problem p = load(deck);
    const double f = p.paths.back().load;
    p.paths = {{1, f}, {1, 0.0}};
    const Result r = solved(p);
    const double size = largest_traction(r);
    double peak = 0;
    for (const Step& s : r.recorded())
      for (int i = 0; i < s.pairs(); ++i) {
        peak = std::max({peak, std::fabs(s.at(i, C2D_UN1)), std::fabs(s.at(i, C2D_UT1))});
        if (s.load != 0) continue;
        CHECK(std::fabs(s.at(i, C2D_TN)) < 1e-9 * size);
        CHECK(std::fabs(s.at(i, C2D_TT)) < 1e-9 * size);
        CHECK(std::fabs(s.at(i, C2D_UN1)) < 1e-9 * peak);
        CHECK(std::fabs(s.at(i, C2D_UT1)) < 1e-9 * peak);
      }
  }
}

TEST_CASE("stepping: the same load again changes nothing") {
  for (const std::string deck : kDecks) {
    CAPTURE(deck);
    const Problem p = load(deck);
    const double f = p.paths.back().load;
    Setup setup;
    setup.advance_mu = p.friction[0];
    setup.advance_loads = {f, f, 0.4 * f, 0.4 * f, f, f};
    const std::vector<Step> s = solved(p, setup).recorded();
    REQUIRE(s.size() == 6);
    for (size_t i : {0u, 2u, 4u}) check_same(compare(s[i], s[i + 1]), 1e-12);
  }
}

namespace {

// Largest error of a traction at the ends of the load cards, deck stepping against events.
double stepping_error(const Problem& p, int32_t times) {
  Setup setup;
  setup.stepping = C2D_STEPPING_DECK;
  const Problem q = split(p, times);
  return at_cards(p, solved(p), q, solved(q, setup)).traction;
}

} // namespace

TEST_CASE("stepping: the deck's own increments come closer to the events as they are halved") {
  const Problem sample = load("sample.dat");
  double before = stepping_error(sample, 1);
  CHECK(before > 1e-3); // it is another way of stepping
  CHECK(before < 0.05);
  for (int32_t times : {2, 4, 8}) {
    CAPTURE(times);
    const double now = stepping_error(sample, times);
    CHECK(now < before);
    before = now;
  }
  CHECK(before < 0.005);
  const Problem half = with_paths(load("half_cylinder.dat"), {{28, 1.0}});
  CHECK(stepping_error(half, 8) < 0.25 * stepping_error(half, 1));
  // What touches from the start and is loaded in proportion keeps its statuses: any increment is exact.
  for (const std::string deck : {"layer_mu.dat", "layer_t.dat", "block.dat"}) {
    CAPTURE(deck);
    CHECK(stepping_error(load(deck), 3) < 1e-9);
  }
}

TEST_CASE("stepping: slip of the deck's own increments knows nothing of trial states") {
  Setup setup;
  setup.stepping = C2D_STEPPING_DECK;
  for (const std::string deck : {"layer_t.dat", "layer_mu.dat", "hertz_lin_l.dat"}) { // one increment each
    CAPTURE(deck);
    const Result r = solved(load(deck), setup);
    REQUIRE(r.steps.size() >= 1);
    for (const Step& step : r.steps)
      for (int i = 0; i < step.pairs(); ++i)
        if (static_cast<int>(step.at(i, C2D_STATUS)) == C2D_OPEN) CHECK(step.at(i, C2D_SLIP_SUM) == 0.0);
  }
  // Down and up again: the slip of every pair comes to that of the events.
  Problem p = load("sample.dat");
  p.friction = {0.2};
  p.paths = {{100, 1.0}, {100, 0.4}, {100, 1.0}};
  const Result fine = solved(p, setup), exact = solved(p);
  double most = 0.0, worst = 0.0;
  for (int i = 0; i < exact.steps.back().pairs(); ++i) {
    most = std::max(most, std::fabs(exact.steps.back().at(i, C2D_SLIP_SUM)));
    worst = std::max(worst, std::fabs(exact.steps.back().at(i, C2D_SLIP_SUM) - fine.steps.back().at(i, C2D_SLIP_SUM)));
  }
  CHECK(most > 0.0);
  CHECK(worst < 0.25 * most); // one increment of slip may be lost where a pair closes or turns back
}

TEST_CASE("stepping: an increment that does not converge is finished by following events") {
  Problem p = load("sample.dat");
  Setup setup;
  setup.stepping = C2D_STEPPING_DECK;
  CHECK(!solved(p, setup).warned(C2D_WARN_INCREMENT));
  p.iteration_limit = 1;
  p.paths = {{1, 1.0}};
  const Result r = solved(p, setup);
  CHECK(r.warned(C2D_WARN_INCREMENT));
  check_same(compare(solved(p), r), 1e-9);
  CHECK(r.summary.force_error < 1e-12);
}

// ---- starts
// -----------------------------------------------------------------------------------------------------

namespace {

Problem lifted(Problem p, double height) {
  for (size_t i = 1; i < p.bodies[1].xy.size(); i += 2) p.bodies[1].xy[i] += height;
  return p;
}

} // namespace

TEST_CASE("stepping: first touch of a layer that hovers everywhere") {
  // Its gaps are all alike, so frames and pairs are those of the layer that lies on the foundation from the
  // start.
  for (const std::string deck : {"layer_t.dat", "layer_mu.dat"}) {
    CAPTURE(deck);
    const Problem p = load(deck);
    const Result lying = solved(p);
    const Problem q = lifted(p, 0.01);
    const Result hovering = solved(q);
    CHECK(hovering.outcome == C2D_REACHED);
    const std::vector<Step> a = lying.recorded(), b = hovering.recorded();
    REQUIRE(a.size() == b.size());
    for (size_t k = 0; k < a.size(); ++k) {
      Step down = b[k];
      for (int i = 0; i < down.pairs(); ++i) down.table[static_cast<size_t>(i * C2D_PAIR_FIELDS + C2D_UN2)] += 0.01;
      check_same(compare(a[k], down), 1e-9);
    }
  }
}

TEST_CASE("stepping: first touch of the sample's cylinder from any height") {
  // Lifting turns the frames a little, so results are near, not equal, to those of the cylinder that touches.
  const Problem p = load("sample.dat");
  const Result touching = solved(p);
  const double peak = largest_traction(touching);
  for (double height : {1e-3, 0.01}) {
    CAPTURE(height);
    const Problem q = lifted(p, height);
    const Result r = solved(q);
    CHECK(r.outcome == C2D_REACHED);
    CHECK(r.summary.force_error < 1e-12);
    CHECK(compare(touching, r).traction < 1e-4); // 1.2e-5 for the higher one
    CHECK(largest_traction(r) == doctest::Approx(peak).epsilon(1e-4));
  }
}

// ---- stops
// ------------------------------------------------------------------------------------------------------

TEST_CASE("stepping: a body pulled away flies") {
  Problem p = load("sample.dat");
  p.paths = {{2, -1.0}};
  const Result at_once = solved(p);
  CHECK(at_once.outcome == C2D_FREE_MOTION);
  CHECK(at_once.summary.outcome_body == 2);
  CHECK(at_once.recorded().empty());
  CHECK(std::fabs(at_once.summary.free_motion[1]) > 0.99); // along y, the one way that symmetry leaves
  CHECK(std::fabs(at_once.summary.free_motion[0]) < 1e-9);
  CHECK(std::fabs(at_once.summary.free_motion[2]) < 1e-9);

  p.paths = {{4, 0.5}, {2, 0.25}, {2, -0.25}}; // pressed first
  const Result later = solved(p);
  CHECK(later.outcome == C2D_FREE_MOTION);
  CHECK(later.recorded().size() >= 6);
  CHECK(later.summary.load == doctest::Approx(0.0).epsilon(1e-9).scale(1));

  const Result hovering = solved(with_paths(lifted(load("layer_t.dat"), 0.01), {{1, -1.0}}));
  CHECK(hovering.outcome == C2D_FREE_MOTION);
}

TEST_CASE("stepping: a block that hovers with three motions falls on its table") {
  const Result lying = solved(load("block.dat")), hovering = solved(lifted(load("block.dat"), 0.01));
  REQUIRE(hovering.outcome == C2D_REACHED);
  const std::vector<Step> a = lying.recorded(), b = hovering.recorded();
  REQUIRE(a.size() == b.size());
  for (size_t k = 0; k < a.size(); ++k) CHECK(compare(a[k], b[k]).traction < 1e-9);
}

TEST_CASE("stepping: a block pulled aside and off flies, one pushed at its top tips about its leading corner") {
  const auto with_top_load = [](double tx, double ty) {
    Problem p = load("block.dat");
    for (End& end : p.bodies[1].ends)
      if (end.values[1] == -1.0) end.values[0] = tx, end.values[1] = ty;
    return p;
  };
  Problem p = with_top_load(0.2, 1.0);
  p.friction = {0.3};
  const Result off = solved(p);
  CHECK(off.outcome == C2D_FREE_MOTION);
  CHECK(off.summary.free_motion[1] > 0.9);
  p = with_top_load(3.0, -1.0); // moment about the corner: 3 x height 1 against 1 x half width 1
  p.friction = {1e9};
  const Result tips = solved(p);
  CHECK(tips.outcome == C2D_TIPPING);
  const double* motion = tips.summary.free_motion;
  CHECK(motion[2] < 0.0);
  CHECK(std::fabs(motion[0]) < 1e-6 * std::fabs(motion[2])); // of the corner (1, 0)
  CHECK(motion[1] + motion[2] * 1.0 == doctest::Approx(0.0).epsilon(1e-6).scale(std::fabs(motion[2])));
}

TEST_CASE("stepping: the block slides as a whole when the load leaves the cone") {
  // Tractions (0.2, -1) on its top: Q/N = 0.2 at every load.
  Problem p = load("block.dat");
  p.friction = {0.21};
  const Result holds = solved(p);
  CHECK(holds.outcome == C2D_REACHED);
  p.friction = {0.19};
  const Result slides = solved(p);
  CHECK(slides.outcome == C2D_GROSS_SLIDING);
  CHECK(slides.summary.load == doctest::Approx(0.0).epsilon(1e-12).scale(1));
  // Nothing is pressed yet where it starts; it goes along the foundation, whichever pairs were tried last.
  for (const double mu : {0.19999, 0.19, 0.15, 0.1, 0.05}) {
    p.friction = {mu};
    for (const double side : {1.0, -1.0}) {
      const Result r = solved(side > 0 ? p : reflected(p));
      INFO(mu, " ", side);
      CHECK(r.outcome == C2D_GROSS_SLIDING);
      CHECK(r.summary.free_motion[0] == doctest::Approx(side).epsilon(1e-9));
      CHECK(r.summary.free_motion[1] == 0.0);
      CHECK(r.summary.free_motion[2] == 0.0);
    }
  }
  p.friction = {0.3, 0.19, 0.25}; // one that fails does not keep the next from being run
  CHECK(solved(p).recorded().size() == 8);
}

namespace {

// The block with its pressure as load case 1 and its shear, 0.2 of it, as case 2.
Problem pressed_and_sheared() {
  Problem p = load("block.dat");
  for (Body& body : p.bodies) body.second_case = body.ends;
  for (End& end : p.bodies[1].ends) end.values[0] = 0;
  for (End& end : p.bodies[1].second_case) end.values[1] = 0;
  return p;
}
Result follow_pair(const Problem& p, double mu, const std::vector<double>& pressure, const std::vector<double>& shear,
                   bool go_on = false) {
  Setup setup;
  setup.advance_mu = mu;
  setup.advance_loads = pressure;
  setup.advance_second = shear;
  setup.go_on = go_on;
  Result r = solve(p, setup);
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  CHECK(coulomb_breach(p, r) == "");
  return r;
}

} // namespace

TEST_CASE("stepping: gross sliding comes at Q = mu N") {
  const Problem p = pressed_and_sheared(); // press, then shear until it goes
  for (double mu : {0.1, 0.3, 0.6}) {
    CAPTURE(mu);
    const double limit = mu / 0.2;
    const Result r = follow_pair(p, mu, {1, 1, 1, 1}, {0, 0.5 * limit, 0.999 * limit, 1.1 * limit});
    REQUIRE(r.steps.size() == 4);
    CHECK(r.steps[2].outcome == C2D_REACHED);
    CHECK(r.outcome == C2D_GROSS_SLIDING);
    // At the last valid load every touching pair is at its limit: the shear carried is mu N = 2 mu.
    CHECK(std::fabs(resultant(p, r, 2, 1).fx) == doctest::Approx(2 * mu).epsilon(1e-9));
    CHECK(std::fabs(resultant(p, r, 2, 1).fy) == doctest::Approx(2).epsilon(1e-9));
  }
}

TEST_CASE("stepping: a path that stopped can be followed back") {
  const Problem p = pressed_and_sheared();
  const double mu = 0.3, limit = mu / 0.2;
  const Result stopped = follow_pair(p, mu, {1, 1, 1, 1}, {0, 1.1 * limit, 0, -0.4 * limit}, true);
  const Result short_of = follow_pair(p, mu, {1, 1, 1, 1}, {0, (1 - 1e-9) * limit, 0, -0.4 * limit});
  REQUIRE(stopped.steps.size() == 4);
  CHECK(stopped.steps[1].outcome == C2D_GROSS_SLIDING);
  CHECK(stopped.steps[2].outcome == C2D_REACHED);
  CHECK(stopped.steps[3].outcome == C2D_REACHED);
  check_same(compare(short_of.steps[2], stopped.steps[2]), 1e-7);
  check_same(compare(short_of.steps[3], stopped.steps[3]), 1e-7);
}

TEST_CASE("stepping: a pressed block holds however small the friction") {
  // No shear at all: by symmetry half the block slips to either side and the pair in the middle stays.
  const Problem p = pressed_and_sheared();
  for (double mu : {0.01, 0.02, 0.05, 0.07, 0.1, 0.2}) {
    CAPTURE(mu);
    const Result r = follow_pair(p, mu, {1}, {0});
    CHECK(r.outcome == C2D_REACHED);
    if (r.outcome != C2D_REACHED) continue;
    const Step& s = r.steps[0];
    for (int i = 0; i < s.pairs(); ++i) CHECK(s.at(i, C2D_TT) == doctest::Approx(-s.at(24 - i, C2D_TT)).epsilon(1e-6));
  }
}

TEST_CASE("stepping: pressure and shear in proportion hold up to Q = mu N") {
  const Problem p = pressed_and_sheared();
  for (double mu : {0.05, 0.1, 0.2, 0.4})
    for (double part : {0.1, 0.5, 0.9, 0.99}) {
      CAPTURE(mu);
      CAPTURE(part);
      const double limit = mu / 0.2;
      CHECK(follow_pair(p, mu, {1}, {part * limit}).outcome == C2D_REACHED);
      CHECK(follow_pair(p, mu, {1e-3, 1}, {0, part * limit}).outcome == C2D_REACHED);
      const c2d_outcome beyond = follow_pair(p, mu, {1}, {limit / part}).outcome;
      if (part >= 0.9) CHECK(beyond == C2D_GROSS_SLIDING);
      CHECK(beyond != C2D_REACHED);
    }
}

TEST_CASE("stepping: shear to the left is the mirror of shear to the right") {
  // The block, its mesh and its pressure are symmetric about x = 0. At 0.7 and 0.9 the trailing edge lifts.
  const Problem p = pressed_and_sheared();
  for (double mu : {0.3, 1.0, 2.0})
    for (double ratio : {0.1, 0.25, 0.5, 0.7, 0.9}) {
      if (ratio > 0.9 * mu) continue;
      CAPTURE(mu);
      CAPTURE(ratio);
      const Result right = follow_pair(p, mu, {1}, {ratio / 0.2}), left = follow_pair(p, mu, {1}, {-ratio / 0.2});
      CHECK(right.outcome == C2D_REACHED);
      CHECK(left.outcome == C2D_REACHED);
      if (right.outcome != C2D_REACHED || left.outcome != C2D_REACHED) continue;
      Step mirrored = left.steps[0];
      for (int i = 0; i < 25; ++i)
        for (int field = C2D_STATUS; field <= C2D_SLIP_SUM; ++field) {
          const bool odd = field == C2D_TT || field == C2D_UT1 || field == C2D_UT2 || field == C2D_SLIP_SUM;
          mirrored.table[static_cast<size_t>(i * C2D_PAIR_FIELDS + field)] = (odd ? -1 : 1) * left.steps[0].at(24 - i, field);
        }
      check_same(compare(right.steps[0], mirrored), 1e-9);
    }
}

// ---- other functions, more zones, adhesion
// ----------------------------------------------------------------------

TEST_CASE("stepping: constant, quadratic and cubic functions on the sample") {
  Problem p = load("sample.dat");
  p.paths = {{4, 1.0}};
  const Result linear = solved(p);
  const double peak = largest_traction(linear);
  for (int32_t f : {1, 3, 4}) {
    CAPTURE(f);
    const Problem q = with_functions(p, f);
    const Result r = solved(q);
    CHECK(r.outcome == C2D_REACHED);
    CHECK(r.summary.force_error < 1e-12);
    for (int body = 1; body <= 2; ++body) {
      const Resultant all = resultant(q, r, body, 0);
      CHECK(std::fabs(all.fx) < 1e-12 * all.size);
      CHECK(std::fabs(all.fy) < 1e-12 * all.size);
      CHECK(std::fabs(all.moment) < 1e-12 * all.size * 16);
    }
    const double force = resultant(q, r, 2, 1).fy;
    CHECK(force == doctest::Approx(resultant(p, linear, 2, 1).fy).epsilon(1e-12));
    // Peaks measured: 209.8 (linear), 209.3, 217.9, 218.6.
    CHECK(largest_traction(r) == doctest::Approx(peak).epsilon(0.05));
    const Problem big = with_paths(q, {{1, 1.0}});
    check_same(at_cards(big, solved(big), q, r), 1e-9);
  }
}

TEST_CASE("stepping: two contact zones") {
  Problem p = load("block.dat");
  p.friction = {0.0, 0.3};
  for (Body& body : p.bodies)
    for (End& end : body.ends) end.values[0] = 0; // pressure alone: mu = 0 could not hold a shear
  // Frictionless feet leave the block a free slide; hold one node of it.
  problem::Zone left = p.zones[0], right = p.zones[0];
  const int32_t step = 10;
  left.elements = right.elements = step;
  left.pairs = right.pairs = step + 1;
  left.last_element[0] = left.first_element[0] + step - 1, left.last_node[0] = left.first_node[0] + step;
  left.last_element[1] = left.first_element[1] - step + 1, left.last_node[1] = left.first_node[1] - step;
  right.first_element[0] = right.last_element[0] - step + 1, right.first_node[0] = right.last_node[0] - step;
  right.first_element[1] = right.last_element[1] + step - 1, right.first_node[1] = right.last_node[1] + step;
  p.zones = {left, right};
  const int32_t zero_x[4] = {1, 0, 0, 1};
  End& hold = p.end(2, 40, 2); // a node of the top, near its middle
  std::copy(zero_x, zero_x + 4, hold.codes);
  const Result r = solved(p);
  CHECK(r.outcome == C2D_REACHED);
  CHECK(r.summary.zones == 2);
  CHECK(r.summary.force_error < 1e-12);
  const Resultant all = resultant(p, r, 2, 0), contact = resultant(p, r, 2, 1);
  CHECK(std::fabs(all.fy) < 1e-12 * all.size);
  CHECK(contact.fy == doctest::Approx(2.0).epsilon(1e-12));
  // The block and its loads are symmetric about x = 0: each foot carries half.
  for (const Step& s : r.recorded()) {
    CHECK(s.pairs() == 2 * (step + 1));
    for (int i = 0; i < step + 1; ++i) CHECK(s.at(i, C2D_TN) == doctest::Approx(s.at(2 * step + 1 - i, C2D_TN)).epsilon(1e-6));
  }
}

TEST_CASE("stepping: full adhesion") {
  const Problem p = load("block.dat");
  Setup setup;
  setup.advance_mu = std::numeric_limits<double>::infinity();
  setup.advance_loads = {0.5, 1.0, 0.25};
  const Result r = solved(p, setup);
  CHECK(r.outcome == C2D_REACHED);
  for (const Step& s : r.steps)
    for (int i = 0; i < s.pairs(); ++i) {
      CHECK(s.at(i, C2D_STATUS) != C2D_SLIP);
      CHECK(s.at(i, C2D_SLIP_SUM) == 0.0);
    }
  CHECK(r.summary.force_error < 1e-12);
  // Nothing slips: everything is proportional to the load while statuses stay.
  setup.advance_mu = 1e6;
  check_same(compare(r.steps[1], solved(p, setup).steps[1]), 1e-9);
}
