// The loop over meshes against closed forms: numbers are as accurate as was asked, and their stated errors are not too small.
#include "estimate_truth.hpp"

#include "program/estimate/error.hpp"

#include <doctest/doctest.h>

namespace {

// Blocks are finite: closed forms for half planes hold to this share. Ranges of stress inside are small beside the pressure: of
// that across the surface 18.308 by the closed form, meshes asked for 1 % and for 0.2 % have 18.2988 and 18.2979.
double known_to(const std::string& name) { return name.find("range of stress ") != std::string::npos ? 6e-4 : 1e-4; }

void check(const truth::Problem& problem, double tolerance) {
  const truth::Judged j = truth::judge(problem, tolerance, false);
  CAPTURE(problem.name);
  REQUIRE_MESSAGE(j.fault.empty(), j.fault);
  CHECK_MESSAGE(j.stopped.empty(), j.stopped);
  int wanted = 0;
  for (const truth::Row& row : j.rows) {
    if (!row.wanted) continue;
    ++wanted;
    CAPTURE(row.name);
    CAPTURE(row.item);
    CHECK(row.error <= row.asked + known_to(row.name));
    CHECK(row.stated <= row.asked);
    CHECK(row.stated >= 0.8 * (row.error - known_to(row.name)));
  }
  CHECK(wanted >= 2);
}

} // namespace

TEST_CASE("estimate: Hertz to 1 %, wherever the edges of contact fall in elements") {
  for (const double shift : {0.13, 0.29}) check(truth::hertz(shift), 0.01);
}

TEST_CASE("estimate: Cattaneo, to and fro: numbers, and the ranges of stress over the cycle") {
  check(truth::cattaneo(0.6, true, 0), 0.01);
}

TEST_CASE("estimate: flat punch with rounded edges to 1 %") { check(truth::rounded_punch(0.2, 0), 0.01); }

TEST_CASE("estimate: a layer that lifts off, and a disc in a hole, to 1 %") {
  check(truth::receding_layer(1), 0.01);
  for (const bool pulled : {true, false}) check(truth::disc_in_hole(pulled), 0.01);
}

// A number that was asked for to 1 %, on a model without zones.
TEST_CASE("estimate: a number is met in two rounds, or by what it changed in the round before, too") {
  estimate::Trial trial;
  estimate::Round before;
  app::Stated number;
  number.what = app::Measure::kForceX, number.value = number.scale = 1, number.tolerance = 0.01, number.error = 0.005;
  const auto is_met = [&](const estimate::Round* round) {
    std::vector<app::Stated> all{number};
    estimate::confirm(all, trial, round);
    return all[0].is_met();
  };
  CHECK_FALSE(is_met(nullptr));
  number.error_by_before = 0.02;
  CHECK_FALSE(is_met(nullptr));
  number.error_by_before = 0.009;
  CHECK(is_met(nullptr));
  number.error_by_before = NAN;
  before.stated = {number};
  CHECK(is_met(&before));
  before.stated[0].error = 0.02;
  CHECK_FALSE(is_met(&before));
  // Where a history ends early it has to end at the same loads.
  before.stated[0].error = 0.005;
  trial.outcome = C2D_GROSS_SLIDING;
  trial.states.resize(1);
  trial.states[0].loads = {1, 0.5};
  CHECK_FALSE(is_met(&before));
  before.loads = {1, 0.45};
  CHECK_FALSE(is_met(&before));
  before.loads = {1, 0.495};
  CHECK(is_met(&before));
  trial.states[0].work = 2, before.work = 1.95;
  CHECK_FALSE(is_met(&before));
  before.work = 1.97;
  CHECK(is_met(&before));
}

TEST_CASE("estimate: numbers without an error are left out, unless asked for") {
  std::vector<app::Stated> all(3);
  all[0].error = 1, all[1].tolerance = 0.01;
  estimate::drop_unknown(all);
  CHECK(all.size() == 2);
}

