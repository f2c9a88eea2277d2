// Warnings about the surfaces of contact zones, at the end of a path.
//
// For every zone the closure of each pair, initial gap minus current gap, is compared with
//   1. the smallest remaining gap: if nothing touches and the loads close less than a tenth of that gap, the zone or the
//   position
//      of the bodies is probably wrong (C2D_WARN_FAR);
//   2. the uncertainty of the surface between boundary points (METHOD 8.6) at closed pairs: if it exceeds 2 % of the largest
//      closure, the interpolated surface decides the contact (C2D_WARN_SURFACE).
#include "results/warnings/surface_warnings.hpp"

#include "contact/pairs/frames.hpp"
#include "model/validate/validate_finding.hpp"

namespace c2d {

namespace {

constexpr double kFar = 10;       // times the largest closure: a larger remaining gap is far
constexpr double kMatters = 0.02; // of the largest closure: a larger uncertainty is reported

// Closure of the gaps of a zone.
struct Closing {
  int32_t touching;          // number of pairs that touch now or initially
  int32_t nearest, doubtful; // pair with the smallest gap; closed pair with the largest uncertainty
  double least, most, doubt; // smallest gap; largest closure; largest uncertainty
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
    // A pair without initial gap counts as touching also after it has opened: its zone is where it should be.
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
      tell_zone(session, C2D_WARN_FAR, zone, c.nearest, "the surfaces stay far apart: the smallest gap is ", c.least,
                " at pair ", c.nearest + 1, ", the loads close gaps by at most ", c.most);
    if (c.touching > 0 && c.doubt > kMatters * c.most && c.most > 0.0)
      tell_zone(session, C2D_WARN_SURFACE, zone, c.doubtful, "between boundary points the surfaces are uncertain by ", c.doubt,
                " at pair ", c.doubtful + 1, ", while the loads close gaps by at most ", c.most,
                ": refine there, or define the curve");
  }
}

} // namespace c2d
