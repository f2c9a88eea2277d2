#include "report/json/json.hpp"

#include "report/json/json_object.hpp"
#include "report/json/json_torsion.hpp"
#include "report/text.hpp"
#include "report/totals.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

void append_memory(std::string& out, const Summary& s) {
  Object o(out, "{", ", ");
  o.bytes("minimum_bytes", s.minimum_bytes);
  o.bytes("in_core_bytes", s.in_core_bytes);
  o.bytes("workspace_bytes", s.workspace_bytes);
  o.bytes("peak_workspace_bytes", s.peak_bytes);
  out += '}';
}

void append_tapes(std::string& out, const Summary& s) {
  out += '[';
  for (int32_t t = 0; t < C2D_TAPES; ++t) {
    out += t == 0 ? "\n    " : ",\n    ";
    Object o(out, "{", ", ");
    o.word("name", tape_word(t));
    o.bytes("bytes_written", s.tape_bytes_written[t]);
    o.bytes("bytes_read", s.tape_bytes_read[t]);
    o.bytes("blocks", s.tape_blocks[t]);
    out += '}';
  }
  out += ']';
}

void append_seconds(std::string& out, const RunRecord& record, const Summary& s) {
  static const char* const kPhases[C2D_PHASES] = {"read", "assemble", "eliminate", "reduce", "contact", "back", "write"};
  Object o(out, "{", ", ");
  for (int32_t p = 0; p < C2D_PHASES; ++p) {
    double seconds = s.seconds[p];
    if (p == C2D_PHASE_READ) seconds += record.read_seconds;
    if (p == C2D_PHASE_WRITE) seconds += record.write_seconds;
    o.number(kPhases[p], seconds);
  }
  out += '}';
}

void append_triple(std::string& out, const double (&v)[3]) {
  for (int i = 0; i < 3; ++i) {
    out += i == 0 ? "[" : ", ";
    if (std::isfinite(v[i]))
      append_number(out, v[i]);
    else
      out += "null";
  }
  out += ']';
}

// Only if there is one.
void append_json_name(Object& o, const std::vector<std::string>& names, size_t i) {
  if (i < names.size() && !names[i].empty()) o.word("name", names[i].c_str());
}

void append_compression(std::string& out, const Summary& s) {
  Object o(out, "{", ", ");
  o.integer("bodies", s.compressed_bodies);
  o.number("residual", s.compression_residual);
  o.number("error", s.compression_error);
  out += '}';
}

void append_force(std::string& out, const Summary& s) {
  Object o(out, "{", ", ");
  o.number("applied", s.force_applied);
  o.number("contact", s.force_contact);
  if (s.force_error >= 0.0) o.number("error", s.force_error);
  o.key("bodies") += '[';
  for (int32_t b = 0; b < s.bodies; ++b) {
    out += b == 0 ? "\n    " : ",\n    ";
    Object body(out, "{", ", ");
    append_json_name(body, s.body_name, static_cast<size_t>(b));
    append_triple(body.key("applied"), s.body[b].applied);
    append_triple(body.key("contact"), s.body[b].contact);
    if (lines_that_cut(s, b + 1) != 0) {
      const BodyTotal applied = whole_of(s, b + 1, s.body[b].applied), contact = whole_of(s, b + 1, s.body[b].contact);
      Object whole(body.key("whole"), "{", ", ");
      append_triple(whole.key("applied"), applied.force);
      append_triple(whole.key("contact"), contact.force);
      out += '}';
    }
    out += '}';
  }
  out += "]}";
}

void append_quantity(std::string& out, const Quantity& q, const Summary& summary) {
  Object o(out, "{", ", ");
  o.integer("zone", q.zone);
  o.word("quantity", name_of(q.what));
  o.integer("item", q.item);
  if (q.is_of_body()) append_json_name(o, summary.body_name, static_cast<size_t>(q.item) - 1);
  o.number("value", q.value);
  if (std::isfinite(q.at[0])) {
    o.number("x", q.at[0]);
    o.number("y", q.at[1]);
    o.number("s", q.s);
    o.number("along", q.along);
  }
  if (std::isfinite(q.error)) o.number("error", q.error);
  out += '}';
}

