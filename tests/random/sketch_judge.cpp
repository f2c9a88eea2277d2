#include "sketch_judge.hpp"

#include "program/estimate/loop.hpp"
#include "program/estimate/wanted.hpp"
#include "program/sketch/read/read.hpp"
#include "program/sketch/refine.hpp"

#include <chrono>
#include <cmath>

namespace random_sketches {
namespace {

constexpr double kNothing = 1e-6; // of a number's scale: an error that the other mesh does not resolve

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

std::string faults_of(const sketch::Reading& reading) {
  std::string all;
  for (const sketch::Fault& f : reading.faults) all += "line " + std::to_string(f.at.line) + ": " + f.text + "; ";
  return all;
}

// Values of one mesh, as the loop states them.
std::vector<app::Stated> values_of(const sketch::Sketch& s, const sketch::Mesh& mesh, const estimate::Trial& trial) {
  estimate::Distance none;
  none.pressure.assign(trial.zones.size(), 0);
  std::vector<app::Stated> out = estimate::state_numbers(trial, trial, none, nullptr);
  for (const app::Stated& wanted : estimate::wanted_of(s, mesh, trial)) out.push_back(wanted);
  return out;
}

double apart(const app::Stated& a, const app::Stated& b) {
  const bool place = a.what == app::Measure::kContactEdge || a.what == app::Measure::kStickBorder;
  return place && !std::isnan(a.at[0]) && !std::isnan(b.at[0]) ? std::hypot(a.at[0] - b.at[0], a.at[1] - b.at[1])
                                                               : std::fabs(a.value - b.value);
}

// The same number of another mesh: by what it is called, and where.
const app::Stated* find(const std::vector<app::Stated>& all, const app::Stated& s) {
  for (const app::Stated& t : all) {
    const bool inside = s.zone == 0 && s.of.empty() && app::row_of(s.what).place == app::PlaceKind::kRefined;
    if (t.what == s.what && t.of == s.of && t.zone == s.zone && t.body == s.body && t.item == s.item &&
        (!inside || (t.at[0] == s.at[0] && t.at[1] == s.at[1])))
      return &t;
  }
  return nullptr;
}

size_t count(const std::vector<app::Stated>& all, const app::Stated& s) {
  size_t n = 0;
  for (const app::Stated& t : all) n += t.what == s.what && t.of == s.of && t.zone == s.zone;
  return n;
}

// Numbers that one mesh has and the other has not are passed over, and so are places of which there are more on one of them:
// which of them belong together is not known.
void compare(const std::vector<app::Stated>& stated, const std::vector<app::Stated>& truth, Judged& out) {
  for (const app::Stated& s : stated) {
    const app::Stated* t = find(truth, s);
    if (t == nullptr || !std::isfinite(s.error) || !s.has_value()) continue;
    if (s.item > 0 && count(stated, s) != count(truth, s)) continue;
    out.numbers.push_back({s, t->value, apart(s, *t)});
  }
}

// Whether the history ends early on the mesh that was taken.
std::string early_end(const std::string& deck, const estimate::Demand& demand) {
  estimate::Trial trial;
  std::string why;
  if (estimate::solve(deck, demand, trial, why) != C2D_OK) return why;
  return trial.outcome == C2D_REACHED ? "" : trial.why;
}

void find_truth(sketch::Sketch s, const estimate::Demand& demand, const Limits& limits, const estimate::Adapted& adapted,
                Judged& out) {
  estimate::Trial trial;
  std::string why;
  sketch::Mesh fine = adapted.mesh;
  for (; out.halved < 2 && 2 * sketch::elements_of(fine) <= limits.of_truth; ++out.halved) fine = sketch::halved(s, fine);
  s.order = std::min(3, s.order + 1);
  const double start = now();
  const c2d_status status = estimate::solve(sketch::deck_of(s, fine), demand, trial, why);
  out.seconds_of_truth = now() - start;
  if (status != C2D_OK)
    out.no_truth = why;
  else if (trial.outcome != C2D_REACHED)
    out.no_truth = trial.why; // there only
  else
    compare(adapted.loop.stated, values_of(s, fine, trial), out);
}

} // namespace

bool Compared::is_wrong() const { return off > stated.error && off > kNothing * stated.scale; }

Judged judge(const std::string& text, const Limits& limits) {
  Judged out;
  sketch::Reading reading = sketch::read_sketch(text, {}, [](const std::string&, std::string&) { return false; });
  out.fault = faults_of(reading);
  if (!out.fault.empty()) return out;
  sketch::Sketch& s = reading.sketch;
  s.most_elements = limits.elements, s.most_seconds = limits.seconds;
  estimate::Demand demand;
  demand.drawn = true; // signs of forces are those of the statements
  estimate::ask(s, demand);
  const double start = now();
  try {
    const estimate::Adapted adapted = estimate::adapt(s, demand, [](const app::MeshRound&) {});
    out.seconds = now() - start;
    out.stopped = adapted.loop.stopped;
    out.rounds = static_cast<int>(adapted.loop.rounds.size());
    out.order = adapted.sketch.order;
    if (adapted.loop.ran()) out.energy = adapted.loop.rounds[adapted.loop.taken].energy;
    if (adapted.status != C2D_OK) {
      (adapted.status == C2D_ERR_INPUT ? out.fault : out.failure) = adapted.why;
      return out;
    }
    out.elements = sketch::elements_of(adapted.mesh);
    for (const app::Stated& n : adapted.loop.stated)
      if (!n.is_met() && out.stopped.empty()) out.silent = n.name();
    if (adapted.loop.stated.empty() && out.stopped.empty()) out.silent = "there are no numbers";
    out.ended = early_end(adapted.deck, demand);
    if (out.ended.empty()) find_truth(s, demand, limits, adapted, out);
  } catch (const sketch::Fault& fault) {
    out.fault = "line " + std::to_string(fault.at.line) + ": " + fault.text;
  }
  return out;
}

} // namespace random_sketches
