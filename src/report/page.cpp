#include "report/page.hpp"

#include "report/drawn/dark.hpp"
#include "report/listing/key_table.hpp"
#include "report/text.hpp"

#include <cmath>

namespace app {
namespace {

const char kStyle[] = "body{font-family:Helvetica,Arial,'Liberation Sans',sans-serif;color:#222;max-width:800px;margin:24px "
                      "auto;"
                      "padding:0 16px;line-height:1.4}\n"
                      "h1{font-size:22px;margin:0 0 4px}h2{font-size:16px;margin:28px 0 6px;border-bottom:1px solid #ccc}\n"
                      "figure{margin:0 0 8px}svg{max-width:100%;height:auto}figcaption{font-size:13px;color:#333}\n"
                      // A box that can be scrolled sideways has a shadow at the edges beyond which there is more.
                      ":root{--paper:#fff;--shadow:#0005}.wide{overflow-x:auto;background:"
                      "linear-gradient(90deg,var(--paper) 50%,transparent) 0/32px local,"
                      "linear-gradient(270deg,var(--paper) 50%,transparent) 100%/32px local,"
                      "linear-gradient(90deg,var(--shadow),transparent) 0/10px 98% scroll,"
                      "linear-gradient(270deg,var(--shadow),transparent) 100%/10px 98% scroll;background-repeat:no-repeat}\n"
                      "td{white-space:nowrap}\n"
                      "table{border-collapse:collapse;font-size:13px;margin:8px 0}\n"
                      "th,td{text-align:right;padding:2px 10px;border-bottom:1px solid #ddd}\n"
                      "th:first-child,td:first-child{text-align:left;padding-left:0}th{border-bottom:1px solid #555}\n"
                      ".outcome{padding:6px 12px;border-left:4px solid #007a5a;background:#f3f8f6}\n"
                      ".stopped{border-left-color:#d55e00;background:#fdf3ec}\n"
                      "@media "
                      "print{body{max-width:none;margin:0;font-size:11pt}section{break-inside:avoid}h2{break-after:avoid}\n"
                      "svg{width:auto;max-height:104mm}}@page{margin:18mm}\n"
                      // Tables may use the margin at the right.
                      "@media screen and (min-width:852px){section>.wide,details>.wide{margin-right:calc(426px - 50vw)}}\n"
                      // On a telephone pictures keep legible letters and are scrolled sideways, the text is not.
                      "@media screen and (max-width:640px){body{margin:12px auto;padding:0 12px}h1{font-size:19px}\n"
                      ".wide svg{max-width:none;width:680px}th,td{padding:2px 6px}}\n";

std::string whole(uint64_t value) { return std::to_string(value); }

void append_row(std::string& out, const std::vector<std::string>& cells, const char* tag = "td") {
  out += "<tr>";
  for (const std::string& cell : cells) out += std::string("<") + tag + ">" + cell + "</" + tag + ">";
  out += "</tr>\n";
}

std::string with_unit(const char* name, const std::string& unit) {
  return unit.empty() ? std::string(name) : name + (", " + unit);
}

void append_outcome(std::string& out, const Scene& scene) {
  const RunRecord& record = *scene.record;
  const bool stopped = record.incomplete() != nullptr;
  out += stopped ? "<div class=\"outcome stopped\">" : "<div class=\"outcome\">";
  if (record.checked_only) out += "Data check only: the deck is in order, nothing was solved.";
  for (const CoefficientRecord& c : record.coefficients) {
    out += "<div>";
    if (!scene.pairs.empty()) out += "&#956; = " + figure(c.mu) + ": ";
    if (c.singular)
      out += "<b>not solved</b>: " + escape_xml(c.why);
    else if (c.outcome != C2D_REACHED)
      out +=
          "<b>incomplete</b>, stopped at " + load_reached(c) + " in step " + std::to_string(c.step) + ": " + escape_xml(c.why);
    else
      out += "reached " + load_reached(c) + " in " + std::to_string(c.step) + (c.step == 1 ? " step." : " steps.");
    out += "</div>\n";
  }
  out += "</div>\n";
}

void append_picture(std::string& out, const Picture& picture) {
  out += "<section id=\"" + picture.name + "\">\n<h2>" + picture.title + "</h2>\n<figure>\n<div class=\"wide\">" + picture.svg +
         "</div><figcaption>" + picture.caption + "</figcaption>\n</figure>\n</section>\n";
}

void append_key_numbers(std::string& out, const Scene& scene) {
  if (scene.zones.empty() || scene.record->coefficients.empty()) return;
  out += "<section id=\"key\">\n<h2>Key numbers at the last step</h2>\n<div class=\"wide\"><table>\n";
  append_row(out,
             {"&#956;", "zone", "load", with_unit("peak pressure", scene.stress_unit), with_unit("at", scene.length_unit),
              "touch", "stick", "slip", with_unit("contact from", scene.length_unit), with_unit("to", scene.length_unit)},
             "th");
  for (size_t i = 0; i < scene.record->coefficients.size(); ++i)
    for (size_t z = 0; z < scene.zones.size(); ++z) {
      const CoefficientRecord& c = scene.record->coefficients[i];
      if (scene.zones[z].pairs == 0 || c.table.empty()) continue;
      const ZoneFacts f = find_facts(scene, scene.zones[z], c.table);
      const std::string zone =
          zone_label(scene, z).substr(5) + (scene.summary.names_bodies() ? ": " + bodies_of(scene, scene.zones[z]) : "");
      append_row(out, {figure(friction_of(scene, i, z)), zone, list_of(c.loads), figure(f.peak, 6),
                       scene.zones[z].position + (" = " + figure(scene.pairs[f.peak_pair].s)), std::to_string(f.touching),
                       std::to_string(f.sticking), std::to_string(f.slipping), f.touching > 0 ? figure(f.low) : "&#8211;",
                       f.touching > 0 ? figure(f.high) : "&#8211;"});
    }
  out += "</table></div>\n</section>\n";
}

std::string unit_of(Measure what, const Scene& scene) {
  switch (what) {
  case Measure::kPeakPressure:
  case Measure::kMeanPressure: return scene.stress_unit;
  case Measure::kContactEdge:
  case Measure::kStickBorder:
  case Measure::kApproach:
  case Measure::kSlipRange:
  case Measure::kMotionX:
  case Measure::kMotionY:
  case Measure::kShift: return scene.length_unit;
  case Measure::kFrictionForce:
  case Measure::kForceX:
  case Measure::kForceY: return scene.force_unit;
  case Measure::kMoment:
  case Measure::kDissipated: return scene.work_unit;
  default: return ""; // intensities have roots of lengths
  }
}

// Key numbers of the contact and their stated errors.
void append_numbers(std::string& out, const Scene& scene) {
  if (scene.zones.empty() || scene.record->coefficients.empty()) return;
  const std::string none = "&#8211;";
  out += "<section id=\"numbers\">\n<h2>Contact in numbers, at the last step</h2>\n<div class=\"wide\"><table>\n";
  bool stated = false;
  for (const CoefficientRecord& c : scene.record->coefficients)
    for (size_t k = 0; !c.steps.empty() && k < c.steps.back().quantities.size(); ++k)
      stated = stated || std::isfinite(c.steps.back().quantities[k].error);
  std::vector<std::string> heading{"&#956;", "zone", "quantity", "value"};
  if (stated) heading.emplace_back("stated error");
  for (const char* name : {"x", "y"}) heading.push_back(with_unit(name, scene.length_unit));
  append_row(out, heading, "th");
  for (size_t i = 0; i < scene.record->coefficients.size(); ++i) {
    const CoefficientRecord& c = scene.record->coefficients[i];
    if (c.steps.empty()) continue;
    for (const Quantity& q : c.steps.back().quantities) {
      const size_t z = q.zone > 0 ? static_cast<size_t>(q.zone) - 1 : 0;
      const std::string zone = q.zone > 0 ? zone_label(scene, z).substr(5) : "all",
                        item = q.item > 0 ? " " + std::to_string(q.item) : "";
      std::vector<std::string> row{figure(friction_of(scene, i, z)), zone,
                                   with_unit((name_of(q.what) + item).c_str(), unit_of(q.what, scene)), figure(q.value, 6)};
      if (stated) row.push_back(std::isfinite(q.error) ? "&#177; " + figure(q.error, 2) : none);
      for (const double at : q.at) row.push_back(std::isfinite(at) ? figure(at, 6) : none);
      append_row(out, row);
    }
  }
  out += "</table></div>\n</section>\n";
}

// Step by step, folded away.
void append_steps(std::string& out, const Scene& scene) {
  size_t shown = 0;
  for (size_t i = 0; i < scene.record->coefficients.size(); ++i)
    for (size_t z = 0; z < scene.zones.size(); ++z) {
      const KeyTable table = key_table(scene.record->coefficients[i], static_cast<int32_t>(z) + 1, 5);
      if (table.rows.empty() || ++shown > kMostCharts) continue;
      out += "<details>\n<summary>Step by step, " + chart_title(scene, friction_of(scene, i, z), z) +
             "</summary>\n<div class=\"wide\"><table>\n";
      append_row(out, table.heading, "th");
      for (const std::vector<std::string>& row : table.rows) append_row(out, row);
      out += "</table></div>\n</details>\n";
    }
}

void append_balance(std::string& out, const Scene& scene) {
  const Summary& s = scene.summary;
  out += "<section id=\"equilibrium\">\n<h2>Equilibrium</h2>\n<div class=\"wide\"><table>\n";
  append_row(out,
             {"per unit thickness", with_unit("fx", scene.force_unit), with_unit("fy", scene.force_unit),
              with_unit("moment about the origin", scene.work_unit)},
             "th");
  for (int32_t b = 0; b < s.bodies; ++b) {
    const std::string body = body_label(scene, b + 1) + ": ";
    const double* applied = s.body[b].applied;
    const double* contact = s.body[b].contact;
    append_row(out, {body + "loads and supports", figure(applied[0], 7), figure(applied[1], 7), figure(applied[2], 7)});
    if (s.pairs > 0) append_row(out, {body + "contact", figure(contact[0], 7), figure(contact[1], 7), figure(contact[2], 7)});
    append_row(out, {body + "sum", figure(applied[0] + contact[0], 2), figure(applied[1] + contact[1], 2),
                     figure(applied[2] + contact[2], 2)});
  }
  out += "</table></div>\n";
  if (s.symmetry != 0)
    out += "<p>Totals cover the modelled half or quarter only; the remainder is carried across the lines of "
           "symmetry.</p>\n";
  out += "</section>\n";
}

// Of one body or two a column each, of more a row each.
void append_body_sizes(std::string& out, const Scene& scene) {
  const Summary& s = scene.summary;
  const std::string none = "&#8211;";
  const auto of = [&](int32_t b, int32_t c2d_body_result::*member) {
    return b < s.bodies ? std::to_string(s.body[b].*member) : none;
  };
  const std::string pairs = std::to_string(s.pairs) + " pairs", unknowns = std::to_string(s.contact_unknowns);
  if (s.bodies > 2) {
    append_row(out, {"size", "elements", "functional nodes", "unknowns"}, "th");
    for (int32_t b = 0; b < s.bodies; ++b)
      append_row(out, {body_label(scene, b + 1), of(b, &c2d_body_result::elements), of(b, &c2d_body_result::nodes),
                       of(b, &c2d_body_result::unknowns)});
    append_row(out, {"contact", none, pairs, unknowns});
    return;
  }
  append_row(out, {"size", body_label(scene, 1), body_label(scene, 2), "contact"}, "th");
  append_row(out, {"elements", of(0, &c2d_body_result::elements), of(1, &c2d_body_result::elements), none});
  append_row(out, {"functional nodes", of(0, &c2d_body_result::nodes), of(1, &c2d_body_result::nodes), pairs});
  append_row(out, {"unknowns", of(0, &c2d_body_result::unknowns), of(1, &c2d_body_result::unknowns), unknowns});
}

void append_sizes(std::string& out, const Scene& scene) {
  const Summary& s = scene.summary;
  out += "<section id=\"sizes\">\n<h2>Sizes, seconds, bytes</h2>\n<div class=\"wide\"><table>\n";
  append_body_sizes(out, scene);
  out += "</table></div>\n<div class=\"wide\"><table>\n";
  append_row(out, {"phase", "seconds"}, "th");
  static const char* const kPhases[] = {"assemble", "eliminate", "reduce", "contact", "back substitution"};
  append_row(out, {"read", figure(s.seconds[0] + scene.record->read_seconds, 3)});
  for (size_t i = 0; i < 5; ++i) append_row(out, {kPhases[i], figure(s.seconds[i + 1], 3)});
  out += "</table></div>\n<div class=\"wide\"><table>\n";
  append_row(out, {"tape", "bytes written", "bytes read", "blocks"}, "th");
  for (int32_t t = 0; t < C2D_TAPES; ++t)
    append_row(out, {tape_word(t), whole(s.tape_bytes_written[t]), whole(s.tape_bytes_read[t]), whole(s.tape_blocks[t])});
  out += "</table></div>\n<div class=\"wide\"><table>\n";
  append_row(out, {"quantity", "value"}, "th");
  append_row(out, {"workspace, bytes", whole(s.workspace_bytes)});
  append_row(out, {"used of it at most, bytes", whole(s.peak_bytes)});
  append_row(out, {"smallest workspace, bytes", whole(s.minimum_bytes)});
  append_row(out, {"events; exchanges; tableau rebuilds",
                   std::to_string(s.events) + "; " + std::to_string(s.exchanges) + "; " + std::to_string(s.tableau_rebuilds)});
  append_row(out, {"largest residual", figure(s.max_residual, 2)});
  append_row(out, {"condition estimate", figure(s.condition, 3)});
  out += "</table></div>\n</section>\n";
}

void append_warnings(std::string& out, const Scene& scene) {
  out += "<section id=\"warnings\">\n<h2>Warnings</h2>\n";
  if (scene.record->warnings.empty()) out += "<p>None.</p>\n";
  if (!scene.record->warnings.empty()) {
    out += "<ul>\n";
    for (const c2d_error& w : scene.record->warnings) out += "<li>" + escape_xml(w.text) + "</li>\n";
    out += "</ul>\n";
  }
  out += "</section>\n";
}

} // namespace

void append_page(std::string& out, const Scene& scene, const Pictures& pictures, const std::string& deck_name) {
  const std::string title = escape_xml(scene.summary.title[0] != '\0' ? scene.summary.title : deck_name.c_str());
  out += "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width\">\n<title>" +
         title + "</title>\n<style>\n" + kStyle;
  append_dark_style(out);
  out += "</style>\n</head>\n<body>\n<h1>" + title + "</h1>\n<p>contact2d " + c2d_version() + ", deck " +
         escape_xml(deck_name) + "</p>\n";
  append_outcome(out, scene);
  append_key_numbers(out, scene);
  if (scene.solved) append_numbers(out, scene);
  if (scene.solved) append_steps(out, scene);
  append_warnings(out, scene);
  for (const Picture& picture : pictures) append_picture(out, picture);
  if (scene.solved) append_balance(out, scene);
  append_sizes(out, scene);
  out += "</body>\n</html>\n";
}

} // namespace app
