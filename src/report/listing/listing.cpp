#include "report/listing/listing.hpp"

#include "report/listing/listing_items.hpp"
#include "report/text.hpp"
#include "report/totals.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

void append_vector(std::string& out, const std::string& name, size_t width, const double (&v)[3]) {
  const size_t used = characters_in(name);
  out.append(used < width ? width - used : 0, ' ') += name;
  for (const double x : v) append_scientific(out, x, 16, 7);
  out += '\n';
}

void append_balance(std::string& out, const Summary& s) {
  append_section(out, "Balance of forces at the last load");
  size_t width = 28;
  const auto name_of_row = [&](int32_t b, const BodyTotal& row) {
    return row.of == "loads and supports" ? body_text(s, b) + ": " + row.of : row.of;
  };
  for (int32_t b = 1; b <= s.bodies; ++b)
    for (const BodyTotal& row : totals_of(s, b)) width = std::max(width, 2 + characters_in(name_of_row(b, row)));
  out.append(width - 28, ' ') += "                                         fx              fy          moment\n";
  for (int32_t b = 1; b <= s.bodies; ++b)
    for (const BodyTotal& row : totals_of(s, b)) append_vector(out, name_of_row(b, row), width, row.force);
  if (mirror_lines(s) != 0) out += std::string("\n  ") + words_of_totals(s) + "\n";
}

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

// Of all tips; where there is none, why.
void append_cracks(std::string& out, const CoefficientRecord& c) {
  append_number(append_name(out, "coefficient of friction"), c.mu);
  out += "\n\n    step    zone        tip x        tip y           K1           K2   load factors\n";
  for (const StepRecord& step : c.steps)
    for (const StressIntensity& crack : step.cracks) {
      append_column(out, step.step, 8);
      append_column(out, crack.zone, 8);
      for (const double v : {crack.at[0], crack.at[1]}) append_general(out, v, 13);
      const double noise = 1e-13 * std::max(std::fabs(crack.K1), std::fabs(crack.K2));
      for (const double v : {crack.K1, crack.K2})
        if (std::isfinite(v))
          append_general(out, std::fabs(v) <= noise ? 0.0 : v, 13);
        else
          append_column(out, "-", 13);
      out += "  ";
      for (const double load : step.loads) append_general(out, load, 13, 8);
      if (!crack.why.empty()) out += "   " + crack.why;
      out += '\n';
    }
}

void append_stress_intensity(std::string& out, const RunRecord& record) {
  bool first = true;
  for (const CoefficientRecord& c : record.coefficients) {
    if (c.steps.empty() || c.steps.front().cracks.empty()) continue;
    if (first) append_section(out, "Stress intensity at tips of cracks");
    first = false;
    append_cracks(out, c);
  }
}

} // namespace

c2d_status append_global(std::string& out, c2d_solver* solver, const Summary& s, const std::vector<double>& loads) {
  const int32_t fields[] = {C2D_END_NODE, C2D_END_X, C2D_END_Y, C2D_END_UX, C2D_END_UY, C2D_END_TX, C2D_END_TY, C2D_END_STATUS};
  std::vector<std::vector<double>> v;
  for (int32_t body = 1; body <= s.bodies; ++body) {
    if (s.is_platen(body)) continue;
    const c2d_status status = get_ends(solver, s, body, fields, 8, v);
    if (status != C2D_OK) return status;
    append_body_section(out, s, body, " in global components");
    append_loads(out, loads);
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

bool is_solved(const RunRecord& record) {
  return !record.checked_only && (record.incomplete() == nullptr || !record.incomplete()->singular);
}

void append_findings(std::string& out, const RunRecord& record, const Summary& s) {
  append_quantities(out, record, s);
  append_accuracy(out, record);
  append_tolerances(out, record);
  append_torsion(out, record);
  append_stress_intensity(out, record);
  append_corners(out, record, s);
}

void append_warnings(std::string& out, const RunRecord& record) {
  if (record.warnings.empty()) return;
  append_section(out, "Warnings");
  for (const c2d_error& w : record.warnings) {
    out += "  ";
    out += w.text;
    out += '\n';
  }
}

void append_outcome(std::string& out, const RunRecord& record, const Summary& s) {
  append_section(out, "Outcome");
  for (const CoefficientRecord& c : record.coefficients) {
    const bool stopped = c.outcome != C2D_REACHED || c.singular;
    append_name(out, "coefficient of friction");
    append_number(out, c.mu);
    out += stopped ? "  incomplete: " : "  ";
    out += c.singular ? "singular" : outcome_word(c.outcome);
    out += " at " + load_reached(c);
    if (stopped) {
      out += ", step ";
      append_integer(out, c.step);
      out += ": ";
      out += c.why;
    }
    out += '\n';
    if (!c.cycles.empty() && !stopped) out += "  the cycle is " + cycle_text(c, s) + '\n';
  }
  if (record.checked_only) out += "  data check only: the input is in order, nothing was solved\n";
}

} // namespace

void append_ending(std::string& out, const RunRecord& record, const Summary& s) {
  if (is_solved(record)) {
    append_balance(out, s);
    append_energy(out, record);
    append_cycles(out, record, s, true);
    append_findings(out, record, s);
  }
  append_warnings(out, record);
  append_inputs(out, record.inputs);
  append_outcome(out, record, s);
}

void append_short_ending(std::string& out, const RunRecord& record, const Summary& s) {
  if (is_solved(record)) append_cycles(out, record, s, false);
  if (is_solved(record)) append_findings(out, record, s);
  append_outcome(out, record, s);
  out += "\nSummary only: --listing FILE writes the complete listing, --listing - prints it.\n";
}

} // namespace app
