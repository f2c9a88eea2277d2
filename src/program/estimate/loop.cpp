// Adaptive refinement of the mesh of a sketch (METHOD 16.5). Every round has four phases:
//   1. solve_pair: solve the history on the coarse mesh and on the mesh with every element bisected, and compare the tractions.
//   2. state_errors: state the error of every requested number from both meshes, METHOD (16.7).
//   3. check_kind: change the kind of mesh where it is unsuitable: quadratic functions, finer contacts, no elements left out.
//   4. refine: end when all tolerances are met, else bisect the elements whose share of the error is large, METHOD (16.6).
// Tolerances are reached in stages: 1 % first, then a tenth of the previous stage. For a deck, estimate_deck does phases 1 and
// 2 once.
#include "program/estimate/loop.hpp"

#include "program/commands/drawn_words.hpp"
#include "program/estimate/fatigue.hpp"
#include "program/estimate/marks.hpp"
#include "program/estimate/mesh/far.hpp"
#include "program/estimate/mesh/gaps.hpp"
#include "program/estimate/mesh/halved.hpp"
#include "program/estimate/mesh/mesh_curves.hpp"
#include "program/estimate/torsion.hpp"
#include "program/estimate/wanted.hpp"
#include "program/interrupt.hpp"
#include "program/sketch/refine.hpp"
#include "program/sketch/shapes/region.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <tuple>

namespace estimate {
namespace {

constexpr double kFirst = 0.25;                        // fineness of the first mesh
constexpr double kStalls = 0.7;                        // ratio to the previous distance that is too large
constexpr double kFirstStage = 0.01, kNextStage = 0.1; // first stage; ratio of successive stages
constexpr double kBends = 1;          // energy difference of the first two meshes that selects quadratic functions
constexpr double kSlenderBends = 0.3; // the same for a model with a slender body
constexpr double kSlender = 8;        // (half the boundary) squared over the area: a rectangle six times as long as it is high
constexpr double kUnfollowed = 0.1;   // above this energy difference no number counts as met
constexpr int kMostRegrown = 3;       // after so many corrections no elements are left out
constexpr double kLeastStep = 0.15, kFirstStep = 0.5; // least factors on the target of the distance: in one round, in the first
constexpr double kLeastRest = 0.03, kMostRest = 0.5;  // of that of the energy, which is lowered in proportion to the distance
constexpr double kRestOnce = 0.125;                   // the same where the distance is below its target
constexpr double kOwn = 0.5;      // if the elements of a zone cause less than this fraction of its distance, refine elsewhere
constexpr double kOfMotion = 0.1; // times the tolerance and the largest motion: smaller gaps count as contact
constexpr double kOfUndecided = 0.25; // factor on the energy target while contact is neither found nor excluded
constexpr double kSettles = 0.8;      // of the previous error: above it the error does not fall
constexpr int kPatience = 3;
constexpr int kEarlyRounds = 3;     // bisections of the contacts before an early end of the history is accepted
constexpr double kOfElements = 2.6; // exponent of the solution time over the number of elements
constexpr double kOfPlaces = 0.75;  // tightening factor if only numbers at one place are inaccurate
constexpr double kOfBodies = 2;     // times d S: the error of a number that the bodies determine
constexpr double kOfEnergy = 8;     // allowed energy difference over the tolerance
constexpr double kLags = 2;         // times its tolerance: the error of a number that converges slower than the tractions

struct Level {
  sketch::Mesh mesh;
  std::string deck;
  Trial trial;
  std::shared_ptr<const Twisted> twisted{}; // with loads round the axis
};

class Loop {
public:
  Loop(const sketch::Sketch& sketch, const Demand& demand, const std::function<void(const app::MeshRound&)>& report,
       TrialKeeper* keeper);
  Adapted run();

private:
  enum class Next { refine, again, end };
  void search();
  Next solve_pair(Level& coarse, Level& fine, Distance& between);
  Next check_kind(Level& coarse, const Level& fine, const Distance& between);
  Next refine(Level& coarse, const Level& fine, const Distance& between);
  void regrow(Level& coarse);
  bool solve_level(Level& level, bool adapted);
  bool is_within_limits(const sketch::Mesh& mesh);
  void state_errors(const Level& coarse, const Level& fine, const Distance& between);
  bool is_near_enough(const app::Stated& s) const;
  bool all_met() const;
  bool all_within() const;
  void end_stages();
  bool takes_quadratic();
  bool lags_behind(const Distance& distance) const;
  bool stays_linear();
  void watch();
  void tell_endless();
  sketch::Mesh with_finer_contacts(const sketch::Mesh& mesh) const;
  sketch::Mesh next_mesh(const Level& coarse, const Level& fine, const Distance& distance, bool near);
  double aim() const;
  double energy_aim() const;
  double step_of_rest(const Distance& distance, double pressure) const;
  bool is_near(const Distance& distance) const;
  void tighten(const Distance& distance, bool first);
  void take(const Level& level);

