#include "report/listing/listing.hpp"

#include "report/listing/listing_items.hpp"
#include "report/text.hpp"

namespace app {
namespace {

const char* analysis_text(int32_t analysis) {
  switch (analysis) {
  case C2D_ANALYSIS_CHECK: return "data check";
  case C2D_ANALYSIS_STRESS: return "stress analysis";
  case C2D_ANALYSIS_CONTACT: return "contact zone";
  case C2D_ANALYSIS_FULL: return "contact zone and back substitution";
  default: return "contact zone, back substitution, every change of status";
  }
}

void append_control(std::string& out, const Summary& s) {
  append_section(out, "Control data");
  append_item(out, "analysis", analysis_text(s.analysis));
  append_item(out, "plane",
              s.plane == C2D_AXISYMMETRIC
                  ? "half section of bodies of revolution about x = 0; forces of the whole circumference"
              : s.plane == C2D_PLANE_STRESS ? "stress"
                                            : "strain");
  append_item(out, "stepping", s.stepping == C2D_STEPPING_DECK ? "deck increments" : "events");
  append_item(out, "quadrature", s.quadrature == C2D_QUADRATURE_THESIS ? "2, 4 and 10 points" : "accurate");
  append_item(out, "symmetry by images", symmetry_text(s).c_str());
  append_item(out, "bodies", static_cast<int64_t>(s.bodies));
  append_item(out, "load cases", static_cast<int64_t>(s.load_cases));
  append_item(out, "contact zones", static_cast<int64_t>(s.zones));
  append_item(out, "pairs of nodes", static_cast<int64_t>(s.pairs));
  append_item(out, "functional nodes per element", static_cast<int64_t>(s.function_nodes));
  append_item(out, "iterations per increment at most", static_cast<int64_t>(s.iteration_limit));
}

void append_body(std::string& out, const Summary& s, int32_t body) {
  const size_t b = static_cast<size_t>(body) - 1;
  append_body_section(out, s, body);
  append_item(out, "elements", static_cast<int64_t>(s.body[b].elements));
  append_item(out, "geometry nodes per element", static_cast<int64_t>(s.body[b].element_nodes));
  append_item(out, "boundary points", static_cast<int64_t>(s.body[b].points));
  append_item(out, "functional nodes", static_cast<int64_t>(s.body[b].nodes));
  append_item(out, "curves", static_cast<int64_t>(s.body[b].regions));
  append_item(out, "equations", static_cast<int64_t>(s.body[b].unknowns));
  append_item(out, "Young's modulus", s.body[b].youngs_modulus);
  append_item(out, "Poisson's ratio", s.body[b].poisson_ratio);
}

c2d_status append_regions(std::string& out, c2d_solver* solver, const Summary& s, int32_t body) {
  out += "\n   curve   first element   last element\n";
  for (int32_t i = 1; i <= s.body[body - 1].regions; ++i) {
    int32_t first = 0, last = 0;
    if (const c2d_status status = c2d_get_region(solver, body, i, &first, &last); status != C2D_OK) return status;
    append_column(out, i, 8);
    append_column(out, first, 16);
    append_column(out, last, 15);
    out += '\n';
  }
  return C2D_OK;
}

c2d_status append_coordinates(std::string& out, c2d_solver* solver, const Summary& s, int32_t body) {
  const size_t n = static_cast<size_t>(s.body[body - 1].points);
  std::vector<double> x(n), y(n);
  const int32_t count = static_cast<int32_t>(n);
  c2d_status status = c2d_get(solver, C2D_NODE_X, body, 1, count, x.data(), 1);
  if (status == C2D_OK) status = c2d_get(solver, C2D_NODE_Y, body, 1, count, y.data(), 1);
  if (status != C2D_OK) return status;
  out += "\n    node              x              y\n";
  for (size_t i = 0; i < n; ++i) {
    append_column(out, static_cast<int64_t>(i) + 1, 8);
    append_general(out, x[i], 15, 8);
    append_general(out, y[i], 15, 8);
    out += '\n';
  }
  return C2D_OK;
}

} // namespace

c2d_status append_model(std::string& out, c2d_solver* solver, const Summary& s, const std::vector<std::string>& heading) {
  append_rule(out);
  out += "contact2d ";
  out += c2d_version();
  out += '\n';
  out += s.title;
  out += '\n';
  append_rule(out);
  for (const std::string& card : heading) {
    out += "  ";
    out += card;
    out += '\n';
  }
  append_control(out, s);
  c2d_status status = C2D_OK;
  for (int32_t body = 1; body <= s.bodies && status == C2D_OK; ++body) {
    if (s.is_platen(body)) {
      append_body_section(out, s, body);
      append_item(out, "a platen that moves", s.moved_by(body).c_str());
      continue;
    }
    append_body(out, s, body);
    status = append_regions(out, solver, s, body);
    if (status == C2D_OK) status = append_coordinates(out, solver, s, body);
    if (status == C2D_OK) status = append_conditions(out, solver, s, body);
  }
  if (status == C2D_OK) status = append_other_loads(out, solver, s);
  if (status == C2D_OK) status = append_zones(out, solver, s);
  if (status == C2D_OK) status = append_path(out, solver, s);
  return status;
}

} // namespace app
