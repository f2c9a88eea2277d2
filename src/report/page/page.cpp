#include "report/page/page.hpp"

#include "post/zone_line.hpp"
#include "report/drawn/dark.hpp"
#include "report/listing/key_table.hpp"
#include "report/page/frames.hpp"
#include "report/page/page_cycles.hpp"
#include "report/page/page_fatigue.hpp"
#include "report/page/page_terms.hpp"
#include "report/page/page_tolerances.hpp"
#include "report/page/page_torsion.hpp"
#include "report/text.hpp"
#include "report/totals.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

const char kStyle[] =
    "body{font-family:Helvetica,Arial,'Liberation Sans',sans-serif;color:#222;max-width:1240px;margin:24px auto;"
    "padding:0 16px;line-height:1.4}\n"
    "h1{font-size:22px;margin:0 0 4px}h2{font-size:16px;margin:28px 0 6px;border-bottom:1px solid #ccc}\n"
    "section{min-width:0}figure{margin:0 0 8px}svg{display:block;width:100%;max-width:580px;height:auto}\n"
    "figcaption{font-size:13px;color:#333;max-width:580px}a{color:#0060a8}nav{display:none}\n"
    // Pictures flow in as many columns as there is room for.
    ".pictures{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,440px),1fr));column-gap:32px}\n"
    // A box that can be scrolled sideways has a shadow at the edges beyond which there is more.
    ":root{--paper:#fff;--shadow:#0005}.wide{overflow-x:auto;background:"
    "linear-gradient(90deg,var(--paper) 50%,transparent) 0/32px local,"
    "linear-gradient(270deg,var(--paper) 50%,transparent) 100%/32px local,"
    "linear-gradient(90deg,var(--shadow),transparent) 0/10px 98% scroll,"
    "linear-gradient(270deg,var(--shadow),transparent) 100%/10px 98% scroll;background-repeat:no-repeat}\n"
    "table{border-collapse:collapse;font-size:13px;margin:8px 0}td{white-space:nowrap}\n"
    "th,td{text-align:right;padding:2px 10px;border-bottom:1px solid #ddd}th{border-bottom:1px solid #555}\n"
    "th:first-child,td:first-child{text-align:left;padding-left:0}th.group{padding-top:12px;white-space:normal}\n"
    ".dense{font-size:12px}.dense th,.dense td{padding:2px 4px}.dense th:first-child,.dense "
    "td:first-child{padding-left:0}.dense th.group{padding-top:10px}\n"
    "dt{font-weight:bold;font-size:13px}dd{margin:0 0 6px;font-size:13px;max-width:70em}\n"
    ".outcome{padding:6px 12px;border-left:4px solid #007a5a;background:#f3f8f6}\n"
    ".stopped{border-left-color:#d55e00;background:#fdf3ec}\n"
    "@media print{body{max-width:none;margin:0;font-size:11pt}section{break-inside:avoid}h2{break-after:avoid}\n"
    "svg{width:auto;max-width:100%;max-height:104mm}}@page{margin:18mm}\n"
    // Beside the page its contents, which stay in sight.
    "@media screen and (min-width:1000px){body{display:grid;grid-template-columns:190px minmax(0,1fr);column-gap:32px}\n"
    "nav{display:block;position:sticky;top:16px;align-self:start;max-height:95vh;overflow:auto;font-size:13px}\n"
    "nav ul{list-style:none;margin:4px 0;padding:0}nav li{margin:5px 0}}\n"
    // The numbers beside the first picture need more room than it; long names take two lines.
    ".first td:first-child{white-space:normal}\n"
    "@media screen and (min-width:1240px){.first{grid-template-columns:410px minmax(0,1fr)}"
    ".first>section:first-child{position:sticky;top:16px;align-self:start}}\n"
    "@media screen and (max-width:640px){body{margin:12px auto;padding:0 12px}h1{font-size:19px}th,td{padding:2px 6px}}\n";

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
  if (record.checked_only) out += "Data check only: the input is in order, nothing was solved.";
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
    if (!c.cycles.empty() && c.outcome == C2D_REACHED) out += " The cycle is " + escape_xml(cycle_text(c, scene.summary)) + ".";
    out += "</div>\n";
  }
  out += "</div>\n";
}