namespace {

// Two bodies with one element each that are tied, and what the tie carries.
estimate::Trial tied(double force, double moment) {
  estimate::Trial out;
  out.nodes = 2;
  out.lengths = {{3}, {3}}, out.stiffness = {100, 100}, out.across = {0, 0};
  out.zones = {{{{0, 0, 0}, {1, 0, 0}}}};
  out.tied = {1};
  estimate::State state;
  state.turn = true, state.loads = {1}, state.work = 1;
  state.ends.resize(2);
  for (auto& body : state.ends)
    for (auto& field : body) field.assign(2, 0.0);
  state.ends[0][estimate::kUy] = {0.01, 0.01};
  for (const auto& [what, value] : {std::pair{app::Measure::kForceY, force}, {app::Measure::kMoment, moment}}) {
    app::Quantity q;
    q.what = what, q.zone = 1, q.value = value;
    state.quantities.push_back(q);
  }
  out.states = {state};
  return out;
}

struct Slipping {
  int pairs;
  double dissipated;
  bool turn;
};
// Two bodies in contact along twenty elements; so many pairs slip in each state.
estimate::Trial slipping(const std::vector<Slipping>& history) {
  constexpr int kElements = 20;
  estimate::Trial out;
  out.nodes = 2;
  out.lengths = {std::vector<double>(kElements, 0.1), std::vector<double>(kElements, 0.1)};
  out.stiffness = {100, 100}, out.across = {0, 0};
  out.zones = {{{{0, 0, kElements - 1}, {1, 0, kElements - 1}}}};
  out.tied = {0};
  for (const Slipping& now : history) {
    estimate::State state;
    state.turn = now.turn, state.loads = {1}, state.work = 1, state.dissipated = now.dissipated;
    state.ends.resize(2);
    for (auto& body : state.ends)
      for (auto& field : body) field.assign(2 * kElements, 0.0);
    for (int e = 0; e < kElements; ++e)
      for (auto& body : state.ends) body[estimate::kStatus][static_cast<size_t>(2 * e)] = e < now.pairs ? C2D_SLIP : C2D_STICK;
    for (const int32_t zone : {1, 0}) {
      app::Quantity q;
      q.what = app::Measure::kDissipated, q.zone = zone, q.value = now.dissipated;
      state.quantities.push_back(q);
    }
    out.states.push_back(state);
  }
  return out;
}

// The stated error of what friction dissipated, of the zone and of all.
std::vector<double> errors_of_slip(const std::vector<Slipping>& history, double coarse) {
  std::vector<Slipping> other = history;
  other.back().dissipated = coarse;
  std::vector<double> out;
  for (const app::Stated& s : estimate::state_numbers(slipping(other), slipping(history), {{}, {1e-6}, 0, {0}}, nullptr))
    if (s.what == app::Measure::kDissipated) out.push_back(s.error);
  return out;
}

} // namespace

TEST_CASE("estimate: what friction dissipates is as uncertain as few slipping pairs make it") {
  const auto check = [&](const std::vector<Slipping>& history, double coarse, double error) {
    const std::vector<double> found = errors_of_slip(history, coarse);
    REQUIRE(found.size() == 2);
    for (size_t i = 0; i < 2; ++i) CHECK(std::fabs(found[i] - error) <= 1e-6);
  };
  check({{3, 0.1, true}}, 0.0999, 0.1 * 6 / 9);
  check({{2, 0.1, true}}, 0.0999, 0.1);             // not more than there is
  check({{20, 0.1, true}}, 0.0999, 0.1 * 6 / 400);  // many pairs
  check({{20, 0.1, true}}, 0.09, 0.02);             // and meshes that differ
  check({{3, 0.1, false}, {6, 0.4, true}}, 0.4, 0); // two meshes that do not: given by the loads
  check({{3, 0.1, false}, {6, 0.4, true}}, 0.399, 0.1 * 6 / 9 + 0.3 / 6);
  check({{0, 0.1, false}, {6, 0.4, true}}, 0.399, 0.4 / 6); // stuck between turns
  check({{4, 0.1, true}, {8, 0.3, true}}, 0.299, 0.1 * 6 / 16 + 0.2 * 6 / 64);
  for (const double error : errors_of_slip({{0, 0.1, true}}, 0)) CHECK(std::isnan(error)); // no pair was seen to slip
  check({{0, 0.1, true}}, 0.0999, 2e-4);                                                   // on neither mesh, and both agree
}

TEST_CASE("estimate: forces and moments that are nothing but round-off are compared with what counts") {
  const estimate::Distance none{{}, {0}, 0, {0}};
  const auto stated = [&](double force, double moment) {
    return estimate::state_numbers(tied(force, -3 * moment), tied(force * (1 + 1e-15), moment), none, nullptr);
  };
  const std::vector<app::Stated> balanced = stated(2, 1e-15);
  REQUIRE(balanced.size() == 2);
  CHECK(balanced[1].scale == doctest::Approx(6)); // the force times the length of the tie
  CHECK((balanced[1].error >= 4e-15 && balanced[1].error < 1e-8));
  const std::vector<app::Stated> loose = stated(1e-19, 1e-19);
  CHECK(loose[0].scale == doctest::Approx(1e-8 * 100 * 0.01));
  CHECK((loose[0].error > 0 && loose[0].error < 1e-16));
  CHECK(stated(1e-3, 0)[0].scale == doctest::Approx(1e-3)); // small, but a force
}
