// Stated errors of the numbers of a solution from two meshes, METHOD (16.7). Phases:
//   1. Match the numbers of both meshes, and of the previous round.
//   2. Find the scale of each error: the number itself, a force, a length or an energy of its zone.
//   3. Combine the change between the meshes, the change in the previous round and the distance of the tractions.
//   4. Confirm: a number counts as met only if two rounds, or two estimates of one round, agree.
// The weights were fitted to problems with closed forms (tests/truth.mk).
#include "program/estimate/error.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace estimate {
namespace {

using app::Measure;

// Error of the coarse mesh over its distance from the finer mesh.
constexpr double kOfCoarse = 2.2;
constexpr double kNoEarlier = 2; // factor on errors without a previous round
constexpr double kExact = 1e-7;  // relative difference below which a number is determined by the loads
constexpr double kRoundOff = 1e-9;
constexpr int32_t kFewPairs = 6;
constexpr double kSameEnd = 0.01; // relative tolerance of the loads at an early end of the history; twice that for their work
// Bounds on the change of a border: times its motion since the previous round; times the distance on the two meshes.
constexpr double kOfMove = 2, kAtLeast = 0.4;
// Of an edge's motion since the previous round: two meshes may agree by accident while the deformation of the bodies changes.
constexpr double kOfEdgeMove = 0.25;
constexpr double kOfDoubt = 2; // factor on the uncertainty where the coarse mesh has no comparable value

bool is_same(const app::Quantity& a, const app::Quantity& b) {
  return a.what == b.what && a.zone == b.zone && a.item == b.item;
}
const app::Quantity* find(const State& state, const app::Quantity& wanted) {
  const auto found = std::find_if(state.quantities.begin(), state.quantities.end(),
                                  [&](const app::Quantity& q) { return is_same(q, wanted); });
  return found == state.quantities.end() ? nullptr : &*found;
}

// The traction distance of a zone; zone 0: the largest of all.
double distance_of(const std::vector<double>& pressure, int32_t zone) {
  if (zone > 0) return static_cast<size_t>(zone) <= pressure.size() ? pressure[static_cast<size_t>(zone) - 1] : 0;
  double largest = 0;
  for (const double p : pressure) largest = std::max(largest, p);
  return largest;
}

double length_of_zone(const Trial& trial, size_t zone) { // of side 2
  const Side& side = trial.zones[zone][1];
  const std::vector<double>& lengths = trial.lengths[static_cast<size_t>(side.body)];
  double sum = 0;
  for (auto e = static_cast<size_t>(side.first);; e = (e + 1) % lengths.size()) {
    sum += lengths[e];
    if (e == static_cast<size_t>(side.last)) return sum;
  }
}

int edges_of(const State& state, int32_t zone) { // at least 1
  const auto edges = std::count_if(state.quantities.begin(), state.quantities.end(),
                                   [&](const app::Quantity& q) { return q.what == Measure::kContactEdge && q.zone == zone; });
  return std::max(1, static_cast<int>(edges));
}

// Scales of numbers near zero: forces are compared with the effect of round-off in motions, friction energies with 1e-4 of the
// work, slip with 1e-4 of the approach, pressures and approaches with the round-off of motions; forces, pressures and motions
// also with 1e-4 of what they were before in the history.
constexpr double kNothing = 1e-4, kNoForce = 1e-8, kRoundedOff = 1e-10;
constexpr double kUnseen = 1e-6; // times these scales: smaller slip is not resolved by any mesh
struct Sizes {
  double force = 0, work = 0;         // smallest values that count
  double approach = 0;                // largest of all zones
  double motion = 0, rotation = 0;    // largest of rigid bodies and platens
  std::vector<double> forces, length; // per zone: force; length of side 2 (tie) or of the touching part (contact)
  std::vector<double> pressure;       // per zone: smallest one that counts
};

double force_on(const State& state, int32_t zone) {
  double force = 0;
  for (const app::Quantity& q : state.quantities)
    if (q.zone == zone && (q.what == Measure::kForceX || q.what == Measure::kForceY)) force = std::hypot(force, q.value);
  return force;
}
Sizes sizes_of(const Trial& trial, size_t last) {
  Sizes out;
  const State& end = trial.states[last];
  for (size_t i = 0; i <= last; ++i)
    for (size_t b = 0; b < trial.states[i].ends.size(); ++b)
      for (const Field f : {kUx, kUy})
        for (const double u : trial.states[i].ends[b][f]) {
          out.force = std::max(out.force, kNoForce * trial.stiffness[b] * std::fabs(u));
          out.approach = std::max(out.approach, kRoundedOff * std::fabs(u));
        }
  out.work = kNothing * std::max(std::fabs(end.work), std::fabs(end.elastic));
  for (size_t z = 0; z < trial.zones.size(); ++z) {
    const auto zone = static_cast<int32_t>(z) + 1;
    out.length.push_back(length_of_zone(trial, z));
    out.forces.push_back(std::hypot(out.force, force_on(end, zone)));
    out.pressure.push_back(kRoundedOff / kNoForce * out.force / out.length.back());
    for (const app::Quantity& q : end.quantities)
      if (q.what == Measure::kMeanPressure && q.zone == zone && q.value > out.pressure.back())
        out.length.back() = out.forces.back() / q.value;
    for (size_t i = 0; i < last; ++i) {
      out.forces.back() = std::max(out.forces.back(), kNothing * force_on(trial.states[i], zone));
      out.pressure.back() = std::max(out.pressure.back(), kNothing * peak_pressure(trial.states[i], zone));
    }
  }
  for (size_t i = 0; i <= last; ++i)
    for (const app::Quantity& q : trial.states[i].quantities) {
      const double size = (i == last ? 1 : kNothing) * std::fabs(q.value);
      if (q.what == Measure::kApproach || q.what == Measure::kShift) out.approach = std::max(out.approach, size);
      if (q.what == Measure::kMotionX || q.what == Measure::kMotionY) out.motion = std::max(out.motion, size);
      if (q.what == Measure::kRotation) out.rotation = std::max(out.rotation, size);
    }
  return out;
}

// The scale S of the error of a number.
double slip_range_of(const State& state, int32_t zone) {
  for (const app::Quantity& q : state.quantities)
    if (q.zone == zone && q.what == Measure::kSlipRange) return q.value;
  return 0;
}

double scale_of(const Sizes& sizes, const State& state, const app::Quantity& q) {
  using app::Scale;
  const double size = std::fabs(q.value);
  const size_t zone = q.zone > 0 ? static_cast<size_t>(q.zone) - 1 : 0;
  switch (app::row_of(q.what).scale) {
  case Scale::kForce: return sizes.forces[zone];
  case Scale::kMoment: return std::max(size, sizes.forces[zone] * sizes.length[zone]);
  case Scale::kApproach: return sizes.approach;
  case Scale::kMotion: return sizes.motion;
  case Scale::kRotation: return sizes.rotation;
  case Scale::kWalk: return std::max({size, slip_range_of(state, q.zone), kUnseen * kNothing * sizes.approach});
  case Scale::kWork: return size > kUnseen * sizes.work ? std::max(size, sizes.work) : 0;
  case Scale::kSlip: return size > kUnseen * kNothing * sizes.approach ? std::max(size, kNothing * sizes.approach) : 0;
  case Scale::kContact: return sizes.length[zone];
  case Scale::kPlace: return sizes.length[zone] / edges_of(state, q.zone);
  case Scale::kOwn:
  case Scale::kGiven: break;
  }
  const bool presses = q.what == Measure::kPeakPressure || q.what == Measure::kMeanPressure;
  return presses ? std::max(size, sizes.pressure[zone]) : size;
}

// Data of a number on two meshes, from which its error follows.
struct Seen {
  double apart;  // difference of its values on the two meshes, c of METHOD (16.7)
  double before; // difference in the previous round times the reduction of the distance since then, m of METHOD (16.7)
  double hidden; // distance of the tractions times the scale, d S: a bound on accidental agreement
  double spacing, doubt;
};

// METHOD (16.7), by a rule of the table of quantities.
double error_of(const app::ErrorRule& rule, const Seen& s) {
  double out = 0;
  const std::pair<double, double> terms[] = {{rule.apart, s.apart},
                                             {rule.before, s.before},
                                             {rule.hidden, s.hidden},
                                             {rule.spacing, s.spacing},
                                             {rule.doubt, s.doubt}};
  for (const auto& [weight, value] : terms)
    if (weight > 0) out = std::max(out, weight * value);
  return out;
}

// Matches numbers of two lists: the n-th number of a kind and place in one list to the n-th in the other.
class NumberFinder {
public:
  explicit NumberFinder(const Round* round) : round_(round) {}
  // Call it for all numbers in their order.
  const app::Stated* find(const app::Stated& s) {
    int which = seen_[key(s)]++;
    if (round_ == nullptr) return nullptr;
    for (const app::Stated& other : round_->stated)
      if (key(other) == key(s) && which-- == 0) return &other;
    return nullptr;
  }

private:
  using Key = std::tuple<app::Measure, std::string, int32_t, int32_t, int32_t>;
  static Key key(const app::Stated& s) { return {s.what, s.of, s.zone, s.item, s.body}; }
  const Round* round_;
  std::map<Key, int> seen_;
};

// Change of a number in the previous round, reduced by the convergence of the tractions since; NaN: unknown.
double change_before(const app::Stated* then, const Round* before, const Distance& now, int32_t zone) {
  if (then == nullptr || std::isnan(then->apart)) return NAN;
  const double d = distance_of(now.pressure, zone), d_then = distance_of(before->pressure, zone);
  return then->apart * (d_then > 0 ? std::min(1.0, d / d_then) : 1.0);
}

// Sets the stated error of a number. `seen.before` is filled in here.
void state(app::Stated& s, Seen seen, double before, const app::ErrorRule& rule) {
  s.apart = seen.apart, s.before = before, s.hidden = seen.hidden, s.spacing = seen.spacing, s.doubt = seen.doubt;
  // Friction in a cycle may vanish on two meshes, and not on a finer one.
  if (s.what != Measure::kCycleDissipated && seen.apart <= kExact * s.scale && !(seen.doubt > kExact * s.scale)) {
    s.error = s.error_by_before = kRoundOff * s.scale;
    return;
  }
  seen.before = std::isnan(before) ? 0 : before;
  s.error = error_of(rule, seen) * (std::isnan(before) ? kNoEarlier : 1);
  if (std::isnan(before)) return;
  seen.apart = before;
  s.error_by_before = error_of(rule, seen);
}

// Did the contact change in the last piece of the history?
bool is_steady(const Trial& trial, size_t last, int32_t zone) {
  size_t before = last;
  while (before > 0 && !trial.states[--before].turn) {
  }
  if (before == last || !trial.states[before].turn) return false;
  const double now = peak_pressure(trial.states[last], zone), then = peak_pressure(trial.states[before], zone);
  return std::fabs(now - then) <= 0.01 * std::max(now, then);
}

// The sum of the errors of the places of a kind in a zone.
double sum_of_errors(const std::vector<app::Stated>& stated, Measure what, int32_t zone) {
  double sum = 0;
  for (const app::Stated& s : stated)
    if (s.zone == zone && s.what == what) sum += s.error;
  return sum;
}

// The error of a mean pressure follows from the errors of the edges of its zone.
double by_edges(const std::vector<app::Stated>& stated, const app::Stated& mean, double length) {
  return mean.value * sum_of_errors(stated, Measure::kContactEdge, mean.zone) / length;
}

// So does that of a width, and of the errors of borders; without borders stick ends at the edges.
double by_places(const std::vector<app::Stated>& stated, const app::Stated& s) {
  const app::ByPlaces& weight = app::row_of(s.what).by_places;
  if (weight.edges == 0 && weight.borders == 0) return 0;
  const double edges = sum_of_errors(stated, Measure::kContactEdge, s.zone),
               borders = sum_of_errors(stated, Measure::kStickBorder, s.zone);
  return s.images * (weight.edges * edges + weight.borders * (borders > 0 ? borders : edges));
}

// Number of pairs of a zone whose status is at least this one.
int32_t pairs_from(const Trial& trial, const State& state, size_t zone, double least) {
  const Side& side = trial.zones[zone][1];
  const std::vector<double>& status = state.ends[static_cast<size_t>(side.body)][kStatus];
  const size_t elements = trial.lengths[static_cast<size_t>(side.body)].size(), nodes = static_cast<size_t>(trial.nodes);
  const size_t own = std::max<size_t>(1, nodes - 1); // nodes of one element, without the shared end
  int32_t out = 0;
  for (auto e = static_cast<size_t>(side.first);; e = (e + 1) % elements) {
    for (size_t i = 0; i < own; ++i) out += status[e * nodes + i] >= least ? 1 : 0;
    if (e == static_cast<size_t>(side.last)) return out;
  }
}

// Number of touching pairs of a zone at the end.
int32_t touching_pairs(const Trial& trial, size_t zone) { return pairs_from(trial, trial.states.back(), zone, C2D_STICK); }

double dissipated_in(const State& state, int32_t zone) {
  for (const app::Quantity& q : state.quantities)
    if (q.what == Measure::kDissipated && q.zone == zone) return q.value;
  return 0;
}

// The share of the energy dissipated between two recorded states that is uncertain where so many pairs slip. It follows from
// slip that is small beside the motion of the surfaces, at edges that advance from pair to pair: neither the distance of the
// tractions nor two meshes show its error. (The factor was fitted to random sketches, tests/random.)
double share_by_slip(int32_t pairs) {
  constexpr double kOfSlipping = 6;
  return std::min(1.0, kOfSlipping / pairs / pairs);
}

// The uncertain energy of a zone. Of a state in which all pairs stick the largest number in its piece of the history counts;
// NaN: friction dissipates energy in a piece, and no pair slips in any of its recorded states.
double by_slip(const Trial& trial, size_t last, size_t zone) {
  constexpr double kOfAll = 0.01;
  const auto number = static_cast<int32_t>(zone) + 1;
  const double least = kOfAll * dissipated_in(trial.states[last], number);
  double before = 0, sum = 0, stuck = 0; // stuck: dissipated in states of this piece without slip
  int32_t most = 0;
  for (size_t i = 0; i <= last; ++i) {
    const int32_t pairs = pairs_from(trial, trial.states[i], zone, C2D_SLIP);
    const double now = dissipated_in(trial.states[i], number), gain = std::fabs(now - before);
    (pairs > 0 ? sum : stuck) += pairs > 0 ? share_by_slip(pairs) * gain : gain;
    before = now, most = std::max(most, pairs);
    if (!trial.states[i].turn && i != last) continue;
    if (most == 0 && stuck > least) return NAN;
    if (most > 0) sum += share_by_slip(most) * stuck;
    stuck = 0, most = 0;
  }
  return sum;
}

// The same of a number: of its zone, or of all of them. An energy that is not resolved has no error if two meshes differ.
void state_slip(app::Stated& s, const Trial& trial, size_t last) {
  if (s.apart <= kExact * s.scale) return; // given by the loads
  double sum = 0;
  for (size_t z = 0; z < trial.zones.size(); ++z)
    if (trial.tied[z] == 0 && (s.zone == 0 || s.zone == static_cast<int32_t>(z) + 1)) sum += by_slip(trial, last, z);
  if (!std::isnan(sum))
    s.error = std::max(s.error, sum);
  else if (s.apart > 0.5 * std::fabs(s.value))
    s.error = s.error_by_before = NAN;
}

// Does the contact end at a free edge, that is neither at the end of the side nor at a corner?
bool has_edge(const State& state, size_t zone) {
  return std::any_of(state.quantities.begin(), state.quantities.end(), [&](const app::Quantity& q) {
    return q.what == Measure::kContactEdge && q.zone == static_cast<int32_t>(zone) + 1 && !q.at_corner;
  });
}

// Does the contact of a zone consist of only a few pairs? Zone 0: of any zone.
bool is_scant(const Trial& trial, int32_t zone) {
  for (size_t z = 0; z < trial.zones.size(); ++z) {
    if (trial.tied[z] != 0 || (zone > 0 && static_cast<size_t>(zone) != z + 1)) continue;
    const int32_t pairs = has_edge(trial.states.back(), z) ? touching_pairs(trial, z) : 0;
    if (pairs > 0 && pairs < kFewPairs) return true;
  }
  return false;
}

// If the model is the reason for an early end, the history ends at the same loads on all meshes.
bool ended_by_mesh(const Trial& halved, const Round* before) {
  if (halved.outcome == C2D_REACHED) return false;
  if (before == nullptr || before->loads.empty() || halved.states.empty()) return true;
  const std::vector<double>& now = halved.states.back().loads;
  double size = 0, off = 0;
  for (size_t k = 0; k < std::min(now.size(), before->loads.size()); ++k)
    size = std::max(size, std::fabs(now[k])), off = std::max(off, std::fabs(now[k] - before->loads[k]));
  const double work = halved.states.back().work;
  return off > kSameEnd * size ||
         std::fabs(work - before->work) > 2 * kSameEnd * std::max(std::fabs(work), std::fabs(before->work));
}

} // namespace

