#include "program/sketch/torsion.hpp"

#include "program/sketch/deck/idle_cases.hpp"
#include "program/sketch/read/words.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {
namespace {

std::string case_named(const LoadCase& c) { return c.name.empty() ? "one load case" : "load case " + in_quotes(c.name); }

class TorsionCases {
public:
  explicit TorsionCases(Sketch& sketch) : s_(sketch) {}
  std::vector<Fault> run();

private:
  void find();
  void check_bodies();
  void take_cases();
  void take_history();
  void check_supports();
  void connect(int body, std::vector<bool>& supported) const;

  Sketch& s_;
  std::vector<char> round_; // of each case: loads round the axis
  std::vector<int> number_; // of each case: its new number among its kind
  std::vector<Fault> faults_;
  bool has_history_ = false;
};

void TorsionCases::find() {
  round_.assign(s_.cases.size(), 0);
  for (const Turn& t : s_.torsion.turns) {
    if (!t.loads() || round_[static_cast<size_t>(t.load_case)] != 0) continue;
    const auto of = static_cast<size_t>(t.load_case);
    round_[of] = 1;
    if (acts(s_, of))
      faults_.push_back({t.at, case_named(s_.cases[of]) +
                                   " has loads in the plane of the section and round the axis, whose friction would share one "
                                   "cone: expected a case of its own for each, that round the axis last in the history"});
    if (s_.cases[of].course) faults_.push_back({t.at, "the loads of this case move, expected a case without a course"});
  }
}

void TorsionCases::check_bodies() {
  for (const Turn& t : s_.torsion.turns) {
    if (t.side && s_.bodies[static_cast<size_t>(t.body)].rigid)
      faults_.push_back({t.at, "body " + in_quotes(s_.bodies[static_cast<size_t>(t.body)].name) +
                                   " is rigid: expected 'drive' for its rotation; without 'drive' it does not turn"});
    for (const Turn& other : s_.torsion.turns) {
      if (&other == &t || !t.side || !other.side || other.body != t.body || !t.is_traction || other.is_traction) continue;
      for (const std::string& name : t.side->names)
        if (other.side->has(name))
          return faults_.push_back({t.at, s_.bodies[static_cast<size_t>(t.body)].name + "." + name +
                                              " has an angle round the axis in line " + std::to_string(other.at.line) +
                                              ", expected an angle or a traction, not both"});
    }
  }
}

void TorsionCases::take_cases() {
  std::vector<LoadCase> left;
  for (size_t c = 0; c < s_.cases.size(); ++c) {
    std::vector<LoadCase>& to = round_[c] != 0 ? s_.torsion.cases : left;
    number_.push_back(static_cast<int>(to.size()));
    to.push_back(s_.cases[c]);
  }
  const auto renumber = [&](auto& statements) {
    statements.erase(std::remove_if(statements.begin(), statements.end(),
                                    [&](const auto& s) { return round_[static_cast<size_t>(s.load_case)] != 0; }),
                     statements.end());
    for (auto& s : statements) s.load_case = number_[static_cast<size_t>(s.load_case)];
  };
  for (Condition& c : s_.conditions) // supports of a case round the axis hold in the others too
    if (round_[static_cast<size_t>(c.load_case)] != 0 && !left.empty())
      c.load_case = static_cast<int>(std::find(round_.begin(), round_.end(), 0) - round_.begin());
  if (left.empty()) {
    left.push_back({});
    for (Condition& c : s_.conditions) c.load_case = 0;
    s_.point_loads.clear(), s_.body_forces.clear(), s_.drives.clear();
  } else {
    for (Condition& c : s_.conditions) c.load_case = number_[static_cast<size_t>(c.load_case)];
    renumber(s_.point_loads), renumber(s_.body_forces), renumber(s_.drives);
  }
  for (Turn& t : s_.torsion.turns)
    if (t.load_case >= 0)
      t.load_case = round_[static_cast<size_t>(t.load_case)] != 0 ? number_[static_cast<size_t>(t.load_case)] : -1;
  s_.cases = std::move(left);
}

// Pieces of the history before the first factor of a case round the axis belong to the others.
void TorsionCases::take_history() {
  Torsion& t = s_.torsion;
  const Place at = std::find_if(t.turns.begin(), t.turns.end(), [](const Turn& turn) { return turn.loads(); })->at;
  if (s_.pieces == 0) {
    t.pieces = 1;
    for (size_t c = 0; c < t.cases.size(); ++c) t.cases[c].factors = {c == 0 ? 1.0 : 0.0};
  } else {
    int first = s_.pieces;
    for (const LoadCase& c : t.cases)
      for (int k = 0; k < s_.pieces; ++k)
        if (c.factors[static_cast<size_t>(k)] != 0) first = std::min(first, k);
    for (LoadCase& c : s_.cases) {
      for (int k = std::max(first, 1); k < s_.pieces && !c.factors.empty(); ++k)
        if (c.factors[static_cast<size_t>(k)] != c.factors[static_cast<size_t>(k) - 1])
          return faults_.push_back(
              {at, "the history changes " + case_named(c) + " after loads round the axis, expected these last"});
      if (first == 0 && !c.factors.empty() && c.factors[0] != 0)
        return faults_.push_back({at, "the history changes " + case_named(c) + " and loads round the axis in one piece"});
    }
    for (LoadCase& c : s_.cases) c.factors.resize(static_cast<size_t>(c.factors.empty() ? 0 : first));
    for (LoadCase& c : s_.cases) c.places.resize(c.factors.size());
    for (LoadCase& c : t.cases) c.factors.erase(c.factors.begin(), c.factors.begin() + first);
    t.first_piece = first, t.pieces = s_.pieces - first;
    s_.pieces = first;
  }
  for (size_t c = 0; c < t.cases.size(); ++c)
    if (std::all_of(t.cases[c].factors.begin(), t.cases[c].factors.end(), [](double f) { return f == 0; }))
      for (const Turn& turn : t.turns)
        if (turn.load_case == static_cast<int>(c))
          return faults_.push_back(
              {turn.at, case_named(t.cases[c]) + " is never applied, expected a statement 'history' that gives it a factor"});
  if (has_history_ && s_.pieces == 0 && acts(s_, 0))
    faults_.push_back(
        {at, case_named(s_.cases[0]) + " is never applied, expected a statement 'history' that gives it a factor"});
}

// Marks a body and all that it carries round the axis.
void TorsionCases::connect(int body, std::vector<bool>& supported) const {
  if (supported[static_cast<size_t>(body)]) return;
  supported[static_cast<size_t>(body)] = true;
  for (const Interface& i : s_.interfaces)
    for (int side = 0; side < 2; ++side)
      if (i.side[side].body == body && (i.tied || friction_round(i) > 0)) connect(i.side[1 - side].body, supported);
}

void TorsionCases::check_supports() {
  std::vector<bool> supported(s_.bodies.size(), false);
  for (size_t b = 0; b < s_.bodies.size(); ++b)
    if (s_.bodies[b].rigid) connect(static_cast<int>(b), supported);
  for (const Turn& t : s_.torsion.turns)
    if (!t.is_traction) connect(t.body, supported);
  for (const Turn& t : s_.torsion.turns) {
    if (!t.loads() || supported[static_cast<size_t>(t.body)]) continue;
    const bool touches = std::any_of(s_.interfaces.begin(), s_.interfaces.end(),
                                     [&](const Interface& i) { return i.side[0].body == t.body || i.side[1].body == t.body; });
    const std::string name = in_quotes(s_.bodies[static_cast<size_t>(t.body)].name);
    return faults_.push_back({t.at, "nothing keeps body " + name + " from turning, expected " +
                                        (touches ? "a coefficient of friction of its contact ('mu'), " : "") +
                                        "a tie, 'fix' or a given angle"});
  }
}

std::vector<Fault> TorsionCases::run() {
  if (std::none_of(s_.torsion.turns.begin(), s_.torsion.turns.end(), [](const Turn& t) { return t.loads(); })) {
    s_.torsion = Torsion();
    for (const Want& w : s_.wants)
      if (w.of == WantOf::kTorsion)
        return {{w.at, "the sketch has no load round an axis, expected 'turn' in a statement 'move', 'drive' or 'traction'"}};
    return {};
  }
  has_history_ = s_.pieces > 0;
  find();
  check_bodies();
  if (faults_.empty()) take_cases();
  if (faults_.empty()) take_history();
  if (faults_.empty()) check_supports();
  return faults_;
}

} // namespace

double friction_round(const Interface& interface) { return interface.friction_round.value_or(interface.friction); }

std::vector<Fault> take_torsion(Sketch& sketch) { return TorsionCases(sketch).run(); }

} // namespace sketch