  Demand demand_;
  const std::function<void(const app::MeshRound&)>& report_;
  TrialKeeper* keeper_;
  Adapted out_;
  const sketch::Sketch& s_;
  struct Watched {
    double error = HUGE_VAL;
    int stays = 0; // rounds in a row
  };
  std::map<std::tuple<app::Measure, int32_t, int32_t, int32_t, int>, Watched>
      watched_;  // by kind, zone, item, body, and count among equal ones
  Round before_; // stated numbers of the previous round
  double seconds_ = 0, work_ = 0;
  double last_work_ = 0;               // multiplications on the last mesh
  int last_size_ = 1;                  // elements of the last mesh times the order of functions
  double least_;                       // smallest requested tolerance
  double stage_;                       // tolerance of the current stage
  double rest_ = 1, worst_ = HUGE_VAL; // rest_ < 1: refine the boundary outside contacts more
  std::string history_;                // why the history of the selected mesh ended early
  bool is_whole_ = false;              // the history of the selected mesh is complete
  bool has_tapes_ = false;             // the store of the demand has the tapes of the selected mesh
  bool tries_order_ = false;           // the order of functions has just been raised
  double strictness_ = 1;              // below 1 if numbers are inaccurate although the tractions have converged
  bool begun_ = false;                 // a finer mesh has been made at least once
  int early_ = 0;                      // rounds with an incomplete history
  int idle_ = 0;                       // successive rounds without more elements
  int regrown_ = 0;                    // how often contact has reached elements that were left out
};

// A displacement or a stress at a point inside a body.
bool is_inside(const app::Stated& s) { return s.zone == 0 && s.of.empty() && is_place(s); }

// Is it a number of torsion that is too inaccurate, or not yet confirmed?
bool is_torsion_missed(const app::Stated& s) {
  return s.what >= app::Measure::kTorque && s.what <= app::Measure::kShear && !s.is_met();
}

double least_tolerance(const sketch::Sketch& s) {
  double out = s.tolerance;
  for (const sketch::Want& want : s.wants) out = std::min(out, want.tolerance.value_or(s.tolerance));
  return out;
}

Loop::Loop(const sketch::Sketch& sketch, const Demand& demand, const std::function<void(const app::MeshRound&)>& report,
           TrialKeeper* keeper)
    : demand_(demand), report_(report), keeper_(keeper), s_(out_.sketch), least_(least_tolerance(sketch)), stage_(kFirstStage) {
  out_.sketch = sketch;
  demand_.drawn = true;
}

// The overlaps of elements of two meshes on the same curves.
Overlaps overlaps_of(const sketch::Mesh& coarse, const sketch::Mesh& fine) {
  Overlaps out;
  for (size_t b = 0; b < coarse.bodies.size(); ++b) {
    out.push_back({});
    int32_t first = 0, first_fine = 0;
    for (size_t o = 0; o < coarse.bodies[b].size(); ++o)
      for (size_t c = 0; c < coarse.bodies[b][o].curves.size(); ++c) {
        const std::vector<double>&p = coarse.bodies[b][o].curves[c].ends, &q = fine.bodies[b][o].curves[c].ends;
        const auto eta = [](const std::vector<double>& ends, size_t e, double s) {
          return -1 + 2 * (s - ends[e]) / (ends[e + 1] - ends[e]);
        };
        for (size_t e = 0, f = 0; e + 1 < p.size() && f + 1 < q.size();) {
          const double from = std::max(p[e], q[f]), to = std::min(p[e + 1], q[f + 1]);
          if (to - from > 1e-9 * (q[f + 1] - q[f]))
            out.back().push_back({first + static_cast<int32_t>(e), first_fine + static_cast<int32_t>(f), eta(p, e, from),
                                  eta(p, e, to), eta(q, f, from), eta(q, f, to)});
          if (p[e + 1] <= q[f + 1])
            ++e;
          else
            ++f;
        }
        first += static_cast<int32_t>(p.size()) - 1, first_fine += static_cast<int32_t>(q.size()) - 1;
      }
  }
  for (size_t b = coarse.bodies.size(); b > out.size();) out.push_back({});
  return out;
}

Distance distance_of(const Level& coarse, const Level& fine) {
  return distance(coarse.trial, fine.trial, overlaps_of(coarse.mesh, fine.mesh));
}

app::MeshRound round_of(const Trial& trial) {
  app::MeshRound round;
  round.elements = trial.elements, round.pairs = trial.pairs, round.equations = trial.equations;
  round.seconds = trial.seconds;
  return round;
}

void tell_distance(const Distance& d, const Trial& trial, app::MeshRound& round) {
  for (size_t z = 0; z < d.pressure.size(); ++z)
    if (trial.tied[z] == 0) round.pressure = std::fmax(round.pressure, d.pressure[z]);
  round.energy = d.energy;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", value);
  return text;
}

// The first mesh is always within the limits.
bool Loop::is_within_limits(const sketch::Mesh& mesh) {
  if (out_.loop.rounds.empty()) return true;
  if (sketch::elements_of(mesh) > s_.most_elements) {
    out_.loop.stopped = "a finer mesh would have more than " + std::to_string(s_.most_elements) + " elements";
    return false;
  }
  const app::MeshRound& last = out_.loop.rounds.back();
  const double more = std::pow(static_cast<double>(sketch::elements_of(mesh) * s_.order) / last_size_, kOfElements);
  if (s_.most_seconds > 0 && seconds_ + more * last.seconds > s_.most_seconds) {
    out_.loop.stopped = "another refinement would exceed the time limit";
    return false;
  }
  if (s_.most_seconds == 0 && work_ + more * last_work_ > s_.most_work) {
    out_.loop.stopped = "another refinement would exceed the work limit, " + number(s_.most_work) + " multiplications (" +
                        number(work_) + " took " + number(seconds_) + " s)";
    return false;
  }
  return true;
}

// Did the history end because of numerical inaccuracy rather than mechanics?
bool fails(c2d_outcome outcome) {
  return outcome == C2D_NO_ADMISSIBLE_CHANGE || outcome == C2D_NO_PROGRESS || outcome == C2D_UNDECIDED ||
         outcome == C2D_BEYOND_LIMITS;
}

bool Loop::solve_level(Level& level, bool adapted) {
  has_tapes_ = false;
  level.trial = Trial();
  level.deck = sketch::deck_of(s_, level.mesh);
  std::string why;
  const bool known = keeper_ != nullptr && keeper_->recall(level.deck, level.trial);
  ask_below(s_, level.mesh, demand_.cycle);
  const c2d_status status = known ? c2d_status{C2D_OK} : solve(level.deck, demand_, level.trial, why);
  if (status == C2D_OK && !known && keeper_ != nullptr && !keeper_->keep(level.deck, level.trial)) return false;
  seconds_ += level.trial.seconds, work_ += level.trial.work;
  if (status != C2D_OK) {
    why = app::in_words_of_drawing(why, level.deck);
    if (out_.deck.empty()) out_.status = status, out_.why = why, out_.deck = level.deck;
    out_.loop.stopped = status == C2D_ERR_CANCELLED ? "the search was interrupted" : why;
    return false;
  }
  if (is_whole_ && fails(level.trial.outcome)) {
    out_.loop.stopped = "on the next mesh the history ended early: " + level.trial.why;
    return false;
  }
  last_work_ = level.trial.work, last_size_ = level.trial.elements * s_.order;
  if (s_.torsion.any()) level.twisted = std::make_shared<const Twisted>(twist(s_, level.mesh, level.trial));
  out_.loop.rounds.push_back(round_of(level.trial));
  out_.loop.rounds.back().adapted = adapted;
  out_.loop.rounds.back().curves = curves_of(level.mesh);
  return true;
}

// Does a tie continue a contact, as at a crack tip? Linear functions have a fixed relative error there on every mesh.
bool meets_tie(const sketch::Sketch& s) {
  const auto bodies = [](const sketch::Interface& i) { return std::minmax(i.side[0].body, i.side[1].body); };
  return std::any_of(s.interfaces.begin(), s.interfaces.end(), [&](const sketch::Interface& a) {
    return std::any_of(s.interfaces.begin(), s.interfaces.end(),
                       [&](const sketch::Interface& b) { return a.tied && !b.tied && bodies(a) == bodies(b); });
  });
}

// Can a body bend? Linear functions represent bending poorly.
bool has_slender_body(const sketch::Sketch& s) {
  return std::any_of(s.bodies.begin(), s.bodies.end(), [&](const sketch::Body& body) {
    const sketch::Region region(s, body);
    return !body.rigid && region.boundary() * region.boundary() > 4 * kSlender * region.area();
  });
}

// Can friction dissipate energy in slip zones narrower than the elements?
bool may_rub(const sketch::Sketch& s) {
  return std::any_of(s.interfaces.begin(), s.interfaces.end(),
                     [](const sketch::Interface& i) { return !i.tied && i.friction > 0 && std::isfinite(i.friction); });
}

void Loop::state_errors(const Level& coarse, const Level& fine, const Distance& between) {
  std::vector<app::Stated>& stated = out_.loop.stated;
  const Round* before = before_.stated.empty() ? nullptr : &before_;
  stated = state_numbers(coarse.trial, fine.trial, between, before);
  for (app::Stated& s : stated) s.tolerance = tolerance_of(s_, s, fine.trial);
  for (const app::Stated& s :
       state_wanted(wanted_of(s_, coarse.mesh, coarse.trial), wanted_of(s_, fine.mesh, fine.trial), between, before))
    stated.push_back(s);
  if (coarse.twisted != nullptr && fine.twisted != nullptr)
    for (const app::Stated& s : state_wanted(coarse.twisted->numbers, fine.twisted->numbers, between, before))
      stated.push_back(s);
  // While contact is neither found nor excluded somewhere, no number has an error.
  const std::vector<OpenContact> open =
      open_contacts(s_, {coarse.mesh, coarse.trial}, {fine.mesh, fine.trial}, kOfMotion * stage_);
  if (std::any_of(open.begin(), open.end(), [](const OpenContact& c) { return c.doubts(); }))
    for (app::Stated& s : stated) s.error = NAN;
  for (app::Stated& s : stated) // nor has one of an empty contact while the bodies are not resolved
    if (between.energy > kUnfollowed && s.zone > 0 && s.value == 0) s.error = NAN;
  for (app::Stated& s : stated) // slip zones at the edges may be narrower than an element
    if (s.what == app::Measure::kDissipated && s.error == 0 && may_rub(s_)) s.error = NAN;
  drop_unknown(stated);
  confirm(stated, fine.trial, before);
  out_.loop.rounds.back().stated = stated;
  before_ = {stated, between.pressure, {}, 0};
  if (!fine.trial.states.empty()) before_.loads = fine.trial.states.back().loads, before_.work = fine.trial.states.back().work;
}

// Is the error below the tolerance of the current stage?
bool Loop::is_near_enough(const app::Stated& s) const {
  return std::isnan(s.tolerance) || s.error <= stage_ / least_ * s.tolerance * s.scale;
}

// Advances to the first stage that some number does not meet.
void Loop::end_stages() {
  const auto ends = [&] {
    return std::all_of(out_.loop.stated.begin(), out_.loop.stated.end(),
                       [&](const app::Stated& s) { return s.endless || is_near_enough(s); });
  };
  while (stage_ > least_ && ends()) stage_ *= kNextStage, strictness_ = 1;
}

// Finds numbers at one place whose errors no longer fall under refinement: at a sharp corner the value may be unbounded.
// Numbers at points inside bodies are bounded.
void Loop::watch() {
  std::map<std::tuple<app::Measure, int32_t, int32_t, int32_t>, int> seen;
  for (app::Stated& s : out_.loop.stated) {
    const int which = seen[{s.what, s.zone, s.item, s.body}]++;
    if (s.endless || is_near_enough(s) || !is_place(s) || is_inside(s)) continue;
    Watched& w = watched_[{s.what, s.zone, s.item, s.body, which}];
    w.stays = s.error > kSettles * w.error ? w.stays + 1 : 0;
    w.error = s.error;
    s.endless = w.stays >= kPatience;
  }
}

bool Loop::all_met() const {
  return std::all_of(out_.loop.stated.begin(), out_.loop.stated.end(),
                     [](const app::Stated& s) { return s.is_met() || s.endless; });
}

bool Loop::all_within() const {
  return std::all_of(out_.loop.stated.begin(), out_.loop.stated.end(),
                     [](const app::Stated& s) { return s.is_within() || s.endless; });
}

sketch::Mesh without_far(sketch::Mesh mesh) {
  for (auto& outlines : mesh.bodies)
    for (sketch::MeshedOutline& outline : outlines)
      for (sketch::MeshedCurve& curve : outline.curves) curve.far.clear();
  return mesh;
}

// A body supported by too few pairs may slide or tip off: with more pairs the same history may continue.
sketch::Mesh Loop::with_finer_contacts(const sketch::Mesh& mesh) const {
  sketch::Levels levels;
  for (const auto& outlines : mesh.bodies) {
    levels.push_back({});
    for (const sketch::MeshedOutline& outline : outlines)
      for (const sketch::MeshedCurve& curve : outline.curves)
        levels.back().insert(levels.back().end(), curve.elements(), sketch::Bisection{curve.curve->contact >= 0 ? 1 : 0, 0});
  }
  return sketch::refined(s_, without_far(mesh), levels, {});
}

// The factor on the target of the energy while the bodies, not the contacts, keep the tractions from converging: these follow
// the energy about in proportion.
double Loop::step_of_rest(const Distance& d, double pressure) const {
  if (pressure < aim()) return kRestOnce;
  return std::min(1.0, d.energy / energy_aim()) * std::clamp(aim() / pressure, kLeastRest, kMostRest);
}

// The next mesh: leave out far elements, bisect those with large shares, move element ends to edges and stick borders.
sketch::Mesh Loop::next_mesh(const Level& coarse, const Level& fine, const Distance& distance, bool near) {
  sketch::Mesh mesh = coarse.mesh;
  if (regrown_ < kMostRegrown) mark_far(s_, coarse.trial, mesh);
  double worst = 0, own = 0;
  for (size_t z = 0; z < distance.pressure.size(); ++z)
    if (distance.pressure[z] > worst) worst = distance.pressure[z], own = distance.own[z];
  if (worst > kStalls * worst_ && own < kOwn * worst) rest_ *= step_of_rest(distance, worst);
  worst_ = worst;
  sketch::Levels levels = marks(mesh, distance, aim(), energy_aim());
  mark_missed(s_, {coarse.mesh, coarse.trial}, {fine.mesh, fine.trial}, kOfMotion * stage_, mesh, levels);
  std::vector<app::Stated> stated = out_.loop.stated;
  for (app::Stated& s : stated) s.tolerance *= stage_ / least_;
  if (near) mark_places(s_, fine.trial, stated, mesh, levels);
  if (coarse.twisted != nullptr && fine.twisted != nullptr && std::any_of(stated.begin(), stated.end(), is_torsion_missed))
    mark_torsion(s_, *coarse.twisted, *fine.twisted, mesh, levels);
  return sketch::refined(s_, mesh, levels, edges_of(fine.trial));
}

// Target of the distance of the tractions.
double Loop::aim() const { return strictness_ * stage_; }

// Target of the energy difference, on which numbers outside the contact depend.
double Loop::energy_aim() const { return kOfEnergy * rest_ / strictness_ * aim(); }

bool Loop::is_near(const Distance& d) const {
  return std::all_of(d.pressure.begin(), d.pressure.end(), [&](double p) { return p < aim(); });
}

// Lowers the targets by the ratio of tolerance to error of the worst number, that of the energy from what it is: numbers inside
// may need much less than `energy_aim`. Numbers at one place have marks of their own. First errors are doubled, and may still
// be those of the bodies.
void Loop::tighten(const Distance& d, bool first) {
  double contact = 1, rest = 1;
  bool inside = false; // is a number inside a body, or one that the bodies determine, inaccurate?
  for (const app::Stated& s : out_.loop.stated) {
    if (s.endless || std::isnan(s.tolerance)) continue;
    const bool within = is_near_enough(s);
    if (within && (s.confirmed || stage_ > least_)) continue; // a met number still needs confirmation on a finer mesh
    const bool of_bodies = !is_place(s) && s.error > kOfBodies * s.hidden; // far above what the tractions may hide
    inside = inside || ((is_inside(s) || of_bodies) && !within);
    double& worst = app::row_of(s.what).by_tractions && !of_bodies && !std::isnan(s.error) ? contact : rest;
    const double part = stage_ / least_ * s.tolerance * s.scale / s.error;
    worst = std::min(worst, within || is_place(s) ? kOfPlaces : std::isnan(part) ? kOfUndecided : part);
  }
  if (contact < 1) strictness_ *= std::clamp(contact, first ? kFirstStep : kLeastStep, kOfPlaces);
  if (d.energy < energy_aim() && rest < 1) rest_ *= (inside ? d.energy / energy_aim() : 1) * std::clamp(rest, 0.05, 0.6);
}

void Loop::tell_endless() {
  bool known = false, seen = false; // to be unbounded; to be so as the mesh was refined
  for (const app::Stated& s : out_.loop.stated)
    if (!s.is_met()) (s.is_unbounded() ? known : seen) = true;
  if (known) out_.loop.stopped = "it is unbounded where contact ends at a corner or with its zone";
  if (seen) out_.loop.stopped = "it does not converge when the mesh there is refined: it may be unbounded";
}

void Loop::take(const Level& level) {
  out_.mesh = level.mesh;
  if (!s_.tolerances.empty()) out_.trial = level.trial;
  out_.deck = is_cut_off(level.trial, level.mesh) ? level.deck : app::without_cut_ends(level.deck);
  out_.loop.taken = out_.loop.rounds.size() - 1;
  if (level.twisted != nullptr) out_.loop.torsion = level.twisted->table;
  out_.loop.fatigue = fatigue_lines(s_, level.mesh, level.trial);
  has_tapes_ = true;
  history_ = level.trial.why;
  if (level.trial.outcome != C2D_REACHED) history_ = "the history ended early: " + history_;
  is_whole_ = level.trial.outcome == C2D_REACHED;
}

bool is_same(const sketch::Mesh& a, const sketch::Mesh& b) {
  for (size_t body = 0; body < a.bodies.size(); ++body)
    for (size_t o = 0; o < a.bodies[body].size(); ++o)
      for (size_t c = 0; c < a.bodies[body][o].curves.size(); ++c) {
        const sketch::MeshedCurve &p = a.bodies[body][o].curves[c], &q = b.bodies[body][o].curves[c];
        if (p.ends != q.ends || p.far != q.far) return false;
      }
  return true;
}

// Have the loads done work up to the last state?
bool is_loaded(const Trial& trial) { return !trial.states.empty() && trial.states.back().work != 0; }

// Replaces linear functions by quadratic ones unless the sketch prescribes the order.
bool Loop::takes_quadratic() {
  if (!s_.chooses_order || s_.order > 1) return false;
  out_.sketch.order = 2;
  tries_order_ = true;
  return true;
}

// Linear functions represent the deformation of bodies worse than tractions: one that bends, an arm beside a slit. Is a number
// that depends on it much less accurate than is wanted, although the tractions are nearly accurate enough?
bool Loop::lags_behind(const Distance& d) const {
  double worst = 0; // distance of the tractions over its target
  for (const double p : d.pressure) worst = std::max(worst, p / aim());
  return worst < kLags && std::any_of(out_.loop.stated.begin(), out_.loop.stated.end(), [&](const app::Stated& s) {
           return (is_inside(s) || !is_place(s)) && !std::isnan(s.tolerance) &&
                  s.error > kLags * std::max(1.0, worst) * stage_ / least_ * s.tolerance * s.scale;
         });
}

// Returns to linear functions where quadratic ones cannot be solved (ill-conditioned floating slender bodies).
bool Loop::stays_linear() {
  if (!tries_order_ || app::interrupted()) return false;
  tries_order_ = false;
  out_.sketch.order = 1;
  out_.sketch.chooses_order = false;
  out_.loop.stopped.clear();
  return true;
}

// Contact has reached elements that were left out, or these divide a zone: leave out none.
void Loop::regrow(Level& coarse) {
  coarse.mesh = without_far(coarse.mesh);
  ++regrown_;
}

// Solves and compares a mesh and the mesh with every element bisected. Next::again: repeat with the changed coarse mesh.
Loop::Next Loop::solve_pair(Level& coarse, Level& fine, Distance& between) {
  if (!is_within_limits(coarse.mesh)) return Next::end;
  if (!solve_level(coarse, true)) return stays_linear() ? Next::again : Next::end;
  report_(out_.loop.rounds.back());
  if (out_.loop.rounds.size() == 1) take(coarse); // the result if no later mesh can be made or solved
  if (is_cut_off(coarse.trial, coarse.mesh)) return regrow(coarse), Next::again;
  if (!begun_ && regrown_ == 0) mark_far(s_, coarse.trial, coarse.mesh);
  fine = {sketch::halved(s_, coarse.mesh), {}, {}};
  if (!is_within_limits(fine.mesh)) return Next::end;
  if (!solve_level(fine, false)) return stays_linear() ? Next::again : Next::end;
  if (fine.trial.zones.size() != coarse.trial.zones.size()) return regrow(coarse), Next::again;
  between = distance_of(coarse, fine);
  tell_distance(between, fine.trial, out_.loop.rounds.back());
  report_(out_.loop.rounds.back());
  state_errors(coarse, fine, between);
  take(fine);
  tries_order_ = false;
  return Next::refine;
}

// Are meshes of this kind suitable? Next::again: repeat with another kind.
Loop::Next Loop::check_kind(Level& coarse, const Level& fine, const Distance& between) {
  if (is_cut_off(fine.trial, fine.mesh)) return regrow(coarse), Next::again;
  const bool bends = between.energy > kBends || (between.energy > kSlenderBends && has_slender_body(s_));
  if (!begun_ && (bends || meets_tie(s_)) && takes_quadratic()) return before_ = Round(), Next::again;
  if (history_.empty()) return Next::refine;
  if (early_++ < kEarlyRounds) return coarse.mesh = with_finer_contacts(coarse.mesh), Next::again;
  return is_loaded(fine.trial) ? Next::refine : Next::end; // more contact elements did not help an unloaded start either
}

// The mesh of the next round, unless every number is met or no finer mesh can be made.
Loop::Next Loop::refine(Level& coarse, const Level& fine, const Distance& between) {
  const bool near = is_near(between);
  if (near) watch();
  if (all_met() && between.energy < kUnfollowed) return tell_endless(), Next::end;
  if (begun_ && lags_behind(between) && takes_quadratic()) return watched_.clear(), Next::again;
  const double before = stage_;
  end_stages();
  const bool first = !begun_;
  begun_ = true;
  if (stage_ < before && takes_quadratic())
    return Next::again;                          // fewer unknowns for the same accuracy; first on the same elements
  if (is_near(between)) tighten(between, first); // for the next stage
  sketch::Mesh next = next_mesh(coarse, fine, between, near);
  if (is_same(next, coarse.mesh) && all_within()) next = fine.mesh; // confirm the errors on the finer mesh
  idle_ = sketch::elements_of(next) > sketch::elements_of(coarse.mesh) ? 0 : idle_ + 1;
  if (is_same(next, coarse.mesh))
    out_.loop.stopped = "the mesh there is as fine as the digits of coordinates allow";
  else if (idle_ > kPatience)
    out_.loop.stopped = "no element is left to refine";
  else
    return coarse.mesh = std::move(next), Next::again;
  return Next::end;
}

// The rounds of refinement, from the first mesh to the end.
void Loop::search() {
  Level coarse, fine;
  coarse.mesh = sketch::first_mesh(s_, kFirst);
  for (Next next = Next::again; next != Next::end;) {
    Distance between;
    next = solve_pair(coarse, fine, between);
    if (next == Next::refine) next = check_kind(coarse, fine, between);
    if (next == Next::refine) next = refine(coarse, fine, between);
  }
}

Adapted Loop::run() {
  std::string& stopped = out_.loop.stopped;
  try {
    search();
  } catch (const sketch::Fault& fault) { // fault of a later mesh: keep the results of the last one
    if (out_.deck.empty()) throw;
    stopped = fault.text;
  }
  if (demand_.store != nullptr && !has_tapes_) demand_.store->drop_tapes(); // they belong to another mesh
  if (!history_.empty()) stopped = history_ + (stopped.empty() ? "" : "; " + stopped);
  return std::move(out_);
}

} // namespace

Adapted adapt(const sketch::Sketch& sketch, const Demand& demand, const std::function<void(const app::MeshRound&)>& report,
              TrialKeeper* keeper) {
  return Loop(sketch, demand, report, keeper).run();
}

app::MeshLoop estimate_deck(c2d_solver* solver, const std::string& deck, const Demand& demand) {
  app::MeshLoop out;
  const std::string decks[2] = {deck, halved_deck(solver, deck, out.stopped)};
  Trial trials[2];
  for (size_t k = 0; k < 2 && out.stopped.empty(); ++k)
    if (solve(decks[k], demand, trials[k], out.stopped) == C2D_OK) out.rounds.push_back(round_of(trials[k]));
  if (!out.stopped.empty() || trials[0].states.empty() || trials[1].states.empty()) return out;
  const Distance between = distance(trials[0], trials[1], overlaps_of_halves(trials[0]));
  tell_distance(between, trials[1], out.rounds.back());
  out.stated = state_of_coarse(trials[0], trials[1], between);
  return out;
}

} // namespace estimate
