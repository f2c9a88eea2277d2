#include "results/warnings/surface_warnings.hpp"

#include "contact/frames.hpp"
#include "model/validate/validate_finding.hpp"

namespace c2d {

namespace {

constexpr double kFar = 10;       // times what the loads have closed
constexpr double kMatters = 0.02; // of what the bodies come closer

// What the loads have done to the gaps of a zone.
struct Closing {
  int32_t touching, nearest,
      doubtful;              // pairs: how many, now or from the start; with the least gap; the closed one of most doubt
  double least, most, doubt; // that gap; the most that a gap was closed by; that doubt
};

Closing closing_of(const Session& session, const Zone& z) {
  const Model& m = session.model;
  const double unit = m.head->length_unit;
  Closing c = {0, -1, -1, 0.0, 0.0, 0.0};
  for (int32_t i = z.first_pair; i < z.first_pair + z.pairs; ++i) {
    const Pair& pair = m.pair[i];
    const double gap = pair.status == C2D_OPEN ? pair_state(*session.follower.t, i, session.follower.y).wn * unit : 0.0;
    const double closed = pair.gap - gap;
    if (closed > c.most) c.most = closed;
    if (c.nearest < 0 || gap < c.least) c.nearest = i, c.least = gap;
    if (pair.status == C2D_OPEN && pair.gap > 0.0) continue;
    ++c.touching;
    if (pair.status == C2D_OPEN) continue;
    const double doubt = surface_doubt(m, i);
    if (doubt > c.doubt) c.doubtful = i, c.doubt = doubt;
  }
  return c;
}

template <class... Parts> void tell_zone(Session& session, int32_t number, int32_t zone, int32_t pair, Parts... parts) {
  Finding out(number);
  out.entry.zone = zone + 1;
  out.entry.pair = pair + 1;
  out.entry.load = session.follower.load[0];
  put_all(out.text, "zone ", zone_named(session.model, zone), ": ", parts...);
  report_fault(session.solver, out.entry);
}

} // namespace

void warn_surfaces(Session& session) {
  c2d_solver* s = session.solver;
  constexpr int32_t kOnce = 1 << (C2D_WARN_FAR - C2D_WARN_ZONE_END);
  if ((s->warned & kOnce) != 0) return;
  s->warned |= kOnce;
  for (int32_t zone = 0; zone < session.model.head->zones; ++zone) {
    if (session.model.zone[zone].is_tied != 0) continue;
    const Closing c = closing_of(session, session.model.zone[zone]);
    if (c.touching == 0 && c.least > kFar * c.most)
      tell_zone(session, C2D_WARN_FAR, zone, c.nearest, "nothing touches, and nothing is near: the least gap is ", c.least,
                " at pair ", c.nearest + 1, ", the loads close at most ", c.most);
    if (c.touching > 0 && c.doubt > kMatters * c.most && c.most > 0.0)
      tell_zone(session, C2D_WARN_SURFACE, zone, c.doubtful, "between boundary points the surfaces may be off by ", c.doubt,
                " at pair ", c.doubtful + 1, ", where the bodies come closer by ", c.most,
                " at most: refine, or tell the curve");
  }
}

} // namespace c2d
