#include "post/summary.hpp"

#include <cmath>

namespace app {

bool Summary::names_bodies() const {
  for (const std::vector<std::string>* names : {&body_name, &zone_name})
    for (const std::string& name : *names)
      if (!name.empty()) return true;
  for (const c2d_zone& z : zone)
    if (z.side1.body != 1 || z.side2.body != 2) return true;
  return bodies > 2;
}

std::string Summary::moved_by(int32_t platen) const {
  for (const c2d_zone& z : zone)
    if (z.side1.body == platen)
      return "elements " + std::to_string(z.side2.first_element) + " to " + std::to_string(z.side2.last_element) + " of body " +
             std::to_string(z.side2.body);
  return "";
}

namespace {

std::vector<std::string> get_names(c2d_solver* solver, int32_t kind, size_t count) {
  std::vector<std::string> out(count);
  char name[32] = "";
  for (size_t i = 0; i < count && c2d_get_name(solver, kind, static_cast<int32_t>(i) + 1, name) == C2D_OK; ++i) out[i] = name;
  return out;
}

// The line, 1 or 2, on which a boundary point at the end of an open region lies; of a body of revolution the axis is none.
c2d_status get_line_at(c2d_solver* solver, const Summary& s, int32_t body, int32_t point, int32_t& lines) {
  double at[2] = {0, 0};
  for (const int axis : {0, 1}) {
    const c2d_status status = c2d_get(solver, axis == 0 ? C2D_NODE_X : C2D_NODE_Y, body, point, 1, &at[axis], 1);
    if (status != C2D_OK) return status;
    at[axis] = (s.symmetry >> axis & 1) != 0 ? std::fabs(at[axis] - s.symmetry_at[axis]) : HUGE_VAL;
  }
  const int line = at[0] <= at[1] ? 1 : 2;
  if (s.plane != C2D_AXISYMMETRIC || line != 1) lines |= line;
  return C2D_OK;
}

// The lines at which the open regions of a body end.
c2d_status get_cut(c2d_solver* solver, const Summary& s, int32_t body, int32_t& lines) {
  const c2d_body_result& b = s.body[body - 1];
  const int32_t order = b.element_nodes - 1;
  lines = 0;
  for (int32_t r = 1; s.symmetry != 0 && r <= b.open_regions; ++r) {
    int32_t first = 0, last = 0;
    c2d_status status = c2d_get_region(solver, body, r, &first, &last);
    // Every open region has one boundary point more than its elements need.
    for (const int32_t point : {(first - 1) * order + r, last * order + r})
      if (status == C2D_OK) status = get_line_at(solver, s, body, point, lines);
    if (status != C2D_OK) return status;
  }
  return C2D_OK;
}

} // namespace

c2d_status get_summary(c2d_solver* solver, Summary& out) {
  c2d_status status = c2d_get_summary(solver, &out);
  if (status != C2D_OK) return status;
  out.body.list().assign(static_cast<size_t>(out.bodies), C2D_INIT(c2d_body_result));
  for (int32_t b = 1; b <= out.bodies && status == C2D_OK; ++b)
    status = c2d_get_body_result(solver, b, &out.body.list()[static_cast<size_t>(b) - 1]);
  const bool complete = out.state >= C2D_STATE_MODEL && out.state <= C2D_STATE_RUNNING;
  out.zone.assign(complete ? static_cast<size_t>(out.zones) : 0, C2D_INIT(c2d_zone));
  for (size_t z = 0; z < out.zone.size() && status == C2D_OK; ++z)
    status = c2d_get_zone(solver, static_cast<int32_t>(z) + 1, &out.zone[z]);
  out.cut.assign(static_cast<size_t>(out.bodies), 0);
  for (int32_t b = 1; complete && b <= out.bodies && status == C2D_OK; ++b)
    status = get_cut(solver, out, b, out.cut[static_cast<size_t>(b) - 1]);
  out.body_name = get_names(solver, C2D_NAME_BODY, complete ? static_cast<size_t>(out.bodies) : 0);
  out.zone_name = get_names(solver, C2D_NAME_ZONE, out.zone.size());
  return status;
}

c2d_status get_pairs(c2d_solver* solver, const Summary& summary, std::initializer_list<PairField> fields) {
  c2d_status status = C2D_OK;
  for (const PairField& f : fields) {
    f.values.resize(static_cast<size_t>(summary.pairs));
    if (status == C2D_OK && summary.pairs > 0) status = c2d_get(solver, f.field, 1, 1, summary.pairs, f.values.data(), 1);
  }
  return status;
}

c2d_status get_ends(c2d_solver* solver, const Summary& summary, int32_t body, const int32_t* fields, int32_t count,
                    std::vector<std::vector<double>>& out) {
  const int32_t ends = summary.body[body - 1].elements * summary.function_nodes;
  out.assign(static_cast<size_t>(count), std::vector<double>(static_cast<size_t>(ends), 0.0));
  for (int32_t f = 0; f < count; ++f) {
    const c2d_status status = c2d_get(solver, fields[f], body, 1, ends, out[static_cast<size_t>(f)].data(), 1);
    if (status != C2D_OK) return status;
  }
  return C2D_OK;
}

} // namespace app
