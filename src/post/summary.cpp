#include "post/summary.hpp"

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