void append_picture(std::string& out, const Picture& picture) {
  out += "<section id=\"" + picture.name + "\">\n<h2>" + picture.title + "</h2>\n<figure>\n" + picture.svg + "<figcaption>" +
         picture.caption + "</figcaption>\n</figure>\n</section>\n";
}

// "Zone 1: body 1 on body 2, mu = 0.3", without a coefficient for a tie.
std::string zone_title(const Scene& scene, size_t coefficient, size_t zone) {
  const bool tied = zone < scene.zones.size() && scene.zones[zone].tied;
  std::string out = (tied ? "Tie, " : "") + zone_label(scene, zone);
  if (!tied) out[0] = 'Z';
  if (zone < scene.zones.size()) out += ": " + bodies_of(scene, scene.zones[zone]);
  if (!tied) out += ", &#956; = " + figure(friction_of(scene, coefficient, zone));
  return out;
}

using Numbers = std::vector<Quantity>;

void append_number_row(std::string& out, const Scene& scene, const TableNumber& number, const Numbers& all, bool stated) {
  const Quantity& q = number.is;
  const RoundOff noise = round_off(all, size_of(scene));
  const std::string none = "&#8211;", item = q.is_of_body() ? ", " + body_label(scene, q.item)
                                             : q.item > 0   ? " " + std::to_string(q.item)
                                                            : number.of;
  std::vector<std::string> row{
      term_link(q.what) + item,
      figure(noise.shown(q.what, shown_value(q.what, q.value, q.along), q.error), unit_of(q.what, scene), 6)};
  if (stated) row.push_back(std::isfinite(q.error) ? "&#177; " + figure(noise.shown(q.what, q.error), 2) : none);
  for (const double at : {q.at[0], q.at[1], q.along})
    row.push_back(std::isfinite(at) && std::isfinite(q.at[0]) ? figure(told_place(at, size_of(scene)), 6) : none);
  append_row(out, row);
}

// Key numbers of the contact and their stated errors, by coefficient and zone.
void append_numbers(std::string& out, const Scene& scene) {
  bool stated = false, any = false;
  for (const CoefficientRecord& c : scene.record->coefficients)
    for (size_t k = 0; !c.steps.empty() && k < c.steps.back().quantities.size(); ++k)
      any = true, stated = stated || std::isfinite(c.steps.back().quantities[k].error);
  if (!any) return;
  out +=
      "<section id=\"numbers\">\n<h2>Contact in numbers, at the last step</h2>\n<div class=\"wide\"><table class=\"dense\">\n";
  std::vector<std::string> heading{"quantity", "value"};
  if (stated) heading.emplace_back("stated error");
  for (const char* name : {"x", "y"}) heading.push_back(with_unit(name, scene.length_unit));
  heading.push_back("<a href=\"#term-along\">along</a>" + (scene.length_unit.empty() ? "" : ", " + scene.length_unit));
  append_row(out, heading, "th");
  for (size_t i = 0; i < scene.record->coefficients.size(); ++i) {
    const CoefficientRecord& c = scene.record->coefficients[i];
    if (c.steps.empty()) continue;
    const Numbers& all = c.steps.back().quantities;
    int32_t zone = -1;
    for (const TableNumber& number : with_wholes(all, scene.summary)) {
      if (number.is.zone != zone) {
        zone = number.is.zone;
        const std::string group =
            zone > 0 ? zone_title(scene, i, static_cast<size_t>(zone) - 1) : "All zones, &#956; = " + figure(c.mu);
        out += "<tr><th class=\"group\" colspan=\"" + std::to_string(heading.size()) + "\">" + group + "</th></tr>\n";
      }
      append_number_row(out, scene, number, all, stated);
    }
  }
  out += "</table></div>\n";
  if (const std::string whose = whose_forces(scene.summary); !whose.empty())
    out += "<p>Forces, moments and dissipated work are those " + whose + ".</p>\n";
  out += "</section>\n";
}

