#include "judged_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace random_decks {

using namespace many;
using Bodies = many::Model;

namespace {

struct Findings {
  Verdict& v;
  void say(const std::string& what, double value) {
    char text[64];
    std::snprintf(text, sizeof text, ": %.3g", value);
    v.findings.push_back(what + text);
  }
  void most(const std::string& what, double value, double limit) {
    if (!(value <= limit)) say(what, value);
  }
};

double largest_energy(const Result& r) {
  double size = 0;
  for (const Step& s : r.steps) size = std::max({size, std::fabs(s.work), s.elastic, s.dissipated});
  return size;
}

bool was_told(const Result& r, int32_t warning) {
  for (const c2d_error& e : r.told)
    if (e.status == warning) return true;
  return false;
}

// Friction gives no energy back; work is what is stored and dissipated, but for the error of meshes as coarse as these, unless
// a warning says so.
void check_energies(Findings& f, const Result& r) {
  const double size = largest_energy(r);
  double before = 0;
  for (const Step& s : r.steps) {
    f.most("friction gives energy back", before - s.dissipated, 1e-9 * size);
    before = s.dissipated;
  }
  if (!was_told(r, C2D_WARN_ENERGY)) f.most("energies", std::fabs(r.last().defect), 0.1);
}

void check_form(Findings& f, const BodyForm& form, const Bodies& m, const Result& r) {
  const Result s = solve(form.model);
  if (s.status == C2D_ERR_MEMORY && form.model.bytes > 0 && s.told_of("slender bodies upon each other")) return;
  if (s.status != r.status) return f.say(form.name + ": another status of the call: " + s.messages(), s.status);
  if (r.status != C2D_OK) return;
  if (s.outcome != r.outcome) return f.say(form.name + ": another outcome", s.outcome);
  const size_t steps = r.steps.size() * static_cast<size_t>(form.map.every);
  if (r.outcome != C2D_REACHED && form.map.every > 1) return; // it may end in the middle of a step
  if (s.steps.size() != steps) return f.say(form.name + ": another number of steps", static_cast<double>(s.steps.size()));
  Mapping map = form.map;
  map.least = least_sizes(m, r);
  if (!r.steps.empty()) f.most(form.name + ": other results", difference(r, s, map), 1e-8);
}

void check_deck(Findings& f, const Bodies& m, const Result& r, const std::vector<int32_t>& order) {
  Mapping by_deck; // platens are numbered behind the zones in both
  by_deck.zone.resize(order.size());
  for (size_t i = 0; i < order.size(); ++i) by_deck.zone[static_cast<size_t>(order[i] - 1)] = static_cast<int32_t>(i) + 1;
  for (size_t i = 0; i < m.platens.size(); ++i) by_deck.zone.push_back(static_cast<int32_t>(order.size() + i) + 1);
  by_deck.least = least_sizes(m, r);
  const Result deck = solve_deck(f.v.deck);
  if (deck.status != C2D_OK)
    f.v.findings.push_back("the deck is refused: " + deck.messages());
  else if (deck.steps.size() == r.steps.size() && !r.steps.empty())
    f.most("by a deck: other results", difference(r, deck, by_deck), 1e-9);
}

} // namespace

std::vector<BodyForm> common_forms(const Bodies& m) {
  std::vector<BodyForm> forms;
  std::vector<int32_t> bodies, zones;
  for (size_t i = m.bodies.size(); i > 0; --i) bodies.push_back(static_cast<int32_t>(i));
  for (size_t i = m.zones.size(); i > 0; --i) zones.push_back(static_cast<int32_t>(i));
  for (size_t i = 1; i < m.bodies.size(); ++i) { // 3 2 1; 2 1 3 and 3 1 2
    forms.push_back({"bodies in another order", with_bodies_in_order(m, bodies), Mapping()});
    std::rotate(bodies.begin(), bodies.begin() + 1, bodies.end());
  }
  if (bodies.size() > 2) forms.push_back({"bodies in another order", with_bodies_in_order(m, bodies), Mapping()});
  if (zones.size() > 1) {
    forms.push_back({"zones in another order", with_zones_in_order(m, zones), Mapping()});
    for (size_t i = 0; i < m.platens.size(); ++i) zones.push_back(static_cast<int32_t>(zones.size()) + 1);
    forms.back().map.zone = zones;
  }
  BodyForm units = {"other units", scaled(m, 0.37, 1e3), Mapping()};
  units.map.length = 0.37, units.map.stress = 1e3;
  units.map.place = [](double& x, double& y) { x *= 0.37, y *= 0.37; };
  units.map.dimensions = m.plane == C2D_AXISYMMETRIC ? 3 : 2;
  forms.push_back(units);
  return forms;
}

void judge_bodies(Verdict& v, const Bodies& m, const std::vector<BodyForm>& forms) {
  Findings f{v};
  std::vector<int32_t> order;
  v.deck = deck_of(m, v.title, order);
  const clock_t start = clock();
  const Result r = solve(m);
  v.seconds = static_cast<double>(clock() - start) / CLOCKS_PER_SEC;
  v.status = r.status, v.outcome = r.outcome, v.load = r.summary.load;
  v.not_unique = was_told(r, C2D_WARN_NOT_UNIQUE), v.undefined_place = was_told(r, C2D_WARN_UNDEFINED_PLACE);
  if (r.status != C2D_OK) v.findings.push_back("refused: " + r.messages());
  v.unstressed = r.status == C2D_OK && r.outcome == C2D_REACHED && largest_energy(r) <= least_sizes(m, r).energy;
  if (v.unstressed) return; // bodies that only move: all numbers are round-off
  if (r.status == C2D_OK && r.outcome == C2D_REACHED) {
    f.most("a body is not in balance", imbalance(m, r), 1e-10);
    f.most("residual", r.summary.max_residual, 1e-9);
    check_energies(f, r);
  }
  Result reached = r; // where a path cannot begin ties are told as open
  while (!reached.steps.empty() && reached.last().outcome != C2D_REACHED) reached.steps.pop_back();
  const std::string law = breach(m, reached);
  if (!law.empty()) v.findings.push_back("a law: " + law);
  if (v.not_unique || v.undefined_place) return; // other forms may choose otherwise
  for (const BodyForm& form : forms) check_form(f, form, m, r);
  if (r.status == C2D_OK) check_deck(f, m, r, order);
}

} // namespace random_decks
