#include "results/friction_work.hpp"

#include "memory/math.hpp"

namespace c2d {

namespace {

struct Between { // two states
  double work, elastic, dissipated;
  double left() const { return work - elastic; } // for friction
};

Between between(const double* from, const double* to) { return Between{to[0] - from[0], to[1] - from[1], to[2] - from[2]}; }

bool is_off(const Session& session, const Between& b) {
  constexpr double kMuch = 0.1, kRoundOff = 1e-9;
  if (b.dissipated < kRoundOff * session.solver->energy_size || b.dissipated < kMuch * fabs(b.elastic)) return false;
  return fabs(b.left() - b.dissipated) > kMuch * b.dissipated;
}

} // namespace

bool tell_friction_work(const Session& session, bool at_end, Text& out) {
  const c2d_solver* s = session.solver;
  const double now[3] = {s->work, s->elastic, s->dissipated};
  const Between all[] = {between(s->turn[2], s->turn[0]), between(s->turn[1], s->turn[0]), between(s->turn[1], now),
                         between(s->turn[0], now)};
  const bool known[] = {s->turns > 2, s->turns > 1, at_end && s->turns > 1, at_end && s->turns > 0};
  for (int i = 0; i < 4; ++i) {
    if (!known[i] || !is_off(session, all[i])) continue;
    put_all(out, "energy: friction dissipated ");
    put(out, all[i].dissipated, 3);
    put_all(out, i == 0 || i == 2 ? " in the last two pieces of the path" : " in the last piece of the path",
            " between turns of the loads, where work less elastic energy is ");
    put(out, all[i].left(), 3);
    put_all(out, ", ");
    put(out, 100.0 * fabs(all[i].left() / all[i].dissipated - 1.0), 2);
    put_all(out, " % off, which adds up over cycles: refine at edges and corners of the contact where pairs slip");
    return true;
  }
  return false;
}

} // namespace c2d