// The quantities above, explained.
void append_terms(std::string& out, const Scene& scene) {
  std::vector<Measure> terms;
  for (const CoefficientRecord& c : scene.record->coefficients)
    for (size_t k = 0; !c.steps.empty() && k < c.steps.back().quantities.size(); ++k)
      terms.push_back(c.steps.back().quantities[k].what);
  for (const Stated& s : scene.record->meshes.stated)
    if (is_fatigue(s)) terms.push_back(s.what);
  if (terms.empty()) return;
  std::sort(terms.begin(), terms.end());
  terms.erase(std::unique(terms.begin(), terms.end()), terms.end());
  out += "<section id=\"terms\">\n<h2>What the numbers mean</h2>\n<dl>\n";
  for (const Measure what : terms)
    out += "<dt id=\"term-" + term_of(what) + "\">" + name_of(what) + "</dt><dd>" + meaning_of(what) + "</dd>\n";
  out +=
      "<dt id=\"term-along\">along</dt><dd>The distance of a place along the second side of its contact statement, from the "
      "start "
      "of its first curve (of a deck along side 2); the same on every mesh.</dd>\n"
      "<dt>stated error</dt><dd>An estimate from meshes of different fineness, not a bound.</dd>\n"
      "<dt>side 1, side 2</dt><dd>A zone names its bodies in this order; stresses act on side 2. n points from side 1 to side "
      "2, and t is n turned by -90 degrees.</dd>\n</dl>\n</section>\n";
}

std::string units_of_steps(const Scene& scene) {
  std::string out = "<p>";
  if (scene.cases > 1) out += "load2: the factor of load case 2. ";
  out += "Edges, borders and the place of the peak are distances along the second side.";
  if (!scene.length_unit.empty())
    out += " Lengths in " + scene.length_unit + ", pressures in " + scene.stress_unit + ", forces in " + scene.force_unit +
           ", moments and work in " + scene.work_unit + ".";
  return out + "</p>\n";
}

// Step by step, folded away.
void append_steps(std::string& out, const Scene& scene) {
  size_t shown = 0;
  for (size_t i = 0; i < scene.record->coefficients.size(); ++i)
    for (size_t z = 0; z < scene.zones.size(); ++z) {
      const KeyTable table = key_table(scene.record->coefficients[i], static_cast<int32_t>(z) + 1, 5);
      if (table.rows.empty() || ++shown > kMostCharts) continue;
      out += "<details>\n<summary>Step by step" + chart_title(scene, friction_of(scene, i, z), z) +
             "</summary>\n<div class=\"wide\"><table>\n";
      append_row(out, table.heading, "th");
      for (const std::vector<std::string>& row : table.rows) append_row(out, row);
      out += "</table></div>\n" + units_of_steps(scene) + "</details>\n";
    }
}

