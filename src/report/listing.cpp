#include "report/listing.hpp"

#include "report/text.hpp"

#include <cmath>

namespace app {
namespace {

void append_rule(std::string& out) {
  out.append(100, '-') += '\n';
}

void append_section(std::string& out, const char* title) {
  out += '\n';
  out += title;
  out += '\n';
  append_rule(out);
}

// "  name ............ value"
std::string& append_name(std::string& out, const char* name) {
  const size_t start = out.size();
  out += "  ";
  out += name;
  out += ' ';
  const size_t used = out.size() - start;
  if (used < 44) out.append(44 - used, '.');
  return out += ' ';
}
void append_item(std::string& out, const char* name, int64_t value) {
  append_integer(append_name(out, name), value);
  out += '\n';
}
void append_item(std::string& out, const char* name, double value) {
  append_number(append_name(out, name), value);
  out += '\n';
}
void append_item(std::string& out, const char* name, const char* value) {
  append_name(out, name) += value;
  out += '\n';
}

const char* analysis_text(int32_t analysis) {
  switch (analysis) {
  case C2D_ANALYSIS_CHECK:
    return "data check";
  case C2D_ANALYSIS_STRESS:
    return "stress analysis";
  case C2D_ANALYSIS_CONTACT:
    return "contact zone";
  case C2D_ANALYSIS_FULL:
    return "contact zone and back substitution";
  default:
    return "contact zone, back substitution, every change of status";
  }
}

void append_control(std::string& out, const c2d_summary& s) {
  append_section(out, "Control data");
  append_item(out, "analysis", analysis_text(s.analysis));
  append_item(out, "plane", s.plane == C2D_PLANE_STRESS ? "stress" : "strain");
  append_item(out, "stepping", s.stepping == C2D_STEPPING_DECK ? "deck increments" : "events");
  append_item(out, "quadrature", s.quadrature == C2D_QUADRATURE_THESIS ? "2, 4 and 10 points" : "accurate");
  append_item(out, "bodies", static_cast<int64_t>(s.bodies));
  append_item(out, "contact zones", static_cast<int64_t>(s.zones));
  append_item(out, "pairs of nodes", static_cast<int64_t>(s.pairs));
  append_item(out, "functional nodes per element", static_cast<int64_t>(s.function_nodes));
  append_item(out, "iterations per increment at most", static_cast<int64_t>(s.iteration_limit));
}

void append_body(std::string& out, const c2d_summary& s, int32_t body) {
  const size_t b = static_cast<size_t>(body) - 1;
  append_section(out, body == 1 ? "Body 1" : "Body 2");
  append_item(out, "elements", static_cast<int64_t>(s.elements[b]));
  append_item(out, "geometry nodes per element", static_cast<int64_t>(s.element_nodes[b]));
  append_item(out, "boundary points", static_cast<int64_t>(s.geometry_nodes[b]));
  append_item(out, "functional nodes", static_cast<int64_t>(s.nodes[b]));
  append_item(out, "closed curves", static_cast<int64_t>(s.regions[b]));
  append_item(out, "equations", static_cast<int64_t>(s.unknowns[b]));
  append_item(out, "Young's modulus", s.youngs_modulus[b]);
  append_item(out, "Poisson's ratio", s.poisson_ratio[b]);
}

c2d_status append_regions(std::string& out, c2d_solver* solver, const c2d_summary& s, int32_t body) {
  out += "\n   curve   first element   last element\n";
  for (int32_t i = 1; i <= s.regions[body - 1]; ++i) {
    int32_t first = 0, last = 0;
    const c2d_status status = c2d_get_region(solver, body, i, &first, &last);
    if (status != C2D_OK) return status;
    append_column(out, i, 8);
    append_column(out, first, 16);
    append_column(out, last, 15);
    out += '\n';
  }
  return C2D_OK;
}

c2d_status append_coordinates(std::string& out, c2d_solver* solver, const c2d_summary& s, int32_t body) {
  const size_t n = static_cast<size_t>(s.geometry_nodes[body - 1]);
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

bool is_free(const int32_t codes[4], const double values[4]) {
  return codes[0] == 0 && codes[1] == 0 && values[0] == 0.0 && values[1] == 0.0;
}

// Known components of every element end that is neither free of traction nor left to the contact.
c2d_status append_conditions(std::string& out, c2d_solver* solver, const c2d_summary& s, int32_t body) {
  out += "\n element     end   codes             tx             ty             ux             uy"
         "    (ends not listed: free or contact)\n";
  for (int32_t e = 1; e <= s.elements[body - 1]; ++e)
    for (int32_t local = 1; local <= s.function_nodes; ++local) {
      int32_t codes[4] = {0, 0, 1, 1};
      double values[4] = {0.0, 0.0, 0.0, 0.0};
      const c2d_status status = c2d_get_condition(solver, body, e, local, codes, values);
      if (status != C2D_OK) return status;
      if (is_free(codes, values)) continue;
      append_column(out, e, 8);
      append_column(out, local, 8);
      out += "    ";
      for (int k = 0; k < 4; ++k) append_integer(out, codes[k]);
      for (int k = 0; k < 4; ++k)
        if (codes[k] == 0)
          append_general(out, values[k], 15, 8);
        else
          append_column(out, "-", 15);
      out += '\n';
    }
  return C2D_OK;
}

c2d_status append_zones(std::string& out, c2d_solver* solver, const c2d_summary& s) {
  if (s.zones == 0) return C2D_OK;
  append_section(out, "Contact zones");
  out += "    zone   pairs   elements          body 1 elements     nodes             body 2 elements     "
         "nodes\n";
  for (int32_t i = 1; i <= s.zones; ++i) {
    c2d_zone z = C2D_INIT(c2d_zone);
    const c2d_status status = c2d_get_zone(solver, i, &z);
    if (status != C2D_OK) return status;
    append_column(out, i, 8);
    append_column(out, z.pairs, 8);
    append_column(out, z.elements, 11);
    for (int b = 0; b < 2; ++b) {
      append_column(out, z.first_element[b], b == 0 ? 19 : 20);
      append_column(out, z.last_element[b], 6);
      append_column(out, z.first_node[b], 6);
      append_column(out, z.last_node[b], 6);
    }
    out += '\n';
  }
  return C2D_OK;
}

// Point loads are listed until the interface says there are no more.
void append_point_loads(std::string& out, c2d_solver* solver) {
  int32_t body = 0;
  double xy[2] = {0.0, 0.0}, force[2] = {0.0, 0.0};
  for (int32_t i = 1; c2d_get_point_load(solver, i, &body, xy, force) == C2D_OK; ++i) {
    if (i == 1) {
      append_section(out, "Point loads");
      out += "    body              x              y             fx             fy\n";
    }
    append_column(out, body, 8);
    append_general(out, xy[0], 15, 8);
    append_general(out, xy[1], 15, 8);
    append_general(out, force[0], 15, 8);
    append_general(out, force[1], 15, 8);
    out += '\n';
  }
}

c2d_status append_program_of_loads(std::string& out, c2d_solver* solver, const c2d_summary& s) {
  append_section(out, "Friction and loads");
  append_name(out, "coefficients of friction");
  for (int32_t i = 1; i <= s.coefficients; ++i) {
    double mu = 0.0;
    const c2d_status status = c2d_get_friction(solver, i, &mu);
    if (status != C2D_OK) return status;
    if (i > 1) out += ", ";
    append_number(out, mu);
  }
  out += "\n\n    path      increments    load factor\n";
  for (int32_t i = 1; i <= s.paths; ++i) {
    int32_t increments = 0;
    double load = 0.0;
    const c2d_status status = c2d_get_path(solver, i, &increments, &load);
    if (status != C2D_OK) return status;
    append_column(out, i, 8);
    append_column(out, increments, 16);
    append_general(out, load, 15, 8);
    out += '\n';
  }
  return C2D_OK;
}

void append_vector(std::string& out, const char* name, const double (&v)[3]) {
  append_column(out, name, 28);
  for (const double x : v) append_scientific(out, x, 16, 7);
  out += '\n';
}

void append_balance(std::string& out, const c2d_summary& s) {
  append_section(out, "Balance of forces at the last load");
  out += "                                         fx              fy          moment\n";
  for (int32_t b = 0; b < s.bodies; ++b) {
    double sum[3];
    for (int k = 0; k < 3; ++k) sum[k] = s.applied[b][k] + s.contact[b][k];
    append_vector(out, b == 0 ? "body 1: loads and supports" : "body 2: loads and supports", s.applied[b]);
    if (s.pairs > 0) append_vector(out, "contact", s.contact[b]);
    append_vector(out, "sum", sum);
  }
}

} // namespace

c2d_status append_model(std::string& out, c2d_solver* solver, const c2d_summary& s,
                        const std::vector<std::string>& heading) {
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
    append_body(out, s, body);
    status = append_regions(out, solver, s, body);
    if (status == C2D_OK) status = append_coordinates(out, solver, s, body);
    if (status == C2D_OK) status = append_conditions(out, solver, s, body);
  }
  append_point_loads(out, solver);
  if (status == C2D_OK) status = append_zones(out, solver, s);
  if (status == C2D_OK) status = append_program_of_loads(out, solver, s);
  return status;
}

namespace {

// What every touching pair carries after a change of status (IOUT of 3 or more).
void append_answers(std::string& out, const c2d_step& step) {
  static const int kColumns[] = {C2D_TN,  C2D_TT,  C2D_UN1, C2D_UT1,
                                 C2D_UN2, C2D_UT2, C2D_GAP, C2D_SLIP_SUM};
  out += "            pair           tn           tt          un1          ut1          un2          ut2"
         "          gap         slip\n";
  for (int32_t p = 0; p < step.pairs; ++p) {
    const double* row = step.table + p * step.stride;
    if (static_cast<int>(row[C2D_STATUS]) == C2D_OPEN) continue;
    append_column(out, p + 1, 16);
    for (const int c : kColumns) append_scientific(out, row[c], 13);
    out += '\n';
  }
}

} // namespace

void append_step(std::string& out, const c2d_step& step, bool first) {
  int32_t count[3] = {0, 0, 0};
  for (int32_t p = 0; p < step.pairs; ++p) {
    const int32_t status = static_cast<int32_t>(step.table[p * step.stride + C2D_STATUS]);
    if (status >= 0 && status < 3) ++count[status];
  }
  if (first) {
    append_section(out, "Increments");
    append_number(append_name(out, "coefficient of friction"), step.mu);
    out += "\n\n    step    load factor    open   stick    slip changes   status of the pairs (- open, o "
           "stick, / slip)\n";
  }
  if (step.kind == C2D_STEP_CHANGE)
    append_column(out, "change", 8);
  else if (step.kind == C2D_STEP_STOPPED)
    append_column(out, "stopped", 8);
  else
    append_column(out, step.step, 8);
  append_general(out, step.load, 15, 8);
  for (const int32_t c : count) append_column(out, c, 8);
  append_column(out, step.changes, 8);
  out += "   ";
  static const char kMark[] = "-o/";
  for (int32_t p = 0; p < step.pairs; ++p) {
    const int32_t status = static_cast<int32_t>(step.table[p * step.stride + C2D_STATUS]);
    if (p > 0 && p % 100 == 0) out.append(1, '\n').append(58, ' ');
    out += status >= 0 && status < 3 ? kMark[status] : '?';
  }
  out += '\n';
  if (step.kind == C2D_STEP_CHANGE) append_answers(out, step);
}

void append_contact_zone(std::string& out, const CoefficientRecord& c, const std::vector<ContactEnd>* ends,
                         const c2d_summary& s) {
  if (s.pairs == 0 || c.table.empty()) return;
  for (int32_t body = 1; body <= 2; ++body) {
    append_section(out, body == 1 ? "Contact zone of body 1" : "Contact zone of body 2");
    append_item(out, "coefficient of friction", c.mu);
    append_item(out, "load factor", c.load);
    out +=
        "  Frame: n from body 1 to body 2, t is n turned by -90 degrees. Tractions act on body 2 per length "
        "of body 1.\n\n"
        "    pair element  end            x            y           un           ut           tn           tt"
        "  status\n";
    for (const ContactEnd& end : ends[body - 1]) {
      const double* row = c.table.data() + static_cast<size_t>(end.pair - 1) * C2D_PAIR_FIELDS;
      append_column(out, end.pair, 8);
      append_column(out, end.element, 8);
      append_column(out, end.local, 5);
      append_scientific(out, end.x, 13);
      append_scientific(out, end.y, 13);
      append_scientific(out, row[body == 1 ? C2D_UN1 : C2D_UN2], 13);
      append_scientific(out, row[body == 1 ? C2D_UT1 : C2D_UT2], 13);
      append_scientific(out, row[C2D_TN], 13);
      append_scientific(out, row[C2D_TT], 13);
      append_column(out, status_word(static_cast<int32_t>(row[C2D_STATUS])), 8);
      out += '\n';
    }
  }
}

c2d_status append_global(std::string& out, c2d_solver* solver, const c2d_summary& s) {
  const int32_t fields[] = {C2D_END_NODE, C2D_END_X,  C2D_END_Y,  C2D_END_UX,
                            C2D_END_UY,   C2D_END_TX, C2D_END_TY, C2D_END_STATUS};
  std::vector<std::vector<double>> v;
  for (int32_t body = 1; body <= s.bodies; ++body) {
    const c2d_status status = get_ends(solver, s, body, fields, 8, v);
    if (status != C2D_OK) return status;
    append_section(out, body == 1 ? "Body 1 in global components" : "Body 2 in global components");
    append_item(out, "load factor", s.load);
    out += "\n element    node            x            y           ux           uy           tx           ty "
           " status\n";
    for (size_t i = 0; i < v[0].size(); ++i) {
      append_column(out, static_cast<int32_t>(i) / s.function_nodes + 1, 8);
      append_column(out, static_cast<int64_t>(v[0][i]), 8);
      for (size_t f = 1; f <= 6; ++f) append_scientific(out, v[f][i], 13);
      if (v[7][i] >= 0.0) append_column(out, status_word(static_cast<int32_t>(v[7][i])), 8);
      out += '\n';
    }
  }
  return C2D_OK;
}

namespace {

void append_energy(std::string& out, const RunRecord& record) {
  append_section(out, "Energy");
  for (const CoefficientRecord& c : record.coefficients) {
    if (c.steps.empty()) continue;
    append_number(append_name(out, "coefficient of friction"), c.mu);
    out += "\n\n    step         work      elastic   dissipated       defect   load factors\n";
    for (const StepRecord& step : c.steps) {
      append_column(out, step.step, 8);
      for (const double v : {step.work, step.elastic, step.dissipated, step.defect}) append_general(out, v, 13, 5);
      out += "  ";
      for (const double load : step.loads) append_general(out, load, 13, 8);
      out += '\n';
    }
  }
}

} // namespace

void append_ending(std::string& out, const RunRecord& record, const c2d_summary& s) {
  const bool solved =
      !record.checked_only && (record.incomplete() == nullptr || !record.incomplete()->singular);
  if (solved) append_balance(out, s);
  if (solved) append_energy(out, record);
  if (!record.warnings.empty()) {
    append_section(out, "Warnings");
    for (const c2d_error& w : record.warnings) {
      out += "  ";
      out += w.text;
      out += '\n';
    }
  }
  append_section(out, "Outcome");
  for (const CoefficientRecord& c : record.coefficients) {
    const bool stopped = c.outcome != C2D_REACHED || c.singular;
    append_name(out, "coefficient of friction");
    append_number(out, c.mu);
    out += stopped ? "  incomplete: " : "  ";
    out += c.singular ? "singular" : outcome_word(c.outcome);
    out += " at load factor ";
    append_number(out, c.load);
    if (stopped) {
      out += ", step ";
      append_integer(out, c.step);
      out += ": ";
      out += c.why;
    }
    out += '\n';
  }
  if (record.checked_only) out += "  data check only: the deck is in order, nothing was solved\n";
}

} // namespace app
