// Check of the work of friction over load cycles (METHOD 15).
//
// First law between two states a and b of the path: W_ab = (E_b - E_a) + D_ab, with external work W, elastic energy E and
// dissipation D = int |q| |dw_t| ds. Collocation satisfies it only up to the discretisation error, METHOD (15.5).
// The check compares W_ab - (E_b - E_a) with D_ab between reversals of the load, where the elastic part nearly cancels, over
// one segment and over two (a closed cycle). During first loading E dominates and its error hides that of D: such segments are
// skipped. A difference above 10 % matters because every further cycle adds it again.
#include "results/friction_work.hpp"

#include "memory/math.hpp"

namespace c2d {

namespace {

struct Between { // changes from one state to another
  double work, elastic, dissipated;
  double left() const { return work - elastic; } // the dissipation that the energy balance requires
};

Between between(const double* from, const double* to) { return Between{to[0] - from[0], to[1] - from[1], to[2] - from[2]}; }

bool is_off(const Session& session, const Between& b) {
  constexpr double kMuch = 0.1, kRoundOff = 1e-9; // relative difference to report; of the energies on the path: round-off
  if (b.dissipated < kRoundOff * session.solver->energy_size || b.dissipated < kMuch * fabs(b.elastic)) return false;
  return fabs(b.left() - b.dissipated) > kMuch * b.dissipated;
}

} // namespace

bool tell_friction_work(const Session& session, bool at_end, Text& out) {
  const c2d_solver* s = session.solver;
  // turn[0] is the last reversal, turn[1] and turn[2] those before. Two segments first: a closed cycle is the stricter test.
  const double now[3] = {s->work, s->elastic, s->dissipated};
  const Between all[] = {between(s->turn[2], s->turn[0]), between(s->turn[1], s->turn[0]), between(s->turn[1], now),
                         between(s->turn[0], now)};
  const bool known[] = {s->turns > 2, s->turns > 1, at_end && s->turns > 1, at_end && s->turns > 0};
  for (int i = 0; i < 4; ++i) {
    if (!known[i] || !is_off(session, all[i])) continue;
    put_all(out, "energy: friction dissipated ");
    put(out, all[i].dissipated, 3);
    put_all(out, i == 0 || i == 2 ? " over the last two load segments" : " over the last load segment",
            " between reversals, but work minus the change of elastic energy is ");
    put(out, all[i].left(), 3);
    put_all(out, ", ");
    put(out, 100.0 * fabs(all[i].left() / all[i].dissipated - 1.0), 2);
    put_all(out, " % apart, which accumulates over cycles: refine at edges and corners of the contact where pairs slip");
    return true;
  }
  return false;
}

} // namespace c2d