// Of a step; nothing where there is no contact at all.
void append_quantities(Object& o, const StepRecord& step, const Summary& summary, const char* between) {
  if (step.quantities.empty()) return;
  std::string& out = o.key("quantities") += '[';
  for (size_t i = 0; i < step.quantities.size(); ++i) {
    out += i > 0 ? "," : "";
    out += i > 0 || *between == '\n' ? between : "";
    append_quantity(out, step.quantities[i], summary);
  }
  out += ']';
}

void append_runs(std::string& out, const RunRecord& record, const Summary& summary) {
  out += '[';
  bool first = true;
  for (const CoefficientRecord& c : record.coefficients) {
    out += first ? "\n    " : ",\n    ";
    first = false;
    Object o(out, "{", ", ");
    o.number("mu", c.mu);
    o.word("outcome", c.singular ? "singular" : outcome_word(c.outcome));
    o.integer("step", c.step);
    o.number("load", c.load);
    o.integer("changes", c.changes);
    if (!c.steps.empty()) append_quantities(o, c.steps.back(), summary, "\n      ");
    out += '}';
  }
  out += ']';
}

void append_list(std::string& out, const std::vector<double>& numbers) {
  out += '[';
  for (size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0) out += ", ";
    append_number(out, numbers[i]);
  }
  out += ']';
}

void append_zone(std::string& out, const c2d_zone_state& z) {
  Object o(out, "{", ", ");
  o.integer("open", z.open);
  o.integer("stick", z.stick);
  o.integer("slip", z.slip);
  o.integer("near_change", z.near_change);
  append_list(o.key("force"), {z.force[0], z.force[1]});
  o.number("moment", z.moment);
  o.number("approach", z.approach);
  o.number("shift", z.shift);
  o.number("dissipated", z.dissipated);
  out += '}';
}

void append_body_state(std::string& out, const c2d_body_state& b) {
  Object o(out, "{", ", ");
  append_list(o.key("contact"), {b.contact[0], b.contact[1], b.contact[2]});
  if (b.is_rigid != 0) {
    append_list(o.key("motion"), {b.motion[0], b.motion[1], b.motion[2]});
    append_list(o.key("point"), {b.point[0], b.point[1]});
    append_list(o.key("load"), {b.load[0], b.load[1], b.load[2]});
  }
  out += '}';
}

void append_crack(std::string& out, const StressIntensity& crack) {
  Object o(out, "{", ", ");
  o.integer("zone", crack.zone);
  append_list(o.key("tip"), {crack.at[0], crack.at[1]});
  o.number("K1", crack.K1);
  o.number("K2", crack.K2);
  if (!crack.why.empty()) o.word("why", crack.why.c_str());
  out += '}';
}

void append_corner(std::string& out, const CornerState& corner) {
  Object o(out, "{", ", ");
  o.word("kind", name_of(corner.kind));
  if (corner.zone > 0) o.integer("zone", corner.zone);
  o.key("bodies") += '[';
  for (int i = 0; i < 2 && corner.body[i] > 0; ++i) {
    if (i > 0) out += ", ";
    append_integer(out, corner.body[i]);
  }
  out += ']';
  append_list(o.key("at"), {corner.at[0], corner.at[1]});
  o.word("state", corner.joint);
  std::vector<double> real, imaginary;
  for (const Complex& lambda : corner.exponents) real.push_back(lambda.real()), imaginary.push_back(lambda.imag());
  append_list(o.key("exponents"), real);
  if (std::any_of(imaginary.begin(), imaginary.end(), [](double v) { return v != 0; }))
    append_list(o.key("imaginary"), imaginary);
  o.number("K", corner.K);
  if (!corner.why.empty()) {
    o.word("why", corner.why.c_str());
  } else {
    o.number("K_error", corner.K_error);
    if (std::isfinite(corner.K2)) o.number("K2", corner.K2);
    if (std::isfinite(corner.K2)) o.number("K2_error", corner.K2_error);
  }
  out += '}';
}

// Tips of cracks only where there are any.
void append_cracks(Object& o, const StepRecord& step) {
  if (step.cracks.empty()) return;
  std::string& out = o.key("cracks") += '[';
  for (size_t i = 0; i < step.cracks.size(); ++i) {
    if (i > 0) out += ", ";
    append_crack(out, step.cracks[i]);
  }
  out += ']';
}

