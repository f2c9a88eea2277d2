#include "estimate_truth.hpp"

#include "program/estimate/mesh/functions.hpp"
#include "program/estimate/wanted.hpp"
#include "program/sketch/read/read.hpp"
#include "program/sketch/refine.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace truth {
namespace {

using Pair = std::array<double, 2>;

// Points of Gauss's rule with five on -1 ... 1.
constexpr double kPoint[5] = {-0.906179845938664, -0.538469310105683, 0, 0.538469310105683, 0.906179845938664};
constexpr double kWeight[5] = {0.236926885056189, 0.478628670499366, 0.568888888888889, 0.478628670499366, 0.236926885056189};

double position(const sketch::MeshedCurve& curve, double s) { return curve.curve->shape->at(curve.measure.u_at(s)).x; }

// Tractions of the mesh and in closed form along the top of body 1: integral of their difference over that of the latter.
// Each element is cut into pieces, shorter towards the edges of contact, where tractions have roots.
double off_tractions(const Problem& problem, const sketch::Mesh& mesh, const estimate::Trial& trial) {
  double sum = 0, all = 0;
  size_t element = 0;
  const auto& ends = trial.states.back().ends[0];
  const auto nodes = static_cast<size_t>(trial.nodes);
  for (const sketch::MeshedOutline& outline : mesh.bodies[0])
    for (const sketch::MeshedCurve& curve : outline.curves)
      for (size_t e = 0; e < curve.elements(); ++e, ++element) {
        if (curve.curve->name != "top") continue;
        const double x0 = position(curve, curve.ends[e]), x1 = position(curve, curve.ends[e + 1]);
        if (std::min(std::fabs(x0), std::fabs(x1)) > 1.5 * problem.half_width) continue;
        constexpr int kPieces = 20;
        for (int piece = 0; piece < kPieces; ++piece)
          for (int g = 0; g < 5; ++g) {
            const double f = (piece + (1 + kPoint[g]) / 2) / kPieces, w = std::fabs(x1 - x0) * kWeight[g] / 2 / kPieces;
            const Pair exact = problem.tractions(x0 + f * (x1 - x0));
            const estimate::Functions functions(trial.nodes, -1 + 2 * f);
            const auto at = [&](estimate::Field field) {
              const double* value = &ends[field][nodes * element];
              return std::inner_product(value, value + nodes, functions.value, 0.0);
            };
            sum += w * std::hypot(at(estimate::kTx) - exact[0], at(estimate::kTy) - exact[1]);
            all += w * std::hypot(exact[0], exact[1]);
          }
      }
  return sum / all;
}

double distance_to(const std::vector<Pair>& places, const double* at) {
  double least = HUGE_VAL;
  for (const Pair& p : places) least = std::min(least, std::hypot(at[0] - p[0], at[1] - p[1]));
  return least;
}

bool is_place(const app::Stated& s) { return s.what == app::Measure::kContactEdge || s.what == app::Measure::kStickBorder; }

// The numbers of the same model on a mesh with elements half as long.
std::vector<app::Stated> numbers_of(const sketch::Sketch& sketch, const sketch::Mesh& mesh, const estimate::Demand& demand) {
  const sketch::Mesh fine = sketch::halved(sketch, mesh);
  estimate::Trial trial;
  std::string why;
  if (estimate::solve(sketch::deck_of(sketch, fine), demand, trial, why) != C2D_OK) return {};
  estimate::Distance none;
  none.pressure.assign(trial.zones.size(), 0.0);
  std::vector<app::Stated> out = estimate::state_numbers(trial, trial, none, nullptr);
  for (const app::Stated& s : estimate::wanted_of(sketch, fine, trial)) out.push_back(s);
  return out;
}

double error_by(const std::vector<app::Stated>& reference, const app::Stated& s) {
  for (const app::Stated& r : reference)
    if (r.what == s.what && r.of == s.of && r.zone == s.zone && r.body == s.body && r.item == s.item && s.has_value())
      return is_place(s) ? std::hypot(r.at[0] - s.at[0], r.at[1] - s.at[1]) : std::fabs(r.value - s.value);
  return NAN;
}

} // namespace

Judged judge(const Problem& problem, double tolerance, bool by_mesh) {
  Judged out;
  const sketch::Reading drawn = sketch::read_sketch(problem.text, {{"tolerance", tolerance}}, nullptr);
  for (const sketch::Fault& fault : drawn.faults) out.fault += fault.text + "; ";
  if (!out.fault.empty()) return out;
  estimate::Demand demand;
  estimate::ask(drawn.sketch, demand);
  const estimate::Adapted found = estimate::adapt(drawn.sketch, demand, [](const app::MeshRound&) {});
  for (const app::MeshRound& round : found.loop.rounds) out.seconds += round.seconds;
  out.meshes = found.loop.rounds.size();
  out.stopped = found.loop.stopped, out.fault = found.why;
  estimate::Trial trial;
  if (found.status != C2D_OK || estimate::solve(found.deck, demand, trial, out.fault) != C2D_OK) return out;
  out.pairs = trial.pairs, out.elements = trial.elements, out.last = trial.seconds;
  const std::vector<app::Stated> reference =
      by_mesh ? numbers_of(found.sketch, found.mesh, demand) : std::vector<app::Stated>();
  for (const app::Stated& s : found.loop.stated) {
    if (s.zone > 1) continue;
    Row row;
    row.name = s.name(), row.item = s.item, row.wanted = !std::isnan(s.tolerance);
    row.value = s.value, row.asked = row.wanted ? s.tolerance : tolerance;
    double error = NAN;
    for (const Known& k : problem.known)
      if (k.name == s.name()) // the nearest of several
        error = std::fmin(error, k.places.empty() ? std::fabs(s.value - k.value) : distance_to(k.places, s.at));
    if (!s.has_value() && problem.tractions) error = off_tractions(problem, found.mesh, trial);
    if (by_mesh) error = error_by(reference, s);
    row.error = error / s.scale, row.stated = s.error / s.scale;
    if (!std::isnan(error)) out.rows.push_back(row);
  }
  return out;
}

} // namespace truth