void append_balance(std::string& out, const Scene& scene) {
  const Summary& s = scene.summary;
  out += "<section id=\"equilibrium\">\n<h2>Equilibrium</h2>\n<div class=\"wide\"><table>\n";
  append_row(out,
             {scene.is_revolved() ? "whole circumference" : "per unit thickness", with_unit("fx", scene.force_unit),
              with_unit("fy", scene.force_unit), with_unit("moment about the origin", scene.work_unit)},
             "th");
  double most[3] = {0.0, 0.0, 0.0};
  for (int32_t b = 0; b < s.bodies; ++b)
    for (size_t k = 0; k < 3; ++k)
      for (const double value : {s.body[b].applied[k], s.body[b].contact[k]}) most[k] = std::max(most[k], std::fabs(value));
  const double force = std::max(most[0], most[1]);
  const double none[3] = {1e-10 * force, 1e-10 * force, 1e-10 * std::max(most[2], force * size_of(scene))};
  const auto number = [&](const double* values, size_t k) { // round-off is 0
    return figure(std::fabs(values[k]) <= none[k] ? 0.0 : values[k], 7);
  };
  for (int32_t b = 1; b <= s.bodies; ++b)
    for (const BodyTotal& row : totals_of(s, b)) {
      const auto shown = [&](size_t k) { return row.is_sum ? figure(row.force[k], 2) : number(row.force, k); };
      append_row(out, {body_label(scene, b) + ": " + row.of, shown(0), shown(1), shown(2)});
    }
  out += "</table></div>\n";
  if (mirror_lines(s) != 0) out += std::string("<p>In this table ") + escape_xml(words_of_totals(s)) + ".</p>\n";
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

void append_page_inputs(std::string& out, const Inputs& inputs) {
  if (inputs.files.empty()) return;
  out += "<section id=\"inputs\">\n<h2>Inputs</h2>\n<div class=\"wide\"><table>\n";
  for (const auto& [key, value] : rows_of(inputs)) append_row(out, {escape_xml(key), escape_xml(value)});
  out += "</table></div>\n</section>\n";
}

// Of several contacts the one with the highest pressure, else a tie; without either the picture after the model's.
size_t first_picture(const Scene& scene, const Pictures& pictures) {
  size_t out = pictures.size();
  double most = -HUGE_VAL;
  bool tied = true;
  for (size_t i = 0; i < pictures.size(); ++i) {
    if (pictures[i].name.compare(0, 7, "contact") != 0) continue;
    const size_t z = pictures[i].name.size() > 12 ? static_cast<size_t>(std::stoi(pictures[i].name.substr(12))) - 1 : 0;
    const ZoneFacts f = find_facts(scene, scene.zones[z], scene.record->coefficients.back().table);
    if (tied && !scene.zones[z].tied) tied = false, most = -HUGE_VAL;
    if (scene.zones[z].tied == tied && f.peak > most) most = f.peak, out = i;
  }
  for (size_t i = 0; i < pictures.size() && out == pictures.size(); ++i)
    if (pictures[i].name == "deformed" || (!scene.solved && pictures[i].name == "model")) out = i;
  return out;
}

// A link to every section, with the words of its heading.
void append_contents(std::string& out, const std::string& page) {
  out += "<nav><b>Contents</b>\n<ul>\n";
  const std::string section = "<section id=\"", heading = "<h2>";
  for (size_t at = page.find(section); at != std::string::npos; at = page.find(section, at + 1)) {
    const size_t name = at + section.size(), title = page.find(heading, at) + heading.size();
    out += "<li><a href=\"#" + page.substr(name, page.find('"', name) - name) + "\">" +
           page.substr(title, page.find("</h2>", title) - title) + "</a></li>\n";
  }
  out += "</ul>\n</nav>\n";
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
         title + "</title>\n<style>\n" + kStyle + kFrameStyle;
  append_dark_style(out);
  out += "</style>\n</head>\n<body>\n";
  // The contents stand beside the page, and so before it.
  std::string page;
  page += "<h1>" + title + "</h1>\n<p>contact2d " + c2d_version() + ", " + escape_xml(deck_name) + "</p>\n";
  append_outcome(page, scene);
  page += "<div class=\"pictures first\">\n";
  const size_t first = first_picture(scene, pictures);
  if (first < pictures.size()) append_picture(page, pictures[first]);
  append_numbers(page, scene);
  page += "</div>\n";
  if (scene.solved) append_steps(page, scene);
  if (scene.solved) append_page_cycles(page, scene);
  append_page_fatigue(page, scene);
  append_page_torsion(page, scene);
  append_page_tolerances(page, scene);
  append_warnings(page, scene);
  page += "<div class=\"pictures\">\n";
  for (size_t i = 0; i < pictures.size(); ++i)
    if (i != first) append_picture(page, pictures[i]);
  append_frames(page, scene);
  page += "</div>\n";
  if (scene.solved) append_balance(page, scene);
  append_sizes(page, scene);
  append_page_inputs(page, scene.record->inputs);
  append_terms(page, scene);
  append_contents(out, page);
  out += "<main>\n" + page + "</main>\n</body>\n</html>\n";
}

} // namespace app