// Only where there are any.
void append_corners(Object& o, const std::vector<CornerState>& corners, const char* between) {
  if (corners.empty()) return;
  std::string& out = o.key("corners") += '[';
  for (size_t i = 0; i < corners.size(); ++i) {
    out += i > 0 ? "," : "";
    out += i > 0 || *between == '\n' ? between : "";
    append_corner(out, corners[i]);
  }
  out += ']';
}

// Per recorded step: factors of all load cases, energy, zones, bodies.
void append_history(std::string& out, const RunRecord& record, const Summary& summary) {
  out += '[';
  bool first = true;
  for (const CoefficientRecord& c : record.coefficients)
    for (const StepRecord& step : c.steps) {
      out += first ? "\n    " : ",\n    ";
      first = false;
      Object o(out, "{", ", ");
      o.number("mu", c.mu);
      o.integer("step", step.step);
      append_list(o.key("loads"), step.loads);
      o.number("work", step.work);
      append_list(o.key("work_by_case"), step.work_by_case);
      o.number("dissipated", step.dissipated);
      o.number("elastic", step.elastic);
      o.number("energy_defect", step.defect);
      append_corners(o, step.corners, " ");
      o.key("zones") += '[';
      for (size_t z = 0; z < step.zones.size(); ++z) {
        if (z > 0) out += ", ";
        append_zone(out, step.zones[z]);
      }
      out += ']';
      o.key("bodies") += '[';
      for (size_t b = 0; b < step.bodies.size(); ++b) {
        if (b > 0) out += ", ";
        append_body_state(out, step.bodies[b]);
      }
      out += ']';
      append_cracks(o, step);
      append_quantities(o, step, summary, " ");
      out += '}';
    }
  out += ']';
}

// Lines across which images continue the model.
void append_symmetry(std::string& out, const Summary& s) {
  out += '[';
  bool first = true;
  for (int axis = 0; axis < 2; ++axis) {
    if ((mirror_lines(s) >> axis & 1) == 0) continue;
    if (!first) out += ", ";
    first = false;
    Object line(out, "{", ", ");
    line.word("axis", axis == 0 ? "x" : "y");
    line.number("at", s.symmetry_at[axis]);
    out += '}';
  }
  out += ']';
}

void append_incomplete(std::string& out, const CoefficientRecord& c) {
  Object o(out, "{", ", ");
  o.number("mu", c.mu);
  o.integer("step", c.step);
  o.number("load", c.load);
  append_list(o.key("loads"), c.loads.empty() ? std::vector<double>{c.load} : c.loads);
  o.word("why", c.why.c_str());
  o.integer("body", c.body);
  o.integer("pair", c.pair);
  out += '}';
}

void append_interior(std::string& out, const Interior& interior) {
  Object o(out, "{", ", ");
  o.integer("points", static_cast<int64_t>(interior.points.size()));
  o.integer("inside", interior.count[C2D_POINT_INSIDE]);
  o.integer("near_node", interior.count[C2D_POINT_NEAR_NODE]);
  o.integer("boundary", interior.count[C2D_POINT_BOUNDARY]);
  o.integer("outside", interior.count[C2D_POINT_OUTSIDE]);
  o.integer("clipped", interior.clipped);
  out += '}';
}

void append_json_warnings(std::string& out, const RunRecord& record) {
  out += '[';
  bool first = true;
  for (const c2d_error& w : record.warnings) {
    out += first ? "\n    " : ",\n    ";
    first = false;
    Object::append_string(out, w.text);
  }
  out += ']';
}

void append_friction(std::string& out, const std::vector<double>& coefficients) {
  out += '[';
  for (size_t i = 0; i < coefficients.size(); ++i) {
    if (i > 0) out += ", ";
    if (std::isfinite(coefficients[i]))
      append_number(out, coefficients[i]);
    else
      out += "null";
  }
  out += ']';
}

void append_unknowns(std::string& out, const Summary& s) {
  Object unknowns(out, "{", ", ");
  for (int32_t b = 1; b <= std::max(s.bodies, 2); ++b) // body2 is present even with one body
    unknowns.integer(("body" + std::to_string(b)).c_str(), b <= s.bodies ? s.body[b - 1].unknowns : 0);
  unknowns.integer("contact", s.contact_unknowns);
  out += '}';
}