bool is_same_number(const app::Stated& a, const app::Stated& b) {
  return std::tie(a.what, a.of, a.zone, a.item, a.body) == std::tie(b.what, b.of, b.zone, b.item, b.body);
}

const app::Stated* find_number(const std::vector<app::Stated>& all, const app::Stated& s, size_t n) {
  for (const app::Stated& one : all)
    if (is_same_number(one, s) && n-- == 0) return &one;
  return nullptr;
}

std::vector<app::Stated> state_numbers(const Trial& coarse, const Trial& halved, const Distance& between, const Round* before) {
  std::vector<app::Stated> out;
  NumberFinder finder(before);
  for (size_t z = 0; z < between.pressure.size(); ++z) {
    if (halved.tied[z] != 0) continue;
    app::Stated s;
    s.what = Measure::kTractions;
    s.zone = static_cast<int32_t>(z) + 1;
    s.value = s.scale = 1;
    const bool known = finder.find(s) != nullptr;
    s.error = between.pressure[z] * (known ? 1 : kNoEarlier);
    if (known) s.error_by_before = s.error;
    out.push_back(s);
  }
  const size_t common = std::min(halved.states.size(), coarse.states.size()); // a history may end early
  if (common == 0) return out;
  const State &f = halved.states[common - 1], &c = coarse.states[common - 1];
  const Sizes sizes = sizes_of(halved, common - 1);
  for (const app::Quantity& q : f.quantities) {
    const app::Quantity* other = find(c, q);
    app::Stated s;
    s.what = q.what, s.zone = q.zone, s.item = q.item, s.value = q.value;
    s.at[0] = q.at[0], s.at[1] = q.at[1], s.along = q.along, s.images = q.images;
    s.scale = scale_of(sizes, f, q);
    const app::Stated* last = finder.find(s);
    const double then = change_before(last, before, between, q.zone);
    const bool unseen = s.scale == 0 && (q.what == Measure::kDissipated || q.what == Measure::kSlipRange);
    if (unseen && q.what == Measure::kDissipated) s.error = 0;
    if (other != nullptr && !unseen) {
      const bool moved = q.what == Measure::kStickBorder && !is_steady(halved, common - 1, q.zone);
      const double since = last == nullptr ? NAN : std::hypot(q.at[0] - last->at[0], q.at[1] - last->at[1]);
      double step = apart(*other, q), doubt = q.doubt;
      if (moved && last != nullptr) // on the coarse mesh the border is at a node
        step = std::min(step, std::max(kOfMove * since, kAtLeast * step));
      if (q.what == Measure::kContactEdge && since > 0) doubt = kOfEdgeMove * since;
      state(s, {step, 0, distance_of(between.pressure, q.zone) * s.scale, q.spacing, doubt}, then,
            app::row_of(q.what).rule[moved ? 1 : 0]);
    }
    if (q.what == Measure::kDissipated && !unseen && !std::isnan(s.error)) state_slip(s, halved, common - 1);
    if (q.unbounded) s.endless = true, s.error = s.error_by_before = NAN;
    out.push_back(s);
  }
  for (app::Stated& s : out) { // needs the errors of the edges; an unknown error stays unknown
    if (s.what == Measure::kMeanPressure && s.value > 0)
      s.error = std::max(s.error, by_edges(out, s, force_on(f, s.zone) / s.value));
    s.error = std::max(s.error, by_places(out, s));
  }
  return out;
}

