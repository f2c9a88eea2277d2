#include "post/cycles.hpp"

namespace app {

c2d_status find_cycle_seen(c2d_solver* solver, int32_t zones, CycleSeen& out) {
  c2d_cycle_state now = C2D_INIT(c2d_cycle_state);
  c2d_status status = c2d_get_cycle_state(solver, &now);
  if (status != C2D_OK) return status;
  out.result = now.result;
  out.cycles = now.cycles, out.extrapolations = now.extrapolations;
  out.stuck = now.stuck, out.slipped = now.slipped;
  out.range_pair = now.range_pair, out.walk_pair = now.walk_pair;
  out.change = now.change, out.dissipated = now.dissipated, out.slip_range = now.slip_range, out.walk = now.walk;
  for (int32_t z = 1; z <= zones && status == C2D_OK; ++z) {
    c2d_cycle_zone zone = C2D_INIT(c2d_cycle_zone);
    status = c2d_get_cycle_zone(solver, z, &zone);
    out.zones.push_back({zone.touched, zone.stuck, zone.slipped, zone.walk, zone.slip_range});
  }
  return status;
}

c2d_status find_followed(c2d_solver* solver, const std::vector<ZoneLine>& lines, int32_t pairs,
                         std::vector<FollowedZone>& out) {
  std::vector<double> range(static_cast<size_t>(pairs)), touched(range.size());
  c2d_status status = c2d_get_cycle(solver, C2D_CYCLE_RANGE, 1, pairs, range.data(), 1);
  if (status == C2D_OK) status = c2d_get_cycle(solver, C2D_CYCLE_TOUCHED, 1, pairs, touched.data(), 1);
  out.assign(lines.size(), FollowedZone());
  for (size_t z = 0; z < lines.size(); ++z) {
    double most = 0.0;
    for (const int32_t p : lines[z].pair) {
      const size_t at = static_cast<size_t>(p);
      if (range[at] > most) most = range[at], out[z].pair = p;
      if (touched[at] > 0.0) out[z].touched.push_back(p);
    }
  }
  return status;
}

c2d_status find_cycle_results(c2d_solver* solver, int32_t zones, int32_t pairs, CycleResults& out) {
  CycleSeen seen;
  c2d_status status = find_cycle_seen(solver, zones, seen);
  if (status != C2D_OK) return status;
  out.zones = seen.zones, out.dissipated = seen.dissipated, out.result = seen.result;
  out.stuck.resize(static_cast<size_t>(pairs));
  return c2d_get_cycle(solver, C2D_CYCLE_STUCK, 1, pairs, out.stuck.data(), 1);
}

RepeatedPaths repeated_paths(c2d_solver* solver) {
  RepeatedPaths out;
  c2d_get_repeated(solver, &out.first, &out.pieces, &out.limit, &out.digits, &out.start);
  return out;
}

int32_t cycles_followed(c2d_solver* solver) {
  c2d_cycle_state now = C2D_INIT(c2d_cycle_state);
  return repeated_paths(solver).first > 0 && c2d_get_cycle_state(solver, &now) == C2D_OK ? now.cycles : 0;
}

} // namespace app