void append_json_inputs(std::string& out, const Inputs& inputs) {
  Object o(out, "{", ", ");
  o.word("build", build_text().c_str());
  o.key("files") += '[';
  for (size_t i = 0; i < inputs.files.size(); ++i) {
    if (i > 0) out += ", ";
    Object file(out, "{", ", ");
    file.word("name", inputs.files[i].name.c_str());
    file.word("sha256", inputs.files[i].sha256.c_str());
    out += '}';
  }
  out += ']';
  {
    Object parameters(o.key("parameters"), "{", ", ");
    for (const auto& [name, value] : inputs.parameters) parameters.word(name.c_str(), value.c_str());
    out += '}';
  }
  o.key("options") += '[';
  for (size_t i = 0; i < inputs.options.size(); ++i) {
    if (i > 0) out += ", ";
    Object::append_string(out, inputs.options[i].c_str());
  }
  out += "]}";
}

void append_zones(std::string& out, const RunRecord& record, const Summary& s) {
  out += '[';
  for (size_t i = 0; i < record.measure.size(); ++i) {
    if (i > 0) out += ", ";
    Object zone(out, "{", ", ");
    zone.integer("zone", static_cast<int64_t>(i) + 1);
    append_json_name(zone, s.zone_name, i);
    if (s.names_bodies() && i < s.zone.size()) {
      zone.integer("body1", s.zone[i].side1.body);
      zone.integer("body2", s.zone[i].side2.body);
    }
    zone.word("measure", ("body " + std::to_string(record.measure[i])).c_str());
    if (i < record.zone_friction.size()) zone.number("mu", record.zone_friction[i]);
    out += '}';
  }
  out += ']';
}

} // namespace

void append_json(std::string& out, const RunRecord& record, const Summary& s) {
  Object o(out, "{\n  ", ",\n  ");
  o.word("version", c2d_version());
  if (!record.inputs.files.empty()) append_json_inputs(o.key("inputs"), record.inputs);
  o.word("outcome", record.outcome());
  if (const CoefficientRecord* stopped = record.incomplete()) append_incomplete(o.key("incomplete"), *stopped);
  o.word("title", s.title);
  append_friction(o.key("mu"), record.friction);
  o.integer("steps", s.steps);
  append_unknowns(o.key("unknowns"), s);
  append_memory(o.key("memory"), s);
  append_tapes(o.key("tapes"), s);
  append_seconds(o.key("seconds"), record, s);
  if (s.plane == C2D_AXISYMMETRIC) o.word("plane", "axisymmetric");
  append_symmetry(o.key("symmetry"), s);
  append_zones(o.key("zones"), record, s);
  o.integer("events", s.events);
  o.integer("exchanges", s.exchanges);
  o.integer("tableau_rebuilds", s.tableau_rebuilds);
  o.number("max_residual", s.max_residual);
  o.number("elimination_residual", s.elimination_residual);
  o.number("condition", s.condition);
  o.word("elimination", s.compressed_bodies > 0 ? "compressed" : "dense");
  if (s.compressed_bodies > 0) append_compression(o.key("compression"), s);
  o.number("tension_ratio", s.tension_ratio);
  append_force(o.key("force"), s);
  append_runs(o.key("runs"), record, s);
  append_history(o.key("steps_detail"), record, s);
  const auto has_cycles = [](const CoefficientRecord& c) { return !c.cycles.empty(); };
  if (std::any_of(record.coefficients.begin(), record.coefficients.end(), has_cycles))
    append_json_cycles(o.key("cycles"), record, s);
  append_corners(o, record.corners, "\n    ");
  if (record.meshes.ran()) append_accuracy(o.key("accuracy"), record.meshes);
  if (record.meshes.tolerances.any()) append_tolerances(o.key("tolerances"), record.meshes.tolerances);
  if (record.meshes.torsion.any()) append_json_torsion(o.key("torsion"), record.meshes.torsion);
  if (record.interior != nullptr) append_interior(o.key("interior"), *record.interior);
  append_json_warnings(o.key("warnings"), record);
  out += "\n}\n";
}

} // namespace app