std::vector<app::Stated> state_wanted(const std::vector<app::Stated>& coarse, std::vector<app::Stated> fine,
                                      const Distance& between, const Round* before) {
  NumberFinder finder(before);
  const double d = distance_of(between.pressure, 0);
  for (size_t i = 0; i < fine.size(); ++i) {
    app::Stated& s = fine[i];
    const double then = change_before(finder.find(s), before, between, 0);
    if (i >= coarse.size()) continue;
    // A value found by a less accurate method on the coarse mesh gives no error estimate.
    const double apart = coarse[i].way < s.way ? kOfDoubt * s.doubt : std::fabs(s.value - coarse[i].value);
    state(s, {apart, 0, d * std::max(s.scale, s.unseen), 0, s.doubt}, then,
          app::row_of(s.what).rule[s.way > 0 || s.other_rule ? 1 : 0]);
  }
  return fine;
}

void drop_unknown(std::vector<app::Stated>& stated) {
  const auto unknown = [](const app::Stated& s) { return std::isnan(s.error) && std::isnan(s.tolerance) && !s.is_unbounded(); };
  stated.erase(std::remove_if(stated.begin(), stated.end(), unknown), stated.end());
}

void confirm(std::vector<app::Stated>& stated, const Trial& halved, const Round* before) {
  const bool cut_off = ended_by_mesh(halved, before);
  NumberFinder finder(before);
  for (app::Stated& s : stated) {
    const app::Stated* then = finder.find(s);
    const bool twice = then != nullptr && then->error <= s.tolerance * then->scale;
    s.confirmed = !cut_off && !is_scant(halved, s.zone) && (twice || s.error_by_before <= s.tolerance * s.scale);
  }
}

std::vector<app::Stated> state_of_coarse(const Trial& coarse, const Trial& halved, const Distance& between) {
  std::vector<app::Stated> out = state_numbers(coarse, halved, between, nullptr);
  drop_unknown(out);
  for (app::Stated& s : out) {
    s.error *= kOfCoarse / kNoEarlier; // from the error of the finer mesh to that of the coarse one
    for (const app::Quantity& q : coarse.states.back().quantities)
      if (s.zone == q.zone && s.item == q.item && s.what == q.what) {
        s.value = q.value;
        s.at[0] = q.at[0], s.at[1] = q.at[1], s.along = q.along;
      }
  }
  return out;
}

} // namespace estimate
